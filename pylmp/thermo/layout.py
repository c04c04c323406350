"""How a thermo table is laid out: one line a step, a block a step, or YAML.

Layouts as LAMMPS 22 Jul 2025 prints them, blank by blank; a cell's format is the user's or the layout's.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass


@dataclass(frozen=True)
class Layout:
    """whole, real: default formats of integers and of other numbers. ahead: room in front of every cell for the name."""

    name: str
    whole: str
    real: str

    def header(self, names: Sequence[str], whole: Sequence[bool]) -> str:
        """Printed once, when a run begins."""
        if self.name == "one":
            return (
                " ".join(f"{name:^{11 if is_whole else 14}}" for name, is_whole in zip(names, whole, strict=True))
                + "\n"
            )
        if self.name == "yaml":
            return "---\nkeywords: [" + "".join(f"'{name}', " for name in names) + "]\ndata:\n"
        return ""

    def row(self, names: Sequence[str], cells: Sequence[str], step: int, cpu: float) -> str:
        """The text of one step; cells are formatted already."""
        if self.name == "one":
            return " ".join(cells) + "\n"
        if self.name == "yaml":
            return "  - [" + "".join(f"{cell}, " for cell in cells) + "]\n"
        text = f"------------ Step {step:14d} ----- CPU = {cpu:12.7g} (sec) -------------"
        for k, (name, cell) in enumerate(zip(names, cells, strict=True)):
            text += ("\n" if k % 3 == 0 else "") + f"{name:<8} = {cell}" + (" " if k + 1 < len(cells) else "")
        return text + "\n"

    @property
    def footer(self) -> str:
        """Printed once, when a run is over."""
        return "...\n" if self.name == "yaml" else ""


LAYOUTS = {
    "one": Layout("one", "%10d ", "% -14.8g"),
    "multi": Layout("multi", "%14d", "%14.4f"),
    "yaml": Layout("yaml", "%d", "%.15g"),
}
