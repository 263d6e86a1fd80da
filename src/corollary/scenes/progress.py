"""How far a scene has got, told while it is played to whoever listens.

What is played has many rooms below the command that waits for it; a listener is set for all of them at once.
"""

from __future__ import annotations

from collections.abc import Callable, Generator
from contextlib import contextmanager
from contextvars import ContextVar

Listener = Callable[[float], None]
"""Takes the share (0 to 1) that is done; it never falls."""

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
