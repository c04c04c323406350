"""Every bond and pair law in units in the last place, against itself at 60 digits and against LAMMPS.

Two yardsticks. An ulp is that of the result. A unit is what the best of algorithms cannot avoid: half an ulp of the result, plus what half an
ulp of each argument changes in it (the numbers a law receives are rounded), plus half an ulp of the largest constant it adds.
Near a zero of the force many ulps are few units.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import mpmath as mp
import numpy as np

from pylmp.model.registry import BONDS, PAIRS

HALF = 2.0**-53
UNITS = 2.0  # the contract
DIGITS = 60
JUMP = 1e5  # units: an error beyond is that of the other side of a limit
WALL = 2.0 ** (1.0 / 6.0)
QUARTIC = (1200.0, -0.55, 0.25, 1.3, 34.6878)
PLASTIC = (10.3, 0.3, 0.51, 0.021)


@dataclass(frozen=True)
class Case:
    """A law with its coefficients. near, far: the lengths measured; critical: those scanned one ulp at a time.

    c: what the law receives. constant: the largest number it adds on its way to force over r, and to the energy. script: LAMMPS's words for it, () if it has none.
    memory: what a bond remembers, at its first evaluation.
    """

    name: str
    kind: str
    law: Callable[..., Any]
    c: tuple[float, ...]
    near: float
    far: float
    critical: tuple[float, ...]
    constant: tuple[float, float] = (0.0, 0.0)
    script: tuple[str, ...] = ()
    memory: tuple[float, ...] = ()

    def at(self, r2: Any, c: Any) -> tuple[Any, Any, Any]:
        """(force over r, energy, holds): a bond or pair at rest."""
        if self.kind == "pair":
            return (*self.law(r2, 0.0, 1.0, c), True)
        force, energy, _, holds = self.law(r2, 0.0, self.memory, c)
        return force, energy, holds


def bond(name: str, c: tuple[float, ...], near: float, far: float, critical: tuple[float, ...], constant: float = 0.0, force: float = 0.0, **more: Any) -> Case:
    style, options = BONDS.find(name), more.pop("options", {})
    words = "".join(f" {key} {'yes' if value else 'no'}" for key, value in options.items() if key in ("smooth", "normalize"))
    numbers = " ".join(repr(x) for x in c[: 3 if name == "bpm/spring" else len(c)])
    script = (f"bond_style {name}{words}", f"bond_coeff 1 {numbers}") if style.release else ()
    return Case(f"bond {name}{words}", "bond", style.law(options), c, near, far, critical, (force, constant), script, **more)


def pair(name: str, coeffs: tuple[float, ...], cut: float, near: float, words: str, coeff: str, options: dict[str, Any] | None = None, constant: float = 0.0) -> Case:
    style = PAIRS.find(name)
    c = style.row(coeffs, cut, False)
    reach = style.reach(coeffs, cut)
    script = (f"pair_style {words}", f"pair_coeff 1 1 {coeff}")
    return Case(f"pair {words.split(' 1.9')[0]}", "pair", style.law(options or {}), c, near, 1.1 * reach, (reach,), (0.0, constant), script)


def _bpm(name: str, c: tuple[float, ...], smooth: bool, normalize: bool) -> Case:
    options = {"smooth": smooth, "normalize": normalize, "break": True, "overlay/pair": False, "volume/factor": False}
    yields = (1.0 - c[3], 1.0 + c[3]) if name.endswith("plastic") else ()
    force = c[0] / 0.75 if yields else 0.0  # 1 + ep
    memory = (1.0, 0.0)[: len(BONDS.find(name).history)]
    return bond(name, c, 0.75, 1.25, (1.0, *yields, 1.0 - c[1], 1.0 + c[1]), options=options, memory=memory, force=force)


CASES = [
    bond("quartic", QUARTIC, 0.7, 1.35, (1.3, WALL, 1.3 - 0.55), 1.0),
    bond("quartic/unbreakable", (200.0, -1.55, 0.57, 0.7, 3.022), 0.6, 2.0, (0.7, WALL), 1.0),
    *(_bpm("bpm/spring/plastic", PLASTIC, smooth, normalize) for smooth in (True, False) for normalize in (True, False)),
    *(_bpm("bpm/spring", (10.3, 0.3, 0.51, 0.0), smooth, normalize) for smooth in (True, False) for normalize in (True, False)),
    bond("harmonic", (32.5, 1.13), 0.3, 3.0, (1.13,)),
    bond("fene", (30.0, 1.5, 1.1, 1.05), 0.8, 1.42, (WALL * 1.05, 1.5 * math.sqrt(0.9)), 1.1),
    bond("fene/expand", (30.0, 1.5, 1.1, 0.95, 0.13), 0.85, 1.55, (WALL * 0.95 + 0.13,), 1.1),
    bond("morse", (10.3, 2.1, 1.07), 0.3, 3.0, (1.07,), 10.3),
    bond("nonlinear", (10.3, 1.07, 1.9), 0.3, 2.9, (1.07,)),
    bond("gromos", (10.3, 1.07), 0.3, 3.0, (1.07,)),
    bond("harmonic/shift", (10.3, 1.07, 1.9), 0.3, 3.0, (1.07, 1.9)),
    bond("harmonic/shift/cut", (10.3, 1.07, 1.9), 0.3, 2.1, (1.07, 1.9)),
    pair("lj/cut", (1.3, 0.9), 1.9, 0.75, "lj/cut 1.9", "1.3 0.9"),
    pair("lj/expand", (1.3, 0.9, 0.17), 1.9, 0.95, "lj/expand 1.9", "1.3 0.9 0.17"),
    pair("morse", (1.3, 1.7, 1.15), 1.9, 0.75, "morse 1.9", "1.3 1.7 1.15"),
    pair("soft", (1.3,), 1.9, 0.1, "soft 1.9", "1.3", constant=1.3),
    pair("bpm/spring", (2.3, 0.4, 0.0), 1.9, 0.2, "bpm/spring", "2.3 1.9 0.4", {"anharmonic": False}),
    pair("bpm/spring", (2.3, 0.4, 5.1), 1.9, 0.2, "bpm/spring anharmonic yes", "2.3 1.9 0.4 5.1", {"anharmonic": True}),
]


def lengths(case: Case, count: int, around: int) -> np.ndarray:
    """count lengths spread evenly at random, and around ulps to either side of every critical length."""
    spread = np.random.default_rng(5).uniform(case.near, case.far, count)
    scans = [r + np.arange(-around, around + 1) * math.ulp(r) for r in case.critical]
    return np.concatenate([spread, *scans])


@dataclass(frozen=True)
class Error:
    """Of one result over many lengths, in ulps: the median and that of 99 in 100 evenly spread lengths, the worst of all and its length; and the worst in units."""

    typical: float
    most: float
    worst: float
    place: float
    units: float


@dataclass(frozen=True)
class Measured:
    """Errors of force over r and energy (None: zero by definition). astray: how many ulps from a limit a double still is on its wrong side."""

    force: Error
    energy: Error | None
    astray: float


def measure(case: Case, count: int, around: int) -> Measured:
    r = lengths(case, count, around)
    r2 = r * r
    with np.errstate(all="ignore"):
        mine = case.at(r2, case.c)
        units = [_unit(case, r2, q) for q in (0, 1)]
    holds = np.broadcast_to(mine[2], r.shape)
    with mp.workdps(DIGITS):
        c = tuple(map(mp.mpf, case.c))
        exact = [case.at(x, c) for x in map(mp.mpf, r2.tolist())]
        off = [
            np.array([float(abs(mp.mpf(a) - b[q])) for a, b in zip(np.broadcast_to(mine[q], r.shape).tolist(), exact, strict=True)])
            for q in (0, 1)
        ]
    wrong = np.array([bool(a) != bool(b[2]) for a, b in zip(holds, exact, strict=True)])
    wrong |= (off[0] > JUMP * units[0]) | (off[1] > JUMP * units[1])
    errors = []
    for q in (0, 1):
        true = np.array([float(b[q]) for b in exact])
        errors.append(_error(r[~wrong], off[q][~wrong], true[~wrong], units[q][~wrong], r[:count]) if true.any() else None)
    assert errors[0] is not None
    astray = max((min(abs(x - at) / math.ulp(at) for at in case.critical) for x in r[wrong].tolist()), default=0.0)
    return Measured(errors[0], errors[1], astray)


def _error(r: np.ndarray, off: np.ndarray, true: np.ndarray, unit: np.ndarray, spread: np.ndarray) -> Error:
    there = true != 0.0
    ulps = off[there] / np.spacing(np.abs(true[there]))
    at = int(np.argmax(ulps))
    median, most = np.quantile(ulps[np.isin(r[there], spread)], (0.5, 0.99)).tolist()
    return Error(median, most, float(ulps[at]), float(r[there][at]), float((off / unit).max()))


def _unit(case: Case, r2: np.ndarray, q: int) -> np.ndarray:
    """What rounding result and arguments by half an ulp does, to first order; by the larger of two one-sided differences."""
    value = case.at(r2, case.c)[q]
    h = 2.0**-26
    total = np.abs(value) + case.constant[q]

    def change(there: Callable[[float], Any]) -> Any:
        return np.maximum(np.abs(there(1.0 + h) - value), np.abs(there(1.0 - h) - value)) / h

    total = total + change(lambda by: case.at(r2 * by, case.c)[q])
    for k in range(len(case.c)):
        total = total + change(lambda by, k=k: case.at(r2, _scaled(case.c, k, by))[q])
    for k in range(len(case.memory)):
        total = total + change(lambda by, k=k: replace(case, memory=_scaled(case.memory, k, by)).at(r2, case.c)[q])
    return HALF * total + np.finfo(float).tiny


def _scaled(values: tuple[float, ...], k: int, by: float) -> tuple[float, ...]:
    return (*values[:k], values[k] * by, *values[k + 1 :])
