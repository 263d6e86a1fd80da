"""A letter means what it meant on the student's own sheet: the option, and the given, whatever they are called today."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from corollary.course.generate import generate
from corollary.formula.value import Text
from corollary.grading.judge import judge
from corollary.grading.key import Key
from corollary.grading.points import grade
from corollary.grading.solutions import Solutions
from corollary.notebook.worksheet import exercise
from corollary.problem.bank import Bank
from corollary.problem.part import Option
from corollary.problem.problem_set import ProblemSet, find_set
from corollary.problem.roster import Student
from corollary.records.assignments import open_record, pending, read_assigned, save_record, settle
from corollary.records.editions import letters_now
from corollary.records.files import open_course

PROBLEM = """\
---
code: X1.1
title: A ball
given:
  m: {is: its mass, value: 0.5, from: 0.3, to: 0.9, step: 0.01, unit: kg}
  v: {is: its speed, value: 20, from: 8, to: 35, step: 0.5, unit: m/s}
---
A ball of mass $m$ = {{m}} moves at {{v}}.

## Energy {#a .expression unit="J" points=1}
What is its energy?

## Twice as fast {#b .choice points=1}
What is doubled, if the speed of {{v}} is?
- (a) the momentum
- (b) the energy
- (c) nothing
"""
SOLUTION = """\
from corollary.author import choice, derivation, step, unknowns
from corollary.laws import law


def derive(m, v):
    (K,) = unknowns("K")
    return derivation(
        step(K, "It is so.", law("Energy", "K = m*v^2/2", K=K, m=m, v=v), answers="a"),
        choice("b", "Momentum goes with the speed.", a=True, b=False, c=False,
               mistakes={"b": "That is four times as much."}),
    )
"""
REORDERED = (
    "- (a) the momentum\n- (b) the energy\n- (c) nothing",
    "- (a) nothing\n- (b) the momentum\n- (c) the energy",
)


class Class:
    """Ada has the sheet of before; whatever is edited afterwards."""

    def __init__(self, folder: Path) -> None:
        self.bank = Bank(folder / "bank")
        self.course = folder / "course"
        for step, text in (("problems", PROBLEM), ("solutions", SOLUTION)):
            place = self.bank.folder / step / "topic"
            place.mkdir(parents=True)
            (place / f"ball.{'md' if step == 'problems' else 'py'}").write_text(text)
        self.bank.sets.mkdir()
        (self.bank.sets / "week.md").write_text("---\ntitle: A week\nproblems:\n  - X1.1\n---\n")
        generate(self.course, self.problem_set, [Student("ada")], Solutions(self.bank))

    @property
    def problem_set(self) -> ProblemSet:
        return find_set(self.bank, "week")

    def edit(self, problem: tuple[tuple[str, str], ...], solution: tuple[tuple[str, str], ...]) -> None:
        for name, pairs in (("problems/topic/ball.md", problem), ("solutions/topic/ball.py", solution)):
            path = self.bank.folder / name
            text = path.read_text()
            for old, new in pairs:
                assert old in text, old
                text = text.replace(old, new)
            path.write_text(text)

    @property
    def key(self) -> Key:
        sheet = read_assigned(open_course(self.course), self.problem_set)["ada"]
        return Solutions(self.bank).key(sheet.variants[0])

    def verdicts(self, **answers: str) -> dict[str, tuple[str, str]]:
        """The verdict on each, and how it was read."""
        key = self.key
        judged = judge(key, {part: Text(text) for part, text in answers.items()})
        return {part.part.id: (type(part.verdict).__name__, part.answer) for part in grade(key, judged).parts}


@pytest.fixture
def ball(tmp_path: Path) -> Class:
    return Class(tmp_path)


def test_options_in_another_order_are_those_of_the_students_own_sheet(ball: Class) -> None:
    before = exercise(ball.key.variant).prompts[1].options
    ball.edit((REORDERED,), (("a=True, b=False, c=False", "a=False, b=True, c=False"), ('{"b":', '{"c":')))
    assert ball.verdicts(b="a")["b"] == ("Right", "(A)")
    assert ball.verdicts(b="b")["b"] == ("Mistaken", "(B)")
    assert ball.verdicts(b="c")["b"] == ("Wrong", "(C)")
    assert exercise(ball.key.variant).prompts[1].options == before, "shown as it was handed out"
    revealed = grade(ball.key, judge(ball.key, {"b": Text("c")}), reveal=True)["b"].feedback
    assert "The answer is (A)." in revealed
    assert "**(A)** Momentum goes" in Solutions(ball.bank).worked_solution_of(ball.key)


def test_where_the_right_option_is_not_on_the_sheet_a_person_decides(ball: Class) -> None:
    ball.edit(
        (("- (c) nothing", "- (c) nothing\n- (d) the wavelength\n- (e) the momentum and the wavelength"),),
        (("a=True, b=False, c=False", "a=False, b=False, c=False, d=False, e=True"),),
    )
    assert ball.verdicts(b="a")["b"][0] == "Unmarked"
    revealed = grade(ball.key, judge(ball.key, {"b": Text("c")}), reveal=True)["b"].feedback
    assert "The answer" not in revealed


@pytest.mark.parametrize(
    ("today", "now"),
    [
        ("xyz", "abc"),
        ("zxy", "bca"),
        ("xqz", "abc"),  # one reworded in its place
        ("qzx", "cab"),  # one reworded and moved: the only one left
        ("xz", "a-b"),
        ("pqr", "abc"),
    ],
)
def test_options_are_known_by_their_words(today: str, now: str) -> None:
    before = [Option(letter, f"the option {word}") for letter, word in zip("abc", "xyz", strict=True)]
    others = [Option(letter, f"the  option\n{word}") for letter, word in zip("abc", today, strict=False)]
    assert "".join(letter or "-" for _, letter in letters_now(before, others)) == now


def renamed(ball: Class, *more: tuple[str, str]) -> None:
    """m is called M from now on, and somebody has said so."""
    ball.edit(
        (("  m: {", "  M: {"), ("$m$ = {{m}}", "$M$ = {{M}}"), *more),
        (("derive(m, v)", "derive(M, v)"), ("m*v^2/2", "M*v^2/2"), ("m=m", "M=M")),
    )
    course, problem_set = open_course(ball.course), ball.problem_set
    record = open_record(course, problem_set)
    for renames in pending(course, problem_set, record):
        settle(record, renames, agreed=True)
    save_record(course, problem_set, record)


def test_a_formula_in_the_letters_of_the_sheet_means_the_givens_of_today(ball: Class) -> None:
    words, before = exercise(ball.key.variant).statement, ball.key.variant.exact["m"]
    renamed(ball)
    key = ball.key
    assert (exercise(key.variant).statement, key.variant.exact["M"]) == (words, before)
    assert ball.verdicts(a="m*v^2/2")["a"] == ("Right", "m*v^2/2")
    assert ball.verdicts(a="m*v^2")["a"][0] in {"Wrong", "Slip"}
    assert ball.verdicts(a="M*v^2/2")["a"][0] == "Unread", "there is no M on this sheet"
    assert "`m` (its mass)" in exercise(key.variant).prompts[0].text


def test_a_letter_that_means_another_given_today_means_what_it_did(ball: Class) -> None:
    """m became M, and a new given is called m: the sheet's m is today's M."""
    words = exercise(ball.key.variant).statement
    renamed(ball)
    record = json.loads((ball.course / ".corollary/assigned/week.json").read_text())
    assert record["editions"][0]["renamed"]["givens"] == {"m": "M"}
    path = ball.bank.folder / "problems/topic/ball.md"
    text = path.read_text()
    path.write_text(text.replace("  v: {", "  m: {is: its length, value: 7, unit: m}\n  v: {"))
    ball.edit((), (("derive(M, v)", "derive(M, m, v)"),))
    assert exercise(ball.key.variant).statement == words
    assert ball.verdicts(a="m*v^2/2")["a"] == ("Right", "m*v^2/2")
