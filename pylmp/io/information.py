"""What the info command tells, category by category, laid out as LAMMPS 22 Jul 2025 does.

Source: LAMMPS manual, info.html. What is LAMMPS's own (its libraries, packages, compiler) is pylmp's here.
"""

from __future__ import annotations

import sys
import time
from collections.abc import Callable
from typing import Any

import numpy as np

from pylmp import __version__
from pylmp.model.atom_style import ATOM_STYLES
from pylmp.model.ghosts import ghost_cutoff
from pylmp.model.registry import REGISTRIES
from pylmp.model.simulation import Simulation
from pylmp.text.number import eight

_STARTED = time.monotonic()
_WIDTH, _LINE = 16, 80  # of a column, of a line of style names


def _entry(*parts: tuple[str, object]) -> str:
    """``name = value,  name = value``, values padded to columns; the last one is not."""
    padded = [f"{label}{f'{value},':<16}" for label, value in parts[:-1]]
    return "  ".join([*padded, f"{parts[-1][0]}{parts[-1][1]}"]) + "\n"


def system(sim: Simulation) -> str:
    """Units, atom style, counts, box, step."""
    style, types = sim.style, sim.atom_types
    kind = sim.map_style if sim.map_style in ("array", "hash", "yes") else "array" if sim.has_bonds else "none"
    text = f"\nSystem information:\nUnits         = {sim.units.name}\nAtom style    = {style.name}\nAtom map      = {kind}\n"
    text += "Molecule type = standard\n" if sim.has_bonds else ""
    text += f"Atoms     = {sim.natoms:12d},  types = {types:8d},  style = {sim.pair.name if sim.pair else 'none'}\nAtoms with atom IDs\n"
    text += "Atoms with molecule IDs\n" if sim.has_bonds else ""
    text += "Atoms with per-type masses\n" if sim.has_box else ""
    text += "Atoms with per-atom charges\n" if style.charged else ""
    if sim.has_bonds:
        bond = (sim.bond.parts[0].style.name if len(sim.bond.parts) == 1 else "hybrid") if sim.bond else "none"
        rows = [("Bonds", sim.bonds, sim.bond_types, bond)]
        for name in ("angle", "dihedral", "improper"):
            chosen = getattr(sim, name)
            rows.append((f"{name.capitalize()}s", getattr(sim, f"{name}s"), getattr(sim, f"{name}_types"), chosen.name if chosen else "none"))
        text += "".join(f"{name:<9} = {count:12d},  types = {kinds:8d},  style = {used}\n" for name, count, kinds, used in rows)
        for label, weights in (("lj =   ", sim.special.lj), ("coul = ", sim.special.coul)):
            text += f"Special bond factors {label} {''.join(f'{eight(w):<8} ' for w in weights).rstrip(' '):<26}\n"
    text += "Kspace style = none\n" + _box(sim)
    return text + f"\nCurrent timestep number = {sim.step}\nCurrent timestep size = {eight(sim.dt)}\n"


def _box(sim: Simulation) -> str:
    if not sim.has_box:
        return "\nBox has not yet been created\n"
    box = sim.box
    edges = " x ".join(eight(float(q)) for q in box.length)
    faces = " ".join(f"{low},{high}" for low, high in box.boundary)
    text = f"\nDimensions = {sim.dimension}\n{'Triclinic' if box.triclinic else 'Orthogonal'} box = {edges}\nBoundaries = {faces}\n"
    for d, axis in enumerate("xyz"):
        text += f"{axis}lo, {axis}hi = {eight(float(box.lo[d]))}, {eight(float(box.hi[d]))}\n"
    return text + (f"Xy, xz, yz = {', '.join(eight(float(q)) for q in box.tilt)}\n" if box.triclinic else "")


def communication(sim: Simulation) -> str:
    """Ghost atoms; and that there is one process."""
    text = f"\nCommunication information:\nMPI version: none, pylmp runs in one process\nComm style = {sim.communication},  Comm layout = {sim.layout}\n"
    text += f"Communicate velocities for ghost atoms = {'yes' if sim.ghost_velocity else 'no'}\n"
    if sim.has_box:
        text += f"Communication mode = single\nCommunication cutoff = {eight(ghost_cutoff(sim))}\n"
    text += "Nprocs = 1,   Nthreads = 1\n"
    return text + ("Processor grid = 1 x 1 x 1\n" if sim.has_box else "")


def computes(sim: Simulation) -> str:
    return "\nCompute information:\n" + "".join(
        f"Compute[{k:3d}]:  " + _entry(("", one.id), ("style = ", one.style), ("group = ", one.group))
        for k, one in enumerate(sim.computes.values())
    )


def fixes(sim: Simulation) -> str:
    known = [fix for fix in sim.fixes if not fix.internal]
    return "\nFix information:\n" + "".join(
        f"Fix[{k:3d}]:      " + _entry(("", one.id), ("style = ", one.style), ("group = ", one.group)) for k, one in enumerate(known)
    )


def dumps(sim: Simulation) -> str:
    return "\nDump information:\n" + "".join(
        f"Dump[{k:3d}]:     "
        + _entry(("", one.id), ("file = ", one.file.name), ("style = ", one.style), ("group = ", one.group), ("every = ", _interval(one)))
        for k, one in enumerate(sim.output.dumps.values())
    )


def _interval(dump: Any) -> object:
    every = dump.schedule.every
    return every if isinstance(every, int) else every.name


def groups(sim: Simulation) -> str:
    return "\nGroup information:\n" + "".join(
        f"Group[{k:2d}]:     {name:<16} ({'dynamic' if name in sim.groups.dynamic else 'static'})\n"
        for k, name in enumerate(sim.groups.names)
    )


def regions(sim: Simulation) -> str:
    """LAMMPS numbers them all 0."""
    text = "\nRegion information:\n"
    for name, region in sim.regions.items():
        text += "Region[  0]:  " + _entry(("", name), ("style = ", region.style), ("side = ", "out" if region.options.outside else "in"))
        if region.bounds is None:
            text += "   No Boundary\n"
        else:
            low, high = (" ".join(eight(float(q)) for q in corner) for corner in region.bounds)
            text += f"   Boundary:  lo {low}  hi {high}\n"
    return text


def variables(sim: Simulation) -> str:
    text = "\nVariable information:\n"
    for k, (name, one) in enumerate(sim.script.variables.known.items()):
        values = " ".join(one.values)
        if one.style in ("equal", "vector", "format", "getenv"):
            literal = values if one.style == "vector" and values.startswith("[") else "(undefined)"
            values += f" {one.told if one.told is not None else literal}"
        elif one.style in ("loop", "uloop"):
            values = str(one.first + one.at)
        elif one.style in ("internal", "timer"):
            values = eight(one.number)
        elif one.style == "file":
            values = one.text()
        gap = "" if one.style == "internal" or not values else " "
        text += f"Variable[{k:3d}]: " + _entry(("", name), ("style = ", one.style), ("def =", f"{gap}{values}"))
    return text


def clock(sim: Simulation) -> str:
    def told(seconds: float) -> str:
        whole = int(seconds)
        return f"{whole // 3600:4d}:{whole // 60 % 60:02d}:{whole % 60:02d}"

    return (
        f"\nTotal time information (MPI rank 0):\n  CPU time: {told(time.process_time())}\n"
        f" Wall time: {told(time.monotonic() - _STARTED)}\n"
    )


def memory(sim: Simulation) -> str:
    import resource  # not on every system

    arrays = sum(a.nbytes for a in vars(sim.atoms).values() if isinstance(a, np.ndarray))
    resident = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024.0
    return (
        f"\nMemory allocation information (MPI rank 0):\n\nTotal dynamically allocated memory: {arrays / 1024.0**2:.4g} Mbyte\n"
        f"Maximum resident set size: {resident:.4g} Mbyte\n"
    )


def config(sim: Simulation) -> str:
    return (
        f"\npylmp version: {__version__}, as LAMMPS 22 Jul 2025 / 20250722\n\nPython {sys.version.split()[0]}, numpy {np.__version__}\n"
        "\nsizeof(smallint): 32-bit\nsizeof(imageint): 32-bit\nsizeof(tagint):   32-bit\nsizeof(bigint):   64-bit\n"
    )


def accelerator(sim: Simulation) -> str:
    return "\nAccelerator configuration:\n\nnone: each style has one implementation here\n"


def coeffs(sim: Simulation) -> str:
    """Which coefficients were given."""
    if not sim.has_box:
        return ""
    text = "\nCoeff status information:\n"
    if sim.pair is not None:
        text += "\nPair coeffs\n"
        for i in range(1, sim.atom_types + 1):
            for j in range(i, sim.atom_types + 1):
                text += f"{i:6d} {j:6d}: is {'set' if (i, j) in sim.pair.acting else 'not set'}\n"
    if sim.bond is not None:
        text += "\nBond coeffs\n"
        if not sim.bond.given:
            text += "Bond style not yet initialized\n"
        else:
            text += "".join(f"{k:6d}: is {'set' if k in sim.bond.given else 'not set'}\n" for k in range(1, sim.bond_types + 1))
    return text


_TITLES = {
    "atom": "Atom", "integrate": "Integrate", "minimize": "Minimize", "pair": "Pair", "bond": "Bond", "angle": "Angle",
    "dihedral": "Dihedral", "improper": "Improper", "kspace": "KSpace", "fix": "Fix", "compute": "Compute", "region": "Region",
    "dump": "Dump", "command": "Command",
}  # fmt: skip
STYLES = (*_TITLES, "all")


def styles(which: str) -> str:
    """The names of all styles of a kind, or of all kinds."""
    text = "\nStyles information:\n"
    others = {"atom": sorted(ATOM_STYLES), "integrate": ["verlet"], "kspace": []}
    for kind, title in _TITLES.items():
        if which in (kind, "all"):
            names = others[kind] if kind in others else REGISTRIES[kind].names()
            text += f"\n{title} styles:\n\n{_columns(names)}\n\n"
    return text


def _columns(names: list[str]) -> str:
    text, at = "", 0
    for name in names:
        width = -(-(len(name) + 1) // _WIDTH) * _WIDTH if len(name) >= _WIDTH else _WIDTH
        if at + width > _LINE:
            text, at = text + "\n", 0
        text, at = text + f"{name:<{width}}", at + width
    return text + "\n"


CATEGORIES: dict[str, Callable[[Any], str]] = {
    "config": config, "accelerator": accelerator, "memory": memory, "communication": communication, "system": system,
    "coeffs": coeffs, "groups": groups, "regions": regions, "computes": computes, "dumps": dumps, "fixes": fixes,
    "variables": variables, "time": clock,
}  # fmt: skip  # in the order in which LAMMPS prints them
