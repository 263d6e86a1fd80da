"""A formula in a line of plain text, for a terminal: `J = F Δt`, `√(2 g h)`, `(m_A v_A + m_B v_B)/(m_A + m_B)`."""

from __future__ import annotations

import re
import unicodedata
from itertools import accumulate
from xml.etree.ElementTree import Element

from corollary.render.maths import formula

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


def plain_formula(latex: str) -> str:
    """The formula as readable text, or its source when it is no LaTeX."""
    tree = formula(latex)
    return latex if tree is None else re.sub(" +", " ", _said(tree)).strip().replace(QUAD, "   ")


def _said(element: Element) -> str:
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
            return f"{_script(_said(degree), RAISED, '')}√({_said(inside)})"
        case "munder" | "mover", [base, brace] if brace.text in {"⏟", "⏞"}:
            return _said(base)
        case "msup", [base, raised]:
            return _said(base) + _script(_said(raised), RAISED, "^")
        case "msub" | "munder", [base, lowered]:
            return _said(base) + _script(_said(lowered), LOWERED, "_")
        case "msubsup" | "munderover", [base, lowered, raised]:
            return _said(base) + _script(_said(lowered), LOWERED, "_") + _script(_said(raised), RAISED, "^")
        case "mover", [base, accent]:
            mark, under = OVER.get(accent.text or "", ""), _said(base)
            return under + mark if len(under) == 1 else under
        case "mtable", _:
            return "; ".join(
                ", ".join(filter(None, (_said(cell).strip() for cell in row))) for row in children
            )
        case _:
            return _row(children)


def _row(children: list[Element]) -> str:
    """Letters side by side are a product, and stand apart."""
    said = ""
    for child in children:
        word = _said(child)
        product = (
            said
            and word
            and (said[-1].isalnum() or said[-1] in ")")
            and (word[0].isalpha() or word[0] == "√")
        )
        differential = said.endswith(("Δ", "∂")) or (said.endswith("d") and len(word) == 1)
        if product and child.tag != "mo" and not differential:
            said += " "
        said += word
    return said


def _operator(element: Element) -> str:
    text = element.text or ""
    if text == "\u2061":
        return " " if element.get("rspace") else ""
    if text in SPACED and element.get("form") != "prefix":
        return f" {text} "
    return ", " if text == "," and element.get("rspace") != "0" else text


def _letter(letter: str) -> str:
    """A styled letter as a plain one: terminals have few of them."""
    return (
        unicodedata.normalize("NFKC", letter)
        if unicodedata.name(letter, "").startswith("MATHEMATICAL")
        else letter
    )


def _grouped(element: Element) -> str:
    """The text in parentheses, unless it is one word or has them."""
    said = _said(element).strip()
    depths = list(accumulate((letter == "(") - (letter == ")") for letter in said))
    enclosed = said.endswith(")") and all(depths[:-1])
    word = all(letter.isalnum() or letter == "_" or unicodedata.combining(letter) for letter in said)
    return said if enclosed or word or len(said) == 1 else f"({said})"


def _script(text: str, letters: dict[str, str], sign: str) -> str:
    """Raised or lowered signs for a number or one letter, else the sign and the text."""
    text = text.replace(" ", "")
    if all(letter in letters for letter in text) and (
        len(text) == 1 or not any(letter.isalpha() for letter in text)
    ):
        return "".join(letters[letter] for letter in text)
    return sign + (text if text.replace(",", "").isalnum() else f"({text})")
