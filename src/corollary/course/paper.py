"""The sheets of a print run set on all cores of this machine; what comes out does not depend on how many there are."""

from __future__ import annotations

import string
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import Future, ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from itertools import product

from corollary.messages import speak, spoken
from corollary.parallel import begin, cores, way_to_start
from corollary.problem.roster import Student
from corollary.render.paper.print_run import PrintedSheet, PrintRun

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
    files: dict[str, bytes] = {}
    pages: list[str] = []
    for at, printed in enumerate(_printed(run)):
        files |= printed.files
        pages.append(printed.pages)
        done(run.sheets[at].mark)
    return files | run.together(pages)


def _printed(run: PrintRun) -> Iterator[PrintedSheet]:
    """In the order of the sheets."""
    if cores() < 2 or len(run.sheets) < WORTH_A_POOL:
        yield from map(run.printed, run.sheets)
        return
    with ProcessPoolExecutor(
        cores(), mp_context=way_to_start(), initializer=_start, initargs=(run, spoken())
    ) as pool:
        try:
            futures = [pool.submit(_print, at) for at in range(len(run.sheets))]
            yield from _results(run, futures)
        finally:
            pool.shutdown(cancel_futures=True)


def _results(run: PrintRun, futures: Sequence[Future[PrintedSheet]]) -> Iterator[PrintedSheet]:
    for at, future in enumerate(futures):
        try:
            yield future.result()
        except BrokenProcessPool:  # a process was killed: what it was at is done here
            yield run.printed(run.sheets[at])


def _start(run: PrintRun, language: str) -> None:
    begin()
    speak(language)
    _at_work.append(run)


def _print(at: int) -> PrintedSheet:
    run = _at_work[0]
    return run.printed(run.sheets[at])
