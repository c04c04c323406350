"""bond_style harmonic/shift/cut: bond_style harmonic/shift up to rc, no force and no energy beyond.

Source: LAMMPS manual, bond_harmonic_shift_cut.html.
"""

from __future__ import annotations

from pylmp.bonds.harmonic_shift import style
from pylmp.model.registry import BONDS

BONDS.add("harmonic/shift/cut", style("harmonic/shift/cut", True))
