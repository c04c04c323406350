"""displace_atoms GROUP move|random|ramp arguments... keywords..."""

from __future__ import annotations

import numpy as np

from pylmp.kernels.random import park_at
from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.text.diagnostic import Unsupported
from pylmp.text.words import Args, Word

_WORDS = {"move": 3, "random": 4, "ramp": 6}


@command("displace_atoms", needs_box=True)
def displace_atoms(sim: Simulation, args: Args) -> None:
    """Move atoms, then wrap them into the box."""
    if len(args) < 2:
        args.illegal(args.owner)
    name, style = args.word(), args.word()
    bit = sim.groups.bit(name.text)
    if not bit:
        args.fail(f"Could not find display_atoms group {name.text}", name)
    if style.text == "rotate":
        raise Unsupported("LAMMPS has displace_atoms rotate, pylmp's native engines do not", style.span)
    if style.text not in _WORDS:
        args.fail(f"Unknown displace_atoms keyword {style.text}", style, hint="move random ramp")
    args.need(_WORDS[style.text])
    words = [args.word() for _ in range(_WORDS[style.text])]
    scale = sim.spacing
    while len(args):
        key = args.word()
        if key.text != "units":
            args.fail(f"Unknown displace_atoms keyword {key.text}", key, hint="units")
        value = args.word()
        if value.text not in ("box", "lattice"):
            args.fail(f"Unknown displace_atoms units argument {value.text}", value, hint="box or lattice")
        scale = (1.0, 1.0, 1.0) if value.text == "box" else sim.spacing
    sim.console.both("Displacing atoms ...\n")
    chosen = (sim.atoms.mask[: sim.atoms.n] & bit) != 0
    {"move": _move, "random": _random, "ramp": _ramp}[style.text](sim, args, words, scale, chosen)
    atoms = sim.atoms
    x = atoms.x[: atoms.n]
    sim.box.remap(x, atoms.image[: atoms.n])
    sim.box.enter(x)
    sim.box.shrink(atoms)
    sim.box.leave(x)
    atoms.clear_ghosts()


def _move(sim: Simulation, args: Args, words: list[Word], scale, chosen) -> None:  # type: ignore[no-untyped-def]
    x = sim.atoms.x[: sim.atoms.n]
    for d, word in enumerate(words):
        if word.text.startswith("v_"):
            raise Unsupported("LAMMPS has variables in displace_atoms, pylmp's native engines do not", word.span)
        x[chosen, d] += scale[d] * args.as_number(word)


def _random(sim: Simulation, args: Args, words: list[Word], scale, chosen) -> None:  # type: ignore[no-untyped-def]
    """dx*2*(u - 1/2), u drawn from seed and position."""
    sizes = [s * args.as_number(w) for s, w in zip(scale, words[:3], strict=True)]
    seed = args.as_integer(words[3])
    if seed <= 0:
        args.fail(f"Illegal displace_atoms random seed {seed}", words[3], hint="a positive number")
    x = sim.atoms.x[: sim.atoms.n]
    draws = park_at(seed, x[chosen], 3)
    for d in range(3):
        x[chosen, d] += sizes[d] * 2.0 * (draws[:, d] - 0.5)


def _ramp(sim: Simulation, args: Args, words: list[Word], scale, chosen) -> None:  # type: ignore[no-untyped-def]
    """Displacement that grows along a coordinate."""
    for word in (words[0], words[3]):
        if word.text not in ("x", "y", "z"):
            args.fail(f"Unknown displace_atoms ramp dimension {word.text}", word)
    moved, along = "xyz".index(words[0].text), "xyz".index(words[3].text)
    lo, hi = (scale[moved] * args.as_number(w) for w in words[1:3])
    start, stop = (scale[along] * args.as_number(w) for w in words[4:6])
    x = sim.atoms.x[: sim.atoms.n]
    fraction = np.minimum(np.maximum((x[chosen, along] - start) / (stop - start), 0.0), 1.0)
    x[chosen, moved] += lo + fraction * (hi - lo)
