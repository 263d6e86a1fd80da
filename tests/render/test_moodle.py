"""Questions for Moodle: well-formed, complete, coherent in their numbers; each part is carried or refused by name."""

from __future__ import annotations

import base64
import html
import re
from dataclasses import replace
from xml.etree import ElementTree as Xml

import pytest

from corollary.grading.solutions import Solutions
from corollary.messages import language
from corollary.problem.bank import chapter_bank, home
from corollary.problem.problem_set import Scheme
from corollary.problem.variant import at
from corollary.render.exports import target
from corollary.render.lms_item import ChoiceAsked, LmsItem, NumbersAsked, item

SOLUTIONS = Solutions(chapter_bank())
USUAL = Scheme()
FIELD = re.compile(r"\{(\d+):(NUMERICAL|MCV):(.*?)\}", re.DOTALL)


def of(code: str, number: int = 1, scheme: Scheme = USUAL) -> LmsItem:
    return item(SOLUTIONS, at(home(None, code)[1], 40 * number), number, 1.0, scheme)


def written(*items: LmsItem, apart: bool = False):
    made = target("moodle").items
    assert made is not None
    return made("few", items, apart)


def questions(*items: LmsItem, apart: bool = False) -> list[Xml.Element]:
    files = written(*items, apart=apart).files
    return list(Xml.fromstring(files["few-moodle.xml"]))


def text(question: Xml.Element, place: str = "questiontext") -> str:
    found = question.findtext(f"{place}/text")
    assert found is not None
    return found


def test_variants_of_a_problem_are_a_category_of_their_own():
    found = questions(of("X12.5", 1), of("X12.5", 2), of("X12.10", 1))
    assert [each.get("type") for each in found] == [
        "category",
        "multianswer",
        "multianswer",
        "category",
        "multianswer",
    ]
    assert found[0].findtext("category/text") == "$course$/top/Corollary/few/X12.5 Kicking a ball"
    names = [each.findtext("name/text") for each in found if each.get("type") == "multianswer"]
    assert len({*names}) == 3
    assert text(found[1]) != text(found[2])


def test_each_field_has_the_right_answer_with_its_tolerance_and_feedback():
    made = of("X12.5")
    (_, question) = questions(made)
    fields = FIELD.findall(text(question))
    assert [int(points) for points, _, _ in fields] == [1, 1, 1, 2]
    for (_, kind, body), asked in zip(fields, made.parts, strict=True):
        assert kind == "NUMERICAL"
        first, *others = body.split("~")
        value, reach = map(float, first.removeprefix("=").split(":"))
        assert value == pytest.approx(asked.marks[0].values[0], rel=1e-6)
        assert reach == pytest.approx(asked.marks[0].reach, rel=1e-4)
        said = [html.unescape(each.partition("#")[2]) for each in others]
        assert all(said)
        assert sum(each.startswith("%25%") for each in others) >= 1
        halves = sum(each.startswith("%50%") for each in others)
        # (b) has the value of (a), of which a slip is a guess
        assert (halves >= 5) == (asked.prompt.part.id != "b")


def test_nothing_inside_of_a_field_ends_it():
    """Formulas in options have braces, and signs that mean something there."""
    (_, question) = questions(of("S12.2"))
    body = text(question)
    opened = re.findall(r"\{\d+:[A-Z]+:", body)
    fields = FIELD.findall(body)
    assert len(fields) == len(opened) >= 2
    for _, _, inside in fields:
        for alternative in inside.split("~"):
            assert re.fullmatch(
                r"(=|%[\d.]+%)?(?:[^~#{}\\]|&#\d+;)+(#(?:[^~#{}\\]|&#\d+;)*)?", alternative
            ), alternative


def test_the_figure_and_the_worked_solution_come_along():
    (_, question) = questions(of("X12.5"))
    file = question.find("questiontext/file")
    assert file is not None
    assert Xml.fromstring(base64.b64decode(file.text or "")).tag.endswith("svg")
    assert f'src="@@PLUGINFILE@@/{file.get("name")}" alt="A ball of mass' in text(question)
    assert r"\[J = \Delta p" in text(question, "generalfeedback")
    assert "$" not in text(question)


def test_parts_apart_read_units_and_prose_is_an_essay():
    found = [each for each in questions(of("P12.14"), apart=True) if each.get("type") != "category"]
    kinds = {each.findtext("name/text", "").partition(", ")[2]: each.get("type") for each in found}
    assert kinds["(a), 1"] == "numerical"
    assert kinds["(k), 1"] == "essay"
    one = found[0]
    assert one.findtext("unitgradingtype") == "1"
    assert float(one.findtext("units/unit/multiplier", "0")) == 1.0
    fractions = {float(each.get("fraction", "")) for each in one.iter("answer")}
    assert fractions <= {100.0, 50.0, 25.0, 0.0}


def test_every_part_is_carried_or_refused_by_name():
    made = of("P12.14")
    for apart in (False, True):
        parts = written(made, apart=apart).parts
        assert [each.part for each in parts] == [each.prompt.part.id for each in made.parts]
        assert all(each.lost for each in parts if not each.how)
        refused = {each.part for each in parts if not each.how}
        assert refused == ({"g", "h", "j"} if apart else {"g", "h", "j", "k"})


def test_a_grade_that_moodle_does_not_have_is_the_nearest_below():
    odd = of("X12.5", scheme=Scheme(mistaken=0.22))
    found = [each for each in questions(odd, apart=True) if each.get("type") == "numerical"]
    assert {float(each.get("fraction", "")) for each in found[0].iter("answer")} == {100.0, 50.0, 20.0}
    assert any("22 %" in each and "20 %" in each for each in written(odd, apart=True).lost)
    assert not any("22 %" in each for each in written(odd).lost)


def test_the_rule_for_decimals_is_in_the_language_of_the_question():
    with language("de"):
        (_, question) = questions(of("X12.5"))
    assert "Dezimalkomma" in text(question)
    assert "decimal point" in text(questions(of("X12.5"))[1])


# Moodle 4 and 5, question/type/multianswer/questiontype.php: what it takes for a field, and for the parts of an alternative.
FRACTION, ANSWER, REMARK = (
    r"=|%(?:-?[0-9]+(?:[.,][0-9]*)?)%",
    r".+?(?<!\\|&)(?=[~#}]|$)",
    r".*?(?<!\\)(?=[~}]|$)",
)
ONE = rf"({FRACTION})?(?P<answer>{ANSWER})(?:#(?P<remark>{REMARK}))?"
MORE = rf"(?:{FRACTION})?(?:{ANSWER})(?:#(?:{REMARK}))?"
EMBEDDED = re.compile(
    rf"\{{\s*([0-9]*)\s*:\s*(NUMERICAL|NM|MULTICHOICE|MCV|MC|SA)\s*:(?P<all>{MORE}(?:~{MORE})*)\}}"
)
NASTY = 'a {b} ~ c = d # e "f" / g \\ h %50% {1:NM:=2} {#1} & {:SA:=x}'


def test_moodle_finds_our_fields_and_no_others_whatever_the_texts_hold():
    """Statement, title, option and feedback have every sign that means something to Moodle's parser, as code."""
    made, literal = of("X12.11"), f"`{NASTY}`"
    parts = [each for each in made.parts if isinstance(each, NumbersAsked | ChoiceAsked)]
    (choice,) = (each for each in parts if isinstance(each, ChoiceAsked))
    first, *others = choice.options
    nasty = replace(first, option=replace(first.option, text=literal), feedback=literal)
    asked = replace(choice, options=(nasty, *others))
    exercise = replace(made.exercise, statement=literal)
    item_of = replace(
        made, exercise=exercise, parts=tuple(asked if each is choice else each for each in made.parts)
    )
    (_, question) = questions(item_of)
    whole = text(question)
    assert NASTY in html.unescape(whole)
    assert not re.search(r"\{#\d", whole)
    found = list(EMBEDDED.finditer(whole))
    assert len(found) == sum(len(each.components) if isinstance(each, NumbersAsked) else 1 for each in parts)
    (field,) = (each for each in found if each[2] == "MCV")
    alternatives = list(re.finditer(rf"~?{ONE}", field["all"]))
    assert len(alternatives) == len(asked.options)
    shown = alternatives[0]
    assert [html.unescape(html.unescape(shown[name])) for name in ("answer", "remark")] == 2 * [
        f"<code>{NASTY}</code>"
    ]
