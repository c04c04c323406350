"""Ctrl-C and SIGTERM. The first lets the step or command in progress end, the second does not wait."""

from __future__ import annotations

import contextlib
import os
import signal
import threading
from collections.abc import Iterator
from types import FrameType

_NOTICE = "\npylmp: stopping when the step or command in progress ends; once more stops at once\n"


class Interrupted(KeyboardInterrupt):
    """The run was ended from outside. number: of the signal. whole: nothing is half done."""

    def __init__(self, number: int, whole: bool) -> None:
        super().__init__(number)
        self.number = number
        self.whole = whole


class Interrupts:
    """number: of the first signal that came while somebody listened, 0: none. loud: the terminal is told what happens next."""

    def __init__(self) -> None:
        self.number = 0
        self.loud = False
        self._listening = False
        self._process = os.getpid()

    @contextlib.contextmanager
    def listen(self) -> Iterator[None]:
        """Inside, a first signal is noted. Within another listen(), and in threads that get no signals, this does nothing."""
        if self._listening or threading.current_thread() is not threading.main_thread():
            yield
            return
        self._listening, self.number = True, 0
        before = [(which, signal.signal(which, self._note)) for which in (signal.SIGINT, signal.SIGTERM)]
        try:
            yield
        finally:
            self._listening = False
            for which, old in before:
                signal.signal(which, old if old is not None else signal.SIG_DFL)

    def obey(self) -> None:
        """Raise Interrupted if a signal came."""
        number = self.number
        if not self._listening:
            self.number = 0
        if number:
            raise Interrupted(number, whole=True)

    def _note(self, number: int, frame: FrameType | None) -> None:
        if self.number:
            raise Interrupted(number, whole=False)
        self.number = int(number)
        if self.loud and os.getpid() == self._process:  # children are told too
            with contextlib.suppress(OSError):
                os.write(2, _NOTICE.encode())
