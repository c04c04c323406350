"""What a run will compute in each step, what it will leave out and why, and about how long it takes and how much memory."""

from __future__ import annotations

from dataclasses import dataclass

from pylmp.engines.fast import obstacles
from pylmp.model.appetite import appetite
from pylmp.model.limits import size
from pylmp.model.scene import Scene
from pylmp.model.simulation import Simulation

# Seconds of processor time on one core, measured with the scripts of inputs/bench: of an atom, of an entry of a half list, of a bond, of a step.
_COST = {"fast": (2.0e-8, 3.0e-9, 1.0e-8, 1.0e-5), "exact": (5.0e-8, 5.0e-9, 8.0e-8, 1.0e-4)}
_WHEN = {  # what a hook of a step means
    "initial_integrate": "before the forces", "post_integrate": "before the forces", "pre_force": "before the forces",
    "post_force": "changes the forces", "final_integrate": "behind the forces", "end_of_step": "at the end of a step",
}  # fmt: skip


@dataclass(frozen=True)
class RunTold:
    """Texts. computed, left_out: one thing a line."""

    steps: int
    engine: str
    fallbacks: tuple[str, ...]
    computed: tuple[str, ...]
    left_out: tuple[str, ...]
    memory: str
    time: str
    same_as: int = 0  # the line of an earlier run with the same scene, 0: none


def tell_run(sim: Simulation, scene: Scene, steps: int) -> RunTold:
    """Of a run that would begin now."""
    lacking = tuple(obstacles(sim))
    engine = "exact" if lacking or sim.relaxing else "fast"
    wanted = appetite(sim)
    per_atom, per_entry, per_bond, per_step = _COST[engine]
    seconds = (steps + 1) * (wanted.atoms * per_atom + wanted.neighbors * per_entry + sim.bonds * per_bond + per_step)
    memory = f"about {size(wanted.bytes)}: {wanted.atoms} atoms, {wanted.ghosts:.3g} ghosts and {wanted.neighbors:.3g} pairs in the lists of LAMMPS's way"
    return RunTold(steps, engine, lacking, tuple(_computed(sim, scene)), tuple(_left_out(sim, scene)), memory, f"about {duration(seconds)} on one core")


def duration(seconds: float) -> str:
    """As a person says it: 3 min."""
    for limit, unit in ((86400.0, "days"), (3600.0, "h"), (60.0, "min")):
        if seconds >= limit:
            return f"{seconds / limit:.2g} {unit}"
    return f"{seconds:.2g} s"


def _computed(sim: Simulation, scene: Scene) -> list[str]:
    told = []
    for part, pair in zip(sim.pair.parts if sim.pair else [], scene.pairs, strict=True):
        if part.style.law is not None and part.settings.compute:
            told.append(f"forces of pair_style {pair.style} up to {float(part.cut.max()):.6g}, from a list up to {sim.neighbor_cutoff:.6g}")
    for bond in scene.bonds:
        told.append(f"forces of {sim.bonds} bonds by bond_style {bond.style}" + (", each asked whether it breaks" if bond.can_break else ""))
    for fix in sim.fixes:
        when = [f"{words} every {fix.every} steps" if name == "end_of_step" and fix.every > 1 else words
                for name, words in _WHEN.items() if hasattr(fix, name)]  # fmt: skip
        if when and not fix.internal:
            told.append(f"fix {fix.id} ({fix.style}): {', '.join(dict.fromkeys(when))}")
    if scene.ghost_velocity:
        told.append("velocities of ghost atoms (comm_modify vel yes)")
    lists = sim.neighbor
    told.append(f"has an atom moved more than {0.5 * lists.skin:.6g}? then new neighbor lists" if lists.check else f"new neighbor lists every {lists.every} steps")
    if sim.output.every:
        told.append(f"energy and pressure every {sim.output.every} steps, for the thermo table")
    told += [f"dump {name} every {dump.schedule.every} steps" for name, dump in sim.output.dumps.items() if dump.schedule.every]
    return told


def _left_out(sim: Simulation, scene: Scene) -> list[str]:
    told = []
    if not scene.pairs:
        told.append("neighbor lists and pair forces: there is no pair style")
    elif all(part.style.law is None for part in sim.pair.parts):
        told.append(f"pair forces: pair_style {scene.pair} has none")
    if sim.has_bonds and not sim.bonds:
        told.append("bond forces: there are no bonds")
    elif not sim.has_bonds:
        told.append(f"bonds: atom_style {sim.atom_style} has none")
    if scene.bonds and not any(bond.can_break for bond in scene.bonds):
        told.append("a look for broken bonds: no bond style here breaks any")
    if not scene.weighted and sim.has_bonds:
        told.append("special weights: all are 1")
    if scene.atom_types == 1:
        told.append("a look at types: there is one")
    if not scene.triclinic:
        told.append("tilt: the box is orthogonal")
    if not all(scene.periodic[: scene.dimension]):
        axes = "".join(axis for axis, periodic in zip("xyz", scene.periodic, strict=True) if not periodic)
        told.append(f"periodic images across {' '.join(axes)}: the box ends there")
    if scene.dimension == 2:
        told.append("the third dimension")
    if not any(fix.integrates for fix in sim.fixes):
        told.append("motion: no fix integrates")
    told.append("energy and virial in steps that nobody asks for them")
    return told
