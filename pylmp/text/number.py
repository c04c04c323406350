"""Numbers as LAMMPS prints them."""

from __future__ import annotations


def shortest(value: float) -> str:
    """The fewest digits that read back as the same double, without a trailing ``.0``."""
    text = repr(float(value))
    return text.removesuffix(".0")


def eight(value: float) -> str:
    """Eight significant digits, C's ``%.8g``."""
    return f"{value:.8g}"
