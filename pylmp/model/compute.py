"""What a compute is: a quantity measured when somebody asks for it."""

from __future__ import annotations

import functools
from collections.abc import Callable
from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from pylmp.model.fix import BIRTHS

if TYPE_CHECKING:
    from pylmp.model.simulation import Simulation
    from pylmp.model.wish import Wish
    from pylmp.text.words import Args

KINDS = ("scalar", "vector", "array", "per_atom", "local")


class Compute:
    """Base of every compute style. A subclass defines what it offers:

    scalar(sim) -> float
    vector(sim) -> (k,) float64; length: k
    array(sim) -> (k, m) float64; length: k, columns: m
    per_atom(sim) -> (n,) or (n, k) float64 over owned atoms in local order (0 outside the group); columns: k, 0 for a vector
    local(sim) -> (rows,) or (rows, k) float64; columns

    Consumers call current(sim, compute, kind), so that it is evaluated once in a block (model/asking.py). Calling a method
    evaluates anew; both note the step and the value.

    extensive_scalar extensive_vector extensive_array  thermo divides them by the number of atoms when norm is on
    varying    the length of its vector, the rows of its array may change
    tallies    what the engine must sum on the steps that ask for it: ENERGY | VIRIAL | ATOM_ENERGY | ATOM_VIRIAL
    extra_dof recount   as compute_modify said: degrees of freedom taken off, whether they are counted at every evaluation
    dynamic    recount, as it was when the last run began
    invoked    kind -> (step, value) of the last evaluation of this run
    evaluated  kind -> value of the current block
    """

    style: ClassVar[str] = ""
    extensive_scalar = False
    extensive_vector = False
    extensive_array = False
    varying = False
    tallies = 0
    extra_dof = 0.0
    recount = dynamic = False
    ready = False  # a run was set up since its definition

    def __init__(self, sim: Simulation, identity: str, group: str, bit: int, args: Args) -> None:
        self.id = identity
        self.group = group
        self.bit = bit
        self.born = next(BIRTHS)
        self.invoked: dict[str, tuple[int, Any]] = {}
        self.evaluated: dict[str, Any] = {}

    def __init_subclass__(cls) -> None:
        """Every evaluation is noted, whoever asks for it."""
        for kind in KINDS:
            if callable(measure := vars(cls).get(kind)):
                setattr(cls, kind, _noting(kind, measure))

    def init(self, sim: Simulation) -> None:
        """Called at the start of every run."""

    @property
    def store(self) -> str:
        """The ID under which restart files hold its state and atom_state."""
        return f"{self.id}_COMPUTE_STORE"

    def state(self, sim: Simulation) -> bytes | None:
        """What a restart file keeps of it, as LAMMPS lays it out; None: nothing."""
        return None

    def restore(self, sim: Simulation, state: bytes) -> None:
        """Go on from state."""

    def atom_state(self, sim: Simulation) -> NDArray[np.float64] | None:
        """(n, k) what a restart file keeps of it with each atom; None: nothing."""
        return None

    def restore_atoms(self, sim: Simulation, values: NDArray[np.float64]) -> None:
        """Go on from values (n, k)."""

    def wish(self, sim: Simulation) -> Wish | None:
        """The neighbor list it uses, None for none."""
        return None

    def setup(self, sim: Simulation) -> None:
        """Called in the set-up of every run, once the forces are known."""

    def removed(self, sim: Simulation) -> None:
        """It was deleted: undo what its definition made."""

    def group_varies(self, sim: Simulation) -> bool:
        """Atoms come and go by the definition of its group."""
        return self.group in sim.groups.dynamic

    def members(self, sim: Simulation) -> NDArray[np.bool_]:
        """(n,) bool: the owned atoms of this compute's group."""
        return (sim.atoms.mask[: sim.atoms.n] & self.bit) != 0

    def at_step(self, sim: Simulation, kind: str) -> Any:
        """Its value of the current step: that of an earlier evaluation at this step, else a new one."""
        step, value = self.invoked.get(kind, (-1, None))
        return value if step == sim.step else getattr(self, kind)(sim)


def _noting(kind: str, measure: Callable[..., Any]) -> Callable[..., Any]:
    @functools.wraps(measure)
    def method(self: Compute, sim: Simulation) -> Any:
        value = measure(self, sim)
        self.invoked[kind] = sim.step, value
        return value

    return method


def current(sim: Simulation, source: Any, kind: str) -> Any:
    """What a compute or fix is worth in the current block: a compute is evaluated at most once."""
    if not isinstance(source, Compute):
        return getattr(source, kind)(sim)
    if kind not in source.evaluated:
        source.evaluated[kind] = getattr(source, kind)(sim)
    return source.evaluated[kind]
