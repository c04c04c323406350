"""What a minimization is: settings, the energy as a function of positions, and what its log says afterwards."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, ClassVar, Protocol

import numpy as np

from pylmp.model.atoms import Floats
from pylmp.model.sums import total

if TYPE_CHECKING:
    from pylmp.model.simulation import Simulation

MAX_ITERATIONS = "max iterations"
MAX_EVALUATIONS = "max force evaluations"
ENERGY_TOLERANCE = "energy tolerance"
FORCE_TOLERANCE = "force tolerance"
NOT_DOWNHILL = "search direction is not downhill"
ALPHA_IS_ZERO = "linesearch alpha is zero"
FORCES_ARE_ZERO = "forces are zero"
FACTORS_ARE_ZERO = "quadratic factors are zero"
OUT_OF_TIME = "walltime limit reached"
UPHILL = "max iterations with v.f negative"
TINY = 1.0e-8  # keeps the relative change of energy defined where the energy is 0


@dataclass
class MinSettings:
    """min_style and min_modify; the names are min_modify's keywords."""

    style: str = "cg"
    dmax: float = 0.1
    line: str = "quadratic"
    norm: str = "two"
    integrator: str = "eulerimplicit"
    tmax: float = 10.0
    tmin: float = 0.02
    delaystep: int = 20
    dtgrow: float = 1.1
    dtshrink: float = 0.5
    alpha0: float = 0.25
    alphashrink: float = 0.99
    vdfmax: int = 2000
    halfstepback: bool = True
    initialdelay: bool = True
    abcfire: bool = False


@dataclass
class MinPlan:
    """minimize's four numbers: tolerances of energy (relative) and force, most iterations, most force evaluations."""

    etol: float
    ftol: float
    maxiter: int
    maxeval: int


@dataclass
class MinReport:
    """What the log says of a minimization. energies: initial, next to last, final; norms, largest: of the force, initial, final."""

    criterion: str
    energies: tuple[float, float, float]
    norms: tuple[float, float]
    largest: tuple[float, float]
    alpha: float
    iterations: int
    evaluations: int


class Energy(Protocol):
    """The energy of the atoms where they stand, per atom where thermo_modify norm is on."""

    def evaluate(self) -> float:
        """Neighbor lists, forces (into atoms.f) and energy at the positions in atoms.x."""
        ...


@dataclass
class Minimizer:
    """Base of the min styles. A style defines iterate, and prepare and begin where it must.

    count   force evaluations; energy, previous: now and before the last iteration; alpha: step of the last line search
    """

    style: ClassVar[str] = ""
    sim: Simulation
    plan: MinPlan
    landscape: Energy
    energy: float
    count: int = 0
    iterations: int = 0
    alpha: float = 0.0
    previous: float = field(default=0.0, init=False)

    def prepare(self) -> None:
        """Called once, before the first output."""

    def begin(self) -> None:
        """Called once, with forces and energy of the start at hand."""

    def iterate(self) -> str | None:
        """One iteration; why the minimization stops, or None."""
        raise NotImplementedError

    def describe(self) -> str:
        """What the log says before the table."""
        return ""

    def end(self) -> None:
        """Put back what was changed."""

    @property
    def settings(self) -> MinSettings:
        return self.sim.minimizing

    # ---- views of the owned atoms: they move in memory when lists are rebuilt ------------------------------

    @property
    def x(self) -> Floats:
        return self.sim.atoms.x[: self.sim.atoms.n]

    @property
    def v(self) -> Floats:
        return self.sim.atoms.v[: self.sim.atoms.n]

    @property
    def f(self) -> Floats:
        return self.sim.atoms.f[: self.sim.atoms.n]

    def evaluate(self) -> float:
        """The energy here, counted."""
        self.count += 1
        return self.landscape.evaluate()

    def converged(self) -> str | None:
        """The two tolerances, energy first."""
        return self.energy_settled() or self.force_settled()

    def energy_settled(self) -> str | None:
        change, size = abs(self.energy - self.previous), abs(self.energy) + abs(self.previous) + TINY
        return ENERGY_TOLERANCE if change < self.plan.etol * 0.5 * size else None

    def force_settled(self) -> str | None:
        if self.plan.ftol <= 0.0:
            return None
        size2 = {"two": dot(self.f, self.f), "inf": largest_force(self.f) ** 2, "max": _longest2(self.f)}
        return FORCE_TOLERANCE if size2[self.settings.norm] < self.plan.ftol * self.plan.ftol else None


def dot(a: Floats, b: Floats) -> float:
    """Sum of products of two (n, 3) arrays, component by component, first to last."""
    return total((a * b).ravel())


def largest_force(f: Floats) -> float:
    """The largest component."""
    return float(np.abs(f).max()) if len(f) else 0.0


def _longest2(f: Floats) -> float:
    """The largest squared force on an atom."""
    return float((f[:, 0] * f[:, 0] + f[:, 1] * f[:, 1] + f[:, 2] * f[:, 2]).max()) if len(f) else 0.0
