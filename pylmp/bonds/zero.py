"""bond_style zero: bonds without force; a length may be kept for other commands. Source: LAMMPS manual, bond_zero.html."""

from __future__ import annotations

from typing import Any

from pylmp.model.blob import Blob
from pylmp.model.registry import BONDS
from pylmp.model.style import BondStyle, Coeff, Options
from pylmp.text.words import Args


def nothing(r2: Any, dot: Any, h: Any, c: Any) -> Any:
    return 0.0 * r2, 0.0 * r2, h, True


def parse(sim: Any, args: Args) -> Options:
    if not len(args):
        return {"nocoeff": False}
    if len(args) == 1 and args.take("nocoeff"):
        return {"nocoeff": True}
    args.fail("Illegal bond_style command", args.peek(), hint="the one keyword is nocoeff")


BONDS.add(
    "zero",
    BondStyle(
        name="zero", manual="bond_zero.html", coeffs=(Coeff("r0", "distance"),), law=lambda options: nothing,
        parse=parse, adapts=("r0",), optional_coeffs=1, length=lambda coeffs, options: coeffs[0], release="zero",
        restart=Blob(defaults=(("nocoeff", False),)),
    ),
)  # fmt: skip
