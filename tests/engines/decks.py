"""Every deck on the fast engine, and on the exact one."""

from __future__ import annotations

import contextlib
import io
import re
import shutil
from pathlib import Path
from typing import Any

import numpy as np

from pylmp.engines.exact import Exact
from pylmp.engines.fast import Fast
from pylmp.interpreter import Interpreter
from pylmp.model.console import Console
from pylmp.model.engine import RunPlan, RunReport
from pylmp.model.minimize import MinPlan
from pylmp.model.scene import Scene
from pylmp.model.simulation import Simulation
from pylmp.text.diagnostic import ScriptError
from pylmp.text.leave import Quit

ROOT = Path(__file__).parents[2]
STEPS = 20  # of each run of inputs/
SAYS = re.compile(r"^Engine exact for this run: engine fast lacks (.+)$", re.M)
INPUTS = sorted(path for path in (ROOT / "inputs").glob("*/in.*") if path.name != "in.quartic_melt")  # it wants a file of 32 000 atoms
DECKS = [*sorted((ROOT / "tests" / "decks").glob("*/*.in")), *INPUTS]
SMALL = {  # the decks of speed, and what makes them small
    "in.A_melt": "ny 4 nz 6", "in.B_melt_long": "nx 32 ny 6 nz 6", "in.C_impact": "shrink 0.4", "in.C2_impact_mild": "shrink 0.4",
    "in.D_sheet_2000": "n 20", "in.E_network": "cells 8", "in.F_liquid": "cells 6", "in.G_two_types": "ny 4 nz 6",
}  # fmt: skip


def short(kind: type, steps: int | None, nudge: bool = False) -> Any:
    """An engine that makes no more than so many steps of a run; nudge: and moves all atoms by the last bits before."""

    class Short(kind):  # type: ignore[misc]
        def run(self, sim: Simulation, scene: Scene, plan: RunPlan) -> RunReport:
            plan.steps = min(plan.steps, steps or plan.steps)
            self._nudge(sim)
            report: RunReport = super().run(sim, scene, plan)
            return report

        def minimize(self, sim: Simulation, scene: Scene, plan: MinPlan) -> Any:
            self._nudge(sim)
            return super().minimize(sim, scene, plan)

        @staticmethod
        def _nudge(sim: Simulation) -> None:
            if nudge:
                x = sim.atoms.x[: sim.atoms.n, : sim.dimension]
                x += 1e-15 * np.random.default_rng(sim.step).uniform(-1.0, 1.0, x.shape)

    return Short()


def name(deck: Path) -> str:
    return deck.relative_to(ROOT).as_posix()


def run(script: Path, engine: Any) -> Simulation:
    """Carry out a script in its own folder."""
    sim = Simulation(Console(io.StringIO(), None), engine)
    permits = re.search(r"^# allow: (.*)$", script.read_text(), re.M)
    with contextlib.chdir(script.parent), np.errstate(all="ignore"):
        interpreter = Interpreter(sim, permits[1].split() if permits else ())
        words = SMALL.get(script.name, "").split()
        for key, value in zip(words[::2], words[1::2], strict=True):
            interpreter.variables.set_index(key, [value])
        with contextlib.suppress(Quit):
            interpreter.run_file(Path(script.name))
    return sim


def three(deck: Path, folder: Path) -> tuple[Simulation, Simulation, Simulation | None]:
    """What the exact engine makes of a deck, the fast one, and the exact one if atoms are moved by the last bits, None if it fails then."""
    steps = STEPS if deck in INPUTS else None
    sims: list[Any] = []
    for place, engine in (("exact", short(Exact, steps)), ("fast", short(Fast, steps)), ("nudged", short(Exact, steps, nudge=True))):
        pattern = "*" if deck in INPUTS else f"{deck.stem}.*"
        (folder / place).mkdir(parents=True)
        for path in deck.parent.glob(pattern):
            if path.is_file():
                shutil.copy2(path, folder / place)
        try:
            sims.append(run(folder / place / deck.name, engine))
        except ScriptError:
            if place != "nudged":  # where atoms stand at a face it may lose them
                raise
            sims.append(None)
    exact, fast, nudged = sims
    return exact, fast, nudged


def lacking(fast: Simulation) -> list[str]:
    """What the exact engine was asked for, in the order of a deck's runs."""
    said = SAYS.findall(fast.console.screen_file.getvalue())
    return list(dict.fromkeys(what for line in said for what in line.split(", ")))


def apart(one: Simulation, other: Simulation) -> float:
    """The largest distance of an atom in one from itself in the other."""
    rows = [np.argsort(sim.atoms.tag[: sim.atoms.n]) for sim in (one, other)]
    d = one.atoms.x[rows[0]] - other.atoms.x[rows[1]]
    return float(np.abs(one.box.minimum_image(d)).max(initial=0.0))
