"""dump ID GROUP custom N FILE attributes...: a row an atom, in local order unless sorted. Source: LAMMPS manual, dump.html."""

from __future__ import annotations

from typing import Any

import numpy as np

from pylmp.dumps.attributes import ATTRIBUTES, absent
from pylmp.dumps.base import Dump
from pylmp.dumps.frame import Field
from pylmp.dumps.sources import ATTRIBUTE, per_atom
from pylmp.dumps.threshold import Threshold, read_threshold
from pylmp.model.atoms import Ints
from pylmp.model.reference import Reference, expand, parse
from pylmp.model.registry import DUMPS
from pylmp.model.simulation import Simulation
from pylmp.model.variables import Variables
from pylmp.text.diagnostic import ScriptError
from pylmp.text.words import Args, Word


@DUMPS.register("custom", "custom/gz")
class DumpCustom(Dump):
    """elements: names of types. region: only atoms inside, "" for all. thresholds: only atoms that pass all. refreshed: a compute
    that starts anew after each frame."""

    style = "custom"

    def read(self, sim: Simulation, args: Args) -> None:
        if not len(args):
            args.fail(f"No dump {self.style} arguments specified", args.owner, hint="id type x y z ...")
        self.elements: list[str] = []
        self.region = self.refreshed = ""
        self.thresholds: list[Threshold] = []
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
        if name[:2] in ("i_", "d_") or name[:3] in ("i2_", "d2_"):
            args.fail(f"Could not find custom per-atom property ID: {name.split('_', 1)[1].split('[')[0]}", word)
        if found is None or "*" in name:
            hint = " ".join(ATTRIBUTES)
            args.fail(f"Invalid attribute {name} in dump {self.style} command", word, hint=hint)
        self.sources.append(found)
        return Field(name, per_atom(sim, args, word, found, ATTRIBUTE, self.bit, self.style))

    # ---- frames -----------------------------------------------------------------------------------------------

    @property
    def measures(self) -> bool:
        return bool(self.sources) or any(threshold.source for threshold in self.thresholds) or super().measures

    def rows(self, sim: Simulation, known: dict[Any, Any]) -> Ints:
        known["elements"] = np.array(["", *(self.elements or ["C"] * sim.atom_types)], dtype=object)
        chosen = (sim.atoms.mask[: sim.atoms.n] & self.bit) != 0
        if self.region:
            chosen &= sim.regions[self.region].inside(sim.atoms.x[: sim.atoms.n])
        for threshold in self.thresholds:
            chosen = threshold.keep(sim, chosen, known)
        return np.flatnonzero(chosen)

    def written(self, sim: Simulation) -> None:
        if self.refreshed and hasattr(sim.computes[self.refreshed], "refresh"):
            sim.computes[self.refreshed].refresh(sim)  # type: ignore[attr-defined]

    def init(self, sim: Simulation) -> None:
        if self.sort != "id" and all(field.name != "id" for field in self.fields):
            sim.console.warning(
                f"Dump {self.id} includes no atom IDs and is not sorted by ID. "
                "This may complicate post-processing tasks or visualization"
            )
        super().init(sim)

    def check(self, sim: Simulation) -> None:
        if self.region and self.region not in sim.regions:
            raise ScriptError(f"Region {self.region} for dump {self.style} does not exist", hint="it was deleted")
        for found in (*self.sources, *(t.source for t in self.thresholds if t.source)):
            self._check_source(sim, found)
        if self.refreshed and self.refreshed not in sim.computes:
            raise ScriptError(f"Dump could not find refresh compute ID {self.refreshed}", hint="it was deleted")

    def _check_source(self, sim: Simulation, found: Reference) -> None:
        if found.kind == "v":
            if Variables(sim).style(found.name) is None:
                raise ScriptError(f"Could not find dump {self.style} variable name {found.name}", hint="it was deleted")
            return
        source = found.source(sim)
        if source is None:
            raise ScriptError(f"Could not find dump {self.style} {found.what} ID {found.name}")
        if found.kind == "c" and not (sim.ran or sim.output.running):
            raise ScriptError(
                f"Dump compute ID {found.name} cannot be invoked before initialization by a run", hint="run 0"
            )
        every = self.schedule.every
        if not isinstance(every, int) or every % getattr(source, "compatible_every", 1):
            if getattr(source, "compatible_every", 1) > 1:
                raise ScriptError(f"Dump {self.style} and fix {found.name} not computed at compatible times")

    # ---- dump_modify ------------------------------------------------------------------------------------------

    def setting(self, sim: Simulation, args: Args, key: Word) -> bool:
        read = {"thresh": self._thresh, "region": self._region, "refresh": self._refresh, "element": self._element}.get(key.text)
        if read is None:
            return False
        read(sim, args, key)
        return True

    def _thresh(self, sim: Simulation, args: Args, key: Word) -> None:
        if not len(args):
            args.fail("Illegal dump_modify thresh command: missing argument(s)", key)
        found = read_threshold(sim, args, f"dump {self.id} thresh {len(self.thresholds)}", self.bit)
        self.thresholds = [*self.thresholds, found] if found else []

    def _region(self, sim: Simulation, args: Args, key: Word) -> None:
        if not len(args):
            args.fail("Illegal dump_modify command: missing argument(s)", key)
        word = args.word()
        if word.text != "none" and word.text not in sim.regions:
            args.fail(f"Dump_modify region {word.text} does not exist", word, hint="region comes first")
        self.region = "" if word.text == "none" else word.text

    def _refresh(self, sim: Simulation, args: Args, key: Word) -> None:
        if not len(args):
            args.fail("Illegal dump_modify refresh command: missing argument(s)", key)
        word = args.word()
        found = parse(word.text)
        if found is None or found.kind != "c" or found.index:
            args.fail("Illegal dump_modify command", word, hint="c_ID of a compute")
        self.refreshed = found.name

    def _element(self, sim: Simulation, args: Args, key: Word) -> None:
        if len(args) < sim.atom_types:
            text = "Number of dump_modify element names does not match number of atom types"
            args.fail(text, args.words[-1], hint=f"{sim.atom_types} names")
        self.elements = [args.word().text for _ in range(sim.atom_types)]
