"""A law that is the claim times a factor: m g h = m v²/2, where v² = 2 g h is to be shown."""

from __future__ import annotations

from pathlib import Path

import pytest

from corollary.answers.verdict import Right, Wrong
from corollary.grading.from_json import from_json
from corollary.grading.judge import judge
from corollary.grading.key import Key, make_key
from corollary.grading.solutions import Solutions
from corollary.problem.bank import Bank, find
from corollary.problem.variant import chapter

PROBLEM = """\
---
code: F1
title: A falling stone
given:
  m: {is: mass of the stone, value: 0.5, from: 0.2, to: 1.5, step: 0.1, unit: kg}
  h: {is: height, value: 5, from: 2, to: 20, step: 0.5, unit: m}
  g: {is: acceleration of free fall, value: 9.81, unit: m/s^2}
require:
  - m > 0
  - h > 0
  - g > 0
---
A stone of {{m}} falls from rest from {{h}}. Use g = {{g}}. Energy is conserved: $m g h = m v^2/2$.

## Show it {#a .proof components="v" points=2}
Show that $v^2 = 2 g h$.

## Speed {#b .value unit="m/s" points=1}
How fast is it at the ground?
"""
SOLUTION = """\
## (b) v

Energy is conserved.

- law: Energy, `m*g*h = m*v^2/2`
- where: `v > 0`

## (a)

The mass cancels.

- proof: Free fall, `v^2 = 2*g*h`
- law: Energy, `m*g*h = m*v^2/2`
- line: `m*g*h = m*v^2/2`
- line: `v^2 = 2*g*h`
"""


@pytest.fixture(scope="module")
def falling(tmp_path_factory: pytest.TempPathFactory) -> Key:
    folder: Path = tmp_path_factory.mktemp("falling")
    for place, text in (("problems", PROBLEM), ("solutions", SOLUTION)):
        (folder / place / "energy").mkdir(parents=True)
        (folder / place / "energy" / "fall.md").write_text(text, encoding="utf-8")
    solution = Solutions(Bank(folder)).of(find(Bank(folder), "F1"))
    return make_key(solution, chapter(solution.problem))


@pytest.mark.parametrize(
    ("lines", "kind", "words"),
    [
        (["m*g*h = m*v^2/2", "g*h = v^2/2", "v^2 = 2*g*h"], Right, "every line follows"),
        (["m*v^2 = 2*m*g*h", "v^2 = 2*g*h"], Right, "every line follows"),
        (["v^2 = 2*g*h"], Wrong, "only the claim"),
        (["v^2/2 = g*h", "v^2 = 2*g*h"], Wrong, "only the claim"),
        (["m*g*h = m*v^2/2"], Wrong, "not yet among them"),
        (["m*g*h = m*v^2", "v^2 = 2*g*h"], Wrong, "does not hold"),
    ],
)
def test_a_law_is_told_from_the_claim_by_its_factor(falling: Key, lines: list[str], kind: type, words: str):
    verdict = judge(falling, {"a": from_json(lines)})["a"][0][0]
    assert isinstance(verdict, kind), verdict
    assert words in str(verdict)
