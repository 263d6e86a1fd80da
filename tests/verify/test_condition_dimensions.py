"""Dimensions of the conditions of cases, options, roots and claims."""

from __future__ import annotations

import pytest

STEPS = 'step(p, "Mass times velocity.", momentum(p, m, v), answers="a"),'
FORCE = 'step(F, "Per time.", mean_force(F, p, t), answers="b")'
CASES = f"""\
return derivation(
    {STEPS}
    cases(
        case("slow", LOW, {FORCE}),
        case("fast", HIGH, {FORCE}),
    ),
)
"""
CHOICE = """
## Larger {#c .choice}
Which?

- (A) one
- (B) the other
"""


@pytest.mark.parametrize(
    ("low", "high"),
    [
        ("p <= m", "p > m"),
        ("v <= 2.5", "v > 2.5"),
        ("p*t <= 3*m*v", "p*t > 3*m*v"),
        ("abs(v) <= 3*m*t", "abs(v) > 3*m*t"),
    ],
)
def test_a_case_compares_what_measures_the_same(verified, low, high):
    checked = verified(CASES.replace("LOW", low).replace("HIGH", high))
    assert len([each for each in checked.complaints if "cannot be compared" in each]) == 2, checked.complaints
    assert checked.complaints[0].startswith("cart.py:11: the case 'slow': ")


def test_the_ratio_of_a_case_is_a_plain_number(verified):
    checked = verified(CASES.replace("LOW", "p/(m*v) <= 0.5").replace("HIGH", "p/(m*v) > 0.5"))
    assert not [each for each in checked.complaints if "cannot be" in each]


def test_the_root_that_is_meant_is_told_by_what_measures_the_same(verified):
    body = f"""\
return derivation(
    {STEPS}
    step(F, "Squares.", law("Squares", "F^2 = (p/t)^2"), where=F > -m/1000, answers="b"),
)
"""
    complaints = verified(body).complaints
    assert any(
        each.startswith("cart.py:10: where=: ") and "cannot be compared" in each for each in complaints
    )


def test_an_option_compares_what_measures_the_same(verified, problem):
    body = f"""\
return derivation(
    {STEPS}
    {FORCE},
    choice("c", "As it is.", a=v > 2, b=v <= 2),
)
"""
    complaints = verified(body, problem=problem + CHOICE).complaints
    assert {each.partition(": v (")[0] for each in complaints if "cannot be compared" in each} == {
        "cart.py:11: option a",
        "cart.py:11: option b",
    }


@pytest.mark.parametrize("claim", ["v + t > m", '"v*t > m"', '"sin(t) < 0.95"'])
def test_a_claim_compares_what_measures_the_same(verified, claim):
    body = f"""\
return derivation(
    {STEPS}
    {FORCE},
    always("it moves", {claim}),
)
"""
    assert any(each.startswith("cart.py:11: always('it moves'): ") for each in verified(body).complaints)
