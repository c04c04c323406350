"""What simple fixes do to forces and velocities. everyone: the group is all; one_type: of atom types there is one."""

from __future__ import annotations

from pylmp.kernels.kinds import Function


def viscous(everyone: bool, one_type: bool) -> Function:
    flat = everyone and one_type

    def brake(v: "f8*", f: "f8*", type_: "i8*", mask: "i8*", gamma: "f8*", bit: "i8", n: "i8") -> "f8":
        """f -= gamma v; gamma by type."""
        if flat:
            drag = gamma[1]
            for k in range(3 * n):
                f[k] -= drag * v[k]
        else:
            for i in range(n):
                if everyone or mask[i] & bit != 0:
                    drag = gamma[type_[i]]
                    f[3 * i] -= drag * v[3 * i]
                    f[3 * i + 1] -= drag * v[3 * i + 1]
                    f[3 * i + 2] -= drag * v[3 * i + 2]
        return 0.0

    return brake


def flatten(everyone: bool) -> Function:
    def stay_in_plane(v: "f8*", f: "f8*", mask: "i8*", bit: "i8", n: "i8") -> "f8":
        """z components of velocities and forces are 0."""
        for i in range(n):
            if everyone or mask[i] & bit != 0:
                v[3 * i + 2] = 0.0
                f[3 * i + 2] = 0.0
        return 0.0

    return stay_in_plane


def add(everyone: bool) -> Function:
    def add_forces(f: "f8*", mask: "i8*", x: "f8", y: "f8", z: "f8", bit: "i8", n: "i8") -> "f8":
        """f += (x, y, z)."""
        for i in range(n):
            if everyone or mask[i] & bit != 0:
                f[3 * i] += x
                f[3 * i + 1] += y
                f[3 * i + 2] += z
        return 0.0

    return add_forces


def replace(everyone: bool, absent: tuple[bool, bool, bool]) -> Function:
    """absent: components that stay as they are."""
    no_x, no_y, no_z = absent

    def set_forces(f: "f8*", mask: "i8*", value: "f8*", before: "f8*", bit: "i8", n: "i8") -> "f8":
        """f = value (3,); before (3,): the sum of what it was, from the first atom to the last."""
        sx = 0.0
        sy = 0.0
        sz = 0.0
        for i in range(n):
            if everyone or mask[i] & bit != 0:
                sx += f[3 * i]
                sy += f[3 * i + 1]
                sz += f[3 * i + 2]
                if not no_x:
                    f[3 * i] = value[0]
                if not no_y:
                    f[3 * i + 1] = value[1]
                if not no_z:
                    f[3 * i + 2] = value[2]
        before[0] = sx
        before[1] = sy
        before[2] = sz
        return 0.0

    return set_forces
