"""kspace_style none"""

from __future__ import annotations

from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.text.diagnostic import Unsupported
from pylmp.text.words import Args

_ELSEWHERE = (
    "ewald", "ewald/dipole", "ewald/dipole/spin", "ewald/disp", "ewald/disp/dipole", "ewald/electrode", "msm", "msm/cg", "pppm",
    "pppm/cg", "pppm/dipole", "pppm/dipole/spin", "pppm/disp", "pppm/disp/dielectric", "pppm/disp/tip4p", "pppm/dielectric",
    "pppm/electrode", "pppm/stagger", "pppm/tip4p", "scafacos", "zero",
)  # fmt: skip


@command("kspace_style")
def kspace_style(sim: Simulation, args: Args) -> None:
    """No long-range solver: there is none here to choose."""
    if not len(args):
        args.missing()
    style = args.word()
    if style.text.removesuffix("/omp").removesuffix("/opt") in _ELSEWHERE:
        raise Unsupported(
            f"LAMMPS has kspace style {style.text}, pylmp's native engines do not", style.span,
            hint="--engine lammps runs this script on LAMMPS", manual="kspace_style.html",
        )  # fmt: skip
    if style.text != "none":
        args.fail(f"Unrecognized kspace style '{style.text}'", style, hint="none")
    args.rest()
