"""What stands around an answer is left out; what would change it is not."""

from __future__ import annotations

import pytest

from corollary.answers.preamble import answer_in
from corollary.answers.read_case import read_case
from corollary.formula.numerals import TO_ASCII


@pytest.mark.parametrize(
    "written",
    [
        "8.6 N", "= 8.6 N", "≈ 8.6 N", "~8.6 N", "ca. 8.6 N", "about 8.6 N", "ungefähr 8.6 N", "environ 8.6 N", "F = 8.6 N",
        "Δp ≈ 8.6 N", "delta p = 8.6 N", "|p| = 8.6 N", "p_1 - p_0 = m v = 8.6 N", "0.43*20 = 8.6 N", "Answer: 8.6 N", "a) 8.6 N",
        "(b) 8.6 N", "The force is 8.6 N", "“8.6 N”", "**8.6 N**", "8.6 N.", "8.6 N;", "8.6 N (g = 9.81 m/s²)",
        "8.6 N, with g = 9.8", "8.6 N because F = ma", "8.6 N, since 2*4.3 = 8.6", "8.6 N due to gravity", "F is 8.6 N", "F_N is 8.6 N",
    ],
)  # fmt: skip
def test_the_answer_is_found(written):
    found, before, _ = answer_in(written.translate(TO_ASCII))
    assert found.strip() == "8.6 N"
    assert written[before:].startswith("8.6")


@pytest.mark.parametrize(
    "written",
    [
        "8.6 or 9 N",
        "not 8.6 N",
        "less than 9 N",
        "between 8 and 9 N",
        "8.6 N if v = 3",
        "> 8 N",
        "half of 8.6 N",
        "x = 3, y = 4",
        "8.6 N because it is not 9 N",
    ],
)
def test_what_changes_an_answer_stays(written):
    found, _, _ = answer_in(written.translate(TO_ASCII))
    assert found.strip() != "8.6 N"
    assert any(word in found for word in ("or", "not", "less", "between", "if", ">", "half", "y = 4"))


@pytest.mark.parametrize(
    ("written", "answer"),
    [
        ("minus 3 m/s", "-3 m/s"),
        ("minus three m/s", "-three m/s"),
        ("(-) 3 m/s", "-3 m/s"),
        ("(-)3 m/s", "-3 m/s"),
    ],
)
def test_a_minus_in_words_or_of_a_calculator(written, answer):
    assert " ".join(answer_in(written)[0].split()) == answer


def test_quotation_marks_around_nothing_stay():
    assert answer_in('""')[0] == '""'
    assert answer_in('"8"')[:2] == ("8", 1)


@pytest.mark.parametrize(
    "text",
    [
        "The average force on the ball is 86 N.", "My answer is 86 N", "It's 86 N", "the mean force on the ball was 86 N", "force on the ball: 86 N",
        "F [N] = 86", "F (N) = 86", "F in N: 86", "F/N = 86", "F/kN = 0.086", "F [mN] = 86000",
    ],
)  # fmt: skip
def test_a_sentence_and_a_label_with_its_unit_lead_up_to_a_number(text):
    found = read_case({"text": text, "unit": "N"})
    assert (found["status"], found["verdict"]) == ("ok", "compatible")
    assert found["value"] == pytest.approx(86)


@pytest.mark.parametrize(
    "text",
    [
        "half the force is 86 N", "the force is not 86 N", "twice the force is 86 N", "a third of the force is 86 N", "no force is 86 N",
        "the force backwards is 86 N", "force to the left = 86 N", "the opposite of the force is 86 N", "left = 86 N", "the force squared is 86 N",
        "F/m = 86", "F/s = 86 N", "F [m] = 86", "F/2 = 86",
    ],
)  # fmt: skip
def test_a_sentence_that_changes_the_number_and_another_label_do_not(text):
    found = read_case({"text": text, "unit": "N"})
    assert found["status"] != "ok" or found["verdict"] != "compatible"
