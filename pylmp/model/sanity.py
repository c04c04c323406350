"""What LAMMPS passes in silence: a timestep too long for the stiffest bond, positions that are no numbers. --strict is silent too."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from pylmp.model.atoms import Floats, Ints
from pylmp.model.bond import pairs_of_rows
from pylmp.model.topology import BOND, entries
from pylmp.text.diagnostic import ScriptError

if TYPE_CHECKING:
    from pylmp.model.simulation import Simulation

_ROWS = 2**15  # that are looked at together: a bound on memory
SAFE, BLOWS_UP = 0.1, 2.0  # omega dt: where velocity Verlet's frequency is off by 1/2400; where it diverges


def stiffest(sim: Simulation) -> list[tuple[int, str, float]]:
    """(bond type, style, omega): the fastest swing of two atoms on a bond of each type, alone, at the bonds' present lengths.

    Bonds that remember are taken at rest. Left out: types without a law of two atoms (tables, volumes), and those that push nothing back.
    """
    atoms, n = sim.atoms, sim.atoms.n
    if not np.isfinite(atoms.x[:n]).all():
        return []
    squares: dict[int, float] = {}
    by_tag = atoms.rows_by_tag()
    parts = [part for part in sim.bond.parts if not part.tabled and not part.style.volumes(part.options)]
    for begin in range(0, n, _ROWS):
        rows, slots, partners = pairs_of_rows(sim, lambda types: types > 0, begin, min(begin + _ROWS, n), by_tag)
        there = partners >= 0
        ends, kinds = np.stack([rows[there], partners[there]], axis=1), atoms.bond_type[rows[there], slots[there]]
        r = np.sqrt((sim.box.minimum_image(atoms.x[ends[:, 0]] - atoms.x[ends[:, 1]]) ** 2).sum(axis=1))
        inverse = (1.0 / sim.mass[atoms.type[ends]]).sum(axis=1) * sim.units.ftm2v
        for part in parts:
            for kind in np.flatnonzero(part.mine).tolist():
                mine = (kinds == kind) & (r > 0.0)
                square = float(np.nanmax(_stiffness(part, kind, r[mine]) * inverse[mine], initial=0.0))
                squares[kind] = max(squares.get(kind, 0.0), square)
    return [
        (kind, part.style.name, float(np.sqrt(squares[kind])))
        for part in parts
        for kind in np.flatnonzero(part.mine).tolist()
        if np.isfinite(squares.get(kind, 0.0)) and squares.get(kind, 0.0) > 0.0
    ]


def _stiffness(part: Any, kind: int, r: Floats) -> Floats:
    """-dF/dr of bonds of a type."""
    h = 1.0e-6 * r
    memory = [r if k == 0 else 0.0 * r for k in range(len(part.style.history))]
    history = np.stack(memory, axis=1) if memory else np.zeros((len(r), 0))
    kinds: Ints = np.full(len(r), kind)

    def force(at: Floats) -> Floats:
        return np.asarray(part.evaluate(kinds, at * at, 0.0 * at, history)[0] * at)

    return np.asarray((force(r - h) - force(r + h)) / (2.0 * h))


def warn_stiff(sim: Simulation, said: set[str]) -> None:
    """Say, on the screen alone and each sentence once, which bonds the timestep is too long for."""
    if sim.strict or sim.bond is None or not sim.has_bonds:
        return
    for kind, style, omega in stiffest(sim):
        turn = omega * sim.dt
        if turn <= SAFE:
            continue
        what = "WARNING: the run will blow up" if turn > BLOWS_UP else "NOTE: energy will waver"
        text = (
            f"{what}: bond type {kind} ({style}) swings with omega = {omega:.4g}, omega dt = {turn:.2g} "
            f"(velocity Verlet: stable below 2, accurate below 0.1: timestep {SAFE / omega:.2g})\n"
        )
        if text not in said:
            said.add(text)
            sim.console.screen(text)


def check_finite(sim: Simulation) -> None:
    """Raises ScriptError where a position or velocity is not a number: which step, atoms, bonds, and the last restart file."""
    atoms = sim.atoms
    n = atoms.n
    if np.isfinite(atoms.x[:n]).all() and np.isfinite(atoms.v[:n]).all():
        return
    bad = ~(np.isfinite(atoms.x[:n]) & np.isfinite(atoms.v[:n])).all(axis=1)
    tags = np.sort(atoms.tag[:n][bad])
    text = f"Non-numeric positions or velocities of {len(tags)} atoms at step {sim.step}: {' '.join(map(str, tags[:5].tolist()))}"
    text += " ..." if len(tags) > 5 else ""
    if sim.has_bonds:
        found = entries(sim, BOND, lambda types: types > 0).once(sim)
        touched = np.isin(found.tags, tags).any(axis=1)
        if touched.any():
            a, b = found.tags[touched][0].tolist()
            text += f"; bond {a} {b} of type {found.types[touched][0]}"
    raise ScriptError(text, hint="a smaller timestep, or start closer to rest; the restart command keeps states to go back to; --strict goes on as LAMMPS does")
