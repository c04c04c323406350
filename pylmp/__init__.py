"""pylmp runs LAMMPS input scripts, with breakable and plastic bonds at the heart."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from pathlib import Path

    from pylmp.model.simulation import Simulation

__version__ = "0.1.0"


def run(path: str | Path, **variables: object) -> Simulation:
    """Run a script on the exact engine and return the simulation it leaves; variables are set as by -var. Writes no log.

    Raises pylmp.text.diagnostic.ScriptError when the script is wrong.
    """
    from pathlib import Path

    from pylmp.engines.exact import Exact
    from pylmp.interpreter import Interpreter
    from pylmp.model.console import Console
    from pylmp.model.simulation import Simulation

    sim = Simulation(Console(), Exact())
    interpreter = Interpreter(sim)
    for name, value in variables.items():
        interpreter.variables.set_index(name, [str(value)])
    interpreter.run_main(Path(path))
    return sim
