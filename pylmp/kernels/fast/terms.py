"""What a force loop of the fast engine is made of: the laws of pairs and of bonds."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from pylmp.kernels.kinds import Function
from pylmp.kernels.simd import some


@dataclass(frozen=True)
class PairTerm:
    """law(r2, dot, factor, c) -> (force over r, energy), c of width numbers. types: of atoms, if few; 0: many. packed: entries of the neighbor list hold them."""

    law: Function
    width: int
    velocity: bool
    types: int
    packed: bool = False


@dataclass(frozen=True)
class BondTerm:
    """law(r2, dot, history, c) -> (force over r, energy, history, alive).

    types       of bonds, if few; 0: many
    memory      numbers a bond remembers; reference: the first is the length at the first evaluation
    can_break   the law may say that a bond is not alive
    instead     a broken bond's atoms interact as a pair from the next step on
    alone       the pair law that acts no longer between bonded atoms, or None: it is taken out again
    watch       None, or watch(r2, c) -> this bond must be reported
    """

    law: Function
    width: int
    memory: int
    velocity: bool
    types: int
    reference: bool
    can_break: bool
    instead: bool
    alone: Function
    watch: Function


def idle(r2: Any, dot: Any, history: Any, c: Any) -> Any:
    """The law of a bond that does nothing."""
    return r2 * 0.0, r2 * 0.0, (), r2 == r2


def joined(laws: list[Function], widths: list[int]) -> Function:
    """One law for several that act side by side: c holds what each receives, one behind the other.

    What a pair law receives ends with the square of its reach: one that reaches less far is left out where nobody is so near.
    """
    if len(laws) == 1:
        return laws[0]
    return _beside(laws, widths)


def _beside(laws: list[Function], widths: list[int]) -> Function:
    if not laws:
        return _none
    rest, last, at, end = _beside(laws[:-1], widths[:-1]), laws[-1], sum(widths[:-1]), sum(widths)

    def law(r2: Any, dot: Any, factor: Any, c: Any) -> Any:
        force, energy = rest(r2, dot, factor, c[:at])
        if some(r2 < c[end - 1]):
            more_force, more_energy = last(r2, dot, factor, c[at:])
            force = force + more_force
            energy = energy + more_energy
        return force, energy

    return law


def _none(r2: Any, dot: Any, factor: Any, c: Any) -> Any:
    return r2 * 0.0, r2 * 0.0
