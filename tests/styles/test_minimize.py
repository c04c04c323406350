"""What bonds remember survives a minimization: LAMMPS 22 Jul 2025 mixes it up there (docs/departures.md), so the law is its own judge."""

from __future__ import annotations

import numpy as np

from tests.support import frames, simulate

NETWORK = """units lj
atom_style bond
newton on off
comm_modify vel yes cutoff 2.6
special_bonds lj 0 1 1 coul 0 1 1
lattice fcc 1.0
region cell block 0 3 0 3 0 3
create_box 1 cell bond/types 1 extra/bond/per/atom 12 extra/special/per/atom 60
create_atoms 1 box
mass 1 1.0
displace_atoms all random 0.03 0.03 0.03 77
pair_style bpm/spring
pair_coeff 1 1 12.0 1.0 0.5
create_bonds many all all 1 0.8 1.25
special_bonds lj 0 1 1 coul 1 1 1
bond_style bpm/spring/plastic smooth no
bond_coeff 1 40 0.5 0.4 0.01
velocity all create 0.3 4711
fix 1 all nve
compute ends all property/local batom1 batom2
compute bond all bond/local dist b1 b2 force
dump 1 all local 1 bonds c_ends[1] c_ends[2] c_bond[*]
dump_modify 1 format float %.17g
run 30
min_style {style}
minimize 0 1.0e-6 30 200
"""


def memory(script: str, folder) -> list[dict[tuple[int, int], np.ndarray]]:
    """(dist, r0, r_eq, force) by pair of IDs, frame by frame."""
    simulate(script, folder)
    return [{tuple(sorted(map(int, row[:2]))): row[2:] for row in rows} for _, _, rows in frames(folder / "bonds")]


def test_every_bond_keeps_its_own_r0_and_obeys_the_law(tmp_path) -> None:
    for style in ("fire", "quickmin"):
        first, *later = memory(NETWORK.format(style=style), tmp_path / style)
        assert len(later) > 31
        for frame in later:
            assert frame.keys() == first.keys()
            for pair, (dist, r0, equilibrium, _) in frame.items():
                assert r0 == first[pair][1]
                assert abs(dist - equilibrium) <= 0.01 * r0 * (1.0 + 1e-12)
