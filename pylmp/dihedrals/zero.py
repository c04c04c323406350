"""dihedral_style zero [nocoeff]: no forces. dihedral_coeff TYPE. Source: LAMMPS manual, dihedral_zero.html."""

from __future__ import annotations

from pylmp.model.blob import Blob
from pylmp.model.many_body import ManyBodyStyle
from pylmp.model.registry import DIHEDRALS
from pylmp.text.words import Args


def parse(args: Args) -> bool:
    if len(args) and not (len(args) == 1 and args.take("nocoeff")):
        args.illegal(args.peek(), hint="nocoeff")
    return len(args.words) == 0


def read(args: Args, types: int) -> tuple[range, tuple[float, ...]]:
    if len(args) != 1:
        args.fail("Incorrect args for dihedral coefficients", args.words[-1], hint="dihedral_coeff TYPE")
    return args.types(types), ()


DIHEDRALS.add("zero", ManyBodyStyle("zero", "dihedral_zero.html", 0, parse, read, Blob()))
