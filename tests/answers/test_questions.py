"""Questions made of parts, and headings that do not fit their answer type."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import pytest

from corollary.answers.question import Question
from corollary.answers.questions import checked, question_of
from corollary.problem.diagnostic import Malformed
from corollary.problem.problem import Problem
from corollary.problem.reader import read_problem

FRONT = """---
code: X1.1
title: A cart
given:
  m: {is: mass, value: 0.5, from: 0.1, to: 0.9, step: 0.1, unit: kg}
---
"""


@pytest.fixture
def problem(tmp_path: Path) -> Callable[[str], Problem]:
    def put(body: str) -> Problem:
        path = tmp_path / "cart.md"
        path.write_text(f"{FRONT}{{{{m}}}}\n\n{body}\n", encoding="utf-8")
        return read_problem(path)

    return put


@pytest.mark.parametrize(
    ("heading", "words"),
    [
        ("## A {#a}", "has no kind of answer"),
        ("## A {#a .number}", "needs one kind"),
        ("## A {#a .value .choice}", "needs one kind"),
        ("## A {#a .vector}", "name its components"),
        (
            '## A {#a .value components="x y"}',
            "only .vector, .interval, .list, .expression, .example and .proof parts have components",
        ),
        ("## A {#a .code}", "function="),
        ('## A {#a .code function="f"}', "function="),
        ('## A {#a .value function="f(x)"}', "function="),
        ("## A {#a .choice}", "list options"),
        ("## A {#a .choice}\n- (a) one", "list options"),
        ("## A {#a .value}\n- (a) one", "list options"),
        ("## A {#a .plot .value}", "needs one kind"),
        ('## A {#a .explain tolerance="5 %" because="so"}', "asks for no quantity; leave tolerance="),
        ('## A {#a .expression plausible="1 to 2"}', "asks for no quantity"),
    ],
)
def test_a_heading_that_does_not_fit_its_answer_type(
    problem: Callable[[str], Problem], heading: str, words: str
):
    with pytest.raises(Malformed) as raised:
        checked(problem(heading))
    (complaint,) = raised.value.complaints
    assert complaint.line == 9
    assert words in complaint.sentence


def test_what_is_known_is_named(problem: Callable[[str], Problem]):
    with pytest.raises(
        Malformed,
        match=r"cart\.md:9: part a needs one kind of \.value, \.integer, \.vector, \.interval, ",
    ):
        checked(problem("## A {#a .number}"))


@pytest.mark.parametrize(
    "heading",
    [
        '## A {#a .plot .code function="f(t, m)"}',
        '## A {#a .vector components="x y" unit="m/s"}',
        "## A {#a .choice}\n- (a) one\n- (b) two",
        '## A {#a .proof components="p"}',
    ],
)
def test_a_question_is_the_same_when_it_was_written_as_data(problem: Callable[[str], Problem], heading: str):
    found = checked(problem(heading))
    question = question_of(found, found.part("a"))
    assert Question.from_data(json.loads(json.dumps(question.as_data()))) == question
    assert question.name == "X1_1_a"
    assert question.symbol_names == ["m"]


def test_a_function_has_a_name_and_arguments(problem: Callable[[str], Problem]):
    found = problem('## A {#a .code function="force( t,m )"}')
    question = question_of(found, found.part("a"))
    assert (question.function, question.arguments) == ("force", ("t", "m"))
