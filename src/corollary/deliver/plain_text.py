"""Markdown as plain text for a terminal: paragraphs wrapped, formulas in a line, emphasis left out."""

from __future__ import annotations

import textwrap
from collections.abc import Iterable

from markdown_it.token import Token

from corollary.deliver.markdown import parser
from corollary.deliver.plain_maths import plain_formula


def plain(text: str, *, width: int = 80) -> str:
    """The text in lines of at most `width` characters (code and display formulas keep their lines)."""
    blocks: list[str] = []
    tokens = parser().parse(text)
    bullet, depth, cells = "", 0, []
    for token in tokens:
        match token.type:
            case "bullet_list_open" | "ordered_list_open" | "blockquote_open":
                depth += 1
            case "bullet_list_close" | "ordered_list_close" | "blockquote_close":
                depth -= 1
            case "list_item_open":
                bullet = f"{token.info}{token.markup} " if token.info else "- "
            case "tr_open":
                cells = []
            case "tr_close":
                blocks.append(" | ".join(cells))
            case "inline" if token.level and blocks and _in_table(tokens, token):
                cells.append(_line(token.children or []))
            case "inline":
                indent = "  " * max(0, depth - (1 if bullet else 0))
                first, rest = indent + bullet, indent + " " * len(bullet)
                blocks.append("\n".join(textwrap.fill(line, width, initial_indent=first, subsequent_indent=rest) for line in
                                        _line(token.children or []).split("\n")))
                bullet = ""
            case "math_block":
                blocks.append("    " + plain_formula(token.content.strip()))
            case "fence" | "code_block":
                blocks.append(textwrap.indent(token.content.rstrip("\n"), "    "))
            case _:
                continue
    return "\n\n".join(blocks)
