"""The content of a restart file to a simulation. The content was checked: nothing here is half done."""

from __future__ import annotations

from typing import Any

import numpy as np

from pylmp.commands.create_box import describe
from pylmp.io.restart import layout
from pylmp.io.restart.blobs import REGISTRIES
from pylmp.io.restart.content import Content, Force
from pylmp.io.restart.gather import MIXINGS
from pylmp.model.atom_style import ATOM_STYLES
from pylmp.model.atoms import Atoms
from pylmp.model.blob import FLAG, MIXING, MODIFIED, UNLESS, Blob
from pylmp.model.bond import Bond, BondPart
from pylmp.model.box import SHRINK_MARGIN, Box
from pylmp.model.many_body import ManyBody
from pylmp.model.pair import Pair, PairPart
from pylmp.model.simulation import Simulation
from pylmp.model.special import build_special
from pylmp.model.style import Options
from pylmp.model.topology import BOND, KIND, KINDS, Kind
from pylmp.model.triclinic import Triclinic
from pylmp.model.units import UNITS
from pylmp.model.waiting import Waiting
from pylmp.text.diagnostic import ScriptError
from pylmp.text.number import shortest

_PERIODIC = (("p", "p"),) * 3
_NOBODY = 2**31 - 1  # no atom has this ID


def restore(sim: Simulation, content: Content) -> None:
    """Make sim what content says, with LAMMPS's lines in the log."""
    _settings(sim, content)
    _box(sim, content)
    sim.define_types(*(content.header[f"{kind} types"] for kind in ("atom", *layout.KINDS)))
    sim.mass[1:] = content.mass
    sim.groups.names = {name: 1 << slot for name, slot in content.groups.items()}
    labels = iter(content.labels or ())
    for kind in ("atom", *layout.KINDS):
        for number in range(1, content.header[f"{kind} types"] + 1):
            if label := next(labels, ""):
                sim.labels.assign(kind, number, label)
    for kind, force in content.forces.items():
        sim.console.both(f"  restoring {kind} style {force.style} from restart\n")
        {"pair": _pair, "bond": _bond}.get(kind, _many_body)(sim, force, KIND.get(kind))
    _atoms(sim, content)
    if content.fixes or content.kept:
        _wait(sim, content)
    for kind in layout.KINDS:
        if content.header[f"{kind}s"]:
            sim.console.both(f"  {content.header[f'{kind}s']} {kind}s\n")
    if sim.has_bonds:
        build_special(sim)


def _settings(sim: Simulation, content: Content) -> None:
    """What single commands set: units, newton, boundary, special_bonds, timestep, atom_modify, comm_modify."""
    header, console = content.header, sim.console
    units = UNITS[header["units"]]
    if units is not sim.units:
        if sim.dt != sim.units.dt:
            dt, default = shortest(sim.dt), shortest(units.dt)
            console.warning(f"Changing timestep from {dt} to {default} due to changing units to {units.name}")
        sim.units, sim.neighbor.skin = units, units.skin
    sim.dt = header["timestep"]
    sim.step = header["step"]
    sim.output.clock.set(header["time step"], header["time"])
    _ = sim.computes  # LAMMPS's own are there before the file says what the dimension is
    sim.dimension = header["dimension"]
    if header["processes"] != 1:
        console.warning(f"Restart file used different # of processors: {header['processes']} vs. 1")
    if header["newton pair"] and not sim.newton_pair:
        console.warning("Restart file used different newton pair setting, using input script value")
    if header["newton bond"] and not sim.newton_bond:
        console.warning("Restart file used different newton bond setting, using restart file value")
    sim.newton_bond = bool(header["newton bond"])
    letters = [layout.FACES[code] for code in header["boundary"]]
    boundary = tuple((letters[k], letters[k + 1]) for k in (0, 2, 4))
    if sim.boundary not in (boundary, _PERIODIC):
        console.warning("Restart file used different boundary settings, using restart file values")
    sim.boundary = boundary
    sim.special.lj = tuple(header["special lj"])
    sim.special.coul = tuple(header["special coul"])
    sim.map_style = sim.map_style or ("any" if header["map style"] else "")  # of which kind it was does not matter to LAMMPS
    sim.sort.every, sim.sort.bin_size = header["sort every"], header["sort bin"]
    sim.comm.cutoff, sim.comm.velocity = header["comm cutoff"], bool(header["comm velocity"])
    sim.style = ATOM_STYLES[header["atom style"][0]]
    console.both(f"  restoring atom style {sim.atom_style} from restart\n")


def _box(sim: Simulation, content: Content) -> None:
    """The faces stand where they stood: shrink-wrapped ones are not moved outward again."""
    header = content.header
    lo, hi = np.array(header["lo"]), np.array(header["hi"])
    box: Box
    if header["triclinic"]:
        tilt = np.array([header["xy"], header["xz"], header["yz"]])
        box = Triclinic(lo, hi, sim.boundary, sim.dimension, tilt)
    else:
        box = Box(lo, hi, sim.boundary, sim.dimension)
    box.margin = SHRINK_MARGIN * box.length
    box.least_lo, box.least_hi = np.array(header["least"][0::2]), np.array(header["least"][1::2])
    sim.box = box
    sim.console.both(f"  {describe(box)}\n  1 by 1 by 1 MPI processor grid\n")


def _options(force: Force, blob: Blob) -> Options:
    """The settings of a style as it reads them from a script."""
    options: Options = dict(blob.defaults)
    for name, how in blob.settings:
        value: Any = force.settings[name]
        value = bool(value) if how == FLAG else not value if how == UNLESS else value
        options[name] = MIXINGS[int(value)] if how == MIXING else value
    return options


def _pair(sim: Simulation, force: Force, _: Kind | None) -> None:
    parts = []
    for each in force.parts or [force]:
        style: Any = REGISTRIES["pair"].find(each.style)
        blob = style.restart
        options = _options(each, blob.in_hybrid if force.parts else blob)
        modified = {name: options.pop(name) for name in MODIFIED if name in options}
        part = PairPart(style, options)
        for name, value in modified.items():
            setattr(part.settings, name, value)
        parts.append(part)
    for part in parts:
        same = [other for other in parts if other.style is part.style]
        part.number = same.index(part) + 1 if len(same) > 1 else 0
    sim.pair = Pair(force.style, parts, sim.atom_types)
    for types, numbers in force.pairs.items():
        named = dict(zip(blob.coeffs, blob.unpack(numbers), strict=True))
        part.given[types] = tuple(named[c.name] for c in style.coeffs), named["cut"]
        sim.pair.acting[types] = [part]


def _bond(sim: Simulation, force: Force, _: Kind | None) -> None:
    parts = []
    for each in force.parts or [force]:
        style: Any = REGISTRIES["bond"].find(each.style)
        blob = style.restart.in_hybrid if force.parts else style.restart
        part = BondPart(style, _options(each, blob), sim.bond_types)
        part.waits = bool(part.memory)
        at = [c.name for c in style.coeffs]
        for kind, row in enumerate(zip(*each.columns, strict=True), 1):
            for name, value in zip(blob.coeffs, blob.unpack(row), strict=True):
                if name in at:
                    part.table[kind, at.index(name)] = value
        parts.append(part)
    sim.bond = Bond(force.style, parts, sim.bond_types)
    sim.bond.restored = True
    if blob.kept:
        parts[0].mine[1:] = 1
        sim.bond.given = set(range(1, sim.bond_types + 1))


def _many_body(sim: Simulation, force: Force, kind: Kind | None) -> None:
    assert kind is not None
    style: Any = REGISTRIES[kind.name].find(force.style)
    made = ManyBody(kind, style, True, kind.types(sim))
    for number in range(made.types):
        made.given[number + 1] = tuple(style.restart.unpack([column[number] for column in force.columns])) if force.columns else ()
    setattr(sim, kind.name, made)


def _atoms(sim: Simulation, content: Content) -> None:
    header, read = content.header, content.atoms
    slots = {kind: header[f"{kind} per atom"] for kind in layout.KINDS}
    sim.extra_slots = {kind: header[f"extra {kind} per atom"] for kind in layout.KINDS}
    sim.atoms = atoms = Atoms(slots.pop("bond"), header["special per atom"], **slots)
    image = read["image"].copy()
    x = read["x"].copy()
    sim.box.remap(x, image)
    outside = (x < sim.box.lo) | (x >= sim.box.hi)
    if not sim.box.triclinic and outside.any():
        row = int(np.flatnonzero(outside.any(axis=1))[0])
        says, hint = "Did not assign all restart atoms correctly", f"atom {int(read['id'][row])} is outside the box"
        raise ScriptError(says, hint=hint, manual="read_restart.html")
    if sim.bond is not None:
        atoms.set_history(sim.bond.memory)
    atoms.append(x, read["type"])
    n = atoms.n
    atoms.tag[:n], atoms.v[:n], atoms.image[:n] = read["id"], read["v"], image
    atoms.mask[:n] = read["mask"] & 0xFFFFFFFF
    for name in ("molecule", "q"):
        if name in read:
            getattr(atoms, name)[:n] = read[name]
    for kind in sim.style.kinds:
        types, members = read[f"{kind.name}_type"], np.minimum(read[f"{kind.name}_atom"], _NOBODY)
        most = types.shape[1]
        kind.numbers(sim)[:n] = read[f"num_{kind.name}"]
        kind.kinds(sim)[:n, :most] = types
        kind.members(sim)[:n, :most] = members[:, :, 0] if kind is BOND else members
    for kind in KINDS:
        kind.set_total(sim, header[kind.plural])
    sim.natoms = header["atoms"]
    sim.console.both(f"  {sim.natoms} atoms\n")


def _wait(sim: Simulation, content: Content) -> None:
    sim.waiting = Waiting()
    for identity, style, state in content.fixes:
        sim.waiting.add(identity, style, state)
    for kept in content.kept:
        values = np.zeros((sim.atoms.capacity, kept.width))
        values[: sim.atoms.n, : kept.values.shape[1]] = kept.values
        sim.waiting.add_atoms(sim, kept.identity, kept.style, values)
