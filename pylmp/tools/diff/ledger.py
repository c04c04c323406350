"""Which bond broke at which step in each program, and how close the first one on which they disagree was to its limit."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from pylmp.tools.diff import read
from pylmp.tools.diff.instrument import COUNT, LEDGER, LENGTH, R0, STEPS

TIE = 1e-10  # closer to its limit than this, relative, rounding decides
_NEVER = 4_000_000_000_000_000_000


@dataclass(frozen=True)
class Broken:
    """One bond: the ids of its ends, its type, the step at which it was first gone."""

    ends: tuple[int, int]
    type: int
    step: int


@dataclass
class Disagreement:
    """The first bond that broke in one program and not at the same step in the other. step: where the first of them lost it.

    margin: how far the other program's bond then was from its limit, relative to the limit; None where the limit is not known.
    """

    ends: tuple[int, int]
    type: int
    step: int
    mine: int | None
    theirs: int | None
    margin: float | None

    @property
    def tie(self) -> bool:
        return self.margin is not None and self.margin < TIE


@dataclass
class Ledger:
    """counts: bonds that broke in each program. first_count: the first step with another number of bonds.

    bonds: each bond that broke, in each program; None unless they were listed in a second pass.
    """

    counts: tuple[int, int]
    first_count: int | None
    bonds: tuple[list[Broken], list[Broken]] | None = None
    first: Disagreement | None = None
    same: int = 0  # bonds that broke at the same step in both


@dataclass
class _Frames:
    steps: list[int] = field(default_factory=list)
    frames: list[read.Numbers] = field(default_factory=list)


def counted(folder: Path, k: int) -> dict[int, float]:
    """Bonds at each step of run command k; empty if none can break."""
    path = folder / f"{COUNT}{k}"
    if not path.is_file():
        return {}
    rows = (line.split() for line in path.read_text().splitlines() if line and line[0] != "#")
    return {int(row[0]): float(row[1]) for row in rows if len(row) == 2}


def summary(mine: Path, theirs: Path, k: int) -> Ledger | None:
    """From the counts alone."""
    both = [counted(folder, k) for folder in (mine, theirs)]
    if not all(both):
        return None
    first = next((step for step, n in both[0].items() if step in both[1] and both[1][step] != n), None)
    lost = [int(counts[min(counts)] - counts[max(counts)]) for counts in both]
    return Ledger((lost[0], lost[1]), first)


def changes(folders: Iterable[Path], k: int) -> list[int]:
    """Steps at which a bond was lost in one of the folders, and the steps before them; without the first, which is listed anyway."""
    steps, first = set(), set()
    for folder in folders:
        counts = counted(folder, k)
        last = None
        for step, n in counts.items():
            if last is not None and n != last:
                steps |= {step - 1, step}
            last = n
        first |= {min(counts, default=0)}
    return sorted(steps - first)


def ask(folder: Path, k: int, steps: list[int]) -> None:
    """Leave the file from which the copy takes the steps at which it lists the bonds of run command k."""
    (folder / f"{STEPS}{k}").write_text("".join(f"{step}\n" for step in [*steps, *range(_NEVER, _NEVER + 4)]))


def settle(ledger: Ledger, mine: Path, theirs: Path, k: int) -> None:
    """Fill in bonds and the first disagreement from the lists of a second pass."""
    lists = [read.numbers(folder / f"{LEDGER}{k}") for folder in (mine, theirs)]
    broken = [_broken(frames) for frames in lists]
    ledger.bonds = broken[0], broken[1]
    a, b = ({bond.ends: bond for bond in bonds} for bonds in broken)
    ledger.same = sum(1 for ends, bond in a.items() if ends in b and b[ends].step == bond.step)
    apart = [ends for ends in {**a, **b} if ends not in a or ends not in b or a[ends].step != b[ends].step]
    if not apart:
        return
    ends = min(apart, key=lambda e: (min(_step(a, e), _step(b, e)), e))
    step = min(_step(a, ends), _step(b, ends))
    bond = a.get(ends) or b[ends]
    other, folder = (lists[1], theirs) if _step(a, ends) == step else (lists[0], mine)
    frame = next((f for f in other if f.step == step), None)
    margin = _margin(frame, ends, bond.type, folder) if frame is not None else None
    ledger.first = Disagreement(ends, bond.type, step, _or_none(a, ends), _or_none(b, ends), margin)


def _step(bonds: dict[tuple[int, int], Broken], ends: tuple[int, int]) -> int:
    return bonds[ends].step if ends in bonds else _NEVER


def _or_none(bonds: dict[tuple[int, int], Broken], ends: tuple[int, int]) -> int | None:
    return bonds[ends].step if ends in bonds else None


def _broken(frames: list[read.Numbers]) -> list[Broken]:
    result = []
    before: dict[tuple[int, int], int] = {}
    for frame in frames:
        now = {_ends(row): int(row[2]) for row in frame["c_pylmp_ends[1] c_pylmp_ends[2] c_pylmp_ends[3]"]}
        result += [Broken(ends, kind, frame.step) for ends, kind in sorted(before.items()) if ends not in now]
        before = now
    return result


def _ends(row: np.ndarray) -> tuple[int, int]:
    return int(min(row[0], row[1])), int(max(row[0], row[1]))


def _margin(frame: read.Numbers, ends: tuple[int, int], kind: int, folder: Path) -> float | None:
    limit = _limit((folder / "log.lammps").read_text(), kind)
    row = next((row for row in frame.values if _ends(row) == ends), None)
    if limit is None or row is None:
        return None
    style, value = limit
    at = dict(zip(frame.columns, row, strict=True))
    length = at[LENGTH]
    if style.startswith("quartic"):
        return float(abs(length - value) / value)
    if not style.startswith("bpm/") or R0 not in at:
        return None
    r0 = at[R0]
    return float(abs(abs(length - r0) / r0 - value) / value)


def _limit(log: str, kind: int) -> tuple[str, float] | None:
    """(style, Rc or eps_c) that the script's last bond_coeff gave this type; None where it said it in another way."""
    style, value = "", None
    for line in log.splitlines():
        words = line.split("#")[0].split()
        if words[:1] == ["bond_style"] and len(words) > 1:
            style, value = words[1], None
        elif words[:1] == ["bond_coeff"] and len(words) > 3 and "$" not in line:
            if _holds(words[1], kind):
                named = words[2] if not re.match(r"[-+.\d]", words[2]) else ""
                at = 2 + bool(named) + (3 if (named or style).startswith("quartic") else 1)
                try:
                    value = (named or style, float(words[at]))
                except (ValueError, IndexError):
                    value = None
    return value


def _holds(types: str, kind: int) -> bool:
    """A bond type or a range of them as commands name them."""
    low, star, high = types.partition("*")
    if not star:
        return types == str(kind)
    return (int(low) if low.isdigit() else 1) <= kind <= (int(high) if high.isdigit() else kind)
