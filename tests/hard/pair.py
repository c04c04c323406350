"""Two beads and a bond, at rest at its length 1, in the middle of a box."""

PAIR = """units lj
atom_style bond
boundary f f f
newton on off
comm_modify vel yes cutoff 3
special_bonds lj 0 1 1 coul 0 1 1
region cell block -4 4 -4 4 -4 4
create_box 1 cell bond/types 1 extra/bond/per/atom 1 extra/special/per/atom 2
create_atoms 1 single -0.5 0 0
create_atoms 1 single 0.5 0 0
mass 1 2.0
pair_style zero 2
pair_coeff * *
create_bonds single/bond 1 1 2
special_bonds lj 0 1 1 coul 1 1 1
"""
