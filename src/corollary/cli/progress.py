"""Progress on long work, for people only: on a terminal, and on standard error."""

from __future__ import annotations

import sys
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
    if not sys.stderr.isatty():
        yield lambda name: None
        return
    from rich.console import Console
    from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn

    with Progress(
        TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn(), TimeRemainingColumn(), TextColumn("{task.fields[name]}"),
        console=Console(stderr=True), transient=True,
    ) as progress:  # fmt: skip
        task = progress.add_task(what, total=total, name="", completed=-1)

        def tell(name: str) -> None:
            progress.update(task, advance=1, name=name)

        yield tell
