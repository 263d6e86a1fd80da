"""Two equations of one form: term by term alike, whatever the order, the sides, and the sign of a difference."""

from __future__ import annotations

import pytest

from corollary.answers.evaluation import as_exact, number
from corollary.answers.proof.form import has_form_of
from corollary.formula.ast import Expr, Relation
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
    ],
)
def test_another_form(mine: str, law: str) -> None:
    assert not alike(mine, law)
    assert not alike(law, mine)
