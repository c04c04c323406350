"""What formulas may refer to in a simulation: variables, computes, fixes, thermo keywords, atoms, the run's clock."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from pylmp.model.compute import current
from pylmp.model.simulation import Simulation
from pylmp.text.diagnostic import ScriptError, Unsupported
from pylmp.text.formula import Clock
from pylmp.text.functions import FormulaError
from pylmp.text.variables import Variables

if TYPE_CHECKING:
    from pylmp.kernels.random import RanMars

_VECTORS = {"x": "x", "v": "v", "f": "f"}


class Scope:
    """Implements pylmp.text.formula.Scope for a simulation."""

    def __init__(self, sim: Simulation, variables: Variables) -> None:
        self._sim = sim
        self._variables = variables
        self._stream: RanMars | None = None

    def variable(self, name: str, index: Sequence[int]) -> float:
        _positive(index)
        if index and name in self._variables.known:
            raise ScriptError(
                f"Variable {name}: Mismatched variable in variable formula", hint=f"v_{name} has one value"
            )
        return self._variables.number(name, self)

    def compute(self, name: str, index: Sequence[int]) -> float:
        self._need_box()
        found = self._sim.computes.get(name)
        if found is None:
            known = " ".join(self._sim.computes)
            raise ScriptError(f"Invalid compute ID '{name}' in variable formula", hint=f"computes: {known}")
        if not found.ready:
            raise FormulaError("Variable formula compute cannot be invoked before initialization by a run")
        return self._entry(found, "compute", name, index)

    def fix(self, name: str, index: Sequence[int]) -> float:
        self._need_box()
        found = next((fix for fix in self._sim.fixes if fix.id == name), None)
        if found is None:
            raise ScriptError(f"Invalid fix ID '{name}' in variable formula", hint="define it first")
        if self._sim.step % found.compatible_every:
            raise FormulaError("Fix in variable not computed at a compatible time")
        return self._entry(found, "fix", name, index)

    def _need_box(self) -> None:
        if not self._sim.has_box:
            raise FormulaError("Variable evaluation before simulation box is defined")

    def _entry(self, source: Any, what: str, name: str, index: Sequence[int]) -> float:
        kind = ("scalar", "vector", "array")[min(len(index), 2)]
        if getattr(source, kind, None) is None:
            raise FormulaError(f"Mismatched {what} in variable formula")
        value = current(self._sim, source, kind)
        _positive(index)
        for at in index:
            if not 1 <= at <= len(value):
                raise FormulaError(f"Variable formula {what} {kind} is accessed out-of-range")
            value = value[at - 1]
        return float(value)

    def keyword(self, name: str) -> float:
        self._need_box()
        return float(self._sim.output.thermo.value(name))

    def atom(self, name: str, tag: int) -> float:
        """``x[5]``, ``mass[5]`` and the like: a property of the atom with that ID."""
        self._need_box()
        _positive([tag])
        sim, atoms = self._sim, self._sim.atoms
        simple = {"id": atoms.tag, "mol": atoms.molecule, "type": atoms.type}
        vector = len(name) in (1, 2) and name[-1] in "xyz" and (name[:-1] or "x") in _VECTORS
        if name not in simple and name != "mass" and not vector:
            raise FormulaError(f"Invalid atom vector {name} in variable formula")
        if tag > atoms.tag[: atoms.n].max(initial=0):
            raise FormulaError("Variable atom ID is too large")
        rows = (atoms.tag[: atoms.n] == tag).nonzero()[0]
        if not len(rows):
            return 0.0  # an atom that was lost or deleted
        row = int(rows[0])
        if name == "mass":
            return float(sim.masses()[row])
        if name in simple:
            return float(simple[name][row])
        return float(getattr(atoms, name[:-1] or "x")[row, "xyz".index(name[-1])])

    def named(self, function: str, names: Sequence[str]) -> float:
        """Functions whose arguments are names."""
        sim = self._sim
        if function == "is_file":
            return float(len(names) == 1 and Path(names[0]).is_file())
        if function == "count":
            if len(names) > 1:
                raise Unsupported(
                    "LAMMPS has regions in group functions, pylmp's native engines do not", hint="count(group)"
                )
            group = names[0] if names else ""
            bit = sim.groups.bit(group)
            if not bit:
                raise FormulaError(f"Group {group} in variable formula does not exist")
            return float(((sim.atoms.mask[: sim.atoms.n] & bit) != 0).sum())
        known: dict[str, Any] = {
            "compute": sim.computes, "dump": sim.output.dumps, "fix": [fix.id for fix in sim.fixes],
            "group": sim.groups.names, "region": sim.regions, "variable": self._variables.known,
        }  # fmt: skip
        if len(names) != 2 or names[0] not in known:
            raise FormulaError("Invalid is_defined() function in variable formula")
        return float(names[1] in known[names[0]])

    def random(self, seed: int) -> RanMars:
        if self._stream is None:
            from pylmp.kernels.random import RanMars

            try:
                self._stream = RanMars(seed)
            except ValueError as error:
                raise ScriptError(str(error)) from None
        return self._stream

    def clock(self) -> Clock:
        sim = self._sim
        return Clock(sim.step, sim.begin, sim.end if sim.output.running else sim.begin, sim.dt)


def _positive(index: Sequence[int]) -> None:
    if any(at <= 0 for at in index):
        raise ScriptError("Index between variable brackets must be positive")
