"""print TEXT [file F] [append F] [screen yes|no] [universe yes|no]"""

from __future__ import annotations

from pathlib import Path

from pylmp.model.paths import writable
from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.text.words import Args


@command("print")
def print_(sim: Simulation, args: Args) -> None:
    """Write text, variables replaced, to screen and log, and to a file if asked."""
    args.need(1)
    text = sim.script.substitute_text(args.word()) + "\n"
    shown, again = True, False
    file: tuple[Path, str] | None = None
    while len(args):
        key = args.word()
        if key.text not in ("file", "append", "screen", "universe"):
            args.fail(f"Unknown print keyword: {key.text}", key, hint="file append screen universe")
        if not len(args):
            args.fail(f"Illegal print {key.text} command: missing argument(s)", key)
        if key.text in ("file", "append"):
            file = writable(sim, args.word()), "w" if key.text == "file" else "a"
        elif key.text == "screen":
            shown = args.yes()
        else:
            again = args.yes()
    if shown:
        sim.console.both(text)
    if file is not None:
        with file[0].open(file[1]) as stream:
            stream.write(text)
    if again:  # LAMMPS prints once more for all partitions together, of which there is one
        sim.console.both(text)
