"""fix ID GROUP halt N ATTRIBUTE OPERATOR VALUE [error hard|soft|continue] [message yes|no] [path NAME] [universe yes|no]:
end a run when a condition holds.

ATTRIBUTE is bondmax (longest bond), tlimit (seconds of wall time since the run began; LAMMPS guesses from half of it at which step it
will be over, here one looks at the clock), diskfree (megabytes free at path) or
an equal-style variable; OPERATOR < <= > >= == != or |^. Looked at every N steps. hard: an error; soft: the run ends, and no later
one takes place; continue: only this run ends. Source: LAMMPS manual, fix_halt.html.
"""

from __future__ import annotations

import shutil
import time

import numpy as np

from pylmp.model.fix import Fix
from pylmp.model.quantity import Quantity
from pylmp.model.registry import FIXES
from pylmp.model.simulation import Simulation
from pylmp.text.diagnostic import ScriptError
from pylmp.text.number import shortest
from pylmp.text.words import Args, Word

_MEGABYTE = 1048576.0
_ATTRIBUTES = ("bondmax", "tlimit", "diskfree")
_OPERATORS = {
    "<": lambda a, b: a < b, ">": lambda a, b: a > b, "<=": lambda a, b: a <= b, ">=": lambda a, b: a >= b,
    "==": lambda a, b: a == b, "!=": lambda a, b: a != b, "|^": lambda a, b: (a == 0.0) != (b == 0.0),
}  # fmt: skip


@FIXES.register("halt")
class Halt(Fix):
    style = "halt"
    minimizes = True

    def __init__(self, sim: Simulation, identity: str, group: str, bit: int, args: Args) -> None:
        super().__init__(sim, identity, group, bit, args)
        args.need(4)
        self.every = args.integer()
        if self.every <= 0:
            args.fail("Illegal fix halt command: nevery must be > 0", hint="every so many steps")
        self.attribute = args.word()
        self.variable = Quantity()
        if self.attribute.text.startswith("v_"):
            self.variable = Quantity(name=self.attribute.text[2:])
            try:
                self._check_variable(sim)
            except ScriptError as error:
                raise error.at(self.attribute.span) from None
        elif self.attribute.text not in _ATTRIBUTES:
            args.fail(
                f"Unknown fix halt keyword {self.attribute.text}", self.attribute, hint=f"v_NAME {' '.join(_ATTRIBUTES)}"
            )
        operator = args.word()
        if operator.text not in _OPERATORS:
            args.fail(f"Invalid fix halt operator {operator.text}", operator, hint=" ".join(_OPERATORS))
        self.holds = _OPERATORS[operator.text]
        self.limit = args.number()
        self.how, self.message, self.path = "soft", True, "."
        while len(args):
            self._keyword(args, args.word())
        self._hit = False
        self._looked = -1

    def _keyword(self, args: Args, key: Word) -> None:
        if key.text not in ("error", "message", "path", "universe"):
            args.fail(f"Unknown fix halt keyword {key.text}", key, hint="error message path universe")
        args.need(1, key.text)
        if key.text == "message":
            self.message = args.yes()
        elif key.text == "universe":
            args.yes()  # whether other partitions end too: there are none
        elif key.text == "path":
            self.path = args.word().text
        else:
            how = args.word()
            if how.text not in ("hard", "soft", "continue"):  # the sentence names the keyword
                args.fail("Unknown fix halt error condition error", how, hint="hard, soft or continue")
            self.how = how.text

    def _check_variable(self, sim: Simulation) -> None:
        self.variable.check(
            sim, "", missing="Could not find fix halt variable name {}", invalid="Fix halt variable is not equal-style variable"
        )

    def init(self, sim: Simulation) -> None:
        self._check_variable(sim)
        self._looked = -1
        if self.attribute.text == "diskfree":
            self._free()
        sim.asking.everyone(self._next(sim))

    def _next(self, sim: Simulation) -> int:
        return (sim.step // self.every + 1) * self.every

    def end_of_step(self, sim: Simulation) -> None:
        value = self._value(sim)
        if not self.holds(value, self.limit):
            return
        text = f"Fix halt condition for fix-id {self.id} met on step {sim.step} with value {shortest(value)}"
        if self.how == "hard":
            raise ScriptError(text, self.attribute.span, hint="error soft or continue goes on")
        if self.message:
            sim.console.both(f"{text}\n")
        sim.halted = True
        self._hit = True

    def min_setup(self, sim: Simulation) -> None:
        """Nothing: there was no step yet."""

    def min_post_force(self, sim: Simulation) -> None:
        """Once a step, however often forces are evaluated in it."""
        if sim.step % self.every == 0 and sim.step != self._looked:
            self.end_of_step(sim)
        self._looked = sim.step

    def post_run(self, sim: Simulation) -> None:
        """In LAMMPS a fix that says continue and has halted a run once lets all later ones go on, whoever halts them."""
        if self.how == "continue" and self._hit:
            sim.halted = False

    # ---- attributes -----------------------------------------------------------------------------------------

    def _value(self, sim: Simulation) -> float:
        name = self.attribute.text
        if name == "bondmax":
            return _longest_bond(sim)
        if name == "tlimit":
            timed = sim.timer.style != "off"  # LAMMPS then has no clock
            return time.perf_counter() - float(sim.output.started[0]) if timed else 0.0
        if name == "diskfree":
            return self._free()
        with self.reading(sim, self._next(sim)):
            return self.variable.number(sim)

    def _free(self) -> float:
        """Megabytes free where path is. Raises ScriptError."""
        try:
            return shutil.disk_usage(self.path).free / _MEGABYTE
        except OSError:
            raise ScriptError("Disk limit not supported by OS or illegal path", hint=f"path {self.path}") from None


def _longest_bond(sim: Simulation) -> float:
    x = sim.atoms.x
    longest = 0.0
    for listed in sim.bond_lists:
        bonds = listed.bonds[: listed.count]
        bonds = bonds[bonds[:, 2] > 0]
        d = x[bonds[:, 0]] - x[bonds[:, 1]]
        if not sim.atoms.ghosts:  # nobody stands for periodic images
            d = sim.box.minimum_image(d)
        if len(d):
            longest = max(longest, float((d[:, 0] * d[:, 0] + d[:, 1] * d[:, 1] + d[:, 2] * d[:, 2]).max()))
    return float(np.sqrt(longest))
