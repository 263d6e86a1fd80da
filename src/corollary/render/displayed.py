"""A formula on lines of its own, in pieces between which a narrow screen may break it.

Browsers do not break MathML. So each piece is a `<math>` of its own: equations first, then what stands between relations,
between signs, between factors in brackets. What is still wider than a phone scrolls, and can be reached by keyboard.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import lru_cache
from typing import Final
from xml.etree.ElementTree import Element

from corollary.messages import catalogue
from corollary.render.mathml import BARS, SIGNS, formula, mathml, written

_ = catalogue(__name__)
NARROW: Final = 13.0
"""What fits a phone of 320 pixels, in em."""
RELATIONS, TIMES = frozenset("=≈≡∼≠<>≤≥≪≫∝→⇒"), frozenset("·×")
OPENING, CLOSING = frozenset("([{⟨"), frozenset(")]}⟩")
BETWEEN_EQUATIONS, BETWEEN_RELATIONS, BETWEEN_SIGNS, BETWEEN_FACTORS = range(4)


@lru_cache(maxsize=4096)
def displayed(latex: str) -> str:
    """The HTML of a formula on lines of its own."""
    tree = formula(latex, display=True)
    row = _row(tree) if tree is not None else list[Element]()
    if width(row) <= NARROW:
        return f'<div class="formula">{mathml(latex, display=True)}</div>\n'
    pieces, widest = _pieces(row, BETWEEN_EQUATIONS)
    if "</math><" not in pieces:
        pieces = mathml(latex, display=True)
    label = _("a wide formula; it scrolls sideways")
    reached = f' tabindex="0" role="group" aria-label="{label}"' if widest > NARROW else ""
    return f'<div class="formula"{reached}>{pieces}</div>\n'


def width(row: Sequence[Element]) -> float:
    """About how wide a row is set, in em; rather too wide than too narrow."""
    return sum(map(_width, row))


def _width(element: Element) -> float:
    letters = len(element.text or "")
    below = [_width(child) for child in element]
    match element.tag:
        case "mo":
            return 0.4 if (element.text or "") in OPENING | CLOSING | BARS else 1.1 if letters else 0.0
        case "mi" | "mn" | "mtext":
            return 0.56 * letters
        case "mspace":
            size = element.get("width", "")
            return float(size.removesuffix("em")) if size.endswith("em") else 0.3
        case "mfrac" | "mover" | "munder" | "munderover":
            return max(below) + 0.2
        case "msub" | "msup" | "msubsup":
            return below[0] + 0.75 * max(below[1:])
        case "mtable":
            return max(below, default=0.0)
        case "mtr":
            return sum(below) + 0.8 * len(below)
        case "msqrt" | "mroot":
            return sum(below) + 0.9
        case _:
            return sum(below)


def _row(tree: Element) -> Sequence[Element]:
    """The row that the formula is, without the rows around it."""
    while len(tree) == 1 and tree.tag in {"math", "mrow"} and tree[0].tag == "mrow":
        tree = tree[0]
    return list(tree)


def _pieces(row: Sequence[Element], level: int) -> tuple[str, float]:
    """The row in pieces no wider than they must be, and the width of the widest."""
    if level > BETWEEN_FACTORS or width(row) <= NARROW:
        return _math(row), width(row)
    parts = list(_split(row, level))
    if len(parts) == 1:
        return _pieces(row, level + 1)
    found = [_pieces(part, level + 1) for part in parts]
    return "".join(f"<span>{text}</span>" for text, _ in found), max(wide for _, wide in found)


def _split(row: Sequence[Element], level: int) -> Iterator[Sequence[Element]]:
    start, depth, in_bars = 0, 0, False
    for at, element in enumerate(row):
        text = _operator(element)
        if at > start and depth == 0 and not in_bars and _breaks(row[at - 1], element, level):
            yield row[start:at]
            start = at
        depth += (text in OPENING) - (text in CLOSING)
        in_bars ^= text in BARS
    yield row[start:]


def _breaks(before: Element, element: Element, level: int) -> bool:
    """Whether a line may end between the two."""
    text = _operator(element)
    if level == BETWEEN_EQUATIONS:
        return before.tag == "mspace" and before.get("width") in {"1em", "2em"}
    if level == BETWEEN_RELATIONS:
        return text in RELATIONS
    if level == BETWEEN_SIGNS:
        return text in SIGNS and element.get("form") != "prefix"
    return text in TIMES or (_bracketed(before, -1, CLOSING) and _bracketed(element, 0, OPENING))


def _operator(element: Element) -> str:
    """The operator that the element is, with or without an exponent: `)` of `)^2` too; or nothing."""
    while element.tag in {"msub", "msup", "msubsup"}:
        element = element[0]
    return (element.text or "") if element.tag == "mo" else ""


def _bracketed(element: Element, end: int, brackets: frozenset[str]) -> bool:
    """Whether the element is, or has at this end, one of the brackets."""
    while element.tag in {"mrow", "msup"} and len(element):
        element = element[0 if element.tag == "msup" else end]
    return _operator(element) in brackets


def _math(row: Sequence[Element]) -> str:
    """The row as a formula of its own; an operator that now stands first is still one between two things."""
    first = row[0]
    if first.tag == "mo" and (first.text or "") in RELATIONS | SIGNS | TIMES and first.get("form") is None:
        first = Element("mo", first.attrib | {"form": "infix"})
        first.text = row[0].text
    whole = Element("math", {"displaystyle": "true"})
    whole.extend([first, *row[1:]])
    return written(whole)
