"""What there is on this machine: versions, processor, the store of kernels, real LAMMPS. Nothing heavy is imported to find out."""

from __future__ import annotations

import importlib.machinery
import os
import platform
import re
import subprocess
import sys
from collections.abc import Callable
from importlib.metadata import PackageNotFoundError, distribution
from pathlib import Path
from typing import Any

from pylmp import __version__
from pylmp.engines import lammps
from pylmp.kernels import disk
from pylmp.kernels.load import Forbidden, check_allowed
from pylmp.text.diagnostic import ScriptError

PACKAGES = ("numpy", "numba", "llvmlite", "lark")  # those that a run needs
_WIDTHS = (("avx512f", 512), ("avx2", 256), ("asimd", 128), ("sse2", 128))  # flag of a processor, bits of its vectors
_SECONDS = 20.0  # that LAMMPS may take to say what it is


def gather() -> tuple[dict[str, Any], list[str]]:
    """(facts by topic, what is wrong: sentences)."""
    troubles: list[str] = []
    facts = {
        "pylmp": {"version": __version__, "folder": str(Path(__file__).parents[2])},
        "python": {"version": platform.python_version(), "program": sys.executable, "system": platform.platform()},
        "packages": _packages(troubles),
        "processor": _processor(),
        "store": _store(troubles),
        "lammps": _lammps(),
    }
    return facts, troubles


def _packages(troubles: list[str]) -> dict[str, str | None]:
    """Versions; a package that is not there, or stands in the shadow of another of its name, is trouble."""
    versions: dict[str, str | None] = {}
    for name in PACKAGES:
        try:
            found = distribution(name)
        except PackageNotFoundError:
            versions[name] = None
            troubles.append(f"the package {name} is not installed: pip install pylmp brings it")
            continue
        versions[name] = found.version
        where = importlib.machinery.PathFinder.find_spec(name)
        own = Path(str(found.locate_file(name))).resolve()
        if where is None or where.origin is None or Path(where.origin).resolve().parent != own:
            shadow = where.origin if where is not None and where.origin else "nothing"
            troubles.append(f"import {name} finds {shadow}, not the package in {own}: rename or remove what is in the way")
    if versions["lark"] is not None and int(versions["lark"].split(".")[0]) < 1:
        troubles.append("lark is older than 1.0: pip install -U lark")
    return versions


def _processor() -> dict[str, Any]:
    try:
        text = Path("/proc/cpuinfo").read_text()
    except OSError:
        text = ""
    name = re.search(r"^model name\s*:\s*(.*)$", text, re.MULTILINE)
    listed = re.search(r"^(?:flags|Features)\s*:\s*(.*)$", text, re.MULTILINE)
    flags = set(listed[1].split()) if listed else set()
    allowed = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count()
    return {
        "name": name[1] if name else platform.processor() or platform.machine(),
        "vector_bits": next((bits for flag, bits in _WIDTHS if flag in flags), None),
        "cores": os.cpu_count(), "cores_allowed": allowed, "threads_asked": os.environ.get("OMP_NUM_THREADS"),
    }  # fmt: skip


def _store(troubles: list[str]) -> dict[str, Any]:
    home = disk.folder()
    kernels, size = disk.contents()
    existing = next((path for path in (home, *home.parents) if path.exists()), home)
    writable = existing.is_dir() and os.access(existing, os.W_OK | os.X_OK)
    if not writable:
        troubles.append(f"{home} cannot be written: every run compiles its kernels anew; PYLMP_CACHE names another folder")
    try:
        check_allowed()
    except Forbidden as error:
        executable = False
        troubles.append(str(error))
    else:
        executable = True
    return {"folder": str(home), "kernels": kernels, "bytes": size, "writable": writable, "executable_memory": executable}


def _lammps() -> dict[str, Any] | None:
    """Where real LAMMPS is, what it says of itself, and its mpiexec; None: there is none. It is needed for diff and bench only."""
    try:
        there = lammps.find()
    except ScriptError:
        return None
    try:
        done = subprocess.run([there.program, "-h"], env=there.environment, capture_output=True, text=True, timeout=_SECONDS, check=False)
        said = done.stdout
    except (OSError, subprocess.SubprocessError):
        said = ""
    version = re.search(r"Simulator - (.*)", said)
    packages = re.search(r"Installed packages:\s+(.*?)\n\n(?=\S)", said, re.DOTALL)
    return {
        "program": there.program, "version": version[1] if version else None,
        "packages": packages[1].split() if packages else [], "mpiexec": _found(lammps.mpiexec),
    }  # fmt: skip


def _found(what: Callable[[], str]) -> str | None:
    try:
        return what()
    except ScriptError:
        return None
