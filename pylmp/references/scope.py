"""What formulas may refer to in a simulation: variables, computes, fixes, thermo keywords, atoms, the run's clock.

And what variables need from outside: files, the environment.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING, Any

from pylmp.model.atoms import Floats
from pylmp.model.paths import readable
from pylmp.model.simulation import Simulation
from pylmp.references import atom_values, measured, named
from pylmp.references.atom_file import atom_sets
from pylmp.references.of_c import of_c
from pylmp.text.diagnostic import ScriptError
from pylmp.text.formula_error import MATH, FormulaError
from pylmp.text.timed import Clock
from pylmp.text.variables import Variables
from pylmp.text.words import Word
from pylmp.thermo.keywords import KEYWORDS

if TYPE_CHECKING:
    from pylmp.kernels.random import RanMars

# variables of the environment that tell nothing but the number of a job, threads and the clock's place
_PUBLIC = (
    "OMP_NUM_THREADS", "SLURM_JOB_ID", "SLURM_ARRAY_TASK_ID", "SLURM_NTASKS", "PBS_JOBID", "PBS_ARRAY_INDEX", "LSB_JOBID", "JOB_ID", "TZ",
)  # fmt: skip


class Scope:
    """Implements pylmp.text.evaluate.Scope and pylmp.text.variable_styles.World for a simulation."""

    def __init__(self, sim: Simulation, variables: Variables) -> None:
        self.sim = sim
        self.variables = variables
        self._streams: dict[bool, RanMars] = {}  # one of equal-style formulas, one of the others

    # ---- variables --------------------------------------------------------------------------------------------

    def variable(self, name: str, index: tuple[int, ...], mode: str, rows: Any) -> Any:
        """``v_name`` and ``v_name[2]`` in a formula of style mode."""
        known = self.variables.known.get(name)
        if known is None or known.style not in ("atom", "atomfile", "vector"):
            if index and known is not None:
                raise ScriptError(
                    f"Variable {name}: Mismatched variable in variable formula", hint=f"v_{name} has one value"
                )
            return self.variables.number(name, self)
        if len(index) > 1:
            raise FormulaError("Invalid syntax in variable formula")
        if known.style == "vector":
            if index:
                values = self.variables.vector(name, self)
                if index[0] > len(values):
                    raise ScriptError(f"Variable {name}: Invalid index into vector-style variable", hint=f"1 to {len(values)}")
                return float(values[index[0] - 1])
            if mode == "vector":
                return self.variables.vector(name, self)
        elif index:
            row = atom_values.row_of(self.sim, index[0])
            return 0.0 if row is None else float(self.variables.per_atom(name, self)[row])
        elif mode == "atom":
            return self.variables.per_atom(name, self, rows)
        style = "Vector" if known.style == "vector" else "Atom"
        raise ScriptError(
            f"Variable {name}: {style}-style variable in {mode}-style variable formula", hint=f"v_{name}[1] is one of its values"
        )

    def need_variable(self, name: str) -> None:
        """Raise LAMMPS's sentence if there is no such variable."""
        if name not in self.variables.known:
            self.variables.number(name, self)

    def variable_text(self, name: str) -> str:
        """The text of a variable between brackets."""
        text = self.variables.text(name, self)
        if text is None:
            known = name in self.variables.known
            wrong = f"variable evaluation for variable {name}" if known else f"variable name {name}"
            raise ScriptError(f"Illegal value in brackets: ERROR: Invalid {wrong} in variable formula\n(v_{name})")
        return text

    def formula(self, name: str) -> str | None:
        """The formula of an atom-style or vector-style variable."""
        known = self.variables.known.get(name)
        text = known.values[0] if known is not None and known.style in ("atom", "vector") else None
        return None if text is None or text.startswith("[") else text

    # ---- the simulation ---------------------------------------------------------------------------------------

    def need_box(self) -> None:
        """Raise LAMMPS's sentence if there is no box."""
        if not self.sim.has_box:
            raise FormulaError("Variable evaluation before simulation box is defined")

    def measured(self, kind: str, name: str, index: tuple[int, ...], mode: str) -> Any:
        return measured.value(self.sim, kind, name, index, mode)

    def keyword(self, name: str) -> float:
        if name not in KEYWORDS:
            raise FormulaError(f"Invalid thermo keyword '{name}' in variable formula")
        return float(self.sim.output.thermo.value(name))

    def atom(self, name: str, tag: int) -> float:
        return atom_values.one(self.sim, name, tag)

    def atoms(self, name: str) -> Floats:
        return atom_values.every(self.sim, name)

    def named(self, function: str, names: tuple[str, ...], mode: str) -> Any:
        return named.value(self, function, names, mode)

    def by_tag(self, table: Any) -> Floats:
        """(n,) the values of (IDs, values) for each owned atom; 0.0 where its ID is not among them."""
        return atom_values.by_tag(self.sim, *table)

    def count(self) -> int:
        """Owned atoms."""
        return self.sim.atoms.n

    def random(self, seed: float, mode: str) -> RanMars:
        """The stream of equal-style formulas, or that of vector-style and atom-style ones; the first seed begins it."""
        stream = self._streams.get(mode == "equal")
        if stream is None:
            from pylmp.kernels.random import RanMars

            if not 1.0 <= seed < 2.0**31:  # it has 32 bits
                raise FormulaError(MATH, plain=mode != "equal")
            try:
                stream = self._streams[mode == "equal"] = RanMars(int(seed))
            except ValueError as error:
                raise ScriptError(str(error)) from None
        return stream

    def clock(self) -> Clock:
        sim = self.sim
        return Clock(sim.step, sim.begin, sim.end if sim.output.running else sim.begin, sim.dt)

    @staticmethod
    def of_c(function: str, *values: Any) -> Any:
        """The C library's function, for numbers or arrays."""
        return of_c(function, *values)

    # ---- the outside ------------------------------------------------------------------------------------------

    def lines(self, path: Word, what: str) -> list[str]:
        """The lines of a file; what: how LAMMPS names it."""
        try:
            return readable(self.sim, path).read_text(errors="surrogateescape").split("\n")
        except (OSError, ValueError) as error:
            why = error.strerror if isinstance(error, OSError) else "Invalid argument"
            raise ScriptError(f"Cannot open {what} {path.text}: {why}", path.span) from None

    def atom_sets(self, name: str, path: Word, lines: list[str]) -> Iterator[Any]:
        """The sets of per-atom values in a file."""
        return atom_sets(self.sim, name, path, lines)

    def environment(self, key: Word) -> Callable[[], str]:
        """What reads an environment variable, if the script may."""
        if key.text not in _PUBLIC and "env" not in self.sim.script.allow:
            raise ScriptError(
                f"Cannot read environment variable {key.text}", key.span, code="S102", hint=f"--allow env lets scripts read all of the environment, not only {' '.join(_PUBLIC)}"
            )  # fmt: skip
        return lambda: os.environ.get(key.text, "")

    def say(self, text: str) -> None:
        self.sim.console.both(text)
