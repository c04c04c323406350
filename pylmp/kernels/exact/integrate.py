"""Velocity Verlet of the fix nve."""

from __future__ import annotations

from pylmp.kernels.kinds import Function


def kick_and_drift(everyone: bool) -> Function:
    def first_half(
        x: "f8*", v: "f8*", f: "f8*", type_: "i8*", mask: "i8*", mass: "f8*", half: "f8", dt: "f8", bit: "i8", n: "i8"
    ) -> "f8":
        """v += (half/m) f; x += dt v, with half = dt/2 in force units."""
        for i in range(n):
            if everyone or mask[i] & bit != 0:
                kick = half / mass[type_[i]]
                for d in range(3):
                    v[3 * i + d] += kick * f[3 * i + d]
                    x[3 * i + d] += dt * v[3 * i + d]
        return 0.0

    return first_half


def kick(everyone: bool) -> Function:
    def second_half(
        v: "f8*", f: "f8*", type_: "i8*", mask: "i8*", mass: "f8*", half: "f8", bit: "i8", n: "i8"
    ) -> "f8":
        for i in range(n):
            if everyone or mask[i] & bit != 0:
                kick = half / mass[type_[i]]
                for d in range(3):
                    v[3 * i + d] += kick * f[3 * i + d]
        return 0.0

    return second_half
