"""Check the script of every folder named on standard input, in one process; says as JSON what was found, and whether a compiler was loaded."""

from __future__ import annotations

import json
import os
import sys
from pathlib import Path

from pylmp.tools.check.look import look


def main() -> None:
    found = {}
    for line in sys.stdin.read().splitlines():
        path = Path(line)
        os.chdir(path.parent)
        _, these = look(Path(path.name), [])
        found[line] = [
            [one.span.line if one.span else 0, one.span.column if one.span else 0, one.severity, one.code, one.message]
            for one in these
        ]
    print(json.dumps({"found": found, "compiler": any(name in sys.modules for name in ("numba", "llvmlite"))}))


if __name__ == "__main__":
    main()
