"""The exact engine: one rank of LAMMPS, in the order in which LAMMPS does things, equal to the last bit.

This is also the engine to read: velocity Verlet with neighbor lists, one method a phase.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any, TypeVar

from pylmp.engines.announce import Announcer
from pylmp.engines.force_field import ForceField
from pylmp.engines.minimize import Relaxation
from pylmp.engines.replay import replay
from pylmp.engines.timers import Timers
from pylmp.model.appetite import check_appetite, make_room
from pylmp.model.bondlist import Breaks
from pylmp.model.engine import RunPlan, RunReport
from pylmp.model.fix import STEP_HOOKS, hooks
from pylmp.model.ghosts import Ghosts, ghost_cutoff
from pylmp.model.lost import remove_lost, warn_image_flags, warn_small_box
from pylmp.model.minimize import MinPlan, MinReport
from pylmp.model.occasional import Occasional
from pylmp.model.sanity import check_finite
from pylmp.model.scene import Scene
from pylmp.model.simulation import Simulation
from pylmp.model.sorting import Sorter

T = TypeVar("T")


class Exact:
    """Runs a simulation as LAMMPS would on one process."""

    name = "exact"

    def __init__(self, announcer: Announcer | None = None) -> None:
        self._announcer = announcer

    def run(self, sim: Simulation, scene: Scene, plan: RunPlan) -> RunReport:
        """Set up (unless plan says not to), advance plan.steps steps, report."""
        if plan.setup or not isinstance(sim.lists, Run):
            sim.lists = Run(sim)
            self._announce(sim)
            sim.lists.setup()
            if self._announcer:
                self._announcer.heed(sim)
        else:
            sim.output.setup(sim)
        return sim.lists.advance(plan.steps)

    def minimize(self, sim: Simulation, scene: Scene, plan: MinPlan) -> tuple[RunReport, MinReport]:
        """Set up, iterate, report."""
        sim.lists = Run(sim)
        self._announce(sim)
        relaxation = Relaxation(sim.lists)
        relaxation.setup(plan)
        return sim.lists.timed(lambda: relaxation.iterate(plan))

    def replay(self, sim: Simulation, scene: Scene, frames: Iterator[None]) -> RunReport:
        """Lists, forces and output of each state."""
        sim.lists = Run(sim)
        self._announce(sim)
        return replay(sim.lists, frames)

    def _announce(self, sim: Simulation) -> None:
        if self._announcer:
            self._announcer.say(sim, self.name, sim.lists.kernels)


class Run:
    """The lists and bound kernels of a run, and the loop over its steps."""

    def __init__(self, sim: Simulation) -> None:
        self.sim = sim
        self.timers = Timers(sim.timer.style == "full")
        self.sorter = Sorter()
        self.breaks = sim.breaks = sim.breaks if isinstance(sim.breaks, Breaks) else Breaks()
        before = sim.bond_lists  # of an earlier run: they know what bonds remember since the last copy
        self.ghosts, self.forces = self._field(sim)
        self.occasional = self._lists_of_computes(sim)
        self.kernels = self.forces.prepare(sim, self.occasional.functions())
        for listed in before:
            listed.copy_back(sim)
        sim.bond_lists = self.forces.bonds
        self.hooks: dict[str, list[Any]] = {}
        self._first: list[Any] = []
        self._last: list[Any] = []
        self.builds = self.dangerous = self.ago = 0

    @staticmethod
    def _field(sim: Simulation) -> tuple[Any, Any]:
        """The ghosts and the force field of this engine."""
        ghosts = Ghosts(sim)
        return ghosts, ForceField(sim, ghosts)

    def _lists_of_computes(self, sim: Simulation) -> Occasional:
        return Occasional(sim, self.forces.lists.whole if self.forces.lists else None)

    # ---- set-up ---------------------------------------------------------------------------------------------

    def setup(self) -> None:
        sim = self.sim
        self.begin(
            f"Setting up Verlet run ...\n  Unit style    : {sim.units.name}\n  Current step  : {sim.step}\n"
            f"  Time step     : {sim.dt:.8g}\n" + sim.timer.notice
        )
        for hook in hooks(sim.fixes, "setup"):
            hook(sim)
        sim.output.setup(sim)
        self.timers.clear()

    def begin(self, title: str) -> None:
        """Lists and forces of the first step; title: what the screen is told."""
        sim = self.sim
        self.bind_hooks()
        sim.console.screen(title)
        if sim.pair is None and sim.sort.every and not sim.sort.bin_size:
            sim.console.warning("No pairwise cutoff or binsize set. Atom sorting therefore disabled.")
            sim.sort.every = 0  # for good: a pair style that comes later does not bring it back
        ghost_cutoff(sim, warn=True, setup=True)
        make_room(sim)
        check_appetite(sim)
        self.start_over(sort=True)

    def bind_hooks(self) -> None:
        """What the fixes do in a step, found once."""
        self.hooks = {name: hooks(self.sim.fixes, name) for name in STEP_HOOKS}
        self._first = self.hooks["initial_integrate"] + self.hooks["post_integrate"]
        self._last = self.hooks["post_force"] + self.hooks["final_integrate"]

    def start_over(self, sort: bool) -> None:
        """New lists, and forces as a set-up sums them."""
        sim = self.sim
        self._rebuild(setup=True, sort=sort)
        self.builds = self.dangerous = 0
        self._forces(sim.asking.take(sim.step), setup=True)
        for compute in sim.computes.values():
            compute.setup(sim)

    # ---- one step -------------------------------------------------------------------------------------------

    def step(self) -> None:
        """Velocity Verlet: half kick and drift, neighbors, forces, half kick."""
        sim = self.sim
        sim.step += 1
        for hook in self._first:
            hook(sim)
        self.timers.stamp("Modify")
        self.renew()
        self._forces(sim.asking.take(sim.step), setup=False)
        for hook in self._last:
            hook(sim)
        self.call("end_of_step")
        self.timers.stamp("Modify")

    def renew(self) -> None:
        """Ghosts follow their atoms, or all lists are built anew."""
        if self._must_rebuild():
            self._rebuild(setup=False)
        else:
            self.timers.stamp("Neigh")
            self.refresh()
            self.timers.stamp("Comm")

    def forces_at(self, wanted: int) -> None:
        """Forces of the present positions, and what is wanted besides (ENERGY | VIRIAL | ...)."""
        self._forces(wanted, setup=False)

    def call(self, name: str) -> None:
        sim = self.sim
        for hook in self.hooks[name]:
            if name == "end_of_step" and sim.step % hook.__self__.every:
                continue
            hook(sim)

    def _forces(self, wanted: int, setup: bool) -> None:
        sim, timers = self.sim, self.timers
        self.forces.clear()
        if wanted and (wanted := self.forces.able(wanted)):
            sim.tally.step, sim.tally.wanted = sim.step, wanted
        if setup:
            for hook in hooks(sim.fixes, "setup_pre_force"):
                hook(sim)
        else:
            if self.breaks.flagged:
                self.breaks.clear_flags(sim, self.forces.lists, self.ghosts)
            if self.hooks["pre_force"] and not sim.relaxing:
                self.call("pre_force")
                timers.stamp("Modify")
        self.forces.pairs(sim, wanted, setup)
        timers.stamp("Pair")
        if wanted or self.forces.bonds:
            self.forces.bonded(sim, wanted, setup, self.breaks)
            timers.stamp("Bond")
        if sim.newton_pair or sim.newton_bond:
            self.reverse()
            timers.stamp("Comm")

    # ---- neighbor lists -------------------------------------------------------------------------------------

    def _must_rebuild(self) -> bool:
        """A restart file is due or a fix wants it; else neigh_modify's every, delay and check: moved more than half the skin since the last build?"""
        sim, settings = self.sim, self.sim.neighbor
        if sim.output.restarts is not None and sim.output.restarts.due == sim.step:
            return True  # a restart file will be written: LAMMPS has all atoms in the box then
        for fix in sim.fixes:
            if fix.next_rebuild == sim.step:
                return True
        self.ago += 1
        if settings.once or self.ago < settings.delay or self.ago % settings.every:
            return False
        if not settings.check:
            return True
        moved = self.forces.anybody_moved(sim)
        if moved and self.ago == max(settings.every, settings.delay):
            self.dangerous += 1
        return moved

    def _rebuild(self, setup: bool, sort: bool = True) -> None:
        """Wrap, sort, ghosts, lists, in LAMMPS's order; up to the ghosts in frame coordinates."""
        sim, atoms = self.sim, self.sim.atoms
        for listed in [] if setup else self.forces.bonds:
            listed.copy_back(sim)
        self.breaks.edit_special(sim)
        if not setup:
            self.call("pre_exchange")
        sorts = sort and sim.sort.every and (sim.sort.bin_size or sim.neighbor_cutoff > 0.0)
        if setup and sorts:
            self.sorter.set_up(sim)
        atoms.clear_ghosts()
        sim.box.enter(atoms.x[: atoms.n])
        sim.box.wrap(atoms)
        sim.box.shrink(atoms, sim.natoms)
        remove_lost(sim)
        if sorts and (setup or sim.step >= self.sorter.next):
            self.sorter.sort(sim)
        self.timers.stamp("Comm")
        cutoff = ghost_cutoff(sim, warn=sim.box.changing and not setup)
        self.ghosts.build(sim, cutoff)
        sim.box.leave(atoms.x[: atoms.total])
        self.timers.stamp("Comm")
        if setup:
            warn_image_flags(sim)
            if sort:
                warn_small_box(sim)
        self.forces.rebuild(sim, cutoff)
        self.occasional.forget()
        self.refresh = self.ghosts.bind_refresh(sim)
        self.reverse = self.ghosts.bind_reverse(sim)
        self.ago = 0
        self.builds += 1
        self.call("post_neighbor")
        self.timers.stamp("Neigh")

    # ---- the loop -------------------------------------------------------------------------------------------

    def advance(self, steps: int) -> RunReport:
        """Run steps steps, writing output when it is due. An interrupt ends the run after the current step."""
        sim, end = self.sim, self.sim.step + steps

        def loop() -> None:
            while sim.step < end and not sim.interrupts.number:
                self.step()
                if sim.output.due(sim):
                    sim.output.write(sim)
                    if sim.watchful:
                        check_finite(sim)
                    self.timers.stamp("Output")
                if sim.halted:
                    break

        return self.timed(loop)[0]

    def timed(self, loop: Callable[[], T]) -> tuple[RunReport, T]:
        """Carry out loop, then what ends a run."""
        sim, first = self.sim, self.sim.step
        with sim.interrupts.listen():
            self.timers.clear()
            result = loop()
        self.breaks.edit_special(sim)
        self.call("post_run")
        warn_small_box(sim)
        report = RunReport(
            steps=sim.step - first, seconds=self.timers.total(), sections=self.timers.sections, processor=self.timers.processor,
            neighbors=self._neighbors(), ghosts=sim.atoms.ghosts,
            builds=self.builds, dangerous=self.dangerous,
            full_neighbors=self._full_neighbors(),
        )  # fmt: skip
        return report, result

    def _neighbors(self) -> int:
        """Entries of a half list of all types: a pair style's, or a compute's."""
        own = self.forces.lists.half if self.forces.lists else 0
        return self.occasional.half_count if own is None else own

    def _full_neighbors(self) -> int | None:
        """Entries of a full list: a pair style's, or a compute's."""
        own = self.forces.lists.full if self.forces.lists else None
        return self.occasional.full_count if own is None else own
