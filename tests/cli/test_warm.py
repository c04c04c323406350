"""What a run loads when its kernels are in the store: no compiler, and nothing that only other commands need."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from tests.engines.scenes import script

LOUD = """
import sys
from pylmp.cli import main
status = main()
heavy = {"numba", "llvmlite", "rich", "importlib.metadata", "matplotlib", "scipy", "pygls", "email.message", "pylmp.tools.bench"}
print("LOADED", *sorted(heavy & set(sys.modules)))
sys.exit(status)
"""


@pytest.mark.parametrize("bond", ["quartic", "plastic"])
@pytest.mark.parametrize("engine", ["fast", "exact"])
def test_no_compiler(engine: str, bond: str, tmp_path: Path) -> None:
    newton = "on on" if bond == "quartic" else "on off"
    (tmp_path / "in.small").write_text(script("lj", bond, newton=newton, flat=True) + "run 30\n")
    command = [sys.executable, "-c", LOUD, "--engine", engine, "in.small"]
    for warm in (False, True):
        done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stderr
        if warm:
            assert f"Engine {engine}" in done.stdout
            assert "Compiling" not in done.stdout
            assert done.stdout.splitlines()[-1].split() == ["LOADED"]
