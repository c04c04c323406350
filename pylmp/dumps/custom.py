"""dump ID GROUP custom N FILE attributes...: a row an atom, in local order unless sorted. Source: LAMMPS manual, dump.html."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from pylmp.dumps.attributes import ATTRIBUTES, absent
from pylmp.dumps.base import Dump
from pylmp.dumps.frame import Field
from pylmp.model.atoms import Ints
from pylmp.model.compute import current
from pylmp.model.reference import Reference, expand, length, offers, parse
from pylmp.model.registry import DUMPS
from pylmp.model.simulation import Simulation
from pylmp.model.variables import Variables
from pylmp.text.diagnostic import ScriptError, Unsupported
from pylmp.text.words import Args, Word


@DUMPS.register("custom")
class DumpCustom(Dump):
    style = "custom"

    def read(self, sim: Simulation, args: Args) -> None:
        if not len(args):
            args.fail("No dump custom arguments specified", args.owner, hint="id type x y z ...")
        self.elements: list[str] = []
        self.sources: list[Reference] = []
        self.fields = [self._field(sim, args, word) for word in expand(sim, args, args.rest(), "per_atom")]

    def _field(self, sim: Simulation, args: Args, word: Word) -> Field:
        name = word.text
        if absent(sim, name):
            args.fail(
                "Dumping an atom property that isn't allocated", word, hint=f"atom_style {sim.atom_style} has none"
            )
        if name == "typelabel" and not sim.labels.of("atom"):
            args.fail("Dump custom typelabel needs a label map", word, hint="labelmap atom 1 NAME ...")
        if name in ATTRIBUTES:
            return ATTRIBUTES[name]
        found = parse(name)
        if name[:2] in ("i_", "d_"):
            args.fail(f"Could not find custom per-atom property ID: {name[2:]}", word)
        if found is None or "*" in name:
            hint = " ".join(ATTRIBUTES)
            args.fail(f"Invalid attribute {name} in dump custom command", word, hint=hint)
        self.sources.append(found)
        return Field(name, self._variable(sim, args, word, found) if found.kind == "v" else _per_atom(sim, args, word, found))

    def _variable(self, sim: Simulation, args: Args, word: Word, found: Reference) -> Callable[..., Any]:
        """An atom-style variable, evaluated for the atoms of the dump's group."""
        style = Variables(sim).style(found.name)
        if style is None:
            args.fail(f"Could not find dump custom variable name {found.name}", word)
        if style not in ("atom", "atomfile") or found.index:
            args.fail(f"Dump custom variable {found.name} is not atom-style variable", word, hint=f"variable {found.name} atom ...")

        def values(sim: Simulation, rows: Ints, known: dict[Any, Any]) -> Any:
            members = np.flatnonzero((sim.atoms.mask[: sim.atoms.n] & self.bit) != 0)
            everybody = np.zeros(sim.atoms.n)
            everybody[members] = Variables(sim).per_atom(found.name, members)
            return everybody[rows]

        return values

    @property
    def measures(self) -> bool:
        return bool(self.sources)

    def rows(self, sim: Simulation, known: dict[Any, Any]) -> Ints:
        known["elements"] = np.array(["", *(self.elements or ["C"] * sim.atom_types)], dtype=object)
        return np.flatnonzero((sim.atoms.mask[: sim.atoms.n] & self.bit) != 0)

    def check(self, sim: Simulation) -> None:
        for found in self.sources:
            if found.kind == "v":
                if Variables(sim).style(found.name) not in ("atom", "atomfile"):
                    raise ScriptError(f"Could not find dump custom variable name {found.name}")
                continue
            source = found.source(sim)
            if source is None:
                raise ScriptError(f"Could not find dump custom {found.what} ID {found.name}")
            if found.kind == "c" and not (sim.ran or sim.output.running):
                raise ScriptError(
                    f"Dump compute ID {found.name} cannot be invoked before initialization by a run", hint="run 0"
                )
            if self.every % getattr(source, "compatible_every", 1):
                raise ScriptError(f"Dump custom and fix {found.name} not computed at compatible times")

    def setting(self, sim: Simulation, args: Args, key: Word) -> bool:
        if key.text in ("thresh", "region", "refresh"):
            raise Unsupported(f"LAMMPS has dump_modify {key.text}, pylmp's native engines do not", key.span)
        if key.text != "element":
            return False
        if len(args) < sim.atom_types:
            text = "Number of dump_modify element names does not match number of atom types"
            args.fail(text, args.words[-1], hint=f"{sim.atom_types} names")
        self.elements = [args.word().text for _ in range(sim.atom_types)]
        return True


def _per_atom(sim: Simulation, args: Args, word: Word, found: Reference) -> Callable[..., Any]:
    """A per-atom vector, or a column of a per-atom array, of a compute or fix."""
    what, name = found.what, found.name
    source = found.source(sim)
    if source is None:
        args.fail(f"Could not find dump custom {what} ID: {name}", word)
    if not offers(source, "per_atom"):
        args.fail(f"Dump custom {what} {name} does not compute per-atom info", word)
    columns = length(sim, source, "per_atom")
    if not found.index and columns:
        args.fail(f"Dump custom {what} {name} does not calculate per-atom vector", word, hint=f"{word.text}[*]")
    if found.index and not columns:
        args.fail(
            f"Dump custom {what} {name} does not calculate per-atom array", word, hint=f"{word.text.split('[')[0]}"
        )
    if found.index and not 1 <= found.index[0] <= columns:
        args.fail(f"Dump custom {what} {name} vector is accessed out-of-range", word, hint=f"1 to {columns}")

    def values(sim: Simulation, rows: Ints, known: dict[Any, Any]) -> Any:
        key = (found.kind, name)
        if key not in known:
            known[key] = current(sim, found.source(sim), "per_atom")
        return known[key][rows] if not found.index else known[key][rows, found.index[0] - 1]

    return values
