"""The terminal: width of tables, progress on long work, and letters that it lacks."""

from __future__ import annotations

import codecs
import io
import os
import shutil
import sys
import textwrap
import time
import unicodedata
from collections import deque
from collections.abc import Callable, Generator, Iterator, Sequence
from contextlib import contextmanager
from typing import TYPE_CHECKING, Final, TypeVar

if TYPE_CHECKING:
    from rich.console import Console

UNLIMITED: Final = 10_000
"""Columns. A pipe has no width of its own; rich takes 80, and what does not fit would be cut off for whoever reads it there."""


def console(*, stderr: bool = False) -> Console:
    """A console on standard output, or on standard error."""
    from rich.console import Console  # only by commands that print tables

    stream = sys.stderr if stderr else sys.stdout
    limited = stream.isatty() or "COLUMNS" in os.environ
    return Console(stderr=stderr, width=None if limited else UNLIMITED)


def columns() -> int:
    """The width of the terminal, or UNLIMITED where there is none."""
    if sys.stdout.isatty() or "COLUMNS" in os.environ:
        return shutil.get_terminal_size().columns
    return UNLIMITED


def hanging(opening: str, text: str, most: int = UNLIMITED) -> str:
    """An opening with a text behind it, broken between words at the terminal's width, `most` at most; further lines begin under
    the text."""
    indent = " " * len(opening)
    wide = max(len(opening) + 24, min(most, columns()))
    lines = textwrap.wrap(
        text,
        wide,
        initial_indent=opening,
        subsequent_indent=indent,
        break_long_words=False,
        break_on_hyphens=False,
    )
    return "\n".join(lines) or opening.rstrip()


T = TypeVar("T")
WINDOW = 40  # the last so many steps tell the pace


def steps(todo: Sequence[T], name: Callable[[T], str], what: str) -> Iterator[T]:
    """The items one by one, with a bar that names the one at work."""
    with bar(what, len(todo)) as progress:
        for item in todo:
            progress(name(item))
            yield item


@contextmanager
def bar(what: str, total: int | None) -> Generator[Callable[[str], None]]:
    """A function that moves the bar on by one and names what is at work."""
    with _drawn(what, total, -1) as progress:
        yield lambda name: progress(name, None)


@contextmanager
def countdown(what: str) -> Generator[Callable[[str, int], None]]:
    """A function that names what is done and says how many are left; the bar tells the rate and the time these will take."""
    with _drawn(what, None, 0) as progress:
        yield progress


@contextmanager
def _drawn(what: str, total: int | None, done: int) -> Generator[Callable[[str, int | None], None]]:
    if not sys.stderr.isatty():
        yield _lines(what, total)
        return
    from rich.console import Console
    from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn
    from rich.table import Column

    console = Console(stderr=True)
    progress = Progress(
        TextColumn("{task.description}"),
        BarColumn(bar_width=20),
        MofNCompleteColumn(),
        TextColumn("{task.fields[pace]}"),
        TextColumn("{task.fields[name]}", table_column=Column(no_wrap=True, overflow="ellipsis")),
        console=console,
        transient=True,
    )
    task = progress.add_task(what, total=total, name="", pace="", completed=max(done, 0))
    count, moments = 0, deque[float](maxlen=WINDOW)
    # The bar draws in a thread, and a process is best forked before it has any: until the first step, one line that stands still.
    console.print(f"{what}: getting ready", end="\r", markup=False, highlight=False)

    def step(name: str, left: int | None) -> None:
        nonlocal count
        progress.start()
        count += 1
        moments.append(time.monotonic())
        if left is not None:
            progress.update(task, total=count + left)
        elif total is not None:
            left = total - count + 1
        progress.update(task, advance=1, name=name, pace=pace(moments, left))
        if left == 0:
            progress.stop()  # what comes now may be a question

    try:
        yield step
    finally:
        progress.stop()
        if not count:
            console.print(" " * min(len(what) + 15, console.width - 1), end="\r")


EVERY = 10.0  # seconds between two lines of progress, where there is no terminal


def _lines(what: str, total: int | None) -> Callable[[str, int | None], None]:
    """Progress for a log or a pipe: `verifying: 3 of 43 (X12.5)` on standard error, at times; none from what is soon done."""
    count, last = 0, time.monotonic()

    def step(name: str, left: int | None) -> None:
        nonlocal count, last
        count += 1
        now = time.monotonic()
        every = total if left is None else count + left
        if now - last < EVERY or count == every:
            return
        last = now
        out_of = "" if every is None else f" of {every}"
        print(f"{what}: {count}{out_of} ({name})", file=sys.stderr, flush=True)

    return step


def pace(moments: Sequence[float], left: int | None) -> str:
    """Steps a second, counted from one step to another so that getting ready does not count, and how long those left will take."""
    if len(moments) < 3 or left is None:
        return ""
    from corollary.render.wording import spell  # with formulas and catalogues, which most commands do without

    each = max((moments[-1] - moments[0]) / (len(moments) - 1), 1e-3)
    rate = f"{1 / each:.1f}/s" if each < 1 else f"{60 / each:.0f}/min"
    return f"{rate}, {spell(each * left)} left" if left else rate


NEAREST = "corollary.nearest"  # the name of the way that letters are replaced, as Python's "replace" is one
LIKE = {
    "≈": "~", "…": "...", "–": "-", "—": "-", "−": "-", "·": "*", "×": "x", "“": '"', "”": '"', "„": '"', "’": "'", "‘": "'",
    "≤": "<=", "≥": ">=", "≠": "!=", "→": "->", "Δ": "Delta", "π": "pi", "°": " deg", "√": "sqrt", "µ": "u", "μ": "u", "Ω": "Ohm",
    "⁻": "^-", "∞": "inf", "\N{NO-BREAK SPACE}": " ", "\N{NARROW NO-BREAK SPACE}": " ", "■": "#", "▸": ">", "ß": "ss", "ø": "o",
}  # fmt: skip


def write_whatever_comes() -> None:
    """Lets standard output and error take every text: C and cp1252 have no ≈, and a line must not end in a traceback."""
    codecs.register_error(NEAREST, nearest)
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors=NEAREST)


def nearest(error: UnicodeError) -> tuple[str, int]:
    """What is written for letters that cannot be: the like of them, the letter without its accent, else `?`."""
    if not isinstance(error, UnicodeEncodeError):
        raise error
    letters = error.object[error.start : error.end]
    return "".join(_nearest(letter, error.encoding) for letter in letters), error.end


def _nearest(letter: str, encoding: str) -> str:
    for text in (LIKE.get(letter, ""), unicodedata.normalize("NFKD", letter)):
        bare = "".join(each for each in text if not unicodedata.combining(each))
        if bare and _has(encoding, bare):
            return bare
    return "?"


def _has(encoding: str, text: str) -> bool:
    try:
        text.encode(encoding)
    except UnicodeEncodeError:
        return False
    return True
