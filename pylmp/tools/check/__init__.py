"""`pylmp check`: every error and warning of a script, without a step."""

from pylmp.tools.check.main import main

__all__ = ["main"]
