"""What the LAMMPS release writes differently from its manual: the same script, said so that the release runs it.

Works on the text of a script, line by line, and says what it changed; nothing but the named departures is touched.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass, field

_BPM_KEYWORDS = ("store/local", "overlay/pair", "smooth", "normalize", "break")
_LJ_REACH = "2^(1/6)"


@dataclass
class Dialect:
    """rewritten: the script for the release. notes: what was changed, one sentence a line.

    exact: False when a rewrite computes the same physics with another order of operations (then bits may differ).
    """

    rewritten: list[str] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)
    exact: bool = True


def translate(lines: list[str]) -> Dialect:
    """Rewrite the physical lines of a script. One line in, one line out."""
    result = Dialect()
    unbreakable = False
    for number, line in enumerate(lines, 1):
        new = line
        for rewrite in (_breakable, _store_local, _write_header, _bond_zero, _bond_history):
            new = rewrite(new)
        words = new.split()
        if words[:1] == ["bond_style"]:
            unbreakable = len(words) > 1 and words[1].removesuffix("/omp") == "quartic/unbreakable"
            if unbreakable:
                new = "bond_style lepton no_offset"
        elif unbreakable and words[:1] == ["bond_coeff"] and len(words) >= 7:
            new = f'bond_coeff {words[1]} 0.0 "{_lepton(*words[2:7])}"'
            result.exact = False
        if new != line:
            result.notes.append(f"line {number}: {line.strip()}  ->  {new.strip()}")
        result.rewritten.append(new)
    return result


def _on(command: str, line: str, change: Callable[[str], str]) -> str:
    return change(line) if line.split()[:1] == [command] else line


def _breakable(line: str) -> str:
    """quartic/breakable is the release's quartic."""
    return (
        _on("bond_style", line, lambda s: re.sub(r"\bquartic/breakable\b(/omp)?", "quartic", s))
        if ("quartic/breakable" in line)
        else _on("bond_coeff", line, lambda s: re.sub(r"\bquartic/breakable\b(/omp)?", "quartic", s))
    )


def _store_local(line: str) -> str:
    """The manual's example leaves the keyword store/local out."""
    words = line.split()
    if words[:2] == ["bond_style", "bpm/spring/plastic"] and len(words) > 3 and words[2] not in _BPM_KEYWORDS:
        return line.replace("bpm/spring/plastic", "bpm/spring/plastic store/local", 1)
    return line


def _write_header(line: str) -> str:
    return _on("dump_modify", line, lambda s: re.sub(r"\bwrite_header\b", "header", s))


def _bond_zero(line: str) -> str:
    """The release refuses bond type 0; stats selects nothing, and remove removes what is off or broken."""
    return _on("delete_bonds", line, lambda s: re.sub(r"\bbond\s+0\b", "stats", s))


def _lepton(k: str, b1: str, b2: str, rc: str, u0: str) -> str:
    """quartic/unbreakable as a formula: past Rc the energy is U0; the LJ term ends at 2^(1/6)."""
    quartic = f"({k})*(r-({rc}))^2*(r-({rc})-({b1}))*(r-({rc})-({b2}))*step(({rc})-r)"
    return f"{quartic}+({u0})+(4*(1/r^12-1/r^6)+1)*step({_LJ_REACH}-r)"


def _bond_history(line: str) -> str:
    """The release writes data files without the lines that continue a run exactly."""
    return _on("write_data", line, lambda s: re.sub(r"\s+bond/history\b", "", s))
