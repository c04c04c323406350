"""``pylmp doctor``: what pylmp finds on this machine."""

from pylmp.tools.doctor.main import main

__all__ = ["main"]
