"""LAMMPS's two random number generators.

RanPark: Park and Miller's minimal standard, by Schrage's method. RanMars: Marsaglia, Zaman and Tsang's lagged Fibonacci
generator. The same seeds give the same numbers, to the last bit.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pylmp.laws import select

_MODULUS, _FACTOR, _QUOTIENT, _REMAINDER = 2147483647, 16807, 127773, 2836
_SCALE = 1.0 / _MODULUS
_32BITS = 0xFFFFFFFF
_AT_ONCE = 2**16  # rows
_C, _CD, _CM = 362436, 7654321, 16777213  # of RanMars, in units of 2^-24
LAG, LANES = 97, 32
STEPS = np.array([lane * _CD % _CM for lane in range(1, LANES + 1)]) / 2.0**24  # what 1, 2, ... draws take off c
Floats = NDArray[np.float64]


def mars(table: Any, state: Any) -> float:
    """The next uniform number of a RanMars: table (98,), state (5,) = c, cd, cm and the two lags. Also runs compiled."""
    k = int(state[3])
    m = int(state[4])
    u = table[k] - table[m]
    if u < 0.0:
        u += 1.0
    table[k] = u
    state[3] = 97.0 if k == 1 else k - 1.0
    state[4] = 97.0 if m == 1 else m - 1.0
    state[0] -= state[1]
    if state[0] < 0.0:
        state[0] += state[2]
    u -= state[0]
    if u < 0.0:
        u += 1.0
    return u


def mars_row(numbers: Any, history: Any, steps: Any, table: Any, state: Any, count: int) -> None:
    """The next count uniform numbers of a RanMars, as mars would give them one by one, but many at once. Also runs compiled.

    A number of the table depends on those 33 and 97 draws before it, so that 32 draws know nothing of each other. history, and
    numbers: room for LAG and LANES more than count; steps: STEPS.
    """
    k = int(state[3])
    for q in range(k):
        history[q] = table[k - q]
    for q in range(k, LAG):
        history[q] = table[LAG + k - q]
    cm = state[2]
    c = last = state[0]
    for start in range(0, count, LANES):
        for lane in range(LANES):
            q = start + lane
            u = history[q] - history[q + 64]
            u = select(u < 0.0, u + 1.0, u)
            history[q + LAG] = u
            w = c - steps[lane]
            u -= select(w < 0.0, w + cm, w)
            numbers[q] = select(u < 0.0, u + 1.0, u)
        last = c
        c -= steps[LANES - 1]
        c = select(c < 0.0, c + cm, c)
    if count > 0:
        last -= steps[(count - 1) % LANES]
        state[0] = select(last < 0.0, last + cm, last)
    for q in range(LAG):
        table[LAG - q] = history[count + q]
    state[3] = 97.0
    state[4] = 33.0


def room(count: int) -> tuple[Floats, Floats]:
    """numbers and history for mars_row."""
    return np.zeros(count + LANES), np.zeros(count + LAG + LANES)


class _Gaussian:
    """Gaussian numbers from uniform ones by the polar method; every second one was kept from the first."""

    _spare: float | None = None

    def uniform(self) -> float:
        raise NotImplementedError

    def gaussian(self) -> float:
        if self._spare is not None:
            spare, self._spare = self._spare, None
            return spare
        while True:
            a, b = 2.0 * self.uniform() - 1.0, 2.0 * self.uniform() - 1.0
            r2 = a * a + b * b
            if 0.0 < r2 < 1.0:
                break
        factor = math.sqrt(-2.0 * math.log(r2) / r2)
        self._spare = a * factor
        return b * factor


class RanMars(_Gaussian):
    """table and state are plain arrays, so that a kernel may draw from them. Seeds 1 to 900000000, else ValueError."""

    def __init__(self, seed: int) -> None:
        if not 0 < seed <= 900000000:
            raise ValueError("Invalid seed for Marsaglia random # generator")
        ij, kl = divmod(seed - 1, 30082)
        i, j = (ij // 177) % 177 + 2, ij % 177 + 2
        k, m = (kl // 169) % 178 + 1, kl % 169
        self.table = np.zeros(98)
        for entry in range(1, 98):
            total, bit = 0.0, 0.5
            for _ in range(24):
                i, j, k = j, k, ((i * j) % 179) * k % 179
                m = (53 * m + 1) % 169
                if (m * k) % 64 >= 32:
                    total += bit
                bit *= 0.5
            self.table[entry] = total
        self.state = np.array([_C / 2**24, _CD / 2**24, _CM / 2**24, 97.0, 33.0])
        self.uniform()

    def uniform(self) -> float:
        return float(mars(self.table, self.state))


class RanPark(_Gaussian):
    """uniform numbers in (0, 1) and gaussian ones."""

    def __init__(self, seed: int) -> None:
        self.seed = seed

    def uniform(self) -> float:
        k = self.seed // _QUOTIENT
        self.seed = _FACTOR * (self.seed - k * _QUOTIENT) - _REMAINDER * k
        if self.seed < 0:
            self.seed += _MODULUS
        return _SCALE * self.seed

    def skip(self, count: int) -> None:
        for _ in range(count):
            self.uniform()

    def reset(self, seed: int, x: NDArray[np.float64]) -> None:
        """Start anew from a seed and a position (3,): Jenkins's one-at-a-time hash of their bytes, as signed characters."""
        h = 0
        for byte in np.int32(seed).tobytes() + np.asarray(x, float).tobytes():
            h = (h + (byte - 256 if byte > 127 else byte)) & _32BITS
            h = (h + (h << 10)) & _32BITS
            h ^= h >> 6
        h = (h + (h << 3)) & _32BITS
        h ^= h >> 11
        h = (h + (h << 15)) & _32BITS
        self.seed = h & 0x7FFFFFF or 1
        self.skip(5)
        self._spare = None


def park_at(seed: int, x: NDArray[np.float64], draws: int) -> NDArray[np.float64]:
    """(n, draws) uniform numbers, row k what a RanPark reset at position x[k] draws; many atoms at once, not so many that it takes much memory."""
    result = np.empty((len(x), draws))
    for begin in range(0, len(x), _AT_ONCE):
        result[begin : begin + _AT_ONCE] = _park_at(seed, x[begin : begin + _AT_ONCE], draws)
    return result


def _park_at(seed: int, x: NDArray[np.float64], draws: int) -> NDArray[np.float64]:
    words = np.empty((len(x), 28), np.uint8)
    words[:, :4] = np.frombuffer(np.int32(seed).tobytes(), np.uint8)
    words[:, 4:] = np.ascontiguousarray(x, float).view(np.uint8).reshape(len(x), 24)
    signed = words.view(np.int8).astype(np.int64)
    h = np.zeros(len(x), np.int64)
    for column in range(28):
        h = (h + signed[:, column]) & _32BITS
        h = (h + (h << 10)) & _32BITS
        h ^= h >> 6
    h = (h + (h << 3)) & _32BITS
    h ^= h >> 11
    h = (h + (h << 15)) & _32BITS
    state = h & 0x7FFFFFF
    state[state == 0] = 1
    result = np.empty((len(x), draws))
    for draw in range(-5, draws):
        k = state // _QUOTIENT
        state = _FACTOR * (state - k * _QUOTIENT) - _REMAINDER * k
        state[state < 0] += _MODULUS
        if draw >= 0:
            result[:, draw] = _SCALE * state
    return result
