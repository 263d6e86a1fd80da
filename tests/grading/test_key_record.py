"""The key as data: what each answer type has."""

from __future__ import annotations

from corollary.grading.key_record import key_record
from corollary.grading.solutions import Solutions
from corollary.problem.bank import chapter_bank
from corollary.problem.variant import chapter

BANK = chapter_bank()
SOLUTIONS = Solutions(BANK)


def parts(code: str):
    return key_record(SOLUTIONS.of(BANK[code]), chapter(BANK[code]))["parts"]


def test_a_proof_has_its_laws_and_what_is_to_be_shown():
    proof = parts("X12.13")["p"]
    assert proof["target"].startswith("F = ")
    assert len(proof["laws"]) >= 2


def test_a_program_has_its_function_and_an_example():
    program = parts("P12.15")["j"]
    assert "(" in program["function"]
    assert "def " in program["example"]


def test_a_quantity_has_its_value_unit_formula_and_exact_number():
    kick = parts("X12.5")["a"]
    assert (kick["value"], kick["unit"], kick["expression"], kick["exact"]) == (8.6, "kg*m/s", "m*v", "43/5")
    assert kick["certified"]


def test_a_choice_has_its_letter_and_a_part_without_a_value_says_why(solution):
    record = key_record(solution("T1"), chapter(solution("T1").problem))
    assert record["parts"]["d"] == {"choice": "b"}
