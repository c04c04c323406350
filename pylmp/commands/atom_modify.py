"""atom_modify map VALUE sort EVERY BINSIZE"""

from __future__ import annotations

from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.text.diagnostic import Unsupported
from pylmp.text.words import Args


@command("atom_modify")
def atom_modify(sim: Simulation, args: Args) -> None:
    """Spatial sorting; the kind of ID map is accepted and makes no difference here."""
    args.need(1)
    while len(args):
        word = args.word()
        if word.text == "map":
            kind = args.word()
            if kind.text not in ("array", "hash", "yes", "no"):
                args.fail(f"Unknown atom_modify map argument {kind.text}", kind, hint="array hash yes no")
            if sim.has_box:
                args.fail("Atom_modify map command after simulation box is defined", word)
            sim.map_style = kind.text
        elif word.text == "sort":
            args.need(2)
            every, size = args.integer(), args.number()
            if every < 0 or size < 0.0:
                args.fail(f"Illegal atom_modify sort frequency {every}" if every < 0 else f"Illegal atom_modify sort bin size {size:g}")
            sim.sort.every, sim.sort.bin_size = every, size
        elif word.text in ("id", "first"):
            raise Unsupported(f"LAMMPS has atom_modify {word.text}, pylmp's native engines do not", word.span)
        else:
            args.fail(f"Illegal atom_modify command argument: {word.text}", word, hint="map sort")
