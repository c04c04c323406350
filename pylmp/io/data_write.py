"""write_data: the state of a simulation as a data file.

Layout and numbers are those of LAMMPS 22 Jul 2025 (manual: write_data.html), with one exception: where LAMMPS rounds a charge, a mass or a
coefficient (%.16g, %g) so that it would not read back as the same number, 17 digits are printed.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from pylmp.io.data_history import history_text
from pylmp.model.simulation import Simulation
from pylmp.model.topology import KIND, Entries, Kind, entries
from pylmp.text.diagnostic import ScriptError
from pylmp.text.number import shortest

TITLE = "LAMMPS data file via write_data, version 22 Jul 2025, timestep = {step}, units = {units}"
_UNMIXED = (
    "Not all mixed pair coeffs generated from mixing. Use write_data with 'pair ij' option to store all pair coeffs."
)


@dataclass
class Contents:
    """What a file is to hold. coeffs: coefficients; pairs: those of every pair of types; labels: the sections of type labels;
    named: labels stand for types in Atoms, Bonds, ...; history: what continues a run exactly, as comment lines."""

    coeffs: bool = True
    pairs: bool = False
    labels: bool = True
    named: bool = False
    history: bool = False


def data_text(sim: Simulation, contents: Contents) -> str:
    """The whole file."""
    bonded = {kind: _stored(sim, kind) for kind in sim.style.kinds}
    parts = [_header(sim, {kind.name: len(found) for kind, found in bonded.items()})]
    parts += [_section(f"{kind.capitalize()} Type Labels", rows) for kind, rows in _labels(sim, contents)]
    parts.append(_section("Masses", _masses(sim)))
    if contents.coeffs and sim.pair is not None and sim.pair.write_coeffs(contents.pairs):
        parts.append(_pair_coeffs(sim, contents.pairs))
    for kind in sim.style.kinds if contents.coeffs else ():
        style = kind.style(sim)
        if style is not None and (rows := style.write_coeffs()):
            lines = (_coefficients((number,), row) for number, row in rows)
            parts.append(_section(f"{kind.name.capitalize()} Coeffs # {style.name}", lines))
    if sim.natoms:
        parts.append(_section(f"Atoms # {sim.atom_style}", _atoms(sim, contents.named)))
        parts.append(_section("Velocities", _velocities(sim)))
    for kind, found in bonded.items():
        if len(found):
            parts.append(_section(kind.plural.capitalize(), _bonded(sim, found, contents.named)))
    if contents.history:
        parts.append(history_text(sim))
    return "\n".join(parts)


def _section(name: str, rows: Iterable[str]) -> str:
    return "\n".join([name, "", *rows]) + "\n"


def rounded(value: float, form: str) -> str:
    """value as LAMMPS prints it, or with 17 digits where that is another number."""
    text = format(value, form)
    return text if float(text) == value else format(value, ".17g")


def _header(sim: Simulation, counts: dict[str, int]) -> str:
    lines = [
        TITLE.format(step=sim.step, units=sim.units.name),
        "",
        f"{sim.natoms} atoms",
        f"{sim.atom_types} atom types",
    ]
    for name, count in counts.items():
        if types := KIND[name].types(sim):
            lines += [f"{count} {name}s", f"{types} {name} types"]
    lines.append("")
    for axis, low, high in zip("xyz", sim.box.lo.tolist(), sim.box.hi.tolist(), strict=True):
        lines.append(f"{shortest(low)} {shortest(high)} {axis}lo {axis}hi")
    if sim.box.triclinic:
        lines.append(" ".join(map(shortest, sim.box.tilt.tolist())) + " xy xz yz")
    return "\n".join(lines) + "\n"


def _labels(sim: Simulation, contents: Contents) -> Iterator[tuple[str, list[str]]]:
    """(kind, lines) of the sections of type labels. LAMMPS leaves out those of a kind without a force style, even where labels stand
    for its types, so that the file cannot be read; here they are written then."""
    for name in ("atom", *(kind.name for kind in sim.style.kinds)):
        types = getattr(sim, f"{name}_types")
        styled = name == "atom" or KIND[name].style(sim) is not None
        if contents.labels and (styled or contents.named) and sim.labels.complete(name, types):
            yield name, [f"{number} {sim.labels.of(name)[number]}" for number in range(1, types + 1)]


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
    part = None if sim.pair is None or sim.pair.hybrid else sim.pair.parts[0]
    if part is not None and part.style.write is not None and any(i != j for i, j in part.given):
        sim.console.warning(_UNMIXED)


def _words(sim: Simulation, kind: str, named: bool) -> dict[int, str] | None:
    """Words for types; None: their numbers. Raises ScriptError if a type has no label."""
    types = getattr(sim, f"{kind}_types")
    if not named or types == 0:
        return None
    if not sim.labels.complete(kind, types):
        bare = next(number for number in range(1, types + 1) if number not in sim.labels.of(kind))
        raise ScriptError(f"Cannot write type labels: {kind} type {bare} has none", hint=f"labelmap {kind} {bare} NAME")
    return sim.labels.of(kind)


def _atoms(sim: Simulation, named: bool) -> Iterator[str]:
    atoms, n = sim.atoms, sim.atoms.n
    words = _words(sim, "atom", named)

    def column(name: str) -> list[str]:
        values = getattr(atoms, name)[:n].tolist()
        if name == "type" and words is not None:
            return [words[value] for value in values]
        return [rounded(value, ".16g") for value in values] if name == "q" else list(map(str, values))

    def vectors(values: Any, form: Callable[[Any], str]) -> list[str]:
        return [" ".join(map(form, row)) for row in values[:n].tolist()]

    columns = [column(name) for name in sim.style.columns]
    columns.append(vectors(atoms.x, shortest))
    columns += [column(name) for name in sim.style.after]
    columns.append(vectors(atoms.image, str))
    yield from map(" ".join, zip(*columns, strict=True))


def _velocities(sim: Simulation) -> Iterator[str]:
    atoms = sim.atoms
    for tag, v in zip(atoms.tag[: atoms.n].tolist(), atoms.v[: atoms.n].tolist(), strict=True):
        yield " ".join([str(tag), *map(shortest, v)])


def _stored(sim: Simulation, kind: Kind) -> Entries:
    """All that is not broken, once: in local order, slots in order."""
    return entries(sim, kind, lambda types: types != 0).once(sim)


def _bonded(sim: Simulation, found: Entries, named: bool) -> Iterator[str]:
    """Lines ``number type atom atom ...``. What is off is on again."""
    words = _words(sim, found.kind.name, named)
    for number, (type_, tags) in enumerate(zip(np.abs(found.types).tolist(), found.tags.tolist(), strict=True), 1):
        yield " ".join([str(number), words[type_] if words else str(type_), *map(str, tags)])
