"""The decks of speed, small: forces, energies and virials of the fast engine against the exact one and LAMMPS, and which bonds break when."""

from __future__ import annotations

import contextlib
import io
import shutil
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from pylmp.engines.exact import Exact
from pylmp.engines.fast import Fast
from pylmp.engines.fast_bonds import FastBonds
from pylmp.interpreter import Interpreter
from pylmp.model.bondlist import Breaks
from pylmp.model.console import Console
from pylmp.model.simulation import Simulation
from tests.engines.test_fast import rows
from tests.support import frames, lammps

BENCH = Path(__file__).parents[2] / "inputs" / "bench"
SMALL = {  # variables, until many bonds have broken, neighbors have changed
    "in.A_melt": "ny 4 nz 6 settle 60 steps 60", "in.B_melt_long": "nx 32 ny 6 nz 6 settle 60 steps 30",
    "in.C_impact": "shrink 0.3 steps 150", "in.C2_impact_mild": "shrink 0.3 steps 300", "in.D_sheet_2000": "n 20 steps 300",
    "in.D_sheet_200": "steps 300", "in.E_network": "cells 8 steps 100", "in.F_liquid": "cells 6 settle 60 steps 60",
    "in.G_two_types": "ny 4 nz 6 settle 60 steps 60",
}  # fmt: skip
BREAKING = {  # steps over which bonds break, and the least number of them
    "in.C_impact": ("shrink 0.5 steps 1000", 2000), "in.C2_impact_mild": ("shrink 0.5 steps 1000", 500), "in.D_sheet_2000": ("n 46 steps 1000", 100),
    "in.D_sheet_200": ("steps 1000", 1), "in.E_network": ("cells 14 steps 1000", 4000),
}  # fmt: skip
GONE = "thermo_modify lost ignore lost/bond ignore\n"  # fragments fly out of the box in a thousand steps


def carry_out(name: str, variables: str, folder: Path, engine: Any, more: str = "") -> Interpreter:
    """Carry out a deck; more: before its first run."""
    folder.mkdir(parents=True)
    for path in BENCH.glob("in.*"):
        (folder / path.name).write_text(path.read_text().replace("run             ${settle}", f"{more}run             ${{settle}}"))
    with contextlib.chdir(folder), np.errstate(all="ignore"):
        interpreter = Interpreter(Simulation(Console(io.StringIO(), None), engine))
        words = variables.split()
        for key, value in zip(words[::2], words[1::2], strict=True):
            interpreter.variables.set_index(key, [value])
        interpreter.run_file(Path(name))
    return interpreter


def numbers(sim: Simulation) -> list[np.ndarray]:
    tally = sim.tally
    return [np.array([tally.pair, tally.bond]), np.array([*tally.pair_virial, *tally.bond_virial])]


@pytest.mark.parametrize("name", SMALL)
def test_forces_energies_virials(name: str, tmp_path: Path) -> None:
    """At the same positions: those to which the exact engine has come, and with the same bits LAMMPS."""
    script = carry_out(name, SMALL[name], tmp_path / "exact", Exact())
    sim = script.sim
    still = [f"unfix {fix.id}" for fix in sim.fixes]  # random forces would be others each time
    for line in (*still, "run 0"):
        script.execute(line)
    exact, sums = rows(sim, "f").copy(), numbers(sim)
    sim.engine = Fast()
    script.execute("run 0")
    assert "engine fast lacks" not in sim.console.screen_file.getvalue()
    fast, others = rows(sim, "f"), numbers(sim)
    limit = 1e-12 * np.sqrt((exact * exact).mean())
    assert np.abs(fast - exact).max() <= limit > 0.0
    for one, other in zip(sums, others, strict=True):
        assert np.abs(one - other).max() <= 1e-12 * np.abs(one).max()
    words = SMALL[name].split()
    switches = [word for k in range(0, len(words), 2) for word in ("-var", words[k], words[k + 1])]
    folder = tmp_path / "lammps"
    shutil.copytree(BENCH, folder)
    more = "\n".join(still) + "\nrun 0\nwrite_dump all custom forces id x y z fx fy fz modify sort id format float %.17g\n"
    lammps((BENCH / name).read_text() + more, folder, *switches)
    there = frames(folder / "forces")[0][2]
    assert there[:, 1:4].tobytes() == rows(sim, "x").tobytes()
    assert np.abs(there[:, 4:] - fast).max() <= limit


@pytest.mark.long
@pytest.mark.parametrize("name", BREAKING)
def test_bonds_break_in_the_same_steps(name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Over 1000 steps; there is no tie among them, a bond so close to its limit that it breaks a step earlier or later."""
    broken: dict[str, dict[tuple[int, int], int]] = {"exact": {}, "fast": {}}
    record, book = Breaks.record, FastBonds.book

    def recorded(self: Breaks, sim: Simulation, listed: Any, count: int) -> None:
        ends = listed.bonds[listed.broken[:count], :2]
        note("exact", sim, sim.atoms.tag[ends])
        record(self, sim, listed, count)

    def booked(self: FastBonds, sim: Simulation, count: int) -> None:
        at = self.broken[:count]
        note("fast", sim, sim.atoms.tag[np.stack([self.owner[at], self.home[at]], axis=1)])
        book(self, sim, count)

    def note(engine: str, sim: Simulation, tags: np.ndarray) -> None:
        for a, b in tags.tolist():
            broken[engine].setdefault((min(a, b), max(a, b)), sim.step)

    monkeypatch.setattr(Breaks, "record", recorded)
    monkeypatch.setattr(FastBonds, "book", booked)
    variables, least = BREAKING[name]
    exact = carry_out(name, variables, tmp_path / "exact", Exact(), GONE).sim
    fast = carry_out(name, variables, tmp_path / "fast", Fast(), GONE).sim
    assert "engine fast lacks" not in fast.console.screen_file.getvalue()
    assert len(broken["exact"]) > least
    assert (exact.report.builds, exact.report.dangerous) == (fast.report.builds, fast.report.dangerous)
    assert broken["exact"] == broken["fast"]
