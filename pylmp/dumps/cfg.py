"""dump ID GROUP cfg N FILE mass type xs ys zs attributes...: AtomEye's extended CFG format, one frame a file.

Three lines an atom: mass, name, scaled coordinates and the rest. With xsu ysu zsu the box is drawn ten times as large, so that atoms
outside fit. Source: LAMMPS manual, dump_cfg.html.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

from pylmp.dumps.attributes import ATTRIBUTES
from pylmp.dumps.custom import DumpCustom
from pylmp.dumps.frame import Field
from pylmp.model.atoms import Ints
from pylmp.model.registry import DUMPS
from pylmp.model.simulation import Simulation
from pylmp.text.diagnostic import ScriptError
from pylmp.text.printf import Format
from pylmp.text.words import Args

_ROOM = 10.0  # how much larger the box is drawn
_STARTS = ("mass type xs ys zs", "mass type xsu ysu zsu")


@DUMPS.register("cfg", "cfg/gz")
class DumpCfg(DumpCustom):
    style = "cfg"

    def read(self, sim: Simulation, args: Args) -> None:
        words = args.words
        start = " ".join(word.text for word in words[:5])
        if start not in _STARTS:
            args.fail(
                f"Dump cfg arguments must start with '{_STARTS[0]}' or '{_STARTS[1]}'", words[0] if words else args.owner,
                hint=_STARTS[0],
            )  # fmt: skip
        self.unwrapped = start == _STARTS[1]
        super().read(sim, args)
        mass, _, *rest = self.fields
        self.fields = [replace(mass, usual=Format("%f")), ATTRIBUTES["element"], *rest]
        if self.unwrapped:
            self.fields[2:5] = [replace(field, values=_drawn(field)) for field in self.fields[2:5]]

    def check(self, sim: Simulation) -> None:
        super().check(sim)
        if not self.file.one_a_frame:
            raise ScriptError("Dump cfg requires one snapshot per file", hint="a name with *")

    def cell_formats(self) -> list[Format]:
        """Mass and name have a line each."""
        mass, *others = super().cell_formats()
        return [mass, *(Format(f"\n{form.text}") if k < 2 else form for k, form in enumerate(others))]

    def head(self, sim: Simulation, count: int) -> str:
        length, (xy, xz, yz) = sim.box.length, sim.box.tilt
        cell = ((length[0], 0.0, 0.0), (xy, length[1], 0.0), (xz, yz, length[2]))
        lines = [f"Number of particles = {count}", f"A = {_ROOM if self.unwrapped else 1.0:g} Angstrom (basic length-scale)"]
        lines += [f"H0({i + 1},{j + 1}) = {cell[i][j]:g} A" for i in range(3) for j in range(3)]
        lines += [".NO_VELOCITY.", f"entry_count = {len(self.fields) - 2}"]
        lines += [f"auxiliary[{k}] = {field.name.replace('[', '_').replace(']', '')}" for k, field in enumerate(self.fields[5:])]
        return "\n".join(lines) + "\n"


def _drawn(field: Field) -> Callable[..., Any]:
    """A scaled coordinate in the larger box."""

    def values(sim: Simulation, rows: Ints, known: dict[Any, Any]) -> Any:
        return (field.values(sim, rows, known) - 0.5) / _ROOM + 0.5

    return values
