"""pylmp bench: what it reads and writes, and small scripts from end to end."""

TINY = """\
# A small liquid.
units lj
lattice fcc 0.8442
region b block 0 4 0 4 0 4
create_box 1 b
create_atoms 1 box
mass 1 1.0
velocity all create 1.44 87287 loop geom
pair_style lj/cut 2.5
pair_coeff 1 1 1.0 1.0
fix 1 all nve
variable steps index 50
run 5
run ${steps}
"""
