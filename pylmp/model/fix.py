"""What a fix is: a value with hooks, called at fixed places of every step in the order of definition."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from itertools import count
from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from pylmp.model.settings import ATOM_VIRIAL, VIRIAL

if TYPE_CHECKING:
    from pylmp.model.simulation import Simulation
    from pylmp.text.words import Args, Word

# A fix defines only those it wants, each as hook(self, sim). The engine calls them in this order:
SETUP_HOOKS = ("init", "setup_pre_force", "setup")
STEP_HOOKS = (
    "initial_integrate", "post_integrate", "pre_exchange", "post_neighbor", "pre_force",
    "post_force", "final_integrate", "end_of_step", "post_run",
)  # fmt: skip

BIRTHS = count()  # LAMMPS's restart files list what fixes, computes and bond styles keep in the order of their definition


class Fix:
    """Base of every fix style. A style is a subclass in its own file, registered under its name.

    style   the name a script uses
    every   end_of_step runs on multiples of this step count
    pause   hooks that calls says nothing of do something on multiples of this step count only
    integrates    it moves atoms (LAMMPS warns when no fix of a run does)
    changes_box   it changes the box during the run
    next_rebuild  on this step the neighbor lists are made anew, whatever neigh_modify says
    minimizes     its post_force acts in minimize too
    has_energy has_virial   fix_modify may count its scalar in the potential energy, its virial in the pressure
    in_energy in_virial     it did
    virial_shares   (n, 6) what each owned atom adds to its virial, on steps that sum shares
    couples       its scalar is energy exchanged with a heat bath (thermo keyword ecouple)
    extensive_scalar extensive_vector   thermo divides them by the number of atoms when norm is on; a tuple: each component
    length        components of its vector
    leads         its post_force comes before that of all others, its setup before all others and once more in its turn
    time_dependent   the step number cannot be reset while it is there
    compatible_every   what it offers is current on multiples of this step count only
    """

    style: ClassVar[str] = ""
    integrates: ClassVar[bool] = False
    minimizes: ClassVar[bool] = False
    has_energy: ClassVar[bool] = False
    has_virial: ClassVar[bool] = False
    couples: ClassVar[bool] = False
    changes_box: bool = False
    next_rebuild: int = -1
    extensive_scalar: bool = False
    extensive_vector: bool | tuple[bool, ...] = False
    time_dependent: ClassVar[bool] = False
    in_energy = in_virial = False
    virial_shares: Any = None
    compatible_every: int = 1
    leads: ClassVar[bool] = False
    every: int = 1
    pause: int = 1
    internal = False  # made by a style, not by a fix command
    born = 0

    def __init__(self, sim: Simulation, identity: str, group: str, bit: int, args: Args) -> None:
        """args holds the words after the style name; a subclass reads them all."""
        self.id = identity
        self.group = group
        self.bit = bit
        self.born = next(BIRTHS)

    # ---- restart files: a fix that keeps something in them says what, and takes it back when it is defined after read_restart

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

    def removed(self, sim: Simulation) -> None:
        """It was deleted, or another takes its place: undo what its definition made."""

    def modify(self, sim: Simulation, args: Args, key: Word) -> bool:
        """Carry out a fix_modify keyword of this style alone, taking its words; False: not one."""
        return False

    def reset_dt(self, sim: Simulation) -> None:
        """The size of a step was changed after a run: the next one may have no set-up."""

    def min_setup(self, sim: Simulation) -> None:
        """What it does when a minimization is set up, after the forces."""
        self.min_post_force(sim)

    def min_post_force(self, sim: Simulation) -> None:
        """What a fix that minimizes does at every force evaluation of a minimization: its post_force."""
        self.post_force(sim)  # type: ignore[attr-defined]

    def functions(self) -> list[Any]:
        """Kernels it will call, so that a run can compile all it needs at once. It binds them in post_neighbor."""
        return []

    def calls(self, sim: Simulation, hook: str) -> list[Callable[[], float]] | None:
        """All that a hook of a step does when nothing is tallied, as bound kernels; None: it does more. Asked after post_neighbor.

        The engine may then carry out many steps without coming back to Python; kernels that depend on the step find it in sim.ticks.
        Of end_of_step None means on multiples of every: in between nothing is done.
        """
        return None

    @contextmanager
    def reading(self, sim: Simulation, following: int) -> Iterator[None]:
        """Around the evaluation of variables and computes: what is read now will be read again at step following."""
        sim.asking.block()
        yield
        sim.asking.again(following)

    @staticmethod
    def virial_due(sim: Simulation) -> bool:
        """Virials are summed in this step; on others LAMMPS leaves a fix's as it was."""
        return sim.tally.has(VIRIAL, sim.step)

    @staticmethod
    def shares_due(sim: Simulation) -> bool:
        """The atoms' shares of the virial are summed in this step."""
        return sim.tally.has(ATOM_VIRIAL, sim.step)

    def members(self, sim: Simulation) -> Any:
        """(n,) bool: the owned atoms of this fix's group."""
        return (sim.atoms.mask[: sim.atoms.n] & self.bit) != 0


def hooks(fixes: list[Fix], name: str) -> list[Any]:
    """The bound methods called name of those fixes that define it, in order."""
    early = [fix for fix in fixes if fix.leads]
    if name == "post_force":
        fixes = early + [fix for fix in fixes if not fix.leads]
    elif name == "setup":
        fixes = early + fixes
    return [getattr(fix, name) for fix in fixes if hasattr(fix, name)]
