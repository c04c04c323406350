"""The thermo table of a run: its columns, what they are worth at a step, and the text of every line."""

from __future__ import annotations

import time
from collections.abc import Sequence
from dataclasses import replace
from functools import cache, partial

from pylmp.io.run_log import memory_line
from pylmp.model.asking import ENERGY
from pylmp.model.atoms import Floats
from pylmp.model.compute import current
from pylmp.model.reference import Reference, expand, offers
from pylmp.model.simulation import Simulation
from pylmp.model.variables import Variables
from pylmp.text.diagnostic import ScriptError
from pylmp.text.printf import Format
from pylmp.text.words import Args, Word
from pylmp.thermo.columns import Column, column
from pylmp.thermo.keywords import KEYWORDS
from pylmp.thermo.layout import LAYOUTS

_NOT_TALLIED = "Energy was not tallied on needed timestep"


class Thermo:
    """columns: what a line holds. layout: one, multi or yaml.

    norm            extensive values are divided by the number of atoms (None: what the unit system says)
    lost            what to do when atoms are gone: error, warn or ignore
    formats headers by column number from 0: the user's; for_whole, for_real, for_line: the user's for all columns
    written         step and values of the last line
    temp press pe   IDs of the computes it reads
    custom          the columns are the user's; else the volume joins them in runs in which the box changes
    """

    sim: Simulation

    def __init__(self, sim: Simulation, layout: str, words: Sequence[Word], args: Args) -> None:
        self.sim = sim
        self.layout = LAYOUTS[layout]
        self.norm: bool | None = None
        self.flush = False
        self.lost = "error"
        self.formats: dict[int, Format] = {}
        self.headers: dict[int, str] = {}
        self.for_whole: Format | None = None
        self.for_real: Format | None = None
        self.for_line: list[Format] = []
        self.temp, self.press, self.pe = "thermo_temp", "thermo_press", "thermo_pe"
        self.silent = False  # said that there are too many warnings
        self.written: tuple[int, list[float]] = (-1, [])
        self.modified = self.custom = self._warned = False
        self.variables = Variables(sim)
        self._paces: dict[str, tuple[float, float]] = {}
        self._uses = ""  # what the columns of the last run needed
        self.columns: list[Column] = []
        self.chosen = [column(self, args, word) for word in expand(sim, args, words, "vector")]
        self.columns = self.chosen

    # ---- what values are made of ----------------------------------------------------------------------------

    def measure(self, found: Reference, values: str, at: tuple[int, ...]) -> float:
        """A scalar, a component of a vector or an element of an array, of a compute or fix, per atom where it is extensive and norm
        is on. at: where, from 0; 0.0 beyond the end of what varies in length.
        """
        result = current(self.sim, found.source(self.sim), values)
        for k in at:
            if k >= len(result) and found.kind == "c":
                raise ScriptError(f"Thermo compute {values} is accessed out-of-range", hint=f"it has {len(result)} rows now")
            if k >= len(result):
                return 0.0
            result = result[k]
        number = float(result)
        extensive = getattr(found.source(self.sim), f"extensive_{values}", False)
        if isinstance(extensive, tuple):  # each component has its own answer
            extensive = extensive[at[0]]
        return self.per_atom(number) if extensive else number

    def temperature(self) -> float:
        return float(current(self.sim, self.sim.computes[self.temp], "scalar"))

    def pressure(self) -> float:
        return float(current(self.sim, self.sim.computes[self.press], "scalar"))

    def pressure_tensor(self) -> Floats:
        """(6,) xx yy zz xy xz yz."""
        tensor: Floats = current(self.sim, self.sim.computes[self.press], "vector")
        return tensor

    def potential(self) -> float:
        """Potential energy of the whole system."""
        return float(current(self.sim, self.sim.computes[self.pe], "scalar"))

    def _invoke(self, entry: Column) -> None:
        """Evaluate the computes a column rests on."""
        measures = {"t": self.temperature, "p": self.pressure, "s": self.pressure_tensor, "e": self.potential}
        for letter in entry.needs:
            if letter in measures:
                measures[letter]()
        if entry.reference is not None and entry.reference.kind == "c":
            entry.value(self)

    def dof(self) -> float:
        """Degrees of freedom of the temperature."""
        return float(self.sim.computes[self.temp].dof(self.sim))  # type: ignore[attr-defined]

    def per_atom(self, value: float) -> float:
        """value over the number of atoms where norm is on."""
        atoms = self.sim.atoms.n
        return value / atoms if self.normed and atoms else value

    @property
    def normed(self) -> bool:
        return self.sim.units.norm if self.norm is None else self.norm

    def redirect(self, before: str, after: str, kinds: Sequence[str]) -> None:
        """As in LAMMPS a column of thermo_temp or thermo_press shows the compute that takes its place in thermo keywords, if a keyword
        reads the same values of it.
        """
        for k, entry in enumerate(self.chosen):
            found = entry.reference
            own = entry.name.split("[")[0] in ("c_thermo_temp", "c_thermo_press")
            if own and found is not None and (found.kind, found.name) == ("c", before):
                values, at = ("scalar", "vector", "array")[len(found.index)], tuple(n - 1 for n in found.index)
                if values in kinds:
                    other = replace(found, name=after)
                    self.chosen[k] = replace(entry, reference=other, value=partial(_measured, other, values, at))

    def uses(self, needs: str) -> bool:
        """Some column needs one of these (letters as in Keyword.needs)."""
        return any(letter in entry.needs for entry in self.chosen for letter in needs)

    def cpu(self) -> float:
        """Wall seconds since the loop of the run began; 0 on the line before its first step."""
        output = self.sim.output
        return 0.0 if self.sim.step == output.first else time.perf_counter() - float(output.started[0])

    def pace(self, name: str, value: float) -> float:
        """Growth of value per second since the last line; 0 on the first line."""
        now = self.cpu()
        before, then = self._paces.get(name, (value, now))
        self._paces[name] = (value, now)
        return (value - before) / (now - then) if now > then else 0.0

    def remaining(self) -> float:
        """Estimated seconds until the run ends."""
        output = self.sim.output
        done = self.sim.step - output.first
        return self.cpu() * (output.last - self.sim.step) / done if done else 0.0

    # ---- one value, for variables ---------------------------------------------------------------------------

    def value(self, keyword: str) -> float:
        """What keyword is worth now; a formula may ask for any keyword.

        Raises ScriptError with LAMMPS's sentence when it is not current.
        """
        known = KEYWORDS[keyword]
        if "r" in known.needs and not self.sim.output.running:
            raise ScriptError(f"The variable thermo keyword {keyword} cannot be used between runs")
        if "e" in known.needs and not self.sim.tally.has(ENERGY, self.sim.step):
            raise ScriptError(_NOT_TALLIED, hint="use it on thermo steps")
        for letter, noun in (("e", "potential energy"), ("t", "temperature"), ("p", "press")):
            if letter in known.needs.replace("s", "p") and letter not in self._uses:
                raise ScriptError(
                    f"Thermo keyword {keyword} in variable requires thermo to use/init {noun}",
                    hint="thermo_style custom with that keyword",
                )
        if known.needs == "t" and not self.sim.ran and not self.sim.output.running:
            return 0.0
        return known.value(self)

    # ---- lines ----------------------------------------------------------------------------------------------

    def init(self) -> None:
        """Everything the columns name is still there."""
        self._paces = {}
        self.columns = self.chosen
        if not self.custom and self.sim.box.changing:
            self.columns = [*self.chosen, column(self, Args("thermo_style", []), Word("vol"))]
        self._uses = "".join(entry.needs for entry in self.columns).replace("s", "p")
        references = [entry.reference for entry in self.columns if entry.reference is not None]
        for found in sorted(references, key=lambda found: "cfv".index(found.kind)):
            if found.kind == "v" and self.variables.style(found.name) is None:
                raise ScriptError(f"Could not find thermo variable {found.name}")
            source = found.source(self.sim)
            if found.kind != "v" and source is None:
                raise ScriptError(f"Could not find thermo {found.what} with ID {found.name}")
            every = 0 if self.sim.output.variable else self.sim.output.every
            if found.kind == "f" and every % source.compatible_every:
                raise ScriptError(
                    f"Thermo and fix {found.name} not computed at compatible times", manual="Errors_details.html#err0007",
                    hint=f"thermo {source.compatible_every}, or a multiple",
                )  # fmt: skip
        if self.for_line and len(self.for_line) < len(self.columns):
            raise ScriptError(
                f"Thermo_modify format line is too short: {' '.join(f.text for f in self.for_line)}",
                hint=f"{len(self.columns)} columns",
            )

    def begin(self, memory: bool) -> None:
        """Header and first line of a run. memory: the run has a set-up, after which LAMMPS says how much memory it uses."""
        if memory:
            self.sim.console.both(memory_line(self.sim))
        whole = [entry.whole for entry in self.columns]
        self.sim.console.both(self.layout.header(self.names, whole))
        self.line()

    def line(self) -> None:
        """Write the line of the current step. As in LAMMPS computes are evaluated first, then variables, then the rest."""
        self._check_lost()
        self.silent = self.sim.console.overflow(self.silent)
        for entry in self.columns:
            self._invoke(entry)
        variables = {
            k: entry.value(self)
            for k, entry in enumerate(self.columns)
            if entry.reference is not None and entry.reference.kind == "v"
        }
        values = [variables[k] if k in variables else entry.value(self) for k, entry in enumerate(self.columns)]
        self.written = self.sim.step, values
        cells = [self._format(k)(value) for k, value in enumerate(values)]
        self.sim.console.both(self.layout.row(self.names, cells, self.sim.step, self.cpu()))
        if self.flush:
            self.sim.console.flush()

    def end(self) -> None:
        """What follows the last line of a run."""
        if self.layout.footer:
            self.sim.console.both(self.layout.footer)

    @property
    def names(self) -> list[str]:
        return [self.headers.get(k, entry.header) for k, entry in enumerate(self.columns)]

    def _format(self, k: int) -> Format:
        """The user's format of this column, else of its kind, else of the whole line, else the layout's."""
        whole = self.columns[k].whole
        own = self.formats.get(k) or (self.for_whole if whole else self.for_real)
        if own is None and self.for_line:
            own = self.for_line[k]
        return own or _format(self.layout.whole if whole else self.layout.real)

    def _check_lost(self) -> None:
        sim = self.sim
        if sim.atoms.n == sim.natoms:
            return
        text = f"Lost atoms: original {sim.natoms} current {sim.atoms.n}"
        if self.lost == "error":
            raise ScriptError(
                text, hint="a smaller timestep, softer coefficients or other boundaries; thermo_modify lost ignore goes on",
                manual="Errors_details.html#err0008",
            )  # fmt: skip
        if self.lost == "warn" and not self._warned:
            self._warned = True
            sim.console.warning(text)
        sim.natoms = sim.atoms.n


_format = cache(Format)


def _measured(found: Reference, values: str, at: tuple[int, ...], thermo: Thermo) -> float:
    return thermo.measure(found, values, at)


def settable(sim: Simulation, identity: str, values: str = "scalar") -> bool:
    """There is a compute identity with such values."""
    return identity in sim.computes and offers(sim.computes[identity], values)
