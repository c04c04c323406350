"""create_atoms TYPE box|region|single|random arguments... keywords...

Keywords: basis, ratio, subset, remap, units, overlap, maxtry, var, set. Source: LAMMPS manual, create_atoms.html.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from pylmp.commands.create_box import describe
from pylmp.kernels.subset import select_subset
from pylmp.model import limits
from pylmp.model.atoms import Floats, Ints
from pylmp.model.lattice import BASES, FLAT, Lattice
from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.model.sites import RandomPoints, Wanted, lattice_sites, within
from pylmp.model.variables import EQUAL_STYLES, Variables
from pylmp.model.waiting import refuse_atoms
from pylmp.text.diagnostic import Unsupported
from pylmp.text.words import Args, Word

_WORDS = {"box": 0, "region": 1, "single": 3, "random": 3}


@dataclass
class _Options:
    """types: of basis atoms. amount: a fraction (ratio) or a number (subset) of the sites; 0: all. axes: variables that get x y z."""

    types: dict[int, int] = field(default_factory=dict)
    units: str = "lattice"
    remap: bool = False
    overlap: float = 0.0
    tries: int = 1000
    amount: float | int = 0
    seed: int = 0
    variable: Word | None = None
    axes: dict[int, Word] = field(default_factory=dict)


@command("create_atoms", needs_box=True)
def create_atoms(sim: Simulation, args: Args) -> None:
    """Fill the box or a region with lattice sites, place one atom, or place atoms at random."""
    refuse_atoms(sim, args, "Cannot create_atoms")
    args.need(2)
    sim.labels.translate(args, "atom")
    type_word, style = args.word(), args.word()
    kind = args.as_integer(type_word)
    if style.text == "mesh":
        raise Unsupported("LAMMPS has create_atoms mesh, pylmp's native engines do not", style.span)
    if style.text not in _WORDS:
        args.fail(f"Unknown create_atoms command option {style.text}", style, hint=" ".join(_WORDS))
    if len(args) < _WORDS[style.text]:
        args.fail(f"Illegal create_atoms {style.text} command: missing argument(s)", style)
    geometry = [args.word() for _ in range(_WORDS[style.text])]
    place = _check_geometry(sim, args, style, geometry)
    options = _read_options(sim, args, style)
    if not 1 <= kind <= sim.atom_types:
        args.fail("Invalid atom type in create_atoms command", type_word, hint=f"types are 1 to {sim.atom_types}")
    lattice: Lattice | None = sim.lattice
    if lattice is not None and lattice.style in BASES and (lattice.style in FLAT) != (sim.dimension == 2):
        args.fail("Lattice style incompatible with simulation dimension", args.owner)
    scale = sim.spacing if options.units == "lattice" else (1.0, 1.0, 1.0)
    if style.text == "single":
        x = _single(sim, args, place, geometry, scale, options)
    elif style.text == "random":
        x = _random(sim, args, geometry, scale[0] * options.overlap, options)
    types = np.full(len(x), kind) if style.text in ("single", "random") else np.zeros(0, np.int64)
    if style.text in ("box", "region"):
        if lattice is None or not lattice.basis:
            args.fail("Cannot create atoms with undefined lattice", args.owner, hint="lattice comes first")
        x, types = _sites(sim, args, lattice, geometry, kind, options)
    sim.atoms.append(x, types)
    sim.atoms.number()
    created = sim.atoms.n - sim.natoms  # counted as LAMMPS does: atoms that were lost before it count here
    sim.natoms = sim.atoms.n
    sim.console.both(
        f"Created {created} atoms\n  using {options.units} units in {describe(sim.box)}\n  create_atoms CPU = 0.000 seconds\n"
    )


def _check_geometry(sim: Simulation, args: Args, style: Word, geometry: list[Word]) -> Floats:
    """What LAMMPS checks before it reads the keywords; the position of style single, as the script has it."""
    if style.text == "single":
        return np.array([[args.as_number(word) for word in geometry]])
    if style.text == "random":
        count, seed = args.as_integer(geometry[0]), args.as_integer(geometry[1])
        if count < 0:
            args.fail(f"Illegal create_atoms number of random atoms {count}", geometry[0])
        if seed <= 0:
            args.fail(f"Illegal create_atoms random seed {seed}", geometry[1], hint="a positive number")
    if geometry and (style.text == "region" or geometry[2].text != "NULL") and geometry[-1].text not in sim.regions:
        args.fail(f"Create_atoms region {geometry[-1].text} does not exist", geometry[-1])
    return np.zeros((0, 3))


def _read_options(sim: Simulation, args: Args, style: Word) -> _Options:
    options = _Options()
    while len(args):
        key = args.word()
        if key.text in ("mol", "radscale", "meshmode"):
            raise Unsupported(f"LAMMPS has create_atoms {key.text}, pylmp's native engines do not", key.span)
        if key.text in ("overlap", "maxtry") and style.text != "random":
            args.fail(f"Create_atoms {key.text} can only be used with random style", key)
        counts = {
            "units": 1,
            "remap": 1,
            "overlap": 1,
            "maxtry": 1,
            "var": 1,
            "basis": 2,
            "set": 2,
            "ratio": 2,
            "subset": 2,
            "rotate": 4,
        }
        if key.text not in counts:
            hint = "units basis ratio subset remap overlap maxtry var set"
            args.fail(f"Illegal create_atoms command option {key.text}", key, hint=hint)
        args.need(counts[key.text], key.text)
        _read_option(sim, args, key, options)
    if style.text == "single" and (options.variable or options.axes):
        args.fail("Cannot use 'var' keyword with 'single' style for create_atoms", args.owner)
    if (options.variable is None) != (not options.axes):
        args.fail("Incomplete use of variables in create_atoms command", args.owner, hint="var NAME set x NAME")
    if options.variable is not None:
        _check_variables(sim, args, options.variable, options.axes)
    return options


def _read_option(sim: Simulation, args: Args, key: Word, options: _Options) -> None:
    """Take the values of a keyword that has enough of them."""
    if key.text == "units":
        value = args.word()
        if value.text not in ("box", "lattice"):
            args.fail(f"Unknown create_atoms units option {value.text}", value, hint="box or lattice")
        options.units = value.text
    elif key.text == "remap":
        options.remap = args.yes()
    elif key.text == "overlap":
        options.overlap = args.number()
        if options.overlap <= 0.0:
            args.fail(f"Illegal create_atoms overlap value: {args.words[args.at - 1].text}", hint="a positive number")
    elif key.text == "maxtry":
        options.tries = args.integer()
        if options.tries <= 0:
            args.fail(f"Illegal create_atoms maxtry value {options.tries}", hint="a positive number")
    elif key.text == "basis":
        which = args.integer()
        sim.labels.translate(args, "atom")
        other = args.integer()
        sites = len(sim.lattice.basis) if sim.lattice else 0
        if not 1 <= which <= sites or not 1 <= other <= sim.atom_types:
            args.fail(f"Out of range basis setting '{which} {other}' in create_atoms command")
        options.types[which - 1] = other
    elif key.text in ("ratio", "subset"):
        ratio = key.text == "ratio"
        options.amount, options.seed = args.number() if ratio else args.integer(), args.integer()
        if options.amount <= 0 or (ratio and options.amount > 1) or options.seed <= 0:
            args.fail(
                f"Illegal create_atoms {key.text} settings", key, hint=f"{key.text} a positive number, and a seed"
            )
    elif key.text == "var":
        options.variable = args.word()
    elif key.text == "set":
        axis, name = args.word(), args.word()
        if axis.text not in ("x", "y", "z"):
            args.fail(f"Unknown create_atoms set option {name.text}", name, hint="set x|y|z NAME")
        options.axes["xyz".index(axis.text)] = name
    else:  # rotate is for molecules
        for _ in range(4):
            args.number()


def _check_variables(sim: Simulation, args: Args, variable: Word, axes: dict[int, Word]) -> None:
    known = Variables(sim)
    style = known.style(variable.text)
    if style is None:
        args.fail(f"Variable {variable.text} for create_atoms does not exist", variable)
    if style not in EQUAL_STYLES:
        args.fail(
            f"Variable {variable.text} for create_atoms is invalid style", variable, hint="an equal-style variable"
        )
    for word in axes.values():
        if known.style(word.text) not in (None, "internal"):
            args.fail(
                f"Variable {word.text} for create_atoms is invalid style",
                word,
                hint="a new name, or an internal variable",
            )
        known.set_internal(word.text, 0.0)


def _wanted(sim: Simulation, options: _Options) -> Wanted:
    """What the variable says of a point, whose coordinates the variables of keyword set then hold."""
    if options.variable is None:
        return None
    known, name = Variables(sim), options.variable.text

    def ask(point: Floats) -> bool:
        for axis, word in options.axes.items():
            known.set_internal(word.text, float(point[axis]))
        return known.number(name) != 0.0

    return ask


def _single(
    sim: Simulation,
    args: Args,
    place: Floats,
    geometry: list[Word],
    scale: tuple[float, float, float],
    options: _Options,
) -> Floats:
    if sim.dimension == 2 and place[0, 2] != 0.0:
        args.fail("Create_atoms single for 2d simulation requires z coord = 0.0", geometry[2])
    x = place * np.array(scale)
    if options.remap:
        sim.box.remap(x, np.zeros((1, 3), np.int64))
    return x[within(sim.box, x)]


def _random(sim: Simulation, args: Args, geometry: list[Word], overlap: float, options: _Options) -> Floats:
    count, seed = int(geometry[0].text), int(geometry[1].text)
    limits.room(count * limits.ATOM_BYTES, f"{count} atoms", geometry[0].span, args.manual)
    points = RandomPoints(sim, sim.regions.get(geometry[2].text) if geometry[2].text != "NULL" else None)
    if not points.apart:
        args.fail("No overlap of box and region for create_atoms", geometry[2])
    x = points.draw(seed, count, options.tries, overlap, _wanted(sim, options))
    if len(x) < count:
        sim.console.warning(f"Only inserted {len(x)} particles out of {count}")
    return x


def _sites(
    sim: Simulation, args: Args, lattice: Lattice, geometry: list[Word], kind: int, options: _Options
) -> tuple[Floats, Ints]:
    region = sim.regions[geometry[0].text] if geometry else None
    wanted = _wanted(sim, options)
    x, places = lattice_sites(sim, lattice, region, wanted)
    chosen = np.ones(len(x), bool)
    if options.amount:
        number = int(options.amount * len(x)) if isinstance(options.amount, float) else options.amount
        if number > len(x):
            args.fail("Create_atoms subset size > # of lattice sites", args.owner, hint=f"there are {len(x)} sites")
        chosen = select_subset(options.seed, number, len(x))
    if wanted is not None:  # LAMMPS goes through the sites twice, which matters to a variable with random numbers
        x, places = lattice_sites(sim, lattice, region, wanted)
        chosen = np.pad(chosen, (0, max(0, len(x) - len(chosen))), constant_values=not options.amount)[: len(x)]
    x, places = x[chosen], places[chosen]
    types = np.full(len(lattice.basis), kind)
    types[list(options.types)] = list(options.types.values())
    return x, types[places]
