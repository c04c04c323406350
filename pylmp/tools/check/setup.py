"""What a run's set-up finds wrong before the first force is computed: the checks of the exact engine without its kernels."""

from __future__ import annotations

from pylmp.model.appetite import check_appetite
from pylmp.model.ghosts import ghost_cutoff
from pylmp.model.lost import warn_image_flags, warn_small_box
from pylmp.model.scene import Scene
from pylmp.model.simulation import Simulation

_SMALL = 200_000  # atoms whose bonds are looked at


def check_setup(sim: Simulation, scene: Scene, steps: int) -> None:
    """In the order of a set-up. Raises ScriptError with LAMMPS's sentence; warnings go to the console."""
    if sim.pair is None and sim.sort.every and not sim.sort.bin_size:
        sim.console.warning("No pairwise cutoff or binsize set. Atom sorting therefore disabled.")
        sim.sort.every = 0
    ghost_cutoff(sim, warn=True, setup=True)
    check_appetite(sim)
    if sim.atoms.n <= _SMALL:
        warn_image_flags(sim)
        warn_small_box(sim)
