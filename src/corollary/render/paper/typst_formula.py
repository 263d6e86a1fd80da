"""A formula as Typst sets it, made of the tree that pages show as MathML, with words for who cannot see it."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from functools import lru_cache, wraps
from typing import Final
from xml.etree.ElementTree import Element

from corollary.render.mathml import APPLY, CLOSING, formula
from corollary.render.terminal_text import formula_text

HOLES: Final = "٠۰߀०০੦૦୦௦౦೦൦෦๐໐༠၀႐០᠐᥆᧐᪀᪐᭐᮰᱀᱐꘠꣐꤀꧐꧰꩐꯰"
"""A zero for each number of a formula, each of a script that no formula is written in: to every converter it is a digit."""
NUMBER = re.compile(r"(?<=[ (])(?:\d+\.\d+|\d\d+)(?![\d.])", re.ASCII)
"""A number in a row, of two digits or more; shorter ones are mostly of the formula itself."""
FILLED = re.compile(rf"([{HOLES}])\.?\1")
SET_OTHERWISE = re.compile(
    rf"[{HOLES}]|[_^]\s*\{{[^{{}}]*[{{( ]|[_^][ (]|\\(?!mathrm\b)(?:math|text|mbox|operatorname|begin)"
)
"""Where numbers may be set by their digits: an index or exponent of several words, bold letters, a text."""


def by_shape(convert: Callable[[str], str]) -> Callable[[str], str]:
    """A conversion of LaTeX that is done once for all formulas that are the same but for their numbers.

    `convert` must keep a number of a row as it stands, and look no further than whether it is whole.
    """
    remembered = lru_cache(maxsize=4096)(convert)

    @wraps(convert)
    def converted(latex: str) -> str:
        numbers = NUMBER.findall(latex)
        if not numbers or len(numbers) > len(HOLES) or SET_OTHERWISE.search(latex):
            return remembered(latex)
        holes = iter(HOLES)
        shape = NUMBER.sub(lambda number: ("." if "." in number[0] else "").join(2 * next(holes)), latex)
        return FILLED.sub(lambda hole: numbers[HOLES.index(hole[1])], remembered(shape))

    return converted


OPENING: Final = frozenset("([{⟨")
ACCENTS: Final = {"→": "arrow", "ˆ": "hat", "˜": "tilde", "¯": "macron", "‾": "overline", "˙": "dot", "¨": "dot.double"}  # fmt: skip


def typst_formula(latex: str, *, display: bool = False) -> str:
    """The formula in Typst's markup: in a line of text, or on lines of its own; its source as code when it is no LaTeX."""
    return _displayed(latex) if display else _in_line(latex)


@by_shape
def _in_line(latex: str) -> str:
    return _call(latex, "")


@by_shape
def _displayed(latex: str) -> str:
    return _call(latex, " ")  # which is how Typst tells the two apart


def _call(latex: str, gap: str) -> str:
    tree = formula(latex)
    if tree is None:
        return f"#raw({literal(latex)});"
    return f"#formula({literal(formula_text(latex))},${gap}{_row(list(tree))}{gap}$);"


def literal(text: str) -> str:
    """A text as a string of Typst's: nothing in it is markup."""
    escaped = text.replace("\\", "\\\\").replace('"', '\\"').replace("\n", "\\n").replace("\t", " ")
    return f'"{escaped}"'


def _row(elements: Sequence[Element]) -> str:
    return "".join(map(_typst, elements))


def _group(element: Element) -> str:
    """An argument of a function: empty brackets, too, are one."""
    return _typst(element) or '#"";'


def _typst(element: Element) -> str:
    children, text = list(element), element.text or ""
    match element.tag, children:
        case "mi", _:
            return _letters(text, upright=element.get("mathvariant") == "normal")
        case "mn" | "mtext", _:
            return f"#{literal(text)};" if text else ""
        case "mo", _:
            return _operator(element, text)
        case "mspace", _:
            return f"#h({_length(element.get('width', '0em'))});"
        case "mfrac", [above, below]:
            return f"frac({_group(above)},{_group(below)})"
        case "msqrt", _:
            return f"sqrt({_row(children)})"
        case "mroot", [inside, degree]:
            return f"root({_group(degree)},{_group(inside)})"
        case "msup", [base, raised]:
            return f"attach({_group(base)},t:{_group(raised)})"
        case "msub" | "munder", [base, lowered]:
            return f"attach({_group(base)},b:{_group(lowered)})"
        case "msubsup" | "munderover", [base, lowered, raised]:
            return f"attach({_group(base)},b:{_group(lowered)},t:{_group(raised)})"
        case "mover", [base, accent] if accent.text in ACCENTS:
            name = ACCENTS[accent.text]
            return (
                f"overline({_group(base)})" if name == "overline" else f"accent({_group(base)},#sym.{name})"
            )
        case "mover", [base, above]:
            return f"attach(limits({_group(base)}),t:{_group(above)})"
        case "mtable", _:
            rows = ";".join(",".join(map(_group, line)) for line in children)
            return f"mat(delim:#none,{rows})"
        case _:
            return _fenced(children)


def _fenced(children: Sequence[Element]) -> str:
    """A row; brackets around the whole of it grow with what they hold."""
    if len(children) > 1 and _fence(children[0], "prefix"):
        ends = _fence(children[-1], "postfix")
        return f"lr({_row(children)})" if ends else f"lr({_row(children)}#none)"
    return _row(children)


def _fence(element: Element, form: str) -> bool:
    return element.tag == "mo" and element.get("form") == form and element.get("stretchy") == "true"


def _letters(text: str, *, upright: bool) -> str:
    if not upright:
        return _symbol(text) if len(text) == 1 else f"op(#{literal(text)};)"
    return f"upright({_symbol(text)})" if len(text) == 1 else f"upright(#{literal(text)};)"


def _operator(element: Element, text: str) -> str:
    if not text:
        return ""
    if text == APPLY:
        return f"#h({element.get('rspace')});" if element.get("rspace") else ""
    if len(text) > 1:
        limits = ",limits:#true" if element.get("movablelimits") else ""
        return f"op(#{literal(text)};{limits})"
    if _fence(element, "prefix") or text in OPENING:
        return f'class("opening",{_symbol(text)})'
    if _fence(element, "postfix") or text in CLOSING - frozenset("!°%′″"):
        return f'class("closing",{_symbol(text)})'
    tight = element.get("lspace") == "0" or element.get("form") == "prefix"
    return f'class("normal",{_symbol(text)})' if tight else _symbol(text)


def _symbol(text: str) -> str:
    """A letter or sign by itself. Escaped it means nothing else to Typst, and is read sooner than a call."""
    return f"\\{text}" if text.isprintable() and not text.isspace() else f"#symbol({literal(text)});"


def _length(text: str) -> str:
    """A length of MathML in Typst: em and pt are the same, what else there is counts as a thin space."""
    return text if text.endswith(("em", "pt")) else "0.167em"
