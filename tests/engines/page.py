"""Writes docs/engines.md: which decks the fast engine runs, and what the exact one is asked for in the others.

usage: python -m tests.engines.page
"""

from __future__ import annotations

import tempfile
from pathlib import Path

from tests.engines.decks import DECKS, ROOT, lacking, name, three

PAGE = ROOT / "docs" / "engines.md"
HEAD = """# What the fast engine runs

`pylmp --engine auto` (the default) and `--engine fast` take the fast engine for every run it can carry out, and the exact one for the others;
the log says which and why. Both give the same physics: forces to 1e-12, the same rebuild steps, random numbers and broken bonds. The bits of
LAMMPS are those of `--engine exact`.

The fast engine lacks, and so the exact one carries out:

- `minimize`: where it stops hangs on the last bits of energies;
- `rerun`: nothing to gain;
- pair_style table and bond_style table: laws that look things up;
- bond_style bpm/spring with volume/factor yes: a law with a number of its own for each bond;
- pair_modify special, if it gives one style of a hybrid other weights than the rest;
- the first run of bpm/spring/plastic under hybrid, where LAMMPS mixes up what bonds first remember ([departures.md](departures.md));
- pair_modify compute no together with bond_style quartic, which takes pairs out of sums that LAMMPS then lets stand.

Slower than it could be, on the fast engine's force loops over ghosts and lists of the exact engine: tilted boxes, boxes narrower than twice the
neighbor cutoff, fix deform remap v, neigh_modify exclude, neighbor nsq, special_bonds weights between 0 and 1.

However small a script is, it loses nothing on the fast engine: of scripts with 2 to 250 atoms and 0 to 200 steps the whole process takes as long
on both, to 0.02 s of 0.32 s, once the kernels are in the store.

One thing is not as in LAMMPS: where write_restart makes ghosts anew between two runs, LAMMPS forgets what bonds across a periodic face went
through since the last rebuild. The fast engine has no ghosts there and forgets nothing.

Written by `python -m tests.engines.page`; `pytest -m long` runs every deck and compares both the result with the exact engine and the row with the log.

| deck | on the exact engine |
|---|---|"""


def row(deck: Path, lacks: list[str]) -> str:
    return f"| `{name(deck)}` | {', '.join(lacks)} |"


def page() -> str:
    rows = []
    for deck in DECKS:
        with tempfile.TemporaryDirectory() as folder:
            rows.append(row(deck, lacking(three(deck, Path(folder))[1])))
    return "\n".join([HEAD, *rows]) + "\n"


if __name__ == "__main__":
    PAGE.write_text(page())
