"""Reading a log: how long the loops of its runs took, and which engine carried out the last one."""

from __future__ import annotations

import re
from dataclasses import dataclass, field

_LOOP = re.compile(r"^Loop time of (\S+) on (\d+) procs for (\d+) steps with (\d+) atoms", re.M)
_SHARE = re.compile(r"^([\d.]+)% CPU use with (\d+) MPI tasks x (\d+|no) OpenMP threads", re.M)
_SECTION = re.compile(r"^(Pair|Bond|Kspace|Neigh|Comm|Output|Modify|Other) +\|[^|\n]*\| *([\d.e+-]+) *\|", re.M)
_INSTEAD = re.compile(r"^Engine (\w+) for this run: (.+)$", re.M)


@dataclass(frozen=True)
class Loop:
    """One run. seconds: its loop. share: processor use of its threads together, 1 is one processor, None if not said.

    instead, why: the engine that stepped in for the one asked for, and its reason; None if none did. sections: seconds of each
    part of the loop, as the table below it says.
    """

    seconds: float
    steps: int
    atoms: int
    share: float | None
    instead: str | None = None
    why: str | None = None
    sections: dict[str, float] = field(default_factory=dict)


def loops(text: str) -> list[Loop]:
    """The runs of a log, in order."""
    found = list(_LOOP.finditer(text))
    result = []
    for k, match in enumerate(found):
        before = text[found[k - 1].end() if k else 0 : match.start()]
        after = text[match.end() : found[k + 1].start() if k + 1 < len(found) else len(text)]
        said, instead = _SHARE.search(after), _INSTEAD.search(before)
        share = float(said[1]) / 100.0 * int(said[2]) if said else None
        who, why = (instead[1], instead[2]) if instead else (None, None)
        sections = {name: float(seconds) for name, seconds in _SECTION.findall(after)}
        result.append(Loop(float(match[1]), int(match[3]), int(match[4]), share, who, why, sections))
    return result


def complaint(text: str) -> str:
    """What a run that failed said last: from its ERROR on, else its last lines."""
    at = text.rfind("ERROR")
    return (text[at:] if at >= 0 else text[-500:]).strip()[:1000]
