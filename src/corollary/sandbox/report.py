"""What a child told, put into the words of a submission; what it did not get to tell is said too."""

from __future__ import annotations

import base64
import signal
from dataclasses import replace

import msgspec

from corollary.formula.value import Nothing
from corollary.sandbox.decode import plain
from corollary.sandbox.job import Job
from corollary.sandbox.protocol import CallTold, Display, Error, Output, Result, Stream
from corollary.sandbox.result import Answered, Axes, CellRun, Figure, Status
from corollary.sandbox.session import WorkerState

PNG = "image/png"
CHANGED = " (changed after it was shown; this is how it was at the end)"
_SIGNALS = {
    signal.SIGSEGV: "a crash in compiled code (segmentation fault; very deep recursion does this too)",
    signal.SIGABRT: "a crash in compiled code (abort)",
    signal.SIGBUS: "a crash in compiled code (bus error)",
    signal.SIGFPE: "a crash in compiled code (arithmetic)",
    signal.SIGILL: "a crash in compiled code (illegal instruction)",
    signal.SIGXCPU: "its computing time was used up",
    signal.SIGSYS: "a system call that is not allowed",
    signal.SIGKILL: "it was killed, most likely for want of memory",
}


def trouble_of(job: Job, told: WorkerState, code: int | None) -> str:
    """One sentence on what ended the notebook early, with the place; "" when nothing did."""
    if told.done:
        return ""
    place = _place(job, told)
    if told.ended:
        return f"The notebook was ended {place}: {told.ended}."
    if code is not None and code > 128:
        try:
            number = signal.Signals(code - 128)
        except ValueError:
            return f"The notebook's process died {place}: signal {code - 128}."
        return f"The notebook's process died {place}: {_SIGNALS.get(number, number.name)}."
    return f"The notebook's process ended itself {place}, as os._exit does."


def _place(job: Job, told: WorkerState) -> str:
    if told.working_on is None:
        return "before its first cell"
    index = told.working_on.index
    if told.working_on.what == "cell":
        return f"in code cell {index + 1}"
    return (
        f"while its function {job.asks[index].function} was called" if index < len(job.asks) else "at its end"
    )


def cell_runs(job: Job, told: WorkerState) -> tuple[CellRun, ...]:
    """One entry for each cell of the job, whether it ran or not."""
    runs = []
    broken = told.working_on.index if told.working_on is not None and told.working_on.what == "cell" else None
    for index, cell in enumerate(job.cells):
        if index in told.cells:
            frame = told.cells[index]
            outputs = tuple(_output(each, told) for each in frame.outputs)
            runs.append(CellRun(cell.id, frame.status, outputs, told.seconds[index], frame.error))
        elif index == broken:
            status: Status = "timeout" if told.late else "error"
            error = (
                "the cell ran out of time and did not stop"
                if told.late
                else "the notebook's process ended in this cell"
            )
            runs.append(CellRun(cell.id, status, (), 0.0, error))
        else:
            runs.append(CellRun(cell.id, "not run", (), 0.0, ""))
    return tuple(runs)


def _output(output: Output, told: WorkerState) -> dict[str, object]:
    match output:
        case Display(data) | Result(data):
            return msgspec.to_builtins(output) | {"data": _with_picture(data, told)}
        case Stream() | Error():
            return msgspec.to_builtins(output)


def _with_picture(data: dict[str, str], told: WorkerState) -> dict[str, str]:
    """With the picture in the place that was kept for it, where one was drawn."""
    word, _, place = data.get(PNG, "").partition(" ")
    if word != "figure" or not place.isdecimal():
        return data
    rest = {mime: content for mime, content in data.items() if mime != PNG}
    picture = told.pictures.get(int(place[:9]))
    if picture is None or picture.png is None:
        return rest
    if picture.changed and "text/plain" in rest:
        rest["text/plain"] += CHANGED
    return rest | {PNG: base64.b64encode(picture.png).decode()}


def answered(told_call: CallTold | None, trouble: str, told: WorkerState, index: int) -> Answered:
    if told_call is not None:
        return Answered(plain(told_call.value), told_call.output, told_call.trouble)
    here = told.working_on is not None and told.working_on.what == "call" and told.working_on.index == index
    if here and told.late:
        return Answered(Nothing(), "", "the function ran out of time and did not stop")
    return Answered(Nothing(), "", trouble if here else f"it was not called: {trouble}")


def figures_of(job: Job, told: WorkerState) -> tuple[Figure, ...]:
    """All figures in the order of the cells that showed them."""
    return tuple(
        Figure(
            job.cells[index].id,
            tuple(_axes(each) for each in figure.axes if each is not None),
            _png(told, figure.picture),
        )
        for index in sorted(told.cells)
        for figure in told.cells[index].figures
    )


def _png(told: WorkerState, place: int | None) -> bytes | None:
    picture = told.pictures.get(place) if place is not None else None
    return picture.png if picture is not None else None


def _axes(told: Axes) -> Axes:
    """With lines whose two rows are equally long, which a child may have got wrong."""
    return replace(
        told,
        lines=tuple(replace(line, x=line.x[: len(line.y)], y=line.y[: len(line.x)]) for line in told.lines),
    )
