"""What setforce and addforce share: fx fy fz, and which atoms they act on."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pylmp.model.fix import Fix
from pylmp.text.diagnostic import ScriptError, Unsupported
from pylmp.text.words import Args

if TYPE_CHECKING:
    from pylmp.model.simulation import Simulation


def read_components(args: Args, null: bool) -> list[float | None]:
    """fx fy fz as numbers; None for NULL where that is allowed. Variables are LAMMPS's only."""
    args.need(3)
    result: list[float | None] = []
    for _ in range(3):
        word = args.word()
        if word.text.startswith("v_"):
            raise Unsupported(f"LAMMPS has variables in {args.what}, pylmp's native engines do not", word.span)
        result.append(None if null and word.text == "NULL" else args.as_number(word))
    return result


class ForceFix(Fix):
    """A fix that changes the forces of its group, or of those of its atoms that are inside a region now."""

    region = ""

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
        if self.region and self.region not in sim.regions:
            raise ScriptError(f"Region {self.region} for fix {self.style} does not exist", hint="it was deleted")

    def members(self, sim: Simulation) -> NDArray[np.bool_]:
        chosen = super().members(sim)
        if self.region:
            chosen &= sim.regions[self.region].inside(sim.atoms.x[: sim.atoms.n])
        return np.asarray(chosen)
