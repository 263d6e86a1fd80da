"""The result of a job, put together from the frames that its worker sent."""

from __future__ import annotations

import base64
import signal
from dataclasses import dataclass, field, replace
from typing import final

import msgspec

from corollary.formula.value import Nothing, Value
from corollary.messages import N_, catalogue
from corollary.sandbox.isolation import Isolation
from corollary.sandbox.job import (
    Axes,
    CallResult,
    CellRun,
    ExecutionResult,
    Figure,
    FunctionCall,
    Job,
    Status,
)
from corollary.sandbox.protocol import (
    Began,
    CallFrame,
    CellFrame,
    Display,
    Error,
    Output,
    PictureFrame,
    Result,
    Stream,
    to_value,
)

_ = catalogue(__name__)


@final
@dataclass(slots=True)
class WorkerState:
    """All that a worker has sent, by the index of the cell, call or picture; `again` and `again_calls` of the second time that one
    was run; `ended` is "" or why it was ended early.

    `working_on` is what it began last, while that is not finished; `late` says that its time was up.
    """

    cells: dict[int, CellFrame] = field(default_factory=dict[int, CellFrame])
    calls: dict[int, CallFrame] = field(default_factory=dict[int, CallFrame])
    again: dict[int, CellFrame] = field(default_factory=dict[int, CellFrame])
    again_calls: dict[int, CallFrame] = field(default_factory=dict[int, CallFrame])
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
    "raised": N_("the function stopped with an error ({error})"),
    "late": N_("the function ran longer than {seconds} s"),
}


def result_of(job: Job, state: WorkerState, isolation: Isolation) -> ExecutionResult:
    """All that came back of one attempt at the job."""
    trouble = _trouble(job, state)
    values: dict[str, Value] = {name: Nothing() for name in job.names}
    by: dict[str, int] = {}  # the cell that gave each value last
    for index in sorted(state.cells):
        sent = state.cells[index].values
        values |= {name: to_value(encoded) for name, encoded in sent.items() if name in values}
        by |= dict.fromkeys(sent, index)
    without = {name for name, value in values.items() if isinstance(value, Nothing)}
    again: dict[int, dict[str, Value]] = {}
    for index, frame in state.again.items():  # in the order in which they were run
        if frame.status == "ok":
            # What a cell below it gave stays; what it gave itself before it stopped was not its last word.
            free = without | {name for name in values if by.get(name) == index}
            again[index] = {name: to_value(sent) for name, sent in frame.values.items() if name in free}
            without -= again[index].keys()
    calls = {
        call.key: _call_result(
            state.again_calls.get(index, state.calls.get(index)), call, trouble, state, index
        )
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
        again,
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
    if state.working_on.what in {"cell", "again"}:
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
            frame = _better(state, index)
            outputs = tuple(_output(each, state) for each in _spoken(frame))
            runs.append(CellRun(cell.id, frame.status, outputs, state.seconds[index], frame.error))
        elif index == broken:
            killed = state.exit_code == 128 + signal.SIGKILL
            status: Status = "timeout" if state.late else "killed" if killed else "ended"
            error = (
                _("the cell ran out of time and did not stop")
                if state.late
                else state.ended or _("the notebook's process ended in this cell")
            )
            runs.append(CellRun(cell.id, status, (), 0.0, error))
        else:
            runs.append(CellRun(cell.id, "not run", (), 0.0, ""))
    return tuple(runs)


def _spoken(frame: CellFrame) -> list[Output]:
    """The outputs of a cell; of one that ran too long without the interrupt that ended it."""
    if frame.status != "timeout":
        return frame.outputs
    outputs: list[Output] = [each for each in frame.outputs if not isinstance(each, Error)]
    return [*outputs, Stream("stderr", _("This cell ran too long and was stopped.") + "\n")]


def _better(state: WorkerState, index: int) -> CellFrame:
    """Of a cell that was run twice the second time, where it went well."""
    frame = state.again.get(index)
    return frame if frame is not None and frame.status == "ok" else state.cells[index]


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
        words = frame.error.partition(": ")[2] or _("an error without a message")
        values = {"function": call.function, "error": words, "seconds": f"{call.seconds:g}"}
        trouble = _(sentence, **values) if sentence else ""
        return CallResult(to_value(frame.value), frame.output, trouble, frame.error)
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
        for figure in _better(state, index).figures
    )


def _png(state: WorkerState, place: int | None) -> bytes | None:
    picture = state.pictures.get(place) if place is not None else None
    return picture.png if picture is not None else None


def _axes(axes: Axes) -> Axes:
    """With lines whose two rows are equally long, which a worker may have got wrong."""
    lines = tuple(replace(line, x=line.x[: len(line.y)], y=line.y[: len(line.x)]) for line in axes.lines)
    return replace(axes, lines=lines)
