"""Markdown with formulas as HTML: raw HTML is shown, not obeyed, and nothing is fetched from anywhere."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache

from markdown_it import MarkdownIt
from markdown_it.token import Token
from mdit_py_plugins.dollarmath import dollarmath_plugin

# What sets formulas is loaded with the first formula: it is half of what a view without one would load.


def new_parser() -> MarkdownIt:
    """CommonMark with tables and `$…$`, `$$…$$`; without raw HTML, links and pictures, for students' words may flow through."""
    markdown = (
        MarkdownIt("commonmark", {"html": False})
        .enable("table")
        .disable(["link", "image", "autolink", "reference"])
    )
    dollarmath_plugin(markdown, allow_labels=False, allow_space=False, allow_digits=False, double_inline=True)
    return markdown


@lru_cache(maxsize=1)
def parser() -> MarkdownIt:
    """The same, with formulas as MathML."""
    markdown = new_parser()
    markdown.add_render_rule("math_inline", _inline)
    markdown.add_render_rule("math_inline_double", _display)
    markdown.add_render_rule("math_block", _block)
    return markdown


@lru_cache(maxsize=1024)
def html(text: str) -> str:
    """The HTML of a text in Markdown, ready to stand in a page."""
    return parser().render(text)


@lru_cache(maxsize=1024)
def inline(text: str) -> str:
    """The HTML of one line in Markdown, without a paragraph around it."""
    return parser().renderInline(text)


def _inline(renderer: object, tokens: Sequence[Token], at: int, *rest: object) -> str:
    from corollary.render.mathml import mathml

    return mathml(tokens[at].content.strip())


def _display(renderer: object, tokens: Sequence[Token], at: int, *rest: object) -> str:
    from corollary.render.mathml import mathml

    return mathml(tokens[at].content.strip(), display=True)


def _block(renderer: object, tokens: Sequence[Token], at: int, *rest: object) -> str:
    from corollary.render.displayed import displayed

    return displayed(tokens[at].content.strip())
