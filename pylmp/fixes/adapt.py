"""fix ID GROUP adapt N pair STYLE PARAM I J v_NAME | bond STYLE PARAM I v_NAME ... [scale yes|no] [reset yes|no] [mass yes|no]

N: every so many steps, 0: when a run begins. PARAM of the types I (J) becomes the value of the variable; with scale yes, that many times
what it was when the run began. reset yes: as it was, once the run is over. What mixes with it is mixed anew. Angles, kspace and
properties of atoms are adapted by LAMMPS only. Source: LAMMPS manual, fix_adapt.html.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

from pylmp.model.fix import Fix
from pylmp.model.pair import PairPart, Types
from pylmp.model.quantity import Quantity
from pylmp.model.registry import FIXES
from pylmp.model.simulation import Simulation
from pylmp.text.diagnostic import ScriptError, Unsupported
from pylmp.text.words import Args, Word

_ATTRIBUTES = ("pair", "bond", "angle", "kspace", "atom")


@dataclass
class Change:
    """One parameter. number: of its style under hybrid, 0 if not said; before: what it was when the run began."""

    style: str
    number: int
    param: str
    first: range
    second: range
    value: Quantity
    part: PairPart | None = None
    at: int = 0
    before: dict[Types, float] = field(default_factory=dict)

    def find(self, sim: Simulation) -> None:
        """Raises ScriptError if there is no such style or parameter."""
        parts = sim.pair.parts if sim.pair else []
        same = [part for part in parts if part.style.name == self.style]
        if sim.pair and sim.pair.hybrid and self.number:
            same = [part for part in same if part.number == self.number or (len(same) == 1 and self.number == 1)]
        if len(same) != 1:
            known = " ".join(part.called for part in parts)
            raise ScriptError(f"Fix adapt pair style {self.style} not found", hint=f"pair styles here: {known}")
        part = self.part = same[0]
        if self.param not in part.style.adapts:
            text = f"Fix adapt pair style {self.style} param {self.param} not supported"
            raise ScriptError(text, hint=" ".join(part.style.adapts) or "this style has none")
        self.at = part.style.adapts.index(self.param)
        pairs = [(i, j) for i in self.first for j in self.second if i <= j]
        if sim.pair and sim.pair.hybrid and any(pair not in part.all for pair in pairs):
            text = f"Fix adapt type pair range is not valid for pair hybrid sub-style {self.style}"
            raise ScriptError(text, hint="types that pair_coeff gives to this style")
        self.before = {pair: part.given[pair][0][self.at] for pair in pairs if pair in part.given}

    def apply(self, values: dict[Types, float]) -> None:
        assert self.part is not None
        for pair, value in values.items():
            coeffs, cut = self.part.given[pair]
            self.part.given[pair] = (*coeffs[: self.at], value, *coeffs[self.at + 1 :]), cut


@dataclass
class BondChange:
    """The same of a bond style, for some types of bonds."""

    style: str
    param: str
    kinds: range
    value: Quantity
    table: Any = None
    at: int = 0
    before: dict[int, float] = field(default_factory=dict)

    def find(self, sim: Simulation) -> None:
        """Raises ScriptError if there is no such style or parameter."""
        parts = sim.bond.parts if sim.bond else []
        part = next((part for part in parts if part.style.name == self.style), None)
        if part is None:
            known = " ".join(part.style.name for part in parts)
            raise ScriptError(f"Fix adapt bond style {self.style} does not exist", hint=f"bond styles here: {known}")
        if self.param not in part.style.adapts:
            text = f"Fix adapt bond style parameter {self.param} not supported"
            raise ScriptError(text, hint=" ".join(part.style.adapts) or "pylmp adapts nothing of this style")
        if not all(part.mine[kind] for kind in self.kinds):
            text = f"Fix adapt type bond range is not valid for bond hybrid sub-style {self.style}"
            raise ScriptError(text, hint="types that bond_coeff gives to this style")
        self.at, self.table = part.style.adapts.index(self.param), part.table
        self.before = {kind: float(part.table[kind, self.at]) for kind in self.kinds}

    def apply(self, values: dict[int, float]) -> None:
        for kind, value in values.items():
            self.table[kind, self.at] = value


@FIXES.register("adapt")
class Adapt(Fix):
    style = "adapt"

    def __init__(self, sim: Simulation, identity: str, group: str, bit: int, args: Args) -> None:
        super().__init__(sim, identity, group, bit, args)
        args.need(2)
        every = args.word()
        self.interval = args.as_integer(every)
        if self.interval < 0:
            args.fail(f"Illegal fix adapt every value {self.interval}", every)
        self.changes: list[Change | BondChange] = []
        while (word := args.peek()) is not None and word.text in _ATTRIBUTES:
            self.changes.append(self._attribute(sim, args, args.word()))
        if not self.changes:
            args.fail("Nothing to adapt in fix adapt command", args.peek(), hint="pair STYLE PARAM I J v_NAME")
        said = {"scale": False, "reset": False, "mass": False}
        while len(args):
            key = args.word()
            if key.text not in said:
                args.fail(f"Unknown fix adapt keyword {key.text}", key, hint=" ".join(said))
            args.need(1, key.text)
            said[key.text] = args.yes()
        self.scale, self.reset = said["scale"], said["reset"]

    @staticmethod
    def _attribute(sim: Simulation, args: Args, key: Word) -> Change | BondChange:
        if key.text not in ("pair", "bond"):
            raise Unsupported(
                f"LAMMPS has fix adapt {key.text}, pylmp's native engines do not", key.span,
                hint="--engine lammps runs this script on LAMMPS", manual="fix_adapt.html",
            )  # fmt: skip
        args.need(5 if key.text == "pair" else 4, key.text)
        name, _, number = args.word().text.partition(":")
        param = args.word().text
        most = [sim.atom_types, sim.atom_types] if key.text == "pair" else [sim.bond_types]
        ranges = [args.as_range(args.word(), 1, types) for types in most]
        variable = args.word()
        if not variable.text.startswith("v_"):
            args.fail(f"Argument must be variable not {variable.text}", variable, hint="v_NAME")
        value = Quantity(name=variable.text[2:])
        if key.text == "bond":
            return BondChange(name, param, ranges[0], value)
        return Change(name, int(number) if number.isdigit() else 0, param, ranges[0], ranges[1], value)

    def init(self, sim: Simulation) -> None:
        for change in self.changes:
            missing = "Variable name {} for {} does not exist"
            change.value.check(sim, "fix adapt", missing=missing)
            change.find(sim)

    def setup_pre_force(self, sim: Simulation) -> None:
        if sim.relaxing:  # a minimization takes things as they are
            return
        with self.reading(sim, sim.step + self.interval):
            for change in self.changes:
                value = change.value.number(sim)
                now: dict[Any, float] = {key: value * before if self.scale else value for key, before in change.before.items()}
                change.apply(now)
        self._renew()

    def pre_force(self, sim: Simulation) -> None:
        if self.interval and sim.step % self.interval == 0:
            self.setup_pre_force(sim)

    def post_run(self, sim: Simulation) -> None:
        if self.reset:
            for change in self.changes:
                before: dict[Any, float] = change.before
                change.apply(before)
            self._renew()

    def _renew(self) -> None:
        for part in {id(change.part): change.part for change in self.changes if isinstance(change, Change)}.values():
            if part is not None:
                part.renew()
