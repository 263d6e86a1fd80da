"""Limits for an author's own code: of its time, and of ending the process that it runs in."""

from __future__ import annotations

import os
import signal
import sys
import threading
from collections.abc import Generator
from contextlib import contextmanager
from types import FrameType
from typing import NoReturn

AGAIN = 1.0  # seconds: code that catches the first interruption is interrupted once more


class TooLong(Exception):
    """The code ran longer than it may."""


@contextmanager
def no_way_out() -> Generator[None]:
    """What would end the process without a word raises SystemExit, and is a failing as every other. A signal ends it all the same."""

    def leave(status: int = 1, /) -> NoReturn:
        raise SystemExit(f"it would end the program (status {status})")

    before = os._exit, os.abort
    os._exit = os.abort = leave
    try:
        yield
    finally:
        os._exit, os.abort = before


@contextmanager
def time_limit(seconds: float) -> Generator[None]:
    """Raises TooLong in what runs inside. Only the main thread of a process on Unix can be interrupted so; elsewhere nothing limits it."""
    if sys.platform == "win32" or threading.current_thread() is not threading.main_thread():
        yield
        return

    def interrupt(_signal: int, _frame: FrameType | None) -> None:
        raise TooLong(f"it ran longer than {seconds:g} s")

    before = signal.signal(signal.SIGALRM, interrupt)
    signal.setitimer(signal.ITIMER_REAL, seconds, AGAIN)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0.0)
        signal.signal(signal.SIGALRM, before)
