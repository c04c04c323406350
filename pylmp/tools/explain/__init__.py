"""`pylmp explain`: what each command of a script does here, and what a style is."""

from pylmp.tools.explain.main import main

__all__ = ["main"]
