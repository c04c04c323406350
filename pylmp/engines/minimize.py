"""Minimization on the exact engine: the energy of the atoms as a function of where they stand, and the loop over iterations."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from pylmp.model.asking import ENERGY
from pylmp.model.fix import hooks
from pylmp.model.minimize import MAX_ITERATIONS, OUT_OF_TIME, Minimizer, MinPlan, MinReport, dot, largest_force
from pylmp.model.registry import MINIMIZERS

if TYPE_CHECKING:
    from pylmp.engines.exact import Run


class Relaxation:
    """Drives a min style over a run's lists and forces. Only fixes that act in minimizations do."""

    def __init__(self, run: Run) -> None:
        self.run = run
        self.sim = run.sim
        self.fixes = sorted((fix for fix in self.sim.fixes if fix.minimizes), key=lambda fix: not fix.leads)
        self._wanted = ENERGY

    def setup(self, plan: MinPlan) -> None:
        """Forces, energy and output of the start."""
        sim = self.sim
        style = MINIMIZERS.find(sim.minimizing.style)
        assert style is not None
        self.minimizer: Minimizer = style(sim, plan, self, 0.0)
        self.run.begin(
            f"Setting up {sim.minimizing.style} style minimization ...\n  Unit style    : {sim.units.name}\n"
            f"  Current step  : {sim.step}\n"
        )
        for fix in self.fixes:
            fix.min_setup(sim)
        self.minimizer.prepare()
        sim.console.both(self.minimizer.describe())
        sim.output.setup(sim)
        self.minimizer.energy = self._energy()
        self.run.timers.clear()

    def evaluate(self) -> float:
        """Neighbor lists where somebody moved too far, forces, energy."""
        run, sim = self.run, self.sim
        run.renew()
        run.forces_at(self._wanted)
        for fix in self.fixes:
            fix.min_post_force(sim)
        run.timers.stamp("Modify")
        return self._energy()

    def _energy(self) -> float:
        sim = self.sim
        energy = float(sim.computes[sim.output.thermo.pe].scalar(sim))  # type: ignore[attr-defined]
        return energy / sim.natoms if sim.output.thermo.normed else energy

    def iterate(self, plan: MinPlan) -> MinReport:
        """Iterate until something says stop. Each iteration counts as a step; the last one is always in the output."""
        sim, minimizer = self.sim, self.minimizer
        f = sim.atoms.f
        first = minimizer.energy
        norm, largest = math.sqrt(dot(minimizer.f, minimizer.f)), largest_force(f[: sim.atoms.n])
        minimizer.begin()
        minimizer.previous = first
        criterion = self._loop(plan)
        if criterion != MAX_ITERATIONS:
            sim.output.last = sim.step
            sim.asking.everyone(sim.step)
            self._wanted = sim.asking.take(sim.step) | ENERGY
            minimizer.energy = self.evaluate()
            sim.output.write_all(sim)
            self.run.timers.stamp("Output")
        minimizer.end()
        for hook in hooks(sim.fixes, "post_run"):
            hook(sim)
        return MinReport(
            criterion=criterion, energies=(first, minimizer.previous, minimizer.energy),
            norms=(norm, math.sqrt(dot(minimizer.f, minimizer.f))), largest=(largest, largest_force(minimizer.f)),
            alpha=minimizer.alpha, iterations=minimizer.iterations, evaluations=minimizer.count,
        )  # fmt: skip

    def _loop(self, plan: MinPlan) -> str:
        sim, minimizer = self.sim, self.minimizer
        for _ in range(plan.maxiter):
            if sim.halted:
                return OUT_OF_TIME
            sim.step += 1
            minimizer.iterations += 1
            self._wanted = sim.asking.take(sim.step) | ENERGY
            criterion = minimizer.iterate()
            if criterion:
                return criterion
            if sim.output.due(sim):
                sim.output.write(sim)
                self.run.timers.stamp("Output")
            if sim.interrupts.number:
                return "interrupted"
        return MAX_ITERATIONS
