"""change_box GROUP operations... [units lattice|box]

    x|y|z final lo hi | delta dlo dhi | scale f | volume      xy|xz|yz final tilt | delta d
    boundary x y z      ortho      triclinic      set      remap

Operations are carried out in order. remap moves the atoms of the group from where the box was (when the command began, or at the
last set or remap) to where it is now. Source: LAMMPS manual, change_box.html.
"""

from __future__ import annotations

import copy
from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np

from pylmp.commands.boundary import read_faces
from pylmp.commands.create_box import describe
from pylmp.model.box import Boundary, Box
from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.model.triclinic import Triclinic
from pylmp.model.waiting import refuse_atoms
from pylmp.text.words import Args, Word

_FACES = {"final": 2, "delta": 2, "scale": 1, "volume": 0}
_TILT = {"final": 1, "delta": 1}
_TILTS = "xy", "xz", "yz"
_OTHERS = "boundary", "ortho", "triclinic", "set", "remap"


@dataclass
class _Operation:
    """name: its first word. style, numbers: of x y z xy xz yz. volume: directions that then keep the volume."""

    name: str
    word: Word
    style: str = ""
    numbers: list[float] = field(default_factory=list)
    volume: list[int] = field(default_factory=list)
    boundary: Boundary | None = None


@command("change_box", needs_box=True)
def change_box(sim: Simulation, args: Args) -> None:
    """Change faces, tilts and boundaries of the box."""
    args.need(2)
    name = args.word()
    bit = sim.groups.bit(name.text)
    if not bit:
        args.fail(f"Group ID {name.text} requested by change_box does not exist", name)
    sim.console.both("Changing box ...\n")
    operations = _read(sim, args)
    spacing = _units(sim, args)
    if any(this.name not in ("triclinic", "ortho") for this in operations):
        refuse_atoms(sim, args, "Change_box parameter not allowed")
    atoms = sim.atoms
    atoms.clear_ghosts()
    sim.box.enter(atoms.x[: atoms.n])
    sim.box.wrap(atoms)
    sim.box.shrink(atoms, sim.natoms)
    sim.box.leave(atoms.x[: atoms.n])
    before = copy.deepcopy(sim.box)
    for this in operations:
        if this.name in ("set", "remap"):
            if this.name == "remap":
                rows = (atoms.mask[: atoms.n] & bit) != 0
                atoms.x[: atoms.n][rows] = sim.box.positions(before.fractions(atoms.x[: atoms.n][rows]))
            before = copy.deepcopy(sim.box)
        elif this.name == "boundary":
            _set_boundary(sim, args, this)
        else:
            _resize(sim, args, this, spacing)
            sim.box.set_initial(sim.console)
            sim.console.both(f"  {describe(sim.box)}\n")
    if sim.box.shrinking:
        _shrink(sim)
    if any(this.name not in ("ortho", "triclinic") for this in operations):
        sim.box.remap(atoms.x[: atoms.n], atoms.image[: atoms.n])
        _shrink(sim)


def _shrink(sim: Simulation) -> None:
    """Shrink-wrapped faces to the atoms."""
    x = sim.atoms.x[: sim.atoms.n]
    sim.box.enter(x)
    sim.box.shrink(sim.atoms, sim.natoms)
    sim.box.leave(x)


# ---- words --------------------------------------------------------------------------------------------------------


def _read(sim: Simulation, args: Args) -> list[_Operation]:
    operations: list[_Operation] = []
    while (word := args.peek()) is not None:
        if word.text in (*"xyz", *_TILTS):
            _read_size(sim, args, args.word(), operations)
        elif word.text in _OTHERS:
            this = _Operation(word.text, args.word())
            operations.append(this)
            if word.text == "boundary":
                args.need(3, "boundary")
                this.boundary = read_faces(args)
        else:
            break
    if word is not None and not operations:
        args.fail(f"Unknown change_box keyword: {word.text}", word, hint=" ".join([*"xyz", *_TILTS, *_OTHERS]))
    return operations


def _read_size(sim: Simulation, args: Args, name: Word, operations: list[_Operation]) -> None:
    tilt = name.text in _TILTS
    if not tilt and sim.dimension == 2 and name.text == "z":
        args.fail("Cannot change_box in z dimension for 2d simulation", name)
    if tilt and sim.dimension == 2 and name.text != "xy":
        args.fail("Cannot change_box in xz or yz for 2d simulation", name)
    args.need(1, name.text)
    style = args.word()
    words = _TILT if tilt else _FACES
    if style.text not in words:
        args.fail(f"Unknown change_box {name.text} argument: {style.text}", style, hint=" ".join(words))
    args.need(words[style.text], f"{name.text} {style.text}")
    if style.text != "volume":
        numbers = [args.number() for _ in range(words[style.text])]
        operations.append(_Operation(name.text, name, style.text, numbers))
        return
    leader = operations[-1] if operations else None
    if leader is None or leader.name not in tuple("xyz") or leader.name == name.text or len(leader.volume) == 2:
        args.fail("Change_box volume used incorrectly", name, hint="after the length whose change it makes good")
    leader.volume.append("xyz".index(name.text))


def _units(sim: Simulation, args: Args) -> tuple[float, float, float]:
    spacing = sim.spacing
    while len(args):
        key = args.word()
        if key.text != "units":
            args.fail(f"Unknown change_box keyword: {key.text}", key, hint="units")
        args.need(1, "units")
        value = args.word()
        if value.text not in ("box", "lattice"):
            args.fail(f"Invalid change_box units argument: {value.text}", value, hint="box or lattice")
        spacing = sim.spacing if value.text == "lattice" else (1.0, 1.0, 1.0)
    return spacing


# ---- operations ---------------------------------------------------------------------------------------------------


def _resize(sim: Simulation, args: Args, this: _Operation, spacing: tuple[float, float, float]) -> None:
    """x y z xy xz yz ortho triclinic."""
    box = sim.box
    if this.name in ("ortho", "triclinic"):
        _turn(sim, args, this)
    elif this.name in _TILTS:
        k = _TILTS.index(this.name)
        if not box.triclinic:
            args.fail("Cannot change box tilt factors for orthogonal box", this.word, hint="change_box all triclinic")
        tilt, value = box.tilt.copy(), spacing[1 if k == 2 else 0] * this.numbers[0]
        tilt[k] = value if this.style == "final" else tilt[k] + value
        box.place(box.lo.copy(), box.hi.copy(), tilt)
    else:
        d = "xyz".index(this.name)
        lo, hi = box.lo.copy(), box.hi.copy()
        volume = _volume(box)
        if this.style == "final":
            lo[d], hi[d] = (spacing[d] * value for value in this.numbers)
        elif this.style == "delta":
            lo[d] += spacing[d] * this.numbers[0]
            hi[d] += spacing[d] * this.numbers[1]
        else:
            _stretch(lo, hi, d, this.numbers[0])
        box.place(lo, hi)
        if this.volume:
            box.set_initial(sim.console)
            lo, hi = box.lo.copy(), box.hi.copy()
            ratio = volume / _volume(box)
            for other in this.volume:
                _stretch(lo, hi, other, ratio if len(this.volume) == 1 else np.sqrt(ratio))
            box.place(lo, hi)


def _volume(box: Box) -> float:
    a, b, c = box.length
    return float(a * b * c)


def _stretch(lo: np.ndarray, hi: np.ndarray, d: int, factor: float) -> None:
    middle = 0.5 * (lo[d] + hi[d])
    lo[d], hi[d] = middle + factor * (lo[d] - middle), middle + factor * (hi[d] - middle)


def _turn(sim: Simulation, args: Args, this: _Operation) -> None:
    if sim.output.dumps:
        args.fail("Cannot change box ortho/triclinic with dumps defined", this.word, hint="undump comes first")
    if any(fix.changes_box for fix in sim.fixes):
        args.fail("Cannot change box ortho/triclinic with certain fixes defined", this.word, hint="unfix comes first")
    if this.name == "ortho" and sim.box.tilt.any():
        args.fail("Cannot change box to orthogonal when tilt is non-zero", this.word, hint="xy final 0, ...")
    kind: Callable[[Box], Box] = Triclinic.of if this.name == "triclinic" else Box.of
    sim.box = kind(sim.box)


def _set_boundary(sim: Simulation, args: Args, this: _Operation) -> None:
    """Image flags of directions that are not periodic any more become 0."""
    box, atoms = sim.box, sim.atoms
    assert this.boundary is not None
    box.boundary = sim.boundary = this.boundary
    loose = [not periodic for periodic in box.periodic]
    if atoms.image[: atoms.n][:, loose].any():
        sim.console.warning("Resetting image flags for non-periodic dimensions")
        atoms.image[: atoms.n][:, loose] = 0
    if sim.dimension == 2 and loose[2]:
        args.fail("Cannot change box z boundary to non-periodic for a 2d simulation", this.word)
    box.set_initial(sim.console)
