"""The rows of one frame: columns of numbers or names, sorted and formatted."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import chain
from typing import TYPE_CHECKING, Any

import numpy as np

from pylmp.model.atoms import Ints
from pylmp.text.printf import Format

if TYPE_CHECKING:
    from pylmp.dumps.base import Dump
    from pylmp.model.simulation import Simulation

_BLOCK = 64
WHOLE, REAL, NAME = Format("%d"), Format("%g"), Format("%s")


@dataclass(frozen=True)
class Field:
    """One column. values(simulation, rows, known) -> (rows,) array; known holds what was computed for this frame already.

    name: above the column, unless dump_modify colname says otherwise. usual: its format by default.
    """

    name: str
    values: Callable[[Simulation, Ints, dict[Any, Any]], Any]
    usual: Format = REAL


def order(keys: Any, descending: bool) -> Ints:
    """Rows sorted by keys. Equal keys as LAMMPS's merge sort leaves them: blocks of 64 rows from last to first, each in order."""
    rows = np.arange(len(keys))
    start = np.lexsort((rows % _BLOCK, -(rows // _BLOCK)))
    keys = keys[start]
    return np.asarray(start[np.argsort(-keys if descending else keys, kind="stable")])


@dataclass(frozen=True)
class Layout:
    """What stands before, between and behind the cells of a row."""

    begin: str
    between: str
    end: str


def text(columns: Sequence[Any], formats: Sequence[Format], layout: Layout) -> str:
    """The rows. columns: arrays of one length."""
    if not columns or len(columns[0]) == 0:
        return ""
    if any(c.dtype.kind == "f" and np.isnan(c).any() for c in columns):
        cells = zip(*([f(v) for v in c.tolist()] for c, f in zip(columns, formats, strict=True)), strict=True)
        return "".join(layout.begin + layout.between.join(row) + layout.end for row in cells)
    whole = [c.astype(np.int64) if f.whole else c for c, f in zip(columns, formats, strict=True)]
    row = layout.begin + layout.between.join(f.python for f in formats) + layout.end
    values = chain.from_iterable(zip(*(c.tolist() for c in whole), strict=True))
    return (row * len(columns[0])) % tuple(values)


def user_formats(dump: Dump) -> list[Format]:
    """Per column: the user's for it, for its kind, for the whole line, else the usual one."""
    if dump.verbatim and dump.for_line:
        return dump.for_line[: len(dump.fields)]
    result = []
    for k, field in enumerate(dump.fields):
        kind = {"d": dump.for_whole, "g": dump.for_real}.get(field.usual.text[-1])
        own = dump.formats.get(k) or kind
        if own is None and dump.for_line:
            own = dump.for_line[k]
        result.append(own or field.usual)
    return result
