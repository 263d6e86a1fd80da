r"""Markdown as the HTML of an LMS, whose own filter sets formulas: in `\(…\)` and `\[…\]`, as Moodle's MathJax reads them."""

from __future__ import annotations

import html as escaping
from collections.abc import Callable, Sequence
from functools import lru_cache

from markdown_it import MarkdownIt
from markdown_it.token import Token

from corollary.render.markdown import new_parser
from corollary.render.pictures import lifted, put_back


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
