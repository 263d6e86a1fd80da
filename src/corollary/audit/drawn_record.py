"""An exercise at the numbers that its program draws: a record for each seed, with the program's own answer as the published one."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import replace
from decimal import Decimal
from fractions import Fraction

from corollary.audit.forgiven import forgiven_by
from corollary.audit.readers.server_draw import ServerDraw, ServerRuns
from corollary.audit.readers.straight_line import NotRead, known_unit
from corollary.audit.record import AskedLetter, ExerciseRecord, StatedGiven, overridden
from corollary.formula.ast import names
from corollary.formula.numerals import decimal_text
from corollary.formula.syntax import author_formula
from corollary.formula.value import Exact, Nothing, Real, Refused, Text, Value
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
