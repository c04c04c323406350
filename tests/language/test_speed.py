"""Loops of a script cost little: a line is read once, however often it is carried out."""

from __future__ import annotations

import time
from pathlib import Path

import pytest

from pylmp.cli import main


def test_a_hundred_thousand_turns(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """10^5 iterations of a loop that prints take less than ten seconds of the processor; about two on one of 2020."""
    monkeypatch.chdir(tmp_path)
    Path("in.loop").write_text('variable i loop 100000\nlabel a\nprint "at $i" screen no\nnext i\njump SELF a\nprint "done"\n')
    begun = time.process_time()
    assert main(["in.loop", "-log", "none", "-screen", "none"]) == 0
    assert time.process_time() - begun < 10.0
