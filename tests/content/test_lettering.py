"""Parts are lettered in order and without gaps, options otherwise than parts, and formulas are asked for as such in every view."""

from __future__ import annotations

import subprocess
import sys
from itertools import pairwise
from pathlib import Path

import pytest

from corollary.problem.bank import chapter_bank

BANK = chapter_bank()
COMMAND = Path(sys.executable).with_name("corollary")


@pytest.mark.parametrize("problem", list(BANK), ids=lambda each: each.code)
def test_headings_are_lettered_from_a_on_without_gaps(problem):
    letters = [ord(part.heading_letter[0]) - ord("a") for part in problem.parts]
    assert letters[0] == 0
    assert all(after - before in (0, 1) for before, after in pairwise(letters)), letters


@pytest.mark.parametrize("form", ["text", "md", "html", "ipynb"])
def test_options_have_capitals_and_a_formula_is_asked_for(form, tmp_path):
    for code, words in (("X12.9", ("(A)", "(C)")), ("X12.1", ("formula",))):
        page = tmp_path / f"{code}.{form}"
        subprocess.run([COMMAND, "show", code, "--format", form, "-o", page], check=True, capture_output=True)
        text = page.read_text(encoding="utf-8")
        for word in words:
            assert word in text or f"<b>{word.strip('()')}</b>" in text
