"""replicate NX NY NZ [bbox] [bond/periodic]: copies of the system side by side.

Atoms of a copy keep the order of the system's; copies follow each other with the z index fastest, their IDs with the x index
fastest. Bonds stay within a copy; with bond/periodic those that cross a periodic face join neighboring copies.
Source: LAMMPS manual, replicate.html.
"""

from __future__ import annotations

from itertools import product

import numpy as np

from pylmp.commands.create_box import announce
from pylmp.model import limits
from pylmp.model.atoms import Ints
from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.model.special import build_special
from pylmp.model.topology import BOND, Kind, entries
from pylmp.text.words import Args

_EDGE = 1.0e-6  # of the box length


@command("replicate", needs_box=True)
def replicate(sim: Simulation, args: Args) -> None:
    """Make the system NX x NY x NZ times larger."""
    if not 3 <= len(args) <= 4:
        args.illegal(args.owner, hint="replicate NX NY NZ")
    grid = [args.integer() for _ in range(3)]
    if min(grid) <= 0:
        says = f"Illegal replication grid {'x'.join(map(str, grid))}. All replications must be > 0"
        args.fail(says, args.words[next(k for k in range(3) if grid[k] <= 0)])
    copies = grid[0] * grid[1] * grid[2]
    limits.room(copies * sim.natoms * limits.ATOM_BYTES, f"{copies * sim.natoms} atoms", None, args.manual)
    sim.console.both(f"Replication is creating a {'x'.join(map(str, grid))} = {copies} times larger system...\n")
    if sim.dimension == 2 and grid[2] != 1:
        args.fail("Cannot replicate 2d simulation in z dimension", args.words[2])
    word = args.peek()
    if word is not None and word.text not in ("bbox", "bond/periodic"):
        args.illegal(word, hint="bbox or bond/periodic")
    if any(count > 1 and not periodic for count, periodic in zip(grid, sim.box.periodic, strict=True)):
        sim.console.warning("Replicating in a non-periodic dimension")
    if sim.atoms.extra or (sim.bond is not None and sim.bond.memory):
        args.fail(
            "Cannot replicate with fixes that store per-atom quantities",
            args.owner,
            hint="replicate comes before such fixes",
        )
    _copy(sim, grid, word.text if word else "")
    inside = _inside(sim)
    sim.console.both(f"  {inside} atoms\n")
    if inside != sim.natoms:
        args.fail(
            "Replicate did not assign all atoms correctly", args.owner, hint="atoms were lost, or are outside the box"
        )
    for kind in sim.style.kinds:
        if kind.total(sim):
            kind.set_total(sim, copies * kind.total(sim))
            sim.console.both(f"  {kind.total(sim)} {kind.plural}\n")
    if sim.has_bonds:
        build_special(sim)
    sim.console.both("  replicate CPU = 0.000 seconds\n")


def _inside(sim: Simulation) -> int:
    """How many atoms LAMMPS finds in the new box; periodic faces are a little farther out."""
    x, (lo, hi) = sim.atoms.x[: sim.atoms.n].copy(), sim.box.frame
    sim.box.enter(x)
    margin = np.where(sim.box.periodic, (hi - lo) * _EDGE, 0.0)
    return int(((x >= lo - margin) & (x < hi + margin)).all(axis=1).sum())


def _copy(sim: Simulation, grid: list[int], mode: str) -> None:
    """The new box, and the atoms in it."""
    atoms, n = sim.atoms, sim.atoms.n
    sim.lists, sim.bond_lists = None, []
    copies = np.array(list(product(*map(range, grid))), np.int64)
    steps = {kind: _steps(sim, kind) if mode == "bond/periodic" else None for kind in sim.style.kinds}
    images = atoms.image[:n]
    if mode == "bond/periodic":
        images[:] = 0
    reach = images.min(axis=0, initial=0), images.max(axis=0, initial=0)
    sim.box.unmap(atoms.x[:n], images)
    h = sim.box.h.copy()
    _enlarge(sim, grid)
    if mode:
        low, high = (" ".join(str(k) for k in corner) for corner in reach)
        sim.console.both(
            f"  bounding box image = ({low}) to ({high})\n  bounding box extra memory = {_megabytes(sim):.2f} MB\n"
            f"  average # of replicas added to proc = {len(copies):.2f} out of {len(copies)} (100.00%)\n"
        )
    largest, molecules = (int(array[:n].max(initial=0)) for array in (atoms.tag, atoms.molecule))
    atoms.clear_ghosts()
    atoms.reserve(n * len(copies))
    atoms.keep(np.tile(np.arange(n), len(copies)))
    n = atoms.n
    sim.natoms *= len(copies)
    which = np.repeat(copies, n // len(copies), axis=0)
    x, (a, b, c) = atoms.x[:n], which.T
    x[:, 0] = x[:, 0] + a * h[0] + b * h[5] + c * h[4]
    x[:, 1] = x[:, 1] + b * h[1] + c * h[3]
    x[:, 2] = x[:, 2] + c * h[2]
    atoms.image[:n] = 0
    sim.box.remap(x, atoms.image[:n])
    offset = _number(which, grid)
    atoms.tag[:n] += offset * largest
    in_one = atoms.molecule[:n] > 0
    atoms.molecule[:n][in_one] += (offset * molecules)[in_one]
    for kind, found in steps.items():
        _renumber(sim, kind, found, copies, grid, largest)


def _megabytes(sim: Simulation) -> float:
    """Of the records in which LAMMPS keeps the old atoms: numbers of eight bytes."""
    numbers = sim.atoms.n * (11 + sim.style.charged + sim.has_bonds)
    for kind in sim.style.kinds:
        numbers += sim.atoms.n + int(kind.numbers(sim)[: sim.atoms.n].sum()) * (2 if kind is BOND else 1 + kind.size)
    return numbers * 8 / 1024 / 1024


def _enlarge(sim: Simulation, grid: list[int]) -> None:
    """The low faces stay."""
    box, (xy, xz, yz) = sim.box, sim.box.tilt.tolist()
    box.place(box.lo.copy(), box.lo + np.array(grid) * box.length, np.array([xy * grid[1], xz * grid[2], yz * grid[2]]))
    announce(sim)


def _number(which: Ints, grid: list[int]) -> Ints:
    """Copies (..., 3) are numbered with the x index fastest."""
    return np.asarray((which[..., 2] * grid[1] + which[..., 1]) * grid[0] + which[..., 0])


def _steps(sim: Simulation, kind: Kind) -> Ints:
    """(k, members, 3) for each stored bond, angle, ...: +1 or -1 where it crosses a face on its way from the atom that stores it."""
    atoms, box = sim.atoms, sim.box
    found = entries(sim, kind)
    x = atoms.x[found.rows][:, None]
    away = x - atoms.x[found.at(sim)]
    half = 0.5 * box.length
    steps: Ints = np.where(np.abs(away) > half, np.where(x > box.lo + half, 1, -1), 0)
    return steps


def _renumber(sim: Simulation, kind: Kind, steps: Ints | None, copies: Ints, grid: list[int], largest: int) -> None:
    """IDs of partners. steps: to which neighboring copy each goes; None: it stays in its own."""
    found = entries(sim, kind)
    each = len(found) // len(copies)
    if steps is None:
        steps = np.zeros((each, found.tags.shape[1], 3), np.int64)
    new = np.concatenate([_number((copy + steps) % np.array(grid), grid) for copy in copies]) * largest
    members = kind.members(sim)
    members[found.rows, found.slots] += new[:, 1] if kind is BOND else new
