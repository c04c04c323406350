"""set STYLE ID keyword values..."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pylmp.io.ready import initialise, wrap_atoms
from pylmp.kernels.random import park_at
from pylmp.kernels.subset import select_subset
from pylmp.model.ghosts import Ghosts
from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.model.topology import KIND, entries
from pylmp.model.variables import Variables
from pylmp.text.diagnostic import ScriptError
from pylmp.text.words import Args, Word

Rows = NDArray[np.int64]
_PLAIN = {"x": ("x", 0), "y": ("x", 1), "z": ("x", 2), "vx": ("v", 0), "vy": ("v", 1), "vz": ("v", 2)}
# What no atom style of pylmp has: LAMMPS refuses these keywords there too.
_ABSENT = (
    "angmom", "apip/lambda", "cc", "density", "density/disc", "diameter", "dipole", "dipole/random", "dpd/theta", "edpd/cv",
    "edpd/temp", "epsilon", "length", "mass", "omega", "quat", "quat/random", "radius/electron", "rheo/rho", "rheo/status",
    "shape", "smd/contact/radius", "smd/mass/density", "sph/cv", "sph/e", "sph/rho", "spin/atom", "spin/atom/random",
    "spin/electron", "theta", "theta/random", "tri", "volume",
)  # fmt: skip
_IMAGES = 1024  # image flags are kept in ten bits


@dataclass
class _Value:
    """A number, or the name of an atom-style variable."""

    number: float = 0.0
    name: str = ""

    @classmethod
    def read(cls, sim: Simulation, args: Args, whole: bool = False) -> _Value:
        word = args.word()
        if not word.text.startswith("v_"):
            return cls(args.as_integer(word) if whole else args.as_number(word))
        style = Variables(sim).style(word.text[2:])
        if style is None:
            args.fail(f"Variable name {word.text} for set command does not exist", word)
        if style not in ("atom", "atomfile"):
            args.fail(f"Variable {word.text} for set command is invalid style", word, hint="an atom-style variable")
        return cls(name=word.text[2:])

    def of(self, sim: Simulation, rows: Rows) -> tuple[Rows, Any]:
        """The number, or (k,) numbers of the owned atoms among rows; and which rows those are."""
        if not self.name:
            return rows, self.number
        own = rows[rows < sim.atoms.n]
        return own, Variables(sim).per_atom(self.name)[own]

    def whole(self, sim: Simulation, rows: Rows) -> tuple[Rows, Any]:
        own, value = self.of(sim, rows)
        return own, value.astype(np.int64) if self.name else int(value)


class _Selection:
    """The selected atoms. Once a keyword has made ghosts, they count too (measured), though they keep nothing.

    rows  owned ones, and ghosts if there are any
    """

    def __init__(self, sim: Simulation, args: Args, style: Word, identity: Word) -> None:
        self.sim, self.style, self.name = sim, style.text, identity.text
        self.bit, self.range, self.rows = 0, range(0), np.zeros(0, np.int64)
        self.ghosts = False
        if self.style == "group":
            self.bit = sim.groups.bit(self.name)
            if not self.bit:
                args.fail(f"Could not find set group ID {self.name}", identity)
        elif self.style == "region":
            if self.name not in sim.regions:
                args.fail(f"Set region {self.name} does not exist", identity)
        elif self.style in ("atom", "type", "mol"):
            if self.style == "mol" and not sim.has_bonds:
                args.fail("Cannot use set mol with no molecule IDs defined", style)
            if self.style == "type":
                identity = sim.labels.resolved(args, "atom", identity)
            self.range = args.as_range(identity, 1, sim.atom_types if self.style == "type" else 2**31 - 1)
        else:
            args.fail(f"Unknown set or fix set command style: {self.style}", style, hint="atom mol type group region")

    def renew(self, ghosts: bool = False) -> None:
        """Select; ghosts: a keyword has just made them. Those of an earlier run do not count."""
        self.ghosts |= ghosts
        atoms = self.sim.atoms
        total = atoms.total if ghosts else atoms.n
        if self.style == "group":
            chosen = (atoms.mask[:total] & self.bit) != 0
        elif self.style == "region":
            chosen = self.sim.regions[self.name].inside(atoms.x[:total])
        else:
            values = {"atom": atoms.tag, "type": atoms.type, "mol": atoms.molecule}[self.style][:total]
            if self.style == "mol":
                values = values[atoms.rows_by_tag()[atoms.tag[:total]]]
            chosen = (values >= self.range.start) & (values < self.range.stop)
        self.rows = np.flatnonzero(chosen)


Action = Callable[[Simulation, _Selection], int]  # changes the selected atoms, returns how many settings it made


@command("set", needs_box=True)
def set_(sim: Simulation, args: Args) -> None:
    """Change properties of selected atoms. The selection is made once, then the keywords act in turn."""
    if sim.natoms == 0:
        args.fail("Set command on system without atoms", args.owner, hint="create_atoms or read_data comes first")
    args.need(4)
    style, identity = args.word(), args.word()
    selection = _Selection(sim, args, style, identity)
    actions = []
    while len(args):
        key = args.word()
        actions.append((key.text, _action(sim, args, key)))
    sim.console.both("Setting atom values ...\n")
    selection.renew()
    counts = [(name, action(sim, selection)) for name, action in actions]
    sim.console.both("".join(f"  {count} settings made for {name}\n" for name, count in counts))
    if selection.ghosts:
        sim.atoms.clear_ghosts()


def _action(sim: Simulation, args: Args, key: Word) -> Action:
    """Read a keyword's values; what it will do."""
    name = key.text
    if name in _PLAIN:
        args.need(1, name)
        return _plain(_Value.read(sim, args), *_PLAIN[name])
    if name in ("type", "mol"):
        args.need(1, name)
        return _whole(sim, args, name)
    if name in ("type/fraction", "type/ratio", "type/subset"):
        args.need(3, name)
        return _some_types(sim, args, name)
    if name == "image":
        args.need(3, name)
        return _image(sim, args)
    if name == "charge" and sim.style.charged:
        args.need(1, name)
        return _charge(_Value.read(sim, args))
    if name in KIND and KIND[name] in sim.style.kinds:
        args.need(1, name)
        return _topology(sim, args, name)
    if name in (*_ABSENT, *KIND, "charge"):
        args.fail(f"Cannot set attribute {name} for atom style {sim.atom_style}", key)
    if name == "temperature":
        args.fail("Cannot set this attribute for this atom style", key)
    if name.startswith(("i_", "d_", "i2_", "d2_")):
        args.fail(f"Set keyword or custom property {name.split('_', 1)[1].split('[')[0]} does not exist", key)
    hint = "type type/fraction type/ratio type/subset mol x y z vx vy vz charge image bond angle dihedral improper"
    args.fail(f"Unrecognized set or fix set command keyword {name}", key, hint=hint)


def _plain(value: _Value, field: str, axis: int) -> Action:
    def act(sim: Simulation, selection: _Selection) -> int:
        rows, numbers = value.of(sim, selection.rows)
        getattr(sim.atoms, field)[rows, axis] = numbers
        return len(selection.rows)

    return act


def _charge(value: _Value) -> Action:
    def act(sim: Simulation, selection: _Selection) -> int:
        rows, numbers = value.of(sim, selection.rows)
        sim.atoms.q[rows] = numbers
        return len(selection.rows)

    return act


def _whole(sim: Simulation, args: Args, name: str) -> Action:
    """Atom types and molecule IDs."""
    if name == "mol" and not sim.has_bonds:
        args.fail(f"Cannot set attribute mol for atom style {sim.atom_style}")
    if name == "type" and not args.words[args.at].text.startswith("v_"):
        sim.labels.translate(args, "atom")
    value = _Value.read(sim, args, whole=True)
    low, high = (1, sim.atom_types) if name == "type" else (0, 2**31 - 1)
    if not value.name and not low <= value.number <= high:
        what = "atom type" if name == "type" else f"molecule ID {value.number}"
        args.fail(f"Invalid {what} in set command", hint=f"types are 1 to {sim.atom_types}" if name == "type" else "")

    def act(sim: Simulation, selection: _Selection) -> int:
        rows, numbers = value.whole(sim, selection.rows)
        if value.name and ((numbers < low) | (numbers > high)).any():
            raise ScriptError(f"Invalid {'atom type' if name == 'type' else 'molecule ID'} in set command")
        (sim.atoms.type if name == "type" else sim.atoms.molecule)[rows] = numbers
        return len(selection.rows)

    return act


def _some_types(sim: Simulation, args: Args, name: str) -> Action:
    """type/fraction: each with a probability, drawn from seed and position; type/ratio, type/subset: exactly so many."""
    sim.labels.translate(args, "atom")
    kind = args.integer()
    if not 1 <= kind <= sim.atom_types:
        args.fail("Invalid atom type in set command", hint=f"types are 1 to {sim.atom_types}")
    if name == "type/subset":
        amount: float = args.integer()
        if amount < 0:
            args.fail("Invalid subset size in set command", hint="0 or more")
    else:
        amount = args.number()
        if not 0.0 <= amount <= 1.0:
            args.fail("Invalid fraction in set command", hint="from 0 to 1")
    seed = args.integer()
    if seed <= 0:
        args.fail("Invalid random number seed in set command", hint="a positive number")

    def act(sim: Simulation, selection: _Selection) -> int:
        rows = selection.rows
        if name == "type/fraction":
            picked: Any = park_at(seed, sim.atoms.x[rows], 1)[:, 0] <= amount
        else:
            wanted = int(amount * len(rows)) if name == "type/ratio" else int(amount)
            if wanted > len(rows):
                raise ScriptError(
                    "Set type/subset value exceeds eligible atoms", hint=f"{len(rows)} atoms are selected"
                )
            picked = select_subset(seed, wanted, len(rows))
        sim.atoms.type[rows[picked]] = kind
        return int(picked.sum())

    return act


def _image(sim: Simulation, args: Args) -> Action:
    flags: list[_Value | None] = []
    for d in range(3):
        if args.take("NULL"):
            flags.append(None)
            continue
        flag = _Value.read(sim, args, whole=True)
        if flag.number and not sim.box.periodic[d]:
            args.fail("Cannot set non-zero image flag for non-periodic dimension")
        flags.append(flag)

    def act(sim: Simulation, selection: _Selection) -> int:
        for d, flag in enumerate(flags):
            if flag is None:
                continue
            rows, numbers = flag.whole(sim, selection.rows)
            if flag.name and not sim.box.periodic[d] and np.any(numbers):
                raise ScriptError("Cannot set non-zero image flag for non-periodic dimension")
            sim.atoms.image[rows, d] = (numbers + _IMAGES // 2) % _IMAGES - _IMAGES // 2
        return len(selection.rows)

    return act


def _topology(sim: Simulation, args: Args, name: str) -> Action:
    """The type of bonds, angles, dihedrals, impropers all of whose atoms are selected."""
    kind = KIND[name]
    sim.labels.translate(args, name)
    number = args.integer()
    if not 1 <= number <= kind.types(sim):
        args.fail(f"Invalid {name} type {number} in set command", hint=f"{name} types are 1 to {kind.types(sim)}")

    def act(sim: Simulation, selection: _Selection) -> int:
        sim.console.both("  system init for set ...\n")
        initialise(sim)
        wrap_atoms(sim, Ghosts(sim))
        selection.renew(ghosts=True)
        found = entries(sim, kind)
        if (found.at(sim) < 0).any():
            raise ScriptError(f"{name.capitalize()} atom missing in set command")
        found = found.take(np.isin(found.tags, sim.atoms.tag[selection.rows]).all(axis=1))
        kind.kinds(sim)[found.rows, found.slots] = number
        return len(found)

    return act
