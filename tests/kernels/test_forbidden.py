"""Executable memory may be denied: by SELinux, systemd, a container."""

from __future__ import annotations

import os
import platform
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]

DENIED = """
import ctypes, sys
if ctypes.CDLL(None).prctl(65, 1, 0, 0, 0):  # PR_SET_MDWE, PR_MDWE_REFUSE_EXEC_GAIN
    print("UNSUPPORTED")
    sys.exit()
if {no_files}:
    import os
    del os.memfd_create
from pylmp.cli import main
sys.exit(main(["--engine", "exact", "-log", "none", "in.deck"]))
"""
DECK = "region r block 0 8 0 8 0 8\ncreate_box 1 r\ncreate_atoms 1 single 3 3 3\nmass 1 1.0\npair_style lj/cut 1.1\npair_coeff 1 1 1 1\nfix 1 all nve\nrun 3\n"


@pytest.mark.skipif(sys.platform != "linux" or platform.machine() != "x86_64", reason="the small loader's platform")
def test_denied_executable_memory(tmp_path: Path) -> None:
    """Code of the store runs all the same, from a file in memory; where that is denied too, and where there is something to compile, a sentence."""
    (tmp_path / "in.deck").write_text(DECK)

    def run(code: str, store: str) -> subprocess.CompletedProcess[str]:
        environment = {**os.environ, "PYLMP_CACHE": str(tmp_path / store), "PYTHONPATH": str(ROOT)}
        return subprocess.run([sys.executable, "-c", code], cwd=tmp_path, env=environment, capture_output=True, text=True, check=False)

    allowed = run("import sys\nfrom pylmp.cli import main\nsys.exit(main(['--engine', 'exact', '-log', 'none', 'in.deck']))", "warm")
    assert allowed.returncode == 0, allowed.stderr
    warm = run(DENIED.format(no_files=False), "warm")
    if "UNSUPPORTED" in warm.stdout:
        pytest.skip("this Linux cannot deny it")
    assert warm.returncode == 0, warm.stdout + warm.stderr
    assert "Loop time" in warm.stdout
    assert "Compiling" not in warm.stdout
    for denied in (run(DENIED.format(no_files=False), "cold"), run(DENIED.format(no_files=True), "warm")):
        told = denied.stdout + denied.stderr
        assert denied.returncode == 1
        assert "ERROR: This system allows no executable memory" in told
        assert "Traceback" not in told
        assert "JIT" not in told
