"""A file of records, or of a bank whose exercises are joined with the laws that somebody states for them."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from pathlib import Path

from corollary.audit.readers.moodle_xml import moodle_records
from corollary.audit.readers.prairielearn import folder_name, prairielearn_records
from corollary.audit.readers.qti_items import qti_records
from corollary.audit.readers.rexams import rexams_records
from corollary.audit.readers.straight_line import MOST_ANSWERS
from corollary.audit.readers.webwork import webwork_records
from corollary.audit.record import AskedLetter, ExerciseRecord, StatedGiven, overridden
from corollary.audit.record_file import records_in
from corollary.audit.text_file import xml_of
from corollary.formula.arithmetics import as_formula
from corollary.formula.ast import Expr, Name, Product, Quotient, names, substitute
from corollary.formula.plain_text import text
from corollary.formula.rational_pi import RationalPi
from corollary.formula.syntax import author_formula
from corollary.problem.diagnostic import Diagnostic, Malformed
from corollary.units.unit import Unit, unit


def xml_records(path: Path) -> tuple[ExerciseRecord, ...]:
    """Moodle's questions or QTI's items, by the root of the file. Raises Malformed."""
    return moodle_records(path) if xml_of(path).tag == "quiz" else qti_records(path)


OF_SEVERAL = "#"  # in an id, before the place or the name of one of several answers
RECORDS = {".yaml", ".yml", ".json", ".csv"}
READERS: Mapping[str, Callable[[Path], tuple[ExerciseRecord, ...]]] = {
    ".pg": webwork_records,
    ".html": prairielearn_records,
    ".rmd": rexams_records,
    ".rnw": rexams_records,
    ".xml": xml_records,
}
"""By the ending of a file's name, what reads a bank of that kind."""


def records_of(path: Path, laws: Mapping[str, ExerciseRecord]) -> tuple[ExerciseRecord, ...]:
    """The records of a file, or of the folder of a PrairieLearn question; `laws` are those of exercises by their id.

    Raises Malformed.
    """
    path = in_question_html(path)
    ending = path.suffix.lower()
    if ending in RECORDS:
        return tuple(
            joined(each, laws.get(each.id)) if each.id in laws else each for each in records_in(path)
        )
    if ending not in READERS:
        known = ", ".join(sorted({*RECORDS, *READERS}))
        raise Malformed([Diagnostic(path, 1, f"is not a supported kind of file (supported: {known})")])
    return joined_each(READERS[ending](path), laws)


def in_question_html(path: Path) -> Path:
    """The page of a PrairieLearn question where its folder is named."""
    try:
        return path / "question.html" if (path / "question.html").is_file() else path
    except OSError:  # of a name that is too long, a folder that nobody may enter
        return path


def laws_of(path: Path, laws: Mapping[str, ExerciseRecord]) -> Mapping[str, ExerciseRecord]:
    """Those that a file can need, where its name says which exercise it is."""
    page = in_question_html(path)
    ending = page.suffix.lower()
    if ending in RECORDS or ending == ".xml":
        return laws
    name = folder_name(page) if ending == ".html" else page.stem
    return {
        each: stated
        for each, stated in laws.items()
        if each == name or each.startswith(f"{name}{OF_SEVERAL}")
    }


def laws_by_id(path: Path | None) -> dict[str, ExerciseRecord]:
    """What a file of laws states for each exercise. Raises Malformed."""
    return {each.id: each for each in records_in(path, answers=False)} if path is not None else {}


def joined_each(
    exercises: Sequence[ExerciseRecord], laws: Mapping[str, ExerciseRecord]
) -> tuple[ExerciseRecord, ...]:
    """The answers of a bank, each with the laws of its own id (`fall#2`), of its place there, or of the whole exercise (`fall`).

    The laws of a whole exercise ask for its answers by their names, or for as many as there are, in their order.
    """
    answers: dict[str, list[str]] = {}
    for each in exercises:
        answers.setdefault(each.id.partition(OF_SEVERAL)[0], []).append(each.id)
    found: list[ExerciseRecord] = []
    for each in exercises:
        whole, mark, name = each.id.partition(OF_SEVERAL)
        place = answers[whole].index(each.id) if len(answers[whole]) <= MOST_ANSWERS else 0
        stated = laws.get(each.id) or (laws.get(f"{whole}{OF_SEVERAL}{place + 1}") if mark else None)
        if stated is None and mark and whole in laws:
            stated = _one_of(laws[whole], name, place, len(answers[whole]))
            if stated is None:
                why = f"its laws ask for {len(laws[whole].asked)} of its {len(answers[whole])} answers, and none is called {name}"
                found.append(each if each.unread else replace(each, unread=why))
                continue
        found.append(joined(each, stated, bare=True))
    return tuple(found)


def _one_of(stated: ExerciseRecord, name: str, place: int, count: int) -> ExerciseRecord | None:
    """The laws of a whole exercise, for one of its answers."""
    letters = [each.letter for each in stated.asked]
    if name in letters:
        place = letters.index(name)
    elif len(letters) != count:
        return None
    published = stated.published[place : place + 1]
    return replace(
        stated,
        id=f"{stated.id}{OF_SEVERAL}{name}",
        asked=(stated.asked[place],),
        published=published,
        forgives=stated.forgives[place : place + 1],
    )


def joined(exercise: ExerciseRecord, stated: ExerciseRecord | None, bare: bool = False) -> ExerciseRecord:
    """An exercise with the laws stated for it: these say what is asked, and take precedence in what both say.

    `bare`: its formulas work with bare numbers, each in the unit that the laws' file gives to its letter.
    """
    if stated is None:
        if exercise.unread or exercise.laws or exercise.problem:
            return exercise
        return replace(
            exercise, unread=f"no laws are stated for {exercise.id}; write them in a file for --laws"
        )
    if exercise.unread and not stated.published:
        return exercise
    published = stated.published or exercise.published
    if len(published) != len(stated.asked):
        why = f"it publishes {len(published)} answers, and the laws are for {len(stated.asked)}"
        return replace(exercise, unread=why)
    units = {each.symbol: each for each in stated.given}
    if bare and (why := _misjoined(exercise, stated)):
        return replace(exercise, unread=why)
    asked = stated.asked
    if exercise.key_unit:
        try:
            asked = tuple(replace(each, unit=unit(exercise.key_unit)) for each in asked)
        except ValueError as error:
            return replace(exercise, unread=str(error))
    given = {each.symbol: _in_unit(each, units.get(each.symbol)) for each in exercise.given}
    notes = [
        overridden(given[each.symbol], each.text)
        for each in exercise.given
        if (given[each.symbol].low, given[each.symbol].high) != (each.low, each.high)
    ]
    if bare and exercise.given and not stated.published:
        try:
            published = tuple(
                _in_si(formula, given, asked) for formula, asked in zip(published, asked, strict=True)
            )
        except ValueError as error:
            return replace(exercise, unread=str(error))
    return replace(
        stated,
        path=exercise.path,
        line=exercise.line,
        asked=asked,
        given=tuple((units | given).values()),
        published=published,
        source=exercise.source or stated.source,
        statement=exercise.statement or stated.statement,
        note="; ".join(notes),
        forgives=stated.forgives or (exercise.forgives if len(exercise.forgives) == len(asked) else ()),
    )


def _misjoined(exercise: ExerciseRecord, stated: ExerciseRecord) -> str:
    """Why the letters of a program are not those of the laws; "" where they are."""
    known = {each.symbol for each in stated.given} | {"pi"}
    known |= {letter for law in stated.laws for letter in names(author_formula(law.formula))}
    drawn = {each.symbol for each in exercise.given}
    for each in stated.given:
        if each.low is None and each.symbol in exercise.worked_out - drawn:
            return f"its program works out {each.symbol}, which the laws have as given; state them in what it draws"
    used = set[str]()
    for formula in exercise.published if exercise.given and not stated.published else ():
        used |= names(author_formula(formula))
    if strange := sorted((used & drawn) - known):
        return f"its key has {strange[0]}, which is drawn, and which the laws do not have"
    return ""


def _in_unit(drawn: StatedGiven, stated: StatedGiven | None) -> StatedGiven:
    """What a bank draws, in the unit that the laws' file says; a number there takes precedence."""
    if stated is None:
        return drawn
    return stated if stated.low is not None else replace(drawn, unit=stated.unit)


def _in_si(formula: str, given: Mapping[str, StatedGiven], asked: AskedLetter) -> str:
    """A bank's formula works with bare numbers in the units of the givens and of what is asked: the same in SI.

    Raises ValueError where a unit has a zero of its own.
    """
    tree = author_formula(formula)
    bare: dict[str, Expr] = {}
    for letter in names(tree) & given.keys():
        bare[letter] = _scaled(Name(letter), given[letter].unit, below=True)
    found = substitute(tree, bare)
    return text(found if asked.unit is None else _scaled(found, asked.unit, below=False))


def _scaled(tree: Expr, unit: Unit, *, below: bool) -> Expr:
    """The formula times the size of a unit, or divided by it."""
    if unit.offset:
        raise ValueError(
            f"the key is a formula of bare numbers in {unit.text}, a scale that does not begin at zero"
        )
    if unit.bare:
        return tree
    size = as_formula(RationalPi(unit.factor, unit.pi))
    return Quotient(tree, size) if below else Product((size, tree))
