"""The fast engine's loops: eight atoms side by side in the lanes of vectors.

Rows of atoms are taken in blocks of eight. A block's neighbors are stored slice by slice: entry k of all eight rows lies
together, shorter rows padded with a row far away from everybody (sliced ELLPACK). Every atom lists all its neighbors, so each pair is
evaluated at both ends, and a block writes nothing but the forces of its own rows: no ghosts, no order between blocks.

Indices of rows are kept multiplied by 3, ready for the flat (n, 3) arrays of positions. Where atoms are of few types, an
entry of a neighbor list holds its type too, and coefficients are chosen among those of all types, which are in registers.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from pylmp.kernels.kinds import Function
from pylmp.kernels.simd import LANES, count_up, gather, load, some, splat_whole, store
from pylmp.laws import select

FEW = 4  # types whose coefficients are chosen; of more they are gathered
SPAN = 2**29  # an entry of a neighbor list of few types: 3 x the row + (type - 1) x SPAN
FAR = 1.0e9  # where rows that fill the last block stand; those that fill neighbor lists stand opposite, far from these too


def blocks(rows: int) -> int:
    return -(-rows // LANES)


def nobody(rows: int) -> int:
    """The row that fills neighbor lists and bonds."""
    return LANES * blocks(rows)


def places(block: int) -> Any:
    """Indices of the rows of a block in a flat (n, 3) array."""
    return count_up(LANES * block, LANES) * splat_whole(3, LANES)


def weight(weights, k):  # type: ignore[no-untyped-def]
    """Weights of eight entries of a neighbor list."""
    return load(weights, k, LANES)


def no_weight(weights, k):  # type: ignore[no-untyped-def]
    return 1.0


def columns(width: int) -> Callable[[Any, Any], tuple[Any, ...]]:
    """A function that gathers width consecutive numbers of a table for each lane: a tuple of vectors."""
    if width == 0:

        def nothing(table, at):
            return ()

        return nothing
    if width == 1:

        def one(table, at):
            return (gather(table, at, 0),)

        return one
    rest, last = columns(width - 1), width - 1

    def several(table, at):
        return rest(table, at) + (gather(table, at, last),)

    return several


def recalling(memory: int) -> Function:
    """A function that loads what eight bonds remember: a tuple of vectors."""
    if memory == 0:

        def nothing(history, k, slots):
            return ()

        return nothing
    rest, last = recalling(memory - 1), memory - 1

    def several(history, k, slots):
        return rest(history, k, slots) + (load(history, last * slots + k, LANES),)

    return several


def remembering(memory: int) -> Function:
    """A function that stores the last of what eight bonds remember where it changed, then the rest; the first, r0, never changes."""
    if memory <= 1:

        def nothing(history, k, slots, remembered, active):
            return None

        return nothing
    rest, last = remembering(memory - 1), memory - 1

    def several(history, k, slots, remembered, active):
        old = load(history, last * slots + k, LANES)
        new = select(active, remembered[last], old)
        if some(new != old):
            store(history, last * slots + k, new)
        rest(history, k, slots, remembered, active)

    return several
