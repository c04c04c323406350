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
    text = sim.script.substitute_text(args.word())
    screen = True
    file: tuple[Path, str] | None = None
    while len(args):
        key = args.word()
        if key.text in ("file", "append"):
            args.need(1)
            word = args.word()
            file = writable(sim, word), "w" if key.text == "file" else "a"
        elif key.text in ("screen", "universe"):
            args.need(1)
            value = args.yes()
            screen = value if key.text == "screen" else screen
        else:
            args.fail(f"Unknown print keyword: {key.text}", key, hint="file append screen")
    if screen:
        sim.console.screen(text + "\n")
    sim.console.log(text + "\n")
    if file is not None:
        with file[0].open(file[1]) as stream:
            stream.write(text + "\n")
