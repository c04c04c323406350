"""bond_style bpm/spring: a spring that breaks.

    F = -k (r - r0) w,  F_D = -gamma w (rhat . v),  w = 1 - ((r - r0)/(r0 eps_c))^8,  E = k (r - r0)^2/2

r0 is the length at the first evaluation; with normalize yes, F = -k (r - r0)/r0. The bond breaks when |r - r0|/r0 > eps_c.
LAMMPS does not smooth the energy.

Source: LAMMPS manual, bond_bpm_spring.html; order of operations as measured on LAMMPS 22 Jul 2025.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from pylmp.bonds.bpm import RESTART, RESTRICTIONS, parse
from pylmp.laws import fabs, select, sqrt
from pylmp.model.blob import FLAG
from pylmp.model.registry import BONDS
from pylmp.model.simulation import Simulation
from pylmp.model.style import BondStyle, Coeff, Law, Options
from pylmp.text.diagnostic import Unsupported
from pylmp.text.words import Args


def spring(options: Options) -> Law:
    normalize, smooth = bool(options["normalize"]), bool(options["smooth"])

    def law(r2: Any, dot: Any, h: Any, c: Any) -> Any:
        r0 = h[0]
        k, eps_c, gamma, _ = c
        r = sqrt(r2)
        e = (r - r0) / r0
        ri = 1.0 / r
        force = -k * e if normalize else -k * (r - r0)
        energy = -0.5 * force * (r - r0)
        force = force - gamma * dot * ri
        force = force * ri
        if smooth:
            s = (r - r0) / (r0 * eps_c)
            s = s * s
            s = s * s
            s = s * s
            force = force * (1.0 - s)
        return force, energy, (r0,), select(fabs(e) > eps_c, False, True)

    return law


def read(sim: Simulation, args: Args) -> Options:
    options = parse(sim, args, ("volume/factor",))
    options["volume known"] = False
    if options["volume/factor"]:
        raise Unsupported(
            "LAMMPS has bond style bpm/spring volume/factor yes, pylmp's native engines do not",
            next((word.span for word in args.words if word.text == "volume/factor"), None),
            hint="--engine lammps runs this script on LAMMPS", manual="bond_bpm_spring.html",
        )  # fmt: skip
    return options


def without_volume(args: Args, coeffs: tuple[float, ...]) -> None:
    """a_v belongs to volume/factor yes."""
    named = args.words[1].text == "bpm/spring"  # under hybrid
    if len(args.words) > 4 + named:
        args.fail("Incorrect args for bond coefficients", hint="bond_coeff TYPE k eps_c gamma")


BONDS.add(
    "bpm/spring",
    BondStyle(
        name="bpm/spring",
        manual="bond_bpm_spring.html",
        coeffs=(Coeff("k", "force/distance"), Coeff("eps_c", "unitless"), Coeff("gamma", "force/velocity"), Coeff("a_v", "force")),
        optional_coeffs=1,
        check=without_volume,
        law=spring,
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
