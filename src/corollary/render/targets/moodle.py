"""Questions as Moodle imports them (Question bank, Import, Moodle XML format): a category for each problem, a question a variant."""

from __future__ import annotations

import base64
import math
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from functools import cache
from itertools import combinations
from xml.sax.saxutils import escape

from corollary.answers.unit_meant import unit_meant
from corollary.formula.errors import ParseError
from corollary.messages import catalogue
from corollary.render.exports import CarriedPart, ItemFiles, Target
from corollary.render.lms_item import (
    ChoiceAsked,
    Credit,
    LmsItem,
    NotAsked,
    NumbersAsked,
    PartAsked,
    ProseAsked,
)
from corollary.render.markdown import tex_html, tex_inline
from corollary.render.page import drawing_file
from corollary.render.pictures import as_files, lifted
from corollary.units.unit import ONE, Unit, canonical, read_unit, show
from corollary.units.unit_table import ENGLISH, UNITS

_ = catalogue(__name__)

SPECIAL = frozenset("&#~{}=%\\\"'<>:/\n")
"""What means something inside of a field, or ends it."""
FIELD_LIKE = re.compile(r"\{(?=\s*(?:#|\d*\s*:))")
"""The bracket of what Moodle would take for a field ({1:NM:=2}), or for the place of one ({#1}), in a text around them."""


def cloze(asked: PartAsked, size: int) -> str:
    """The fields of a part; `size` times its points are whole numbers. Raises TypeError for a part that has no fields."""
    points = int(_points(asked) * size)
    match asked:
        case ChoiceAsked(options=options):
            alternatives = (
                _alternative(each.share, _inside(tex_inline(each.option.text)), each.feedback)
                for each in options
            )
            return f"<p>{{{points}:MCV:{'~'.join(alternatives)}}}</p>"
        case NumbersAsked(components=components):
            unit = f" {around_fields(escape(show(asked.unit)))}" if show(asked.unit) else ""
            lines: list[str] = []
            for place, name in enumerate(components):
                alternatives = (
                    _alternative(mark.share, f"{middle}:{reach}", mark.feedback)
                    for middle, reach, mark in answers_in(asked, place)
                )
                before = f"{around_fields(escape(name))}: " if name else ""
                lines.append(f"{before}{{{points}:NUMERICAL:{'~'.join(alternatives)}}}{unit}")
            return f"<p>{'<br>'.join(lines)}</p>"
        case _:
            raise TypeError(f"{type(asked).__name__} has no field")


def size_of_points(asked: Sequence[PartAsked]) -> int:
    """What makes whole numbers of the points of every field, which Moodle wants."""
    return math.lcm(*(_points(each).denominator for each in asked))


def answers_in(asked: NumbersAsked, place: int) -> Iterator[tuple[str, str, Credit]]:
    """The middle of each range and how far it reaches, as Moodle has them."""
    for low, high, mark in _ranges(asked, place):
        yield f"{(low + high) / 2 + 0.0:.7g}", f"{(high - low) / 2:.6g}", mark


def _points(asked: PartAsked) -> Fraction:
    """Those of one field: components share them."""
    fields = len(asked.components) if isinstance(asked, NumbersAsked) else 1
    return Fraction(asked.prompt.out_of).limit_denominator(1000) / fields


def _ranges(asked: NumbersAsked, place: int) -> Iterator[tuple[float, float, Credit]]:
    """What one component may lie between, in the order of trying, without what an earlier range covers."""
    seen: list[tuple[float, float]] = []
    for mark in asked.marks:
        low, high = mark.ranges()[place]
        room = 1e-6 * (high - low)
        if not any(a - room <= low and high <= b + room for a, b in seen):
            seen.append((low, high))
            yield low, high, mark


def _alternative(share: float, answer: str, feedback: str) -> str:
    grade = "=" if share == 1 else f"%{100 * share:.5g}%"
    return grade + answer + (f"#{_inside(tex_inline(feedback))}" if feedback else "")


def _inside(html: str) -> str:
    """HTML as it may stand in a field: Moodle decodes entities there."""
    return "".join(f"&#{ord(sign)};" if sign in SPECIAL else sign for sign in html)


def around_fields(html: str) -> str:
    """HTML beside fields, in which Moodle finds none: a browser shows the same."""
    return FIELD_LIKE.sub("&#123;", html)


COMMON = ("N kN mN J kJ mJ W kW kg g t C V A K m cm mm km s ms min h").split()  # fmt: skip  # noqa: SIM905
"""What products and quotients are made of, products in this order."""
TIMES = ("", "*", "·")
RAISED = (("^2", "²", "2"), ("^3", "³", "3"))
MANY = 60
LEAST, MOST = 1e-9, 1e9
"""Moodle keeps 19 decimals of a size."""


@cache
def typed_units(unit: Unit) -> list[tuple[str, float]]:
    """Each name with how many of it make one of the unit; the unit itself first. None for a plain number and a temperature.

    Only what our own reader reads as this quantity where the unit is asked for: no Hz for rad/s.
    """
    if not show(unit) or unit.offset:
        return []
    found: dict[str, float] = {}
    for text in _candidates(unit):
        name = text.replace(" ", "")
        meant = read_unit(text)
        if isinstance(meant, ParseError) or isinstance(unit_meant(name, unit), ParseError) or name in found:
            continue
        size = unit.si / meant.si
        if meant.dimension == unit.dimension and not meant.offset and LEAST <= size <= MOST:
            found[name] = size
    return list(found.items())[:MANY]


def _candidates(unit: Unit) -> Iterator[str]:
    for text in (show(unit), canonical(unit)):
        yield from _spelled(text)
    for name, each in UNITS.items():
        if each.dimension == unit.dimension and (name == each.text or name in ENGLISH):
            yield name
    if unit.dimension == ONE:
        return
    for one, other in combinations(COMMON, 2):
        a, b = UNITS[one].dimension, UNITS[other].dimension
        if a * b == unit.dimension:
            yield from _spelled(f"{one}*{other}")
        if a / b == unit.dimension:
            yield from _spelled(f"{one}/{other}")


def _spelled(text: str) -> Iterator[str]:
    """The ways to write a product or a power."""
    texts = [text.replace(" ", "*").replace("*", times) for times in TIMES]
    for power in RAISED:
        texts += [
            each.replace(sign, other)
            for each in texts
            for sign in power[:2]
            for other in power
            if sign in each
        ]
    yield from dict.fromkeys(texts)


# What Moodle takes as the grade of an answer, in per cent (`question_bank::fraction_options_full`).
GRADES = (
    100,
    90,
    83.33333,
    80,
    75,
    70,
    66.66667,
    60,
    50,
    40,
    33.33333,
    30,
    25,
    20,
    16.66667,
    14.28571,
    12.5,
    11.11111,
    10,
    5,
    0,
)
NO_ROOM = "an option is a picture, which a field cannot show; --apart sends it as a separate question"
PLACE = "@@PLUGINFILE@@/"  # of the files that come with a text
WRONG_UNIT = 0.5  # what a slip costs
LOST = (
    "an answer that follows from the student's own earlier one is wrong",
    "the same slip costs in every part, not once",
    "figures are not counted: what is rounded to fewer than three is right or wrong as its value is",
    "a decimal comma is read where Moodle speaks a language that has one; the question says so",
)
"""What no question carries."""


def write_items(name: str, items: Sequence[LmsItem], apart: bool) -> ItemFiles:
    """One file with all questions, and what became of each part, from the first variant of each problem."""
    return ItemFiles({f"{name}-moodle.xml": quiz(questions(name, items, apart))}, *became(items, apart))


def quiz(texts: Iterable[str]) -> bytes:
    """A file with these questions and categories."""
    body = "\n".join(texts)
    return f'<?xml version="1.0" encoding="UTF-8"?>\n<quiz>\n{body}\n</quiz>\n'.encode()


def questions(name: str, items: Sequence[LmsItem], apart: bool) -> Iterator[str]:
    """The questions of all items, each pool behind its category."""
    for item in items:
        yield from _questions(name, item, apart)


def became(items: Sequence[LmsItem], apart: bool) -> tuple[tuple[CarriedPart, ...], tuple[str, ...]]:
    """What became of each part, and what is lost of all, from the first variant of each problem."""
    first = [item for item in items if item.number == 1]
    return tuple(_carried(first, apart)), (*LOST, *_grades_lost(first, apart))


def _grades_lost(items: Sequence[LmsItem], apart: bool) -> Iterator[str]:
    """Shares that Moodle does not have for an answer, and what takes their place; embedded answers take any."""
    for scheme in dict.fromkeys(item.scheme for item in items if apart or len(_asked(item)) == 1):
        for share in (scheme.mistaken, scheme.slip, scheme.choice):
            if 100 * share - _grade(share) > 1e-3:
                yield f"Moodle has no grade of {100 * share:g} %: such an answer earns {_grade(share):g} %"


def _carried(items: Sequence[LmsItem], apart: bool) -> Iterator[CarriedPart]:
    for item in items:
        together = _asked(item)
        alone = apart or len(together) == 1
        for asked in item.parts:
            no_room = not apart and _shows_pictures(asked) and asked not in together
            how = ("", NO_ROOM) if no_room else _how(asked, alone)
            yield CarriedPart(item.exercise.problem.code, asked.prompt.part.id, *how)


def _how(asked: PartAsked, alone: bool) -> tuple[str, str]:
    """How a part is asked ("" where it is not), and what is lost of it."""
    match asked:
        case NumbersAsked(components=components) if len(components) > 1:
            lost = "each component earns its share by itself; a unit that is typed is not read"
            return "a field for each component", lost
        case NumbersAsked() if alone:
            return "number and unit", "a number without a unit earns half" if typed_units(asked.unit) else ""
        case NumbersAsked():
            return "field for a number", "a unit that is typed is not read: it stands beside the field"
        case ChoiceAsked():
            return "choice", ""
        case ProseAsked() if alone:
            return "essay", "a person marks it"
        case ProseAsked():
            return "", "a question of several parts has no field for prose; --apart sends it as an essay"
        case NotAsked(why=why):
            return "", why


def _asked(item: LmsItem) -> Sequence[PartAsked]:
    """What can stand in one question; prose only where there is nothing else."""
    fields = [each for each in item.parts if isinstance(each, NumbersAsked | ChoiceAsked)]
    if len(fields) > 1:
        fields = [each for each in fields if not _shows_pictures(each)] or fields[:1]
    prose = [each for each in item.parts if isinstance(each, ProseAsked)]
    return fields or prose[:1]


def _shows_pictures(asked: PartAsked) -> bool:
    return isinstance(asked, ChoiceAsked) and any(
        lifted(each.option.text).addresses for each in asked.options
    )


def _questions(name: str, item: LmsItem, apart: bool) -> Iterator[str]:
    problem = item.exercise.problem
    pool = f"{problem.code} {problem.title}".replace("/", "//")
    if not apart:
        if asked := _asked(item):
            yield from _category(item, name, pool)
            yield _question(item, asked, str(item.number))
        return
    for each in item.parts:
        if not isinstance(each, NotAsked):
            letter = each.prompt.part.heading_letter
            yield category(name, pool, f"({letter})")
            yield _question(item, [each], f"({letter}), {item.number}")


def _category(item: LmsItem, name: str, pool: str) -> Iterator[str]:
    if item.number == 1:
        yield category(name, pool)


def category(*path: str) -> str:
    text = escape("/".join(("$course$", "top", "Corollary", *path)))
    return f'<question type="category"><category><text>{text}</text></category></question>'


def _question(item: LmsItem, asked: Sequence[PartAsked], number: str) -> str:
    problem = item.exercise.problem
    head = [
        f"<name><text>{escape(f'{problem.code} {problem.title}, {number}')}</text></name>",
        f'<generalfeedback format="html">{cdata(tex_html(item.solution))}</generalfeedback>',
    ]
    stem = f"{tex_html(item.exercise.statement)}{figure(item)}"
    match asked:
        case [NumbersAsked(components=("",)) as one]:
            kind, text, rest = (
                "numerical",
                f"{words(one)}<p>{escape(_number_and_unit())}</p>",
                _numerical(one),
            )
        case [ChoiceAsked() as one]:
            kind, text, rest = "multichoice", words(one), _multichoice(one)
        case [ProseAsked() as one]:
            kind, text, rest = "essay", words(one), _essay(one)
        case _:
            size = size_of_points(asked)
            fields = "".join(around_fields(words(each)) + cloze(each, size) for each in asked)
            stem = around_fields(stem)
            kind, text, rest = "multianswer", f"<p>{escape(_numbers_only())}</p>{fields}", []
    if kind != "multianswer":
        rest = [f"<defaultgrade>{asked[0].prompt.out_of:g}</defaultgrade>", *rest]
    question = question_text(item, stem + text)
    penalty = "<penalty>0</penalty>"
    return "\n".join([f'<question type="{kind}">', *head, question, penalty, *rest, "</question>"])


def question_text(item: LmsItem, html: str) -> str:
    """The text of a question, with the figure and the pictures that it shows."""
    text, pictures = as_files(html, PLACE)
    figure_file = {item.figure_name: drawing_file(item.exercise)} if item.figure_name else {}
    return f'<questiontext format="html">{cdata(text)}{_files(figure_file | pictures)}</questiontext>'


def words(asked: PartAsked) -> str:
    part = asked.prompt.part
    return f"<h4>({part.heading_letter}) {tex_inline(part.title)}</h4>{tex_html(asked.prompt.text)}"


def _numbers_only() -> str:
    return _(
        "In each number field, write only the number, in the unit beside the field, with at least "
        "three significant figures: 4.71 or 6.30e-5. Use a decimal point, not a comma."
    )


def _number_and_unit() -> str:
    return _(
        "Write a number with at least three significant figures, and its unit. Use a decimal point, not a comma."
    )


def _numerical(asked: NumbersAsked) -> list[str]:
    answers = [
        f'<answer fraction="{_grade(mark.share):g}"><text>{middle}</text><tolerance>{reach}</tolerance>{_feedback(mark.feedback)}</answer>'
        for middle, reach, mark in answers_in(asked, 0)
    ]
    units = typed_units(asked.unit)
    listed = "".join(
        f"<unit><multiplier>{size:.12g}</multiplier><unit_name>{escape(name)}</unit_name></unit>"
        for name, size in units
    )
    graded = (
        f"<units>{listed}</units><unitgradingtype>1</unitgradingtype><unitpenalty>{WRONG_UNIT}</unitpenalty>"
        "<showunits>0</showunits><unitsleft>0</unitsleft>"
    )
    return [*answers, graded if units else "<unitgradingtype>0</unitgradingtype><showunits>3</showunits>"]


def _multichoice(asked: ChoiceAsked) -> list[str]:
    answers: list[str] = []
    for each in asked.options:
        text, files = as_files(tex_inline(each.option.text), PLACE)
        answers.append(
            f'<answer fraction="{_grade(each.share):g}" format="html">{cdata(text)}{_files(files)}'
            f"{_feedback(each.feedback)}</answer>"
        )
    rest = "<single>true</single><shuffleanswers>false</shuffleanswers><answernumbering>abc</answernumbering>"
    return [rest, *answers]


def _essay(asked: ProseAsked) -> list[str]:
    rubric = "".join(f"<li>{tex_inline(each)}</li>" for each in asked.rubric)
    info = f'<graderinfo format="html">{cdata(f"<ul>{rubric}</ul>" if rubric else "")}</graderinfo>'
    return ["<responseformat>editor</responseformat><responserequired>1</responserequired>", info]


def _grade(share: float) -> float:
    """The grade that Moodle has, in per cent: the nearest that is not above."""
    return next(each for each in GRADES if each <= 100 * share + 1e-3)


def _feedback(text: str) -> str:
    return f'<feedback format="html">{cdata(tex_html(text))}</feedback>' if text else ""


def figure(item: LmsItem) -> str:
    if not item.exercise.figure:
        return ""
    alt = escape(item.exercise.figure_alt, {'"': "&quot;"})
    return f'<p><img src="{PLACE}{item.figure_name}" alt="{alt}"></p>'


def _files(files: Mapping[str, bytes]) -> str:
    return "".join(
        f'<file name="{name}" path="/" encoding="base64">{base64.b64encode(raw).decode()}</file>'
        for name, raw in files.items()
    )


def cdata(html: str) -> str:
    return f"<text><![CDATA[{html.replace(']]>', ']]&gt;')}]]></text>"


TARGET = Target(ending="xml", items=write_items)
