"""Atoms that leave, and geometry that LAMMPS warns of at set-up."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

import numpy as np

from pylmp.model.atoms import Ints
from pylmp.model.bond import pairs_of_rows
from pylmp.model.topology import BOND, Kind, entries
from pylmp.text.diagnostic import ScriptError

if TYPE_CHECKING:
    from pylmp.model.simulation import Simulation

_ROWS = 2**15  # that are looked at together: a bound on memory
_STRETCH = 1.1  # measured on LAMMPS 22 Jul 2025: it warns as if bonds were this much longer


def remove_lost(sim: Simulation) -> None:
    """Drop owned atoms beyond the faces, as LAMMPS's exchange does: the last atom moves into the hole. In frame coordinates.

    In periodic directions these are atoms more than one box length away, since wrapping moves by one at most.
    """
    atoms = sim.atoms
    if not sim.box.lost(atoms):
        return
    lo, hi = sim.box.frame
    for d in range(3):
        x = atoms.x[: atoms.n, d]
        outside = (x < lo[d]) | (x >= hi[d])
        if outside.any():
            atoms.drop(outside)


def check_lost_partner(sim: Simulation, lost: bool, sentence: str) -> None:
    """What thermo_modify lost/bond wants where a bond's partner is lost: an error, a warning, nothing."""
    if lost and sim.lost_bonds == "error":
        raise ScriptError(sentence, hint="an atom was lost: a smaller timestep, or a boundary that keeps it")
    if lost and sim.lost_bonds == "warn":
        sim.console.warning(sentence)


def looks_for_bonded(sim: Simulation) -> list[Kind]:
    """What check_bonded looks for. Of bonds the bond list says so itself when that is an error."""
    return [kind for kind in sim.style.kinds if kind.style(sim) is not None and (kind is not BOND or sim.lost_bonds == "warn")]


def check_bonded(sim: Simulation) -> None:
    """At each rebuild: all atoms of what has a force style are there."""
    for kind in looks_for_bonded(sim):
        found = entries(sim, kind, lambda types: types > 0)
        missing = (found.at(sim) < 0).any(axis=1)
        if not missing.any():
            continue
        tags = "".join(f" {tag}" for tag in found.tags[int(np.argmax(missing))]) + " missing on proc 0"
        which = tags if sim.lost_bonds == "error" else " missing"
        check_lost_partner(sim, True, f"{kind.name.capitalize()} atoms{which} at step {sim.step}")


def warn_image_flags(sim: Simulation) -> None:
    """Image flags that disagree along a bond: unwrapped, it is longer than half the box (where not periodic, than the box)."""
    atoms, box = sim.atoms, sim.box
    limit = np.where(box.periodic, 0.5, 1.0) * box.length

    torn = False
    for one, other in _bonded(sim, "Bond atom missing in image check"):
        apart = box.unwrap(atoms.x[one], atoms.image[one]) - box.unwrap(atoms.x[other], atoms.image[other])
        torn = torn or bool(np.any((np.abs(apart) > limit)[:, : sim.dimension]))
    if torn:
        sim.console.warning("Inconsistent image flags\nFor more information see https://docs.lammps.org/err0027")


def warn_small_box(sim: Simulation) -> None:
    """The longest bond, a tenth longer, and two or three of them where there are angles or dihedrals, must fit into half the box."""
    longest = -1.0
    for one, other in _bonded(sim, "Bond atom missing in box size check"):
        d = sim.box.minimum_image(sim.atoms.x[one] - sim.atoms.x[other])
        longest = max(longest, float(np.sqrt(d[:, 0] * d[:, 0] + d[:, 1] * d[:, 1] + d[:, 2] * d[:, 2]).max()))
    if longest < 0.0:
        return
    reach = longest * _STRETCH * (3.0 if sim.dihedrals else 2.0 if sim.angles else 1.0)
    if np.any(((reach > 0.5 * sim.box.length) & np.array(sim.box.periodic))[: sim.dimension]):
        sim.console.warning("Bond/angle/dihedral extent > half of periodic box length")


def _bonded(sim: Simulation, sentence: str) -> Iterator[tuple[Ints, Ints]]:
    """Rows of both ends of the bonds that are on, where the box is periodic, in stretches of bonds; sentence: to say of those with one end."""
    if not sim.has_bonds or not any(sim.box.periodic):
        return
    lost, by_tag = False, sim.atoms.rows_by_tag()
    for begin in range(0, sim.atoms.n, _ROWS):
        rows, _, partners = pairs_of_rows(sim, lambda kinds: kinds > 0, begin, min(begin + _ROWS, sim.atoms.n), by_tag)
        here = partners >= 0
        if not lost and not here.all():
            lost = True
            check_lost_partner(sim, lost, sentence)
        if here.any():
            yield rows[here], partners[here]
