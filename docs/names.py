"""Writes grammar/names.txt: the names of LAMMPS's commands and styles, so that what pylmp lacks is known and not called misspelled.

    python docs/names.py

The names are those that the installed LAMMPS tells (``info styles all``), those of its built-in commands, and those of packages
that its binary distribution leaves out (from the lists in its manual: Commands_all.html and its neighbors).
"""

from __future__ import annotations

import re
import subprocess
import sys
import tempfile
import textwrap
from pathlib import Path

ROOT = Path(__file__).parents[1]
PAGE = ROOT / "grammar" / "names.txt"
_SUFFIX = re.compile(r"/(omp|opt|kk|gpu|intel)$")
_LEFT_OUT = {
    "command": "angle_coeff angle_style atom_modify atom_style bond_coeff bond_style bond_write boundary clear comm_modify comm_style "
    "compute compute_modify dielectric dihedral_coeff dihedral_style dimension dump dump_modify echo fix fix_modify group if "
    "improper_coeff improper_style include jump kim kspace_modify kspace_style label labelmap lattice log mass mdi min_modify min_style "
    "molecule neigh_modify neighbor newton next package pair_coeff pair_modify pair_style pair_write partition print processors python "
    "quit region replicate reset_atoms reset_image_flags reset_timestep restart run_style shell special_bonds suffix thermo "
    "thermo_modify thermo_style timer timestep uncompute undump unfix units variable",
    "fix": "atc lb/fluid lb/momentum lb/viscous manifoldforce mdi/qm mdi/qmmm nve/awpmd nve/manifold/rattle nvt/manifold/rattle plumed "
    "python/invoke python/move qbmsst qmmm qtb",
    "pair": "awpmd/cut hdnnp kim lj/cut/dipole/sf mgpt none pace pace/extrapolation python quip rann smatb smatb/single smtbq",
    "bond": "none", "angle": "none", "dihedral": "none", "improper": "none", "kspace": "none scafacos",
    "compute": "pace ptm/atom", "dump": "adios h5md molfile netcdf netcdf/mpiio vtk",
}  # fmt: skip


def told() -> dict[str, set[str]]:
    """kind -> names, without the suffixes of accelerated versions, as the installed LAMMPS lists them."""
    with tempfile.TemporaryDirectory() as folder:
        script = Path(folder) / "in.names"
        script.write_text("info styles all\n")
        program = Path(sys.prefix) / "bin" / "lmp"
        done = subprocess.run(
            [str(program), "-in", str(script), "-log", "none"], capture_output=True, text=True, check=True, cwd=folder
        )
    parts = re.split(r"\n(\w+) styles[^\n]*:\n", done.stdout.split("Info-Info")[1] + done.stdout)
    return {
        kind.lower(): {_SUFFIX.sub("", name) for name in names.split("Info-Info")[0].split()}
        for kind, names in zip(parts[1::2], parts[2::2], strict=True)
    }


def page() -> str:
    """The text of the file."""
    names = told()
    for kind, more in _LEFT_OUT.items():
        names[kind] |= set(more.split())
    lines = ["# Names of LAMMPS's commands and styles, without the suffixes of accelerated versions. Written by docs/names.py."]
    for kind in sorted(names):
        lines += ["", f"{kind}:", *textwrap.wrap(" ".join(sorted(names[kind])), 130, break_on_hyphens=False, break_long_words=False)]
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    PAGE.write_text(page())
