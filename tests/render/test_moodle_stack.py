"""A formula as a STACK question: Maxima's words, one comparison after the other, beside the questions that every Moodle takes."""

from __future__ import annotations

from xml.etree import ElementTree as Xml

import pytest

from corollary.formula.syntax import author_formula
from corollary.grading.solutions import Solutions
from corollary.problem.bank import chapter_bank, home
from corollary.problem.problem_set import Scheme
from corollary.problem.variant import at
from corollary.render.exports import target
from corollary.render.lms_item import item
from corollary.render.targets.moodle_stack import NotInStack, stack_formula

LETTERS = list("mvghxylaFe")
SOLUTIONS = Solutions(chapter_bank())


def written(to: str, variants: int = 1):
    made = target(to).items
    assert made is not None
    problem = home(None, "X12.1")[1]
    items = [
        item(SOLUTIONS, at(problem, 40 * n), n, 1.0, Scheme(mistaken=0.3)) for n in range(1, variants + 1)
    ]
    return made("few", items, False)


def stack_of(made) -> list[Xml.Element]:
    (content,) = made.files.values()
    return [each for each in Xml.fromstring(content) if each.get("type") == "stack"]


def test_the_other_questions_are_those_of_every_moodle():
    plain, made = written("moodle", 2), written("moodle-stack", 2)
    assert list(made.files) == ["few-moodle-stack.xml"]
    (before,), (after,) = plain.files.values(), made.files.values()
    assert after.startswith(before.removesuffix(b"</quiz>\n"))
    assert len(stack_of(made)) == 2
    names = {each.findtext("name/text") for each in stack_of(made)}
    assert names == {"X12.1 Golf ball, (a), 1", "X12.1 Golf ball, (a), 2"}


def test_the_part_is_carried_and_says_what_is_lost():
    (before,), (after,) = (
        [each for each in written(to).parts if each.part == "a"] for to in ("moodle", "moodle-stack")
    )
    assert (before.how, after.how) == ("", "STACK")
    assert "moodle-stack" in before.lost
    assert "dimension" in after.lost


def test_right_comes_first_then_what_misconceptions_give_then_slips():
    (question,) = stack_of(written("moodle-stack"))
    variables = (question.findtext("questionvariables/text") or "").splitlines()
    assert variables[:5] == [
        "ta1: 2*v;",
        "ta2: v;",
        "ta3: M*v/m;",
        "ta4: v*sqrt(M/m);",
        "ta5: 2*M*v/(M + m);",
    ]
    assert "ta6: -1*(2*v);" in variables or "ta6: (-1)*(2*v);" in variables
    nodes = question.findall("prt/node")
    shares = [float(each.findtext("truescore") or "") for each in nodes]
    assert shares[:6] == [1.0, 0.3, 0.3, 0.3, 0.3, 0.5]
    following = [int(each.findtext("falsenextnode") or "") for each in nodes]
    assert following == [*range(1, len(nodes)), -1]
    assert all(each.findtext("truefeedback/text") for each in nodes[1:])
    assert question.findtext("assumepositive") == "1"
    words = question.findtext("questiontext/text") or ""
    assert "[[input:ans1]]" in words
    assert all(f"<code>{letter}</code>" in words for letter in "vMmr")  # nor which of them the answer has


@pytest.mark.parametrize(
    ("formula", "maxima"),
    [
        ("0.5*m*v^2", "(1/2)*m*v^2"),
        ("sqrt(2*g*h)", "sqrt(2*g*h)"),
        ("log10(x)/ln(y)", "lg(x)/ln(y)"),
        ("2*pi*sqrt(l/g)", "2*pi*sqrt(l/g)"),
    ],
)
def test_formulas_in_maximas_words(formula, maxima):
    assert stack_formula(author_formula(formula, LETTERS)) == maxima


@pytest.mark.parametrize(
    ("formula", "why"),
    [("m*e", "the letter e"), ("atan2(y, x)", "no function atan2"), ("F - m*abs(e)", "the letter e")],
)
def test_what_stack_cannot_hold_is_said(formula, why):
    with pytest.raises(NotInStack, match=why):
        stack_formula(author_formula(formula, LETTERS))
