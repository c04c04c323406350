"""Every fix, alone and with others, against LAMMPS: trajectories, thermo columns and fix outputs are the same numbers."""

from __future__ import annotations

import pytest

from tests.fixes.twins import compare, scene

NVE = "fix 1 all nve\n"
BATH = NVE + "fix 2 all langevin 1 9 0.7 12345"
BOX_RAMP = NVE + "fix 2 all deform 1 x erate 0.3 y scale 0.8 z final 0 5"
PARTS = "run 20 start 0 stop 80\nrun 30 start 0 stop 80\nrun 60 upto start 0 stop 80\nrun 20"
THREE = "f_2[1] f_2[2] f_2[3]"

SCENES = {
    "nve": scene("fix 1 all nve"),
    "nve of a group": scene("fix 1 two nve"),
    "moved twice": scene("fix 1 two nve\nfix 2 odd nve"),
    "langevin": scene(BATH),
    "langevin of a group, scaled": scene("fix 2 two langevin 1 3 0.7 12345 scale 2 1.7\nfix 1 all nve"),
    "langevin zero": scene(NVE + "fix 2 odd langevin 1 3 0.7 12345 zero yes scale 1 2.2"),
    "langevin tally": scene(NVE + "fix 2 all langevin 1 3 0.7 12345 zero yes tally yes", "f_2 ecouple econserve"),
    "langevin tally asked late": scene(
        NVE + "fix 2 two langevin 1 3 0.7 12345 tally yes",
        runs="run 30\nthermo_style custom step f_2\nthermo_modify format float %.17g\nrun 30",
    ),
    "langevin ramp over runs": scene(BATH, runs=PARTS),
    "langevin, run every": scene(BATH, runs="run 20\nrun 20 every 7 NULL\nrun 10 pre no"),
    "langevin, other mass and step": scene(BATH, runs="run 30\ntimestep 0.002\nmass 1 3.0\nrun 20\nunfix 2\nrun 10"),
    "langevin replaced": scene(
        NVE + "fix 2 all langevin 1 3 0.7 12345\nfix 3 all setforce NULL 0 NULL\nfix 2 all langevin 3 3 0.7 1234"
    ),
    "setforce": scene(NVE + "fix 2 odd setforce 0.5 NULL 0.0", THREE),
    "setforce in a region": scene("region r block 1 3 1 3 1 3\n" + NVE + "fix 2 all setforce 0.5 NULL 0 region r", THREE),
    "addforce": scene(NVE + "fix 2 odd addforce 0.5 0.0 -0.3", "f_2 " + THREE),
    "addforce and setforce": scene(
        NVE + "fix 2 odd addforce 0.5 0 -0.3\nfix 3 two setforce 0 0 0", "f_2 f_2[1] f_3[1] f_3[3]"
    ),
    "addforce every in a region": scene(
        "region r sphere 2 2 2 1.7\n" + NVE + "fix 2 odd addforce 0.5 0.1 0 region r every 3", "f_2 " + THREE
    ),
    "addforce in energy and pressure": scene(
        NVE + "fix 2 odd addforce 0.5 0.1 0\nfix_modify 2 energy yes virial yes\nfix 3 two addforce 1 0 0 every 10\n"
        "fix_modify 3 energy yes\ncompute p all pressure NULL fix\ncompute q all pressure NULL pair fix\ncompute e all pe fix",
        "f_2 f_2[1] c_p c_p[1] c_p[4] c_p[6] c_q c_e",
    ),
    "viscous": scene(NVE + "fix 2 odd viscous 0.5 scale 2 3.3"),
    "enforce2d": scene("set atom * vz 0.1\n" + NVE + "fix 2 two enforce2d", dim=2),
    "plane": scene(BATH + "\nfix 3 all enforce2d", dim=2),
    "move": scene("fix 1 two nve\ngroup rest subtract all two\nfix 2 rest move linear 0.5 NULL -1.0"),
    "move in box units": scene("group q id 1 2 3 7\ngroup rest subtract all q\nfix 2 q move linear 6.5 0 -1.0 units box\nfix 1 rest nve"),
    "move, ended and anew": scene(
        "fix 1 odd move linear 1 0 NULL",
        runs="run 30\nunfix 1\nrun 20\nfix 1 odd move linear 0 1 0\nrun 20\nfix 1 odd move linear 1 1 0\nrun 20",
    ),
    "deform erate scale": scene(NVE + "fix 2 all deform 1 x erate 0.3 y scale 0.8"),
    "deform of a group every 5": scene(NVE + "fix 2 odd deform 5 x final 0.0 5.2 y delta -0.1 0.3 z vel 0.2"),
    "deform without atoms": scene(
        NVE + "fix 2 all deform 3 x final -0.1 6.2 y delta -0.1 0.3 z vel 0.2 units box remap none"
    ),
    "deform far": scene(NVE + "fix 2 all deform 4 x erate -0.1 y scale 1.3 z vel 0.1 units box", runs="run 300\nrun 50"),
    "deform ramp over runs": scene(BOX_RAMP, runs=PARTS),
    "deform ended": scene(BOX_RAMP, runs="run 20\nunfix 2\nrun 20"),
    "deform in the plane": scene(NVE + "fix 2 all deform 1 x erate 0.1 y vel -0.1\nfix 3 all enforce2d", dim=2),
    "neighbor settings": scene(
        NVE + "neighbor 0.5 bin\nneigh_modify every 2 delay 4 check yes",
        runs="run 30\nneigh_modify delay 10 check no\nneighbor 0.2 bin\ncomm_modify cutoff 4.0\nrun 40",
    ),
}


@pytest.mark.parametrize("name", SCENES)
def test_same_numbers(name: str, tmp_path) -> None:
    compare(SCENES[name], tmp_path)
