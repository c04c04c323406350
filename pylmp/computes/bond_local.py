"""compute ID GROUP bond/local values...: a row a bond, in local atom and slot order.

dist dx dy dz; engpot force fx fy fz from the bond law itself; engvib engrot engtrans omega velvib from the atoms'
motion; b1 b2 ... what the bond style remembers (r0 and r_eq of bpm/spring/plastic).
Source: LAMMPS manual, compute_bond_local.html.
"""

from __future__ import annotations

import re
from typing import Any

import numpy as np

from pylmp.computes.property_local import rows_of_bonds
from pylmp.model import bond_volumes
from pylmp.model.atoms import Floats, Ints
from pylmp.model.compute import Compute
from pylmp.model.registry import COMPUTES
from pylmp.model.simulation import Simulation
from pylmp.text.diagnostic import ScriptError, Unsupported
from pylmp.text.words import Args

_VALUES = (
    "dist", "dx", "dy", "dz", "engpot", "force", "fx", "fy", "fz", "engvib", "engrot", "engtrans", "omega", "velvib",
)  # fmt: skip


@COMPUTES.register("bond/local")
class BondLocal(Compute):
    style = "bond/local"

    def __init__(self, sim: Simulation, identity: str, group: str, bit: int, args: Args) -> None:
        super().__init__(sim, identity, group, bit, args)
        if not sim.has_bonds:
            args.fail("Compute bond/local used when bonds are not allowed", args.owner, hint="atom_style bond")
        if not len(args):
            args.illegal(args.owner, hint=" ".join(_VALUES))
        self.names = []
        for word in args.rest():
            if word.text == "set" or word.text.startswith("v_"):
                raise Unsupported(
                    "LAMMPS has variables in compute bond/local, pylmp's native engines do not", word.span
                )
            if re.fullmatch(r"b\d+", word.text) and int(word.text[1:]) == 0:
                args.fail(f"Invalid keyword {word.text} in compute bond/local command", word, hint="b1 b2")
            if word.text not in _VALUES and not re.fullmatch(r"b[1-9]\d*", word.text):
                args.fail(f"Unknown compute bond/local keyword: {word.text}", word, hint=" ".join(_VALUES) + " b1 b2")
            self.names.append(word.text)
        self.columns = len(self.names)

    def init(self, sim: Simulation) -> None:
        if sim.bond is None:
            raise ScriptError("No bond style is defined for compute bond/local", hint="bond_style comes first")
        extra = [int(name[1:]) for name in self.names if name not in _VALUES]
        if extra and max(extra) > max(part.memory for part in sim.bond.parts):
            raise ScriptError(
                "Bond style does not have extra field requested by compute bond/local",
                hint="b1 of bpm styles, b2 of bpm/spring/plastic",
            )

    def local(self, sim: Simulation) -> Floats:
        """(rows,) or (rows, columns): bonds that are not broken. Those turned off have no energy, force and memory: 0.0
        (LAMMPS prints whatever its memory held before)."""
        atoms = sim.atoms
        rows, slots, partners = rows_of_bonds(sim, self.members(sim), lambda kinds: kinds != 0)
        d = sim.box.minimum_image(atoms.x[rows] - atoms.x[partners])
        kinds = atoms.bond_type[rows, slots].astype(np.int64)
        r2 = _dot(d, d)
        values: dict[str, Any] = {"dist": np.sqrt(r2), "dx": d[:, 0], "dy": d[:, 1], "dz": d[:, 2]}
        if not set(self.names) <= set(values):
            v = atoms.v[rows] - atoms.v[partners]
            apart = atoms.x[rows] - atoms.x[partners]  # not the minimum image: LAMMPS's damping here takes none
            dot = apart[:, 0] * v[:, 0] + apart[:, 1] * v[:, 1] + apart[:, 2] * v[:, 2]
            memory = remembered(sim, rows, partners)
            if not {"engpot", "force", "fx", "fy", "fz"}.isdisjoint(self.names):
                report(sim, kinds, r2)
            over_r, energy = single(sim, rows, partners, kinds, r2, dot, memory)
            values |= {"engpot": energy, "force": values["dist"] * over_r}
            values |= {f"f{axis}": d[:, k] * over_r for k, axis in enumerate("xyz")}
            values |= motion(sim, rows, partners)
            if memory.shape[1]:
                values["b1"] = memory[:, 0]
            if memory.shape[1] > 1:
                values["b2"] = (1.0 + memory[:, 1]) * memory[:, 0]
        table = np.stack([values[name] for name in self.names], axis=1)
        return table[:, 0] if self.columns == 1 else table


def remembered(sim: Simulation, rows: Ints, partners: Ints) -> Floats:
    """(bonds, memory) what each bond remembers now: the bond lists know it, the atoms' slots only since the last rebuild."""
    memory = sim.bond.memory
    result = np.zeros((len(rows), memory))
    if not memory or not len(rows):
        return result
    tag = sim.atoms.tag
    span = int(tag[: sim.atoms.n].max()) + 1
    for listed in sim.bond_lists:
        bonds, history = listed.bonds[: listed.count], listed.history[: listed.count]
        low, high = np.minimum(tag[bonds[:, 0]], tag[bonds[:, 1]]), np.maximum(tag[bonds[:, 0]], tag[bonds[:, 1]])
        # A bond across a face may be listed twice, with copies that differ in the last bits; the first counts, as in LAMMPS.
        keys, first = np.unique(low * span + high, return_index=True)
        mine = np.minimum(tag[rows], tag[partners]) * span + np.maximum(tag[rows], tag[partners])
        at = np.minimum(np.searchsorted(keys, mine), max(len(keys) - 1, 0))
        found = (keys[at] == mine) if len(keys) else np.zeros(len(mine), bool)
        result[found] = history[first[at[found]]]
    return result


def single(
    sim: Simulation, rows: Ints, partners: Ints, kinds: Ints, r2: Floats, dot: Floats, memory: Floats
) -> tuple[Floats, Floats]:
    """Force over r and energy of each bond, 0.0 where it is turned off.

    As in LAMMPS quartic's energy has the pair energy taken out, its force has not.
    """
    force, energy = np.zeros(len(rows)), np.zeros(len(rows))
    for part in sim.bond.parts:
        mine = (kinds > 0) & (part.mine[np.abs(kinds)] != 0)
        if not mine.any():
            continue
        history = memory[mine][:, : part.memory]
        own = bond_volumes.growth(sim, rows[mine], partners[mine]) if part.style.volumes(part.options) else None
        force[mine], energy[mine] = part.evaluate(kinds[mine], r2[mine], dot[mine], history, own)
        if part.style.subtract_pair and sim.pair is not None and sim.pair.working:
            ends = sim.atoms.type[rows[mine]], sim.atoms.type[partners[mine]]
            _, pair_energy = sim.pair.single(r2[mine], np.zeros(int(mine.sum())), *ends)
            energy[mine] = part.style.single(r2[mine], tuple(part.table[kinds[mine]].T), pair_energy)
    return force, energy


def report(sim: Simulation, kinds: Ints, r2: Floats) -> None:
    """Warnings of styles about bonds evaluated alone."""
    for part in sim.bond.parts:
        if part.style.report_alone is not None:
            mine = np.flatnonzero((kinds > 0) & (part.mine[np.abs(kinds)] != 0))
            seen = mine[np.asarray(part.watch(r2[mine], part.columns(kinds[mine])), bool)]
            part.style.report_alone(sim, part, r2[seen], kinds[seen])


def motion(sim: Simulation, rows: Ints, partners: Ints) -> dict[str, Floats]:
    """Kinetic energy of a bond's two atoms: of their center, of turning, of stretching; turning rate; stretching speed.

    Like LAMMPS it takes the coordinates as stored: a bond across a periodic face counts as if it spanned the box.
    Order of operations as measured on LAMMPS 22 Jul 2025.
    """
    masses, x, v = sim.masses(), sim.atoms.x, sim.atoms.v
    m1, m2 = masses[rows], masses[partners]
    inverse = 1.0 / (m1 + m2)
    center, drift = _mean(m1, x[rows], m2, x[partners], inverse), _mean(m1, v[rows], m2, v[partners], inverse)
    arm1, arm2 = x[rows] - center, x[partners] - center
    own1, own2 = v[rows] - drift, v[partners] - drift
    d = x[rows] - x[partners]
    with np.errstate(all="ignore"):
        along = d * (1.0 / np.sqrt(_dot(d, d)))[:, None]
        speed1, speed2 = _dot(own1, along), _dot(own2, along)
        omega2 = (_dot(own1, own1) - speed1 * speed1) / _dot(arm1, arm1)
        inertia = m1 * _dot(arm1, arm1) + m2 * _dot(arm2, arm2)
        half = 0.5 * sim.units.mvv2e
        return {
            "engtrans": half * (m1 + m2) * _dot(drift, drift),
            "engvib": half * (m1 * speed1 * speed1 + m2 * speed2 * speed2),
            "engrot": half * inertia * omega2,
            "omega": np.sqrt(omega2),
            "velvib": speed1 - speed2,
        }


def _mean(m1: Floats, a: Floats, m2: Floats, b: Floats, inverse: Floats) -> Floats:
    """Mass-weighted mean of the vectors a and b (rows, 3)."""
    return np.asarray((m1[:, None] * a + m2[:, None] * b) * inverse[:, None])


def _dot(a: Floats, b: Floats) -> Floats:
    return np.asarray(a[:, 0] * b[:, 0] + a[:, 1] * b[:, 1] + a[:, 2] * b[:, 2])
