"""Holes: values that only a simulation knows. They are NaN, which spreads through formulas by itself, and "nan" in texts."""

from __future__ import annotations

import re
from typing import Any

import numpy as np

from pylmp.model.simulation import Simulation
from pylmp.references.scope import Scope
from pylmp.text.diagnostic import ScriptError
from pylmp.text.variables import Variables

HOLE = "nan"
_HOLE = re.compile(r"(?<![A-Za-z0-9_])-?nan_*(?![A-Za-z0-9])")
_TEMPLATE = re.compile(r"\{\{.*?\}\}")
_BLOCK = re.compile(r"\{[%#].*?[%#]\}")
_ALWAYS = {
    "step",
    "dt",
    "atoms",
    "natoms",
    "lx",
    "ly",
    "lz",
    "xlo",
    "xhi",
    "ylo",
    "yhi",
    "zlo",
    "zhi",
    "vol",
    "bonds",
}  # known while nothing moved


def is_hole(text: str) -> bool:
    """Does a value that is not known stand in text?"""
    return HOLE in text and _HOLE.search(text) is not None


def without_templates(text: str) -> str:
    """A script whose marks {{x}} are holes of the same width; lines of a template language become blank."""
    text = _BLOCK.sub(lambda found: " " * len(found[0]), text)
    return _TEMPLATE.sub(lambda found: HOLE + "_" * (len(found[0]) - len(HOLE)), text)


class HoleScope(Scope):
    """The scope of formulas that notes when a value was read that only a run could know. met: that happened."""

    def __init__(self, sim: Simulation, variables: Variables) -> None:
        super().__init__(sim, variables)
        self.met = False

    def variable(self, name: str, index: tuple[int, ...], mode: str, rows: Any) -> Any:
        known = self.variables.known.get(name)
        if (
            known is not None
            and known.style in ("index", "string", "loop", "getenv", "internal")
            and is_hole(known.text() or "")
        ):
            return self._hole()
        return super().variable(name, index, mode, rows)

    def keyword(self, name: str) -> float:
        if is_hole(name):
            return self._hole()
        value = self._try(lambda: super(HoleScope, self).keyword(name))
        if name not in ("step", "dt") and (self.sim.ran or name not in _ALWAYS):
            return self._hole()
        return float(value)

    def measured(self, kind: str, name: str, index: tuple[int, ...], mode: str) -> Any:
        value = self._try(lambda: super(HoleScope, self).measured(kind, name, index, mode))
        return value * self._hole() if isinstance(value, np.ndarray) else self._hole()

    def atom(self, name: str, tag: int) -> float:
        value = super().atom(name, tag)
        return self._hole() if self.sim.ran and name not in ("id", "type", "mass", "q") else value

    def named(self, function: str, names: tuple[str, ...], mode: str) -> Any:
        value = self._try(lambda: super(HoleScope, self).named(function, names, mode))
        moves = self.sim.ran and function not in (
            "count",
            "mass",
            "charge",
            "is_active",
            "is_defined",
            "is_available",
            "is_file",
            "is_os",
            "next",
        )
        return self._hole() if moves and not isinstance(value, np.ndarray) else value

    def _hole(self) -> float:
        self.met = True
        return float("nan")

    def _try(self, read: Any) -> Any:
        """What read gives; a hole where a run would have made the value current."""
        try:
            return read()
        except ScriptError as error:
            message = error.diagnostic.message
            if not self.sim.ran or not ("current" in message or "not tallied" in message):
                raise
            return self._hole()
