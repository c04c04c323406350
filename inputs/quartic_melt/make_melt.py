"""Write melt.data: CHAINS chains of LENGTH beads at bead density DENSITY, each a self-avoiding walk on a lattice.

usage: python make_melt.py [chains] [length]      (1000 chains of 32 beads: 32 000 beads)

The walk snakes through a cubic lattice, so that beads start about one bond length apart and never overlap;
the melt then forgets the lattice within a few hundred steps. Plain Python, no packages, same file every time.
"""

import sys

CHAINS, LENGTH = (int(w) for w in sys.argv[1:3]) if len(sys.argv) == 3 else (1000, 32)
DENSITY = 0.85


def snake(cells: int):
    """All sites of a cells^3 lattice, each a neighbor of the one before."""
    for k in range(cells):
        rows = range(cells) if k % 2 == 0 else reversed(range(cells))
        for turn, j in enumerate(rows):
            forward = (turn + k * cells) % 2 == 0
            for i in range(cells) if forward else reversed(range(cells)):
                yield i, j, k


def main() -> None:
    beads = CHAINS * LENGTH
    cells = round(beads ** (1 / 3) + 0.499999)
    while cells**3 < beads:
        cells += 1
    spacing = (beads / DENSITY) ** (1 / 3) / cells
    length = cells * spacing
    with open("melt.data", "w") as out:
        out.write(f"melt of {CHAINS} chains of {LENGTH} beads\n\n{beads} atoms\n1 atom types\n")
        out.write(f"{beads - CHAINS} bonds\n1 bond types\n\n")
        for axis in "xyz":
            out.write(f"0 {length!r} {axis}lo {axis}hi\n")
        out.write("\nMasses\n\n1 1.0\n\nAtoms # bond\n\n")
        for bead, (i, j, k) in zip(range(beads), snake(cells), strict=False):
            x, y, z = ((q + 0.5) * spacing for q in (i, j, k))
            out.write(f"{bead + 1} {bead // LENGTH + 1} 1 {x!r} {y!r} {z!r}\n")
        out.write("\nBonds\n\n")
        bond = 0
        for bead in range(1, beads):
            if bead % LENGTH:
                bond += 1
                out.write(f"{bond} 1 {bead} {bead + 1}\n")


main()
