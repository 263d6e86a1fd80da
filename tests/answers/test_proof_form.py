"""Two equations of one form: term by term alike, whatever the order, the sides, and the sign of a difference."""

from __future__ import annotations

import pytest

from corollary.answers.evaluation import as_exact, number
from corollary.answers.proof.form import has_form_of, has_terms_of
from corollary.formula.ast import Expr, Name, Relation
from corollary.formula.syntax import author_formula

VALUES = {"F": 1.7, "m": 2.3, "u": 0.9, "v": 3.1, "w": 5.3, "t": 0.7}
AT = {name: as_exact(value) for name, value in VALUES.items()}


def same(left: Expr, right: Expr) -> bool:
    return number(left, AT) == number(right, AT)


def alike(mine: str, law: str) -> bool:
    left, right = author_formula(mine), author_formula(law)
    assert isinstance(left, Relation)
    assert isinstance(right, Relation)
    return has_form_of(left, right, same, lambda _: False)


@pytest.mark.parametrize(
    ("mine", "law"),
    [
        ("F*t = m*v - m*u", "m*v - m*u = F*t"),
        ("2*F*t = 2*m*v - 2*m*u", "m*v - m*u = F*t"),
        ("F*t = m*(v - u)", "m*v - m*u = F*t"),
        ("F/(u - v) = m", "F/(v - u) = -m"),
        ("F/(u - v)^2 = m", "F/(v - u)^2 = m"),
        ("F/(u - v)/(w - t) = m", "F/(v - u)/(t - w) = m"),
        ("F/(u - v)/(w + t) = m", "F/(v - u)/(t + w) = -m"),
    ],
)
def test_one_form(mine: str, law: str) -> None:
    assert alike(mine, law)
    assert alike(law, mine)


@pytest.mark.parametrize(
    ("mine", "law"),
    [
        ("F*t = m*v + m*u", "m*v - m*u = F*t"),
        ("F/(u - v) = m", "F/(v - u) = m"),
        ("F/(u - v)^2 = m", "F/(v - u)^2 = -m"),
        ("F/(u - v)/(w - t) = m", "F/(v - u)/(t - w) = -m"),
        ("F/(u + v) = m", "F/(v - u) = m"),
        ("F/(u + v) = m", "F/(v + u)^2 = m"),
        ("F*t = m*v + m*v", "F*t = m*v + m*u"),
        ("F = 0", "F*t = m*v"),
        ("F*(u - v)^(1/2) = m", "F*(v - u)^(1/2) = m"),
        ("F*(u - v)^(1/2) = m", "F*(v - u)^(1/2) = -m"),
    ],
)
def test_another_form(mine: str, law: str) -> None:
    assert not alike(mine, law)
    assert not alike(law, mine)


@pytest.mark.parametrize(
    ("mine", "other", "found"),
    [
        ("F*t = m*v - m*u", "m*v - m*u = F*t", True),
        ("2*F*t = 2*m*(v - u)", "m*v - m*u = F*t", True),
        ("F*t = m*v + m*u", "m*v - m*u = F*t", False),
        ("F = m*w", "F = m*v", False),
        ("F = m*v", "F*t = m*v - m*u", False),
    ],
)
def test_the_same_terms_have_the_same_values_one_by_one(mine: str, other: str, found: bool) -> None:
    left, right = author_formula(mine), author_formula(other)
    assert isinstance(left, Relation)
    assert isinstance(right, Relation)
    assert has_terms_of(left, right, same) == found
    assert has_terms_of(right, left, same) == found


@pytest.mark.parametrize(
    ("mine", "law", "found"),
    [
        ("m*v = m*w", "v = w", True),
        ("F*m^2 = m^3*v", "F = m*v", True),
        ("m*v = m*w + m*u", "v = w + u", True),
        ("m*v = m^2*w", "v = w", False),
        ("F/m = v/m - u/m", "F = v - u", True),
    ],
)
def test_a_factor_of_all_terms_that_is_never_zero_is_taken_out(mine: str, law: str, found: bool) -> None:
    left, right = author_formula(mine), author_formula(law)
    assert isinstance(left, Relation)
    assert isinstance(right, Relation)
    assert has_form_of(left, right, same, lambda base: base == Name("m")) == found
    assert not alike(mine, law)
