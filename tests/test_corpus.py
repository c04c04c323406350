"""Wrong scripts: LAMMPS's sentence, the place, a caret, exit code 1, no traceback; and LAMMPS agrees that they are wrong."""

from __future__ import annotations

import re
import subprocess
import sys

import pytest

from tests.corpus_reader import Case, cases
from tests.support import lammps

CASES = cases()
NAMES = [f"{k}-{case.sentence[:50]}" for k, case in enumerate(CASES)]


def test_the_corpus_is_not_small() -> None:
    assert len(CASES) >= 60
    assert len({case.script for case in CASES}) == len(CASES)


@pytest.mark.parametrize("case", CASES, ids=NAMES)
def test_lammps_says_so_too(case: Case, tmp_path) -> None:
    """Some errors LAMMPS finds by reading memory that it never wrote: where it stays silent it is asked again, up to twice."""
    for _ in range(3):
        outcome = lammps(case.script, tmp_path, "-log", "none")
        said = re.findall(r"^ERROR(?: on proc 0)?: (.*)$", outcome.screen, re.M)
        if said:
            break
    assert said
    assert outcome.code == 1
    assert said[0].startswith(case.sentence)


def test_pylmp_names_sentence_and_place(tmp_path) -> None:
    """All cases in one go: each its own process would cost a minute of start-ups."""
    for number, case in enumerate(CASES):
        folder = tmp_path / str(number)
        folder.mkdir()
        (folder / "in.bad").write_text(case.script)
    done = subprocess.run(
        [sys.executable, "-m", "tests.run_many", str(tmp_path)], capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr
    wrong = []
    for number, case in enumerate(CASES):
        text = (tmp_path / str(number) / "screen").read_text()
        code = (tmp_path / str(number) / "code").read_text()
        source = case.script.splitlines()[case.line - 1]
        caret = " " * (case.column - 1) + "^" * max(1, case.length)
        expected = [
            f"ERROR: {case.sentence}" in text,
            f"in.bad:{case.line}:{case.column}" in text,
            f"{source}\n" in text and f"   | {caret}\n" in text + "\n",
            "Traceback" not in text,
            code == "1",
        ]
        if not all(expected):
            wrong.append(f"{expected} {case.sentence}\n{text[-700:]}")
    assert not wrong, f"{len(wrong)} of {len(CASES)}\n" + "\n----\n".join(wrong)
