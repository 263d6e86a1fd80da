"""Every kind of thing that a figure can hold stands in the page of figures, with an example that is drawn."""

from __future__ import annotations

import re
from pathlib import Path
from textwrap import dedent, indent

import pytest

from corollary.figure.drawing_sheet import PRIMITIVES, TEXT_SIDES
from corollary.problem.figure import drawn
from corollary.problem.reader import read_problem
from corollary.problem.variant import chapter

PAGE = (Path(__file__).parents[2] / "docs" / "reference" / "figures.md").read_text(encoding="utf-8")
TABLE = PAGE.partition("| thing | example | takes |")[2]
ROWS = dict(re.findall(r"^\| `(\w+)` \| (.*) \|$", TABLE, re.MULTILINE))
FRONT = """\
---
code: X1.1
title: Two blocks
given:
  mA: {is: mass of A, value: 2.0, unit: kg}
  mB: {is: mass of B, value: 3.0, unit: kg}
  vA: {is: velocity of A, value: 5.0, unit: m/s}
  vB: {is: velocity of B, value: -2.5, unit: m/s}
figure: |
"""
REST = '---\nTwo blocks.\n\n## Speed {#a .value unit="m/s"}\nHow fast?\n'


def shown(figure: str, folder: Path) -> str:
    path = folder / "blocks.md"
    path.write_text(FRONT + indent(figure, "  ") + "\n" + REST, encoding="utf-8")
    return drawn(chapter(read_problem(path))).svg


def test_everything_has_a_row():
    assert ROWS.keys() == PRIMITIVES.keys()


@pytest.mark.parametrize("kind", ROWS)
def test_an_example_is_drawn_and_the_words_are_those_it_takes(kind: str, tmp_path: Path):
    example, _, takes = ROWS[kind].partition(" | ")
    svg = shown(example.strip("`"), tmp_path)
    assert "<path" in svg or "<circle" in svg or "<text" in svg
    words = set(re.findall(r"`(\w+)=?`", takes))
    assert words - {"small"} >= set(PRIMITIVES[kind].words)
    assert words <= PRIMITIVES[kind].words | (PRIMITIVES[kind].flags - TEXT_SIDES)


def test_the_first_figure_of_the_page_is_drawn(tmp_path: Path):
    block = dedent(PAGE.partition("```text\nfigure: |\n")[2].partition("```")[0])
    svg = shown(block.strip(), tmp_path)
    assert svg.count("<text") == 8
    assert "−2.5\N{NO-BREAK SPACE}m/s" in svg
