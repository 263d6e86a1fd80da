"""Hints: the next step on the shortest way, in the words of laws; never a value, never the formula that is asked for."""

from __future__ import annotations

from dataclasses import replace
from itertools import combinations, permutations

import pytest
import sympy
from tests.chapter_problems import PROBLEMS

from corollary.derive.solution import ClosedForms
from corollary.formula.ast import names
from corollary.formula.latex import latex
from corollary.formula.numerals import decimal_text
from corollary.formula.to_sympy import expression
from corollary.grading.solutions import Solutions
from corollary.practice.hints import Fork, hints, hints_by_known, remaining
from corollary.problem.bank import chapter_bank
from corollary.problem.variant import chapter

BANK = chapter_bank()
SOLUTIONS = Solutions(BANK)
SOME = ("X12.5", "X12.8", "X12.13", "E12.3.1s", "S12.5el", "X12.2")
CODES = [
    pytest.param(problem.code, marks=() if problem.code in SOME else (pytest.mark.whole,))
    for problem in PROBLEMS
]


def key(code: str):
    return SOLUTIONS.key(chapter(BANK[code]))


def told(code: str, part: str, *right: str) -> tuple[str, ...]:
    of = key(code)
    return hints(of, of.variant.problem.part(part), frozenset(right))


def test_the_first_hint_is_the_next_step():
    """A kick: the change of momentum is the impulse, and divided by the time it is the mean force."""
    assert (
        told("X12.5", "c")[0]
        == "First find the answer to (a): Change of momentum. After that, 2 steps to go."
    )
    assert told("X12.5", "c", "a")[0].startswith("First find the answer to (b)")
    assert told("X12.5", "c", "a", "b")[0] == "One step is left, and it starts from your answer in (b)."
    assert "Change of momentum" in told("X12.5", "a")[1]
    assert r"\Delta p = m\, v_{1} - m\, v_{0}" in told("X12.5", "a")[2]


def test_hints_lead_as_far_as_the_step_that_decides():
    """The mean force with nothing found yet: change of momentum, impulse, and then the force itself."""
    found = told("X12.5", "c")
    places = [
        next(at for at, text in enumerate(found) if name in text)
        for name in ("Change of momentum", "(b)", "last step")
    ]
    assert places == sorted(places)
    assert "Mean force" in found[places[-1] + 1]
    assert found[places[-1] + 1 :] == told("X12.5", "c", "a", "b")[1:]


def test_an_authors_own_hint_comes_first():
    of = key("X12.5")
    part = replace(of.variant.problem.part("a"), hint="Draw the ball before and after.")
    assert hints(of, part, frozenset()) == ("Draw the ball before and after.", *told("X12.5", "a"))


def test_a_way_that_the_author_did_not_take_counts_too():
    """Part d of a kick needs no earlier answer, but one who has the mean force of part c may start from it."""
    of = key("X12.8")
    asked = of.solution.answer("c2")
    assert asked is not None
    assert len(remaining(of.solution, asked, frozenset()).steps) > 1
    assert remaining(of.solution, asked, frozenset({"a"})).steps == (asked,)
    assert told("X12.8", "c2", "a")[0] == "One step is left, and it starts from your answer in (a)."


def test_what_no_law_says_is_told_by_what_counts_and_a_check():
    """An impulse is the integral of the force, the answer itself; still there is more to say than that one step is left."""
    found = told("S12.3", "a")
    assert len(found) == 2
    assert "The answer depends on: the largest force; the time of contact" in found[1]


@pytest.mark.parametrize("code", CODES)
def test_hints_are_the_same_whichever_parts_are_known(code):
    """The tree that goes out with a page of files and the hints that the program behind a page tells."""
    of = key(code)
    parts = [part.id for part in of.variant.problem.parts]
    some = [
        frozenset(each)
        for count in (0, 1, 2, len(parts) - 1, len(parts))
        for each in combinations(parts, count)
    ]
    for part in of.variant.problem.parts:
        tree = hints_by_known(of, part)
        for right in some:
            found = tree
            while isinstance(found, Fork):
                found = found.known if found.part in right else found.unknown
            assert found == hints(of, part, right - {part.id}), (part.id, right)


@pytest.mark.parametrize("code", CODES)
def test_the_last_hint_says_more_than_that_a_step_is_left(code):
    of = key(code)
    for part in of.variant.problem.parts:
        if of.solution.answer(part.id) is not None:
            assert not hints(of, part, frozenset())[-1].startswith(("One step", "Now the last step"))


def test_an_equation_that_is_the_answer_itself_is_not_shown():
    """The mass that hangs is its share of the chain, mu = m*y/L: the law's only equation is the answer."""
    before_the_next = told("X12.13", "a")[:3]
    assert "Even chain" in before_the_next[1]
    assert not any("$$" in each for each in before_the_next)


@pytest.mark.parametrize("code", CODES)
def test_no_hint_gives_the_answer_away(code):
    of = key(code)
    order = [part.id for part in of.variant.problem.parts]
    for part in of.variant.problem.parts:
        for right in (frozenset[str](), frozenset(order[: order.index(part.id)])):
            text = "\n".join(hints(of, part, right))
            truth, asked = of.truths.get(part.id), of.solution.answer(part.id)
            if truth is None or asked is None:
                continue
            for value in truth.values:
                for figures in range(3, 7):
                    number = decimal_text(abs(value) / part.unit.si, figures)
                    assert len(number.replace(".", "").strip("0")) < 2 or number not in text, (part.id, text)
            formulas = [
                *(asked.local.trees if isinstance(asked.local, ClosedForms) else ()),
                *(asked.in_givens or ()),
            ]
            for tree in formulas:
                if len(names(tree)) > 1:
                    assert f"= {latex(tree)}$" not in text, (part.id, text)
                for law in asked.laws:
                    if f"$${latex(law.textbook)}$$" in text:
                        assert not is_the_same(law.textbook.right, tree), (part.id, text)


def is_the_same(side, answer) -> bool:
    """Whether two formulas are one when the letters of the first are called as those of the second, by sympy."""
    mine, theirs = sorted(names(side) - {"pi"}), sorted(names(answer) - {"pi"})
    if len(mine) != len(theirs) or not 1 < len(mine) < 5:
        return False
    symbols = {name: sympy.Symbol(name, positive=True) for name in {*mine, *theirs}}
    first, second = expression(side, symbols), expression(answer, symbols)
    return any(
        sympy.expand(
            first.subs({symbols[a]: symbols[b] for a, b in zip(mine, order, strict=True)}, simultaneous=True)
            - second
        )
        == 0
        for order in permutations(theirs)
    )
