"""What starting costs: --help and a run whose kernels are in the store never load the compiler."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

DECK = """
units lj
atom_style bond
region space block 0 8 0 8 0 8
lattice sc 1.0
create_box 1 space bond/types 1 extra/bond/per/atom 2 extra/special/per/atom 4
create_atoms 1 single 3 3 3
create_atoms 1 single 4 3 3
mass 1 1.0
pair_style lj/cut 1.12
pair_coeff 1 1 1.0 1.0
bond_style harmonic
bond_coeff 1 30.0 1.1
special_bonds lj 0 1 1
create_bonds single/bond 1 1 2
fix 1 all nve
run 20
"""


def loaded(arguments: list[str], folder: Path, **environment: str) -> tuple[str, set[str]]:
    """Screen text of pylmp with these arguments, and the packages it had loaded at its end."""
    code = (
        f"import sys\nfrom pylmp.cli import main\ncode = main({arguments!r})\n"
        "print('LOADED', *{name.split('.')[0] for name in sys.modules})\nsys.exit(code)"
    )
    done = subprocess.run(
        [sys.executable, "-c", code],
        cwd=folder,
        env={**os.environ, **environment},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    screen, _, packages = done.stdout.rpartition("LOADED")
    return screen, set(packages.split())


def test_help_loads_neither_compiler_nor_arrays(tmp_path: Path) -> None:
    screen, packages = loaded(["--help"], tmp_path)
    assert "usage: pylmp" in screen
    assert not packages & {"numba", "llvmlite", "numpy", "lark"}


def test_a_warm_run_never_loads_the_compiler(tmp_path: Path) -> None:
    (tmp_path / "in.deck").write_text(DECK)
    cold, _ = loaded(["in.deck"], tmp_path, PYLMP_CACHE=str(tmp_path / "store"))
    warm, packages = loaded(["in.deck"], tmp_path, PYLMP_CACHE=str(tmp_path / "store"))
    assert "Compiling" in cold
    assert "Compiling" not in warm
    assert not packages & {"numba", "llvmlite"}
    assert "numpy" in packages


def test_a_script_without_a_run_is_carried_out_without_the_compiler(tmp_path: Path) -> None:
    (tmp_path / "in.deck").write_text(DECK.replace("run 20", "quit"))
    _, packages = loaded(["in.deck"], tmp_path)
    assert not packages & {"numba", "llvmlite"}
