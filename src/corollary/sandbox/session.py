"""Following one child with the clock in hand: what it has told so far, and what ended it."""

from __future__ import annotations

import signal
import time
from dataclasses import dataclass, field
from typing import assert_never, final

import msgspec

from corollary.sandbox.disk import bytes_in
from corollary.sandbox.job import Job, Limits
from corollary.sandbox.protocol import (
    Began,
    Broken,
    CallTold,
    CellTold,
    Done,
    Frames,
    Garbled,
    PictureTold,
    WallTest,
)
from corollary.sandbox.zygote import Child, tell

_GRACE = 1.0


@final
@dataclass(slots=True)
class WorkerState:
    """All a child has told, by the index of the cell or call; `ended` is "" or why it had to be ended."""

    cells: dict[int, CellTold] = field(default_factory=dict)
    calls: dict[int, CallTold] = field(default_factory=dict)
    pictures: dict[int, PictureTold] = field(default_factory=dict)
    seconds: dict[int, float] = field(default_factory=dict)
    trial: dict[str, bool] = field(default_factory=dict)
    working_on: Began | None = None
    late: bool = False
    done: bool = False
    ended: str = ""


def give(child: Child, job: Job, limits: Limits, trial: bool = False) -> None:
    """Hands over the job; raises OSError when the child is gone."""
    sent = {
        "cells": [cell.source for cell in job.cells],
        "names": list(job.names),
        "asks": [(ask.function, ask.arguments, ask.seconds) for ask in job.asks],
        "pictures": job.pictures,
        "limits": msgspec.to_builtins(limits),
        "trial": trial,
    }
    text = msgspec.msgpack.encode(sent)
    child.channel.sendall(len(text).to_bytes(4, "big") + text)


def follow(child: Child, job: Job, limits: Limits, watch: Watch, told: WorkerState) -> None:
    """Reads frames into `told` until the child is done or at its end; interrupts what is too long, kills what does not stop.

    It is done when all answers are out; the pictures that may still follow can only be missing.
    """
    frames = Frames(child.channel)
    last = time.monotonic() + limits.total_seconds
    deadline, interrupted, began = last, False, time.monotonic()
    pictures = 0
    while True:
        try:
            frame = frames.read(min(deadline, last, time.monotonic() + watch.every))
        except Garbled:
            _kill(child, told, "what its process sent could not be read")
            return
        match frame:
            case "late":
                if trouble := watch.trouble():
                    _kill(child, told, trouble)
                    return
                now = time.monotonic()
                if now >= last:
                    _kill(child, told, f"the notebook ran longer than {limits.total_seconds:g} s in all")
                    return
                if now >= deadline:
                    told.late = True
                    if interrupted:
                        _kill(child, told, "it did not stop when its time was up")
                        return
                    tell(child, signal.SIGINT)
                    interrupted, deadline = True, now + _GRACE
            case "end":
                return
            case Began(what, index):
                told.working_on, told.late, interrupted, began = frame, False, False, time.monotonic()
                deadline = began + _allowed(job, limits, what == "call", index)
            case CellTold(index=index):
                if index not in told.cells and index < len(job.cells):
                    told.cells[index] = frame
                    told.seconds[index] = time.monotonic() - began
                deadline = last
            case CallTold(index=index):
                if index < len(job.asks):
                    told.calls.setdefault(index, frame)
                deadline = last
            case WallTest(held):
                told.trial = held
            case Broken(why):
                told.ended = f"its own process stumbled ({why})"
            case Done(pictures):
                told.working_on, told.done = None, True
            case PictureTold(index):
                told.pictures[index] = frame
            case _:
                assert_never(frame)
        if told.done and len(told.pictures) >= pictures:
            return


@final
@dataclass(frozen=True, slots=True)
class Watch:
    """Looks at what the kernel does not bound, every so many seconds; `trouble` gives a sentence or ""."""

    every: float = 3600.0
    folder: str = ""
    most_bytes: int = 0

    def trouble(self) -> str:
        return "" if not self.folder or bytes_in(self.folder) <= self.most_bytes else "it filled the disk"


def _allowed(job: Job, limits: Limits, call: bool, index: int) -> float:
    if call:
        return job.asks[index].seconds if index < len(job.asks) else 0.0
    return limits.cell_seconds


def _kill(child: Child, told: WorkerState, why: str) -> None:
    tell(child, signal.SIGKILL)
    told.ended = why
