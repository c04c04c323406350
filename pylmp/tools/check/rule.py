"""What a rule is. A rule is one file in rules/, found by being there."""

from __future__ import annotations

import importlib
import pkgutil
from functools import cache
from typing import TYPE_CHECKING, ClassVar

from pylmp.model.scene import Scene
from pylmp.text.words import Word

if TYPE_CHECKING:
    from pylmp.tools.check.look import Look


class Rule:
    """What LAMMPS accepts and people regret.

    The docstring: one sentence; why it matters; scripts under `Okay:` and `Bad:`, which are the rule's tests.
    One object sees one script: before and after each command, at each run, at the end.
    """

    code: ClassVar[str]
    name: ClassVar[str]
    severity: ClassVar[str] = "warning"
    manual: ClassVar[str] = ""

    def before(self, look: Look, words: list[Word]) -> None:
        """A command is about to be carried out, its variables replaced, its name first."""

    def after(self, look: Look, words: list[Word]) -> None:
        """A command was carried out without an error."""

    def run(self, look: Look, scene: Scene, steps: int) -> None:
        """A run or minimization begins; everything checked itself."""

    def end(self, look: Look, whole: bool) -> None:
        """The script is over; whole: it was followed to its end."""


@cache
def rules() -> tuple[type[Rule], ...]:
    """All rules, by code."""
    from pylmp.tools.check import rules as folder

    for module in pkgutil.iter_modules(folder.__path__):
        importlib.import_module(f"{folder.__name__}.{module.name}")
    return tuple(sorted(Rule.__subclasses__(), key=lambda rule: rule.code))
