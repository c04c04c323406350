"""What setforce, addforce and aveforce share: fx fy fz, and which atoms they act on."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pylmp.model.atoms import Floats
from pylmp.model.fix import Fix
from pylmp.model.quantity import Quantity
from pylmp.model.region import named
from pylmp.text.words import Args

if TYPE_CHECKING:
    from pylmp.model.simulation import Simulation


class ForceFix(Fix):
    """A fix that changes the forces of its group, or of those of its atoms that are inside a region now.

    force     fx fy fz: numbers or variables, absent where NULL may stand
    per_atom  atom-style variables may stand there
    missing invalid   what LAMMPS says of a variable that does not exist, that has another style
    """

    region = ""
    force: list[Quantity]
    per_atom = True
    missing, invalid = "Variable {} for {} does not exist", "Variable {} for {} is invalid style"

    def read_force(self, args: Args, null: bool) -> None:
        args.need(3)
        self.force = [Quantity.read(args, null=null) for _ in range(3)]

    def read_keywords(self, sim: Simulation, args: Args, others: dict[str, Callable[[Args], None]]) -> None:
        """region ID, and what else a style knows: keyword -> reader of its one value."""
        while len(args):
            key = args.word()
            if key.text != "region" and key.text not in others:
                args.fail(f"Unknown {args.what} keyword: {key.text}", key, hint=" ".join(["region", *others]))
            args.need(1, key.text)
            if key.text in others:
                others[key.text](args)
                continue
            name = args.word()
            if name.text not in sim.regions:
                args.fail(f"Region {name.text} for {args.what} does not exist", name, hint="region comes first")
            self.region = name.text

    def init(self, sim: Simulation) -> None:
        for force in self.force:
            force.check(sim, f"fix {self.style}", atoms=self.per_atom, missing=self.missing, invalid=self.invalid)
        if self.region:
            named(sim, self.region, f"fix {self.style}")

    @property
    def varies(self) -> bool:
        return any(force.varies for force in self.force)

    def members(self, sim: Simulation) -> NDArray[np.bool_]:
        chosen = super().members(sim)
        if self.region:
            chosen &= sim.regions[self.region].inside(sim.atoms.x[: sim.atoms.n])
        return np.asarray(chosen)

    def values(self, sim: Simulation, rows: NDArray[np.bool_], *others: Quantity) -> list[Floats | float]:
        """fx fy fz, and others, now: a number each, or (k,) numbers for the k chosen rows; 0.0 where absent."""
        if not self.varies:
            return [quantity.value for quantity in (*self.force, *others)]
        group = super().members(sim)
        with self.reading(sim, sim.step + 1):
            found = [0.0 if quantity.absent else quantity.numbers(sim, group) for quantity in (*self.force, *others)]
        return [value[rows] if isinstance(value, np.ndarray) else value for value in found]
