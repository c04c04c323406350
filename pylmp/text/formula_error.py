"""What goes wrong in a formula."""

from __future__ import annotations

from typing import Self

MATH = "Invalid math function in variable formula"


class FormulaError(Exception):
    """A formula is wrong; the caller adds whose it is.

    plain   LAMMPS says so without the variable's name
    place   the innermost formula, the offset and length of what is wrong in it
    """

    def __init__(self, message: str, *, plain: bool = False, hint: str = "") -> None:
        super().__init__(message)
        self.plain = plain
        self.hint = hint
        self.place: tuple[str, int, int] | None = None

    def inside(self, formula: str, at: int, length: int) -> Self:
        """This error, at a place in a formula unless it has one already."""
        self.place = self.place or (formula, at, length)
        return self


def require(holds: bool) -> None:
    """Raise LAMMPS's sentence about a function's values unless they are right."""
    if not holds:
        raise FormulaError(MATH)
