"""Taking a submission: run a notebook in isolation and bring back its answers; the one place where foreign code runs."""

from __future__ import annotations

import threading
import time
from contextlib import suppress
from types import TracebackType
from typing import Self, final

from corollary.formula.value import Nothing, Value
from corollary.sandbox.decode import plain
from corollary.sandbox.isolation import UNKNOWN, WeakIsolation, isolation_of
from corollary.sandbox.job import Ask, Cell, Job, Limits
from corollary.sandbox.report import answered, cell_runs, figures_of, trouble_of
from corollary.sandbox.rerun import MOST, rest_of, together
from corollary.sandbox.result import Answered, Axes, CellRun, ExecutionResult, Figure, Isolation, Line
from corollary.sandbox.session import Watch, WorkerState, follow, give
from corollary.sandbox.zygote import Child, Parent, ask, fork, leave, reap, start, stop

__all__ = [
    "Answered",
    "Ask",
    "Axes",
    "Cell",
    "CellRun",
    "ExecutionResult",
    "Figure",
    "Isolation",
    "Job",
    "Limits",
    "Line",
    "Runner",
    "WeakIsolation",
]

_NO_JOB = Job((), ())


@final
class Runner:
    """Runs notebooks one after another, each in a fork of one warm parent; for several at once use several.

    `require` is the least isolation level accepted: entering raises WeakIsolation below it, and CannotStart when nothing
    can be run at all. `without` leaves out walls by name, to measure their cost. `take` is safe to call from several threads;
    they wait for one another.
    """

    def __init__(
        self, limits: Limits | None = None, require: int = 0, without: frozenset[str] = frozenset()
    ) -> None:
        self.limits = limits or Limits()
        self.require = require
        self.without = without
        self.isolation: Isolation = UNKNOWN
        self._parent: Parent | None = None
        self._lock = threading.Lock()

    def __enter__(self) -> Self:
        self._warm()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        with self._lock:
            self._cool()

    @property
    def kilobytes(self) -> int:
        """Memory the warm parent takes."""
        return self._parent.kilobytes if self._parent else 0

    def take(self, job: Job) -> ExecutionResult:
        """Runs the job; whatever it does, the result says so and the next one runs. Raises CannotStart only.

        Where its process dies, the job is run again without the cell or the function that it died in.
        """
        with self._lock:
            began = time.monotonic()
            told, code = self._run(job)
            if not (
                told.done or told.working_on
            ):  # it died before anything of the notebook ran: not the notebook's doing
                told, code = self._run(job)
            taken = self._taken(job, told, code)
            rest: Job | None = job
            for _ in range(MOST):
                rest = rest_of(rest, told)
                if rest is None or time.monotonic() - began > self.limits.total_seconds:
                    break
                told, code = self._run(rest)
                taken = together(job, taken, rest, self._taken(rest, told, code))
            return taken

    def _warm(self) -> Parent:
        if self._parent is None:
            self._parent = start(self.limits, self.without)
            told, _ = self._run(_NO_JOB, trial=True)
            if self._parent is None:
                self._parent = start(self.limits, self.without)
            self.isolation = isolation_of(told.trial, self._parent.missing)
            if self.isolation.level < self.require:
                self._cool()
                raise WeakIsolation(self.isolation, self.require)
        return self._parent

    def _cool(self) -> None:
        if self._parent is not None:
            stop(self._parent)
            self._parent = None

    def _run(self, job: Job, trial: bool = False) -> tuple[WorkerState, int | None]:
        told = WorkerState()
        try:
            parent, child = self._child()
            watch = Watch() if parent.namespaces else Watch(0.25, str(parent.folder), self.limits.file_bytes)
            try:
                give(child, job, self.limits, trial)
                follow(child, job, self.limits, watch, told)
                # How it ended matters only when it did not say that it was done; else the next job need not wait for it.
                code = None if told.done or told.ended else reap(parent)
            finally:
                leave(child)
            if parent.namespaces:  # else it would share the folder of the one that ends just now
                with suppress(OSError):  # a parent that is gone is met at the next job
                    ask(parent)
            return told, code
        except OSError as error:
            # The machine's failing, or a notebook that got at the parent: start afresh for the next one.
            self._cool()
            told.ended = f"the process that runs notebooks failed ({error})"
            return told, None

    def _child(self) -> tuple[Parent, Child]:
        """A child that waits for its job. One that got ready early and died while it waited is no submission's fault."""
        if self._parent is not None and self._parent.process.poll() is not None:
            self._cool()
        parent = self._parent or self._warm()
        waited = parent.coming is not None
        try:
            return parent, fork(parent)
        except OSError:
            if not waited:
                raise
            self._cool()
            parent = self._warm()
            return parent, fork(parent)

    def _taken(self, job: Job, told: WorkerState, code: int | None) -> ExecutionResult:
        trouble = trouble_of(job, told, code)
        values: dict[str, Value] = {name: Nothing() for name in job.names}
        for index in sorted(told.cells):
            values |= {name: plain(sent) for name, sent in told.cells[index].values.items() if name in values}
        calls = {
            ask.key: answered(told.calls.get(index), trouble, told, index)
            for index, ask in enumerate(job.asks)
        }
        return ExecutionResult(
            cell_runs(job, told), values, calls, figures_of(job, told), self.isolation, trouble
        )
