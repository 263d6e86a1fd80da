"""Somebody else's numbers in an answer are found, chance is stated, and honest mistakes are not accused."""

from __future__ import annotations

import pytest

from corollary.grading.solutions import Solutions
from corollary.problem.bank import Bank, chapter_bank
from corollary.problem.problem_set import find_set
from corollary.problem.variant import at
from corollary.records.assignments import AssignedSheet
from corollary.records.collusion import find_shared
from corollary.records.marks import HandedIn, PartRecord, Record

SOLUTIONS = Solutions(chapter_bank())
SET = find_set(SOLUTIONS.bank, "momentum_1")
CODES = ("X12.5", "X12.10")
ASSIGNED = {
    f"s{number}": AssignedSheet(
        tuple(at(problem, 40000 + 7919 * number) for problem in SET.problems if problem.code in CODES), ""
    )
    for number in range(20)
}


def truth(student: str, code: str, part: str) -> float:
    variant = next(each for each in ASSIGNED[student].variants if each.problem.code == code)
    return SOLUTIONS.key(variant).truths[part].values[0]


def record(**answers: tuple[str, str]) -> Record:
    parts = {name: PartRecord(verdict, 0.0, 1.0, answer) for name, (verdict, answer) in answers.items()}
    return Record(0.0, 1.0, parts, "", HandedIn("s7", "s7", 0.0, 1.0), ())


def test_a_copied_answer_is_found_with_its_owner() -> None:
    copied = f"{truth('s3', 'X12.5', 'd'):.4g} N"
    found = [
        one
        for one in find_shared(SET, SOLUTIONS, ASSIGNED, {"s7": record(X12_5_d=("wrong", copied))})
        if one.other == "s3"
    ]
    assert [(one.student, tuple(one.parts)) for one in found] == [("s7", ("X12_5_d",))]
    assert 0.01 < found[0].chance < 0.5, "with one answer and nineteen others, chance is not small"


def test_two_exercises_make_chance_much_smaller_and_two_parts_of_one_do_not() -> None:
    mass = f"{truth('s3', 'X12.5', 'd'):.4g} N"
    force = f"{truth('s3', 'X12.5', 'c'):.4g} N"
    speed = f"{truth('s3', 'X12.10', 'a'):.4g} m/s"

    def chance(**answers: tuple[str, str]) -> float:
        return next(
            one.chance
            for one in find_shared(SET, SOLUTIONS, ASSIGNED, {"s7": record(**answers)})
            if one.other == "s3"
        )

    one = chance(X12_5_d=("wrong", mass))
    assert chance(X12_5_d=("wrong", mass), X12_5_c=("wrong", force)) >= one * 0.99
    assert chance(X12_5_d=("wrong", mass), X12_10_a=("wrong", speed)) < one / 10


@pytest.mark.parametrize("verdict", ["right", "follows", "mistaken", "slip", "unread", "unmarked"])
def test_only_wrong_answers_are_looked_at(verdict: str) -> None:
    copied = f"{truth('s3', 'X12.5', 'd'):.4g} N"
    assert find_shared(SET, SOLUTIONS, ASSIGNED, {"s7": record(X12_5_d=(verdict, copied))}) == ()


def test_a_wrong_answer_that_fits_nobody_is_nobodys() -> None:
    assert (
        find_shared(
            SET, SOLUTIONS, ASSIGNED, {"s7": record(X12_5_d=("wrong", "987654 N"), X12_5_c=("wrong", "0 N"))}
        )
        == ()
    )


TABLE = """\
---
code: T1
title: Two carts
given:
  m: {is: mass, value: 2, from: 1, to: 9, step: 0.1, unit: kg}
  v: {is: speed, value: 3, from: 1, to: 9, step: 0.1, unit: m/s}
  M: {is: other mass, value: 3000, unit: kg}
  c: {is: braking, value: 100, unit: m/s^2}
require: [m > 0, v > 0, M > 0, c > 0]
---
Carts of {{m}} and {{M}} at {{v}}.

## Table {#a .table rows="light, heavy" columns="momentum, mass" unit="kg m/s, kg" points=2}
?

## Both {#b .list unit="s" components="first second"}
?
"""
TABLE_SOLUTION = """\
from corollary.author import derivation, step, unknowns
from corollary.laws import law

def derive(m, v, M, c):
    p1, m1, p2, m2, t1, t2 = unknowns("p1 m1 p2 m2 t1 t2")
    return derivation(
        step((p1, m1, p2, m2), "By definition.", law("P1", "p1 = m*v"), law("M1", "m1 = m"),
             law("P2", "p2 = M*v"), law("M2", "m2 = M"), answers="a"),
        step((t1, t2), "Times.", law("T1", "t1 = v/c"), law("T2", "t2 = m*v/(M*c)"), answers="b"),
    )
"""


@pytest.fixture(scope="module")
def tables(tmp_path_factory):
    """Twenty students' numbers in a problem with a table and a list, and what is found of one who handed in these answers."""
    folder = tmp_path_factory.mktemp("bank")
    for name, text in (("problems/x/t.md", TABLE), ("solutions/x/t.py", TABLE_SOLUTION)):
        (folder / name).parent.mkdir(parents=True)
        (folder / name).write_text(text)
    sets = folder / "problems" / "sets"
    sets.mkdir()
    (sets / "week.md").write_text("---\ntitle: W\nproblems: [T1]\n---\n")
    bank = Bank(folder)
    problem = bank["T1"]
    assigned = {f"s{n}": AssignedSheet((at(problem, 37 + 311 * n),), "") for n in range(20)}
    solutions, found_set = Solutions(bank), find_set(bank, "week")

    def found(**answers: str):
        handed_in = record(**{name: ("wrong", text) for name, text in answers.items()})
        return {one.other: one for one in find_shared(found_set, solutions, assigned, {"s7": handed_in})}

    def numbers(student: str, part: str) -> tuple[float, ...]:
        return solutions.key(assigned[student].variants[0]).truths[part].values

    return found, numbers


def test_one_small_entry_of_a_table_is_somebody_elses(tables) -> None:
    """By its length the table would be its largest entry alone, in whatever unit that is."""
    found, numbers = tables
    own, theirs = numbers("s7", "a"), numbers("s3", "a")
    mixed = f"{theirs[0]:.5g}, {own[1]:.5g}; {own[2]:.5g}, {own[3]:.5g}"
    assert "s3" in found(T1_a=mixed)
    assert found(T1_a=f"{1.1 * theirs[0]:.5g}, {own[1]:.5g}; {own[2]:.5g}, {own[3]:.5g}") == {}


def test_an_entry_in_its_own_place_only(tables) -> None:
    found, numbers = tables
    own, theirs = numbers("s7", "a"), numbers("s3", "a")
    assert "s3" not in found(T1_a=f"{own[0]:.5g}, {theirs[0]:.5g}; {own[2]:.5g}, {own[3]:.5g}")


def test_an_entry_left_out_or_in_another_unit_is_nobodys(tables) -> None:
    found, numbers = tables
    own = numbers("s7", "a")
    assert found(T1_a=f"1 s, {own[1]:.5g}; {own[2]:.5g}, {own[3]:.5g}") == {}


def test_a_list_is_compared_in_any_order(tables) -> None:
    found, numbers = tables
    theirs = sorted(numbers("s3", "b"), reverse=True)
    for pair in (theirs, theirs[::-1]):
        assert "s3" in found(T1_b=f"{pair[0]:.5g} s, {pair[1]:.5g} s")


def test_two_entries_that_may_fit_are_two_chances(tables) -> None:
    found, numbers = tables
    own, theirs = numbers("s7", "a"), numbers("s3", "a")
    one = found(T1_a=f"{theirs[0]:.5g}, {own[1]:.5g}; {own[2]:.5g}, {own[3]:.5g}")["s3"].chance
    two = found(T1_a=f"{theirs[0]:.5g}, 77; {own[2]:.5g}, {own[3]:.5g}")["s3"].chance
    assert one < two < 2.5 * one
