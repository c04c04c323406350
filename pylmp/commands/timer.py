"""timer [off|loop|normal|full] [sync|nosync] [timeout H:M:S|off|unlimited] [every N]"""

from __future__ import annotations

import re

from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.model.timer import STYLES
from pylmp.text.words import Args, Word


@command("timer")
def timer(sim: Simulation, args: Args) -> None:
    """What the log says about time after a run, and how long runs may take."""
    settings = sim.timer
    while len(args):
        key = args.word()
        if key.text in STYLES:
            settings.style = key.text
        elif key.text in ("sync", "nosync"):
            settings.sync = key.text == "sync"
        elif key.text in ("timeout", "every"):
            if not len(args):
                args.fail(f"Illegal timer {key.text} command: missing argument(s)", key)
            if key.text == "timeout":
                settings.set_limit(_seconds(args, key, args.word()))
                continue
            settings.every = args.integer()
            if settings.every <= 0:
                args.fail("Illegal timer every frequency: every", hint="a positive number of steps")
        else:
            args.fail(f"Unknown timer keyword {key.text}", key, hint=" ".join((*STYLES, "sync nosync timeout every")))
    sim.console.both(f"New timer settings: {settings}\n")


def _seconds(args: Args, key: Word, word: Word) -> float | None:
    """S, M:S or H:M:S."""
    if word.text in ("off", "unlimited"):
        return None
    if not re.fullmatch(r"\d{1,9}(:\d{1,9}){0,2}", word.text):
        args.fail(f"Illegal timeout time: {key.text}", word, hint="hours:minutes:seconds, as in 1:30:00")
    seconds = 0
    for part in word.text.split(":"):
        seconds = seconds * 60 + int(part)
    return float(seconds)
