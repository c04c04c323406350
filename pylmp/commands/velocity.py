"""velocity GROUP create|set|scale|zero|ramp arguments... keywords..."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pylmp.kernels.random import RanPark, park_at
from pylmp.model.atoms import Floats
from pylmp.model.motion import center_of_mass_velocity, remove_rotation
from pylmp.model.registry import COMPUTES, command
from pylmp.model.simulation import Simulation
from pylmp.model.temperature import Temperature
from pylmp.model.variables import EQUAL_STYLES, Variables
from pylmp.text.words import Args, Word

_WORDS = {"create": 2, "set": 3, "scale": 1, "zero": 1, "ramp": 6}
_CHOICES = {"dist": ("uniform", "gaussian"), "loop": ("all", "local", "geom"), "units": ("box", "lattice")}
Chosen = NDArray[np.bool_]


@dataclass
class Options:
    """temp: the compute that temp names; rigid: the word after it."""

    group: str = "all"
    bit: int = 1
    dist: str = "uniform"
    sum: bool = False
    mom: bool = True
    rot: bool = False
    loop: str = "all"
    units: str = "lattice"
    bias: bool = False
    temp: Temperature | None = None
    rigid: Word | None = None


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
    options = Options(name.text, bit)
    _read_options(sim, args, options)
    chosen = (sim.atoms.mask[: sim.atoms.n] & bit) != 0
    actions = {"create": _create, "set": _set, "scale": _scale, "zero": _zero, "ramp": _ramp}
    actions[style.text](sim, args, words, options, chosen)


def _read_options(sim: Simulation, args: Args, options: Options) -> None:
    while len(args):
        key = args.word()
        if key.text not in (*_CHOICES, "sum", "mom", "rot", "bias", "temp", "rigid"):
            args.fail(f"Unknown velocity keyword: {key.text}", key, hint="dist sum mom rot temp bias loop units")
        args.need(1, key.text)
        if key.text in ("sum", "mom", "rot", "bias"):
            setattr(options, key.text, args.yes())
            continue
        value = args.word()
        if key.text == "temp":
            options.temp = _temperature(sim, args, value, options)
        elif key.text == "rigid":
            options.rigid = value
        elif value.text in _CHOICES[key.text]:
            setattr(options, key.text, value.text)
        else:
            args.fail(
                f"Unknown velocity {key.text} argument: {value.text}", value, hint=" or ".join(_CHOICES[key.text])
            )
    if options.bias and options.temp is None:
        args.fail("Cannot use velocity bias command without temp keyword", args.owner, hint="temp COMPUTE-ID")
    if options.bias and options.temp is not None and not options.temp.bias:
        args.fail(
            "Velocity temperature ID does calculate a velocity bias", args.owner, hint="a compute like temp/partial"
        )


def _temperature(sim: Simulation, args: Args, word: Word, options: Options) -> Temperature:
    found = sim.computes.get(word.text)
    if found is None:
        args.fail(f"Could not find velocity temperature compute ID: {word.text}", word)
    if not isinstance(found, Temperature):
        args.fail(f"Velocity temperature compute {word.text} does not compute temperature", word, hint="compute temp")
    return found


def _scale_of(sim: Simulation, options: Options) -> tuple[float, float, float]:
    return sim.spacing if options.units == "lattice" else (1.0, 1.0, 1.0)


def _create(sim: Simulation, args: Args, words: list[Word], options: Options, chosen: Chosen) -> None:
    """Random velocities, momentum (and rotation) removed, scaled to the temperature."""
    target, seed = args.as_number(words[0]), args.as_integer(words[1])
    if seed <= 0:
        args.fail(f"Illegal velocity create seed argument: {seed}", words[1], hint="a positive number")
    compute = _ready(sim, options, own=options.bias)
    drift = options.temp if options.bias else None
    atoms = sim.atoms
    v = atoms.v[: atoms.n]
    before = v.copy()
    draws = _draws(sim, args, options, seed, chosen)
    everyone = np.ones(atoms.n, bool)
    kept = drift.remove_bias(sim, everyone) if drift else None
    new = draws * (1.0 / np.sqrt(sim.masses()))[:, None]
    if sim.dimension == 2:
        new[:, 2] = 0.0
    v[chosen] = new[chosen]
    if (options.mom or options.rot) and not chosen.any():
        args.fail("Cannot zero momentum of no atoms", args.owner)
    if options.mom:
        v[chosen] -= center_of_mass_velocity(sim, chosen)
    if options.rot:
        remove_rotation(sim, chosen)
    _rescale(sim, args, compute.scalar(sim), target, chosen)
    if drift:
        drift.restore_bias(sim, everyone, kept)
    if options.sum:
        v[chosen] += before[chosen]


def _ready(sim: Simulation, options: Options, own: bool = False) -> Temperature:
    """The compute that temp names, or one of the group (own: in any case that), with its degrees of freedom counted now."""
    compute = options.temp
    if compute is None or own:
        kind = COMPUTES.find("temp")
        assert kind is not None
        compute = kind(sim, "velocity_temp", options.group, options.bit, Args("compute temp", []))
        assert isinstance(compute, Temperature)
    elif compute.bit != options.bit:
        sim.console.warning("Mismatch between velocity and compute groups")
    for each in {compute, options.temp or compute}:
        each.init(sim)
        each.setup(sim)
    return compute


def _draws(sim: Simulation, args: Args, options: Options, seed: int, chosen: Chosen) -> Floats:
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
        if int(tags.max()) != sim.natoms or int(tags.min()) != 1:
            args.fail(
                "Atom IDs must be consecutive for velocity create loop all", args.owner, hint="loop geom or loop local"
            )
        rows = atoms.rows_by_tag()
        for tag in range(1, sim.natoms + 1):
            drawn = [draw() for _ in range(3)]
            if rows[tag] >= 0:  # else the atom was lost
                result[rows[tag]] = drawn
    return result


def _rescale(sim: Simulation, args: Args, now: float, target: float, chosen: Chosen) -> None:
    """From temperature now to target."""
    if now == 0.0:
        args.fail("Attempting to rescale a 0.0 temperature", args.owner)
    ratio = target / now
    sim.atoms.v[: sim.atoms.n][chosen] *= math.sqrt(ratio) if ratio >= 0.0 else math.nan


def _scale(sim: Simulation, args: Args, words: list[Word], options: Options, chosen: Chosen) -> None:
    target = args.as_number(words[0])
    compute = _ready(sim, options)
    everyone = np.ones(sim.atoms.n, bool)
    now = compute.scalar(sim)
    kept = compute.remove_bias(sim, everyone) if options.bias else None
    _rescale(sim, args, now, target, chosen)
    if options.bias:
        compute.restore_bias(sim, everyone, kept)


def _set(sim: Simulation, args: Args, words: list[Word], options: Options, chosen: Chosen) -> None:
    values = [_component(sim, args, word, d, options, chosen) for d, word in enumerate(words)]
    v = sim.atoms.v[: sim.atoms.n]
    for d, value in enumerate(values):
        if value is not None:
            v[chosen, d] = v[chosen, d] + value if options.sum else value


def _component(
    sim: Simulation, args: Args, word: Word, axis: int, options: Options, chosen: Chosen
) -> Floats | float | None:
    """A number in lattice units, a variable's number or numbers of the chosen atoms as they are, None for NULL."""
    if word.text == "NULL":
        return None
    flat = axis == 2 and sim.dimension == 2
    if not word.text.startswith("v_"):
        value = args.as_number(word) * _scale_of(sim, options)[axis]
        if flat and value != 0.0:
            args.fail("Cannot set non-zero z velocity for 2d simulation", word)
        return value
    style = Variables(sim).style(word.text[2:])
    if style is None:
        args.fail("Variable name for velocity set does not exist", word)
    if flat:
        args.fail("Cannot set variable z velocity for 2d simulation", word)
    if style in ("atom", "atomfile"):
        return Variables(sim).per_atom(word.text[2:], np.flatnonzero(chosen))
    if style not in EQUAL_STYLES:
        args.fail("Variable for velocity set is invalid style", word, hint="an equal-style or atom-style variable")
    return Variables(sim).number(word.text[2:])


def _zero(sim: Simulation, args: Args, words: list[Word], options: Options, chosen: Chosen) -> None:
    if words[0].text not in ("linear", "angular"):
        args.illegal(words[0], hint="linear or angular")
    if options.rigid is not None:
        if all(fix.id != options.rigid.text for fix in sim.fixes):
            args.fail(f"Fix ID {options.rigid.text} for velocity does not exist", options.rigid)
        args.fail("Velocity rigid used with non-rigid fix-ID", options.rigid)
    if not chosen.any():
        args.fail("Cannot zero momentum of no atoms", args.owner)
    if words[0].text == "linear":
        sim.atoms.v[: sim.atoms.n][chosen] -= center_of_mass_velocity(sim, chosen)
    else:
        remove_rotation(sim, chosen)


def _ramp(sim: Simulation, args: Args, words: list[Word], options: Options, chosen: Chosen) -> None:
    """A velocity component that grows along a coordinate."""
    if words[0].text not in ("vx", "vy", "vz") or words[3].text not in ("x", "y", "z"):
        args.illegal(words[0] if words[0].text not in ("vx", "vy", "vz") else words[3])
    moved, along = "xyz".index(words[0].text[1]), "xyz".index(words[3].text)
    if moved == 2 and sim.dimension == 2:
        args.fail("Velocity ramp in z for a 2d problem", words[0])
    scale = _scale_of(sim, options)
    lo, hi = (scale[moved] * args.as_number(w) for w in words[1:3])
    start, stop = (scale[along] * args.as_number(w) for w in words[4:6])
    atoms = sim.atoms
    with np.errstate(all="ignore"):
        fraction = (atoms.x[: atoms.n][chosen, along] - start) / (stop - start)
    # C's fmax and fmin, which prefer a number to what is none
    fraction = np.fmin(np.fmax(fraction, 0.0), 1.0)
    value = lo + fraction * (hi - lo)
    v = atoms.v[: atoms.n]
    v[chosen, moved] = v[chosen, moved] + value if options.sum else value
