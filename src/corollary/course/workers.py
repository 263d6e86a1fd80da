"""Marking many submissions on the cores of this machine; each core has its own warm runner, and nobody but the caller writes."""

from __future__ import annotations

from collections.abc import Callable, Generator, Iterable, Iterator
from concurrent.futures import FIRST_COMPLETED, wait
from contextlib import AbstractContextManager, contextmanager
from itertools import islice

from corollary.grading.submission import GradingContext, Submission
from corollary.guard import ends_after
from corollary.messages import speak
from corollary.nbgrader.graded import GradedSubmission, grade_submission, not_graded
from corollary.parallel import ProcessDied, Workers, cores
from corollary.sandbox.folders import remove_abandoned
from corollary.sandbox.runner import Runner

Execute = Callable[[GradingContext, Iterable[Submission]], AbstractContextManager[Iterator[GradedSubmission]]]
AHEAD = 2  # submissions at a time for each worker: enough that none is idle, few enough to hold in memory
WORTH_A_WORKER = 6  # a warm process takes about as long to start as marking this many
LONGEST = 150.0  # seconds of the processor; marking and writing a page stop themselves before, unless inside a library

_at_work: list[tuple[GradingContext, Runner]] = []  # of a worker process: what it marks with


def here(jobs: int | None, count: int) -> Execute:
    """For so many submissions, in at most so many processes (None: one for each core); few are marked in this very process."""
    most = min(jobs, count) if jobs is not None else min(cores(), -(-count // WORTH_A_WORKER))
    return side_by_side(most) if most > 1 else in_turn


@contextmanager
def in_turn(
    context: GradingContext, submissions: Iterable[Submission]
) -> Generator[Iterator[GradedSubmission]]:
    """One after the other, in this process."""
    with context.runner() as runner:
        yield (grade_submission(context, runner, each) for each in submissions)


def side_by_side(jobs: int) -> Execute:
    """In so many processes, as they get done."""

    @contextmanager
    def execute(
        context: GradingContext, submissions: Iterable[Submission]
    ) -> Generator[Iterator[GradedSubmission]]:
        done = _as_done(context, jobs, iter(submissions))
        try:
            yield done
        finally:
            done.close()
            remove_abandoned()  # a process ends without a word, by ctrl-C at once: its folder is left

    return execute


def _as_done(
    context: GradingContext, jobs: int, waiting: Iterator[Submission]
) -> Generator[GradedSubmission]:
    while begun := list(islice(waiting, AHEAD * jobs)):
        lost: list[Submission] = []
        with _processes(context, jobs) as processes:
            pending = {processes.submit(_grade, each): each for each in begun}
            while pending:
                for future in wait(pending, return_when=FIRST_COMPLETED).done:
                    submission = pending.pop(future)
                    try:
                        graded = future.result()
                    except ProcessDied:
                        lost.append(submission)
                        continue
                    if not lost:
                        pending |= {processes.submit(_grade, each): each for each in islice(waiting, 1)}
                    yield graded
        # A process died: what it was at is done once more, alone, and the rest by as many processes as before.
        for submission in lost:
            yield _alone(context, submission)


def _alone(context: GradingContext, submission: Submission) -> GradedSubmission:
    with _processes(context, 1) as process:
        try:
            return process.submit(_grade, submission).result()
        except ProcessDied:
            return not_graded(context, submission, "the process that marked it died, twice")


def _processes(context: GradingContext, count: int) -> Workers:
    return Workers(count, _begin, context)


def _begin(context: GradingContext) -> None:
    speak(context.language)
    _at_work.append((context, context.runner()))


def _grade(submission: Submission) -> GradedSubmission:
    """In a worker. Its runner starts with the first submission, so that a failure to start is reported like any other."""
    context, runner = _at_work[0]
    with ends_after(LONGEST):
        return grade_submission(context, runner, submission)
