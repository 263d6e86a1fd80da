"""A formula on a page, and on lines of its own: LaTeX becomes MathML that a browser lays out, offline, and a screen reader says.

What TeX knows of setting formulas a browser must be told: upright words, functions, signs, primes, accents.

Browsers do not break MathML. So each piece is a `<math>` of its own: equations first, then what stands between relations,
between signs, between factors in brackets. What is still wider than a phone scrolls, and can be reached by keyboard.
"""

from __future__ import annotations

import html
import re
import unicodedata
from collections.abc import Iterator, Sequence
from functools import lru_cache
from itertools import accumulate, groupby, pairwise
from typing import Final
from xml.etree.ElementTree import Element

from latex2mathml.converter import convert_to_element

from corollary.messages import catalogue

_ = catalogue(__name__)

LONGEST, DEEPEST = 4000, 60
DEFINES = re.compile(r"\\(newcommand|renewcommand|def|DeclareMathOperator|newenvironment)\b")
# The number and unit of a filled hole (`20.0 m/s`, joined by a no-break space): the unit stands upright in a formula.
SYMBOL = r"[A-Za-zµΩÅ%°][A-Za-zµΩÅ%°/·⁰¹²³⁴⁵⁶⁷⁸⁹⁻^0-9.()]*"
MEASURED = re.compile(rf"\u00a0({SYMBOL}(?: {SYMBOL})*)")
CHILDREN = {
    "mfrac": 2,
    "mroot": 2,
    "msub": 2,
    "msup": 2,
    "mover": 2,
    "munder": 2,
    "msubsup": 3,
    "munderover": 3,
}
ROWS = frozenset({"math", "mrow", "mstyle", "mtd", "msqrt", "mphantom", "mpadded", "menclose"})
TAGS = ROWS | CHILDREN.keys() | {"mi", "mn", "mo", "mspace", "mtable", "mtext", "mtr"}
ATTRIBUTES = frozenset(
    re.findall(
        r"\w+",
        """
    accent accentunder columnalign depth display displaystyle fence form height largeop linethickness
    lspace maxsize minsize movablelimits notation rspace scriptlevel separator stretchy symmetric
    voffset width
    """,
    )
)
# Words, or lengths of at most two digits: no formula may push the rest of the page away.
VALUE = re.compile(r"[a-z -]{1,20}|[+-]?[0-9]{0,2}(\.[0-9]{0,4})?[a-z%]{0,3}")
ENTITY = re.compile(r"&#x([0-9A-Fa-f]{1,6});")
UNSEEN = re.compile("[\x00-\x1f\x7f\ud800-\udfff\ufffe\uffff]")  # what XML knows no letter for
SYMBOLS = frozenset("−·×±÷≈≤≥°→")
ACCENTS = {"^": "ˆ", "~": "˜", "→": "→", "¯": "¯", "―": "‾", "˙": "˙", "¨": "¨"}
BARS, LIMITS = frozenset("|‖∥"), frozenset({"lim", "max", "min", "sup", "inf"})
SIGNS, CLOSING = frozenset("−-+±∓"), frozenset(")]}|!‖⟩°%′″")
APPLY, THIN = "\u2061", "0.167em"


@lru_cache(maxsize=4096)
def formula(latex: str, *, display: bool = False) -> Element | None:
    """The MathML of a formula, made only of elements and attributes known to be harmless; None when it is no LaTeX.

    The tree is shared: read it, and leave it as it is.
    """
    depths = accumulate((letter == "{") - (letter == "}") for letter in latex)
    if len(latex) > LONGEST or DEFINES.search(latex) or max(depths, default=0) > DEEPEST:
        return None
    latex = UNSEEN.sub(" ", latex)
    text = re.sub(r"\\(begin|end)\{aligned\}", r"\\\1{split}", prepared(latex))
    try:
        tree = typeset(convert_to_element(text, xmlns="", display="block" if display else "inline"))
    except Exception:  # malformed LaTeX ends there in a dozen unrelated exceptions (IndexError, StopIteration, KeyError, ...)
        return None
    tree.set("alttext", latex)
    return tree


def prepared(latex: str) -> str:
    """The LaTeX with units of filled holes upright, and percent signs meant as such: no formula here holds comments."""
    text = MEASURED.sub(lambda unit: rf"\,\text{{{unit[1]}}}", latex)
    return re.sub(r"(?<!\\)%", r"\\%", text)


@lru_cache(maxsize=4096)
def mathml(latex: str, *, display: bool = False) -> str:
    """A `<math>` element for a page, or the source as code when it is no LaTeX."""
    tree = formula(latex, display=display)
    if tree is None:
        return f'<code class="latex">{html.escape(latex)}</code>'
    return written(tree)


def written(element: Element) -> str:
    """The tree as it stands in a page."""
    attributes = "".join(f' {name}="{html.escape(value)}"' for name, value in element.attrib.items())
    inside = html.escape(element.text or "", quote=False) + "".join(map(written, element))
    return f"<{element.tag}{attributes}>{inside}</{element.tag}>"


def typeset(element: Element) -> Element:
    """A copy for the page of what latex2mathml made; unknown elements become rows, unknown attributes are left out.

    Raises ValueError when an element has too few or too many children.
    """
    text = UNSEEN.sub("", ENTITY.sub(lambda entity: chr(int(entity[1], 16)), element.text or ""))
    tag = element.tag if element.tag in TAGS else "mrow"
    if tag in {"mi", "mtext"} and text in SYMBOLS:
        tag = "mo"
    elif tag == "mo" and (
        text == "∞" or (len(text) > 1 and text.isalpha() and text != "mod")
    ):  # \operatorname{sgn} is a name
        tag = "mi"
    copy = Element(
        tag,
        {
            name: value
            for name, value in element.attrib.items()
            if name in ATTRIBUTES and VALUE.fullmatch(value)
        },
    )
    style = element.get("mathvariant", "")
    # A lone letter of \mathrm arrives as an entity without a style; TeX sets capital Greek upright.
    if tag == "mi" and (
        style == "normal" or (ENTITY.fullmatch(element.text or "") and text.isascii()) or "Α" <= text <= "Ω"
    ):
        copy.set("mathvariant", "normal")
    copy.text = _styled(text, style) if style not in {"", "normal"} else text
    if tag == "mo" and (text == "/" or text in BARS):
        copy.attrib.update(lspace="0", rspace="0", stretchy=element.get("stretchy", "false"))
    children = [typeset(child) for child in element]
    if len(children) != CHILDREN.get(tag, len(children)):
        raise ValueError(f"{tag} has {len(children)} children")
    if tag == "mover" and children[1].tag == "mo" and children[1].text in ACCENTS:
        _accented(copy, *children)
    elif tag == "msup" and children[1].tag == "mi" and set(children[1].text or " ") <= {"′", "″", "‴"}:
        copy.tag = "mrow"  # a prime is raised already
        children[1].tag = "mo"
        children[1].attrib.update(lspace="0", rspace="0")
    elif tag == "msub" and children[0].text in LIMITS:
        copy.tag = "munder"
        children[0].tag = "mo"
        children[0].attrib.update(movablelimits="true", lspace="0", rspace=THIN)
    elif tag == "mrow" and [child.text for child in children] == [","]:  # 3{,}5 is a decimal comma
        children[0].attrib.update(lspace="0", rspace="0")
    copy.extend(_applied(_signed(_joined(children))) if tag in ROWS else children)
    return copy


def _styled(letters: str, style: str) -> str:
    """Bold, script and so on as letters of their own: browsers no longer heed the attribute."""

    def styled(letter: str) -> str:
        alphabet, _, rest = unicodedata.name(letter, "").partition(" ")
        name = f"MATHEMATICAL {style.upper().replace('-', ' ')} {rest.replace('LETTER ', '')}"
        try:
            return unicodedata.lookup(name) if alphabet in {"LATIN", "GREEK", "DIGIT"} else letter
        except KeyError:
            return letter

    return "".join(map(styled, letters))


def _accented(over: Element, base: Element, accent: Element) -> None:
    """Small accents over one letter; over more they stretch."""
    over.set("accent", "true")
    letters = sum(element.tag in {"mi", "mn"} for element in base.iter())
    if letters == 1:
        accent.text = ACCENTS[accent.text or ""]
        accent.set("stretchy", "false")
        if accent.text == "→":
            accent.set("mathsize", "65%")
    else:
        accent.set("stretchy", "true")


def _joined(children: list[Element]) -> list[Element]:
    """Upright letters one by one (`n` `e` `t`) become one word, for the eye and for the voice."""
    joined: list[Element] = []
    for upright, letters in groupby(
        children, lambda child: child.tag == "mi" and child.get("mathvariant") == "normal"
    ):
        run = list(letters)
        if upright and len(run) > 1 and all((letter.text or "").isascii() for letter in run):
            run[0].text = "".join(letter.text or "" for letter in run)
            del run[1:]
        joined += run
    return joined


def _signed(children: list[Element]) -> list[Element]:
    """A sign that comes first, or after another operator, belongs to the number behind it."""
    if children and children[0].tag == "mo" and children[0].text in SIGNS:
        children[0].set("form", "prefix")
    for before, sign in pairwise(children):
        if (
            sign.tag == "mo"
            and sign.text in SIGNS
            and before.tag == "mo"
            and (before.text or "") not in CLOSING
        ):
            sign.set("form", "prefix")
    return children


def _applied(children: list[Element]) -> list[Element]:
    """The row with the invisible sign of application after each function's name, and TeX's thin spaces around it."""
    row: list[Element] = []
    for place, child in enumerate(children):
        if not _is_function(child):
            row.append(child)
            continue
        if row and row[-1].tag not in {"mo", "mspace"}:
            row.append(Element("mspace", {"width": THIN}))
        row.append(child)
        after = children[place + 1] if place + 1 < len(children) else None
        if after is not None and (after.tag != "mo" or after.text in {"(", "["}):
            opens = after.text in {"(", "["} or (len(after) > 0 and after[0].get("form") == "prefix")
            apply = Element("mo", {} if opens else {"rspace": THIN})
            apply.text = APPLY
            row.append(apply)
    return row


def _is_function(element: Element) -> bool:
    if element.tag in {"msub", "msup", "msubsup", "munder"}:
        return _is_function(element[0])
    return element.tag == "mi" and len(element.text or "") > 1 and "mathvariant" not in element.attrib


NARROW: Final = 13.0
"""What fits a phone of 320 pixels, in em."""
RELATIONS, TIMES = frozenset("=≈≡∼≠<>≤≥≪≫∝→⇒"), frozenset("·×")
OPENING, CLOSING_BRACKETS = frozenset("([{⟨"), frozenset(")]}⟩")
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
            return (
                0.4 if (element.text or "") in OPENING | CLOSING_BRACKETS | BARS else 1.1 if letters else 0.0
            )
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
        depth += (text in OPENING) - (text in CLOSING_BRACKETS)
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
    return text in TIMES or (_bracketed(before, -1, CLOSING_BRACKETS) and _bracketed(element, 0, OPENING))


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
