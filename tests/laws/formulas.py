"""The formulas of the LAMMPS manual, written from its pages and from nothing else, for any kind of number."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import mpmath as mp

mp.mp.dps = 50
WALL = mp.mpf(2) ** (mp.mpf(1) / 6)


def lennard_jones(r: Any, epsilon: Any, sigma: Any) -> Any:
    return 4 * epsilon * ((sigma / r) ** 12 - (sigma / r) ** 6)


def quartic(r: Any, k: Any, b1: Any, b2: Any, rc: Any, u0: Any) -> Any:
    """bond_quartic.html, unbreakable: E = E_q + E_lj, E_q = U0 beyond Rc."""
    bond = k * (r - rc) ** 2 * (r - rc - b1) * (r - rc - b2) + u0 if r <= rc else u0
    return bond + (lennard_jones(r, 1, 1) + 1 if r < WALL else 0)


def harmonic(r: Any, k: Any, r0: Any) -> Any:
    return k * (r - r0) ** 2


def fene(r: Any, k: Any, r0: Any, epsilon: Any, sigma: Any, delta: Any = 0) -> Any:
    """bond_fene.html and bond_fene_expand.html, short of the length at which the release holds the force."""
    s = r - delta
    wall = lennard_jones(s, epsilon, sigma) + epsilon if s < WALL * sigma else 0
    return -k * r0**2 / 2 * mp.log(1 - (s / r0) ** 2) + wall


def morse(r: Any, d: Any, alpha: Any, r0: Any) -> Any:
    return d * (1 - mp.exp(-alpha * (r - r0))) ** 2


def nonlinear(r: Any, epsilon: Any, r0: Any, longest: Any) -> Any:
    return epsilon * (r - r0) ** 2 / (longest**2 - (r - r0) ** 2)


def gromos(r: Any, k: Any, r0: Any) -> Any:
    return k * (r**2 - r0**2) ** 2


def harmonic_shift(r: Any, depth: Any, r0: Any, rc: Any) -> Any:
    return depth / (r0 - rc) ** 2 * ((r - r0) ** 2 - (rc - r0) ** 2)


def soft(r: Any, a: Any, cut: Any) -> Any:
    return a * (1 + mp.cos(mp.pi * r / cut)) if r < cut else 0


def morse_pair(r: Any, d: Any, alpha: Any, r0: Any) -> Any:
    return d * (mp.exp(-2 * alpha * (r - r0)) - 2 * mp.exp(-alpha * (r - r0)))


def expanded(r: Any, epsilon: Any, sigma: Any, delta: Any) -> Any:
    return lennard_jones(r - delta, epsilon, sigma)


def spring_pair(r: Any, k: Any, rc: Any, ka: Any = 0) -> Any:
    """pair_bpm_spring.html without damping."""
    return k * (rc - r) ** 2 / 2 + ka * (rc - r) ** 4 / 4 if r < rc else 0


def plastic(
    r: Any, speed: Any, r0: Any, ep: Any, k: Any, eps_c: Any, gamma: Any, eps_p: Any, *, smooth: bool, normalize: bool
) -> tuple[Any, Any, bool]:
    """bond_bpm_spring_plastic.html: (force along the bond, plastic strain, bond holds).

    speed: rate of r. The yield limit is a strain relative to r0 (docs/departures.md).
    """
    e = (r - r0) / r0
    if e - ep > eps_p:
        ep = e - eps_p
    elif ep - e > eps_p:
        ep = e + eps_p
    equilibrium = (1 + ep) * r0
    force = -k * (r - equilibrium) / (r0 if normalize else 1) - gamma * speed
    if smooth:
        force *= 1 - ((r - r0) / (r0 * eps_c)) ** 8
    return force, ep, abs(e) <= eps_c


def slope(energy: Callable[[Any], Any], r: Any) -> Any:
    """dE/dr by differences of fourth order, 50 digits."""
    h = mp.mpf(10) ** -9
    return (energy(r - 2 * h) - 8 * energy(r - h) + 8 * energy(r + h) - energy(r + 2 * h)) / (12 * h)
