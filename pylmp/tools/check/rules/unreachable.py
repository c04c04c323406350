"""P106."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from pylmp.text.lines import logical_lines
from pylmp.tools.check.holes import without_templates
from pylmp.tools.check.rule import Rule

if TYPE_CHECKING:
    from pylmp.tools.check.look import Look


class Unreachable(Rule):
    """No way leads to this line.

    It follows a quit, or a jump that no next command can let pass, and no label stands in between. What it says is not done.

    Okay:
        print "one"
        jump SELF end
        label end
        print "two"
        quit

    Bad:
        print "one"
        quit
        print "two"

    Bad:
        jump SELF end
        print "one"
        label end
    """

    code = "P106"
    name = "unreachable"
    manual = "jump.html"

    def end(self, look: Look, whole: bool) -> None:
        texts = look.files()
        loops = any(re.search(r"(?<![\w-])next\s", text) for text in texts.values())
        for name, text in texts.items():
            last = ""
            for line in logical_lines(without_templates(text), name):
                words = line.text.split("#")[0].split()
                if not words:
                    continue
                if words[0] == "label":
                    last = ""
                elif last:
                    start = line.text.find(words[0])
                    span = line.span(start, start + len(words[0]))
                    if (span.file, span.line) not in look.places:
                        look.warn(self, span, f"No way leads to here, after this {last}")
                    last = ""
                if words[0] == "quit" or (words[0] == "jump" and not loops):
                    last = words[0]
