"""create_box NTYPES REGION keywords..."""

from __future__ import annotations

import numpy as np

from pylmp.model.atoms import Atoms
from pylmp.model.box import Box
from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.model.topology import KIND, KINDS
from pylmp.model.triclinic import Triclinic
from pylmp.text.diagnostic import Unsupported
from pylmp.text.number import eight
from pylmp.text.words import Args


def describe(box: Box) -> str:
    """`orthogonal box = (0 0 0) to (4 5 6)`, `triclinic box = (0 0 0) to (4 5 6) with tilt (1 0 0)`"""
    low, high, tilt = (" ".join(eight(float(c)) for c in triple) for triple in (box.lo, box.hi, box.tilt))
    if box.triclinic:
        return f"triclinic box = ({low}) to ({high}) with tilt ({tilt})"
    return f"orthogonal box = ({low}) to ({high})"


def announce(sim: Simulation, prefix: str = "  ") -> None:
    """Say what the box is, check and set it as LAMMPS does wherever a box begins or begins anew."""
    sim.console.both(f"{prefix}{describe(sim.box)}\n")
    sim.box.set_initial(sim.console)
    sim.console.both("  1 by 1 by 1 MPI processor grid\n")


@command("create_box")
def create_box(sim: Simulation, args: Args) -> None:
    """Make the box from a region's extent, without atoms."""
    args.need(2)
    types, name = args.integer(), args.word()
    if sim.has_box:
        args.fail("Cannot create_box after simulation box is defined", args.owner, hint="clear starts anew")
    if name.text == "NULL":
        raise Unsupported("LAMMPS has general triclinic boxes, pylmp's native engines do not", name.span, hint="region prism")
    region = sim.regions.get(name.text)
    if region is None:
        args.fail(f"Create_box region {name.text} does not exist", name)
    if region.bounds is None:
        args.fail("Create_box region does not support a bounding box", name, hint="a region without side out")
    options = _options(sim, args)
    low, high, tilt = region.cell or (*region.bounds, None)
    if sim.dimension == 2:
        if sim.boundary[2][0] != "p":
            args.fail("Cannot run 2d simulation with nonperiodic Z dimension", args.owner, hint="boundary x y p")
        if low[2] >= 0.0 or high[2] <= 0.0:
            args.fail("Create_box region zlo/zhi for 2d simulation must straddle 0.0", name)
    lo, hi = np.array(low), np.array(high)
    if tilt is None:
        sim.box = Box(lo, hi, sim.boundary, sim.dimension)
    else:
        sim.box = Triclinic(lo, hi, sim.boundary, sim.dimension, np.array(tilt))
    announce(sim, "Created ")
    sim.define_types(types, *(options[f"{kind.name}/types"] for kind in KINDS))
    sim.extra_special = options["extra/special/per/atom"]
    slots = {kind.name: options[f"extra/{kind.name}/per/atom"] for kind in KINDS[1:]}
    sim.atoms = Atoms(options["extra/bond/per/atom"], 1 + sim.extra_special, **slots)
    sim.step = 0


def _options(sim: Simulation, args: Args) -> dict[str, int]:
    options = {word: 0 for kind in KINDS for word in (f"{kind.name}/types", f"extra/{kind.name}/per/atom")}
    options["extra/special/per/atom"] = 0
    while len(args):
        word = args.word()
        if word.text not in options:
            args.fail(f"Unknown create_box keyword: {word.text}", word, hint=" ".join(options))
        args.need(1)
        value = args.integer()
        name = word.text.split("/")[0 if word.text.endswith("types") else 1]
        if name == "special":
            options[word.text] += value
        elif KIND[name] in sim.style.kinds:
            options[word.text] = value
        else:
            args.fail(f"No {name}s allowed with atom style {sim.atom_style}", word)
    return options
