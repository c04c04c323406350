"""dump ID GROUP yaml N FILE attributes...: dump custom as YAML, a document a frame. dump_modify thermo yes adds the thermo values.

Source: LAMMPS manual, dump.html.
"""

from __future__ import annotations

import numpy as np

from pylmp.dumps.custom import DumpCustom
from pylmp.dumps.frame import Layout
from pylmp.model.registry import DUMPS
from pylmp.model.simulation import Simulation
from pylmp.text.number import shortest
from pylmp.text.words import Args, Word


@DUMPS.register("yaml")
class DumpYaml(DumpCustom):
    style = "yaml"
    layout = Layout("  - [ ", " , ", ", ]\n")

    def read(self, sim: Simulation, args: Args) -> None:
        super().read(sim, args)
        self.thermo = False

    def head(self, sim: Simulation, count: int) -> str:
        box = sim.box
        lines = ["---", "creator: LAMMPS", f"timestep: {sim.step}"]
        if self.units:
            lines.append(f"units: {sim.units.name}")
        if self.time:
            lines.append(f"time: {sim.output.time():.16g}")
        faces = ", ".join(face for faces in box.boundary for face in faces)
        lines += [f"natoms: {count}", f"boundary: [ {faces}, ]"]
        if self.thermo:
            lines += self._thermo(sim)
        lines.append("box:")
        lines += [
            f"  - [ {shortest(low)}, {shortest(high)} ]" for low, high in np.stack(box.bounds, axis=1).tolist()
        ]
        if box.triclinic:
            lines.append(f"  - [ {', '.join(shortest(tilt) for tilt in box.tilt.tolist())} ]")
        names = " ".join(self.headers.get(k, field.name) for k, field in enumerate(self.fields)).split()
        return "\n".join([*lines, f"keywords: [ {', '.join(map(_quoted, names))},  ]", "data:"]) + "\n"

    def _thermo(self, sim: Simulation) -> list[str]:
        """Names and values of the thermo line of this step, if there is one."""
        table = sim.output.thermo
        step, values = table.written
        if step != sim.step:
            return []
        names = [_quoted(entry.header) for entry in table.columns]
        values = [str(value) if isinstance(value, int) else shortest(value) for value in values]
        return ["thermo:", f"  - keywords: [ {', '.join(names)}, ]", f"  - data: [ {', '.join(values)}, ]"]

    @property
    def footer(self) -> str:
        return "...\n"

    def setting(self, sim: Simulation, args: Args, key: Word) -> bool:
        if key.text != "thermo":
            return super().setting(sim, args, key)
        if not len(args):
            args.fail("expected 'yes' or 'no' after 'thermo' keyword.", key)
        self.thermo = args.yes()
        return True


def _quoted(name: str) -> str:
    """A name that YAML would take for something else."""
    return f"'{name}'" if "[" in name else name
