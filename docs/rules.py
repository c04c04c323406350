"""Write docs/rules.md from the docstrings of the rules: python docs/rules.py"""

from __future__ import annotations

import inspect
from pathlib import Path

from pylmp.tools.check.codes import CODES
from pylmp.tools.check.rule import rules

PAGE = Path(__file__).with_suffix(".md")


def page() -> str:
    """The whole page."""
    lines = [
        "# Rules of pylmp check",
        "",
        "Written by docs/rules.py from the docstrings of pylmp/tools/check/rules/.",
        "",
        "## Codes that are no rule's",
        "",
    ]
    lines += [f"- `{code}`: {text}" for code, text in CODES.items()]
    for rule in rules():
        text = inspect.getdoc(rule) or ""
        lines += [
            "",
            f"## {rule.code} {rule.name} ({rule.severity})",
            "",
            text.replace("Okay:\n", "Okay:\n\n").replace("Bad:\n", "Bad:\n\n"),
        ]
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    PAGE.write_text(page())
