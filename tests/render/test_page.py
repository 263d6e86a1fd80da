"""Pages need nothing beside them, and say nothing that was not meant as HTML in HTML."""

from __future__ import annotations

import runpy
from pathlib import Path

from corollary.notebook.worksheet import exercise
from corollary.problem.roster import Student
from corollary.problem.variant import chapter
from corollary.render.exports import target
from corollary.render.page import page

SAMPLE = runpy.run_path(str(Path(__file__).parents[1] / "sample.py"))


def test_an_exercise_is_a_whole_page_with_its_font(tmp_path):
    kick = SAMPLE["problem_set"](tmp_path).problems[0]
    write = target("html").exercise
    assert write is not None
    text = write(exercise(chapter(kick)), Student("ada"), "Because $p = mv$.")
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
    return {"exercise": shown, "drawing": "", "wanted": str, "solution": ""}
