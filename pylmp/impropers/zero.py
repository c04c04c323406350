"""improper_style zero [nocoeff]: no forces. improper_coeff TYPE. Source: LAMMPS manual, improper_zero.html."""

from __future__ import annotations

from pylmp.model.blob import Blob
from pylmp.model.many_body import ManyBodyStyle
from pylmp.model.registry import IMPROPERS
from pylmp.text.words import Args


def parse(args: Args) -> bool:
    if len(args) and not (len(args) == 1 and args.take("nocoeff")):
        args.illegal(args.peek(), hint="nocoeff")
    return len(args.words) == 0


def read(args: Args, types: int) -> tuple[range, tuple[float, ...]]:
    if len(args) != 1:
        args.fail("Incorrect args for improper coefficients", args.words[-1], hint="improper_coeff TYPE")
    return args.types(types), ()


IMPROPERS.add("zero", ManyBodyStyle("zero", "improper_zero.html", 0, parse, read, Blob()))
