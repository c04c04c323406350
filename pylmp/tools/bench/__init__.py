"""pylmp bench: the same script on several engines, in turn, and what each step costs."""

from pylmp.tools.bench.main import main

__all__ = ["main"]
