"""pylmp check finds what LAMMPS refuses, says nothing of scripts that run, writes nothing and loads no compiler."""

from __future__ import annotations

import json
import re
import subprocess
import sys
from pathlib import Path
from typing import Any

from pylmp.cli import main
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


def test_scripts_of_inputs_have_no_warnings() -> None:
    paths = sorted(ROOT.glob("inputs/*/in.*"))
    told = look(paths)
    wrong = [(path.name, one) for path in paths for one in told["found"][str(path)] if one[2] == "warning"]
    assert not wrong


def test_decks_have_no_warnings_but_what_they_are_about() -> None:
    """Definitions that nothing uses (P2) are many a deck's purpose; the others are told here."""
    meant = {
        "delete_bonds.in": "P101",
        "minimize.in": "P109",  # bonds stretched past Rc before it begins
        "reset_atoms.in": "P113",
        "all_at_once.in": "P109",
        "last_step.in": "P108 P109",
    }
    told = look(sorted(ROOT.glob("tests/decks/*/*.in")))
    for path, found in told["found"].items():
        codes = {one[3] for one in found if one[2] == "warning" and not one[3].startswith("P2")}
        assert codes == set(meant.get(Path(path).name, "").split()), (path, found)


def test_holes_templates_and_formats(tmp_path: Path, monkeypatch: Any, capsys: Any) -> None:
    script = """units lj
lattice fcc {{density}}
region cell block 0 3 0 3 0 3
create_box 1 cell
create_atoms 1 random 20 4711 cell
mass 1 1.0
pair_style lj/cut 2.0
pair_coeff 1 1 1.0 1.0
fix 1 all nve
run 10
variable e equal pe
if "${e} > 0" then "thermo nothing" else "thermo 10 20"
fix 2 all nvve
print "${missing}"
"""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "in.holes").write_text(script)
    assert main(["check", "in.holes", "--format", "json"]) == 3
    found = json.loads(capsys.readouterr().out)["found"]
    assert [one["line"] for one in found if one["severity"] == "error"] == [12, 12, 13, 14]
    assert any(one["code"] == "N002" for one in found)
    assert main(["check", "in.holes", "--format", "github"]) == 3
    lines = capsys.readouterr().out.splitlines()
    assert len(lines) == 4
    assert all(
        re.match(r"::error file=in\.holes,line=1[234],col=\d+,endColumn=\d+,title=pylmp E001::", line) for line in lines
    )
    assert main(["check", "in.holes", "--format", "sarif"]) == 3
    report = json.loads(capsys.readouterr().out)
    run = report["runs"][0]
    assert report["version"] == "2.1.0"
    for result in run["results"]:
        assert run["tool"]["driver"]["rules"][result["ruleIndex"]]["id"] == result["ruleId"]
        assert result["level"] in ("error", "warning", "note")
        assert result["locations"][0]["physicalLocation"]["region"]["startLine"] >= 1
    assert main(["check", "in.holes", "--ignore", "E"]) == 0
    assert main(["check", "in.none"]) == 2
    assert main(["check"]) == 2
