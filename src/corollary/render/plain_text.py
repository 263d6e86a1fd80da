"""Markdown as plain text for a terminal: paragraphs wrapped, formulas in a line, emphasis left out."""

from __future__ import annotations

import textwrap
from collections.abc import Sequence

from markdown_it.token import Token

from corollary.render.markdown import parser
from corollary.render.plain_maths import plain_formula

UNBROKEN = 24  # characters of the longest formula that a line is broken before, and not within


def plain(text: str, *, width: int = 80) -> str:
    """The text in lines of at most `width` characters; code, tables and display formulas keep their lines."""
    said, bullet, depth, cells = "", "", 0, None
    for token in parser().parse(text):
        block, close = "", False
        match token.type:
            case "bullet_list_open" | "ordered_list_open" | "blockquote_open":
                depth += 1
            case "blockquote_close":
                depth -= 1
            case "bullet_list_close" | "ordered_list_close":
                depth -= 1
                said = said.rstrip("\n") + "\n\n"
            case "list_item_open":
                bullet = f"{token.info}{token.markup} " if token.info else "- "
            case "tr_open":
                cells = []
            case "tr_close":
                block, close, cells = " | ".join(cells or []), True, None
            case "inline" if cells is not None:
                cells.append(_line(token.children or []).replace("\N{NO-BREAK SPACE}", " "))
            case "inline":
                first = "  " * max(0, depth - bool(bullet)) + bullet
                block, close = _wrapped(_line(token.children or []), width, first), bool(bullet)
                bullet = ""
            case "math_block":
                block = "    " + plain_formula(token.content.strip())
            case "fence" | "code_block":
                block = textwrap.indent(token.content.rstrip("\n"), "    ")
            case "table_close":
                said += "\n"
        if block:
            said += block + ("\n" if close else "\n\n")
    return said.strip("\n")


def _wrapped(text: str, width: int, first: str) -> str:
    rest = " " * len(first)
    lines = [
        textwrap.fill(line, width, initial_indent=rest, subsequent_indent=rest) for line in text.split("\n")
    ]
    return first + "\n".join(lines).removeprefix(rest).replace("\N{NO-BREAK SPACE}", " ")


def _line(tokens: Sequence[Token]) -> str:
    """The words of one paragraph; a line break of the source is a space, a forced one stays."""
    said = ""
    for token in tokens:
        match token.type:
            case "text" | "code_inline" | "html_inline":
                said += token.content
            case "math_inline":
                formula = plain_formula(token.content.strip())
                said += formula if len(formula) > UNBROKEN else formula.replace(" ", "\N{NO-BREAK SPACE}")
            case "math_inline_double":
                said += f" {plain_formula(token.content.strip())} "
            case "softbreak":
                said += " "
            case "hardbreak":
                said += "\n"
    return said
