"""Files of records and banks read one after the other, each within bounds of time and memory, none at the cost of another."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from types import TracebackType
from typing import Self, TypeVar, final

from corollary.audit.bank_file import READERS, RECORDS, in_question_html, laws_by_id, laws_of, records_of
from corollary.audit.drawn_record import drawn_records
from corollary.audit.readers.prairielearn import inputs_of
from corollary.audit.readers.server_draw import ServerRuns
from corollary.audit.readers.straight_line import NotRead, shortened
from corollary.audit.record import ExerciseRecord
from corollary.problem.diagnostic import Diagnostic, Malformed
from corollary.sandbox.limited import Limited, NotFinished

SECONDS, WAITING = 20.0, 30.0  # of the processor, and on the wall: 20 MB of YAML take 15
MOST_COMPLAINTS = 10
NO_RECORDS = "there are no records in it; `docs/audit.md` shows how they are written"
T = TypeVar("T")
LONGEST_ID, LONGEST_STATEMENT, LONGEST_ANSWER = 200, 5000, 2000  # characters


@dataclass(frozen=True, slots=True)
class BankReading:
    """`trouble` says why a file as a whole could not be read, and its one record, too; `no_such_file` where it is not there, or is
    of no kind that is read."""

    records: tuple[ExerciseRecord, ...]
    trouble: str = ""
    no_such_file: bool = False


@final
class LimitedReader:
    """What stands in files, with the laws of `laws`; with `servers` their programs are run, too."""

    def __init__(self, laws: Path | None, servers: ServerRuns | None) -> None:
        self._interpreter, self._servers = Limited(), servers
        self._laws_file = laws
        self._laws: Mapping[str, ExerciseRecord] = {}

    def __enter__(self) -> Self:
        """Raises Malformed where the file of laws cannot be read."""
        if self._laws_file is not None:
            laws = self._laws_file.absolute()
            found = self._within_limits(partial(_laws_or_trouble, laws), laws)
            if isinstance(found, str):
                raise Malformed([Diagnostic(laws, 1, found.removeprefix(f"{laws.name}:1: "))])
            self._laws = found
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._interpreter.stop()

    def read(self, path: Path) -> BankReading:
        """Raises WeakIsolation and CannotStart where programs cannot be run well enough here."""
        path = path.absolute()  # the interpreter that reads it is elsewhere
        laws = laws_of(path, self._laws)
        found = self._within_limits(partial(_records_or_trouble, path, laws), path)
        if isinstance(found, str):
            return self._unread(path, found)
        records, inputs = found
        if not records:
            return self._unread(path, f"{path.name}: {NO_RECORDS}")
        if self._servers is None or not inputs:
            return BankReading(records)
        try:
            return BankReading(drawn_records(records, inputs, laws, self._servers))
        except Malformed as error:
            return self._unread(path, _sentence(error))

    def _within_limits(self, function: Callable[[], T], path: Path) -> T | str:
        try:
            return self._interpreter.call(function, SECONDS, WAITING)
        except NotFinished:
            return f"{path.name}: was not read within {SECONDS:.0f} s and the memory allowed; divide it"

    def _unread(self, path: Path, trouble: str) -> BankReading:
        known = path.suffix.lower() in {*RECORDS, *READERS} or in_question_html(path) != path
        record = ExerciseRecord(_printable(path.name, LONGEST_ID), path, 1, unread=trouble)
        return BankReading((record,), trouble, not (known and os.path.lexists(path)))


def _laws_or_trouble(path: Path) -> dict[str, ExerciseRecord] | str:
    try:
        return laws_by_id(path)
    except Exception as error:
        return _trouble(path, error)


def _records_or_trouble(
    path: Path, laws: Mapping[str, ExerciseRecord]
) -> tuple[tuple[ExerciseRecord, ...], list[dict[str, str]]] | str:
    """The records, and the inputs of a question whose program may be run; or why there are none."""
    try:
        records = tuple(_bounded(each) for each in records_of(path, laws))
        page = in_question_html(path)
        return records, _inputs(page) if page.suffix.lower() == ".html" else []
    except Exception as error:
        return _trouble(path, error)


def _inputs(page: Path) -> list[dict[str, str]]:
    try:
        return inputs_of(page)
    except NotRead:
        return []  # as its record says


def _trouble(path: Path, error: Exception) -> str:
    match error:
        case Malformed():
            return _sentence(error)
        case OSError():
            return f"{path.name}: cannot be read: {error.strerror}"
        case RecursionError():
            return f"{path.name}: is nested too deeply"
        case _:  # a fault of a reader costs this file, not those after it
            return shortened(f"{path.name}: its reader fails on it ({type(error).__name__}: {error})")


def _sentence(error: Malformed) -> str:
    """The first complaints, and how many more there are."""
    first = [shortened(str(each)) for each in error.complaints[:MOST_COMPLAINTS]]
    more = len(error.complaints) - len(first)
    return _printable("\n".join([*first, *([f"and {more} more"] if more else [])]), 10 * LONGEST_STATEMENT)


def _bounded(record: ExerciseRecord) -> ExerciseRecord:
    """A record that can be shown, whatever somebody wrote into it."""
    published = tuple(_printable(each, LONGEST_ANSWER) for each in record.published)
    unread = record.unread
    if not unread and any(len(each) >= LONGEST_ANSWER for each in published):
        unread = f"an answer of more than {LONGEST_ANSWER} characters is not read"
    return replace(
        record,
        id=_printable(record.id, LONGEST_ID),
        published=published,
        source=_printable(record.source, LONGEST_STATEMENT),
        address=_printable(record.address, LONGEST_STATEMENT),
        licence=_printable(record.licence, LONGEST_STATEMENT),
        statement=_printable(record.statement, LONGEST_STATEMENT),
        unread=_printable(unread, LONGEST_STATEMENT),
    )


def _printable(text: str, most: int) -> str:
    """A text without halves of characters, of a length that is shown."""
    text = text if len(text) <= most else f"{text[: most - 1]}…"
    return text.encode("utf-8", "replace").decode("utf-8")
