"""Runs notebooks in isolation and brings back their answers, each worker followed with the clock in hand; the one place where foreign code runs."""

from __future__ import annotations

import base64
import signal
import threading
import time
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass, field, replace
from functools import partial
from importlib.util import find_spec
from types import TracebackType
from typing import Self, assert_never, final

import msgspec

from corollary.formula.value import Nothing, Value
from corollary.messages import N_, catalogue
from corollary.sandbox.folders import Canary, bytes_in
from corollary.sandbox.isolation import UNKNOWN, Isolation, WeakIsolation, isolation_of
from corollary.sandbox.job import (
    Axes,
    CallResult,
    CellRun,
    ExecutionResult,
    Figure,
    FunctionCall,
    Job,
    Limits,
    Status,
)
from corollary.sandbox.protocol import (
    Began,
    Broken,
    CallFrame,
    CellFrame,
    Display,
    Done,
    Error,
    Frames,
    Garbled,
    Output,
    PictureFrame,
    Probed,
    Result,
    Stream,
    send,
    to_value,
    worker_frames,
)
from corollary.sandbox.zygote import CannotStart, Worker, Zygote

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


_PNG = "image/png"
_CHANGED = N_("changed after it was shown; this is how it was at the end")
_SIGNALS = {
    "SIGSEGV": N_("a crash in compiled code (segmentation fault; very deep recursion does this too)"),
    "SIGABRT": N_("a crash in compiled code (abort)"),
    "SIGBUS": N_("a crash in compiled code (bus error)"),
    "SIGFPE": N_("a crash in compiled code (arithmetic)"),
    "SIGILL": N_("a crash in compiled code (illegal instruction)"),
    "SIGXCPU": N_("its computing time was used up"),
    "SIGSYS": N_("a system call that is not allowed"),
    "SIGKILL": N_("it was killed, most likely because it used too much memory"),
}
# Why there is no value, by the worker's word for it.
_NO_VALUE = {
    "missing": N_("there is no function called {function}"),
    "no function": N_("{function} is not a function"),
    "raised": N_("the function raised {error}"),
    "late": N_("the function ran longer than {seconds} s"),
}


def result_of(job: Job, state: WorkerState, isolation: Isolation) -> ExecutionResult:
    """All that came back of one attempt at the job."""
    trouble = _trouble(job, state)
    values: dict[str, Value] = {name: Nothing() for name in job.names}
    for index in sorted(state.cells):
        sent = state.cells[index].values
        values |= {name: to_value(encoded) for name, encoded in sent.items() if name in values}
    calls = {
        call.key: _call_result(state.calls.get(index), call, trouble, state, index)
        for index, call in enumerate(job.calls)
    }
    return ExecutionResult(
        _cell_runs(job, state),
        values,
        calls,
        _figures(job, state),
        isolation,
        trouble,
        state.machine_failed,
    )


def _trouble(job: Job, state: WorkerState) -> str:
    """One sentence on what ended the notebook early, with the place; "" when nothing did."""
    if state.done:
        return ""
    place, code = _place(job, state), state.exit_code
    if state.ended:
        return _("The notebook was ended {place}: {why}.", place=place, why=state.ended)
    if code is not None and code > 128:
        try:
            name = signal.Signals(code - 128).name
            why = _(_SIGNALS[name]) if name in _SIGNALS else name
        except ValueError:
            why = _("signal {number}", number=code - 128)
        return _("The notebook's process crashed {place}: {why}.", place=place, why=why)
    return _("The notebook's process ended itself {place}, as os._exit does.", place=place)


def _place(job: Job, state: WorkerState) -> str:
    if state.working_on is None:
        return _("before its first cell")
    index = state.working_on.index
    if state.working_on.what == "cell":
        return _("in code cell {number}", number=index + 1)
    if index < len(job.calls):
        return _("while its function {function} was called", function=job.calls[index].function)
    return _("at its end")


def _cell_runs(job: Job, state: WorkerState) -> tuple[CellRun, ...]:
    """One entry for each cell of the job, whether it ran or not."""
    runs: list[CellRun] = []
    at = state.working_on
    broken = at.index if at is not None and at.what == "cell" else None
    for index, cell in enumerate(job.cells):
        if index in state.cells:
            frame = state.cells[index]
            outputs = tuple(_output(each, state) for each in frame.outputs)
            runs.append(CellRun(cell.id, frame.status, outputs, state.seconds[index], frame.error))
        elif index == broken:
            status: Status = "timeout" if state.late else "error"
            error = (
                _("the cell ran out of time and did not stop")
                if state.late
                else _("the notebook's process ended in this cell")
            )
            runs.append(CellRun(cell.id, status, (), 0.0, error))
        else:
            runs.append(CellRun(cell.id, "not run", (), 0.0, ""))
    return tuple(runs)


def _output(output: Output, state: WorkerState) -> dict[str, object]:
    match output:
        case Display(data) | Result(data):
            return msgspec.to_builtins(output) | {"data": _with_picture(data, state)}
        case Stream() | Error():
            return msgspec.to_builtins(output)


def _with_picture(data: dict[str, str], state: WorkerState) -> dict[str, str]:
    """With the picture in place of its placeholder, where one was drawn."""
    word, place = data.get(_PNG, "").partition(" ")[::2]
    if word != "figure" or not place.isdecimal():
        return data
    rest = {mime: content for mime, content in data.items() if mime != _PNG}
    picture = state.pictures.get(int(place[:9]))
    if picture is None or picture.png is None:
        return rest
    if picture.changed and "text/plain" in rest:
        rest["text/plain"] += f" ({_(_CHANGED)})"
    return rest | {_PNG: base64.b64encode(picture.png).decode()}


def _call_result(
    frame: CallFrame | None, call: FunctionCall, trouble: str, state: WorkerState, index: int
) -> CallResult:
    if frame is not None:
        sentence = _NO_VALUE.get(frame.trouble, frame.trouble)
        values = {"function": call.function, "error": frame.error, "seconds": f"{call.seconds:g}"}
        return CallResult(to_value(frame.value), frame.output, _(sentence, **values) if sentence else "")
    here = (
        state.working_on is not None and state.working_on.what == "call" and state.working_on.index == index
    )
    if here and state.late:
        return CallResult(Nothing(), "", _("the function ran out of time and did not stop"))
    return CallResult(Nothing(), "", trouble if here else _("it was not called: {why}", why=trouble))


def _figures(job: Job, state: WorkerState) -> tuple[Figure, ...]:
    """All figures in the order of the cells that showed them."""
    return tuple(
        Figure(
            job.cells[index].id,
            tuple(_axes(each) for each in figure.axes if each is not None),
            _png(state, figure.picture),
        )
        for index in sorted(state.cells)
        for figure in state.cells[index].figures
    )


def _png(state: WorkerState, place: int | None) -> bytes | None:
    picture = state.pictures.get(place) if place is not None else None
    return picture.png if picture is not None else None


def _axes(axes: Axes) -> Axes:
    """With lines whose two rows are equally long, which a worker may have got wrong."""
    lines = tuple(replace(line, x=line.x[: len(line.y)], y=line.y[: len(line.x)]) for line in axes.lines)
    return replace(axes, lines=lines)


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
