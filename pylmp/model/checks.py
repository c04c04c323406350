"""What LAMMPS checks before every run that belongs to no single style."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from pylmp.text.diagnostic import ScriptError

if TYPE_CHECKING:
    from pylmp.model.simulation import Simulation


def check_integration(sim: Simulation) -> None:
    """Warn when two fixes move the same atom."""
    movers = np.zeros(sim.atoms.n, np.int64)
    for fix in sim.fixes:
        if fix.integrates:
            movers += fix.members(sim)
    if (movers > 1).any():
        sim.console.warning(
            "One or more atoms are time integrated more than once\n"
            "For more information see https://docs.lammps.org/err0032"
        )


def warn_motionless(sim: Simulation) -> None:
    """Warn when no fix moves atoms: what LAMMPS says first when a run begins."""
    if not any(fix.integrates for fix in sim.fixes):
        sim.console.warning(
            "No fixes with time integration, atoms won't move\nFor more information see https://docs.lammps.org/err0028"
        )


def check_neighbor_settings(sim: Simulation) -> None:
    """Raise ScriptError where neigh_modify's numbers do not fit together."""
    settings = sim.neighbor
    settings.exclude.check(sim)
    if settings.delay > 0 and settings.delay % settings.every:
        raise ScriptError(
            "Neighbor delay must be 0 or multiple of every setting", manual="neigh_modify.html",
            hint=f"neigh_modify every {settings.every} delay {settings.delay // settings.every * settings.every}",
        )  # fmt: skip
    if settings.page < 10 * settings.one:
        raise ScriptError(
            "Neighbor page size must be >= 10x the one atom setting", hint=f"neigh_modify page {10 * settings.one}",
            manual="neigh_modify.html",
        )  # fmt: skip
