"""P111."""

from __future__ import annotations

from math import pi
from typing import TYPE_CHECKING

from pylmp.model.sanity import BLOWS_UP, stiffest
from pylmp.model.scene import Scene
from pylmp.text.span import Span
from pylmp.text.words import Word
from pylmp.tools.check.rule import Rule

if TYPE_CHECKING:
    from pylmp.tools.check.look import Look

_SMALL = 200_000  # atoms whose bonds are looked at
_HALF = BLOWS_UP / 2.0  # of what is stable: the frequency is off by 1/24


class TimestepTooLong(Rule):
    """The timestep is too long for the stiffest bond.

    Two atoms on a bond swing with omega, the root of its stiffness over their reduced mass. With omega dt above 1, six
    steps in a period, energy wavers and frequencies are wrong; from 2 on, velocity Verlet diverges.

    Okay:
        atom_style bond
        region cell block 0 9 0 9 0 9
        create_box 1 cell bond/types 1 extra/bond/per/atom 1 extra/special/per/atom 2
        create_atoms 1 single 1 1 1
        create_atoms 1 single 2 1 1
        mass 1 1.0
        create_bonds single/bond 1 1 2
        pair_style zero 2
        pair_coeff * *
        bond_style harmonic
        bond_coeff 1 1000 1.0
        fix 1 all nve
        timestep 0.005
        run 0

    Bad:
        atom_style bond
        region cell block 0 9 0 9 0 9
        create_box 1 cell bond/types 1 extra/bond/per/atom 1 extra/special/per/atom 2
        create_atoms 1 single 1 1 1
        create_atoms 1 single 2 1 1
        mass 1 1.0
        create_bonds single/bond 1 1 2
        pair_style zero 2
        pair_coeff * *
        bond_style harmonic
        bond_coeff 1 1000 1.0
        fix 1 all nve
        timestep 0.05
        run 0
    """

    code = "P111"
    name = "timestep-too-long"
    manual = "timestep.html"

    def __init__(self) -> None:
        self._place: Span | None = None

    def after(self, look: Look, words: list[Word]) -> None:
        if words[0].text == "timestep":
            self._place = words[-1].span

    def run(self, look: Look, scene: Scene, steps: int) -> None:
        sim = look.sim
        moving = any(
            fix.style.startswith(("nve", "nvt", "nph", "npt")) and fix.style != "nve/limit" for fix in sim.fixes
        )
        if sim.ran or sim.relaxing or not moving or sim.bond is None or not sim.has_bonds or sim.atoms.n > _SMALL:
            return
        for kind, style, omega in stiffest(sim):
            turn = omega * sim.dt
            if turn > _HALF:
                what = "diverges" if turn > BLOWS_UP else f"makes {2.0 * pi / turn:.2g} steps in a period"
                look.warn(
                    self, self._place, f"Bonds of type {kind} ({style}) swing with omega = {omega:.4g}: a timestep of {sim.dt:g} {what}",
                    f"timestep {0.1 / omega:.2g}",
                )  # fmt: skip
