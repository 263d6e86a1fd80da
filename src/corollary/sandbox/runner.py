"""Runs notebooks in isolation and brings back their answers; the one place where foreign code runs."""

from __future__ import annotations

import threading
from contextlib import suppress
from functools import partial
from importlib.util import find_spec
from types import TracebackType
from typing import Self, final

from corollary.sandbox.folders import Canary, bytes_in
from corollary.sandbox.isolation import UNKNOWN, Isolation, WeakIsolation, isolation_of
from corollary.sandbox.job import Job, Limits
from corollary.sandbox.report import result_of
from corollary.sandbox.rerun import run_with_reruns
from corollary.sandbox.result import ExecutionResult
from corollary.sandbox.session import WorkerState, follow, send_job
from corollary.sandbox.zygote import CannotStart, Worker, Zygote

_NO_JOB = Job((), ())

NOT_HERE = (
    "notebooks and programs are run on Linux and macOS only: everything else works on Windows, "
    "and grading does in WSL or in a container (docs/instructor.md, Windows)"
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
    can be run at all. `without` leaves out layers or libraries by name, to measure what they are worth. `execute` is safe to call from several
    threads; they wait for one another.
    """

    def __init__(
        self, limits: Limits | None = None, require: int = 0, without: frozenset[str] = frozenset()
    ) -> None:
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
            self._zygote = Zygote(self.limits, self.without, self._probe_only)
            probed = self._probe(self._zygote)
            self.isolation = isolation_of(probed.held, self._zygote.missing)
            if self.isolation.level < self.require:
                self._stop()
                raise WeakIsolation(self.isolation, self.require)
        return self._zygote

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
