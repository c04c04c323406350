"""Writes docs/numerics.md: hard cases, what was measured, and the contracts that tests/hard holds.

usage: python docs/numerics.py [laws] [cases]      both if none is named
"""

from __future__ import annotations

import sys
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).parents[1]
sys.path[0] = str(ROOT)  # not the folder docs, whose coverage.py is not the package of that name

from tests.hard import laws  # noqa: E402

PAGE = ROOT / "docs" / "numerics.md"
POINTS, AROUND = 100_000, 1000
HEAD = """# Numerics: hard cases

Written by `python docs/numerics.py`; the contracts are checked by `tests/hard` (and `tests/decks/hard`, which are bit for bit what LAMMPS does).
"""
LAWS = f"""## Laws

Force over r and energy of every law in doubles against the same source at {laws.DIGITS} digits: {POINTS:,} lengths spread evenly, and {AROUND:,} ulps to either
side of every limit, one at a time. An ulp is that of the result. A unit is what no order of operations can avoid: half an ulp of the result, plus what half
an ulp of each argument changes in it, plus half an ulp of the largest constant that the formula adds. Close to a zero of the force many ulps are few units.
Contract: never more than {laws.UNITS:g} units, and no bond is found broken or whole on the wrong side of a limit by more than one ulp of the length. LAMMPS, the
exact and the fast engine have the same bits as the law, at these limits and at r = 0, 1e-11, 1e-8, 1e-3 too.

| law | force: median ulps | 99 % | worst | at r | **units** | energy: median ulps | 99 % | worst | at r | **units** |
|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|"""


def law_rows() -> Iterator[str]:
    for case in laws.CASES:
        print(case.name, file=sys.stderr, flush=True)
        found = laws.measure(case, POINTS, AROUND)
        cells = [cell for error in (found.force, found.energy) for cell in numbers(error)]
        yield f"| {case.name} | {' | '.join(cells)} |"


def numbers(error: laws.Error | None) -> list[str]:
    if error is None:
        return ["-"] * 5
    return [f"{error.typical:.2f}", f"{error.most:.3g}", f"{error.worst:.2g}", f"{error.place:.4g}", f"**{error.units:.2f}**"]


SECTIONS = {"laws": lambda: "\n".join([LAWS, *law_rows()])}


def main(names: list[str]) -> None:
    text = PAGE.read_text() if PAGE.exists() else HEAD + "".join(f"\n<!-- {name} -->\n<!-- end -->\n" for name in SECTIONS)
    for name in names or SECTIONS:
        start, end = f"<!-- {name} -->", "<!-- end -->"
        before, _, rest = text.partition(start)
        text = f"{before}{start}\n\n{SECTIONS[name]()}\n\n{end}{rest.partition(end)[2]}"
    PAGE.write_text(text)


if __name__ == "__main__":
    main(sys.argv[1:])
