"""compute ID GROUP property/atom attributes...: what atoms are, as per-atom values: id mol proc type mass x y z xs .. xu .. ix ..
vx .. fx .. nbonds. Source: LAMMPS manual, compute_property_atom.html.
"""

from __future__ import annotations

import re
from typing import Any

import numpy as np

from pylmp.dumps.attributes import ATTRIBUTES, absent
from pylmp.model.atoms import Floats
from pylmp.model.compute import Compute
from pylmp.model.registry import COMPUTES
from pylmp.model.simulation import Simulation
from pylmp.text.words import Args, Word

_NOT_HERE = ("element", "typelabel", "procp1", "xsu", "ysu", "zsu", "mu")
_NOT_ALLOCATED = ("spx", "spy", "spz", "sp", "buckling", "nbonds")
_SHAPES = {"corner": "tri", "end": "line"}


@COMPUTES.register("property/atom")
class PropertyAtom(Compute):
    style = "property/atom"

    def __init__(self, sim: Simulation, identity: str, group: str, bit: int, args: Args) -> None:
        super().__init__(sim, identity, group, bit, args)
        args.need(1)
        self.names = []
        for word in args.rest():
            self._check(sim, args, word)
            self.names.append(word.text)
        self.columns = len(self.names) if len(self.names) > 1 else 0

    @staticmethod
    def _check(sim: Simulation, args: Args, word: Word) -> None:
        name = word.text
        if name == "nbonds" and sim.has_bonds or (name in ATTRIBUTES and name not in _NOT_HERE):
            if not absent(sim, name):
                return
        if found := re.match(r"[id]2?_(\w+)", name):
            args.fail(f"Compute property/atom property {found[1]} does not exist", word)
        if found := re.fullmatch(r"(corner|end)\d[xyz]", name):
            args.fail(f"Compute property/atom {name} requires atom style {_SHAPES[found[1]]}", word)
        if absent(sim, name) or name in _NOT_ALLOCATED:
            args.fail(f"Compute property/atom {name} is not available", word, hint=f"atom_style {sim.atom_style} has none")
        text = f"Invalid keyword {name} for atom style {sim.atom_style} in compute property/atom command "
        args.fail(text, word, hint=" ".join(ATTRIBUTES))

    def per_atom(self, sim: Simulation) -> Floats:
        """(n,) with one attribute, else (n, attributes)."""
        rows = np.arange(sim.atoms.n)
        known: dict[Any, Any] = {}
        outside = ~self.members(sim)
        table = np.zeros((sim.atoms.n, len(self.names)))
        for k, name in enumerate(self.names):
            table[:, k] = sim.atoms.num_bond[rows] if name == "nbonds" else ATTRIBUTES[name].values(sim, rows, known)
        table[outside] = 0.0
        return table if self.columns else table[:, 0]
