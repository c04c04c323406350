"""dump ID GROUP local N FILE attributes...: a row an entry of computes and fixes with local values.

Rows end with a blank, as in LAMMPS. Source: LAMMPS manual, dump.html.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, ClassVar

import numpy as np

from pylmp.dumps.base import Dump
from pylmp.dumps.frame import WHOLE, Field, Layout
from pylmp.model.atoms import Ints
from pylmp.model.compute import current
from pylmp.model.reference import Reference, expand, length, offers, parse
from pylmp.model.registry import DUMPS
from pylmp.model.simulation import Simulation
from pylmp.text.diagnostic import ScriptError
from pylmp.text.words import Args, Word


@DUMPS.register("local", "local/gz")
class DumpLocal(Dump):
    style = "local"
    layout: ClassVar[Layout] = Layout("", " ", " \n")

    def read(self, sim: Simulation, args: Args) -> None:
        if not len(args):
            args.fail("No dump local arguments specified", args.owner, hint="index c_ID[*] or f_ID[*]")
        self.title = "ENTRIES"
        self.sources: list[Reference] = []
        self.fields = [self._field(sim, args, word) for word in expand(sim, args, args.rest(), "local")]

    def _field(self, sim: Simulation, args: Args, word: Word) -> Field:
        if word.text == "index":
            return Field("index", lambda sim, rows, known: rows + 1, WHOLE)
        found = parse(word.text)
        if found is None or found.kind == "v" or "*" in word.text:
            args.fail(f"Invalid attribute {word.text} in dump local command", word, hint="index, c_ID[N], f_ID[N]")
        self.sources.append(found)
        return Field(word.text, _local(sim, args, word, found))

    @property
    def label(self) -> str:
        return self.title

    @property
    def measures(self) -> bool:
        return bool(self.sources) or super().measures

    def rows(self, sim: Simulation, known: dict[Any, Any]) -> Ints:
        sizes = set()
        for found in self.sources:
            key = (found.kind, found.name)
            if key not in known:
                known[key] = current(sim, found.source(sim), "local")
            sizes.add(len(known[key]))
        if len(sizes) > 1:
            raise ScriptError("Dump local count is not consistent across input fields", hint="one dump for each list")
        return np.arange(sizes.pop())

    def check(self, sim: Simulation) -> None:
        if self.sort == "id":
            raise ScriptError("Dump local cannot sort by atom ID", hint="sort by the number of a column")
        if not self.sources:
            raise ScriptError("Dump local attributes contain no compute or fix", hint="c_ID[N] or f_ID[N]")
        for found in self.sources:
            source = found.source(sim)
            if source is None:
                raise ScriptError(f"Could not find dump local {found.what} ID {found.name}")
            if found.kind == "c" and not (sim.ran or sim.output.running):
                raise ScriptError(
                    f"Dump compute ID {found.name} cannot be invoked before initialization by a run", hint="run 0"
                )
            every = self.schedule.every
            if isinstance(every, int) and every % getattr(source, "compatible_every", 1):
                hint = f"dump every {source.compatible_every} steps, or a multiple"
                raise ScriptError(f"Dump local and fix {found.name} not computed at compatible times", hint=hint)

    def setting(self, sim: Simulation, args: Args, key: Word) -> bool:
        if key.text != "label":
            return False
        if not len(args):
            args.fail("Illegal dump_modify label command: missing argument(s)", key)
        self.title = args.word().text
        return True

    def format_column(self, args: Args, word: Word) -> int:
        number = args.as_integer(word)
        if not 1 <= number <= len(self.fields):
            args.fail(f"Illegal dump_modify format column number {number - 1}", word, hint=f"1 to {len(self.fields)}")
        return number - 1


def _local(sim: Simulation, args: Args, word: Word, found: Reference) -> Callable[..., Any]:
    """A local vector, or a column of a local array, of a compute or fix."""
    what, name = found.what, found.name
    source = found.source(sim)
    if source is None:
        args.fail(f"Could not find dump local {what} ID {name}", word)
    if not offers(source, "local"):
        args.fail(f"Dump local {what} {name} does not compute local info", word)
    columns = length(sim, source, "local")
    if not found.index and columns:
        args.fail(f"Dump local {what} {name} does not calculate local vector", word, hint=f"{word.text}[*]")
    if found.index and not columns:
        args.fail(f"Dump local {what} {name} does not calculate local array", word, hint=word.text.split("[")[0])
    if found.index and not 1 <= found.index[0] <= columns:
        args.fail(f"Dump local {what} {name} vector is accessed out-of-range", word, hint=f"1 to {columns}")

    def values(sim: Simulation, rows: Ints, known: dict[Any, Any]) -> Any:
        table = known[found.kind, name]
        return table if not found.index else table[:, found.index[0] - 1]

    return values
