"""write_data: the state of a simulation as a data file.

Layout and numbers are those of LAMMPS 22 Jul 2025 (manual: write_data.html), with one exception: where LAMMPS rounds a mass or a
coefficient (%.16g, %g) so that it would not read back as the same number, 17 digits are printed.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

import numpy as np

from pylmp.model.simulation import Simulation
from pylmp.text.number import shortest

TITLE = "LAMMPS data file via write_data, version 22 Jul 2025, timestep = {step}, units = {units}"
_UNMIXED = (
    "Not all mixed pair coeffs generated from mixing. Use write_data with 'pair ij' option to store all pair coeffs."
)


def data_text(sim: Simulation, coeffs: bool = True, pairs: bool = False) -> str:
    """The whole file. coeffs: with coefficients; pairs: pair coefficients for every pair of types."""
    bonds = list(_bonds(sim)) if sim.has_bonds else []
    parts = [_header(sim, len(bonds)), _section("Masses", _masses(sim))]
    if coeffs and sim.pair is not None:
        parts.append(_pair_coeffs(sim, pairs))
    if coeffs and sim.bond is not None and (rows := sim.bond.write_coeffs()):
        parts.append(_section(f"Bond Coeffs # {sim.bond.name}", (_coefficients((kind,), row) for kind, row in rows)))
    if sim.natoms:
        parts.append(_section(f"Atoms # {sim.atom_style}", _atoms(sim)))
        parts.append(_section("Velocities", _velocities(sim)))
    if bonds:
        parts.append(_section("Bonds", (f"{n} {kind} {a} {b}" for n, (kind, a, b) in enumerate(bonds, 1))))
    return "\n".join(parts)


def _section(name: str, rows: Iterable[str]) -> str:
    return "\n".join([name, "", *rows]) + "\n"


def rounded(value: float, form: str) -> str:
    """value as LAMMPS prints it, or with 17 digits where that is another number."""
    text = format(value, form)
    return text if float(text) == value else format(value, ".17g")


def _header(sim: Simulation, bonds: int) -> str:
    lines = [
        TITLE.format(step=sim.step, units=sim.units.name),
        "",
        f"{sim.natoms} atoms",
        f"{sim.atom_types} atom types",
    ]
    if sim.bond_types:
        lines += [f"{bonds} bonds", f"{sim.bond_types} bond types"]
    lines.append("")
    for axis, low, high in zip("xyz", sim.box.lo.tolist(), sim.box.hi.tolist(), strict=True):
        lines.append(f"{shortest(low)} {shortest(high)} {axis}lo {axis}hi")
    if sim.box.triclinic:
        lines.append(" ".join(map(shortest, sim.box.tilt.tolist())) + " xy xz yz")
    return "\n".join(lines) + "\n"


def _masses(sim: Simulation) -> Iterator[str]:
    for kind in range(1, sim.atom_types + 1):
        yield f"{kind} {rounded(float(sim.mass[kind]), '.16g')}"


def _pair_coeffs(sim: Simulation, pairs: bool) -> str:
    rows = (_coefficients(types, row) for types, row in sim.pair.write_coeffs(pairs))
    return _section(f"{'PairIJ' if pairs else 'Pair'} Coeffs # {sim.pair.name}", rows)


def _coefficients(types: tuple[int, ...], values: Sequence[float]) -> str:
    return " ".join([*map(str, types), *(rounded(float(value), "g") for value in values)])


def warn_unmixed(sim: Simulation) -> None:
    """LAMMPS's warning when pair coefficients of unlike types are lost, because a script gave them."""
    if sim.pair is not None and any(i != j for part in sim.pair.parts for i, j in part.given):
        sim.console.warning(_UNMIXED)


def _atoms(sim: Simulation) -> Iterator[str]:
    atoms = sim.atoms
    columns = [atoms.tag, atoms.molecule, atoms.type] if sim.has_bonds else [atoms.tag, atoms.type]
    table = np.stack([column[: atoms.n] for column in columns], axis=1)
    rows = zip(table.tolist(), atoms.x[: atoms.n].tolist(), atoms.image[: atoms.n].tolist(), strict=True)
    for numbers, x, image in rows:
        yield " ".join([*map(str, numbers), *map(shortest, x), *map(str, image)])


def _velocities(sim: Simulation) -> Iterator[str]:
    atoms = sim.atoms
    for tag, v in zip(atoms.tag[: atoms.n].tolist(), atoms.v[: atoms.n].tolist(), strict=True):
        yield " ".join([str(tag), *map(shortest, v)])


def _bonds(sim: Simulation) -> Iterator[tuple[int, int, int]]:
    """(type, atom, partner) of every bond that is not broken, once: in local order, slots in order. Off bonds are on again."""
    atoms = sim.atoms
    slots = np.arange(atoms.bond_per_atom)
    used = (slots < atoms.num_bond[: atoms.n, None]) & (atoms.bond_type[: atoms.n] != 0)
    if not sim.newton_bond:
        used &= atoms.tag[: atoms.n, None] < atoms.bond_atom[: atoms.n]
    rows, cols = np.nonzero(used)
    kinds, partners = np.abs(atoms.bond_type[rows, cols]), atoms.bond_atom[rows, cols]
    yield from zip(kinds.tolist(), atoms.tag[rows].tolist(), partners.tolist(), strict=True)
