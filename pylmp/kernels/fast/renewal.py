"""New lists for the same rows in the same arrays: kernel after kernel, without Python."""

from __future__ import annotations

from pylmp.kernels.kinds import Function
from pylmp.kernels.machine import invoke


def renew(calls: "i8*", results: "f8*", count: "i8") -> "f8":
    """Make count calls one after the other. calls: address and block of each; results: least and greatest number that it returns if all is well.

    Returns 0.0, or which call, counted from 1, was the last one because it returned something else.
    """
    for k in range(count):
        got = invoke(calls[2 * k], calls[2 * k + 1])
        if not (got >= results[2 * k] and got <= results[2 * k + 1]):
            return k + 1.0
    return 0.0


def look_out(periodic: tuple[bool, bool, bool]) -> Function:
    px, py, pz = periodic

    def beyond(least: "f8*", most: "f8*", lo: "f8*", hi: "f8*") -> "f8":
        """Directions in which somebody between least and most (3,) may be lost: outside, or about to be farther out than he is wrapped."""
        count = 0
        for d in range(3):
            wraps = px if d == 0 else py if d == 1 else pz
            reach = 0.5 * (hi[d] - lo[d]) if wraps else 0.0
            if not (least[d] >= lo[d] - reach and most[d] < hi[d] + reach):
                count += 1
        return float(count)

    return beyond


def gridding(periodic: tuple[bool, bool, bool], flat: bool) -> Function:
    """flat: all atoms lie in one plane of cells."""
    px, py, pz = periodic

    def grid(
        lo: "f8*", hi: "f8*", least: "f8*", most: "f8*", cutoff: "f8", margin: "f8", most_cells: "i8", room: "i8",
        corner: "f8*", inverse: "f8*", lengths: "f8*", counts: "i8*", limit2: "f8*",
    ) -> "f8":
        """Cells no smaller than the cutoff and not many more than atoms, over the box where it is periodic, else from least to most.

        Sets, (3,) each, the low corner, how many cells there are to a length, the lengths of the box, how many cells there are. limit2[0]: up to where
        atoms are listed; margin: what single precision loses, in lengths. Returns how many more cells there are than room.
        """
        widest = 0.0
        for d in range(3):
            wraps = px if d == 0 else py if d == 1 else pz
            low = lo[d] if wraps else least[d]
            high = hi[d] if wraps else most[d]
            length = max(high - low, 1.0e-6 * cutoff)
            widest = max(widest, length)
            counts[d] = 1
            if not (flat and d == 2):
                counts[d] = max(1, int(min(length / cutoff, 1.0e9)))
            corner[d] = low
            inverse[d] = 1.0 / length
            lengths[d] = hi[d] - lo[d]
        while float(counts[0]) * counts[1] * counts[2] > most_cells:
            d = 0
            for k in range(1, 3):
                if counts[k] > counts[d]:
                    d = k
            counts[d] = max(1, counts[d] // 2)
        for d in range(3):
            inverse[d] *= counts[d]
        limit2[0] = (cutoff + margin * widest) * (cutoff + margin * widest)
        return float(max(counts[0] * counts[1] * counts[2] - room, 0))

    return grid


def hold(x: "f8*", held: "f8*", n: "i8") -> "f8":
    """Remember where the atoms stand."""
    for k in range(3 * n):
        held[k] = x[k]
    return 0.0


def unmark(stamp: "i4*", count: "i8") -> "f8":
    """Nobody is marked."""
    for k in range(count):
        stamp[k] = -1
    return 0.0
