"""Runs notebooks in isolation and brings back their answers, each worker followed with the clock in hand; the one place where foreign code runs."""

from __future__ import annotations

import signal
import threading
import time
from collections.abc import Callable
from contextlib import suppress
from dataclasses import replace
from functools import partial
from importlib.util import find_spec
from types import TracebackType
from typing import Self, assert_never, final

import msgspec

from corollary.formula.value import Nothing
from corollary.messages import N_, catalogue
from corollary.sandbox.execution_result import WorkerState, result_of
from corollary.sandbox.folders import Canary, bytes_in
from corollary.sandbox.isolation import UNKNOWN, Isolation, WeakIsolation, isolation_of
from corollary.sandbox.job import (
    ExecutionResult,
    Job,
    Limits,
)
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
from corollary.sandbox.zygote import CannotStart, Worker, Zygote

_ = catalogue(__name__)

_GRACE = (
    1.0  # seconds between the interrupt and the kill: a cell that catches KeyboardInterrupt may still tidy up
)
_DISK_WATCH = 0.25  # seconds between two looks at a folder that no quota bounds


def send_job(worker: Worker, job: Job, limits: Limits, canary: Canary | None = None) -> None:
    """Hands over the job, or what to probe instead; raises OSError when the worker is gone."""
    message = {
        "cells": [cell.source for cell in job.cells],
        "again": [cell.again for cell in job.cells],
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
                    state.late = True
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
            case CellFrame(index=index, again=True):
                if index in state.cells and job.cells[index].again:
                    state.again.setdefault(index, frame)
                deadline = last
            case CellFrame(index=index):
                if index not in state.cells and index < len(job.cells):
                    state.cells[index] = frame
                    state.seconds[index] = time.monotonic() - began
                deadline = last
            case CallFrame(index=index):
                if index < len(job.calls):
                    known = state.again_calls if frame.again else state.calls
                    known.setdefault(index, frame)
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


MOST_RERUNS = 3  # after so many more deaths a notebook is taken as it is
_AGAIN = N_("The rest was run again without it.")

Attempt = Callable[[Job], tuple[WorkerState, ExecutionResult]]


def run_with_reruns(job: Job, attempt: Attempt, seconds: float) -> ExecutionResult:
    """The result of the job, put together from as many attempts as its crashes take; none is begun after `seconds`."""
    began = time.monotonic()
    state, result = attempt(job)
    rest: Job | None = job
    for _ in range(MOST_RERUNS):
        rest = _without_culprit(rest, state)
        if rest is None or result.machine_failed or time.monotonic() - began > seconds:
            break
        state, later = attempt(rest)
        result = _together(job, result, rest, later)
    return result


def _without_culprit(job: Job, state: WorkerState) -> Job | None:
    """The job without the cell, or the function, that its process died in; None when it lived, or none can be named."""
    at = state.working_on
    if state.done or at is None:
        return None
    if at.what == "cell" and at.index < len(job.cells) and at.index not in state.cells:
        empty = replace(job.cells[at.index], source="")
        return replace(job, cells=(*job.cells[: at.index], empty, *job.cells[at.index + 1 :]))
    if at.what == "again" and at.index < len(job.cells):
        once = replace(job.cells[at.index], again=False)
        return replace(job, cells=(*job.cells[: at.index], once, *job.cells[at.index + 1 :]))
    if at.what == "call" and at.index < len(job.calls) and at.index not in state.calls:
        function = job.calls[at.index].function
        return replace(job, calls=tuple(call for call in job.calls if call.function != function))
    return None


def _together(job: Job, result: ExecutionResult, rest: Job, later: ExecutionResult) -> ExecutionResult:
    """What the run of the rest gave, with what is known already of all that was left out of it."""
    left_out = [
        cell.source != remaining.source for cell, remaining in zip(job.cells, rest.cells, strict=True)
    ]
    cells = tuple(
        known if out else run for known, run, out in zip(result.cells, later.cells, left_out, strict=True)
    )
    values = {
        name: result.values[name] if isinstance(value, Nothing) else value
        for name, value in later.values.items()
    }
    trouble = " ".join(filter(None, (result.trouble, _(_AGAIN), later.trouble)))
    return replace(later, cells=cells, values=values, calls=result.calls | later.calls, trouble=trouble)


_NO_JOB = Job((), ())

NOT_HERE = (
    "notebooks and programs are run on Linux and macOS only: everything else works on Windows, "
    "and grading does in WSL or in a container (docs/howto/grade_on_windows.md)"
)


def probe_isolation(require: int = 0) -> Isolation:
    """How well notebooks are isolated here, before any is run. Raises WeakIsolation below `require`, and CannotStart."""
    runner = Runner(require=require)
    runner._probe_only = True  # pyright: ignore[reportPrivateUsage]
    with runner:
        return runner.isolation


@final
class Runner:
    """Runs notebooks one after another, each in a fork of one zygote; for several at once use several.

    `require` is the least isolation level accepted: entering raises WeakIsolation below it, and CannotStart when nothing
    can be run at all. `without` leaves out layers or libraries by name, to measure what they are worth. `packages` are modules
    that notebooks are likely to import: they are imported once, before the first. `execute` is safe to call from several
    threads; they wait for one another.
    """

    def __init__(
        self,
        limits: Limits | None = None,
        require: int = 0,
        without: frozenset[str] = frozenset(),
        packages: tuple[str, ...] = (),
    ) -> None:
        self.packages = packages
        self.limits = limits or Limits()
        self.require = require
        self.without = without
        self.isolation: Isolation = UNKNOWN
        self._probe_only = False
        self._zygote: Zygote | None = None
        self._lock = threading.Lock()

    def __enter__(self) -> Self:
        with self._lock:
            self._started()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        with self._lock:
            self._stop()

    @property
    def kilobytes(self) -> int:
        """Memory the zygote takes."""
        return self._zygote.ready.kilobytes if self._zygote else 0

    def execute(self, job: Job) -> ExecutionResult:
        """Runs the job; whatever it does, the result says so and the next one runs. Raises CannotStart and WeakIsolation only.

        Where its process dies, the job is run again without the cell or the function that it died in; where the machine
        fails, it is run once more as it is, and if that fails too the result says so.
        """
        with self._lock:
            return run_with_reruns(job, self._attempt, self.limits.total_seconds)

    def _attempt(self, job: Job) -> tuple[WorkerState, ExecutionResult]:
        state = self._run(job)
        if state.machine_failed:
            state = self._run(job)
        return state, result_of(job, state, self.isolation)

    def _started(self) -> Zygote:
        if self._zygote is not None and not self._zygote.running:
            self._stop()
        if find_spec("fcntl") is None:
            raise CannotStart(NOT_HERE)
        if self._zygote is None:
            self._zygote = self._new_zygote()
            probed = self._probe(self._zygote)
            self.isolation = isolation_of(probed.held, self._zygote.missing)
            if self.isolation.level < self.require:
                self._stop()
                raise WeakIsolation(self.isolation, self.require)
        return self._zygote

    def _new_zygote(self) -> Zygote:
        """Without the declared packages where one of them starts threads: after a fork their locks would stay held. Raises
        CannotStart."""
        if self.packages:
            zygote = Zygote(self.limits, self.without, self._probe_only, self.packages)
            if zygote.ready.threads <= 1:
                return zygote
            zygote.stop()
        return Zygote(self.limits, self.without, self._probe_only)

    def _probe(self, zygote: Zygote) -> WorkerState:
        """What holds, tried in a worker. Raises CannotStart where not even that can be run."""
        state = WorkerState()
        try:
            self._give(zygote, zygote.fork(), _NO_JOB, state, zygote.canary())
        except OSError as error:
            state.ended = str(error)
        if not state.done:
            self._stop()
            raise CannotStart(f"The process that runs notebooks cannot run any: {state.ended or 'it died'}.")
        return state

    def _stop(self) -> None:
        if self._zygote is not None:
            self._zygote.stop()
            self._zygote = None

    def _run(self, job: Job) -> WorkerState:
        """One run of the job. The machine has failed where its process could not be reached, or died before the first cell."""
        state = WorkerState()
        self._started()
        try:
            zygote, worker = self._fork()
            self._give(zygote, worker, job, state)
        except OSError as error:
            self._stop()
            state.ended = f"the process that runs notebooks failed ({error})"
            state.machine_failed = True
        if not (state.started or state.done):
            state.machine_failed = True
        return state

    def _fork(self) -> tuple[Zygote, Worker]:
        zygote = self._started()
        waited = zygote.worker_waits
        try:
            return zygote, zygote.fork()
        except OSError:
            if not waited:
                raise
        # One that was forked ahead of its job and died while it waited is no submission's fault.
        self._stop()
        zygote = self._started()
        return zygote, zygote.fork()

    def _give(
        self, zygote: Zygote, worker: Worker, job: Job, state: WorkerState, canary: Canary | None = None
    ) -> None:
        own_disk = zygote.ready.namespaces
        try:
            send_job(worker, job, self.limits, canary)
            follow(worker, job, self.limits, state, None if own_disk else partial(bytes_in, zygote.folder))
            # How it ended matters only when it was not done; else the next job need not wait for its end.
            if not (state.done or state.ended):
                state.exit_code = zygote.reap()
        finally:
            worker.release()
        if own_disk:  # else it would write into the folder of the one that ends just now
            with suppress(OSError):  # a zygote that is gone is noticed at the next job
                zygote.ask()
