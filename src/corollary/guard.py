"""Guard around the work on one person's input: an exception of any kind, or too much time, is a failure that stops nobody else's."""

from __future__ import annotations

import errno
import os
import signal
import sys
import threading
import time
import traceback
from collections.abc import Callable, Generator
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass
from types import FrameType
from typing import Final, TypeVar

T = TypeVar("T")

LONGEST: Final = 20_000
"""Letters of a traceback that are kept: a message may hold ten megabytes of an answer."""
FRAMES: Final = 30
OF_EVERYBODY: Final = {errno.ENOSPC, errno.EDQUOT, errno.EROFS}
AGAIN: Final = 1.0
"""Seconds after which an interruption that was lost (in a destructor, in a callback of C) comes once more."""


class Overtime(BaseException):
    """One person's input took more time of the processor than it may; no `except Exception` on the way stops it."""


@dataclass(frozen=True, slots=True)
class Failure:
    """An exception that this program did not foresee, in a few words, and where it was raised."""

    what: str
    trace: str


_collected: ContextVar[list[Failure] | None] = ContextVar("failures", default=None)


def guarded(
    work: Callable[[], T], seconds: float = 0.0, passing: tuple[type[Exception], ...] = ()
) -> T | Failure:
    """What the work returns; a failure where it raises an exception, or takes longer than so many seconds of the processor (0:
    as long as it likes). KeyboardInterrupt and SystemExit pass, and what is nobody's own: a disk that is full, and `passing`. With
    COROLLARY_DEBUG every exception does."""
    try:
        with within(seconds):
            return work()
    except Overtime as error:
        return _noted(Failure(f"it took longer than {seconds:g} s", _trace(error)))
    except Exception as error:
        full = isinstance(error, OSError) and error.errno in OF_EVERYBODY
        if full or isinstance(error, passing) or os.environ.get("COROLLARY_DEBUG"):
            raise
        return _noted(failure_of(error))


def failure_of(error: BaseException) -> Failure:
    """The failure that an exception is."""
    try:
        text = str(error)
    except Exception:
        text = "it cannot even say what is wrong"
    return Failure(f"{type(error).__name__}: {' '.join(text[:200].split())}".rstrip(": "), _trace(error))


@contextmanager
def collecting() -> Generator[list[Failure]]:
    """The failures of all that is guarded inside, which also go to whoever collects outside."""
    outer, found = _collected.get(), list[Failure]()
    token = _collected.set(found)
    try:
        yield found
    finally:
        _collected.reset(token)
        if outer is not None:
            outer.extend(found)


@contextmanager
def within(seconds: float) -> Generator[None]:
    """Raises Overtime inside after so many seconds of this process's own time, in its main thread and where the system has such
    a clock. The clock on the wall is not asked: a loaded machine must not decide what is marked."""
    if not seconds or not _has_clock():
        yield
        return
    armed = True

    def over(number: int, frame: FrameType | None) -> None:
        if armed:
            raise Overtime

    began = time.process_time()
    handler = signal.signal(signal.SIGPROF, over)
    left, _ = signal.setitimer(signal.ITIMER_PROF, seconds, AGAIN)
    if left and left < seconds:  # of a guard around this one
        signal.setitimer(signal.ITIMER_PROF, left, AGAIN)
    try:
        try:
            yield
        finally:
            armed = False
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0.0)
        signal.signal(signal.SIGPROF, handler)
        if left:
            signal.setitimer(signal.ITIMER_PROF, max(1e-3, left - (time.process_time() - began)), AGAIN)


@contextmanager
def ends_after(seconds: float) -> Generator[None]:
    """The system ends this process after so many seconds of the processor, even inside a library that hears no signal: for a
    process that marks, and whose end is noticed. Nothing where the system has no such clock."""
    if not _has_clock():
        yield
        return
    signal.signal(signal.SIGVTALRM, signal.SIG_DFL)
    signal.setitimer(signal.ITIMER_VIRTUAL, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_VIRTUAL, 0.0)


def _has_clock() -> bool:
    return (
        sys.platform not in {"win32", "emscripten"} and threading.current_thread() is threading.main_thread()
    )


def _noted(failure: Failure) -> Failure:
    found = _collected.get()
    if found is not None:
        found.append(failure)
    return failure


def _trace(error: BaseException) -> str:
    """Where an exception was raised: the innermost frames, without what the message says beyond bounds."""
    try:
        lines = traceback.format_exception(type(error), error, error.__traceback__, limit=-FRAMES)
    except Exception:  # of an exception that cannot be printed
        lines = traceback.format_tb(error.__traceback__, limit=-FRAMES)
    return "".join(lines)[-LONGEST:]
