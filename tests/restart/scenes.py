"""Scenes for restart files: (what sets a simulation up, what must be said again after read_restart) by name."""

from __future__ import annotations

from pathlib import Path

DECKS = Path(__file__).parents[1] / "decks"
BONDS = "bond/types 2 extra/bond/per/atom 6 extra/special/per/atom 40"
SETUP = """units lj
{before}
atom_style {style}
newton {newton}
boundary {boundary}
lattice sc 0.8
region cell block 0 5 0 5 0 5
create_box 2 cell {counts}
create_atoms 1 box
set group all type/fraction 2 0.3 9213
mass 1 1.0
mass 2 1.7
displace_atoms all random 0.02 0.02 0.02 4711
pair_style lj/cut 1.122462048309373
pair_modify shift yes
pair_coeff 1 1 1.0 1.0
pair_coeff 2 2 0.9 1.05
{rest}
velocity all create {heat} 87287 loop geom
"""
NET = """special_bonds lj/coul 0 1 1
create_bonds many all all 1 0.8 1.15
group two type 2
create_bonds many two two 2 0.8 1.14
"""
ONES = "special_bonds lj/coul 1 1 1\n"
BPM = "special_bonds lj 0 1 1 coul 1 1 1\ncomm_modify vel yes cutoff 3.5\npair_coeff * * 1.0 0.7\n"
HARMONIC = "bond_style harmonic\nbond_coeff 1 60 1.07\nbond_coeff 2 90 1.0\n"
QUARTIC = "bond_style quartic\nbond_coeff 1 1200 -0.55 0.25 1.3 34.6878\nbond_coeff 2 1000 -0.5 0.25 1.25 30\n"
PAIR_TABLE = f"pair_coeff * * {DECKS}/pair/table.table PLAIN\n"
BOND_TABLE = f"bond_coeff * {DECKS}/bond/table.table MORSE\n"
PLASTIC = "bond_style bpm/spring/plastic{words}\nbond_coeff 1 60 0.25 0.3 0.05\nbond_coeff 2 80 0.2 0.1 0.1\n"
TWO = "bond_coeff 1 bpm/spring/plastic 60 0.25 0.3 0.05\nbond_coeff 2 quartic 1000 -0.5 0.25 1.25 30\n"
TWO_STYLES = "bond_style hybrid bpm/spring/plastic overlay/pair yes quartic\n"
MIXED = "bond_coeff 1 harmonic 60 1.07\nbond_coeff 2 zero 1\n"
NVE = "fix 1 all nve\nthermo 10\n"


def setup(
    rest: str = "", style: str = "bond", newton: str = "on on", boundary: str = "p p p", heat: float = 1.4, before: str = "units lj"
) -> str:  # fmt: skip
    counts = "" if style == "atomic" else BONDS
    return SETUP.format(
        rest=rest, style=style, newton=newton, boundary=boundary, heat=heat, before=before, counts=counts
    )


SCENES: dict[str, tuple[str, str]] = {
    **{
        f"harmonic, {style}, newton {newton}": (setup(NET + HARMONIC, style, newton), NVE)
        for style, newton in (
            ("bond", "on on"), ("bond", "off off"), ("molecular", "on off"), ("angle", "off on"), ("full", "on on"),
        )
    },
    "atomic": (setup(style="atomic"), NVE),
    "walls that follow": (setup(style="atomic", boundary="s p m"), NVE),
    "walls that follow, bonds": (setup(NET + HARMONIC + "comm_modify cutoff 3.0", boundary="s s m"), NVE),
    "fixed walls": (setup("comm_modify cutoff 2.0\ndisplace_atoms all move 0 0.4 0 units box", style="atomic", boundary="p f p"), NVE + "thermo_modify lost ignore\n"),
    "quartic": (setup(NET + ONES + QUARTIC), NVE),
    "quartic, breaking": (setup(NET + ONES + QUARTIC, newton="off off", heat=9.0), NVE),
    "plastic": (setup(NET + BPM + PLASTIC.format(words=""), newton="on off", heat=2.0), NVE),
    "plastic, keywords": (setup(NET + BPM + PLASTIC.format(words=" smooth no normalize yes"), newton="on off", heat=2.0), NVE),
    "plastic, unbreakable": (setup(NET + BPM + PLASTIC.format(words=" break no smooth no")), NVE),
    "plastic, recorded": (
        setup(NET + BPM + PLASTIC.format(words=" store/local broken 5 time id1 x/ref"), newton="on off", heat=2.0), NVE,
    ),
    "plastic, given again": (
        setup(NET + BPM + PLASTIC.format(words=" store/local broken 5 time id1 x/ref"), newton="on off", heat=2.0),
        PLASTIC.format(words=" store/local broken 5 time id1 x/ref") + NVE,
    ),
    "hybrid, given again": (setup(NET + ONES + BPM.split("\n")[1] + "\n" + TWO_STYLES + TWO, newton="on off"), TWO_STYLES + TWO + NVE),
    "hybrid": (setup(NET + "bond_style hybrid harmonic zero\n" + MIXED), MIXED + NVE),
    "bonds without force": (setup(NET + "bond_style zero\nbond_coeff 1 1.2\nbond_coeff 2\n"), NVE),
    "bonds turned off": (setup(NET + HARMONIC + "group few id 1:30\ndelete_bonds few bond 1\n"), NVE),
    "pairs without force": (setup(NET + "pair_style zero 1.5\npair_coeff * *\npair_coeff 1 2 1.2\n" + HARMONIC), NVE),
    **{
        f"bpm/spring, volumes{words}, newton {newton}": (
            setup(NET + BPM + f"bond_style bpm/spring volume/factor yes{words}\nbond_coeff 1 60 0.25 0.3 9\nbond_coeff 2 80 0.2 0.1 -5\n", newton=newton, heat=2.0),
            NVE,
        )
        for words, newton in (("", "on off"), (" break no smooth no", "on on"))
    },
    "tables": (
        setup(NET + f"pair_style table spline 30 pppm\n{PAIR_TABLE}bond_style table linear 50\n{BOND_TABLE}"), PAIR_TABLE + BOND_TABLE + NVE,
    ),
    "pair bpm/spring": (
        setup(NET + "comm_modify vel yes\npair_style bpm/spring\npair_coeff * * 2 1.1 0.3\npair_coeff 2 2 3 1.2 0.1\n" + HARMONIC), NVE,
    ),
    "pair settings": (setup("pair_modify mix arithmetic tail yes shift no", style="atomic"), NVE),
    "a heat bath": (setup(style="atomic"), NVE + "fix 2 all langevin 1.0 1.0 0.5 4711\n"),
    "a path": (
        setup("group a id 1:60", style="atomic"), "group b subtract all a\nfix 1 b nve\nfix 2 a move wiggle 0.2 NULL 0.1 0.5\n",
    ),
    "groups, a map": (
        setup("group a id 1:20\ngroup b type 2\ngroup c id 5 6 7\ngroup b delete\n", "atomic", before="atom_modify map hash"), "fix 1 a nve\n",
    ),
    "sorting, ghosts": (setup("atom_modify sort 10 1.0\ncomm_modify cutoff 2.0 vel yes\ntimestep 0.002\n", style="atomic"), NVE),
}  # fmt: skip
SCENES |= {
    "fix move": (setup("group few id 1:20\ngroup rest subtract all few\n", "atomic"), "fix 1 rest nve\nfix 2 few move wiggle 0.5 NULL 0.1 2.0 units box\n"),
    "fix spring/self": (setup("group few id 1:20\n", "atomic"), NVE + "fix 2 few spring/self 10\n"),
    "fix temp/rescale": (setup(style="atomic"), NVE + "fix 2 all temp/rescale 5 1.0 2.0 0.1 0.5\nfix 3 all temp/berendsen 1.0 1.0 0.5\nthermo_style custom step temp f_2 f_3\n"),
    "fix store/state": (setup(style="atomic"), NVE + "fix 2 all store/state 0 x vy\ncompute s all reduce sum f_2[1] f_2[2]\nthermo_style custom step temp c_s[1] c_s[2]\n"),
    "computes that remember": (
        setup("group few id 1:20\n", "atomic"),
        NVE + "compute m few msd com yes\ncompute d all displace/atom\ncompute v all vacf\ncompute s all reduce max c_d[4]\n"
        "thermo_style custom step temp c_m[4] c_v[4] c_s\n",
    ),
    "who keeps what": (
        setup("group few id 1:20\n", "atomic"),
        "compute m few msd\n" + NVE + "fix 2 few spring/self 10\ncompute d all displace/atom\nfix 3 few move linear 0 0 0.1 units box\nunfix 3\n",
    ),
}  # fmt: skip
HYBRID = "pair_coeff 1 1 lj/cut 1.0 1.0\npair_coeff 2 2 morse 3 4 1.1\npair_coeff 1 2 lj/cut 0.5 1.0\n"
OVERLAY = "pair_coeff * * lj/cut 1 1.0 1.0\npair_coeff * * soft 2.0\npair_coeff 1 2 lj/cut 2 0.5 1.0 1.3\n"
SCENES |= {
    "pair hybrid": (setup("pair_style hybrid lj/cut 1.5 morse 1.4\n" + HYBRID, "atomic", heat=0.5), HYBRID + NVE),
    "pair hybrid/overlay": (setup("pair_style hybrid/overlay lj/cut 1.2 soft 1.4 lj/cut 1.1\n" + OVERLAY, "atomic", heat=0.5), OVERLAY + NVE),
    "pair morse": (setup("pair_style morse 1.5\npair_coeff * * 3 4 1.1\npair_coeff 1 2 2 4 1.1 1.3\npair_modify shift yes\n", "atomic"), NVE),
    "pair soft": (setup("pair_style soft 1.3\npair_coeff 1 1 3\npair_coeff 2 2 4 1.2\npair_modify mix arithmetic\n", "atomic"), NVE),
    "bpm/spring": (
        setup(NET + BPM + PLASTIC.format(words="").replace("/plastic", "").replace(" 0.05\n", "\n").replace(" 0.1 0.1\n", " 0.1\n"), newton="on off"), NVE,
    ),
}  # fmt: skip
SCENES["fix deform"] = (setup(style="atomic"), NVE + "fix 2 all deform 2 x erate 0.05 y scale 1.1 z trate 0.02 remap x\n")
KEPT_OTHERWISE = {"fix deform"}  # LAMMPS stores what it then computes anew
SCENES["two dimensions"] = (
    """units lj
dimension 2
atom_style bond
lattice sq2 0.8
region cell block 0 7 0 7 -0.5 0.5
create_box 1 cell bond/types 1 extra/bond/per/atom 6 extra/special/per/atom 20
create_atoms 1 box
mass 1 1.0
pair_style lj/cut 1.122462048309373
pair_coeff 1 1 1.0 1.0
special_bonds lj/coul 0 1 1
create_bonds many all all 1 0.5 1.15
bond_style harmonic
bond_coeff 1 60 1.07
velocity all create 1.0 4711 loop geom
""",
    "fix 1 all nve\nfix 2 all enforce2d\n",
)
SCENES["triclinic"] = (
    """units lj
region cell prism 0 6 0 6 0 6 1.0 0.5 -0.7 units box
lattice sc 0.5
create_box 1 cell
create_atoms 1 box
mass 1 1.0
pair_style lj/cut 1.5
pair_coeff 1 1 1.0 1.0
velocity all create 1.0 4711 loop geom
""",
    "fix 1 all nve\n",
)
