"""Groups whose members change: the internal fix GROUP that LAMMPS keeps for each of them.

Source: LAMMPS manual, group.html. Membership is renewed at set-up and on multiples of ``every``, once the forces are there, before
any fix acts on them (measured).
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from pylmp.model.fix import Fix
from pylmp.model.region import named
from pylmp.model.variables import Variables
from pylmp.text.diagnostic import ScriptError, Unsupported
from pylmp.text.words import Args, Word

if TYPE_CHECKING:
    from pylmp.model.simulation import Simulation


class DynamicGroup(Fix):
    """group parent: members of it that satisfy all of region, variable. target: the bit of the dynamic group."""

    style = "GROUP"
    leads = minimizes = True
    internal = True

    def __init__(self, sim: Simulation, name: Word, args: Args) -> None:
        """args: what follows ``group ID dynamic``."""
        if not len(args):
            args.illegal(args.owner, hint="dynamic PARENT region|var|every ...")
        parent = args.word()
        if not len(args):
            args.illegal(parent, hint=f"dynamic {parent.text} region|var|every ...")
        bit = sim.groups.bit(parent.text)
        if not bit:
            args.fail(f"Group dynamic parent group {parent.text} does not exist", parent)
        if name.text == parent.text:
            args.fail("Group dynamic cannot reference itself", parent)
        if name.text == "all":
            args.fail("Group all cannot be made dynamic", name)
        self.target = 0
        self.step_every = 1
        self.region = self.variable = ""
        while len(args):
            key = args.word()
            if key.text not in ("region", "var", "property", "every"):
                args.fail(f"Unknown keyword {key.text} in dynamic group command", key, hint="region var every")
            args.need(1, f"dynamic {key.text}")
            value = args.word()
            if key.text == "region":
                if value.text not in sim.regions:
                    args.fail(f"Region {value.text} for dynamic group {name.text} does not exist", value)
                self.region = value.text
            elif key.text == "var":
                if Variables(sim).style(value.text) is None:
                    args.fail(f"Variable '{value.text}' for dynamic group {name.text} does not exist", value)
                self.variable = value.text
            elif key.text == "every":
                self.step_every = args.as_integer(value)
                if self.step_every <= 0:
                    args.fail(f"Illegal every value {value.text} for dynamic group {name.text}", value)
            else:
                raise Unsupported("LAMMPS has group dynamic property, pylmp's native engines do not", key.span)
        super().__init__(sim, f"GROUP_{name.text}", parent.text, bit, args)

    def init(self, sim: Simulation) -> None:
        if self.group in sim.groups.dynamic:
            raise ScriptError(f"Dynamic group parent group {self.group} cannot be dynamic", manual="group.html")
        if self.region:
            named(sim, self.region, f"dynamic group {self.group}")
        if self.variable:
            style = Variables(sim).style(self.variable)
            if style is None:
                raise ScriptError(f"Variable '{self.variable}' for dynamic group {self.group} does not exist")
            if style not in ("atom", "atomfile"):
                raise ScriptError(
                    f"Variable '{self.variable}' for dynamic group is of incompatible style",
                    hint="an atom-style variable",
                )

    def setup(self, sim: Simulation) -> None:
        self.renew(sim)

    def min_setup(self, sim: Simulation) -> None:
        self.renew(sim)

    def min_post_force(self, sim: Simulation) -> None:
        """A minimization keeps the members it began with (measured)."""

    def post_force(self, sim: Simulation) -> None:
        if sim.step % self.step_every == 0:
            self.renew(sim)

    def renew(self, sim: Simulation) -> None:
        """Who belongs to it now."""
        atoms = sim.atoms
        chosen = self.members(sim)
        if self.region:
            chosen = chosen & sim.regions[self.region].inside(atoms.x[: atoms.n])
        if self.variable:
            with self.reading(sim, sim.step + self.step_every):
                rows = np.flatnonzero(self.members(sim))
                wanted = np.zeros(atoms.n, bool)
                wanted[rows] = Variables(sim).per_atom(self.variable, rows) != 0.0
                chosen = chosen & wanted
        mask = atoms.mask[: atoms.n]
        mask[:] = np.where(chosen, mask | self.target, mask & ~self.target)
