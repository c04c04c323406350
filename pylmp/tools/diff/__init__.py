"""pylmp diff: one script, two programs, every number compared."""

from pylmp.tools.diff.main import main

__all__ = ["main"]
