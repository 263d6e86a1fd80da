"""Marking many submissions on the cores of this machine or on a Dask cluster; each process has a warm runner."""

# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false

from __future__ import annotations

import atexit
import os
from collections.abc import Callable, Generator, Iterable, Iterator
from concurrent.futures import FIRST_COMPLETED, wait
from contextlib import AbstractContextManager, contextmanager, suppress
from dataclasses import dataclass
from itertools import islice
from threading import Lock
from typing import TYPE_CHECKING, Any

from corollary.grading.submission import GradingContext, Submission, state_of
from corollary.guard import ends_after
from corollary.messages import speak
from corollary.nbgrader.graded import GradedSubmission, grade_submission, not_graded
from corollary.parallel import NoCluster, ProcessDied, Workers, connect, cores, worker_count
from corollary.sandbox.folders import remove_abandoned
from corollary.sandbox.runner import Runner

if TYPE_CHECKING:
    from distributed import Client

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
            return not_graded(context, submission, "the marking process died twice on this submission")


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


# Of a worker process: what it marks with, under the token of the grading.
_marking_there: dict[str, tuple[GradingContext, Runner]] = {}
_one_at_a_time = Lock()  # a worker may have several threads; the judge's arithmetic is for one


@dataclass(frozen=True, slots=True)
class Sent:
    """A grading on its way: `token` tells it from the one before, `state` its program and solutions."""

    context: GradingContext
    token: str
    state: str


def on_cluster(address: str) -> Execute:
    """On the cluster whose scheduler is at this address; what a dying worker was at is done again by another.

    Entering raises NoCluster where there is none, and so does going on once it is lost.
    """

    @contextmanager
    def execute(
        context: GradingContext, submissions: Iterable[Submission]
    ) -> Generator[Iterator[GradedSubmission]]:
        client = connect(address)
        try:
            sent = Sent(context, os.urandom(8).hex(), state_of(context.problem_set, context.solutions))
            yield _done_there(client, sent, iter(submissions))
        finally:
            with suppress(Exception):  # a cluster that is lost has no workers left to stop
                client.run(leave)
            client.close()

    return execute


def mark_there(sent: Sent, submission: Submission) -> GradedSubmission:
    """In a worker. The solutions are found and the runner starts with the first submission of a grading."""
    with _one_at_a_time:
        if sent.token not in _marking_there:
            _leave()
            speak(sent.context.language)
            if state_of(sent.context.problem_set, sent.context.solutions) != sent.state:
                raise NoCluster(
                    "a worker has another version of corollary or of the solutions; install the same version on all workers"
                )
            _marking_there[sent.token] = sent.context, sent.context.runner()
            # Whoever sent it may be gone when the worker ends, and the runner has a temporary folder.
            atexit.register(_leave)
        context, runner = _marking_there[sent.token]
        return grade_submission(context, runner, submission)


def leave() -> None:
    """In a worker, at the end: its warm runner ends."""
    with _one_at_a_time:
        _leave()


def _leave() -> None:
    while _marking_there:
        _, runner = _marking_there.popitem()[1]
        runner.__exit__(None, None, None)


def _done_there(client: Client, sent: Sent, waiting: Iterator[Submission]) -> Iterator[GradedSubmission]:
    from distributed import KilledWorker, as_completed

    def submit(submission: Submission) -> Any:
        future = client.submit(mark_there, sent, submission, pure=False)
        pending[future.key] = submission
        return future

    pending: dict[Any, Submission] = {}
    ahead = AHEAD * max(1, worker_count(client))  # all of them may be being replaced just now
    done = as_completed([submit(each) for each in islice(waiting, ahead)])
    for future in done:
        submission = pending.pop(future.key)
        for another in islice(waiting, 1):
            done.add(submit(another))
        match future.status, future.exception() if future.status == "error" else None:
            case "finished", _:
                yield future.result()
            case _, KilledWorker():
                yield not_graded(sent.context, submission, "every worker that marked this submission died")
            case _, None:
                raise NoCluster(
                    "the connection to the cluster was lost; grade again: finished marks stay, and only the rest is graded"
                )
            case _, error:
                raise error
