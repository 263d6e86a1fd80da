"""Markdown in pages: formulas are set, HTML is shown as typed, and nothing leads out."""

from __future__ import annotations

import pytest

from corollary.render.markdown import html, inline


def test_formulas_stand_in_the_line_and_apart():
    said = html("Let $x^2$ be.\n\n$$\nF = ma\n$$\n\nand $$y$$ too")
    assert said.count("<math") == 3
    assert '<div class="formula"><math display="block"' in said


def test_a_formula_may_begin_a_line_that_ends_with_a_digit():
    assert inline("$m$ of part 5").count("<math") == 1
    assert html("$m$ and $v$ of part 5").count("<math") == 2


def test_a_price_is_no_formula():
    assert html("It costs $5 and $6.") == "<p>It costs $5 and $6.</p>\n"


def test_tables_lists_and_code_are_set():
    assert "<td>" in html("| a |\n|---|\n| $x$ |")
    assert "<li>" in html("- a")
    assert "<code>8,6 Ns</code>" in html("`8,6 Ns`")


@pytest.mark.parametrize(
    "text",
    [
        "<script>alert(1)</script>",
        "a <img src=x onerror=alert(1)> b",
        "<div onclick='x'>\n\ntext\n\n</div>",
        "[x](javascript:alert(1))",
        "![x](http://example.org/a.png)",
        "<http://example.org>",
        "[x][a]\n\n[a]: http://example.org",
        "http://example.org",
        "`` `<script>` ``",
        "$<script>alert(1)</script>$",
        "$\\text{<script>}$",
        "```<script>\n<script>\n```",
        "&lt;script&gt;",
    ],
)
def test_nothing_runs_and_nothing_leads_out(text):
    said = html(text)
    for tag in ("<script", "<img", "<a ", "<div onclick"):
        assert tag not in said


def test_one_line_has_no_paragraph():
    assert inline("the *sign* of $x$").startswith("the <em>sign</em> of <math")
