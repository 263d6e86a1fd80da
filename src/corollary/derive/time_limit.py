"""Limits for an author's own code: of its time, of ending the process that it runs in, and of looking like a person's ctrl-C."""

from __future__ import annotations

import ctypes
import os
import signal
import threading
import time
from collections.abc import Callable, Generator
from contextlib import contextmanager
from types import FrameType
from typing import NoReturn

TICK = 1.0  # seconds: how often is looked, and how soon code that catches the interruption is interrupted once more


class TooLong(Exception):
    """The code ran longer than it may."""

    def __init__(self, sentence: str = "it does not end"):
        super().__init__(sentence)


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
def keyboard() -> Generator[Callable[[], bool]]:
    """Yields a function: whether a person has interrupted what runs inside. Any other KeyboardInterrupt is the code's own."""
    before = signal.getsignal(signal.SIGINT)
    if not callable(before) or not _is_main_thread():  # ignored, or heard elsewhere: then none is a person's
        yield lambda: False
        return
    pressed, theirs = False, before

    def note(number: int, frame: FrameType | None) -> None:
        nonlocal pressed
        pressed = True
        theirs(number, frame)

    signal.signal(signal.SIGINT, note)
    try:
        yield lambda: pressed
    finally:
        signal.signal(signal.SIGINT, before)


@contextmanager
def time_limit(processor_s: float, wall_s: float) -> Generator[None]:
    """Raises TooLong in what runs inside after so many seconds of this process's own time, or on the wall: a loaded machine is not
    what makes a program endless. In a thread the interpreter is asked to raise it, which a call into C does not hear."""
    began, clock = time.process_time(), time.monotonic()

    def over() -> bool:
        return time.process_time() - began > processor_s or time.monotonic() - clock > wall_s

    sentence = f"it ran longer than {processor_s:g} s of the processor, or {wall_s:g} s on the wall"
    timer = getattr(signal, "SIGALRM", None)  # Windows has none
    with (_by_signal if _is_main_thread() and timer is not None else _by_thread)(over, sentence):
        yield


@contextmanager
def _by_signal(over: Callable[[], bool], sentence: str) -> Generator[None]:
    def look(_signal: int, _frame: FrameType | None) -> None:
        if over():
            raise TooLong(sentence)

    before = signal.signal(signal.SIGALRM, look)
    signal.setitimer(signal.ITIMER_REAL, TICK, TICK)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0.0)
        signal.signal(signal.SIGALRM, before)


@contextmanager
def _by_thread(over: Callable[[], bool], sentence: str) -> Generator[None]:
    """Only a class can be raised in another thread, without the sentence."""
    raise_in, thread = ctypes.pythonapi.PyThreadState_SetAsyncExc, ctypes.c_ulong(threading.get_ident())
    ended = threading.Event()

    def look() -> None:
        while not ended.wait(TICK):
            if over():
                raise_in(thread, ctypes.py_object(TooLong))

    looking = threading.Thread(target=look, daemon=True)
    looking.start()
    try:
        yield
    finally:
        ended.set()
        looking.join()
        raise_in(thread, None)  # one that was on its way is called back


def _is_main_thread() -> bool:
    return threading.current_thread() is threading.main_thread()
