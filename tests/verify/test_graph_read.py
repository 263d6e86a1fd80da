"""A graph may show what is asked for, and givens that stand nowhere else; a text that shows the answer may not."""

from __future__ import annotations

import pytest

from corollary.problem.bank import Bank, find
from corollary.verify.verify import verify

PROBLEM = """\
---
code: X1.1
title: A trip
given:
  a: {is: acceleration, value: 2, from: 1, to: 4, step: 0.5, unit: m/s^2}
  t1: {is: time, value: 4, from: 2, to: 6, step: 1, unit: s}
require: [a > 0, t1 > 0]
figure: |
  graph x=t,0,8 y=0,24 units=s,m/s "t" "v"
  curve through=(0,0),(t1,a*t1),(8,a*t1)
---
The graph shows the velocity v of a car.NOTE

## Speed {#a .value unit="m/s" tolerance="5 %" because="it is read off a graph"}
How fast does it become?
"""
SOLUTION = """\
A trip.

## (a) v

The speed grows steadily.

- law: Constant acceleration, `v = a*t1`
- mistake: You took the mean. `v = a*t1/2`
- mistake: That is the acceleration times the time, squared. `v = a*t1 + a*t1`
"""


@pytest.fixture
def verified(tmp_path):
    def put(problem: str):
        for folder, text in (("problems", problem), ("solutions", SOLUTION)):
            (tmp_path / folder / "cars").mkdir(parents=True)
            (tmp_path / folder / "cars" / "trip.md").write_text(text, encoding="utf-8")
        bank = Bank(tmp_path)
        return verify(bank, find(bank, "X1.1"), 20)

    return put


@pytest.mark.parametrize("alt", ["", "alt: How the velocity grows.\n"])
def test_the_graph_shows_its_givens_and_what_is_read_off_it(verified, alt):
    checked = verified(PROBLEM.replace("NOTE", "").replace("---\nThe", f"{alt}---\nThe"))
    assert checked.complaints == ()
    assert checked.notes == ()


def test_a_text_that_tells_the_answer_is_still_a_fault(verified):
    checked = verified(PROBLEM.replace("NOTE", " It comes to {{a*t1}}."))
    assert any("tells the answer to part a" in each for each in checked.complaints)
