"""Somebody else's numbers in an answer are found, chance is stated, and honest mistakes are not accused."""

from __future__ import annotations

import pytest

from corollary.grading.solutions import Solutions
from corollary.problem.bank import chapter_bank
from corollary.problem.problem_set import find_set
from corollary.problem.variant import at
from corollary.records.assigned import AssignedSheet
from corollary.records.collusion import find_shared
from corollary.records.record import HandedIn, PartRecord, Record

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
