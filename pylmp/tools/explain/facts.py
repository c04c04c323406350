"""What a script has made so far, as short texts by name: what differs before and after a command is what the command did."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from pylmp.model.simulation import Simulation
from pylmp.model.topology import KINDS
from pylmp.text.number import eight
from pylmp.tools.explain.forms import Given
from pylmp.tools.explain.units import named


def facts(sim: Simulation) -> dict[str, str]:
    """By name, in the order in which a reader wants them."""
    found = _settings(sim)
    if sim.has_box:
        found |= _box(sim) | _atoms(sim)
    return {name: text for name, text in (found | _forces(sim) | _lists(sim) | _variables(sim)).items() if text}


def changes(before: dict[str, str], after: dict[str, str]) -> list[str]:
    """In words: "atoms: 0 -> 4000"."""
    told = [f"{name}: {before[name]} -> {text}" if name in before else f"{name}: {text}" for name, text in after.items() if before.get(name) != text]
    return told + [f"{name} is gone" for name in before if name not in after]


def coefficients(sim: Simulation, words: list[str]) -> list[Given]:
    """The numbers of a pair_coeff or bond_coeff line by name."""
    at = {"pair_coeff": 3, "bond_coeff": 2}.get(words[0])
    force = sim.pair if words[0] == "pair_coeff" else sim.bond
    if at is None or force is None:
        return []
    given = words[at:]
    parts = {part.style.name: part for part in force.parts}
    part = parts.get(given[0]) if given and len(parts) > 1 else next(iter(parts.values()), None)
    given = given[1:] if given and given[0] in parts else given
    return [Given(one.name, word, one.unit) for one, word in zip(part.style.coeffs, given, strict=False)] if part else []


def with_unit(value: float, unit: str, sim: Simulation) -> str:
    return f"{eight(value)} {named(unit, sim.units.name)}".rstrip()


def _settings(sim: Simulation) -> dict[str, str]:
    found = {
        "units": sim.units.name, "dimension": str(sim.dimension), "boundary": " ".join(low if low == high else low + high for low, high in sim.boundary),
        "newton": f"pair {_on(sim.newton_pair)}, bond {_on(sim.newton_bond)}", "atom style": sim.style.name,
        "timestep": with_unit(sim.dt, "time", sim), "step": str(sim.step),
        "lattice": f"{sim.lattice.style}, spacings {' '.join(map(eight, sim.spacing))}" if sim.lattice else "",
    }  # fmt: skip
    one, comm, special = sim.neighbor, sim.comm, sim.special
    found["neighbor lists"] = (
        f"skin {with_unit(one.skin, 'distance', sim)}, {one.style}, every {one.every}, delay {one.delay}, "
        f"check {_on(one.check, 'yes', 'no')}, one {one.one}, page {one.page}"
    )
    found["communication"] = f"cutoff {eight(comm.cutoff)}, velocities {_on(comm.velocity, 'yes', 'no')}"
    found["special bonds"] = f"lj {' '.join(map(eight, special.lj))}, coul {' '.join(map(eight, special.coul))}"
    found["sorting of atoms"] = f"every {sim.sort.every} steps"
    found["minimizer"] = sim.minimizing.style
    return found


def _on(value: bool, yes: str = "on", no: str = "off") -> str:
    return yes if value else no


def _box(sim: Simulation) -> dict[str, str]:
    box = sim.box
    text = f"({' '.join(map(eight, box.lo.tolist()))}) to ({' '.join(map(eight, box.hi.tolist()))}) {named('distance', sim.units.name)}"
    found = {"box": f"{text}, tilt {' '.join(map(eight, box.tilt.tolist()))}" if box.triclinic else text}
    found["volume" if sim.dimension == 3 else "area"] = eight(box.volume)
    found["atom types"] = str(sim.atom_types)
    for kind in KINDS:
        if kind in sim.style.kinds:
            found[f"{kind.name} types"] = str(kind.types(sim)) if kind.types(sim) else ""
    return found


def _atoms(sim: Simulation) -> dict[str, str]:
    atoms, n = sim.atoms, sim.atoms.n
    found = {"atoms": str(sim.natoms)}
    if n and sim.box.volume > 0.0:
        found["number density"] = eight(n / sim.box.volume)
    for kind in sim.style.kinds:
        found[kind.plural] = str(kind.total(sim)) if kind.total(sim) else ""
    if n:
        counts = np.bincount(atoms.type[:n], minlength=sim.atom_types + 1)[1:].tolist()
        found["atoms by type"] = ", ".join(f"{kind}: {count}" for kind, count in enumerate(counts[:12], 1)) if sim.atom_types > 1 else ""
    masses = sim.mass[1:13].tolist()
    found["masses"] = ", ".join(f"{kind}: {with_unit(mass, 'mass', sim)}" for kind, mass in enumerate(masses, 1) if mass)
    for name, bit in sim.groups.names.items():
        if name != "all":
            found[f"group {name}"] = f"{int(((atoms.mask[:n] & bit) != 0).sum())} atoms"
    if n and (mass := sim.mass[atoms.type[:n]]).all():
        squares = np.einsum("ij,ij->i", atoms.v[:n], atoms.v[:n])
        dof = sim.dimension * n - sim.dimension
        kinetic = float((mass * squares).sum()) * sim.units.mvv2e
        found["temperature"] = with_unit(float(f"{kinetic / (dof * sim.units.boltz):.6g}"), "temperature", sim) if dof > 0 and kinetic else ""
    return found


def _forces(sim: Simulation) -> dict[str, str]:
    found: dict[str, str] = {}
    if sim.pair is not None:
        found["pair style"] = sim.pair.name
        for part in sim.pair.parts:
            options = " ".join(f"{key} {_text(value)}" for key, value in part.options.items())
            found[f"pair {part.called}"] = options
            names = [one.name for one in part.style.coeffs]
            for (i, j), (values, cut) in list(part.given.items())[:20]:
                told = " ".join(f"{name} {_text(value)}" for name, value in zip(names, values, strict=False))
                found[f"pair coefficients {i} {j}" + (f" of {part.called}" if len(sim.pair.parts) > 1 else "")] = f"{told} cutoff {_text(cut)}"
    if sim.bond is not None:
        found["bond style"] = sim.bond.name
        for part in sim.bond.parts:
            found[f"bond {part.style.name}"] = " ".join(f"{key} {_text(value)}" for key, value in part.options.items())
            names = [one.name for one in part.style.coeffs]
            for kind in range(1, min(sim.bond.types, 20) + 1):
                if part.mine[kind]:
                    rows = zip(names, part.table[kind].tolist(), strict=False)
                    found[f"bond coefficients {kind}"] = " ".join(f"{name} {eight(value)}" for name, value in rows)
    for other in KINDS[1:]:
        if other.style(sim) is not None:
            found[f"{other.name} style"] = other.style(sim).name
    return found


def _lists(sim: Simulation) -> dict[str, str]:
    found = {f"region {name}": type(region).__name__.lower() for name, region in sim.regions.items()}
    for fix in sim.fixes:
        if not fix.internal:
            found[f"fix {fix.id}"] = f"{fix.style} on {fix.group}"
    for name, compute in sim.computes.items():
        if not name.startswith("thermo_"):
            found[f"compute {name}"] = f"{compute.style} on {compute.group}"
    for name, dump in sim.output.dumps.items():
        found[f"dump {name}"] = f"{dump.style} of {dump.group} every {dump.schedule.every or 'variable'} steps"
    found["thermo table"] = f"every {sim.output.every} steps" if sim.output.every else "first and last step of a run"
    if sim.output.restarts is not None:
        found["restart files"] = ", ".join(f"{one.names[0].text} every {one.every} steps" for one in sim.output.restarts.all)
    return found


def _variables(sim: Simulation) -> dict[str, str]:
    found = {}
    for name, one in sim.script.variables.known.items():
        values = [str(value) for value in one.values[:8]]
        found[f"variable {name}"] = f"{one.style} {' '.join(values)}".strip()[:120]
    return found


def _text(value: Any) -> str:
    show: Callable[[Any], str] = eight if isinstance(value, float) else str
    return {True: "yes", False: "no"}[value] if isinstance(value, bool) else show(value)
