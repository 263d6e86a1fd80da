"""Pages need nothing beside them, and say nothing that was not meant as HTML in HTML."""

from __future__ import annotations

import runpy
from pathlib import Path

import pytest

from corollary.figure.colour import contrast
from corollary.notebook.worksheet import exercise
from corollary.problem.variant import chapter
from corollary.render.page import page, points
from corollary.render.show import show_html
from corollary.render.verdict_look import LOOKS

SAMPLE = runpy.run_path(str(Path(__file__).parents[1] / "sample.py"))


def test_an_exercise_is_a_whole_page_with_its_font(tmp_path):
    kick = SAMPLE["problem_set"](tmp_path).problems[0]
    text = show_html(exercise(chapter(kick)), "Because $p = mv$.")
    found = SAMPLE["Page"](text)
    assert text.startswith('<!DOCTYPE html>\n<html lang="en">')
    assert 'name="viewport"' in text
    assert "<title>X12.5 Kicking a ball</title>" in text
    assert 'Corollary Mathematics"; src: url(data:font/woff2;base64,' in text
    assert not found.out
    assert "Because" in found.words
    assert "(a) Momentum" in found.words
    assert "run()" not in text


def test_a_page_without_formulas_carries_no_font():
    assert "font/woff2" not in page("exercise.html", title="t", **_facts("no formula"))
    assert "font/woff2" in page("exercise.html", title="t", **_facts("a formula $x$"))


def test_what_is_not_markup_is_escaped():
    assert "<title>&lt;b&gt;</title>" in page("exercise.html", title="<b>", **_facts(""))
    assert "<i>" not in page("exercise.html", title="t", **_facts("<i>"))


def _facts(statement: str) -> dict[str, object]:
    problem = {"code": "X", "title": "t", "source": ""}
    shown = {"problem": problem, "statement": statement, "prompts": (), "variant": {"label": "X#1"}}
    return {"exercise": shown, "drawing": "", "earns": {}, "solution": ""}


POINTS = [(1, "1"), (0.5, "0.5"), (2.346, "2.35"), (10, "10"), (0, "0"), (-0.001, "0"), (1e5, "100000")]


@pytest.mark.parametrize(("value", "said"), POINTS)
def test_points_are_written_as_people_do(value, said):
    assert points(value) == said


def test_the_look_of_verdicts_differs_and_ink_is_readable():
    assert len({look.colour for look in LOOKS.values()}) == len(LOOKS)
    assert contrast("#1b1b1b", "#f5f6f8") > 7
    assert contrast("#55595f", "#f5f6f8") >= 4.5
    assert contrast("#00538a", "#ffffff") >= 4.5
