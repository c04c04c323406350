"""velocity GROUP create|set|scale|zero|ramp arguments... keywords..."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pylmp.kernels.random import RanPark, park_at
from pylmp.model.atoms import Floats
from pylmp.model.motion import (
    center_of_mass_velocity,
    remove_rotation,
    temperature_dof,
    temperature_of,
)
from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.text.diagnostic import Unsupported
from pylmp.text.words import Args, Word

_WORDS = {"create": 2, "set": 3, "scale": 1, "zero": 1, "ramp": 6}


@dataclass
class _Options:
    dist: str = "uniform"
    sum: bool = False
    mom: bool = True
    rot: bool = False
    loop: str = "all"
    lattice: bool = True


@command("velocity", needs_box=True)
def velocity(sim: Simulation, args: Args) -> None:
    """Set velocities of a group: at a temperature, to values, to zero momentum, along a ramp."""
    args.need(2)
    name, style = args.word(), args.word()
    if sim.atoms.n == 0:
        args.fail("Velocity command with no atoms existing", args.owner)
    for kind in range(1, sim.atom_types + 1):
        if sim.mass[kind] == 0.0:
            args.fail(f"Not all per-type masses are set. Type {kind} is missing.", args.owner, hint=f"mass {kind} 1.0")
    bit = sim.groups.bit(name.text)
    if not bit:
        args.fail(f"Could not find velocity group ID {name.text}", name)
    if style.text not in _WORDS:
        args.fail(f"Unknown velocity keyword: {style.text}", style, hint="create set scale zero ramp")
    args.need(_WORDS[style.text])
    words = [args.word() for _ in range(_WORDS[style.text])]
    options = _read_options(args)
    chosen = (sim.atoms.mask[: sim.atoms.n] & bit) != 0
    actions = {"create": _create, "set": _set, "scale": _scale, "zero": _zero, "ramp": _ramp}
    actions[style.text](sim, args, words, options, chosen)


def _read_options(args: Args) -> _Options:
    options = _Options()
    while len(args):
        key = args.word()
        if key.text in ("bias", "temp", "rigid"):
            raise Unsupported(f"LAMMPS has velocity keyword {key.text}, pylmp's native engines do not", key.span)
        if key.text in ("sum", "mom", "rot"):
            args.need(1)
            setattr(options, key.text, args.yes())
            continue
        choices = {"dist": ("uniform", "gaussian"), "loop": ("all", "local", "geom"), "units": ("box", "lattice")}
        if key.text not in choices:
            args.fail(f"Unknown velocity keyword: {key.text}", key, hint="dist sum mom rot loop units")
        value = args.word()
        if value.text not in choices[key.text]:
            args.fail(f"Unknown velocity {key.text} argument: {value.text}", value, hint=" or ".join(choices[key.text]))
        if key.text == "units":
            options.lattice = value.text == "lattice"
        else:
            setattr(options, key.text, value.text)
    return options


Chosen = NDArray[np.bool_]


def _create(sim: Simulation, args: Args, words: list[Word], options: _Options, chosen: Chosen) -> None:
    """Random velocities, momentum (and rotation) removed, scaled to the temperature."""
    target, seed = args.as_number(words[0]), args.as_integer(words[1])
    if seed <= 0:
        args.fail(f"Illegal velocity create seed argument: {seed}", words[1], hint="a positive number")
    atoms = sim.atoms
    v = atoms.v[: atoms.n]
    before = v.copy()
    draws = _draws(sim, args, options, seed, chosen)
    factor = 1.0 / np.sqrt(sim.masses())
    new = draws * factor[:, None]
    if sim.dimension == 2:
        new[:, 2] = 0.0
    v[chosen] = new[chosen]
    if options.mom:
        v[chosen] -= center_of_mass_velocity(sim, chosen)
    if options.rot:
        remove_rotation(sim, chosen)
    _rescale(sim, args, target, chosen)
    if options.sum:
        v[chosen] += before[chosen]


def _draws(sim: Simulation, args: Args, options: _Options, seed: int, chosen: Chosen) -> Floats:
    """(n, 3) numbers: uniform - 1/2, or gaussian; from one stream by ID, one by local order, or one an atom."""
    atoms = sim.atoms
    n = atoms.n
    gaussian = options.dist == "gaussian"
    if options.loop == "geom" and not gaussian:
        return park_at(seed, atoms.x[:n], 3) - 0.5
    result = np.zeros((n, 3))
    random = RanPark(seed)

    def draw() -> float:
        return random.gaussian() if gaussian else random.uniform() - 0.5

    if options.loop == "geom":
        for i in np.flatnonzero(chosen):
            random.reset(seed, atoms.x[i])
            result[i] = [draw() for _ in range(3)]
    elif options.loop == "local":
        random.skip(100)
        for i in np.flatnonzero(chosen):
            result[i] = [draw() for _ in range(3)]
    else:
        tags = atoms.tag[:n]
        if int(tags.max()) != n or len(np.unique(tags)) != n:
            args.fail("Atom IDs must be consecutive for velocity create loop all", args.owner, hint="loop geom or loop local")
        rows = atoms.rows_by_tag()
        for tag in range(1, n + 1):
            result[rows[tag]] = [draw() for _ in range(3)]
    return result


def _rescale(sim: Simulation, args: Args, target: float, chosen: Chosen) -> None:
    now = temperature_of(sim, chosen, temperature_dof(sim, chosen))
    if now == 0.0:
        args.fail("Attempting to rescale a 0.0 temperature", args.owner)
    sim.atoms.v[: sim.atoms.n][chosen] *= math.sqrt(target / now)


def _scale(sim: Simulation, args: Args, words: list[Word], options: _Options, chosen: Chosen) -> None:
    _rescale(sim, args, args.as_number(words[0]), chosen)


def _set(sim: Simulation, args: Args, words: list[Word], options: _Options, chosen: Chosen) -> None:
    v = sim.atoms.v[: sim.atoms.n]
    for d, word in enumerate(words):
        if word.text == "NULL":
            continue
        if word.text.startswith("v_"):
            raise Unsupported("LAMMPS has variables in velocity set, pylmp's native engines do not", word.span)
        value = args.as_number(word) * (sim.spacing[d] if options.lattice else 1.0)
        if d == 2 and sim.dimension == 2 and value != 0.0:
            args.fail("Cannot set non-zero z velocity for 2d simulation", word)
        v[chosen, d] = v[chosen, d] + value if options.sum else value


def _zero(sim: Simulation, args: Args, words: list[Word], options: _Options, chosen: Chosen) -> None:
    if not chosen.any():
        args.fail("Cannot zero momentum of no atoms", args.owner)
    if words[0].text == "linear":
        sim.atoms.v[: sim.atoms.n][chosen] -= center_of_mass_velocity(sim, chosen)
    elif words[0].text == "angular":
        remove_rotation(sim, chosen)
    else:
        args.illegal(words[0], hint="linear or angular")


def _ramp(sim: Simulation, args: Args, words: list[Word], options: _Options, chosen: Chosen) -> None:
    """A velocity component that grows along a coordinate."""
    if words[0].text not in ("vx", "vy", "vz") or words[3].text not in ("x", "y", "z"):
        args.illegal(words[0])
    moved, along = "xyz".index(words[0].text[1]), "xyz".index(words[3].text)
    scale = sim.spacing if options.lattice else (1.0, 1.0, 1.0)
    lo, hi = (scale[moved] * args.as_number(w) for w in words[1:3])
    start, stop = (scale[along] * args.as_number(w) for w in words[4:6])
    atoms = sim.atoms
    fraction = np.minimum(np.maximum((atoms.x[: atoms.n][chosen, along] - start) / (stop - start), 0.0), 1.0)
    value = lo + fraction * (hi - lo)
    v = atoms.v[: atoms.n]
    v[chosen, moved] = v[chosen, moved] + value if options.sum else value
