"""fix_modify ID energy|virial yes|no, fix_modify ID temp COMPUTE-ID"""

from __future__ import annotations

from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.text.diagnostic import Unsupported
from pylmp.text.words import Args


@command("fix_modify")
def fix_modify(sim: Simulation, args: Args) -> None:
    """Count a fix in the energy or the pressure."""
    args.need(2)
    identity = args.word()
    fix = next((fix for fix in sim.fixes if fix.id == identity.text), None)
    if fix is None:
        args.fail(f"Could not find fix_modify ID {identity.text}", identity, hint="fix comes first")
    while len(args):
        key = args.word()
        if key.text in ("dynamic/dof", "bodyforces", "respa"):
            raise Unsupported(f"LAMMPS has fix_modify {key.text}, pylmp's native engines do not", key.span)
        if key.text in ("energy", "virial"):
            args.need(1, key.text)
            value = args.yes()
            if value and not getattr(fix, f"has_{key.text}"):
                args.fail(f"Fix {fix.id} {fix.style} does not support fix_modify {key.text} command", key)
            setattr(fix, f"in_{key.text}", value)
        elif not fix.modify(sim, args, key):
            args.fail(
                f"Fix {fix.id} {fix.style} does not support fix_modify {key.text} command", key, hint="energy yes|no"
            )
