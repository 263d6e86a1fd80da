"""Marking many submissions on the cores of this machine; each core has its own warm runner, and nobody but the caller writes."""

from __future__ import annotations

from collections.abc import Callable, Generator, Iterable, Iterator
from concurrent.futures import FIRST_COMPLETED, Future, ProcessPoolExecutor, wait
from concurrent.futures.process import BrokenProcessPool
from contextlib import AbstractContextManager, contextmanager
from itertools import islice

from corollary.grading.submission import GradingContext, Submission
from corollary.messages import speak
from corollary.nbgrader.graded import GradedSubmission, grade_submission, not_graded
from corollary.parallel import begin, cores, way_to_start
from corollary.sandbox.folders import remove_abandoned
from corollary.sandbox.runner import Runner

Execute = Callable[[GradingContext, Iterable[Submission]], AbstractContextManager[Iterator[GradedSubmission]]]
Pending = dict[Future[GradedSubmission], Submission]
AHEAD = 2  # submissions at a time for each worker: enough that none is idle, few enough to hold in memory
WORTH_A_WORKER = 6  # a warm process takes about as long to start as marking this many

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
        waiting = iter(submissions)
        pool = _pool(context, jobs)
        try:
            pending = _submit(pool, islice(waiting, AHEAD * jobs))
            yield _as_done(context, jobs, pool, pending, waiting)
        finally:
            pool.shutdown(cancel_futures=True)
            remove_abandoned()  # a process of a pool ends without a word, by ctrl-C at once: its folder is left

    return execute


def _as_done(
    context: GradingContext,
    jobs: int,
    pool: ProcessPoolExecutor,
    pending: Pending,
    waiting: Iterator[Submission],
) -> Iterator[GradedSubmission]:
    lost: list[Submission] = []
    while pending:
        for future in wait(pending, return_when=FIRST_COMPLETED).done:
            submission = pending.pop(future)
            try:
                graded = future.result()
            except BrokenProcessPool:
                lost.append(submission)
                continue
            if not lost:
                pending |= _submit(pool, islice(waiting, 1))
            yield graded
    if not lost:
        return
    # A worker died, and with it the pool: what any of them was at is done once more, alone, and the rest by a new pool.
    for submission in lost:
        yield _alone(context, submission)
    with side_by_side(jobs)(context, waiting) as rest:
        yield from rest


def _alone(context: GradingContext, submission: Submission) -> GradedSubmission:
    with _pool(context, 1) as pool:
        try:
            return pool.submit(_grade, submission).result()
        except BrokenProcessPool:
            return not_graded(context, submission, "the process that marked it died, twice")


def _pool(context: GradingContext, jobs: int) -> ProcessPoolExecutor:
    return ProcessPoolExecutor(jobs, mp_context=way_to_start(), initializer=_begin, initargs=(context,))


def _submit(pool: ProcessPoolExecutor, submissions: Iterable[Submission]) -> Pending:
    pending: Pending = {}
    for each in submissions:
        try:
            pending[pool.submit(_grade, each)] = each
        except BrokenProcessPool as error:  # then it is lost as those are that were submitted before
            failed: Future[GradedSubmission] = Future()
            failed.set_exception(error)
            pending[failed] = each
    return pending


def _begin(context: GradingContext) -> None:
    begin()
    speak(context.language)
    _at_work.append((context, context.runner()))


def _grade(submission: Submission) -> GradedSubmission:
    """In a worker. Its runner starts with the first submission, so that a failure to start is reported like any other."""
    context, runner = _at_work[0]
    return grade_submission(context, runner, submission)
