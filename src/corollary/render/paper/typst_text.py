"""Markdown as Typst's markup: what stands in a text is text, and only what the page's Markdown knows becomes anything else."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from functools import lru_cache
from typing import Final

from markdown_it.tree import SyntaxTreeNode

from corollary.render.markdown import parser
from corollary.render.paper.typst_formula import literal, typst_formula
from corollary.render.pictures import as_svg, lifted

POINT: Final = 0.75  # of a pixel of 1/96 inch
AROUND = {"em": "emph", "strong": "strong", "s": "strike"}


def typst_text(markdown: str, level: int = 4) -> str:
    """Paragraphs, lists, tables, formulas, pictures; headings in the text are of this level."""
    words = lifted(markdown)
    return _with_pictures(_text(words.text, level), words.addresses)


def typst_line(markdown: str) -> str:
    """One line, without a paragraph around it."""
    words = lifted(markdown)
    return _with_pictures(_line(words.text), words.addresses)


@lru_cache(maxsize=4096)
def _text(markdown: str, level: int) -> str:
    return _blocks(SyntaxTreeNode(parser().parse(markdown)).children, level).strip()


@lru_cache(maxsize=4096)
def _line(markdown: str) -> str:
    return _words(SyntaxTreeNode(parser().parseInline(markdown)).children)


def _with_pictures(markup: str, addresses: Mapping[str, str]) -> str:
    for name, address in addresses.items():
        svg, width = as_svg(address)
        markup = markup.replace(
            f"#picture-of({literal(name)}, ", f"#picture-of({literal(svg)}, {width * POINT:.4g}pt, "
        )
    return markup


def words_of(text: str) -> str:
    """A text that is no Markdown, such as a name. A space alone is one only as markup."""
    return (f"#{literal(text)};" if text.strip(" ") else " ") if text else ""


def _blocks(nodes: Iterable[SyntaxTreeNode], level: int) -> str:
    return "\n\n".join(_block(node, level) for node in nodes)


def _block(node: SyntaxTreeNode, level: int) -> str:
    match node.type:
        case "heading":
            return f"#heading(level: {level})[{_words(node.children)}]"
        case "bullet_list" | "ordered_list":
            start = f"start: {node.attrGet('start') or 1}, " if node.type == "ordered_list" else ""
            items = (f"[{_blocks(item.children, level)}]" for item in node.children)
            return f"#{'enum' if start else 'list'}({start}{', '.join(items)})"
        case "blockquote":
            return f"#quote(block: true)[{_blocks(node.children, level)}]"
        case "fence" | "code_block":
            return f"#raw({literal(node.content.rstrip())}, block: true)"
        case "math_block":
            return typst_formula(node.content.strip(), display=True)
        case "table":
            return _table(node)
        case "hr":
            return "#line(length: 100%)"
        case "inline" | "paragraph":
            return _words(node.children)
        case _:
            return words_of(node.content) if not node.children else _blocks(node.children, level)


def _table(node: SyntaxTreeNode) -> str:
    rows = [
        [_words(cell.children) for cell in row.children] for part in node.children for row in part.children
    ]
    head = [f"[#strong[{cell}]]" for cell in rows[0]]
    cells = ", ".join(f"[{cell}]" for row in rows[1:] for cell in row)
    return f"#table(columns: {len(head)}, table.header({', '.join(head)}), {cells})"


def _words(nodes: Iterable[SyntaxTreeNode]) -> str:
    return "".join(map(_word, nodes))


def _word(node: SyntaxTreeNode) -> str:
    match node.type:
        case "math_inline":
            return typst_formula(node.content.strip())
        case "math_inline_double":
            return typst_formula(node.content.strip(), display=True)
        case "code_inline":
            return f"#raw({literal(node.content)});"
        case "softbreak":
            return " "
        case "hardbreak":
            return "#linebreak();"
        case "image":
            return f"#picture-of({literal(str(node.attrGet('src')))}, {literal(node.content)});"
        case "em" | "strong" | "s":
            return f"#{AROUND[node.type]}[{_words(node.children)}];"
        case _:
            return _words(node.children) if node.children else words_of(node.content)
