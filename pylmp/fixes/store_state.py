"""fix ID GROUP store/state N attributes... [com yes|no]: per-atom values as they were when the fix was defined, or N steps ago at most.

attributes are those of dump custom, c_ID[I], f_ID[I], v_NAME; N = 0: kept for good. com yes: xu yu zu without the center of mass of
the group. per-atom: the kept values. Source: LAMMPS manual, fix_store_state.html.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from pylmp.dumps.attributes import ATTRIBUTES, absent
from pylmp.model.atoms import Floats
from pylmp.model.compute import current
from pylmp.model.fix import Fix
from pylmp.model.motion import center_of_mass
from pylmp.model.quantity import Quantity
from pylmp.model.reference import Reference, parse
from pylmp.model.registry import FIXES
from pylmp.model.simulation import Simulation
from pylmp.model.variables import Variables
from pylmp.text.diagnostic import ScriptError
from pylmp.text.words import Args, Word

_NOT_HERE = ("element", "typelabel", "proc", "procp1", "heatflow", "temperature")


@FIXES.register("store/state")
class StoreState(Fix):
    style = "store/state"

    def __init__(self, sim: Simulation, identity: str, group: str, bit: int, args: Args) -> None:
        super().__init__(sim, identity, group, bit, args)
        args.need(2)
        self.interval = args.integer()
        if self.interval < 0:
            args.fail(f"Invalid fix store/state never value {self.interval}", hint="0, or every so many steps")
        self.every = self.interval or 1
        self.values: list[Callable[[Simulation], Any]] = []
        self.sources: list[Reference] = []
        self.names: list[str] = []
        while (word := args.peek()) is not None and word.text != "com":
            self.values.append(self._attribute(sim, args, args.word()))
            self.names.append(word.text)
        self.relative = False
        while len(args):
            key = args.word()
            if key.text != "com":
                args.fail(f"Unknown fix store/state keyword: {key.text}", key, hint="com yes|no")
            args.need(1, "com")
            self.relative = args.yes()
        self.columns = len(self.values)
        self._key = f"fix store/state {identity}"
        sim.atoms.extra[self._key] = np.zeros((sim.atoms.capacity, self.columns))
        self._store(sim, lambda name: name[:2] not in ("c_", "f_", "v_"))
        self._first = True

    def _attribute(self, sim: Simulation, args: Args, word: Word) -> Callable[[Simulation], Any]:
        """What one word of the script stands for: sim -> (n,)."""
        name = word.text
        if absent(sim, name) and name not in _NOT_HERE:
            args.fail(f"Cannot use fix store/state {name} for atom style {sim.atom_style}", word)
        if name == "xsu" and not sim.box.triclinic:  # of this one LAMMPS keeps all digits, other than of ysu and zsu
            return lambda sim: ATTRIBUTES["xs"].values(sim, np.arange(sim.atoms.n), {}) + sim.atoms.image[: sim.atoms.n, 0]
        if name in ATTRIBUTES and name not in _NOT_HERE:
            return lambda sim: ATTRIBUTES[name].values(sim, np.arange(sim.atoms.n), {})
        if name[:2] in ("i_", "d_"):
            args.fail(f"Custom vector/array {name[2:]} for fix store/state does not exist", word)
        found = parse(name)
        if found is None or "*" in name:
            args.fail(f"Unknown fix store/state keyword: {name}", word, hint=" ".join(ATTRIBUTES))
        self.sources.append(found)
        if found.kind == "v":
            style = Variables(sim).style(found.name)
            if style is None:
                args.fail(f"Variable name {found.name} for fix store/state does not exist", word)
            if style not in ("atom", "atomfile"):
                args.fail(f"Fix store/state variable {found.name} is not atom-style variable", word)
            return lambda sim: Quantity(name=found.name, per_atom=True).numbers(sim, self.members(sim))
        return self._measured(sim, args, word, found)

    @staticmethod
    def _measured(sim: Simulation, args: Args, word: Word, found: Reference) -> Callable[[Simulation], Any]:
        source = found.source(sim)
        what = f"Fix store/state {found.what} {found.name}"
        if source is None:
            args.fail(f"{found.what.capitalize()} ID {found.name} for fix store/state does not exist", word)
        if not callable(getattr(source, "per_atom", None)):
            args.fail(f"{what} does not calculate per-atom values", word)
        columns = int(getattr(source, "columns", 0))
        columns = 0 if columns == 1 else columns
        column = found.index[0] if found.index else 0
        if columns and not column:
            args.fail(f"{what} does not calculate a per-atom vector", word, hint=f"{word.text}[1]")
        if column and not columns:
            args.fail(f"{what} does not calculate per-atom array", word, hint=f"{found.kind}_{found.name}")
        if column > columns:
            args.fail(f"{what} array is accessed out-of-range", word, hint=f"1 to {columns}")

        def values(sim: Simulation) -> Any:
            table = current(sim, found.source(sim), "per_atom")
            return table[:, column - 1] if column else table

        return values

    def init(self, sim: Simulation) -> None:
        for found in self.sources if self.interval else []:
            missing = Variables(sim).style(found.name) is None if found.kind == "v" else found.source(sim) is None
            if missing:
                name = "Variable name" if found.kind == "v" else f"{found.what.capitalize()} ID"
                raise ScriptError(f"{name} {found.name} for fix store/state does not exist", hint="it was deleted")

    def setup(self, sim: Simulation) -> None:
        """What is measured was not there yet when the fix was defined."""
        if self._first:
            self._first = False
            self._store(sim, lambda name: name[:2] in ("c_", "f_", "v_"))

    def calls(self, sim: Simulation, hook: str) -> list[Callable[[], float]] | None:
        return None if self.interval else []

    def end_of_step(self, sim: Simulation) -> None:
        """Other than most, LAMMPS has computes evaluated anew here only if somebody else did so since the last time."""
        if self.interval:
            self._store(sim)
            sim.asking.again(sim.step + self.every)

    def _store(self, sim: Simulation, wanted: Callable[[str], bool] = lambda name: True) -> None:
        rows = self.members(sim)
        kept = sim.atoms.extra[self._key][: sim.atoms.n]
        kept[~rows] = 0.0
        shift = center_of_mass(sim, rows) if self.relative else np.zeros(3)
        for k, (name, values) in enumerate(zip(self.names, self.values, strict=True)):
            if not wanted(name):
                continue
            kept[rows, k] = np.asarray(values(sim))[rows]
            if name in ("xu", "yu", "zu"):
                kept[rows, k] -= shift["xyz".index(name[0])]

    def per_atom(self, sim: Simulation) -> Floats:
        """(n,) with one attribute, else (n, attributes)."""
        kept = sim.atoms.extra[self._key][: sim.atoms.n]
        return np.array(kept[:, 0] if self.columns == 1 else kept)

    def atom_state(self, sim: Simulation) -> Floats:
        return np.asarray(sim.atoms.extra[self._key][: sim.atoms.n], float)

    def restore_atoms(self, sim: Simulation, values: Floats) -> None:
        sim.atoms.extra[self._key][: sim.atoms.n] = values
        self._first = False

    def removed(self, sim: Simulation) -> None:
        sim.atoms.extra.pop(self._key, None)
