"""log FILE [append], log none"""

from __future__ import annotations

from typing import TextIO, cast

from pylmp.model.paths import writable
from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.text.words import Args


@command("log")
def log(sim: Simulation, args: Args) -> None:
    """Close the log file and open another."""
    args.expect(1, 2, "1 or 2 argument(s)")
    word = args.word()
    mode = "w"
    if len(args):
        key = args.word()
        if key.text != "append":
            args.fail(f"Unknown log keyword: {key.text}", key, hint="append")
        mode = "a"
    console = sim.console
    stream: TextIO | None = None
    if word.text != "none":
        try:
            stream = cast(TextIO, writable(sim, word).open(mode, buffering=1))
        except OSError as error:
            args.fail(f"Cannot open logfile {word.text}: {error.strerror}", word)
    if console.log_file is not None:
        console.log_file.close()
    console.log_file = stream
