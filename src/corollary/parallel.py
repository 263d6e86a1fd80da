"""Processes beside this one: how many this program may use, how they begin, and that none outlives the one that made it."""

from __future__ import annotations

import gc
import os
import signal
import sys
from multiprocessing import get_context, parent_process
from multiprocessing.connection import wait
from multiprocessing.context import BaseContext
from threading import Thread


def cores() -> int:
    """How many this program may use."""
    return len(os.sched_getaffinity(0)) if sys.platform == "linux" else os.cpu_count() or 1


def way_to_start() -> BaseContext:
    """A fork has what was loaded and derived already; elsewhere than on Linux the system's own libraries do not survive one."""
    return get_context("fork" if sys.platform == "linux" else "spawn")


def begin() -> None:
    """In a new process: Ctrl-C ends it at once, and it does not outlive the one that made it, however that one ends."""
    gc.freeze()  # what was there before stays: looking through it again and again would be a tenth to a fifth of the time
    gc.set_threshold(100_000, 50, 100)
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    Thread(target=_end_with_parent, daemon=True).start()


def _end_with_parent() -> None:
    parent = parent_process()
    if parent is not None:
        wait([parent.sentinel])
        os._exit(1)
