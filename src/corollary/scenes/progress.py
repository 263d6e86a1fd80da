"""Progress of a scene while it is played, told to whoever listens; a terminal shows a bar.

What is played has many rooms below the command that waits for it; a listener is set for all of them at once.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Generator
from contextlib import contextmanager
from contextvars import ContextVar
from threading import Event, Thread

Listener = Callable[[float], None]
"""Takes the share (0 to 1) that is done; it never falls."""

PATIENCE, REDRAWN = 1.0, 0.1  # seconds until a wait is shown, and between two looks at how far it has got

_listener: ContextVar[Listener | None] = ContextVar("listener", default=None)


@contextmanager
def reported_to(listener: Listener) -> Generator[None]:
    """Whatever is played within is told to this listener."""
    known = _listener.set(listener)
    try:
        yield
    finally:
        _listener.reset(known)


@contextmanager
def part(begin: float, end: float) -> Generator[None]:
    """What is played within is only this part of the whole: from `begin` to `end` (0 to 1), both of which are told."""
    outer = _listener.get()
    if outer is None:
        yield
        return
    outer(begin)
    with reported_to(lambda share: outer(begin + share * (end - begin))):
        yield
    outer(end)


def tell(share: float) -> None:
    """Say that so much (0 to 1) is done."""
    listener = _listener.get()
    if listener is not None:
        listener(share)


@contextmanager
def with_bar(what: str, after: float = PATIENCE) -> Generator[None]:
    """Whoever waits at a terminal sees a bar on it once `after` seconds have passed; not if somebody listens already."""
    if _listener.get() is not None or sys.stderr is None or not sys.stderr.isatty():
        yield
        return
    shares: list[float] = []
    over = Event()
    drawing = Thread(target=_draw, args=(what, after, shares, over), daemon=True)
    drawing.start()
    try:
        with reported_to(shares.append):
            yield
    finally:
        over.set()
        drawing.join()


def _draw(what: str, after: float, shares: list[float], over: Event) -> None:
    """Until it is over; rich is loaded only for what takes so long."""
    if after > 0.0 and over.wait(after):
        return
    from rich.console import Console
    from rich.progress import BarColumn, Progress, TextColumn, TimeElapsedColumn

    columns = TextColumn("{task.description}"), BarColumn(bar_width=20), TimeElapsedColumn()
    with Progress(*columns, console=Console(stderr=True), transient=True) as progress:
        task = progress.add_task(what, total=None)
        while True:
            if shares and shares[-1] > 0.0:  # until something is known of it, the bar moves to and fro
                progress.update(task, total=1.0, completed=shares[-1])
            if over.wait(REDRAWN):
                return
