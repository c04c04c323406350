"""Coefficients of unlike types from those of the like ones: pair_modify mix. Source: LAMMPS manual, pair_modify.html."""

from __future__ import annotations

import math

GEOMETRIC, ARITHMETIC, SIXTHPOWER = "geometric", "arithmetic", "sixthpower"


def mix_distance(a: float, b: float, rule: str) -> float:
    """A length (sigma, cutoff) of an unlike pair."""
    if rule == ARITHMETIC:
        return 0.5 * (a + b)
    if rule == SIXTHPOWER:
        return math.pow(0.5 * (_sixth(a) + _sixth(b)), 1.0 / 6.0)
    return math.sqrt(a * b)


def mix_energy(e1: float, e2: float, s1: float, s2: float, rule: str) -> float:
    """A well depth of an unlike pair; sigmas matter for sixthpower only."""
    if rule == SIXTHPOWER:
        return 2.0 * math.sqrt(e1 * e2) * (s1 * (s1 * s1)) * (s2 * (s2 * s2)) / (_sixth(s1) + _sixth(s2))
    return math.sqrt(e1 * e2)


def _sixth(x: float) -> float:
    """x^6 by repeated squaring, which C's pow rounds differently."""
    square = x * x
    return square * (square * square)
