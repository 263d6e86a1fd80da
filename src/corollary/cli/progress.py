"""Progress on long work, for people only: on a terminal, and on standard error."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from typing import TypeVar

T = TypeVar("T")


def steps(todo: Sequence[T], name: Callable[[T], str], what: str) -> Iterator[T]:
    """The items one by one, with a bar that names the one at work."""
    with bar(what, len(todo)) as tell:
        for item in todo:
            tell(name(item))
            yield item


@contextmanager
def bar(what: str, total: int | None) -> Iterator[Callable[[str], None]]:
    """A function that moves the bar on by one and names what is at work."""
    with _shown(what, total, -1) as progress:
        yield lambda name: progress(name, None)


@contextmanager
def countdown(what: str) -> Iterator[Callable[[str, int], None]]:
    """A function that names what is done and says how many are left; the bar tells the rate and the time these will take."""
    with _shown(what, None, 0) as progress:
        yield progress


@contextmanager
def _shown(what: str, total: int | None, done: int) -> Iterator[Callable[[str, int | None], None]]:
    if not sys.stderr.isatty():
        yield lambda name, left: None
        return
    from rich.console import Console
    from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn

    progress = Progress(
        TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn(), TextColumn("{task.fields[rate]}"),
        TimeRemainingColumn(), TextColumn("{task.fields[name]}"), console=Console(stderr=True), transient=True,
    )  # fmt: skip
    task = progress.add_task(what, total=total, name="", rate="", completed=done)
    started, told = time.monotonic(), 0

    def tell(name: str, left: int | None) -> None:
        nonlocal told
        progress.start()  # with the first step only: the bar draws in a thread, and a process is best forked before it has any
        told += 1
        progress.update(task, advance=1, name=name)
        if left is not None:
            progress.update(task, total=told + left, rate=f"{told / (time.monotonic() - started):.1f}/s")

    try:
        yield tell
    finally:
        progress.stop()
