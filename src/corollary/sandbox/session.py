"""One worker followed from job to end, with the clock in hand: what it has sent so far, and why it had to be ended."""

from __future__ import annotations

import signal
import time
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import assert_never, final

import msgspec

from corollary.messages import catalogue
from corollary.sandbox.folders import Canary
from corollary.sandbox.job import Job, Limits
from corollary.sandbox.protocol import (
    Began,
    Broken,
    CallFrame,
    CellFrame,
    Done,
    Frames,
    Garbled,
    PictureFrame,
    Probed,
    send,
    worker_frames,
)
from corollary.sandbox.zygote import Worker

_ = catalogue(__name__)

_GRACE = (
    1.0  # seconds between the interrupt and the kill: a cell that catches KeyboardInterrupt may still tidy up
)
_DISK_WATCH = 0.25  # seconds between two looks at a folder that no quota bounds


@final
@dataclass(slots=True)
class WorkerState:
    """All that a worker has sent, by the index of the cell, call or picture; `ended` is "" or why it was ended early.

    `working_on` is what it began last, while that is not finished; `late` says that its time was up.
    """

    cells: dict[int, CellFrame] = field(default_factory=dict[int, CellFrame])
    calls: dict[int, CallFrame] = field(default_factory=dict[int, CallFrame])
    pictures: dict[int, PictureFrame] = field(default_factory=dict[int, PictureFrame])
    seconds: dict[int, float] = field(default_factory=dict[int, float])
    held: dict[str, bool] = field(default_factory=dict[str, bool])
    working_on: Began | None = None
    started: bool = False
    late: bool = False
    done: bool = False
    ended: str = ""
    exit_code: int | None = None
    machine_failed: bool = False


def send_job(worker: Worker, job: Job, limits: Limits, canary: Canary | None = None) -> None:
    """Hands over the job, or what to probe instead; raises OSError when the worker is gone."""
    message = {
        "cells": [cell.source for cell in job.cells],
        "names": list(job.names),
        "calls": [(call.function, call.arguments, call.seconds) for call in job.calls],
        "pictures": job.pictures,
        "limits": msgspec.to_builtins(limits),
        "probe": canary,
    }
    send(worker.channel, message)


def follow(
    worker: Worker, job: Job, limits: Limits, state: WorkerState, disk_used: Callable[[], int] | None = None
) -> None:
    """Reads frames into `state` until the worker is done or gone; interrupts what takes too long, kills what does not stop.

    It is done when all answers are out; the pictures that may still follow can only be missing. `disk_used` gives the bytes
    in its folder, where the kernel does not bound them.
    """
    frames = Frames(worker.channel, worker_frames)
    last = time.monotonic() + limits.total_seconds
    deadline, interrupted, began = last, False, time.monotonic()
    pictures = 0
    while True:
        try:
            look = time.monotonic() + _DISK_WATCH if disk_used is not None else last
            frame = frames.read(min(deadline, last, look))
        except Garbled:
            _kill(worker, state, _("what its process sent could not be read"))
            return
        match frame:
            case "late":
                if disk_used is not None and disk_used() > limits.file_bytes:
                    _kill(worker, state, _("it filled the disk"))
                    return
                now = time.monotonic()
                if now >= last:
                    seconds = f"{limits.total_seconds:g}"
                    _kill(
                        worker, state, _("the notebook ran longer than {seconds} s in all", seconds=seconds)
                    )
                    return
                if now >= deadline:
                    state.late = True
                    if interrupted:
                        _kill(worker, state, _("it did not stop when its time was up"))
                        return
                    worker.signal(signal.SIGINT)
                    interrupted, deadline = True, now + _GRACE
            case "end":
                return
            case Began(what, index):
                began = time.monotonic()
                state.working_on, state.started, state.late, interrupted = frame, True, False, False
                deadline = began + _seconds(job, limits, what == "call", index)
            case CellFrame(index=index):
                if index not in state.cells and index < len(job.cells):
                    state.cells[index] = frame
                    state.seconds[index] = time.monotonic() - began
                deadline = last
            case CallFrame(index=index):
                if index < len(job.calls):
                    state.calls.setdefault(index, frame)
                deadline = last
            case Probed(held):
                state.held, state.done = held, True
            case Broken(why):
                state.ended = _("its own process failed ({why})", why=why)
            case Done(pictures):
                state.working_on, state.done = None, True
            case PictureFrame(index):
                state.pictures[index] = frame
            case _:
                assert_never(frame)
        if state.done and len(state.pictures) >= pictures:
            return


def _seconds(job: Job, limits: Limits, call: bool, index: int) -> float:
    if call:
        return job.calls[index].seconds if index < len(job.calls) else 0.0
    return limits.cell_seconds


def _kill(worker: Worker, state: WorkerState, why: str) -> None:
    worker.signal(signal.SIGKILL)
    state.ended = why
