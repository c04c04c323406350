"""fix ID GROUP ave/time Nevery Nrepeat Nfreq VALUES... KEYWORDS...: averages of global values over time, for a file and for others.

VALUES are c_ID f_ID v_NAME, with [I]; mode vector: each is a vector or a column of an array. KEYWORDS:
    mode scalar|vector    ave one|running|window M    start STEP    off COLUMN
    file|append NAME (.yaml: as YAML)    overwrite    format TEXT    title1|title2|title3 TEXT

scalar, vector, array: the last averages. Source: LAMMPS manual, fix_ave_time.html.
"""

from __future__ import annotations

import numpy as np

from pylmp.io.growing_file import GrowingFile
from pylmp.model.atoms import Floats
from pylmp.model.fix import Fix
from pylmp.model.inputs import read_inputs
from pylmp.model.registry import FIXES
from pylmp.model.sampling import Average, Schedule
from pylmp.model.simulation import Simulation
from pylmp.text.diagnostic import ScriptError
from pylmp.text.number import shortest
from pylmp.text.printf import Format
from pylmp.text.words import Args, Word

_KEYWORDS = ("mode", "file", "append", "ave", "start", "off", "overwrite", "format", "title1", "title2", "title3")


@FIXES.register("ave/time")
class AveTime(Fix):
    style = "ave/time"
    time_dependent = True
    varying = False

    def __init__(self, sim: Simulation, identity: str, group: str, bit: int, args: Args) -> None:
        super().__init__(sim, identity, group, bit, args)
        args.need(4)
        self.schedule = Schedule.read(args)
        self.every, self.compatible_every = self.schedule.every, self.schedule.period
        self.vectors = _mode(args)
        self.inputs = read_inputs(sim, args, vector=self.vectors, every=self.schedule.every)
        self.average = Average(off=np.zeros(len(self.inputs), bool))
        self.titles: dict[str, str] = {}
        self.format = Format(" %g")
        self.overwrite = False
        self.file: GrowingFile | None = None
        while len(args):
            self._keyword(sim, args, args.word())
        if self.overwrite and self.average.mode != "running":
            args.fail("Fix ave/time overwrite keyword requires ave running setting", args.owner, hint="ave running")
        if self.vectors:
            sizes = {value.rows for value in self.inputs if not value.varying}
            if len(sizes) > 1:
                args.fail("Fix ave/time columns have inconsistent lengths", args.owner, hint="one fix for each length")
            if len({value.extensive for value in self.inputs}) > 1:
                args.fail(
                    "Fix ave/time cannot set output array intensive/extensive from these inputs", args.owner,
                    hint="one fix for the extensive ones, one for the others",
                )  # fmt: skip
        self._sum = np.zeros(0)
        self._describe()
        self._head()
        self.schedule.begin(sim)

    def _keyword(self, sim: Simulation, args: Args, key: Word) -> None:
        name = key.text
        if name not in _KEYWORDS:
            args.fail(f"Unknown fix ave/time keyword {name}", key, hint=" ".join(_KEYWORDS))
        if name == "overwrite":
            self.overwrite = True
            return
        if name == "ave":
            self.average.read(args)
            return
        args.need(1, name)
        word = args.word()
        if name in ("file", "append"):
            if self.file is not None:
                self.file.close()
            self.file = GrowingFile(
                sim, args, word, append=name == "append", message="Cannot open fix ave/time file {}: {}"
            )
        elif name == "start":
            self.schedule.start = args.as_integer(word)
        elif name == "off":
            column = args.as_integer(word)
            if not 0 < column <= len(self.inputs):
                args.fail(f"Invalid fix ave/time off column: {column}", word, hint=f"1 to {len(self.inputs)}")
            self.average.off[column - 1] = True
        elif name == "format":
            try:
                self.format = Format(word.text)
            except ValueError:
                args.fail(f"Illegal fix ave/time format: {word.text}", word, hint="one conversion, as in ' %12.5f'")
        elif name.startswith("title"):
            self.titles[name] = word.text

    def _describe(self) -> None:
        """What it offers to others depends on how many values it has."""
        extensive = tuple(value.extensive for value in self.inputs)
        single = len(self.inputs) == 1
        offered = ("vector" if single else "array") if self.vectors else ("scalar" if single else "vector")
        for kind in ("scalar", "vector", "array"):
            if kind != offered:
                setattr(self, kind, None)
        self.length = len(self.inputs)
        if self.vectors:
            self.varying = all(value.varying for value in self.inputs)
            self.length = max(value.rows for value in self.inputs if self.varying or not value.varying)
            self.columns = len(self.inputs)
        self.extensive_scalar = extensive[0]
        self.extensive_vector = extensive[0] if self.vectors else extensive

    # ---- the file -------------------------------------------------------------------------------------------

    @property
    def _yaml(self) -> bool:
        return self.file is not None and self.file.name.endswith((".yaml", ".yml"))

    def _head(self) -> None:
        if self.file is None:
            return
        names = " ".join(value.text for value in self.inputs)
        first = self.titles.get("title1", f"# Time-averaged data for fix {self.id}")
        second = "# TimeStep Number-of-rows" if self.vectors else f"# TimeStep {names}"
        lines = [first, self.titles.get("title2", second)]
        if self.vectors:
            lines.append(self.titles.get("title3", f"# Row {names}"))
        if self._yaml:
            columns = [value.text for value in self.inputs]
            quoted = "".join(f"'{name}', " for name in (columns if self.vectors else ["Step", *columns]))
            lines += ["---", f"keywords: [{quoted}]", "data:"]
        self.file.write("\n".join(lines) + "\n")
        self.file.mark()

    def _block(self, step: int, values: Floats) -> str:
        """What one average adds to the file: values is (columns,), or (rows, columns) in mode vector."""
        if self._yaml:
            if not self.vectors:
                return f"  - [{step}, {''.join(f'{shortest(v)}, ' for v in values)}]\n"
            rows = [f"  - [{''.join(f'{shortest(v)}, ' for v in row)}]\n" for row in values]
            return f"  {step}:\n" + "".join(rows)
        if not self.vectors:
            return f"{step}{''.join(self.format(v) for v in values.tolist())}\n"
        rows = [f"{k}{''.join(self.format(v) for v in row)}\n" for k, row in enumerate(values.tolist(), 1)]
        return f"{step} {len(values)}\n" + "".join(rows)

    # ---- a run ----------------------------------------------------------------------------------------------

    def init(self, sim: Simulation) -> None:
        for value in self.inputs:
            value.find(sim, "fix ave/time")
        self.schedule.resume(sim)

    def setup(self, sim: Simulation) -> None:
        if sim.step == self.schedule.due:
            self.end_of_step(sim)

    def end_of_step(self, sim: Simulation) -> None:
        if sim.step != self.schedule.due:
            return
        with self.reading(sim, self.schedule.following()):
            sample = self._sample(sim)
        if self.schedule.taken == 0:
            self._sum = np.zeros(sample.shape)
        off = self.average.off
        self._sum = self._sum + sample
        self._sum[..., off] = sample[..., off]
        if not self.schedule.advance():
            return
        mean = self._sum / float(self.schedule.repeat)
        mean[..., off] = self._sum[..., off]
        self.average.add(mean)
        if self.file is not None:
            block = self._block(sim.step, self.average.value)
            (self.file.replace if self.overwrite else self.file.write)(block)

    def _sample(self, sim: Simulation) -> Floats:
        """(columns,), or (rows, columns) in mode vector."""
        values = [value.measure(sim) for value in self.inputs]
        if self.vectors and len({len(value) for value in values}) > 1:
            raise ScriptError("Fix ave/time columns have inconsistent lengths", hint="one fix for each length")
        return np.stack(values, axis=-1) if self.vectors else np.array(values)

    def removed(self, sim: Simulation) -> None:
        if self.file is not None:
            if self._yaml:
                self.file.write("...\n")
            self.file.close()

    # ---- what others read -----------------------------------------------------------------------------------

    def scalar(self, sim: Simulation) -> float:
        return float(self.average.value[0]) if self.average.count else 0.0

    def vector(self, sim: Simulation) -> Floats:
        return self._rows()[:, 0] if self.vectors else self._rows()

    def array(self, sim: Simulation) -> Floats:
        return self._rows()

    def _rows(self) -> Floats:
        """Where the number of rows varies, LAMMPS shows others the first one only."""
        if not self.average.count:
            return np.zeros((self.length, self.columns) if self.vectors else self.length)
        return self.average.value[:1] if self.varying else self.average.value


def _mode(args: Args) -> bool:
    """mode vector stands after the values, which it says how to read."""
    words = [word.text for word in args.words[args.at :]]
    mode = ""
    for key, value in zip(words, [*words[1:], ""], strict=True):
        if key == "mode":
            mode = value
            if mode not in ("scalar", "vector"):
                at = args.words[args.at + words.index("mode")]
                if not mode:
                    args.fail("Illegal fix ave/time mode command: missing argument(s)", at)
                args.fail(f"Unknown fix ave/time mode {mode}", at, hint="scalar or vector")
    return mode == "vector"
