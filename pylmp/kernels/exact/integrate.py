"""Velocity Verlet of the fix nve, and the random force of fix langevin."""

from __future__ import annotations

from pylmp.kernels.kinds import Function
from pylmp.kernels.random import mars


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


def langevin(everyone: bool, zero: bool, record: bool) -> Function:
    """zero: take out the mean random force. record: keep each atom's drag and noise in push (n, 3)."""

    def drag_and_noise(
        v: "f8*", f: "f8*", type_: "i8*", mask: "i8*", drag: "f8*", noise: "f8*", heat: "f8*", table: "f8*", state: "f8*",
        push: "f8*", bit: "i8", count: "i8", n: "i8",
    ) -> "f8":
        """f += drag*v + noise*heat*(u - 1/2), u uniform, three numbers an atom; heat[0] = sqrt(target temperature).

        count: atoms in the group.
        """
        sx = 0.0
        sy = 0.0
        sz = 0.0
        for i in range(n):
            if everyone or mask[i] & bit != 0:
                g1 = drag[type_[i]]
                g2 = noise[type_[i]] * heat[0]
                rx = g2 * (mars(table, state) - 0.5)
                ry = g2 * (mars(table, state) - 0.5)
                rz = g2 * (mars(table, state) - 0.5)
                px = g1 * v[3 * i] + rx
                py = g1 * v[3 * i + 1] + ry
                pz = g1 * v[3 * i + 2] + rz
                f[3 * i] += px
                f[3 * i + 1] += py
                f[3 * i + 2] += pz
                if zero:
                    sx += rx
                    sy += ry
                    sz += rz
                if record:
                    push[3 * i] = px
                    push[3 * i + 1] = py
                    push[3 * i + 2] = pz
        if zero:
            sx /= count
            sy /= count
            sz /= count
            for i in range(n):
                if everyone or mask[i] & bit != 0:
                    f[3 * i] -= sx
                    f[3 * i + 1] -= sy
                    f[3 * i + 2] -= sz
                    if record:
                        push[3 * i] -= sx
                        push[3 * i + 1] -= sy
                        push[3 * i + 2] -= sz
        return 0.0

    return drag_and_noise
