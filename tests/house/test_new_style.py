"""Adding a style is adding one file, in pylmp or in a package of one's own; nothing else is edited."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).parents[2]

BOND = '''
"""bond_style my/cubic: E = K dr^2 + L dr^3."""
from pylmp.laws import sqrt
from pylmp.model.registry import BONDS
from pylmp.model.style import BondStyle, Coeff

def cubic(r2, dot, h, c):
    k, l, r0 = c
    r = sqrt(r2)
    dr = r - r0
    return -(2.0 * k * dr + 3.0 * l * dr * dr) / r, k * dr * dr + l * dr * dr * dr, h, True

BONDS.add("my/cubic", BondStyle(
    name="my/cubic", manual="", law=lambda options: cubic, length=lambda coeffs, options: coeffs[2],
    coeffs=(Coeff("K", "energy/distance^2"), Coeff("L", "energy/distance^3"), Coeff("r0", "distance")),
))
'''
FIX = '''
"""fix ID GROUP my/say: announces itself when a run begins."""
from pylmp.model.fix import Fix
from pylmp.model.registry import FIXES

@FIXES.register("my/say")
class Say(Fix):
    def setup(self, sim):
        sim.console.both("my/say is here\\n")
'''
SCRIPT = """
units lj
atom_style bond
region space block 0 8 0 8 0 8 units box
create_box 1 space bond/types 1 extra/bond/per/atom 2 extra/special/per/atom 4
create_atoms 1 single 3 3 3 units box
create_atoms 1 single 4.5 3 3 units box
mass 1 1.0
pair_style zero 2.0
pair_coeff * *
bond_style my/cubic
bond_coeff 1 8.0 2.0 1.0
create_bonds single/bond 1 1 2
fix 1 all my/say
thermo_modify norm no
run 0
"""


def simulate(folder: Path, *path: Path) -> subprocess.CompletedProcess[str]:
    (folder / "in.deck").write_text(SCRIPT)
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(map(str, path)), "PYLMP_CACHE": str(folder / "store")}
    return subprocess.run(
        [sys.executable, "-m", "pylmp", "in.deck"],
        cwd=folder,
        env=environment,
        capture_output=True,
        text=True,
        check=False,
    )


def energy_per_bond(screen: str) -> float:
    (row,) = re.findall(r"Step .*\n +0 +\S+ +\S+ +(\S+)", screen)
    return float(row)


EXPECTED = 8.0 * 0.5**2 + 2.0 * 0.5**3


def test_a_package_of_ones_own_brings_styles(tmp_path: Path) -> None:
    site = tmp_path / "site"
    (site / "mine").mkdir(parents=True)
    (site / "mine" / "__init__.py").write_text("")
    (site / "mine" / "cubic.py").write_text(BOND)
    (site / "mine" / "say.py").write_text(FIX)
    about = site / "mine-1.0.dist-info"
    about.mkdir()
    (about / "METADATA").write_text("Metadata-Version: 2.1\nName: mine\nVersion: 1.0\n")
    (about / "entry_points.txt").write_text("[pylmp.bonds]\ncubic = mine.cubic\n[pylmp.fixes]\nsay = mine.say\n")
    done = simulate(tmp_path, site, ROOT)
    assert done.returncode == 0, done.stdout + done.stderr
    assert energy_per_bond(done.stdout) == EXPECTED
    assert "my/say is here" in done.stdout


def test_a_file_in_pylmp_is_a_style(tmp_path: Path) -> None:
    copy = tmp_path / "copy"
    for part in ("pylmp", "grammar"):
        shutil.copytree(ROOT / part, copy / part, ignore=shutil.ignore_patterns("__pycache__"))
    (copy / "pylmp" / "bonds" / "my_cubic.py").write_text(BOND)
    (copy / "pylmp" / "fixes" / "my_say.py").write_text(FIX)
    done = simulate(tmp_path, copy)
    assert done.returncode == 0, done.stdout + done.stderr
    assert energy_per_bond(done.stdout) == EXPECTED
    assert "my/say is here" in done.stdout


def test_without_it_the_script_is_refused(tmp_path: Path) -> None:
    done = simulate(tmp_path, ROOT)
    assert done.returncode == 1
    assert "my/cubic" in done.stdout
    assert "Traceback" not in done.stdout + done.stderr


def test_an_engine_names_no_style() -> None:
    """Which styles exist is written nowhere but in their own files: the engines and the model never spell one."""
    styles = {"quartic", "harmonic", "bpm/spring/plastic", "bpm/spring", "lj/cut", "langevin"}
    for path in (*(ROOT / "pylmp" / "engines").glob("*.py"), *(ROOT / "pylmp" / "kernels").rglob("*.py")):
        spelled = set(re.findall(r'"([^"\n]*)"', path.read_text()))
        assert not spelled & styles, path.name
