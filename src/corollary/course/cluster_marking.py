"""Marking on more than one machine: a Dask cluster that is there already; each of its processes has its own warm runner."""

# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false

from __future__ import annotations

import atexit
import os
from collections.abc import Generator, Iterable, Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from itertools import islice
from threading import Lock
from typing import TYPE_CHECKING, Any

from corollary.cluster import NoCluster, connect, worker_count
from corollary.course.workers import AHEAD, Execute
from corollary.grading.submission import GradingContext, Submission, state_of
from corollary.messages import speak
from corollary.nbgrader.graded import GradedSubmission, grade_submission, not_graded
from corollary.sandbox.runner import Runner

if TYPE_CHECKING:
    from distributed import Client

# Of a worker process: what it marks with, under the token of the grading.
_at_work: dict[str, tuple[GradingContext, Runner]] = {}
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
            yield _as_done(client, sent, iter(submissions))
        finally:
            with suppress(Exception):  # a cluster that is lost has no workers left to stop
                client.run(leave)
            client.close()

    return execute


def mark_there(sent: Sent, submission: Submission) -> GradedSubmission:
    """In a worker. The solutions are found and the runner starts with the first submission of a grading."""
    with _one_at_a_time:
        if sent.token not in _at_work:
            _leave()
            speak(sent.context.language)
            if state_of(sent.context.problem_set, sent.context.solutions) != sent.state:
                raise NoCluster(
                    "a worker has another version of the program or of the solutions; put the same ones everywhere"
                )
            _at_work[sent.token] = sent.context, sent.context.runner()
            # Whoever sent it may be gone when the worker ends, and the runner has a temporary folder.
            atexit.register(_leave)
        context, runner = _at_work[sent.token]
        return grade_submission(context, runner, submission)


def leave() -> None:
    """In a worker, at the end: its warm runner ends."""
    with _one_at_a_time:
        _leave()


def _leave() -> None:
    while _at_work:
        _, runner = _at_work.popitem()[1]
        runner.__exit__(None, None, None)


def _as_done(client: Client, sent: Sent, waiting: Iterator[Submission]) -> Iterator[GradedSubmission]:
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
                yield not_graded(
                    sent.context, submission, "the workers that marked it died, one after another"
                )
            case _, None:
                raise NoCluster(
                    "the cluster was lost on the way; grade again: what is marked stays, and the rest is done then"
                )
            case _, error:
                raise error
