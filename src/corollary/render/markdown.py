"""Markdown with formulas as HTML: raw HTML is shown, not obeyed, and nothing is fetched from anywhere."""

from __future__ import annotations

import html as escaping
import re
from collections.abc import Callable, Sequence
from functools import lru_cache

from markdown_it import MarkdownIt
from markdown_it.common.utils import escapeHtml
from markdown_it.rules_inline import StateInline
from markdown_it.token import Token
from mdit_py_plugins.dollarmath import dollarmath_plugin
from mdit_py_plugins.dollarmath.index import math_inline_dollar

from corollary.render.pictures import NAME, lifted, put_back

# No line ends between a number and its unit (`12 m/s`, `(0.00, 0.72) kg m/s`, `2 %`), nor between a letter and its value (`= 9.8`).
UNIT = r"(?:[mµnckM]?(?:g|m|s|N|J|W|Pa|Hz|V|A|C)|°C|%|K|eV|u|h|min|mol|rad|deg)[²³]?"
MEASURE = re.compile(rf"(?<=[\d)]) (?:{UNIT}[ ·/])*{UNIT}(?![\w'’-])")
VALUE = re.compile(r"^ = (?=[-−]?\d)")

# What sets formulas is loaded with the first formula: it is half of what a view without one would load.


def new_parser() -> MarkdownIt:
    """CommonMark with tables and `$…$`, `$$…$$`; without raw HTML and links, for students' words may flow through. Pictures are
    those that `pictures.lifted` has named: nothing is fetched."""
    markdown = (
        MarkdownIt("commonmark", {"html": False}).enable("table").disable(["link", "autolink", "reference"])
    )
    markdown.validateLink = lambda url: url.startswith(NAME)
    dollarmath_plugin(markdown, allow_labels=False, allow_space=False, allow_digits=False, double_inline=True)
    markdown.inline.ruler.at("math_inline", _at_the_beginning_too)
    return markdown


@lru_cache(maxsize=1)
def parser() -> MarkdownIt:
    """The same, with formulas as MathML."""
    markdown = new_parser()
    markdown.add_render_rule("math_inline", _inline)
    markdown.add_render_rule("math_inline_double", _display)
    markdown.add_render_rule("math_block", _block)
    markdown.add_render_rule("text", _words)
    return markdown


def html(text: str) -> str:
    """The HTML of a text in Markdown, ready to stand in a page."""
    words = lifted(text)
    return put_back(_html(words.text), words.addresses)


def inline(text: str) -> str:
    """The HTML of one line in Markdown, without a paragraph around it."""
    words = lifted(text)
    return put_back(_inline_html(words.text), words.addresses)


@lru_cache(maxsize=1024)
def _html(text: str) -> str:
    return parser().render(text)


@lru_cache(maxsize=1024)
def _inline_html(text: str) -> str:
    return parser().renderInline(text)


_formula = math_inline_dollar(allow_space=False, allow_digits=False, allow_double=True)


def _at_the_beginning_too(state: StateInline, silent: bool) -> bool:
    """The plug-in's rule. Before the first character it looks at the last one: a digit there must not count as one before a formula."""
    if state.pos > 0 or not state.src[-1:].isdigit():
        return _formula(state, silent)
    source = state.src
    state.src = source + " "
    try:
        return _formula(state, silent)
    finally:
        state.src = source


def _words(renderer: object, tokens: Sequence[Token], at: int, *rest: object) -> str:
    return escapeHtml(VALUE.sub(_together, MEASURE.sub(_together, tokens[at].content)))


def _together(found: re.Match[str]) -> str:
    return found[0].replace(" ", "\N{NO-BREAK SPACE}")


def _inline(renderer: object, tokens: Sequence[Token], at: int, *rest: object) -> str:
    from corollary.render.mathml import mathml

    return mathml(tokens[at].content.strip())


def _display(renderer: object, tokens: Sequence[Token], at: int, *rest: object) -> str:
    from corollary.render.mathml import mathml

    return mathml(tokens[at].content.strip(), display=True)


def _block(renderer: object, tokens: Sequence[Token], at: int, *rest: object) -> str:
    from corollary.render.mathml import displayed

    return displayed(tokens[at].content.strip())


def tex_html(text: str) -> str:
    """The HTML of a text in Markdown."""
    words = lifted(text)
    return put_back(_parser().render(words.text), words.addresses)


def tex_inline(text: str) -> str:
    """The HTML of one line in Markdown, without a paragraph around it."""
    words = lifted(text)
    return put_back(_parser().renderInline(words.text), words.addresses)


@lru_cache(maxsize=1)
def _parser() -> MarkdownIt:
    markdown = new_parser()
    for rule, (opens, closes) in {
        "math_inline": (r"\(", r"\)"),
        "math_inline_double": (r"\[", r"\]"),
        "math_block": (r"<p>\[", r"\]</p>" + "\n"),
    }.items():
        markdown.add_render_rule(rule, _between(opens, closes))
    return markdown


def _between(opens: str, closes: str) -> Callable[..., str]:
    from corollary.render.mathml import prepared

    def render(renderer: object, tokens: Sequence[Token], at: int, *rest: object) -> str:
        return opens + escaping.escape(prepared(tokens[at].content.strip()), quote=False) + closes

    return render
