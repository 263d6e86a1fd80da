"""The report as a page: plots in words too, tables beside them, nothing from elsewhere."""

from __future__ import annotations

import re
import runpy
from pathlib import Path

import pytest

from corollary.render.report_page import report_page

SAMPLE = runpy.run_path(str(Path(__file__).parents[1] / "sample.py"))
summary = SAMPLE["summary"]
Page = SAMPLE["Page"]


@pytest.fixture
def of(tmp_path):
    return SAMPLE["problem_set"](tmp_path)


def test_the_page_holds_the_report_and_needs_nothing_beside_it(of):
    found = summary(
        [SAMPLE["marked"](of), SAMPLE["late"](SAMPLE["marked"](of, "eve"))], roster=["ada", "cy", "eve"]
    )
    text = report_page(found, of)
    page = Page(text)
    assert page.out == []
    assert "2 handed in, 1 missing" in page.words
    assert "3.38 mean of 12 points" in page.words
    assert "50 % came late" in page.words
    assert "You forgot the" in page.words
    assert "ada, eve" in page.words
    assert "late, 50 % kept" in page.words
    assert "a person reads this" in page.words
    assert "cy" in page.words
    assert text == report_page(found, of)


def test_every_plot_has_its_words_and_its_table(of):
    text = report_page(summary([SAMPLE["marked"](of)]), of)
    plots = re.findall(r'<figure class="plot"><svg[^>]* role="img" aria-label="([^"]+)"', text)
    assert len(plots) == 2
    assert "Histogram of the totals of 1 students: mean 4.5" in plots[0]
    assert text.count("</figure>") == 2
    for after in text.split("</figure>")[1:]:
        assert "<table" in after


def test_a_report_on_nothing_is_a_page(of):
    assert "Nothing was handed in yet." in Page(report_page(summary([]), of)).words
