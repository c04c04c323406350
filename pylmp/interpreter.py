"""Line by line: a stand-in until the language floor is done."""

from __future__ import annotations

import shlex

from pylmp.model.registry import COMMANDS
from pylmp.model.simulation import Simulation
from pylmp.text.diagnostic import ScriptError
from pylmp.text.span import Span
from pylmp.text.words import Args, Word


def run_text(sim: Simulation, text: str, name: str = "<script>") -> None:
    for number, line in enumerate(text.splitlines(), 1):
        words = [Word(w, Span(name, number, 1)) for w in shlex.split(line, comments=True)]
        if not words:
            continue
        found = COMMANDS.find(words[0].text)
        if found is None:
            raise ScriptError(f"Unknown command: {line}", words[0].span)
        if found.needs_box and not sim.has_box:
            raise ScriptError(f"{found.name.capitalize()} command before simulation box is defined", words[0].span)
        found.run(sim, Args(found.name, words[1:], words[0], found.manual))
