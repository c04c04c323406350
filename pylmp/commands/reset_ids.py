"""reset_ids, reset_atom_ids, reset_mol_ids: older names of reset_atoms id and reset_atoms mol."""

from __future__ import annotations

from pylmp.commands.reset_atoms import renamed
from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.text.words import Args


@command("reset_ids", manual="reset_atoms.html", needs_box=True)
def reset_ids(sim: Simulation, args: Args) -> None:
    """reset_atoms id."""
    renamed(sim, args, "reset_ids", "id")


@command("reset_atom_ids", manual="reset_atoms.html", needs_box=True)
def reset_atom_ids(sim: Simulation, args: Args) -> None:
    """reset_atoms id."""
    renamed(sim, args, "reset_atom_ids", "id")


@command("reset_mol_ids", manual="reset_atoms.html", needs_box=True)
def reset_mol_ids(sim: Simulation, args: Args) -> None:
    """reset_atoms mol."""
    renamed(sim, args, "reset_mol_ids", "mol")
