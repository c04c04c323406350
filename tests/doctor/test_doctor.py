"""pylmp doctor: what it says must be what is there, as other programs see it."""

from __future__ import annotations

import json
import os
import platform
import subprocess
import sys
from importlib.metadata import version
from pathlib import Path
from typing import Any

import pytest

from pylmp.kernels import disk

ROOT = Path(__file__).parents[2]


def doctor(folder: Path, *words: str, **environment: str) -> subprocess.CompletedProcess[str]:
    surroundings = {**os.environ, "PYLMP_CACHE": str(folder / "store"), "PYTHONPATH": str(ROOT), **environment}
    return subprocess.run([sys.executable, "-m", "pylmp", "doctor", *words], cwd=folder, env=surroundings, capture_output=True, text=True, check=False)


def facts(folder: Path, *words: str, code: int = 0, **environment: str) -> dict[str, Any]:
    done = doctor(folder, "--json", *words, **environment)
    assert done.returncode == code, done.stdout + done.stderr
    found: dict[str, Any] = json.loads(done.stdout)
    return found


def test_versions_and_lammps(tmp_path: Path) -> None:
    found = facts(tmp_path, OMP_NUM_THREADS="3")
    assert found["packages"] == {name: version(name) for name in ("numpy", "numba", "llvmlite", "lark")}
    assert found["python"]["version"] == platform.python_version()
    assert found["processor"]["cores"] == os.cpu_count()
    assert found["processor"]["threads_asked"] == "3"
    assert found["troubles"] == []
    there = found["lammps"]
    if there is None:
        pytest.skip("real LAMMPS is not installed")
    assert there["version"] == "22 Jul 2025 - Update 4"
    assert {"BPM", "MOLECULE", "OPENMP", "OPT"} <= set(there["packages"])
    assert all(name == name.upper() for name in there["packages"])
    assert there["mpiexec"] is None or os.access(there["mpiexec"], os.X_OK)


def test_the_compiler_agrees_on_the_width(tmp_path: Path) -> None:
    """Bits of vectors, as LLVM knows the processor."""
    code = "import llvmlite.binding as l\nprint(*(name for name, on in l.get_host_cpu_features().items() if on))"
    features = set(subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout.split())
    expected = 512 if "avx512f" in features else 256 if "avx2" in features else 128 if features & {"sse2", "neon"} else None
    assert facts(tmp_path)["processor"]["vector_bits"] == expected


def test_store_is_counted_and_emptied(tmp_path: Path, monkeypatch) -> None:
    monkeypatch.setenv("PYLMP_CACHE", str(tmp_path / "store"))
    assert facts(tmp_path)["store"] == {
        "folder": str(tmp_path / "store"), "kernels": 0, "bytes": 0, "writable": True, "executable_memory": True,
    }  # fmt: skip
    disk.keep("a" * 40, b"some code")
    disk.keep("b" * 40, b"some more code")
    left = tmp_path / "store" / f"{'c' * 40}.123.deadbeef"
    left.write_bytes(b"of a process that was killed")
    strangers = [tmp_path / "store" / name for name in ("notes.txt", "short.o", "d" * 40)]
    for stranger in strangers:
        stranger.write_text("not ours")
    sizes = [path.stat().st_size for path in (tmp_path / "store").glob(f"{'[ab]' * 40}.o")]
    assert len(sizes) == 2
    found = facts(tmp_path)["store"]
    assert (found["kernels"], found["bytes"]) == (2, sum(sizes))
    told = doctor(tmp_path, "--empty-store")
    assert told.stdout.startswith(f"3 files deleted from {tmp_path / 'store'}\n")
    assert facts(tmp_path)["store"]["kernels"] == 0
    assert sorted((tmp_path / "store").iterdir()) == sorted(strangers)
    assert facts(tmp_path, "--empty-store")["deleted"] == 0


def test_what_is_in_the_way(tmp_path: Path) -> None:
    (tmp_path / "lark.py").write_text("raise SystemExit('the wrong lark')\n")
    (tmp_path / "store").write_text("a file")
    (first, second) = facts(tmp_path, code=1)["troubles"]
    assert first.startswith(f"import lark finds {tmp_path / 'lark.py'}")
    assert second.startswith(f"{tmp_path / 'store'} cannot be written")
    told = doctor(tmp_path)
    assert told.returncode == 1
    assert f"ERROR: {first}" in told.stdout
    assert doctor(tmp_path, "--nonsense").returncode == 2


def test_nothing_heavy_is_loaded(tmp_path: Path) -> None:
    code = "import sys\nfrom pylmp.cli import main\nmain(['doctor'])\nprint('LOADED', *{n.split('.')[0] for n in sys.modules} & {'numba', 'llvmlite', 'lark', 'scipy'})"
    done = subprocess.run([sys.executable, "-c", code], cwd=tmp_path, capture_output=True, text=True, check=True)
    assert done.stdout.splitlines()[-1].split() == ["LOADED"]
