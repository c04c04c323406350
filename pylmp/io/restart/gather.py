"""A simulation to the content of a restart file."""

from __future__ import annotations

from typing import Any

import numpy as np

from pylmp.io.restart import layout
from pylmp.io.restart.content import Content, Force, Kept
from pylmp.io.restart.keepers import keepers
from pylmp.model.blob import FLAG, MIXING, UNLESS, Blob
from pylmp.model.many_body import ManyBody
from pylmp.model.mixing import ARITHMETIC, GEOMETRIC, SIXTHPOWER
from pylmp.model.simulation import Simulation
from pylmp.model.topology import BOND, KINDS
from pylmp.text.diagnostic import Unsupported

MIXINGS = (GEOMETRIC, ARITHMETIC, SIXTHPOWER)  # codes 0 to 2
MAP_USER = {"": 0, "any": 0, "array": 1, "hash": 2, "yes": 3}
_ARRAY, _HASH = 1, 2  # kinds of ID map
_LONGEST_ARRAY = 1_000_000  # larger IDs: a hash, unless the script asks for an array


def gather(sim: Simulation, files: int = 0) -> Content:
    """All that a restart file holds. What bonds remember must have been copied to their slots.

    Raises Unsupported for what LAMMPS would store and pylmp cannot.
    """
    content = Content(files=files)
    content.header = _header(sim)
    content.groups = {name: bit.bit_length() - 1 for name, bit in sim.groups.names.items()}
    content.mass = [float(mass) for mass in sim.mass[1:]]
    if sim.labels.in_use:
        kinds = (("atom", sim.atom_types), *((kind.name, kind.types(sim)) for kind in KINDS))
        content.labels = [sim.labels.of(kind).get(number, "") for kind, types in kinds for number in range(1, types + 1)]
    if sim.pair is not None:
        content.forces["pair"] = _pair(sim)
    if sim.bond is not None:
        content.forces["bond"] = _bond(sim)
    for name in ("angle", "dihedral", "improper"):
        if getattr(sim, name) is not None:
            content.forces[name] = _many_body(getattr(sim, name))
    content.atoms = _atoms(sim)
    for keeper in keepers(sim):
        if keeper.state is not None:
            content.fixes.append((keeper.identity, keeper.style, keeper.state))
        if keeper.values is not None:
            width = keeper.values.shape[1]
            counts = np.full(sim.atoms.n, width, np.int64)
            content.kept.append(Kept(keeper.identity, keeper.style, width, keeper.values, counts))
    return content


def _header(sim: Simulation) -> dict[str, Any]:
    box, atoms = sim.box, sim.atoms
    booked, time = sim.output.clock.booked
    said: dict[str, Any] = {
        "version": layout.VERSION, "smallint": 4, "imageint": 4, "tagint": 4, "bigint": 8,
        "units": sim.units.name, "step": sim.step, "dimension": sim.dimension, "processes": 1, "process grid": [1, 1, 1],
        "newton pair": sim.newton_pair, "newton bond": sim.newton_bond,
        "boundary": [layout.FACES.index(face) for faces in box.boundary for face in faces],
        "least": [float(face) for faces in zip(box.least_lo, box.least_hi, strict=True) for face in faces],
        "atom style": (sim.atom_style, []), "atoms": sim.atoms.n, "atom types": sim.atom_types,
        "triclinic": box.triclinic, "lo": box.lo.tolist(), "hi": box.hi.tolist(),
        "special lj": list(sim.special.lj), "special coul": list(sim.special.coul), "timestep": sim.dt,
        "atom id": 1, "map style": _map_style(sim), "map user": MAP_USER[sim.map_style],
        "sort every": sim.sort.every, "sort bin": sim.sort.bin_size,
        "comm cutoff": sim.comm.cutoff, "comm velocity": sim.comm.velocity,
        "special per atom": atoms.max_special, "time step": booked, "time": time,
    }  # fmt: skip
    said |= {f"periodic {axis}": periodic for axis, periodic in zip("xyz", box.periodic, strict=True)}
    for kind in KINDS:
        said |= {kind.plural: kind.total(sim), f"{kind.name} types": kind.types(sim), f"{kind.name} per atom": atoms.slots(kind.name)}
        said[f"extra {kind.name} per atom"] = sim.extra_slots.get(kind.name, 0)
    said |= dict(zip(("xy", "xz", "yz"), box.tilt.tolist(), strict=True))
    said["record growth"] = sum(said[f"{kind} per atom"] * (1 + ids) for kind, ids in layout.KINDS.items())
    return {name: said.get(name, 0) for name in layout.HEADER if name not in layout.OPTIONAL}


def _map_style(sim: Simulation) -> int:
    """Which kind of ID map LAMMPS has: none, an array, a hash."""
    if not sim.map_style and not sim.has_bonds:
        return 0
    if sim.map_style in ("array", "hash"):
        return MAP_USER[sim.map_style]
    largest = int(sim.atoms.tag[: sim.atoms.n].max(initial=0))
    return _HASH if largest > _LONGEST_ARRAY else _ARRAY


def _pair(sim: Simulation) -> Force:
    pair = sim.pair
    if pair.hybrid:
        return Force(pair.name, parts=[_part(part, part.settings, _blob(part.style, "pair").in_hybrid) for part in pair.parts])
    (part,) = pair.parts
    blob = _blob(part.style, "pair")
    force = _part(part, part.settings, blob)
    for types, (coeffs, cut) in part.given.items() if blob.kept else ():
        named = dict(zip((c.name for c in part.style.coeffs), coeffs, strict=True), cut=cut)
        force.pairs[types] = list(blob.pack([named[name] for name in blob.coeffs]))
    return force


def _bond(sim: Simulation) -> Force:
    bond = sim.bond
    if bond.name == "hybrid":
        return Force("hybrid", parts=[_part(part, part, _blob(part.style, "bond").in_hybrid) for part in bond.parts])
    (part,) = bond.parts
    blob = _blob(part.style, "bond")
    force = _part(part, part, blob)
    if blob.kept:
        at = [c.name for c in part.style.coeffs]
        columns = [part.table[1:, at.index(name)].tolist() if name in at else [0.0] * bond.types for name in blob.coeffs]
        force.columns = _packed(blob, columns)
    return force


def _many_body(force: ManyBody) -> Force:
    blob = _blob(force.style, force.kind.name)
    rows = [force.given.get(kind, (0.0,) * len(blob.coeffs)) for kind in range(1, force.types + 1)]
    columns = [[row[k] if row else 0.0 for row in rows] for k in range(len(blob.coeffs))]
    return Force(force.name, columns=_packed(blob, columns))


def _packed(blob: Blob, columns: list[list[float]]) -> list[list[float]]:
    return [list(column) for column in zip(*(blob.pack(row) for row in zip(*columns, strict=True)), strict=True)]


def _blob(style: Any, kind: str) -> Blob:
    if style.restart is None:
        says = f"LAMMPS has restart files with {kind} style {style.name}, pylmp's native engines do not"
        raise Unsupported(says, manual=style.manual)
    blob: Blob = style.restart
    return blob


def _part(part: Any, owner: Any, blob: Blob) -> Force:
    """Name and settings of one style: numbers from its options, or from owner."""
    said = {}
    for name, how in blob.settings:
        value = part.options[name] if name in part.options else getattr(owner, name)
        if how == MIXING:
            value = MIXINGS.index(value)
        said[name] = int(not value) if how == UNLESS else int(value) if how == FLAG else value
    return Force(blob.name or part.style.name, said)


def _atoms(sim: Simulation) -> dict[str, Any]:
    """Views or copies of the owned atoms' arrays. Bonds that are off are written as if they were on, as LAMMPS does."""
    atoms, n = sim.atoms, sim.atoms.n
    found: dict[str, Any] = {
        "x": atoms.x[:n], "id": atoms.tag[:n], "type": atoms.type[:n],
        "mask": atoms.mask[:n].astype(np.uint32).view(np.int32).astype(np.int64),
        "image": atoms.image[:n], "v": atoms.v[:n], "molecule": atoms.molecule[:n], "q": atoms.q[:n],
    }  # fmt: skip
    for kind in KINDS:
        members = kind.members(sim)[:n]
        found[f"num_{kind.name}"], found[f"{kind.name}_type"] = kind.numbers(sim)[:n], np.abs(kind.kinds(sim)[:n])
        found[f"{kind.name}_atom"] = members[:, :, None] if kind is BOND else members
    return found
