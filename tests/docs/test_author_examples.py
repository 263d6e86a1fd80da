"""The complete examples of the author's page are solutions that verify."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from corollary.problem.bank import Bank
from corollary.problem.reader import read_problem
from corollary.verify.verify import verify

PAGE = (Path(__file__).parents[2] / "docs" / "author.md").read_text(encoding="utf-8")
FRONT = """\
---
code: X1.1
title: An example
given:
  m: {is: mass, value: 2, from: 1, to: 4, step: 0.5, unit: kg}
  g: {is: gravity, value: 9.81, unit: m/s^2}
GIVENS
require:
  - m > 0
  - g > 0
MORE
---
An example.

"""
FALLING = (
    """\
  b: {is: drag, value: 0.5, from: 0.2, to: 1, step: 0.1, unit: kg/s}
  t1: {is: time, value: 3, from: 1, to: 5, step: 0.5, unit: s}""",
    "  - b > 0\n  - t1 > 0",
    '## Speed {#a .value unit="m/s"}\n?\n\n## Way {#b .value unit="m"}\n?\n',
)
SLOPE = (
    """\
  alpha: {is: angle, value: 20, from: 10, to: 40, step: 1, unit: deg}
  mus: {is: static friction, value: 0.5, from: 0.3, to: 0.6, step: 0.05, unit: "1"}
  muk: {is: kinetic friction, value: 0.2, from: 0.1, to: 0.25, step: 0.05, unit: "1"}""",
    "  - 0 < alpha < 90 deg\n  - mus > 0\n  - muk > 0",
    '## Friction {#a .value unit="N"}\n?\n',
)


@pytest.mark.parametrize("section", ["Intervals, lists and words", "Tables and matrices", "Forces on a body"])
def test_the_pair_verifies(tmp_path, section):
    found = re.search(rf"\n### {section}\n.*?```markdown\n(.*?)```\n.*?```python\n(.*?)```", PAGE, re.DOTALL)
    assert found is not None
    for folder, ending, text in (("problems", "md", found[1]), ("solutions", "py", found[2])):
        (tmp_path / folder / "x").mkdir(parents=True)
        (tmp_path / folder / "x" / f"pair.{ending}").write_text(text, encoding="utf-8")
    checked = verify(Bank(tmp_path), read_problem(tmp_path / "problems" / "x" / "pair.md"), 5)
    assert checked.complaints == ()
    assert checked.checks["kind samples"] > 15
    assert checked.checks["mistakes apart"] > 0


@pytest.mark.parametrize(("section", "problem"), [("Functions of time", FALLING), ("Cases", SLOPE)])
def test_the_example_verifies(tmp_path, section, problem):
    found = re.search(rf"\n## {section}\n.*?```python\n(.*?)```", PAGE, re.DOTALL)
    assert found is not None
    givens, more, parts = problem
    for folder in ("problems", "solutions"):
        (tmp_path / folder / "x").mkdir(parents=True)
    place = tmp_path / "problems" / "x" / "example.md"
    place.write_text(FRONT.replace("GIVENS", givens).replace("MORE", more) + parts, encoding="utf-8")
    (tmp_path / "solutions" / "x" / "example.py").write_text(found[1], encoding="utf-8")
    checked = verify(Bank(tmp_path), read_problem(place), 5)
    assert checked.complaints == ()
    assert not [note for note in checked.notes if "used in no answer" in note]
    assert checked.checks["mistakes apart"] > 0
