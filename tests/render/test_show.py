"""One exercise as a student sees it, in three dresses."""

from __future__ import annotations

import base64
import re
import runpy
from pathlib import Path

import pytest

from corollary.notebook.worksheet import exercise
from corollary.problem.variant import chapter
from corollary.render.show import show_markdown, show_text

SAMPLE = runpy.run_path(str(Path(__file__).parents[1] / "sample.py"))


@pytest.fixture
def kick(tmp_path):
    return exercise(chapter(SAMPLE["problem_set"](tmp_path).problems[0]))


def test_text_reads_well_on_a_terminal(kick):
    text = show_text(kick, "Because $p = mv$.")
    assert text.startswith(
        "X12.5  Kicking a ball\n\nA ball of mass 0.43 kg lies still until you kick it; it leaves at v = 20.0"
    )
    assert "[Figure: A ball of mass 0.43 kg [at rest].]" in text
    assert "(a) Momentum  [1 point, in kg m/s]\nBy how much does it change, Δp?" in text
    assert "- (a) the momentum, ∑p" in text.replace("∑ p", "∑p")
    assert text.endswith("Worked solution\n\nBecause p = m v.\n")
    assert "$" not in text
    assert "Worked solution" not in show_text(kick)


def test_markdown_keeps_formulas_and_brings_the_figure(kick):
    text = show_markdown(kick)
    assert "$\\Delta p$" in text
    assert r"![A ball of mass 0.43" in text
    assert r"\[at rest\].][figure]" in text
    drawn = base64.b64decode(re.search(r"\[figure\]: data:image/svg\+xml;base64,(\S+)", text)[1]).decode()  # type: ignore[index]
    assert drawn.startswith('<svg xmlns="http://www.w3.org/2000/svg"')
    assert "m = 0.43" in drawn
    assert "script" not in drawn
