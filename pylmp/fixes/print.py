"""fix ID GROUP print N TEXT [file|append NAME] [screen yes|no] [title TEXT]: a line of text every N steps, variables replaced.

N is a number, or an equal-style variable that says the next step. The text also appears when a run begins at a step that is
due. Source: LAMMPS manual, fix_print.html.
"""

from __future__ import annotations

from pylmp.io.growing_file import GrowingFile
from pylmp.model.fix import Fix
from pylmp.model.quantity import Quantity
from pylmp.model.registry import FIXES
from pylmp.model.simulation import Simulation
from pylmp.text.diagnostic import ScriptError
from pylmp.text.words import Args


@FIXES.register("print")
class Print(Fix):
    style = "print"

    def __init__(self, sim: Simulation, identity: str, group: str, bit: int, args: Args) -> None:
        super().__init__(sim, identity, group, bit, args)
        args.need(2)
        first = args.peek()
        self.when = Quantity()
        if first is not None and first.text.startswith("v_"):
            self.when = Quantity.read(args)
        else:
            self.every = args.integer()
            if self.every <= 0:
                args.fail(f"Illegal fix print nevery value {self.every}; must be > 0", hint="every so many steps")
        self.text = args.word()
        self.shown = True
        self.file: GrowingFile | None = None
        title = f"# Fix print output for fix {identity}"
        while len(args):
            key = args.word()
            if key.text not in ("file", "append", "screen", "title"):
                args.fail(f"Unknown fix print keyword: {key.text}", key, hint="file append screen title")
            args.need(1, key.text)
            if key.text == "screen":
                self.shown = args.yes()
                continue
            word = args.word()
            if key.text == "title":
                title = word.text
                continue
            if self.file is not None:
                self.file.close()
            self.file = GrowingFile(
                sim, args, word, append=key.text == "append", message="Cannot open fix print file {}: {}"
            )
        if self.file is not None:
            self.file.write(title + "\n")
        self.due = -1

    def init(self, sim: Simulation) -> None:
        self.when.check(sim, "fix print timestep")
        if self.when.varies:
            self.due = self._following(sim)
        else:
            self.due = -(-sim.step // self.every) * self.every
        sim.asking.everyone(self.due)

    def _following(self, sim: Simulation) -> int:
        """The step that is due after the current one."""
        if not self.when.varies:
            return sim.step + self.every
        step = int(self.when.number(sim))
        if step <= sim.step:
            raise ScriptError(
                f"Fix print timestep variable {self.when.name} returned a bad timestep: {step}",
                hint=f"a step after {sim.step}",
            )
        return step

    def end_of_step(self, sim: Simulation) -> None:
        if sim.step != self.due:
            return
        sim.asking.block()
        text = sim.script.substitute_text(self.text) + "\n"
        self.due = self._following(sim)
        sim.asking.again(self.due)
        if self.shown:
            sim.console.both(text)
        if self.file is not None:
            self.file.write(text)

    setup = end_of_step

    def removed(self, sim: Simulation) -> None:
        if self.file is not None:
            self.file.close()
