"""pylmp check finds what LAMMPS refuses, says nothing of scripts that run, writes nothing and loads no compiler."""

from __future__ import annotations

import json
import re
import subprocess
import sys
from pathlib import Path
from typing import Any

from tests.corpus_reader import cases

ROOT = Path(__file__).parents[2]
ONLY_A_RUN = ROOT / "tests" / "check" / "only_a_run.txt"
# Decks that need a switch or another script's file, and what check then says.
NEEDS = {
    "shell.in": "Cannot run shell|Cannot read environment variable",
    "in.quartic_melt": "Cannot open file melt.data",
}


def look(paths: list[Path]) -> dict[str, Any]:
    text = "\n".join(str(path) for path in paths)
    done = subprocess.run(
        [sys.executable, "-m", "tests.check.look_many"],
        input=text,
        capture_output=True,
        text=True,
        check=False,
        cwd=ROOT,
    )
    assert done.returncode == 0, done.stderr
    return dict(json.loads(done.stdout))


def contents(folder: Path) -> dict[str, int]:
    return {str(path): path.stat().st_mtime_ns for path in folder.rglob("*") if "__pycache__" not in path.parts}


def test_every_wrong_script_of_the_corpus(tmp_path: Path) -> None:
    """The same sentence at the same place; only_a_run.txt holds what forces, time or files must be there for."""
    paths = []
    for number, case in enumerate(cases()):
        folder = tmp_path / f"{number:04}"
        folder.mkdir()
        paths.append(folder / "in.bad")
        paths[-1].write_text(case.script)
    before = contents(tmp_path)
    told = look(paths)
    assert contents(tmp_path) == before
    assert not told["compiler"]
    missed, more = [], []
    for case, path in zip(cases(), paths, strict=True):
        errors = [one for one in told["found"][str(path)] if one[2] == "error"]
        here = [one for one in errors if one[:2] == [case.line, case.column] and one[4].startswith(case.sentence)]
        if not here:
            missed.append(f"{case.script.splitlines()[case.line - 1]}: {case.sentence}")
        elif len(errors) > len(here):
            more.append((case.sentence, errors))
    known = [line for line in ONLY_A_RUN.read_text().splitlines() if line and not line.startswith("#")]
    assert sorted(missed) == sorted(known)
    assert not more


def test_scripts_that_run_are_not_complained_about() -> None:
    paths = sorted([*ROOT.glob("tests/decks/*/*.in"), *ROOT.glob("inputs/*/in.*")])
    before = {folder: contents(ROOT / folder) for folder in ("inputs", "tests/decks")}
    told = look(paths)
    assert {folder: contents(ROOT / folder) for folder in before} == before
    wrong = []
    for path in paths:
        for one in told["found"][str(path)]:
            if (one[2] == "error" or one[3] == "N009") and not re.match(NEEDS.get(path.name, "$^"), one[4]):
                wrong.append((path.name, one))
    assert len(paths) > 120
    assert not wrong
