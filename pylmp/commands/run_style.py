"""run_style verlet"""

from __future__ import annotations

from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.text.diagnostic import Unsupported
from pylmp.text.words import Args


@command("run_style", needs_box=True)
def run_style(sim: Simulation, args: Args) -> None:
    """The time integrator: velocity Verlet."""
    if not len(args):
        args.missing()
    style = args.word()
    if style.text in ("respa", "respa/omp", "verlet/split", "verlet/lrt/intel"):
        raise Unsupported(
            f"LAMMPS has run style {style.text}, pylmp's native engines do not", style.span,
            hint="run_style verlet with a smaller timestep, or --engine lammps",
        )  # fmt: skip
    if style.text != "verlet":
        args.fail(f"Unknown integrate style {style.text}", style, hint="verlet")
    args.rest()
