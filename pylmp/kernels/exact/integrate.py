"""Velocity Verlet of the fixes nve and nve/limit.

Where all atoms move and have one mass, every number has the same kick: one flat loop over 3n numbers, which the compiler turns
into vector instructions. Otherwise a loop over atoms. kicks: (types + 1,) room for half/m of each type.
"""

from __future__ import annotations

from pylmp.kernels.kinds import Function
from pylmp.laws import sqrt


def kick_and_drift(everyone: bool, one_type: bool) -> Function:
    flat = everyone and one_type

    def first_half(
        x: "f8*", v: "f8*", f: "f8*", type_: "i8*", mask: "i8*", mass: "f8*", kicks: "f8*", half: "f8", dt: "f8", types: "i8",
        bit: "i8", n: "i8",
    ) -> "f8":
        """v += (half/m) f; x += dt v, with half = dt/2 in force units."""
        for t in range(1, types + 1):
            kicks[t] = half / mass[t]
        if flat:
            kick = kicks[1]
            for k in range(3 * n):
                v[k] += kick * f[k]
                x[k] += dt * v[k]
        else:
            for i in range(n):
                if everyone or mask[i] & bit != 0:
                    kick = kicks[type_[i]]
                    at = 3 * i
                    vx = v[at] + kick * f[at]
                    vy = v[at + 1] + kick * f[at + 1]
                    vz = v[at + 2] + kick * f[at + 2]
                    v[at] = vx
                    v[at + 1] = vy
                    v[at + 2] = vz
                    x[at] += dt * vx
                    x[at + 1] += dt * vy
                    x[at + 2] += dt * vz
        return 0.0

    return first_half


def kick(everyone: bool, one_type: bool) -> Function:
    flat = everyone and one_type

    def second_half(
        v: "f8*", f: "f8*", type_: "i8*", mask: "i8*", mass: "f8*", kicks: "f8*", half: "f8", types: "i8", bit: "i8", n: "i8"
    ) -> "f8":
        """v += (half/m) f."""
        for t in range(1, types + 1):
            kicks[t] = half / mass[t]
        if flat:
            kick = kicks[1]
            for k in range(3 * n):
                v[k] += kick * f[k]
        else:
            for i in range(n):
                if everyone or mask[i] & bit != 0:
                    kick = kicks[type_[i]]
                    at = 3 * i
                    v[at] += kick * f[at]
                    v[at + 1] += kick * f[at + 1]
                    v[at + 2] += kick * f[at + 2]
        return 0.0

    return second_half


def limited_kick(everyone: bool, drift: bool) -> Function:
    """drift: positions follow."""

    def limited_half(
        x: "f8*", v: "f8*", f: "f8*", type_: "i8*", mask: "i8*", mass: "f8*", kicks: "f8*", half: "f8", dt: "f8", limit: "f8",
        types: "i8", bit: "i8", count: "i8*", n: "i8",
    ) -> "f8":
        """v += (half/m) f, shortened where v*v is above limit. count[0] grows by how many were."""
        for t in range(1, types + 1):
            kicks[t] = half / mass[t]
        fast = 0
        for i in range(n):
            if everyone or mask[i] & bit != 0:
                kick = kicks[type_[i]]
                at = 3 * i
                vx = v[at] + kick * f[at]
                vy = v[at + 1] + kick * f[at + 1]
                vz = v[at + 2] + kick * f[at + 2]
                square = vx * vx + vy * vy + vz * vz
                if square > limit:
                    fast += 1
                    part = sqrt(limit / square)
                    vx *= part
                    vy *= part
                    vz *= part
                v[at] = vx
                v[at + 1] = vy
                v[at + 2] = vz
                if drift:
                    x[at] += dt * vx
                    x[at + 1] += dt * vy
                    x[at + 2] += dt * vz
        count[0] += fast
        return 0.0

    return limited_half
