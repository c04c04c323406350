"""Coefficients of few types are chosen, lane by lane, among those of all: nothing is gathered.

Those of a block's own atoms are chosen once, and for each neighbor one of as many rows as there are types is left to take.
"""

from __future__ import annotations

from pylmp.kernels.exact import row
from pylmp.kernels.fast import FEW, SPAN
from pylmp.kernels.kinds import Function
from pylmp.kernels.simd import LANES, gather, splat_whole
from pylmp.laws import select


def few_types(types: int) -> int:
    """As terms of a loop hold them: 0 for many."""
    return types if types <= FEW else 0


def either(width: int) -> Function:
    """A function that takes, lane by lane, from one of two tuples of width vectors or numbers."""
    if width == 0:

        def neither(mask, a, b):
            return ()

        return neither
    rest, last = either(width - 1), width - 1

    def several(mask, a, b):
        return rest(mask, a, b) + (select(mask, a[last], b[last]),)

    return several


def choice(types: int, width: int) -> Function:
    """A function that takes of a tuple of rows the one of each lane's type, counted from 1; below 1 counts as 1."""
    if types <= 1:

        def first(rows, t):
            return rows[0]

        return first
    rest, take, less = choice(types - 1, width), either(width), types - 1

    def several(rows, t):
        return take(t > less, rows[less], rest(rows, t))

    return several


def rows_of(types: int, width: int) -> Function:
    """A function that reads a tuple of rows of a table: at + step, at + 2 step, ..."""
    one = row(width)
    if types <= 1:

        def first(table, at, step):
            return (one(table, at + step),)

        return first
    rest = rows_of(types - 1, width)

    def several(table, at, step):
        return rest(table, at, step) + (one(table, at + types * step),)

    return several


def rows_of_pairs(second: int, types: int, width: int) -> Function:
    """A function that reads, for types 1 to second of the other atom, the rows of all types of the one: a tuple of tuples of rows."""
    one = rows_of(types, width)
    if second <= 1:

        def first(table, stride):
            return (one(table, width, stride * width),)

        return first
    rest = rows_of_pairs(second - 1, types, width)

    def several(table, stride):
        return rest(table, stride) + (one(table, second * width, stride * width),)

    return several


def by_other(second: int, types: int, width: int) -> Function:
    """A function that chooses of these by the type of the one: for types 1 to second of the other a row."""
    take, last = choice(types, width), second - 1
    if second <= 1:

        def first(rows, t):
            return (take(rows[0], t),)

        return first
    rest = by_other(last, types, width)

    def several(rows, t):
        return rest(rows, t) + (take(rows[last], t),)

    return several


def unpacking(types: int, packed: bool) -> Function:
    """A function that takes an entry of a neighbor list apart: 3 x the row, and the type."""
    if types == 1:

        def alike(entry, kinds):
            return entry, splat_whole(1, LANES)

        return alike
    if not packed:

        def looked_up(entry, kinds):
            return entry, gather(kinds, entry, 0)

        return looked_up
    if types == 2:

        def either_of_two(entry, kinds):
            more = entry >= SPAN
            return select(more, entry - SPAN, entry), select(more, splat_whole(2, LANES), splat_whole(1, LANES))

        return either_of_two
    rest, less = unpacking(types - 1, True), (types - 1) * SPAN

    def several(entry, kinds):
        j, t = rest(entry, kinds)
        more = entry >= less
        return select(more, entry - less, j), select(more, splat_whole(types, LANES), t)

    return several
