"""Atoms and the faces of the box, in coordinates in which it is a brick. Most atoms are inside: stretches of them are looked at
in vector instructions, and only where somebody is not, one by one.
"""

from __future__ import annotations

from typing import Any

from pylmp.kernels.exact.ghosts import cross
from pylmp.kernels.kinds import Function

_STRETCH = 256
_NEVER = float("nan")  # nothing is below or above it


def wrap() -> Function:
    def wrap_atoms(
        x: "f8*", v: "f8*", image: "i4*", mask: "i8*", lo: "f8*", hi: "f8*", periodic: "i8*", rate: "f8*", group: "i8", n: "i8"
    ) -> "f8":
        """Periodic coordinates move by at most one box length a side; image flags, ten bits each, count it.

        periodic: (3,). rate, group: who crosses a face of a box that flows takes on the velocity of the other side.
        """
        for start in range(0, n, _STRETCH):
            stop = min(start + _STRETCH, n)
            if beyond(x, lo, hi, periodic, start, stop) == 0:
                continue
            for d in range(3):
                if periodic[d] == 0:
                    continue
                length = hi[d] - lo[d]
                for i in range(start, stop):
                    c = x[3 * i + d]
                    if c < lo[d]:
                        c += length
                        image[3 * i + d] = ten_bits(image[3 * i + d] - 1)
                        if mask[i] & group != 0:
                            cross(v, 3 * i, d, 1.0, rate)
                    if c >= hi[d]:
                        c -= length
                        if c < lo[d]:
                            c = lo[d]
                        image[3 * i + d] = ten_bits(image[3 * i + d] + 1)
                        if mask[i] & group != 0:
                            cross(v, 3 * i, d, -1.0, rate)
                    x[3 * i + d] = c
        return 0.0

    return wrap_atoms


def outside() -> Function:
    def count_outside(x: "f8*", lo: "f8*", hi: "f8*", which: "i8*", n: "i8") -> "f8":
        """How many atoms are beyond faces of the chosen directions, which (3,)."""
        return float(beyond(x, lo, hi, which, 0, n))

    return count_outside


def beyond(x: "f8*", lo: "f8*", hi: "f8*", which: "i8*", start: int, stop: int) -> int:
    """Atoms of rows start to stop beyond faces of the chosen directions."""
    ax = lo[0] if which[0] != 0 else _NEVER
    bx = hi[0] if which[0] != 0 else _NEVER
    ay = lo[1] if which[1] != 0 else _NEVER
    by = hi[1] if which[1] != 0 else _NEVER
    az = lo[2] if which[2] != 0 else _NEVER
    bz = hi[2] if which[2] != 0 else _NEVER
    count = 0
    for i in range(start, stop):
        px = x[3 * i]
        py = x[3 * i + 1]
        pz = x[3 * i + 2]
        out = (px < ax) | (px >= bx) | (py < ay) | (py >= by) | (pz < az) | (pz >= bz)
        count += 1 if out else 0
    return count


def ten_bits(image: Any) -> Any:
    """As LAMMPS keeps image flags, -512 to 511."""
    return ((image + 512) & 1023) - 512


def walk(x: float, lo: float, hi: float, length: float) -> tuple[float, int]:
    """x wrapped by one length after the other, and what its image flag gains."""
    turns = 0
    while x < lo:
        x, turns = x + length, turns - 1
    while x >= hi:
        x, turns = x - length, turns + 1
    return x, turns
