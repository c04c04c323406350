"""Where a run's text goes: the screen (standard output) and the log file."""

from __future__ import annotations

from typing import TextIO

from pylmp.text.diagnostic import ScriptError


class Console:
    """Two streams, either may be absent. Text is passed with its newlines."""

    def __init__(self, screen: TextIO | None = None, log: TextIO | None = None) -> None:
        self.screen_file = screen
        self.log_file = log
        self.warnings = 0
        self._noted: set[str] = set()
        self.limit = 100  # warnings after this many are not shown; 0: show all, below 0: none (thermo_modify warn)

    def both(self, text: str) -> None:
        self.screen(text)
        self.log(text)

    def screen(self, text: str) -> None:
        if self.screen_file is not None:
            try:
                self.screen_file.write(text)
            except BrokenPipeError:
                raise
            except OSError as error:
                self.screen_file = None
                raise ScriptError(f"Error writing to the screen: {error.strerror}") from None

    def log(self, text: str) -> None:
        if self.log_file is not None:
            try:
                self.log_file.write(text)
            except OSError as error:
                self.log_file = None
                raise ScriptError(f"Error writing log file: {error.strerror}") from None

    def warning(self, message: str) -> None:
        self.warnings += 1
        if self.limit and self.warnings > self.limit:
            return
        self.both(f"WARNING: {message}\n")

    def note(self, text: str) -> None:
        """Say something that is no warning, once."""
        if text not in self._noted:
            self._noted.add(text)
            self.both(f"NOTE: {text}\n")

    def overflow(self, silent: bool) -> bool:
        """Say, unless silent, that warnings are no longer shown because there were too many; is that so?"""
        if 0 < self.limit < self.warnings and not silent:
            many = f"{self.warnings} vs {self.limit}"
            self.both(f"WARNING: Too many warnings: {many}. All future warnings will be suppressed\n")
            return True
        return silent

    def flush(self) -> None:
        for stream in (self.screen_file, self.log_file):
            if stream is not None:
                stream.flush()
