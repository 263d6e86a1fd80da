"""An author of whom too many draws are refused is told which range to change, or what condition to add."""

from __future__ import annotations

import re
from fractions import Fraction

import pytest

from corollary.problem.reader import read_problem
from corollary.problem.sampling import spread
from corollary.verify.walk import TriedDraw, narrower

MIXED = """\
---
code: X1.1
title: Two fluids
given:
  m: {is: mass of the warm water, value: 2, from: 0.1, to: 3, step: 0.1, unit: kg}
  v: {is: mass of the cold water, value: 60, from: 30, to: 3000, step: 0.5, unit: kg}
  t: {is: rise, value: 20, from: 10, to: 60, step: 1, unit: K}
require:
  - m > 0
  - v > 0
  - t > 0
---
{{m}} and {{v}} and {{t}}.

## Mass {#a .value unit="kg" points=1}
How much is it in the end?
"""
ADDED = """
return derivation(
    step(p, "Both.", law("Mass", "p = m + v"), answers="a",
         mistakes=[mistake("The warm water counts, too.", wrong("p = v")), mistake("Both.", wrong("p = m"))]),
)
"""


def refusal(checked) -> str:
    return next(each for each in (*checked.complaints, *checked.notes) if "may not be assigned" in each)


def test_the_range_to_change_is_named(verified):
    """One per cent is what tells m + v from v: that is so where v is below some hundred times m."""
    said = refusal(verified(ADDED, "", MIXED))
    assert said.startswith("cart.md:5: 9")
    assert (
        "(part a: the mistake 'The warm water counts, too.' cannot be told from the truth); with v to: "
        in said
    )
    limit = float(said.split("with v to: ")[1].split(" kg")[0])
    assert 150 < limit < 600


@pytest.mark.parametrize(("largest", "kind"), [("3000", "complaints"), ("400", "notes"), ("60", "")])
def test_more_than_half_is_a_note_and_nearly_all_a_complaint(verified, largest, kind):
    checked = verified(ADDED, "", MIXED.replace("to: 3000", f"to: {largest}"))
    for name in ("complaints", "notes"):
        assert any("may not be assigned" in each for each in getattr(checked, name)) == (name == kind), name


@pytest.mark.whole
def test_where_two_givens_decide_together_it_is_a_condition(tmp_path):
    """All draws with more than 1.2 times as much cold water are refused: no range of one mass says that as well."""
    path = tmp_path / "two.md"
    path.write_text(
        MIXED.replace("from: 30, to: 3000, step: 0.5", "from: 0.1, to: 3, step: 0.1"), encoding="utf-8"
    )
    problem = read_problem(path)
    tried = [
        TriedDraw(variant, variant.values["v"] <= Fraction("1.2") * variant.values["m"])
        for variant in spread(problem, 400, salt="test")
    ]
    found = re.fullmatch(
        r"with m >= (0\.8\d)\*v \(under where:\) it would be (\d+) % of them; beyond that it is (\d+) %",
        narrower(tried),
    )
    assert found is not None
    assert abs(float(found[1]) - 1 / 1.2) < 0.03
    assert (int(found[2]) <= 3, int(found[3]) >= 97) == (True, True)


@pytest.mark.whole
def test_what_no_limit_tells_apart_is_said_of_none(tmp_path):
    path = tmp_path / "two.md"
    path.write_text(MIXED, encoding="utf-8")
    draws = spread(read_problem(path), 400, salt="test")
    assert narrower([TriedDraw(variant, place % 3 == 0) for place, variant in enumerate(draws)]) == ""
    assert narrower([]) == ""
