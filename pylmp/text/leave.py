"""Leaving a script before its end."""

from __future__ import annotations


class Quit(Exception):
    """The quit command: ends the run with its exit code."""

    def __init__(self, code: int) -> None:
        super().__init__(code)
        self.code = code
