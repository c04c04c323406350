"""Where points touch the surface of a region: what fix wall/region pushes along.

A face answers for all points at once: near (n,) bool, the distance (n,) and the vector (n, 3) from the surface to the point. What
they hold where near is False means nothing. Order of operations as measured on LAMMPS 22 Jul 2025.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pylmp.model.atoms import Floats

Mask = NDArray[np.bool_]
BIG = 1.0e20


@dataclass
class Contact:
    """One possible contact of each of n points."""

    near: Mask
    distance: Floats
    away: Floats


def along_axis(distance: Floats, near: Mask, axis: int, high: bool) -> Contact:
    """A flat face across an axis; high: points are below it."""
    away = np.zeros((len(distance), 3))
    away[:, axis] = -distance if high else distance
    return Contact(near, distance, away)


def radial(d: Floats, r: Floats, radius: float, near: Mask, distance: Floats) -> Contact:
    """A round face: d (n, 3) from its center or axis, r its length."""
    with np.errstate(divide="ignore", invalid="ignore"):
        away = d * (1.0 - radius / r)[:, None]
    return Contact(near, distance, away)


def to_point(x: Floats, nearest: Floats, outside: Mask, cutoff: float) -> Contact:
    """The point of a surface nearest to each x."""
    away = x - nearest
    distance = np.sqrt(away[:, 0] * away[:, 0] + away[:, 1] * away[:, 1] + away[:, 2] * away[:, 2])
    return Contact(outside & (distance < cutoff), distance, away)


def on_segment(x: Floats, a: Floats, b: Floats) -> Floats:
    """(n, 3) the point nearest to each x on the segment from a to b, (n, 3) or (1, 3)."""
    w, v = b - a, x - a
    with np.errstate(divide="ignore", invalid="ignore"):
        t = (v[:, 0] * w[:, 0] + v[:, 1] * w[:, 1] + v[:, 2] * w[:, 2]) / (
            w[:, 0] * w[:, 0] + w[:, 1] * w[:, 1] + w[:, 2] * w[:, 2]
        )
        between = a + t[:, None] * w
    return np.where((t <= 0.0)[:, None], a, np.where((t >= 1.0)[:, None], b, between))


def closest(x: Floats, candidates: list[Floats], *, first: bool = False) -> Floats:
    """(n, 3) the candidate nearest to each x. first: the first of equals; else the last, and one that is nan takes the place of those
    before it.
    """
    best, least = candidates[0], np.full(len(x), BIG)
    for candidate in candidates:
        d = x - candidate
        square = d[:, 0] * d[:, 0] + d[:, 1] * d[:, 1] + d[:, 2] * d[:, 2]
        nearer = square < least if first else ~(square > least)
        best = np.where(nearer[:, None], candidate, best)
        least = np.where(nearer, square, least)
    return best


def on_rectangle(x: Floats, low: Floats, high: Floats, face: int) -> Floats:
    """(n, 3) the point nearest to each x on face 0 to 5 of a block: its foot, or the nearest point of the edges."""
    axis, at = face // 2, float((high if face % 2 else low)[face // 2])
    u, v = (d for d in range(3) if d != axis)
    if face in (2, 5):  # LAMMPS goes around these the other way
        u, v = v, u
    foot = low + (x - low)  # LAMMPS goes through the corner's frame, which costs a bit
    foot[:, axis] = at
    corners = np.empty((4, 3))
    corners[:, axis] = at
    corners[:, u] = low[u], low[u], high[u], high[u]
    corners[:, v] = low[v], high[v], high[v], low[v]
    edges = [on_segment(x, corners[k : k + 1], corners[(k + 1) % 4][None, :]) for k in range(4)]
    over = (x[:, u] >= low[u]) & (x[:, u] <= high[u]) & (x[:, v] >= low[v]) & (x[:, v] <= high[v])
    return np.where(over[:, None], foot, closest(x, edges))


def within(x: Floats, axis: int, low: float, high: float) -> Mask:
    return np.asarray((x[:, axis] >= low) & (x[:, axis] <= high))
