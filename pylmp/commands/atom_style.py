"""atom_style atomic|charge|bond|angle|molecular|full"""

from __future__ import annotations

from pylmp.model.atom_style import ATOM_STYLES
from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.model.unknown import is_elsewhere, unsupported
from pylmp.text.words import Args


@command("atom_style")
def atom_style(sim: Simulation, args: Args) -> None:
    """What atoms carry: charge, molecule ID, bonds, angles, dihedrals, impropers."""
    word = args.word()
    if sim.has_box:
        args.fail("Atom_style command after simulation box is defined", args.owner, hint="atom_style comes before the box")
    if is_elsewhere("atom", word.text):
        raise unsupported("atom", word)
    if word.text not in ATOM_STYLES:
        args.fail(f"Unrecognized atom style '{word.text}'", word, hint=" ".join(ATOM_STYLES))
    if len(args):
        args.fail("Invalid atom_style command", args.peek())
    sim.style = ATOM_STYLES[word.text]
