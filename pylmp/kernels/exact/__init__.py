"""The exact engine's loops: one rank of LAMMPS in its own order of operations.

Plain Python over flat arrays (row k of an (n, 3) array starts at 3*k), composed by closures; compiled by
``pylmp.kernels.store``. What a scene does not need is a captured False and absent from the machine code.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

SPECIAL_SHIFT = 30  # a neighbor entry carries its special kind (0 none, 1..3: 1-2, 1-3, 1-4) above the index
INDEX_MASK = (1 << SPECIAL_SHIFT) - 1


SHARES = 7  # numbers that an atom's share of a tally has: energy, virial xx yy zz xy xz yz


def give_share(shares: "f8*", i: int, e: float, force: float, dx: float, dy: float, dz: float) -> None:
    """Half an interaction's energy and virial to the atom of row i."""
    at = SHARES * i
    shares[at] += 0.5 * e
    shares[at + 1] += 0.5 * (dx * dx * force)
    shares[at + 2] += 0.5 * (dy * dy * force)
    shares[at + 3] += 0.5 * (dz * dz * force)
    shares[at + 4] += 0.5 * (dx * dy * force)
    shares[at + 5] += 0.5 * (dx * dz * force)
    shares[at + 6] += 0.5 * (dy * dz * force)


def row(count: int) -> Callable[[Any, int], tuple[float, ...]]:
    """A function that reads count consecutive numbers of an array as a tuple."""
    if count == 0:

        def nothing(table, at):  # type: ignore[no-untyped-def]
            return ()

        return nothing
    if count == 1:

        def one(table, at):  # type: ignore[no-untyped-def]
            return (table[at],)

        return one
    rest, last = row(count - 1), count - 1

    def several(table, at):  # type: ignore[no-untyped-def]
        return rest(table, at) + (table[at + last],)

    return several


def coefficients(width: int, tabled: bool = False, individual: bool = False) -> Callable[..., tuple[Any, ...]]:
    """A function of (table, at, data, own, k) that reads what a law receives: width numbers of table from at on; behind them
    data, where the law looks things up in a table; behind these own[k], where each interaction has a number of its own.
    """
    load = row(width)

    def plain(table, at, data, own, k):  # type: ignore[no-untyped-def]
        return load(table, at)

    def with_data(table, at, data, own, k):  # type: ignore[no-untyped-def]
        return load(table, at) + (data,)

    def with_own(table, at, data, own, k):  # type: ignore[no-untyped-def]
        return load(table, at) + (own[k],)

    if tabled and individual:
        raise ValueError("a law has a table or a number for each bond, not both")
    return with_data if tabled else with_own if individual else plain
