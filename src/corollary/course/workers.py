"""Marking many submissions on the cores of this machine; each core has its own warm runner, and nobody but the caller writes."""

from __future__ import annotations

import os
import signal
import sys
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import FIRST_COMPLETED, Future, ProcessPoolExecutor, wait
from concurrent.futures.process import BrokenProcessPool
from contextlib import AbstractContextManager, contextmanager
from itertools import islice
from multiprocessing import get_context, parent_process
from multiprocessing.connection import wait as wait_for
from threading import Thread

from corollary.course.submission import GradedSubmission, GradingContext, Submission, mark_one, set_aside
from corollary.sandbox.runner import Runner

Execute = Callable[[GradingContext, Iterable[Submission]], AbstractContextManager[Iterator[GradedSubmission]]]
Doing = dict[Future[GradedSubmission], Submission]
AHEAD = 2  # submissions at a time for each worker: enough that none is idle, few enough to hold in memory
WORTH_A_WORKER = 6  # a warm process takes about as long to start as marking this many

_at_work: list[tuple[GradingContext, Runner]] = []  # of a worker process: what it marks with


def cores() -> int:
    """How many this program may use."""
    return len(os.sched_getaffinity(0)) if sys.platform == "linux" else os.cpu_count() or 1


def here(jobs: int | None, count: int) -> Execute:
    """For so many submissions, in at most so many processes (None: one for each core); few are marked in this very process."""
    most = min(jobs, count) if jobs is not None else min(cores(), -(-count // WORTH_A_WORKER))
    return side_by_side(most) if most > 1 else in_turn


@contextmanager
def in_turn(order: GradingContext, submissions: Iterable[Submission]) -> Iterator[Iterator[GradedSubmission]]:
    """One after the other, in this process."""
    with order.runner() as runner:
        yield (mark_one(order, runner, each) for each in submissions)


def side_by_side(jobs: int) -> Execute:
    """In so many processes, as they get done."""

    @contextmanager
    def execute(
        order: GradingContext, submissions: Iterable[Submission]
    ) -> Iterator[Iterator[GradedSubmission]]:
        left = iter(submissions)
        crew = _crew(order, jobs)
        try:
            doing = _give(crew, islice(left, AHEAD * jobs))
            yield _as_done(order, jobs, crew, doing, left)
        finally:
            crew.shutdown(cancel_futures=True)

    return execute


def _as_done(
    order: GradingContext, jobs: int, crew: ProcessPoolExecutor, doing: Doing, left: Iterator[Submission]
) -> Iterator[GradedSubmission]:
    lost: list[Submission] = []
    while doing:
        for future in wait(doing, return_when=FIRST_COMPLETED).done:
            handed = doing.pop(future)
            try:
                returned = future.result()
            except BrokenProcessPool:
                lost.append(handed)
                continue
            if not lost:
                doing |= _give(crew, islice(left, 1))
            yield returned
    if not lost:
        return
    # A worker died, and with it the crew: what any of them was at is done once more, alone, and the rest by a new crew.
    for handed in lost:
        yield _alone(order, handed)
    with side_by_side(jobs)(order, left) as rest:
        yield from rest


def _alone(order: GradingContext, handed: Submission) -> GradedSubmission:
    with _crew(order, 1) as crew:
        try:
            return crew.submit(_mark, handed).result()
        except BrokenProcessPool:
            return set_aside(order, handed, "the process that marked it died, twice")


def _crew(order: GradingContext, jobs: int) -> ProcessPoolExecutor:
    # A fork has the solutions already; elsewhere than on Linux the system's own libraries do not survive one.
    method = get_context("fork" if sys.platform == "linux" else "spawn")
    return ProcessPoolExecutor(jobs, mp_context=method, initializer=_begin, initargs=(order,))


def _give(crew: ProcessPoolExecutor, submissions: Iterable[Submission]) -> Doing:
    doing: Doing = {}
    for each in submissions:
        try:
            doing[crew.submit(_mark, each)] = each
        except BrokenProcessPool as error:  # then it is lost as those are that were handed out before
            failed: Future[GradedSubmission] = Future()
            failed.set_exception(error)
            doing[failed] = each
    return doing


def _begin(order: GradingContext) -> None:
    """In a new worker: Ctrl-C ends it at once, and it does not outlive the process that made it, however that one ends."""
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    Thread(target=_end_with_parent, daemon=True).start()
    _at_work.append((order, order.runner()))


def _end_with_parent() -> None:
    parent = parent_process()
    if parent is not None:
        wait_for([parent.sentinel])
        os._exit(1)


def _mark(handed: Submission) -> GradedSubmission:
    """In a worker. Its runner starts with the first submission, so that a failing to start is told like any other."""
    order, runner = _at_work[0]
    return mark_one(order, runner, handed)
