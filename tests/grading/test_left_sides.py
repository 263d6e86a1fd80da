"""Left sides of an answer: names are passed over, a factor or one function is solved for its letter, the rest is asked about."""

from __future__ import annotations

import pytest

from corollary.answers.questions import question_of
from corollary.answers.read_case import read_case
from corollary.answers.verdict import Right
from corollary.grading.from_json import from_json
from corollary.grading.judge import judge


def quantity(text: str, unit: str):
    return read_case({"text": text, "field": "quantity", "unit": unit})


def expression(text: str, *names: str):
    return read_case({"text": text, "field": "expression", "names": list(names)})


@pytest.mark.parametrize(
    "text",
    ["F = 86 N", "Δp_x = 86 N", "F_{avg} = 86 N", "|F| = 86 N", "F(t) = 86 N", "F(y = 0.6 m) = 86 N", "∑F = 86 N", "<F> = 86 N", "F' = 86 N",
     "F = m*a = 86 N", "the mean force = 86 N", "43*2 = 86 N", "86 N = 86 kg m/s²", "m*a = 86 N", "F = 2*F_1 = 86 N"],
)  # fmt: skip
def test_a_name_or_a_side_that_agrees_is_passed_over(text):
    found = quantity(text, "N")
    assert (found["status"], found["value"]) == ("ok", 86.0)


@pytest.mark.parametrize(
    "text",
    ["2F = 86 N", "-F = 86 N", "F/2 = 86 N", "F*dt = 86 N", "x + 2 = 86 N", "F - N = 86 N", "cos(F) = 86 N", "F² = 86 N", "F^2 = 86 N", "43 N = 86 N",
     "40*2 = 86 N", "43 == 86 N", "a + b = 86 N", "2*F = 86 N"],
)  # fmt: skip
def test_another_left_side_is_asked_about(text):
    assert quantity(text, "N")["status"] in ("asked", "refused")


@pytest.mark.parametrize("text", ["cos(theta) = 0.795", "2θ = 90°", "θ + 1 = 90°", "sin θ = 0.5"])
def test_an_angle_behind_a_function_is_not_the_function(text):
    assert quantity(text, "deg")["status"] in ("asked", "refused")


@pytest.mark.parametrize(
    "text",
    ["2*p = m*v", "-p = m*v", "p^2 = m*v", "p/2 = m*v", "m^2 + v^2 = m*v", "2*m*v = m*v", "p + 1 = m*v"],
)
def test_a_formula_behind_another_left_side_is_asked_about(text):
    assert expression(text, "m", "v")["status"] in ("asked", "refused")


@pytest.mark.parametrize("text", ["p = m*v", "p(t) = m*v", "v*m = m*v", "p = v*m = m*v", "Answer: p = m*v"])
def test_a_formula_behind_a_name_is_read(text):
    assert expression(text, "m", "v")["read"] in ("m*v", "v*m")


@pytest.mark.parametrize(
    ("code", "part", "text", "right"),
    [
        ("X12.5", "d", "F/2 = 86 N", True),  # 172 N is right
        ("X12.5", "c", "2 F = 172 N", True),
        ("X12.5", "c", "-F = -86 N", True),
        ("X12.5", "c", "2*F = 2*m*v/dt", True),
        ("X12.5", "c", "m*v/dt = 86 N", True),
        ("X12.1", "b", "2*v = 65 m/s", False),  # which does not come to it
        ("X12.5", "c", "2 F = 86 N", False),
        ("X12.5", "c", "F/2 = 86 N", False),
        ("X12.5", "c", "m = m*v/dt", False),
        ("X12.5", "a", "2*m*v = 8.6 kg m/s", False),
        ("X12.7", "d", "sin(theta) = 1.5708", False),
        ("X12.7", "d", "θ/2 = 90°", False),
    ],
)
def test_what_is_solved_is_judged_and_nothing_else_earns(key, code, part, text, right):
    verdict = judge(key(code), {part: from_json(text)})[part][0][0]
    assert isinstance(verdict, Right) is right, verdict


def test_the_value_solved_for_is_said(key):
    of = key("X12.5")
    assert question_of(of.variant.problem, of.variant.problem.part("c")).symbols
    verdict = judge(of, {"c": from_json("2 F = 172 N")})["c"][0][0]
    assert "2 F = 172 N gives F = 86 N" in str(verdict)


@pytest.mark.parametrize("text", ["1,6 Ns nach oben", "1,6 Ns up", "1.6 Ns upwards", "(0; 1,6) Ns"])
def test_a_decimal_comma_before_a_direction_parts_no_components(verdicts, text):
    assert isinstance(verdicts("X12.7", a=text)["a"], Right)
