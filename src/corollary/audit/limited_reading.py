"""Files of records and banks read one after the other, each within bounds of time and memory, none at the cost of another."""

from __future__ import annotations

import math
import os
import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from decimal import Decimal
from fractions import Fraction
from functools import partial
from pathlib import Path
from types import TracebackType
from typing import Self, TypeVar, final

from corollary.audit.bank_file import READERS, RECORDS, in_question_html, laws_by_id, laws_of, records_of
from corollary.audit.forgiven import forgiven_by
from corollary.audit.readers.prairielearn import inputs_of
from corollary.audit.readers.server_draw import ServerDraw, ServerRuns
from corollary.audit.readers.straight_line import NotRead, known_unit, shortened
from corollary.audit.record import AskedLetter, ExerciseRecord, StatedGiven, overridden
from corollary.formula.ast import names
from corollary.formula.numerals import decimal_text
from corollary.formula.syntax import author_formula
from corollary.formula.value import Exact, Nothing, Real, Refused, Text, Value
from corollary.problem.diagnostic import Diagnostic, Malformed
from corollary.sandbox.limited import Limited, NotFinished
from corollary.units.unit import PURE

MOST_FIGURES = 9  # of a number worked out in doubles
NOISE = 12  # figures from which on a double is what the arithmetic left, not what somebody rounded to
LARGEST = Fraction(10) ** 300
NUMBER = r"[-+]?(?:\d{1,100}(?:\.\d{0,100})?|\.\d{1,100})(?:[eE][-+]?\d{1,2})?"
WRITTEN = re.compile(rf"\s*({NUMBER})\s*")
WITH_UNIT = re.compile(rf"\s*({NUMBER})\s*([A-Za-z%/^*0-9 ()-]{{0,40}})")


def drawn_records(
    read: Sequence[ExerciseRecord],
    inputs: Sequence[Mapping[str, str]],
    laws: Mapping[str, ExerciseRecord],
    servers: ServerRuns,
) -> tuple[ExerciseRecord, ...]:
    """What was read of a question, and behind it one record for each seed; these alone of what could not be read.

    `laws` are those of this question, whole or answer by answer. Nothing is run where there are none, or the answer stands in
    `question.html`. One record says why where no seed gives numbers. Raises Malformed, WeakIsolation and CannotStart.
    """
    server = read[0].path.parent / "server.py"
    if not laws or not server.is_file() or any("correct-answer" in each for each in inputs):
        return tuple(read)
    by_name = {each.get("answers-name", ""): each for each in inputs}
    whole = read[0].id.partition("#")[0]
    records: list[ExerciseRecord] = []
    for stated in [laws[whole]] if whole in laws else laws.values():
        answers = _answers_names(stated.asked, by_name)
        draws = servers.draws(server, _letters(stated), list(answers.values()))
        figures = {name: _figures([each.answers.get(name) for each in draws]) for name in answers.values()}
        bare = replace(read[0], id=stated.id)
        drawn = [_at(bare, stated, draw, answers, by_name, figures) for draw in draws]
        records += drawn[:1] if all(each.unread for each in drawn) else drawn
    return (*(each for each in read if not each.unread), *records)


def _letters(stated: ExerciseRecord) -> list[str]:
    """Letters that a program may draw: those given, and all others of the laws but what is asked."""
    of_laws = {letter for law in stated.laws for letter in names(author_formula(law.formula))}
    return sorted({each.symbol for each in stated.given} | of_laws - {each.letter for each in stated.asked})


def _answers_names(asked: Sequence[AskedLetter], inputs: Mapping[str, Mapping[str, str]]) -> dict[str, str]:
    """The name of the answer to each letter asked for: its own, or that of the only input."""
    if len(asked) == len(inputs) == 1:
        return {asked[0].letter: next(iter(inputs))}
    return {each.letter: each.letter for each in asked}


def _at(
    read: ExerciseRecord,
    stated: ExerciseRecord,
    draw: ServerDraw,
    answers: Mapping[str, str],
    inputs: Mapping[str, Mapping[str, str]],
    figures: Mapping[str, Mapping[Fraction, int]],
) -> ExerciseRecord:
    """The record at one seed."""
    place = f"{read.id}, seed {draw.seed}"
    try:
        if draw.trouble:
            raise NotRead(draw.trouble)
        given = _given(stated, draw.params)
        note = _overridden(stated, draw.params)
        published = tuple(
            _published(each, answers[each.letter], draw, inputs.get(answers[each.letter], {}), figures)
            for each in stated.asked
        )
    except NotRead as error:
        bare = ExerciseRecord(place, read.path, read.line, statement=read.statement, unread=str(error))
        return replace(bare, isolation=draw.isolation)
    return replace(
        stated,
        id=place,
        path=read.path,
        line=read.line,
        given=given,
        published=published,
        source=read.source or stated.source,
        statement=read.statement or stated.statement,
        isolation=draw.isolation,
        note=note,
        forgives=tuple(forgiven_by(inputs.get(answers[each.letter], {})) for each in stated.asked),
    )


def _overridden(stated: ExerciseRecord, params: Mapping[str, Value]) -> str:
    """That a number of the laws' file takes the place of another, which the program draws; "" where none does."""
    drawn = {
        each: _number(params[each.symbol], f"params[{each.symbol!r}]")
        for each in stated.given
        if each.fixed and each.symbol in params
    }
    return "; ".join(
        overridden(each, decimal_text(number, 0)) for each, number in drawn.items() if number != each.low
    )


def _given(stated: ExerciseRecord, params: Mapping[str, Value]) -> tuple[StatedGiven, ...]:
    """What is given at one seed, in the units that the laws' file says; a number there takes precedence. Raises NotRead."""
    units = {each.symbol: each.unit for each in stated.assumed} | {
        each.symbol: each.unit for each in stated.given
    }
    given = {each.symbol: each for each in stated.given if each.fixed}
    for each in stated.given:
        if each.symbol not in given and each.symbol not in params:
            raise NotRead(f"generate sets no params[{each.symbol!r}], which the laws have as given")
    for letter, value in params.items():
        if letter not in given:
            number = _number(value, f"params[{letter!r}]")
            given[letter] = StatedGiven(letter, units.get(letter, PURE), number, number)
    return tuple(given.values())


def _published(
    asked: AskedLetter,
    name: str,
    draw: ServerDraw,
    element: Mapping[str, str],
    figures: Mapping[str, Mapping[Fraction, int]],
) -> str:
    """The program's answer as somebody would print it, with the unit behind the input where none is asked for. Raises NotRead."""
    where = f"correct_answers[{name!r}]"
    if element.get("tag") == "pl-symbolic-input":
        raise NotRead(f"{where} is a formula, and numbers are compared where a program is run")
    if name not in draw.answers:
        raise NotRead(f"generate sets no {where}, which the laws ask for")
    value = draw.answers[name]
    match value:
        case Text(text) if found := WITH_UNIT.fullmatch(text):
            number, its_unit = found[1], found[2].strip()
        case _:
            exact = _number(value, where)
            number, its_unit = _in_figures(exact, figures[name][exact]), ""
    if not its_unit and asked.unit is None:
        suffix = element.get("suffix", "").replace("$", "").strip()
        its_unit = suffix if known_unit(suffix) else ""
    return f"{number} {its_unit}".strip()


def _number(value: Value | None, where: str) -> Fraction:
    """The number that a value is. Raises NotRead."""
    match value:
        case Real(number) if math.isfinite(number):
            found = Fraction(repr(number))
        case Exact(number):
            found = number
        case Text(text) if written := WRITTEN.fullmatch(text):
            found = Fraction(written[1])
        case Text():
            raise NotRead(f"{where} is a text, and not that of a number alone")
        case Refused(why):
            raise NotRead(f"{where} {why}")
        case _:
            raise NotRead(f"{where} is {'nothing' if isinstance(value, Nothing) else 'no finite number'}")
    if abs(found) > LARGEST:
        raise NotRead(f"{where} is too large a number")
    return found


def _figures(values: Sequence[Value | None]) -> dict[Fraction, int]:
    """To how many figures each answer is meant: a program that rounds has as few places, or figures, at every seed."""
    found: dict[Fraction, tuple[int, int]] = {}
    for value in values:
        if isinstance(value, Real | Exact):
            try:
                number = _number(value, "")
            except NotRead:
                continue
            decimal = Decimal(f"{float(number):.{NOISE}g}").normalize()
            exponent = decimal.as_tuple().exponent
            assert isinstance(exponent, int)
            found[number] = (
                decimal.adjusted() + 1 if decimal else 1,
                -exponent,
            )  # 1230 is 1.23e3: no place but tens
    places = max((after for number, (_, after) in found.items() if number), default=0)
    most = max((before + after for before, after in found.values()), default=1)
    return {number: max(1, min(MOST_FIGURES, most, before + places)) for number, (before, _) in found.items()}


def _in_figures(number: Fraction, figures: int) -> str:
    """The number to so many figures, zeros at its end counting."""
    text = decimal_text(number, figures)
    return f"{float(number):.{figures - 1}e}" if text.endswith("0") and "." not in text else text


SECONDS, WAITING = 20.0, 30.0  # of the processor, and on the wall: 20 MB of YAML take 15
MOST_COMPLAINTS = 10
NO_RECORDS = "there are no records in it; `docs/reference/audit_records.md` shows how they are written"
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
            return shortened(f"{path.name}: its reader fails ({type(error).__name__}: {error})")


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
