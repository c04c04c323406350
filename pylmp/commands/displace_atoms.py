"""displace_atoms GROUP move|random|ramp|rotate arguments... keywords...

Source: LAMMPS manual, displace_atoms.html.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pylmp.kernels.random import park_at
from pylmp.model.quantity import Quantity
from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.model.transform import rotated, unit
from pylmp.model.waiting import refuse_atoms
from pylmp.text.words import Args, Word

_DEGREE = math.pi / 180.0


@dataclass
class _Displacement:
    """What one command asks for: words after the style; scale: of lattice or box units; chosen (n,) bool."""

    sim: Simulation
    args: Args
    words: list[Word]
    scale: tuple[float, float, float]
    chosen: NDArray[np.bool_]

    def numbers(self, first: int, last: int) -> list[float]:
        return [self.args.as_number(word) for word in self.words[first:last]]


@command("displace_atoms", needs_box=True)
def displace_atoms(sim: Simulation, args: Args) -> None:
    """Move atoms, then wrap them into the box."""
    refuse_atoms(sim, args, "Cannot displace_atoms")
    if len(args) < 2:
        args.illegal(args.owner)
    sim.console.both("Displacing atoms ...\n")
    name, style = args.word(), args.word()
    bit = sim.groups.bit(name.text)
    if not bit:
        args.fail(f"Could not find display_atoms group {name.text}", name)
    if style.text not in _STYLES:
        args.fail(f"Unknown displace_atoms keyword {style.text}", style, hint=" ".join(_STYLES))
    count, act = _STYLES[style.text]
    args.need(count)
    words = [args.word() for _ in range(count)]
    scale = sim.spacing
    while len(args):
        key = args.word()
        if key.text != "units":
            args.fail(f"Unknown displace_atoms keyword {key.text}", key, hint="units")
        args.need(1, "units")
        value = args.word()
        if value.text not in ("box", "lattice"):
            args.fail(f"Unknown displace_atoms units argument {value.text}", value, hint="box or lattice")
        scale = (1.0, 1.0, 1.0) if value.text == "box" else sim.spacing
    atoms = sim.atoms
    act(_Displacement(sim, args, words, scale, (atoms.mask[: atoms.n] & bit) != 0))
    x = atoms.x[: atoms.n]
    sim.box.remap(x, atoms.image[: atoms.n])
    sim.box.enter(x)
    sim.box.shrink(atoms, sim.natoms)
    sim.box.leave(x)
    atoms.clear_ghosts()
    if atoms.n != sim.natoms:  # they were lost before
        sim.console.warning(
            f"Lost atoms via displace_atoms: original {sim.natoms} current {atoms.n}\n"
            "For more information see https://docs.lammps.org/err0008"
        )


def _move(this: _Displacement) -> None:
    x = this.sim.atoms.x[: this.sim.atoms.n]
    for d, word in enumerate(this.words):
        amount = Quantity.read(Args("displace_atoms", [word], word, this.args.manual), scale=this.scale[d])
        missing, invalid = "Variable {} for {} move does not exist", "Variable {} for {} is invalid style"
        amount.check(this.sim, "displace_atoms", atoms=True, missing=missing, invalid=invalid)
        if d >= this.sim.dimension:  # no complaint here, and no effect (measured)
            continue
        delta = amount.numbers(this.sim, this.chosen)
        x[this.chosen, d] += delta[this.chosen] if isinstance(delta, np.ndarray) else delta


def _random(this: _Displacement) -> None:
    """dx*2*(u - 1/2), u drawn from seed and position."""
    sizes = [s * size for s, size in zip(this.scale, this.numbers(0, 3), strict=True)]
    seed = this.args.as_integer(this.words[3])
    if seed <= 0:
        this.args.fail(f"Illegal displace_atoms random seed {seed}", this.words[3], hint="a positive number")
    _stay_flat(this, sizes[2] != 0.0, this.words[2])
    x = this.sim.atoms.x[: this.sim.atoms.n]
    draws = park_at(seed, x[this.chosen], 3)
    for d in range(3):
        x[this.chosen, d] += sizes[d] * 2.0 * (draws[:, d] - 0.5)


def _ramp(this: _Displacement) -> None:
    """Displacement that grows along a coordinate."""
    for word in (this.words[0], this.words[3]):
        if word.text not in ("x", "y", "z"):
            this.args.fail(f"Unknown displace_atoms ramp dimension {word.text}", word)
    moved, along = "xyz".index(this.words[0].text), "xyz".index(this.words[3].text)
    _stay_flat(this, moved == 2, this.words[0])
    lo, hi = (this.scale[moved] * bound for bound in this.numbers(1, 3))
    start, stop = (this.scale[along] * bound for bound in this.numbers(4, 6))
    x = this.sim.atoms.x[: this.sim.atoms.n]
    with np.errstate(all="ignore"):
        fraction = (x[this.chosen, along] - start) / (stop - start)
    x[this.chosen, moved] += lo + np.fmin(np.fmax(fraction, 0.0), 1.0) * (hi - lo)


def _rotate(this: _Displacement) -> None:
    """Rotation of unwrapped positions about an axis, by degrees; images begin anew."""
    sim, atoms, rows = this.sim, this.sim.atoms, this.chosen
    px, py, pz = (s * p for s, p in zip(this.scale, this.numbers(0, 3), strict=True))
    a, b, c, degrees = this.numbers(3, 7)
    if sim.dimension == 2 and (a != 0.0 or b != 0.0):
        this.args.fail("Invalid displace_atoms rotate axis for 2d system", this.words[3], hint="0 0 1")
    if a == b == c == 0.0:
        this.args.fail("Zero length rotation vector with displace_atoms", this.words[3])
    x, image = atoms.x[: atoms.n][rows], atoms.image[: atoms.n]
    sim.box.unmap(x, image[rows])
    image[rows] = 0
    atoms.x[: atoms.n][rows] = rotated(x, (px, py, pz), unit((a, b, c)), _DEGREE * degrees)


def _stay_flat(this: _Displacement, out_of_plane: bool, word: Word) -> None:
    if out_of_plane and this.sim.dimension == 2:
        this.args.fail("Must not displace atoms in z-direction with 2d system", word)


_STYLES: dict[str, tuple[int, Callable[[_Displacement], None]]] = {
    "move": (3, _move), "random": (4, _random), "ramp": (6, _ramp), "rotate": (7, _rotate),
}  # fmt: skip
