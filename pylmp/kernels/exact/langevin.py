"""The drag and noise of fix langevin."""

from __future__ import annotations

from pylmp.kernels.kinds import Function
from pylmp.kernels.random import mars, mars_row
from pylmp.laws import log, sqrt

CHUNK = 512  # atoms whose numbers are drawn at once: they stay in the cache


def drag_and_noise(everyone: bool, one_type: bool, zero: bool, record: bool, biased: bool, each: bool) -> Function:
    """zero: take out the mean random force. record: keep each atom's drag and noise in push (n, 3). biased: v is not what moves the
    atoms but what is hot of it, and components that are 0 get no noise. each: heat has a number for each atom.
    """
    flat = everyone and one_type and not (zero or biased or each)

    def one_step(
        v: "f8*", f: "f8*", type_: "i8*", mask: "i8*", drag: "f8*", noise: "f8*", heat: "f8*", table: "f8*", state: "f8*",
        numbers: "f8*", history: "f8*", steps: "f8*", push: "f8*", bit: "i8", count: "i8", n: "i8",
    ) -> "f8":
        """f += drag*v + noise*heat*(u - 1/2), u uniform, three numbers an atom; heat: square root of the target temperature.

        count: atoms in the group. numbers, history: room for the numbers of CHUNK atoms (kernels/random.py).
        """
        sx = 0.0
        sy = 0.0
        sz = 0.0
        for start in range(0, n, CHUNK):
            stop = min(start + CHUNK, n)
            members = stop - start
            if not everyone:
                members = 0
                for i in range(start, stop):
                    if mask[i] & bit != 0:
                        members += 1
            mars_row(numbers, history, steps, table, state, 3 * members)
            if flat:
                g1 = drag[1]
                g2 = noise[1] * heat[0]
                at = 3 * start
                for k in range(3 * members):
                    p = g1 * v[at + k] + g2 * (numbers[k] - 0.5)
                    f[at + k] += p
                    if record:
                        push[at + k] = p
                continue
            q = 0
            for i in range(start, stop):
                if everyone or mask[i] & bit != 0:
                    g1 = drag[type_[i]]
                    g2 = noise[type_[i]] * heat[i if each else 0]
                    rx = g2 * (numbers[q] - 0.5)
                    ry = g2 * (numbers[q + 1] - 0.5)
                    rz = g2 * (numbers[q + 2] - 0.5)
                    q += 3
                    if biased:
                        if v[3 * i] == 0.0:
                            rx = 0.0
                        if v[3 * i + 1] == 0.0:
                            ry = 0.0
                        if v[3 * i + 2] == 0.0:
                            rz = 0.0
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

    return one_step


def gaussians() -> Function:
    def draw(out: "f8*", table: "f8*", state: "f8*", spare: "f8*", count: "i8") -> "f8":
        """count gaussian numbers of a RanMars by the polar method; spare: whether one is kept from the last time, and which."""
        for k in range(count):
            if spare[0] != 0.0:
                spare[0] = 0.0
                out[k] = spare[1]
            else:
                a = 0.0
                b = 0.0
                r2 = 2.0
                while r2 >= 1.0 or r2 == 0.0:
                    a = 2.0 * mars(table, state) - 1.0
                    b = 2.0 * mars(table, state) - 1.0
                    r2 = a * a + b * b
                factor = sqrt(-2.0 * log(r2) / r2)
                spare[0] = 1.0
                spare[1] = a * factor
                out[k] = b * factor
        return 0.0

    return draw


def ramp_up(step: "i8*", begin: "i8", end: "i8", start: "f8", stop: "f8", heat: "f8*") -> "f8":
    """heat[0]: square root of the target temperature at a step of a run from begin to end."""
    part = 0.0 if step[0] == begin else (step[0] - begin) / (end - begin)
    heat[0] = sqrt(start + part * (stop - start))
    return 0.0
