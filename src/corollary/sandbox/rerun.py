"""A notebook whose process died is run again without the cell or function it died in, so that the answers around it count."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import replace

from corollary.formula.value import Nothing
from corollary.messages import N_, catalogue
from corollary.sandbox.job import Job
from corollary.sandbox.result import ExecutionResult
from corollary.sandbox.session import WorkerState

_ = catalogue(__name__)

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
