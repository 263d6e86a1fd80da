"""Markdown as text for a terminal: paragraphs wrapped, formulas in a line (`J = F Δt`, `√(2 g h)`), emphasis left out."""

from __future__ import annotations

import re
import textwrap
import unicodedata
from collections.abc import Sequence
from itertools import accumulate
from xml.etree.ElementTree import Element

from markdown_it.token import Token

from corollary.messages import catalogue
from corollary.render.markdown import parser
from corollary.render.pictures import lifted

_ = catalogue(__name__)

UNBROKEN = 24  # characters of the longest formula that a line is broken before, and not within
RAISED = dict(zip("0123456789+−-=nixyTabcdt′″∘", "⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻⁻⁼ⁿⁱˣʸᵀᵃᵇᶜᵈᵗ′″°", strict=True))
LOWERED = dict(zip("0123456789+−-=aeijnpt", "₀₁₂₃₄₅₆₇₈₉₊₋₋₌ₐₑᵢⱼₙₚₜ", strict=True))
QUAD = "\N{EM SPACE}"
SPACED = frozenset("=<>≤≥≈≠≪≫+−-±∓→⇒⇔∝∼×·⋅∈≡⟹↦")
OVER = {
    "→": "\u20d7",
    "ˆ": "\u0302",
    "˜": "\u0303",
    "¯": "\u0304",
    "‾": "\u0305",
    "˙": "\u0307",
    "¨": "\u0308",
}


def terminal_text(text: str, *, width: int = 80) -> str:
    """The text in lines of at most `width` characters; code, tables and display formulas keep their lines."""
    out, bullet, depth, cells = "", "", 0, None
    for token in parser().parse(lifted(text).text):
        block, tight = "", False
        match token.type:  # pyright: ignore[reportMatchNotExhaustive]
            case "bullet_list_open" | "ordered_list_open" | "blockquote_open":
                depth += 1
            case "blockquote_close":
                depth -= 1
            case "bullet_list_close" | "ordered_list_close":
                depth -= 1
                out = out.rstrip("\n") + "\n\n"
            case "list_item_open":
                bullet = f"{token.info}{token.markup} " if token.info else "- "
            case "tr_open":
                cells = list[str]()
            case "tr_close":
                block, tight, cells = " | ".join(cells or []), True, None
            case "inline" if cells is not None:
                cells.append(_line(token.children or []).replace("\N{NO-BREAK SPACE}", " "))
            case "inline":
                first = "  " * max(0, depth - bool(bullet)) + bullet
                block, tight = _wrapped(_line(token.children or []), width, first), bool(bullet)
                bullet = ""
            case "math_block":
                block = "    " + formula_text(token.content.strip())
            case "fence" | "code_block":
                block = textwrap.indent(token.content.rstrip("\n"), "    ")
            case "table_close":
                out += "\n"
        if block:
            out += block + ("\n" if tight else "\n\n")
    return out.strip("\n")


def _wrapped(text: str, width: int, first: str) -> str:
    rest = " " * len(first)
    lines = [
        textwrap.fill(line, width, initial_indent=rest, subsequent_indent=rest) for line in text.split("\n")
    ]
    return first + "\n".join(lines).removeprefix(rest).replace("\N{NO-BREAK SPACE}", " ")


def _line(tokens: Sequence[Token]) -> str:
    """The words of one paragraph; a line break of the source is a space, a forced one stays."""
    out = ""
    for token in tokens:
        match token.type:  # pyright: ignore[reportMatchNotExhaustive]
            case "text" | "code_inline" | "html_inline":
                out += token.content
            case "image":
                out += _("[Picture: {alt}]", alt=token.content)
            case "math_inline":
                formula = formula_text(token.content.strip())
                out += formula if len(formula) > UNBROKEN else formula.replace(" ", "\N{NO-BREAK SPACE}")
            case "math_inline_double":
                out += f" {formula_text(token.content.strip())} "
            case "softbreak":
                out += " "
            case "hardbreak":
                out += "\n"
    return out


def formula_text(latex: str) -> str:
    """The formula as readable text, or its source when it is no LaTeX."""
    from corollary.render.mathml import formula  # loaded with the first formula, as in `markdown`

    tree = formula(latex)
    return latex if tree is None else re.sub(" +", " ", _text(tree)).strip().replace(QUAD, "   ")


def _text(element: Element) -> str:
    children = list(element)
    match element.tag, children:
        case "mi" | "mn" | "mtext", _:
            return "".join(map(_letter, element.text or ""))
        case "mo", _:
            return _operator(element)
        case "mspace", _:
            return QUAD if element.get("width", "") in {"1em", "2em"} else " "
        case "mfrac", [above, below]:
            return f"{_grouped(above)}/{_grouped(below)}"
        case "msqrt", _:
            return f"√({_row(children)})" if len(_row(children)) > 1 else f"√{_row(children)}"
        case "mroot", [inside, degree]:
            return f"{_script(_text(degree), RAISED, '')}√({_text(inside)})"
        case "munder" | "mover", [base, brace] if brace.text in {"⏟", "⏞"}:
            return _text(base)
        case "msup", [base, raised]:
            return _text(base) + _script(_text(raised), RAISED, "^")
        case "msub" | "munder", [base, lowered]:
            return _text(base) + _script(_text(lowered), LOWERED, "_")
        case "msubsup" | "munderover", [base, lowered, raised]:
            return _text(base) + _script(_text(lowered), LOWERED, "_") + _script(_text(raised), RAISED, "^")
        case "mover", [base, accent]:
            mark, under = OVER.get(accent.text or "", ""), _text(base)
            return under + mark if len(under) == 1 else under
        case "mtable", _:
            return "; ".join(
                ", ".join(filter(None, (_text(cell).strip() for cell in row))) for row in children
            )
        case _:
            return _row(children)


def _row(children: list[Element]) -> str:
    """Letters side by side are a product, and stand apart; those of a word or a unit (`cm²`) are upright, and do not."""
    out = ""
    for before, child in zip([None, *children], children, strict=False):
        word = _text(child)
        product = (
            out and word and (out[-1].isalnum() or out[-1] in ")") and (word[0].isalpha() or word[0] == "√")
        )
        differential = out.endswith(("Δ", "∂")) or (out.endswith("d") and len(word) == 1)
        one_word = before is not None and _upright(before) and _upright(child)
        if product and child.tag != "mo" and not differential and not one_word:
            out += " "
        out += word
    return out


def _upright(element: Element) -> bool:
    """Whether it is a letter of a word or a unit, or begins with one."""
    if element.tag in ("msup", "msub"):
        return _upright(element[0])
    return element.tag == "mi" and element.get("mathvariant") == "normal"


def _operator(element: Element) -> str:
    text = element.text or ""
    if text == "\u2061":
        return " " if element.get("rspace") else ""
    if text in SPACED and element.get("form") != "prefix":
        return f" {text} "
    return ", " if text == "," and element.get("rspace") != "0" else text


def _letter(letter: str) -> str:
    """A styled letter as an ordinary one: terminals have few of them."""
    return (
        unicodedata.normalize("NFKC", letter)
        if unicodedata.name(letter, "").startswith("MATHEMATICAL")
        else letter
    )


def _grouped(element: Element) -> str:
    """The text in parentheses, unless it is one word or has them."""
    text = _text(element).strip()
    depths = list(accumulate((letter == "(") - (letter == ")") for letter in text))
    enclosed = text.endswith(")") and all(depths[:-1])
    word = all(letter.isalnum() or letter == "_" or unicodedata.combining(letter) for letter in text)
    return text if enclosed or word or len(text) == 1 else f"({text})"


def _script(text: str, letters: dict[str, str], sign: str) -> str:
    """Raised or lowered signs for a number or one letter, else the sign and the text."""
    text = text.replace(" ", "")
    if all(letter in letters for letter in text) and (
        len(text) == 1 or not any(letter.isalpha() for letter in text)
    ):
        return "".join(letters[letter] for letter in text)
    return sign + (text if text.replace(",", "").isalnum() else f"({text})")
