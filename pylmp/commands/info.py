"""info CATEGORY... [out screen | log | append FILE | overwrite FILE]"""

from __future__ import annotations

import time

from pylmp.io.information import CATEGORIES, STYLES, styles
from pylmp.model.paths import writable
from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.text.words import Args, Word

_RULE = "Info-Info-Info-Info-Info-Info-Info-Info-Info-Info-Info\n"


@command("info")
def info(sim: Simulation, args: Args) -> None:
    """Tell about the state: system communication computes dumps fixes groups regions variables coeffs styles time, all."""
    wanted: set[str] = set()
    kind = ""
    file: tuple[Word, str] | None = None
    logged = False
    while len(args):
        word = args.word()
        following = args.peek()
        if word.text == "all":
            wanted |= {*CATEGORIES, "styles"}
            kind = "all"
        elif word.text in CATEGORIES:
            wanted.add(word.text)
        elif word.text == "styles":
            wanted.add("styles")
            kind = args.word().text if following is not None and following.text in STYLES else "all"
        elif word.text == "out" and following is not None and following.text in ("screen", "log"):
            logged, file = args.word().text == "log", None
        elif word.text == "out" and following is not None and following.text in ("append", "overwrite") and len(args) > 1:
            mode = "a" if args.word().text == "append" else "w"
            file = args.word(), mode
        else:
            sim.console.warning(f"Ignoring unknown or incorrect info command flag: {word.text}")
    text = f"\n{_RULE}Printed on {time.ctime()}\n"
    text += "".join(tell(sim) for name, tell in CATEGORIES.items() if name in wanted)
    text += styles(kind) if "styles" in wanted else ""
    text += f"\n{_RULE}\n"
    if file is not None:
        path = writable(sim, file[0])
        try:
            with path.open(file[1]) as stream:
                stream.write(text)
        except OSError as error:
            args.fail(f"Cannot open info file {path}: {error.strerror}", file[0])
    elif logged:
        sim.console.log(text)
    else:
        sim.console.screen(text)
