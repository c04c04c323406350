"""Where create_atoms puts atoms: lattice sites in the box, and random points. Order of operations as measured on LAMMPS 22 Jul 2025."""

from __future__ import annotations

import math
from collections.abc import Callable
from itertools import product
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pylmp.kernels.random import RanPark
from pylmp.model.atoms import Floats, Ints
from pylmp.model.box import Box
from pylmp.model.lattice import Lattice
from pylmp.model.limits import ATOM_BYTES, room
from pylmp.model.region import Region

if TYPE_CHECKING:
    from pylmp.model.simulation import Simulation

_EDGE = 1.0e-6  # of the box length: sites this near a periodic face count as on it
_MANY = 1_000_000  # cells
_SAMPLES = 24  # in each direction
_SKIPPED = 30  # numbers LAMMPS draws and forgets
Wanted = Callable[[Floats], bool] | None  # what a variable says of one point (3,)


def within(box: Box, x: Floats, edge: float = 0.0) -> NDArray[np.bool_]:
    """(n,) bool: positions in the box; edge, of a length: a periodic box begins that far below its low face and ends twice that far
    below its high face, so that one of two images on its faces is in."""
    x, (lo, hi) = x.copy(), box.frame
    box.enter(x)
    margin = np.where(box.periodic, (hi - lo) * edge, 0.0)
    return np.asarray(((x >= lo - margin) & (x < hi - 2.0 * margin)).all(axis=1))


def lattice_sites(sim: Simulation, lattice: Lattice, region: Region | None, wanted: Wanted) -> tuple[Floats, Ints]:
    """(n, 3) sites in the box and the region, and the basis atom (n,) of each: z slowest, then y, x, basis."""
    box = sim.box
    if region is not None:
        region.update()
    low, high = (corner.tolist() for corner in box.brick(*box.frame))
    ranges = _cells(sim, lattice, *_narrowed((low, high), region))
    _foresee(lattice, region, ranges)
    j, i, place = (
        grid.ravel() for grid in np.meshgrid(ranges[1], ranges[0], np.arange(len(lattice.basis)), indexing="ij")
    )
    bx, by, bz = np.array(lattice.basis)[place].T
    sites, places = [np.zeros((0, 3))], [np.zeros(0, np.int64)]
    for k in ranges[2]:
        x = np.stack(lattice.to_box((i + bx, j + by, k + bz)), axis=1)
        keep = region.match(x) if region is not None else np.ones(len(x), bool)
        if wanted is not None:
            keep[keep] = [wanted(point) for point in x[keep]]
        keep &= within(box, x, _EDGE)
        sites.append(x[keep])
        places.append(place[keep])
    return np.concatenate(sites), np.concatenate(places)


def _foresee(lattice: Lattice, region: Region | None, ranges: list[range]) -> None:
    """Raises ScriptError if so many sites find no room: counted by cells, of which some thousand tell how many the region holds."""
    cells = math.prod(map(len, ranges))
    if cells < _MANY:
        return
    share = 1.0
    if region is not None:
        some = np.meshgrid(*(r.start + (np.arange(_SAMPLES) + 0.5) * (len(r) / _SAMPLES) for r in ranges), indexing="ij")
        a, b, c = (axis.ravel() for axis in some)
        axes: Any = lattice.to_box((a, b, c))
        share = float(region.match(np.stack(axes, axis=1)).mean())
    count = cells * share * len(lattice.basis)
    room(count * ATOM_BYTES, f"about {count:.3g} atoms", None, "create_atoms.html")


def _narrowed(brick: tuple[list[float], list[float]], region: Region | None) -> tuple[list[float], list[float]]:
    """A brick, as far as it lies within a region's extent."""
    low, high = brick
    if region is None or region.bounds is None:
        return low, high
    least, most = region.bounds
    return [max(a, b) for a, b in zip(low, least, strict=True)], [min(a, b) for a, b in zip(high, most, strict=True)]


def _cells(sim: Simulation, lattice: Lattice, low: list[float], high: list[float]) -> list[range]:
    """Cells whose sites may lie between low and high."""
    corners = [lattice.from_box((a, b, c)) for a, b, c in product(*zip(low, high, strict=True))]
    ranges = []
    for d in range(3):
        least, most = min(c[d] for c in corners), max(c[d] for c in corners)
        first = int(least) - 1
        if least < 0.0:
            first -= 1
        ranges.append(range(first, int(most) + 2))
    if sim.dimension == 2:
        ranges[2] = range(1)
    return ranges


class RandomPoints:
    """Uniformly random positions, tried again while outside the region, unwanted, or nearer than overlap to an atom.

    low, high   corners between which points are drawn; apart: is there anything between them
    """

    def __init__(self, sim: Simulation, region: Region | None) -> None:
        self.sim, self.region = sim, region
        low, high = sim.box.bounds
        self.low, self.high = _narrowed((low.tolist(), high.tolist()), region)
        self.apart = all(a <= b for a, b in zip(self.low, self.high, strict=True))

    def draw(self, seed: int, count: int, tries: int, overlap: float, wanted: Wanted) -> Floats:
        """(n, 3) at most count of them, each found in at most so many tries."""
        sim, box, region = self.sim, self.sim.box, self.region
        if region is not None:
            region.update()
        random = RanPark(seed)
        random.skip(_SKIPPED)
        there = np.zeros((sim.atoms.n + count, 3))
        there[: sim.atoms.n] = sim.atoms.x[: sim.atoms.n]
        n = sim.atoms.n
        for _ in range(count):
            for _ in range(tries):
                point = np.array([a + random.uniform() * (b - a) for a, b in zip(self.low, self.high, strict=True)])
                if sim.dimension == 2:
                    point[2] = 0.0
                if region is not None and not region.match(point[None])[0]:
                    continue
                if wanted is not None and not wanted(point):
                    continue
                if box.triclinic and not within(box, point[None])[0]:
                    continue
                if overlap > 0.0 and self._crowded(point, there[:n], overlap):
                    continue
                there[n] = point
                n += 1
                break
        return there[sim.atoms.n : n]

    def _crowded(self, point: Floats, there: Floats, overlap: float) -> bool:
        away = self.sim.box.minimum_image(point - there)
        return bool(
            (away[:, 0] * away[:, 0] + away[:, 1] * away[:, 1] + away[:, 2] * away[:, 2] < overlap * overlap).any()
        )
