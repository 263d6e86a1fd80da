"""The sheets of a print run set on all cores of this machine; what comes out does not depend on how many there are."""

from __future__ import annotations

import string
from collections.abc import Callable, Iterable, Sequence
from concurrent.futures import Future
from functools import partial
from itertools import product
from typing import TypeVar

from corollary.messages import speak, spoken
from corollary.parallel import ProcessDied, Workers, cores
from corollary.problem.roster import Student
from corollary.render.paper.print_run import Pages, PrintRun

T = TypeVar("T")

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
        pages = [run.pages(sheet) for sheet in run.sheets]
        return _collected(run, map(run.printed, run.sheets, pages), done) | run.together(pages)
    with Workers(cores(), _start, run, spoken()) as pool:
        written = [pool.submit(_pages, at) for at in range(len(run.sheets))]
        pages = [
            _result(future, partial(run.pages, sheet))
            for future, sheet in zip(written, run.sheets, strict=True)
        ]
        together = pool.submit(_together, pages)  # the longest job is the first, so that none waits for it
        futures = [pool.submit(_printed, at, each) for at, each in enumerate(pages)]
        each = (
            _result(future, partial(run.printed, sheet, pages[at]))
            for at, (future, sheet) in enumerate(zip(futures, run.sheets, strict=True))
        )
        return _collected(run, each, done) | _result(together, partial(run.together, pages))


def _collected(
    run: PrintRun, printed: Iterable[dict[str, bytes]], done: Callable[[str], None]
) -> dict[str, bytes]:
    """In the order of the sheets."""
    files: dict[str, bytes] = {}
    for sheet, found in zip(run.sheets, printed, strict=True):
        files |= found
        done(sheet.mark)
    return files


def _result(future: Future[T], here: Callable[[], T]) -> T:
    try:
        return future.result()
    except ProcessDied:  # a process was killed: what it was at is done here
        return here()


def _start(run: PrintRun, language: str) -> None:
    speak(language)
    _at_work.append(run)


def _pages(at: int) -> Pages:
    run = _at_work[0]
    return run.pages(run.sheets[at])


def _printed(at: int, pages: Pages) -> dict[str, bytes]:
    run = _at_work[0]
    return run.printed(run.sheets[at], pages)


def _together(pages: Sequence[Pages]) -> dict[str, bytes]:
    return _at_work[0].together(pages)
