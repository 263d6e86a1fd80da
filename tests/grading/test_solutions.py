"""The solutions of a bank: solved once, told with a student's numbers, and found again in another process."""

from __future__ import annotations

import pickle

import pytest

from corollary.grading.solutions import Solutions
from corollary.problem.bank import home
from corollary.problem.variant import chapter


@pytest.fixture
def stone(small_bank):
    bank, problem = home(small_bank, "T1")
    return Solutions(bank), problem


def test_a_worked_solution_has_the_numbers(stone):
    solutions, problem = stone
    told = solutions.worked_solution(chapter(problem))
    assert told == solutions.worked_solution_of(solutions.key(chapter(problem)))
    for words in ("Only its upward velocity lifts it.", "Gravity points down.", "4.9"):
        assert words in told


def test_solved_once(stone):
    solutions, problem = stone
    assert solutions.of(problem) is solutions.of(problem)
    assert solutions.source(problem).startswith(b'"""A thrown stone')


def test_another_process_finds_them_again(stone):
    solutions, problem = stone
    there = pickle.loads(pickle.dumps(solutions))
    assert there.bank == solutions.bank
    assert there.worked_solution(chapter(problem)) == solutions.worked_solution(chapter(problem))
