"""pylmp restart: what is in a restart file, and the same as a data file."""

from pylmp.tools.restart.main import main

__all__ = ["main"]
