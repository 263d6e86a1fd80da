"""Feedback to a wrong answer: it says something to think about, and nothing of the key: no value, no formula, no factor."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from dataclasses import replace

import pytest
from tests.chapter_problems import PROBLEMS

from corollary.answers.verdict import Mistaken, Slip, Wrong
from corollary.formula.plain_text import text
from corollary.grading.advice import advice
from corollary.grading.from_json import from_json
from corollary.grading.judge import judge
from corollary.grading.key import Key, make_key
from corollary.grading.points import grade
from corollary.grading.solutions import Solutions
from corollary.practice.practice import Posed
from corollary.problem.bank import chapter_bank, find
from corollary.problem.sampling import draws
from corollary.problem.variant import chapter, chosen

BANK = chapter_bank()
SOLUTIONS = Solutions(BANK)
SOURCE = re.compile(
    r"\((?:section |example )?12\.[\d.]*\d\)?(?:-\(?12\.\d+\))?"
)  # numbers of the chapter's equations
NUMBER = re.compile(r"\d+(?:[.,]\d+)?(?:e[+-]?\d+)?")
FACTORS = re.compile(r"\b(twice too|half as|double|factor (of )?\d|times too|\d+ times|√2|3\.6)\b")
WRONG = (1.37, 0.61, 7.3, -3.3)
OFF = (-1.0, 2.0, 0.5, 10.0, 0.1, 1000.0, 0.001, 3.6)


def key_of(code: str) -> Key:
    problem = find(BANK, code)
    for student in range(20):
        try:
            return make_key(SOLUTIONS.of(problem), next(draws(problem, b"advice", str(student))))
        except ArithmeticError:
            continue
    raise AssertionError(code)


def feedback(key: Key, answers: dict[str, object]) -> Iterator[tuple[str, object, str]]:
    judged = judge(key, {part: from_json(value) for part, value in answers.items()})
    for part in grade(key, judged).parts:
        if part.part.id in answers:
            yield part.part.id, part.verdict, part.feedback


def bent(key: Key, factor: float) -> dict[str, object]:
    """Every number of the key, taken so many times."""
    found: dict[str, object] = {}
    for part in key.variant.problem.parts:
        if part.id in key.truths and "expression" not in part.answer_types:
            values = [factor * value / part.unit.si for value in key.truths[part.id].values]
            found[part.id] = values if len(values) > 1 else values[0]
    return found


def leaks(key: Key, part: str, said: str, answer: object) -> list[str]:
    """What the key holds and the text says."""
    words = SOURCE.sub("", said)
    for given in key.variant.problem.givens:
        words = words.replace(given.meaning, "")
    own = answer if isinstance(answer, list) else [answer]
    unit = key.variant.problem.part(part).unit.si
    values = [value / size for value in key.truths[part].values if value for size in (1.0, unit)]
    numbers = [float(each.replace(",", ".")) for each in NUMBER.findall(words)]
    given = [abs(value / size) for value in key.variant.si.values() for size in (1.0, 1e-3, 1e3)]
    shown = [
        f"{number}"
        for number in numbers
        if any(math.isclose(number, abs(value), rel_tol=0.02) for value in values)
        and not any(math.isclose(number, abs(each), rel_tol=1e-3) for each in own if isinstance(each, float))
        and not any(math.isclose(number, each, rel_tol=1e-9) for each in given)
    ]
    find = key.solution.answer(part)
    trees = [*getattr(find.local, "trees", ()), *(find.in_givens or ())] if find is not None else []
    formulas = [formula for tree in trees if len(formula := text(tree)) > 3 and formula in words]
    return [*shown, *formulas, *(found[0] for found in FACTORS.finditer(words)), *re.findall(r"[=$]", words)]


@pytest.mark.whole
@pytest.mark.parametrize("code", [problem.code for problem in PROBLEMS if problem.givens])
def test_nothing_of_the_key_is_told_to_a_wrong_answer(code):
    key = key_of(code)
    for factor in WRONG + OFF:
        answers = bent(key, factor)
        for part, verdict, said in feedback(key, answers):
            if isinstance(verdict, Wrong | Slip):
                assert not leaks(key, part, said, answers[part]), (part, said)
            if isinstance(
                verdict, Wrong
            ):  # of a count that no given enters every check would be passed by the same mistake
                assert "A check: " in said or (key.truths[part].counted and "none of the given" in said)


@pytest.mark.parametrize(
    ("code", "part", "answer", "words"),
    [
        (
            "X12.5",
            "d",
            77.7,
            ("Mean force", "the speed of the incoming ball", "the time of contact", "A check"),
        ),
        ("X12.10", "a", 12.345, ("Conservation of momentum", "Newton's second law", "the sliding distance")),
        (
            "X12.8",
            "b",
            0.77,
            ("Conservation of momentum", "your mass without the snowball", "your answer in (a)"),
        ),
        (
            "X12.1",
            "b",
            3.33,
            ("Conservation of mechanical energy", "type your answer as a formula of `v`, `M`, `m`"),
        ),
        ("P12.14", "i", [0.1, 0.2, 0.3], ("halve the step",)),
        ("X12.1", "a", "v/7", ("the speed of the club", "with `2*v` in place of `v`")),
        ("S12.5nc", "b", "14 deg", ("none of the given numbers", "another value of `v0`")),
    ],
)
def test_it_names_the_laws_the_quantities_and_a_check(code, part, answer, words):
    problem = find(BANK, code)
    ((_, verdict, said),) = feedback(make_key(SOLUTIONS.of(problem), chapter(problem)), {part: answer})
    assert isinstance(verdict, Wrong)
    for word in words:
        assert word in said
    assert "the your" not in said


def test_a_wrong_choice_is_told_what_to_ask_of_each_option():
    key = key_of("X12.9")
    options = {option.letter for option in key.variant.problem.part("a").options} - {key.choices["a"]}
    for letter in options:
        ((_, verdict, said),) = feedback(key, {"a": letter})
        assert isinstance(verdict, Wrong | Mistaken)
        assert len(said.split()) > 6


def test_an_angle_answered_in_degrees_is_told_in_degrees():
    key = key_of("E12.3.2")
    degrees = f"{math.degrees(key.truths['c3'].values[0]):.4g}"[:4]
    for answer, sign in (("7 deg", "°"), ("7°", "°"), (3.1, "rad")):
        judged = judge(key, {"c3": from_json(answer)})
        said = next(part.feedback for part in grade(key, judged, reveal=True).parts if part.part.id == "c3")
        assert said.endswith(f"{sign}."), said
        assert (degrees in said) == (sign == "°"), said


def test_advice_names_no_answer_that_a_set_leaves_out():
    key = key_of("X12.8")
    (part,) = (each for each in key.variant.problem.parts if each.id == "c")
    assert "your answer in (b)" in " ".join(advice(key, part))
    problem = replace(key.variant.problem, parts=(part,), written=key.variant.problem)
    alone = " ".join(advice(replace(key, variant=replace(key.variant, problem=problem)), part))
    assert "your answer in (" not in alone
    assert "mass of the snowball" in alone


def told(key: Key, part: str, answer: object, wrong_before: int | None) -> str:
    judged = judge(key, {part: from_json(answer)})
    return grade(key, judged, wrong_before=wrong_before)[part].feedback


def test_one_wrong_answer_after_the_other_is_told_the_law_what_counts_and_a_check():
    key = key_of("X12.5")
    first, second, third, fourth = (told(key, "d", 77.7, count) for count in range(4))
    assert "Think of: Change of momentum" in first
    assert "(12.29); Mean force (12.22), in “Momentum, Impulse, and Collisions”." in first
    assert "The answer depends on: the mass of the ball" in second
    assert "A check: type your answer as a formula of `m`, `v`, `w`, `dt`" in third
    assert fourth == third
    assert [
        ("Think of" in each, "The answer depends on" in each, "A check" in each)
        for each in (first, second, third)
    ] == [
        (True, False, False),
        (False, True, False),
        (False, False, True),
    ]
    whole = told(key, "d", 77.7, None)  # of work that is handed in once
    assert all(words in whole for words in ("Think of", "The answer depends on", "A check"))


@pytest.mark.parametrize(
    "code",
    [
        pytest.param(problem.code, marks=[pytest.mark.whole] if problem.topic == "projects" else [])
        for problem in PROBLEMS
        if problem.givens
    ],
)
def test_what_counts_is_what_the_answer_depends_on(code):
    """A given that is named changes the answer: by the keys of other numbers, one given moved along its grid."""
    key = key_of(code)
    problem = key.variant.problem
    for part in problem.parts:
        find = key.solution.answer(part.id)
        if part.id not in key.truths or find is None or find.in_givens is None:
            continue
        counts = next((each for each in advice(key, part) if each.startswith("The answer depends on")), "")
        for given in problem.givens:
            if re.search(rf"[:;] (?:the )?{re.escape(given.meaning)}[;.]", counts) and given.grid.count > 1:
                others = [moved(key, given.symbol, step) for step in (1, -1, 7, -7, 20)]
                truths = [other.truths[part.id].values for other in others if other is not None]
                assert not truths or any(
                    math.dist(each, key.truths[part.id].values) > 1e-9 * math.hypot(*each) for each in truths
                ), (part.id, given.symbol)
        assert "do the units of all" not in " ".join(advice(key, part))


def moved(key: Key, symbol: str, steps: int) -> Key | None:
    """The key with one given so many steps along its grid; none where that has no answer."""
    problem, grid = key.variant.problem, key.variant.problem.given(symbol).grid
    value = key.variant.values[symbol] + steps * grid.step
    if not min(grid.first, grid.last) <= value <= max(grid.first, grid.last):
        return None
    try:
        return make_key(key.solution, chosen(problem, {**key.variant.values, symbol: value}))
    except (ArithmeticError, ValueError):
        return None


@pytest.mark.parametrize("code", [problem.code for problem in PROBLEMS if problem.givens])
def test_the_check_can_be_typed(code):
    """The letters that it names are read, and a formula of them that is right is read without a complaint."""
    posed = Posed(key_of(code))
    for part in posed.exercise.problem.parts:
        *_others, check = advice(posed.key, part) or ("",)
        if "as a formula of" not in check:
            continue
        letters = re.findall(r"`(\w+)`", check)
        find = posed.key.solution.answer(part.id)
        assert find is not None
        assert {*letters} <= {given.symbol for given in posed.exercise.problem.givens}
        if find.in_givens is not None and not part.rows:
            formulas = [text(tree) for tree in find.in_givens]
            typed = [posed.preview(part.id, formulas[0] if len(formulas) == 1 else formulas)]
            assert all(each.ok for each in typed), (part.id, formulas, typed)


@pytest.mark.parametrize(
    ("code", "part", "answer"),
    [("S12.7", "b", "4.00"), ("E12.5.1", "c", "2.50"), ("S12.7", "b", "4.20"), ("X12.10", "a", "21.4")],
)
def test_more_figures_are_asked_for_only_where_the_formula_was_right(code, part, answer):
    """4.00 is what is left of 4.08 without the small term dm*dv."""
    key = make_key(SOLUTIONS.of(find(BANK, code)), chapter(find(BANK, code)))
    said = told(key, part, answer, None)
    assert said.startswith("Close, but rounding does not explain it")
    assert "carry four figures" not in said


@pytest.mark.parametrize(
    ("code", "part", "answer"),
    [
        ("E12.5.1", "b", "-285"),  # with 2.4 m/s and 240 m/s for 2.425 and 244.9
        ("S12.2", "b", "12.65"),  # the root of 160, for 10² + 7.5² = 156.25
        ("X12.12", "a0", "4.5"),  # the root of 20, for 2·9.8·1
    ],
)
def test_more_figures_are_asked_for_where_too_few_were_carried(code, part, answer):
    key = make_key(SOLUTIONS.of(find(BANK, code)), chapter(find(BANK, code)))
    assert told(key, part, answer, None).startswith(
        "Close: carry four figures on the way and round at the end."
    )


def test_a_formula_that_is_wrong_is_put_to_the_test_with_the_students_own_numbers():
    key = make_key(SOLUTIONS.of(find(BANK, "X12.1")), chapter(find(BANK, "X12.1")))
    assert told(key, "a", "M*v/(m+M)", 0).startswith(
        "With `v` = 40 m/s, `M` = 200 g, `m` = 46 g your formula gives 32.52 m/s; the laws give another value."
    )
    assert "V is not among the letters here (M, m, r, v); did you mean v?" in told(key, "a", "2*V", 0)


@pytest.mark.parametrize(
    ("code", "part", "answer", "words"),
    [
        ("X12.5", "a", "-0.84 or 0.84 kg m/s", "These are two answers; write the one that you mean."),
        ("X12.2", "b", [1, 0, 1, 0], "With 0 for `v1` and `v2` a law has no value; choose another number."),
        ("S12.4", "b", 16.15, "A number of this size cannot be right here: look at what is divided by what."),
        ("S12.5el", "c", "1", "Rounded too far to tell: give three significant figures."),
        ("E12.7.1", "a", "3 N", "Newton's second law for a changing mass"),
        ("X12.5", "c", "86000 mn", "mn can be mN or MN"),
    ],
)
def test_it_says_what_is_wrong_in_words_of_the_question(code, part, answer, words):
    key = make_key(SOLUTIONS.of(find(BANK, code)), chapter(find(BANK, code)))
    assert words in told(key, part, answer, None)


def test_a_count_that_no_given_enters_has_no_check_that_cannot_fail():
    """Who counts wrongly counts the same with other numbers."""
    key = key_of("S12.5nc")
    sentences = advice(key, key.variant.problem.part("e"))
    assert any("depends on none of the given numbers" in each for each in sentences)
    assert not any("A check" in each for each in sentences)
