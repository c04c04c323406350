"""What read_restart found for fixes that are not there yet. Each takes its own when it is defined; the first set-up drops the rest."""

from __future__ import annotations

import struct
from dataclasses import dataclass
from typing import TYPE_CHECKING

from pylmp.text.diagnostic import ScriptError

if TYPE_CHECKING:
    from pylmp.model.atoms import Floats
    from pylmp.model.compute import Compute
    from pylmp.model.fix import Fix
    from pylmp.model.simulation import Simulation
    from pylmp.text.words import Args


@dataclass
class _Entry:
    """state: bytes of a global state, or the name under which the atoms carry theirs."""

    identity: str
    style: str
    state: bytes | str
    taken: bool = False


class Waiting:
    """globals, per_atom: entries in the order of the file. source: what the log calls it."""

    def __init__(self, source: str = "restart file") -> None:
        self.source = source
        self.globals: list[_Entry] = []
        self.per_atom: list[_Entry] = []

    def add(self, identity: str, style: str, state: bytes) -> None:
        self.globals.append(_Entry(identity, style, state))

    def add_atoms(self, sim: Simulation, identity: str, style: str, values: Floats) -> None:
        """values (capacity, k): they ride along with the atoms until somebody takes them."""
        name = f"restart {identity} {style}"
        sim.atoms.extra[name] = values
        self.per_atom.append(_Entry(identity, style, name))

    def take(self, sim: Simulation, identity: str, style: str) -> bytes | None:
        """The global state kept for this ID and style."""
        entry = _find(self.globals, identity, style)
        if entry is None:
            return None
        self._announce(sim, "global", entry)
        assert isinstance(entry.state, bytes)
        return entry.state

    def take_atoms(self, sim: Simulation, identity: str, style: str, width: int) -> Floats | None:
        """(n, width) what is kept per atom for this ID and style."""
        entry = _find(self.per_atom, identity, style)
        if entry is None:
            return None
        self._announce(sim, "peratom", entry)
        assert isinstance(entry.state, str)
        values: Floats = sim.atoms.extra[entry.state][: sim.atoms.n]  # type: ignore[assignment]
        if values.shape[1] != width:
            raise ScriptError(
                f"Fix {identity} settings not consistent with restart", manual="read_restart.html",
                hint=f"the restart file holds {values.shape[1]} numbers an atom for it, not {width}",
            )  # fmt: skip
        return values

    def offer(self, sim: Simulation, owner: Fix | Compute, identity: str, style: str, per_atom: str) -> None:
        """Something was defined: give it what is its own. identity, style, per_atom: how LAMMPS calls what keeps it, globally and
        with the atoms. Raises ScriptError if that was kept by another kind of fix."""
        if (state := self.take(sim, identity, style)) is not None:
            try:
                owner.restore(sim, state)
            except (struct.error, ValueError, OverflowError):
                says, hint = f"Fix {identity} settings not consistent with restart", "the settings of the run that wrote the file"
                raise ScriptError(says, hint=hint, manual="read_restart.html") from None
        own = owner.atom_state(sim)
        if own is not None and (values := self.take_atoms(sim, identity, per_atom, own.shape[1])) is not None:
            owner.restore_atoms(sim, values)

    def _announce(self, sim: Simulation, what: str, entry: _Entry) -> None:
        entry.taken = True
        sim.console.both(
            f"Resetting {what} fix info from {self.source}:\n  fix style: {entry.style}, fix ID: {entry.identity}\n"
        )

    def drop(self, sim: Simulation) -> None:
        """The first set-up: say what nobody took."""
        for what, entries in (("global", self.globals), ("peratom", self.per_atom)):
            left = [entry for entry in entries if not entry.taken]
            if left:
                lines = "".join(f"  fix style: {entry.style}, fix ID: {entry.identity}\n" for entry in left)
                sim.console.both(f"Unused {self.source} {what} fix info:\n{lines}")
            elif entries:
                sim.console.both(f"All {self.source} {what} fix info was re-assigned\n")
        for entry in self.per_atom:
            sim.atoms.extra.pop(str(entry.state), None)
        sim.waiting = None


def refuse_atoms(sim: Simulation, args: Args, says: str) -> None:
    """Fail if the atoms carry what a fix is to take over: a command that changes atoms would spoil it."""
    if sim.waiting is not None and sim.waiting.per_atom:
        args.fail(
            f"{says} after reading restart file with per-atom info", args.owner,
            hint="the fixes that keep something per atom, then run 0, come before it",
        )  # fmt: skip


def _find(entries: list[_Entry], identity: str, style: str) -> _Entry | None:
    return next((e for e in entries if (e.identity, e.style) == (identity, style)), None)


