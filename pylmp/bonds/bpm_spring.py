"""bond_style bpm/spring: a spring that breaks.

    F = -k (r - r0) w,  F_D = -gamma w (rhat . v),  w = 1 - ((r - r0)/(r0 eps_c))^8,  E = k (r - r0)^2/2
    with volume/factor yes also F_V = a_v ((V/V0)^(1/d) - r/r0) w, V the volumes of both atoms (model/bond_volumes.py)

r0 is the length at the first evaluation; with normalize yes, F = -k (r - r0)/r0. The bond breaks when |r - r0|/r0 > eps_c.
LAMMPS does not smooth the energy, and leaves the volumes out of it.

Source: LAMMPS manual, bond_bpm_spring.html; order of operations as measured on LAMMPS 22 Jul 2025.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from pylmp.bonds.bpm import RESTART, RESTRICTIONS, parse, slowed
from pylmp.laws import fabs, select, sqrt
from pylmp.model.blob import FLAG
from pylmp.model.registry import BONDS
from pylmp.model.simulation import Simulation
from pylmp.model.style import BondStyle, Coeff, Law, Options
from pylmp.text.words import Args


def spring(options: Options) -> Law:
    normalize, finish = bool(options["normalize"]), slowed(bool(options["smooth"]))

    def plain(r2: Any, dot: Any, h: Any, c: Any) -> Any:
        r0 = h[0]
        k, eps_c, gamma, _ = c
        r = sqrt(r2)
        e = (r - r0) / r0
        force = -k * e if normalize else -k * (r - r0)
        energy = -0.5 * force * (r - r0)
        return finish(force, dot, r, r0, gamma, eps_c), energy, (r0,), select(fabs(e) > eps_c, False, True)

    def swollen(r2: Any, dot: Any, h: Any, c: Any) -> Any:
        """With volumes: c ends with (V/V0)^(1/d)."""
        r0 = h[0]
        k, eps_c, gamma, a_v, growth = c
        r = sqrt(r2)
        e = (r - r0) / r0
        force = -k * e if normalize else -k * (r - r0)
        energy = -0.5 * force * (r - r0)
        force = force + a_v * (growth - 1.0 - e)
        return finish(force, dot, r, r0, gamma, eps_c), energy, (r0,), select(fabs(e) > eps_c, False, True)

    return swollen if options["volume/factor"] else plain


def read(sim: Simulation, args: Args) -> Options:
    return {**parse(sim, args, ("volume/factor",)), "volume known": False}


def fitting(options: Options, args: Args, coeffs: tuple[float, ...]) -> None:
    """a_v belongs to volume/factor yes, and is needed there."""
    named = args.words[1].text == "bpm/spring"  # under hybrid
    if len(args.words) != 4 + named + options["volume/factor"]:
        names = "k eps_c gamma a_v" if options["volume/factor"] else "k eps_c gamma"
        args.fail("Incorrect args for bond coefficients", args.words[-1], hint=f"bond_coeff TYPE {names}")


BONDS.add(
    "bpm/spring",
    BondStyle(
        name="bpm/spring",
        manual="bond_bpm_spring.html",
        coeffs=(Coeff("k", "force/distance"), Coeff("eps_c", "unitless"), Coeff("gamma", "force/velocity"), Coeff("a_v", "force")),
        optional_coeffs=1,
        check=fitting,
        law=spring,
        volumes=lambda options: bool(options["volume/factor"]),
        parse=read,
        restrictions=RESTRICTIONS,
        history=("r0",),
        reference=True,
        velocity=True,
        can_break=lambda options: bool(options["break"]),
        on_break="remove",
        lower_id_first=True,
        updates_special=lambda options: bool(options["break"]) and not options["overlay/pair"],
        mixable=True,
        writes=False,
        release="bpm/spring",
        restart=replace(RESTART, settings=(*RESTART.settings, ("volume/factor", FLAG), ("volume known", FLAG))),
    ),
)
