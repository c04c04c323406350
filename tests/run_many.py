"""Run in.bad of every folder under the folder given, through the command line, in one process."""

from __future__ import annotations

import contextlib
import io
import os
import sys
from pathlib import Path

from pylmp.cli import main


def run(folder: Path) -> None:
    os.chdir(folder)
    screen = io.StringIO()
    with contextlib.redirect_stdout(screen), contextlib.redirect_stderr(screen):
        code = main(["in.bad"])
    (folder / "screen").write_text(screen.getvalue())
    (folder / "code").write_text(str(code))


if __name__ == "__main__":
    for folder in sorted(Path(sys.argv[1]).resolve().iterdir()):
        run(folder)
