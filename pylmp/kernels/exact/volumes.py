"""Volumes of atoms, as bond_style bpm/spring volume/factor yes has them: sums over their bonds."""

from __future__ import annotations

import math

from pylmp.kernels.kinds import Function
from pylmp.laws import sqrt


def swell(planar: bool, memory: int) -> Function:
    """Add each bond's length to the power of the dimension to both of its ends. What new bonds add, those without r0, goes to change,
    too. Returns their number."""

    def add(x: "f8*", bonds: "i8*", history: "f8*", volume: "f8*", change: "f8*", count: "i8") -> "f8":
        new = 0
        for b in range(count):
            if bonds[3 * b + 2] <= 0:
                continue
            i = bonds[3 * b]
            j = bonds[3 * b + 1]
            dx = x[3 * i] - x[3 * j]
            dy = x[3 * i + 1] - x[3 * j + 1]
            dz = x[3 * i + 2] - x[3 * j + 2]
            r2 = dx * dx + dy * dy + dz * dz
            size = r2 if planar else r2 * sqrt(r2)
            volume[i] += size
            volume[j] += size
            if not history[memory * b] >= 1.0e-10:
                change[i] += size
                change[j] += size
                new += 1
        return float(new)

    return add


def compare() -> Function:
    """Each bond's root of the volumes of its ends over those that they had at first."""

    def relate(
        bonds: "i8*", volume: "f8*", first: "f8*", own: "f8*", exponent: "f8", count: "i8",
    ) -> "f8":  # fmt: skip
        for b in range(count):
            if bonds[3 * b + 2] > 0:
                i = bonds[3 * b]
                j = bonds[3 * b + 1]
                own[b] = math.pow((volume[i] + volume[j]) / (first[i] + first[j]), exponent)
        return 0.0

    return relate
