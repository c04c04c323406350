"""Who runs against whom: the two sides, the reference's shadow where they are not identical, and the reference's own noise."""

from __future__ import annotations

import argparse
from dataclasses import replace
from pathlib import Path

from pylmp.text.diagnostic import ScriptError
from pylmp.tools.diff import compare, ledger, measure
from pylmp.tools.diff.instrument import Extras
from pylmp.tools.diff.report import Report
from pylmp.tools.diff.resync import resync
from pylmp.tools.diff.sides import Side
from pylmp.tools.diff.verdict import Compared, Growth, growth, judge
from pylmp.tools.permits import granted


def hold(options: argparse.Namespace, folder: Path) -> Report:
    """Run, compare and judge. Raises Failed, ScriptError, subprocess.TimeoutExpired."""
    switches = [word for names in options.var for word in ("-var", *names)]
    permits = ["--allow", ",".join(granted(options))]
    other = options.other or options.script
    titles = (options.script.name, other.name) if options.other else ("pylmp", "LAMMPS")
    if titles[0] == titles[1]:
        titles = str(options.script), str(other)
    mine = Side(titles[0], options.script, folder / "pylmp", options.engine, switches, permits, options.timeout)
    program = options.engine if options.other else "lammps"
    theirs = Side(titles[1], other, folder / ("other" if options.other else "lammps"), program, switches, permits, options.timeout)
    for side in (mine, theirs):
        side.run()
    found = _compared(mine, theirs)
    if not found.parts.identical or options.ledger:
        _second_pass(mine, theirs, found)
    shadow, rate = (None, None) if found.parts.identical else _shadow(theirs)
    report = Report(
        options.script.name, mine.title, theirs.title, found, judge(found, shadow, told=options.other is None), theirs.dialect.notes, theirs.dialect.exact,
        growth(found.runs), shadow, rate,
    )  # fmt: skip
    if options.noise and theirs.is_lammps:
        report.noise = _noise(theirs)
    if options.resync:
        report.resync = resync(mine, theirs, options.resync)
    return report


def _compared(mine: Side, theirs: Side) -> Compared:
    inputs = {path.name for side in (mine, theirs) for path in side.script.parent.iterdir() if path.is_file()}
    found = Compared(compare.runs(mine.folder, theirs.folder, inputs), measure.compare_runs(mine.folder, theirs.folder))
    for run in found.runs:
        run.ledger = ledger.summary(mine.folder, theirs.folder, run.number)
    return found


def _second_pass(mine: Side, theirs: Side, found: Compared) -> None:
    """Both once more: at each step on which one of them lost a bond, all bonds are listed."""
    steps = {run.number: ledger.changes((mine.folder, theirs.folder), run.number) for run in found.runs if run.ledger}
    if not any(steps.values()):
        return
    sides = [side.variant(side.title, f"{side.folder.name}-ledger", extras=Extras(ledger=list(steps))) for side in (mine, theirs)]
    for side in sides:
        side.run(steps)
    for run in found.runs:
        if run.ledger and steps.get(run.number):
            ledger.settle(run.ledger, sides[0].folder, sides[1].folder, run.number)


def _shadow(theirs: Side) -> tuple[Compared | None, Growth | None]:
    """The reference against itself with every atom moved by 1e-14; None if it does not run so."""
    side = theirs.variant("its shadow", "shadow", extras=replace(theirs.extras, perturbed=True))
    try:
        side.run()
    except ScriptError:
        return None, None
    found = _compared(side, theirs)
    return found, growth(found.runs)


def _noise(theirs: Side) -> dict[str, Compared | str]:
    """LAMMPS on two processes, and without sorting, against LAMMPS; why not, where it does not run so."""
    sides = [
        theirs.variant("itself on two processes", "two", program="mpi2"),
        theirs.variant("itself without sorting of atoms", "unsorted", extras=Extras(unsorted=True)),
    ]
    result: dict[str, Compared | str] = {}
    for side in sides:
        try:
            side.run()
            result[side.title] = _compared(side, theirs)
        except ScriptError as error:
            result[side.title] = error.diagnostic.message.splitlines()[-1]
    return result
