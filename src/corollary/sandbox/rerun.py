"""A notebook whose process died is run again without what killed it, so that the answers around it still count."""

from __future__ import annotations

from dataclasses import replace

from corollary.formula.value import Nothing
from corollary.sandbox.job import Job
from corollary.sandbox.result import ExecutionResult
from corollary.sandbox.session import WorkerState

MOST = 3  # deaths after which a notebook is taken as it stands
AGAIN = "The rest was run again without it."


def rest_of(job: Job, told: WorkerState) -> Job | None:
    """The job without the cell, or the function, in which the process died; None when it lived, or nothing is to blame."""
    at = told.working_on
    if told.done or at is None:
        return None
    if at.what == "cell" and at.index < len(job.cells) and at.index not in told.cells:
        empty = replace(job.cells[at.index], source="")
        return replace(job, cells=(*job.cells[: at.index], empty, *job.cells[at.index + 1 :]))
    if at.what == "call" and at.index < len(job.asks) and at.index not in told.calls:
        function = job.asks[at.index].function
        return replace(job, asks=tuple(ask for ask in job.asks if ask.function != function))
    return None


def together(job: Job, taken: ExecutionResult, rest: Job, later: ExecutionResult) -> ExecutionResult:
    """What the run of the rest gave, with what is known already of all that was left out of the job."""
    left_out = [cell.source != kept.source for cell, kept in zip(job.cells, rest.cells, strict=True)]
    cells = tuple(
        known if out else run for known, run, out in zip(taken.cells, later.cells, left_out, strict=True)
    )
    values = {
        name: taken.values[name] if isinstance(value, Nothing) else value
        for name, value in later.values.items()
    }
    trouble = " ".join(filter(None, (taken.trouble, AGAIN, later.trouble)))
    return replace(later, cells=cells, values=values, calls=taken.calls | later.calls, trouble=trouble)
