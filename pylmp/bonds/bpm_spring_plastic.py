"""bond_style bpm/spring/plastic: a spring that yields and breaks.

    F = -k (r - r_eq) w,  F_D = -gamma w (rhat . v),  w = 1 - ((r - r0)/(r0 eps_c))^8,  r_eq = (1 + ep) r0

r0 is the length at the first evaluation. When the strain e = (r - r0)/r0 leaves [ep - eps_p, ep + eps_p], the plastic strain
ep follows it; the bond breaks when |e| > eps_c. The potential energy is zero by definition.

Source: LAMMPS manual, bond_bpm_spring_plastic.html (Clemmer and Lechman, Powder Technology, 2025); the limit eps_p
relative to r0 and the order of operations as measured on LAMMPS 22 Jul 2025.
"""

from __future__ import annotations

import math
from typing import Any

from pylmp.bonds.bpm import RESTART, RESTRICTIONS, parse, slowed
from pylmp.laws import fabs, select, sqrt
from pylmp.model.registry import BONDS
from pylmp.model.style import BondStyle, Coeff, Law, Options


def plastic(options: Options) -> Law:
    normalize, finish = bool(options["normalize"]), slowed(bool(options["smooth"]))

    def law(r2: Any, dot: Any, h: Any, c: Any) -> Any:
        r0, ep = h
        k, eps_c, gamma, eps_p = c
        r = sqrt(r2)
        e = (r - r0) / r0
        ep = select(e > ep + eps_p, e - eps_p, ep)
        ep = select(e < ep - eps_p, e + eps_p, ep)
        force = -k * (e - ep) if normalize else -k * (r - (1.0 + ep) * r0)
        force = finish(force, dot, r, r0, gamma, eps_c)
        return force, 0.0 * r2, (r0, ep), select(fabs(e) > eps_c, False, True)

    return law


BONDS.add(
    "bpm/spring/plastic",
    BondStyle(
        name="bpm/spring/plastic",
        manual="bond_bpm_spring_plastic.html",
        coeffs=(
            Coeff("k", "force/distance"),
            Coeff("eps_c", "unitless"),
            Coeff("gamma", "force/velocity"),
            Coeff("eps_p", "unitless"),
        ),
        law=plastic,
        parse=parse,
        restrictions=RESTRICTIONS,
        history=("r0", "ep"),
        evolves=True,
        reference=True,
        velocity=True,
        can_break=lambda options: bool(options["break"]),
        on_break="remove",
        lower_id_first=True,
        updates_special=lambda options: bool(options["break"]) and not options["overlay/pair"],
        mixable=True,
        misplaces=True,
        freeze=lambda coeffs: (*coeffs[:3], math.inf),  # one bond alone does not yield
        writes=False,
        release="bpm/spring/plastic",
        restart=RESTART,
    ),
)
