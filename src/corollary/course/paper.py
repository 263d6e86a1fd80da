"""The sheets of a print run set on all cores of this machine; what comes out does not depend on how many there are."""

from __future__ import annotations

import string
from collections.abc import Callable, Iterable
from concurrent.futures import Future, ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from functools import partial
from itertools import product

from corollary.messages import speak, spoken
from corollary.parallel import begin, cores, way_to_start
from corollary.problem.roster import Student
from corollary.render.paper.print_run import PrintRun

WORTH_A_POOL = 8  # fewer are done sooner than processes start

_at_work: list[PrintRun] = []  # of a worker process


def form_owners(count: int) -> list[Student]:
    """Whoever gets one of so many forms: A to Z, then AA, AB, …"""
    letters = string.ascii_uppercase
    pairs = ("".join(pair) for pair in product(letters, repeat=2))
    return [Student(name) for name, _number in zip([*letters, *pairs], range(count), strict=False)]


def print_files(run: PrintRun, done: Callable[[str], None]) -> dict[str, bytes]:
    """Every file of a print run by its name; `done` is told the name of each sheet. Raises CannotTypeset, NotDerivable, Undefined."""
    run.prepare()
    if cores() < 2 or len(run.sheets) < WORTH_A_POOL:
        return _collected(run, map(run.printed, run.sheets), done) | run.together()
    with ProcessPoolExecutor(
        cores(), mp_context=way_to_start(), initializer=_start, initargs=(run, spoken())
    ) as pool:
        try:
            together = pool.submit(_together)  # the longest job is the first, so that none waits for it
            futures = [pool.submit(_printed, at) for at in range(len(run.sheets))]
            each = (
                _result(future, partial(run.printed, sheet))
                for future, sheet in zip(futures, run.sheets, strict=True)
            )
            return _collected(run, each, done) | _result(together, run.together)
        finally:
            pool.shutdown(cancel_futures=True)


def _collected(
    run: PrintRun, printed: Iterable[dict[str, bytes]], done: Callable[[str], None]
) -> dict[str, bytes]:
    """In the order of the sheets."""
    files: dict[str, bytes] = {}
    for sheet, found in zip(run.sheets, printed, strict=True):
        files |= found
        done(sheet.mark)
    return files


def _result(future: Future[dict[str, bytes]], here: Callable[[], dict[str, bytes]]) -> dict[str, bytes]:
    try:
        return future.result()
    except BrokenProcessPool:  # a process was killed: what it was at is done here
        return here()


def _start(run: PrintRun, language: str) -> None:
    begin()
    speak(language)
    _at_work.append(run)


def _printed(at: int) -> dict[str, bytes]:
    run = _at_work[0]
    return run.printed(run.sheets[at])


def _together() -> dict[str, bytes]:
    return _at_work[0].together()
