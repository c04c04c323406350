"""Who takes part in a bench: pylmp's engines, and LAMMPS as it is started in five ways."""

from __future__ import annotations

import os
import sys
from collections.abc import Sequence
from dataclasses import dataclass

from pylmp.engines import lammps

SERIAL = "lammps"  # whom the others are compared with
_SUFFIX = {"opt": ["-sf", "opt"], "omp1": ["-sf", "omp", "-pk", "omp", "1"], "omp2": ["-sf", "omp", "-pk", "omp", "2"]}
_NATIVE = {"exact": ("exact", 1), "fast": ("fast", 1), "fast2": ("fast", 2)}  # engine and threads
NAMES = (*_NATIVE, SERIAL, *_SUFFIX, "mpi2")
PAIRED = ("omp2", "mpi2")  # LAMMPS on two processors


@dataclass(frozen=True)
class Contender:
    """One way to run a script. native: pylmp itself. threads: processors it may keep busy."""

    name: str
    title: str
    native: bool
    threads: int
    start: tuple[str, ...]
    switches: tuple[str, ...]
    environment: dict[str, str]

    def command(self, script: str, switches: Sequence[str]) -> list[str]:
        """Its command line for a script of the folder it runs in."""
        return [*self.start, script, *self.switches, "-screen", "none", "-log", "log.lammps", "-nocite", *switches]


def contender(name: str, store: str | None = None) -> Contender:
    """The contender of that name; store: where pylmp keeps its kernels, if not where it always does.

    Raises ScriptError where LAMMPS or mpiexec is wanted and not installed.
    """
    if name in _NATIVE:
        environment = {**os.environ, "OMP_NUM_THREADS": "1"} | ({"PYLMP_CACHE": store} if store else {})
        engine, threads = _NATIVE[name]
        title = f"pylmp, {engine}" + (f", {threads} threads" if threads > 1 else "")
        switches = ("--engine", engine, *(("--threads", str(threads)) if threads > 1 else ()))
        return Contender(name, title, True, threads, (sys.executable, "-m", "pylmp"), switches, environment)
    there = lammps.find()
    start = ((lammps.mpiexec(), "-n", "2") if name == "mpi2" else ()) + (there.program, "-in")
    switches = tuple(_SUFFIX.get(name, ()))
    title = "LAMMPS, serial" if name == SERIAL else "LAMMPS, mpiexec -n 2" if name == "mpi2" else f"LAMMPS, {' '.join(switches)}"
    return Contender(name, title, False, 2 if name.endswith("2") else 1, start, switches, there.environment)
