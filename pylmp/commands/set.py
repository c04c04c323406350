"""set STYLE ID keyword values..."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from pylmp.kernels.random import park_at
from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.text.diagnostic import Unsupported
from pylmp.text.words import Args, Word

_PLAIN = {"x": ("x", 0), "y": ("x", 1), "z": ("x", 2), "vx": ("v", 0), "vy": ("v", 1), "vz": ("v", 2)}
_ELSEWHERE = (
    "angle", "angmom", "apip/lambda", "bond", "cc", "charge", "density", "density/disc", "diameter", "dihedral", "dipole",
    "dipole/random", "dpd/theta", "edpd/cv", "edpd/temp", "epsilon", "image", "improper", "length", "mass", "mol", "omega",
    "quat", "quat/random", "radius/electron", "shape", "smd/contact/radius", "smd/mass/density", "sph/cv", "sph/e", "sph/rho",
    "spin/atom", "spin/atom/random", "spin/electron", "temperature", "theta", "theta/random", "tri", "type/ratio", "type/subset",
    "volume",
)  # fmt: skip


@command("set", needs_box=True)
def set_(sim: Simulation, args: Args) -> None:
    """Change properties of selected atoms. The selection is made once, then the keywords act in turn."""
    args.need(4)
    style, identity = args.word(), args.word()
    chosen = _select(sim, args, style, identity)
    sim.console.both("Setting atom values ...\n")
    while len(args):
        key = args.word()
        if key.text in _PLAIN:
            name, axis = _PLAIN[key.text]
            args.need(1)
            word = args.word()
            if word.text.startswith("v_"):
                raise Unsupported("LAMMPS has variables in set, pylmp's native engines do not", word.span)
            getattr(sim.atoms, name)[: sim.atoms.n][chosen, axis] = args.as_number(word)
            count = int(chosen.sum())
        elif key.text == "type":
            kind = _type(sim, args)
            sim.atoms.type[: sim.atoms.n][chosen] = kind
            count = int(chosen.sum())
        elif key.text == "type/fraction":
            count = _fraction(sim, args, chosen)
        elif key.text in _ELSEWHERE or key.text.startswith(("i_", "d_", "i2_", "d2_")):
            raise Unsupported(f"LAMMPS has set keyword {key.text}, pylmp's native engines do not", key.span)
        else:
            args.fail(f"Unrecognized set or fix set command keyword {key.text}", key, hint="type type/fraction x y z vx vy vz")
        sim.console.both(f"  {count} settings made for {key.text}\n")


def _select(sim: Simulation, args: Args, style: Word, identity: Word) -> NDArray[np.bool_]:
    atoms = sim.atoms
    n = atoms.n
    if style.text == "group":
        bit = sim.groups.bit(identity.text)
        if not bit:
            args.fail(f"Could not find set group ID {identity.text}", identity)
        return (atoms.mask[:n] & bit) != 0
    if style.text == "region":
        if identity.text not in sim.regions:
            args.fail(f"Set region {identity.text} does not exist", identity)
        return np.asarray(sim.regions[identity.text].inside(atoms.x[:n]))
    fields: dict[str, Any] = {"atom": atoms.tag, "type": atoms.type, "mol": atoms.molecule}
    if style.text not in fields:
        args.fail(f"Unknown set or fix set command style: {style.text}", style, hint="atom mol type group region")
    values = fields[style.text][:n]
    high = sim.atom_types if style.text == "type" else np.iinfo(np.int64).max
    chosen = args.as_range(identity, 1, int(high))
    return np.asarray((values >= chosen.start) & (values < chosen.stop))


def _type(sim: Simulation, args: Args) -> int:
    args.need(1)
    word = args.word()
    kind = args.as_integer(word)
    if not 1 <= kind <= sim.atom_types:
        args.fail(f"Numeric index {kind} is out of bounds (1-{sim.atom_types})", word)
    return kind


def _fraction(sim: Simulation, args: Args, chosen: NDArray[np.bool_]) -> int:
    """Each selected atom changes with this probability; the draw depends on seed and position only."""
    args.need(3)
    kind = _type(sim, args)
    fraction = args.number()
    if not 0.0 <= fraction <= 1.0:
        args.fail("Invalid fraction in set command", hint="from 0 to 1")
    seed = args.integer()
    if seed <= 0:
        args.fail("Invalid random number seed in set command", hint="a positive number")
    draws = park_at(seed, sim.atoms.x[: sim.atoms.n], 1)[:, 0]
    changed = chosen & (draws <= fraction)
    sim.atoms.type[: sim.atoms.n][changed] = kind
    return int(changed.sum())
