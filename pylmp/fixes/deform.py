"""fix ID GROUP deform N parameter values ... [remap x|v|none] [flip yes|no] [units lattice|box]: the box changes during the run.

    x|y|z      final lo hi | delta dlo dhi | scale f | vel V | erate R | trate R | volume | wiggle A T | variable v_shift v_rate
    xy|xz|yz   final tilt | delta d | vel V | erate R | trate R | wiggle A T | variable v_shift v_rate

remap x: atoms of the group keep their places relative to the box; remap v: they keep their positions, and velocities change where
they cross a periodic face. A tilt of more than half a box length is flipped to its periodic image. Rates refer to the box at the
start of each run. Source: LAMMPS manual, fix_deform.html; order of operations as measured on LAMMPS 22 Jul 2025.
"""

from __future__ import annotations

import math
from contextlib import nullcontext

import numpy as np

from pylmp.kernels.exact.wrapping import ten_bits
from pylmp.model.deformation import ALONG, Change, Start, pack, read_change, unpack, volume_shares
from pylmp.model.fix import Fix
from pylmp.model.registry import FIXES
from pylmp.model.simulation import Simulation
from pylmp.model.triclinic import SKEW, Triclinic
from pylmp.text.diagnostic import ScriptError
from pylmp.text.words import Args

_NAMES = "x", "y", "z", "yz", "xz", "xy"  # as in box.h
_HALF = 0.5


@FIXES.register("deform")
class Deform(Fix):
    style = "deform"

    def __init__(self, sim: Simulation, identity: str, group: str, bit: int, args: Args) -> None:
        super().__init__(sim, identity, group, bit, args)
        self.every = args.integer()
        if self.every <= 0:
            args.fail("Fix deform Nevery must be > 0", hint="every so many steps")
        self.changes: dict[int, Change] = {}
        while (word := args.peek()) is not None and word.text in _NAMES:
            name = args.word()
            k = _NAMES.index(name.text)
            if k > 2 and not sim.box.triclinic:
                args.fail("Fix deform tilt factors require triclinic box", name, hint="region prism, or change_box triclinic")
            self.changes[k] = read_change(args, tilt=k > 2)
        self.remap, lattice = "x", True
        self.flips = any(k > 2 for k in self.changes)
        while len(args):
            key = args.word()
            if key.text not in ("remap", "flip", "units"):
                args.fail(f"Unknown fix deform keyword: {key.text}", key, hint=" ".join([*_NAMES, "remap flip units"]))
            args.need(1, key.text)
            if key.text == "flip":
                self.flips = args.yes() and self.flips
                continue
            value = args.word()
            allowed = ("x", "v", "none") if key.text == "remap" else ("box", "lattice")
            if value.text not in allowed:
                args.fail(f"Illegal fix deform {key.text} command: {value.text}", value, hint=" ".join(allowed))
            if key.text == "remap":
                self.remap = value.text
            else:
                lattice = value.text == "lattice"
        for k, change in self.changes.items():
            if k < 3 and any(letter in "sm" for letter in sim.box.boundary[k]):
                args.fail("Cannot use fix deform on a shrink-wrapped boundary", args.owner)
            if k > 2 and any(letter in "sm" for letter in sim.box.boundary[ALONG[k][1]]):
                args.fail("Cannot use fix deform tilt on a shrink-wrapped 2nd dim", args.owner)
            if lattice:
                change.scale(sim.spacing[ALONG[k][0]])
        self.shares = volume_shares(args, self.changes)
        self.changes_box = bool(self.changes)
        self.varies = any(change.names for change in self.changes.values())
        self.flipped: tuple[int, int, int] | None = None
        self.first = self.start = Start.of(sim.box)

    # ---- restart files --------------------------------------------------------------------------------------

    def state(self, sim: Simulation) -> bytes:
        return pack(self.changes, self.shares, self.first)

    def restore(self, sim: Simulation, state: bytes) -> None:
        self.first = unpack(self.changes, self.shares, state)

    # ---- a run begins ---------------------------------------------------------------------------------------

    def init(self, sim: Simulation) -> None:
        """Where everything is at the end of this run."""
        if sum(fix.style == "deform" for fix in sim.fixes) > 1:
            raise ScriptError("More than one fix deform", hint="one fix deform takes several directions")
        for change in self.changes.values():
            change.check(sim)
        # A later part of a ramp starts where the box was when the fix was defined. Other commands than runs take no time.
        running = sim.output.running
        self.start = self.first if running and sim.step != sim.begin else Start.of(sim.box)
        time = (sim.end - sim.begin) * sim.dt if running else 0.0
        for k, change in sorted(self.changes.items()):
            if k < 3:
                change.plan_faces(*self.start.faces[k], time)
            else:
                a, b = self.start.faces[ALONG[k][1]]
                change.plan_tilt(self.start.tilt[k - 3], b - a, time)
        self._check_yz()
        box = sim.box
        if self.remap == "v":
            box.rate_group = self.bit
        box.rate[:] = 0.0
        for k, change in self.changes.items():
            box.rate[k] = change.rate_at_start(self.start.faces[k] if k < 3 else (self.start.tilt[k - 3],), time)

    def _check_yz(self) -> None:
        """A yz flip would move xz by xy, which changes too."""
        if 3 not in self.changes or 5 not in self.changes or not self.flips:
            return
        if self.changes[3].style == "variable":
            raise ScriptError("Fix deform cannot use yz variable with xy", hint="flip no")
        least, most = self.changes[3].extremes
        lengths = [hi - lo for lo, hi in (self.start.faces[1], *([self.changes[1].stop] if 1 in self.changes else []))]
        if any(least < -SKEW * length or most > SKEW * length for length in lengths):
            raise ScriptError("Fix deform is changing yz too much with xy", hint="flip no, or yz within half a box length")

    # ---- every so many steps ----------------------------------------------------------------------------------

    def end_of_step(self, sim: Simulation) -> None:
        """The new box; with remap x the group's atoms pass through fractions, also in directions that do not change."""
        box, atoms = sim.box, sim.atoms
        with self.reading(sim, sim.step + self.every) if self.varies else nullcontext():
            lo, hi, tilt = self._target(sim)
        if isinstance(box, Triclinic):
            self._bring_near(box, lo, hi, tilt)
            self._plan_flip(sim, box, lo, hi, tilt)
        rows = self.members(sim) if self.remap == "x" else np.zeros(atoms.n, bool)
        x = atoms.x[: atoms.n]
        fractions = box.fractions(x[rows])
        for k in range(3):
            if k not in self.changes:
                lo[k], hi[k] = box.lo[k], box.hi[k]
            if k + 3 not in self.changes:
                tilt[k] = box.h[k + 3]
        box.place(np.array(lo), np.array(hi), np.array(tilt[::-1]))
        if self.remap == "x":
            x[rows] = box.positions(fractions)

    def _target(self, sim: Simulation) -> tuple[list[float], list[float], list[float]]:
        """lo, hi, and yz xz xy, that the parameters ask for now."""
        box = sim.box
        part = float(sim.step - sim.begin)
        if part != 0.0:
            part /= sim.end - sim.begin
        elapsed = (sim.step - sim.begin) * sim.dt
        lo, hi, tilt = box.lo.tolist(), box.hi.tolist(), box.h[3:].tolist()
        for k, change in sorted(self.changes.items()):
            if k > 2:
                tilt[k - 3] = change.tilt(sim, self.start.tilt[k - 3], part, elapsed)
            elif change.style != "volume":
                lo[k], hi[k] = change.faces(sim, *self.start.faces[k], part, elapsed)
            box.rate[k] = change.rate(sim, float(box.h[k]), elapsed, float(box.rate[k]))
        for k, share in self.shares.items():
            a, b = self.start.faces[k]
            leader, (c, d) = hi[share.leader] - lo[share.leader], self.start.faces[share.other]
            other = hi[share.other] - lo[share.other] if share.role == "leads" else d - c
            if share.role == "follows":
                shift = _HALF * math.sqrt(self.start.volume * (b - a) / leader / other)
            else:
                shift = _HALF * (self.start.volume / leader / other)
            lo[k], hi[k] = _HALF * (a + b) - shift, _HALF * (a + b) + shift
            box.rate[k] = (2.0 * shift / box.h[k] - 1.0) / sim.dt  # of a length LAMMPS takes the strain rate here (measured)
        return lo, hi, tilt

    @staticmethod
    def _bring_near(box: Triclinic, lo: list[float], hi: list[float], tilt: list[float]) -> None:
        """Each tilt to that periodic image of its target that is nearest to the tilt of the box."""
        for k, along in ((0, 1), (1, 0), (2, 0)):
            length = hi[along] - lo[along]
            now = float(box.h[3 + k] / box.h[along])
            while tilt[k] / length - now > 0.0:
                tilt[k] -= length
            while tilt[k] / length - now < 0.0:
                tilt[k] += length
            if abs(tilt[k] / length - 1.0 - now) < abs(tilt[k] / length - now):
                tilt[k] -= length

    # ---- flips ------------------------------------------------------------------------------------------------

    def _plan_flip(self, sim: Simulation, box: Triclinic, lo: list[float], hi: list[float], tilt: list[float]) -> None:
        """If a tilt has become too large, its flip is due at the start of the next step, which rebuilds everything."""
        lx, ly = hi[0] - lo[0], hi[1] - lo[1]
        x, y = 1.0 / lx, 1.0 / ly
        yz, xz, xy = tilt
        if not self.flips or max(abs(yz * y), abs(xz * x), abs(xy * x)) <= SKEW:
            return
        along_x, along_y, _ = box.periodic
        n_yz = n_xz = n_xy = 0
        if along_y and abs(yz * y) > SKEW:
            n_yz = 1 if yz < 0.0 else -1
            yz, xz = yz + n_yz * ly, xz + n_yz * xy
        if along_x and abs(xz * x) > SKEW:
            n_xz = 1 if xz < 0.0 else -1
            xz += n_xz * lx
        if along_x and abs(xy * x) > SKEW:
            n_xy = 1 if xy < 0.0 else -1
            xy += n_xy * lx
        if n_yz or n_xz or n_xy:
            self.flipped = n_yz, n_xz, n_xy
            self._flip_to = np.array([xy, xz, yz])
            self.next_rebuild = sim.step + 1

    def pre_exchange(self, sim: Simulation) -> None:
        """The same lattice by other cell vectors: image flags count the new ones."""
        if self.flipped is None:
            return
        box, atoms = sim.box, sim.atoms
        n_yz, n_xz, n_xy = self.flipped
        self.flipped = None
        box.place(box.lo.copy(), box.hi.copy(), self._flip_to)
        x, image = atoms.x[: atoms.n], atoms.image[: atoms.n]
        image[:, 1] -= n_yz * image[:, 2]
        image[:, 0] -= n_xy * image[:, 1] + n_xz * image[:, 2]
        image[:] = ten_bits(image)
        box.remap(x, image)
        box.enter(x)
        box.leave(x)
