"""The fixes' kernels against their formulas, atom by atom: the same bits for any number of atoms, group and types."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import product

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from pylmp.kernels.exact import integrate, langevin, pushes, wrapping
from pylmp.kernels.exact.neighbor import moved
from pylmp.kernels.random import LAG, STEPS, RanMars, mars_row, room
from pylmp.kernels.store import kernel
from pylmp.model.sums import totals

BIT = 4
TYPES = 3


@dataclass
class Some:
    """n atoms, some of them in the group of BIT."""

    n: int
    seed: int
    one_type: bool

    def __post_init__(self) -> None:
        random = np.random.default_rng(self.seed)
        self.x, self.v, self.f = random.standard_normal((3, max(self.n, 1), 3))
        for array in (self.x, self.v, self.f):  # zeros of both signs
            array[random.random(array.shape) < 0.2] = 0.0
            array[random.random(array.shape) < 0.2] = -0.0
        self.type = np.ones(self.n, np.int64) if self.one_type else random.integers(1, TYPES + 1, self.n)
        self.mask = 1 + BIT * random.integers(0, 2, self.n)
        self.mass = np.array([0.0, 0.3, 7.0, 1.1])
        self.types = 1 if self.one_type else TYPES

    def rows(self, everyone: bool) -> list[int]:
        return [i for i in range(self.n) if everyone or self.mask[i] & BIT]


SOME = st.builds(Some, st.integers(0, 70), st.integers(0, 10**6), st.booleans())


@settings(max_examples=60, deadline=None)
@given(SOME, st.booleans())
def test_nve(some: Some, everyone: bool) -> None:
    half, dt, scene = 0.37, 0.011, (everyone, some.one_type)
    x, v, f = some.x.copy(), some.v.copy(), some.f
    for i in some.rows(everyone):
        kick = half / some.mass[some.type[i]]
        for d in range(3):
            v[i, d] += kick * f[i, d]
            x[i, d] += dt * v[i, d]
            v[i, d] += kick * f[i, d]
    kinds = some.type, some.mask, some.mass, np.zeros(TYPES + 1), half
    kernel(integrate.kick_and_drift(*scene)).bind(some.x, some.v, f, *kinds, dt, some.types, BIT, some.n)()
    kernel(integrate.kick(*scene)).bind(some.v, f, *kinds, some.types, BIT, some.n)()
    assert some.x.tobytes() == x.tobytes()
    assert some.v.tobytes() == v.tobytes()


@settings(max_examples=60, deadline=None)
@given(SOME, st.booleans(), st.booleans())
def test_nve_limit(some: Some, everyone: bool, drift: bool) -> None:
    half, dt, limit, count = 0.37, 0.011, 1.7, 0
    x, v, f = some.x.copy(), some.v.copy(), some.f
    for i in some.rows(everyone):
        v[i] += half / some.mass[some.type[i]] * f[i]
        square = v[i, 0] * v[i, 0] + v[i, 1] * v[i, 1] + v[i, 2] * v[i, 2]
        if square > limit:
            count += 1
            v[i] *= np.sqrt(limit / square)
        if drift:
            x[i] += dt * v[i]
    given_ = (
        some.x,
        some.v,
        f,
        some.type,
        some.mask,
        some.mass,
        np.zeros(TYPES + 1),
        half,
        dt,
        limit,
        TYPES,
        BIT,
        counter := np.array([7]),
        some.n,
    )
    kernel(integrate.limited_kick(everyone, drift)).bind(*given_)()
    assert counter[0] == 7 + count
    assert some.x.tobytes() == x.tobytes()
    assert some.v.tobytes() == v.tobytes()


@settings(max_examples=60, deadline=None)
@given(SOME, st.booleans())
def test_viscous(some: Some, everyone: bool) -> None:
    gamma = np.array([0.0, 0.7, 1.9, 3.1])
    f = some.f.copy()
    for i in some.rows(everyone):
        f[i] -= gamma[some.type[i]] * some.v[i]
    kernel(pushes.viscous(everyone, some.one_type)).bind(some.v, some.f, some.type, some.mask, gamma, BIT, some.n)()
    assert some.f.tobytes() == f.tobytes()


@settings(max_examples=60, deadline=None)
@given(SOME, st.booleans())
def test_enforce2d(some: Some, everyone: bool) -> None:
    v, f, rows = some.v.copy(), some.f.copy(), some.rows(everyone)
    v[rows, 2] = f[rows, 2] = 0.0
    kernel(pushes.flatten(everyone)).bind(some.v, some.f, some.mask, BIT, some.n)()
    assert some.v.tobytes() == v.tobytes()
    assert some.f.tobytes() == f.tobytes()


@pytest.mark.parametrize(
    "absent", [(False, False, False), (True, False, False), (False, True, True), (True, True, True)]
)
@settings(max_examples=30, deadline=None)
@given(SOME, st.booleans())
def test_setforce(absent: tuple[bool, bool, bool], some: Some, everyone: bool) -> None:
    value, before, rows = np.array([0.3, -0.0, 4.0]), np.zeros(3), some.rows(everyone)
    f, total = some.f.copy(), totals(some.f[rows])
    for d in range(3):
        if not absent[d]:
            f[rows, d] = value[d]
    kernel(pushes.replace(everyone, absent)).bind(some.f, some.mask, value, before, BIT, some.n)()
    assert some.f.tobytes() == f.tobytes()
    assert before.tobytes() == total.tobytes()


@pytest.mark.parametrize(
    ("n", "off"), [(0, ()), (1, ()), (1, (0,)), (70, (69,)), (1500, ()), (1500, (1499,)), (1500, (700, 701))]
)
def test_somebody_moved(n: int, off: tuple[int, ...]) -> None:
    x = np.random.default_rng(n).standard_normal((n, 3))
    held, limit2 = x.copy(), np.array([0.25])
    x += 0.28  # 3 * 0.28^2 = 0.2352
    x[list(off), 1] += 0.03
    assert kernel(moved()).bind(x, held, limit2, n)() == float(bool(off))


@pytest.mark.parametrize("compiled", [False, True])
@settings(max_examples=40, deadline=None)
@given(st.integers(1, 900_000_000), st.lists(st.integers(0, 210), max_size=8))
def test_many_random_numbers_at_once_are_those_one_by_one(compiled: bool, seed: int, counts: list[int]) -> None:
    """Rows of draws with single draws between them, as other users of the generator make them."""

    def draw(numbers: "f8*", history: "f8*", steps: "f8*", table: "f8*", state: "f8*", count: "i8") -> "f8":
        mars_row(numbers, history, steps, table, state, count)
        return 0.0

    ours, theirs = RanMars(seed), RanMars(seed)
    for count in counts:
        numbers, history = room(count)
        given_ = numbers, history, STEPS, ours.table, ours.state, count
        kernel(draw).bind(*given_)() if compiled else draw(*given_)
        assert numbers[:count].tolist() == [theirs.uniform() for _ in range(count)]
        assert ours.uniform() == theirs.uniform()
    assert [ours.uniform() for _ in range(2 * LAG)] == [theirs.uniform() for _ in range(2 * LAG)]
    assert ours.state[0] == theirs.state[0]


FLAGS = list(product((False, True), repeat=4))


@pytest.mark.parametrize("everyone", [False, True])
@pytest.mark.parametrize(
    ("zero", "record", "biased", "each"), [flags for flags in FLAGS if sum(flags) < 2 or sum(flags) > 3]
)
@settings(max_examples=15, deadline=None)
@given(SOME)
def test_langevin(everyone: bool, zero: bool, record: bool, biased: bool, each: bool, some: Some) -> None:
    """Also with more atoms than are drawn for at once."""
    if some.seed % 5 == 0:
        some = Some(some.n + langevin.CHUNK, some.seed, some.one_type)
    rows = some.rows(everyone)
    drag, noise = np.array([0.0, -0.1, -0.7, -1.3]), np.array([0.0, 2.0, 0.3, 1.9])
    heat = np.random.default_rng(some.seed).random(max(some.n, 1))
    ours, theirs = RanMars(some.seed + 1), RanMars(some.seed + 1)
    f, push, mean = some.f.copy(), np.zeros_like(some.f), np.zeros(3)
    for i in rows:
        for d in range(3):
            random = noise[some.type[i]] * heat[i if each else 0] * (theirs.uniform() - 0.5)
            random = 0.0 if biased and some.v[i, d] == 0.0 else random
            force = drag[some.type[i]] * some.v[i, d] + random
            f[i, d] += force
            push[i, d] = force
            mean[d] += random
    if zero:
        for i in rows:
            f[i] -= mean / len(rows)
            push[i] -= mean / len(rows)
    kept = np.zeros_like(push)
    kernel(langevin.drag_and_noise(everyone, some.one_type, zero, record, biased, each)).bind(
        some.v, some.f, some.type, some.mask, drag, noise, heat, ours.table, ours.state, *room(3 * langevin.CHUNK), STEPS,
        kept, BIT, len(rows), some.n,
    )()  # fmt: skip
    assert some.f.tobytes() == f.tobytes()
    assert not record or kept.tobytes() == push.tobytes()
    assert ours.uniform() == theirs.uniform()


@settings(max_examples=80, deadline=None)
@given(SOME, st.tuples(*[st.booleans()] * 3), st.booleans())
def test_wrap(some: Some, periodic: tuple[bool, bool, bool], flows: bool) -> None:
    """Against LAMMPS's pbc, atom by atom: one box length a side at most, never below the low face, flags in ten bits."""
    lo, hi, rate = np.array([-0.9, 0.0, -1.5]), np.array([1.1, 1.0, 1.5]), np.arange(1.0, 7.0)
    some.x[: some.n : 7] = lo - 1e-17  # one length up is on the high face, or beyond
    some.x[3 : some.n : 9] *= 4.0
    image = np.random.default_rng(some.seed).choice([-512, -1, 0, 511], (some.n, 3)).astype(np.int32)
    x, v, flags, group = some.x.copy(), some.v.copy(), image.copy(), BIT if flows else 0
    moved_by = ([rate[0], 0.0, 0.0], [rate[5], rate[1], 0.0], [rate[4], rate[3], rate[2]])
    for i, d in product(range(some.n), range(3)):
        if not periodic[d]:
            continue
        for beyond, sign in ((x[i, d] < lo[d], 1), (None, -1)):
            if x[i, d] >= hi[d] if beyond is None else beyond:
                x[i, d] += sign * (hi[d] - lo[d])
                if sign < 0:
                    x[i, d] = max(x[i, d], lo[d])
                flags[i, d] = (flags[i, d] - sign + 512) % 1024 - 512
                if some.mask[i] & group:
                    v[i, : d + 1] += sign * np.array(moved_by[d][: d + 1])
    which = np.array(periodic, np.int64)
    out = kernel(wrapping.outside()).bind(some.x, lo, hi, which, some.n)()
    sides = ((some.x[: some.n] < lo) | (some.x[: some.n] >= hi)) & which.astype(bool)
    assert out == sides.any(axis=1).sum()
    kernel(wrapping.wrap()).bind(some.x, some.v, image, some.mask, lo, hi, which, rate, group, some.n)()
    assert some.x.tobytes() == x.tobytes()
    assert some.v.tobytes() == v.tobytes()
    assert image.tobytes() == flags.tobytes()
