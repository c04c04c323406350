"""Kernels and laws the tests of the store compile."""

from __future__ import annotations

import math

import numpy as np

from pylmp.laws import bits, cos, exp, fabs, log, power, select, sin, single, sqrt, whole

STIFFNESS = 3.0


def spring(r2, k):
    r = sqrt(r2)
    return select(r < 1.5, -k * (r - 1.0) / r + STIFFNESS * r2, 0.0)


def soft(r2, k):
    return fabs(k - r2)


def chain(*laws, doubled=False):
    """A kernel over a line of beads."""
    first, second = laws[0], laws[-1]

    def forces(x: "f8*", f: "f8*", type_: "i4*", n: "i8", k: "f8") -> "f8":
        """f gets the forces; returns a sum."""
        total = 0.0
        for i in range(n - 1):
            d = x[i + 1] - x[i]
            g = first(d * d, k)
            if doubled:
                g = g + second(d * d, k)
            if type_[i] != 0:
                f[i] -= d * g
                f[i + 1] += d * g
            total += g
        return total

    return forces


def multiply_add():
    """Written so that a compiler allowed to contract or to reorder would."""

    def kernel(a: "f8*", b: "f8*", c: "f8*", out: "f8*", n: "i8") -> "f8":
        total = 0.0
        for i in range(n):
            out[i] = a[i] * b[i] + c[i]
            total += a[i] * b[i]
        return total

    return kernel


def word(name):
    """One word of the alphabet, element by element."""

    def divide(x: "f8*", out: "f8*", n: "i8") -> "f8":
        for i in range(n):
            out[i] = 1.0 / x[i]
        return 0.0

    def root(x: "f8*", out: "f8*", n: "i8") -> "f8":
        for i in range(n):
            out[i] = sqrt(x[i])
        return 0.0

    def magnitude(x: "f8*", out: "f8*", n: "i8") -> "f8":
        for i in range(n):
            out[i] = fabs(x[i])
        return 0.0

    def floor(x: "f8*", out: "f8*", n: "i8") -> "f8":
        for i in range(n):
            out[i] = math.floor(x[i]) + int(x[i])
        return 0.0

    def bounds(x: "f8*", out: "f8*", n: "i8") -> "f8":
        for i in range(n):
            out[i] = max(x[i], 0.25) - min(x[i], 0.5) + abs(x[i])
        return 0.0

    def grow(x: "f8*", out: "f8*", n: "i8") -> "f8":
        for i in range(n):
            out[i] = exp(x[i]) + log(x[i])
        return 0.0

    def turn(x: "f8*", out: "f8*", n: "i8") -> "f8":
        for i in range(n):
            out[i] = sin(x[i]) + 3.0 * cos(x[i])
        return 0.0

    def raised(x: "f8*", out: "f8*", n: "i8") -> "f8":
        for i in range(n):
            out[i] = power(x[i], 1.0 / 3.0) + power(x[i], 3.0) + power(x[i], -1.5)
        return 0.0

    def index(x: "f8*", out: "f8*", n: "i8") -> "f8":
        for i in range(n):
            out[i] = float(whole(x[i] * 1.0e3))
        return 0.0

    def narrow(x: "f8*", out: "f8*", n: "i8") -> "f8":
        for i in range(n):
            out[i] = single(x[i])
        return 0.0

    def pattern(x: "f8*", out: "f8*", n: "i8") -> "f8":
        for i in range(n):
            out[i] = float(bits(x[i]))
        return 0.0

    return {f.__name__: f for f in (divide, root, magnitude, floor, bounds, grow, turn, raised, index, narrow, pattern)}[name]


def transcendental():
    def powers(x: "f8*", y: "f8*", n: "i8", a: "f8") -> "f8":
        for i in range(n):
            y[i] = math.exp(-x[i]) + math.cos(x[i])
        return math.exp(a) + math.pow(a, 1.7)

    return powers


def both_of_an_angle():
    """What the compiler turns into sincos."""

    def turned(x: "f8*", y: "f8*", n: "i8", a: "f8") -> "f8":
        for i in range(n):
            y[i] = sin(x[i]) + cos(x[i])
        return a

    return turned


def fill_and_copy():
    """What the compiler turns into memset and memcpy."""

    def filled(x: "f8*", y: "f8*", n: "i8", a: "f8") -> "f8":
        for i in range(n):
            y[i] = x[i]
        for i in range(n):
            x[i] = 0.0
        return a

    return filled


def allocating():
    def hungry(n: "i8") -> "f8":
        return np.zeros(n)[0]

    return hungry


def raising():
    def loud(x: "f8*", n: "i8") -> "f8":
        if n < 0:
            raise ValueError
        return x[0]

    return loud


def line(n=50):
    """Arguments for chain."""
    x = np.cumsum(0.8 + 0.4 * np.random.default_rng(7).random(n))
    return x, np.zeros(n), np.arange(n, dtype=np.int32) % 3, n, 30.0
