"""The fast engine: the same physics several times faster, by vectors of eight atoms and without ghosts.

It keeps LAMMPS's atom order, its rebuild steps and its random streams, works in place on the atoms' arrays, and gives up one
thing only: the order in which forces are added up. Fixes, computes and output are those of the exact engine. A run that needs
something this engine lacks is carried out by the exact engine, and the log says why.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from pylmp.engines.announce import Announcer
from pylmp.engines.exact import Exact, Run
from pylmp.engines.fast_forces import FastForces
from pylmp.engines.fast_ghosts import GhostRun, wants_ghosts
from pylmp.engines.guests import Guests
from pylmp.engines.leap import Leap
from pylmp.engines.renewal import Renewal
from pylmp.kernels.kinds import Function
from pylmp.model.atoms import Ints
from pylmp.model.box import extremes
from pylmp.model.engine import RunPlan, RunReport
from pylmp.model.ghosts import ghost_cutoff
from pylmp.model.lost import remove_lost, warn_image_flags, warn_small_box
from pylmp.model.minimize import MinPlan, MinReport
from pylmp.model.scene import Scene
from pylmp.model.simulation import Simulation


def obstacles(sim: Simulation) -> list[str]:
    """What of this simulation the fast engine lacks, in words; empty: it can run it."""
    return _pair_obstacles(sim) + _bond_obstacles(sim)


def _pair_obstacles(sim: Simulation) -> list[str]:
    found = []
    for part in sim.pair.working if sim.pair else []:
        if part.style.data is not None or part.style.watch is not None:
            found.append(f"pair_style {part.style.name}")
        if sim.has_bonds and part.settings.lj not in (None, sim.special.lj):
            found.append("pair_modify special")
    if sim.pair and not all(part.settings.compute for part in sim.pair.parts) and any(part.style.subtract_pair for part in (sim.bond.parts if sim.bond else [])):
        found.append(f"pair_modify compute no with bond_style {sim.bond.name}")
    return found


def _bond_obstacles(sim: Simulation) -> list[str]:
    parts, found = sim.bond.parts if sim.bond else [], []
    for part in parts:
        if len(parts) > 1 and part.style.misplaces and not part.stored:
            found.append(f"what LAMMPS mixes up of bond_style {part.style.name} under hybrid in the first run")
        if part.style.volumes(part.options):
            found.append(f"bond_style {part.style.name} volume/factor yes")
        elif part.style.read is not None:
            found.append(f"bond_style {part.style.name}")
    return found


class Fast:
    """Runs a simulation on vectors where it can, else as the exact engine does."""

    name = "fast"

    def __init__(self, announcer: Announcer | None = None) -> None:
        self._announcer = announcer
        self._exact = Exact(announcer)

    def run(self, sim: Simulation, scene: Scene, plan: RunPlan) -> RunReport:
        if not plan.setup and isinstance(sim.lists, Run):
            return self._exact.run(sim, scene, plan)
        if lacking := obstacles(sim):
            self._say(sim, ", ".join(lacking))
            return self._exact.run(sim, scene, plan)
        sim.lists = GhostRun(sim) if wants_ghosts(sim) else FastRun(sim)
        if self._announcer:
            self._announcer.say(sim, self.name, sim.lists.kernels)
        sim.lists.setup()
        if self._announcer:
            self._announcer.heed(sim)
        report: RunReport = sim.lists.advance(plan.steps)
        return report

    def minimize(self, sim: Simulation, scene: Scene, plan: MinPlan) -> tuple[RunReport, MinReport]:
        self._say(sim, "minimize")
        return self._exact.minimize(sim, scene, plan)

    def replay(self, sim: Simulation, scene: Scene, frames: Iterator[None]) -> RunReport:
        self._say(sim, "rerun")
        return self._exact.replay(sim, scene, frames)

    @staticmethod
    def _say(sim: Simulation, lacking: str) -> None:
        sim.console.both(f"Engine exact for this run: engine fast lacks {lacking}\n")


class NoGhosts:
    """Periodic images are found from the positions themselves. first: row of each ID, for those who look for one."""

    def __init__(self) -> None:
        self.first: Ints = np.zeros(0, np.int64)

    def functions(self) -> list[Function]:
        return []


class FastRun(GhostRun):
    """A run of the fast engine without ghosts."""

    occasional: Guests

    def __init__(self, sim: Simulation) -> None:
        self.leap, self.renewal = Leap(), Renewal()
        self.end = 0
        super().__init__(sim)

    @staticmethod
    def _field(sim: Simulation) -> tuple[Any, Any]:
        return NoGhosts(), FastForces(sim)

    def _lists_of_computes(self, sim: Simulation) -> Guests:
        return Guests(sim, self._rebind)

    def _rebind(self) -> None:
        """The arrays of the atoms moved."""
        self.call("post_neighbor")
        self.forces.bind(self.sim)
        self.renewal.forget()
        self.leap.forget()

    def renew(self) -> None:
        """All lists are built anew where somebody has moved too far."""
        if not self._must_rebuild():
            self.timers.stamp("Neigh")
        elif self.renewal.go(self.sim.step):
            self.renewed(1)
        else:
            self._rebuild(setup=False)

    def renewed(self, builds: int) -> None:
        """Lists were made anew, rows are what they were."""
        self.occasional.forget()
        self.ago = 0
        self.builds += builds
        self.timers.stamp("Neigh")

    @property
    def sorts(self) -> bool:
        sort = self.sim.sort
        return bool(sort.every and (sort.bin_size or self.sim.neighbor_cutoff > 0.0))

    def _rebuild(self, setup: bool, sort: bool = True) -> None:
        """Wrap, sort, lists. Bonds stay as they are laid out until atoms change places."""
        sim, atoms, box = self.sim, self.sim.atoms, self.sim.box
        if not setup:
            self.call("pre_exchange")
        if setup and sort and self.sorts:
            self.sorter.set_up(sim)
        atoms.clear_ghosts()
        box.wrap(atoms)
        self.forces.measure(sim)
        if box.shrinks(atoms, sim.natoms):
            box.shrink_to(*extremes(np.stack([self.forces.least, self.forces.most])))
        leaving = bool(((self.forces.least < box.lo) | (self.forces.most >= box.hi)).any())
        sorting = sort and self.sorts and (setup or sim.step >= self.sorter.next)
        if setup or leaving or sorting:
            if not setup:
                self.forces.copy_back(sim)
            self.forces.moved_rows()
        if leaving:
            remove_lost(sim)
            self.forces.measure(sim)  # without those, who may be very far away
        if sorting:
            self.sorter.sort(sim)
        self.timers.stamp("Comm")
        if setup:
            ghost_cutoff(sim)
            warn_image_flags(sim)
            if sort:
                warn_small_box(sim)
        self.occasional.make_room(sim)
        self.forces.rebuild(sim)
        self.ghosts.first = self.forces.by_tag
        self.occasional.forget()
        self.ago = 0
        self.builds += 1
        self.call("post_neighbor")
        self.renewal.bind(self)
        self.leap.forget()
        self.timers.stamp("Neigh")

    def advance(self, steps: int) -> RunReport:
        self.end = self.sim.step + steps
        self.renewal.forget()
        self.leap.forget()  # what fixes do, and whatever arrays hold, may have been changed since the last run
        return super().advance(steps)

    def step(self) -> None:
        """A step, or many that need nothing of Python."""
        self.forces.alone(self.sim)
        if not self.leap.go(self, self.end):
            super().step()
