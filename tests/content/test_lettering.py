"""Parts are lettered in order and without gaps, options otherwise than parts, and formulas are asked for as such in every view."""

from __future__ import annotations

from itertools import pairwise

import nbformat
import pytest
from tests import forked
from tests.chapter_problems import PROBLEMS

from corollary.problem.bank import chapter_bank

BANK = chapter_bank()


@pytest.mark.parametrize("problem", PROBLEMS, ids=lambda each: each.code)
def test_headings_are_lettered_from_a_on_without_gaps(problem):
    letters = [ord(part.heading_letter[0]) - ord("a") for part in problem.parts]
    assert letters[0] == 0
    assert all(after - before in (0, 1) for before, after in pairwise(letters)), letters


@pytest.mark.parametrize("problem", PROBLEMS, ids=lambda each: each.code)
def test_an_answer_is_named_by_the_letter_above_it(problem):
    names = [problem.variable(part) for part in problem.parts]
    assert len({*names}) == len(names)
    assert all(
        name == f"{problem.prefix}_{part.heading_letter}"
        for name, part in zip(names, problem.parts, strict=True)
    )


def test_a_sheet_shows_one_letter_for_a_part(tmp_path):
    """The catalogue has S12.5r a, b, c, d and f: students see (e) and S12_5r_e, and nowhere the f."""
    page = tmp_path / "sheet.ipynb"
    forked.run([forked.COMMAND, "show", "S12.5r", "--format", "ipynb", "-o", page], check=True)
    sources = "\n".join(cell["source"] for cell in nbformat.read(page, as_version=4).cells)
    assert "#### (e)" in sources
    assert "S12_5r_e = None" in sources
    assert 'check("S12_5r_e")' in sources
    assert "S12_5r_f" not in sources


@pytest.mark.parametrize("form", ["text", "md", "html", "ipynb"])
def test_options_have_capitals_and_a_formula_is_asked_for(form, tmp_path):
    for code, words in (("X12.9", ("(A)", "(C)")), ("X12.1", ("formula",))):
        page = tmp_path / f"{code}.{form}"
        forked.run([forked.COMMAND, "show", code, "--format", form, "-o", page], check=True)
        text = page.read_text(encoding="utf-8")
        for word in words:
            assert word in text or f"<b>{word.strip('()')}</b>" in text
