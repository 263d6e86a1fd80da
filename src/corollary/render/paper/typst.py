"""Typst's markup: Markdown and formulas as it has them, and a tagged PDF made of it, the same bytes every time."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import lru_cache, wraps
from importlib import import_module
from importlib.resources import files
from typing import Any, Final
from xml.etree.ElementTree import Element

from markdown_it.tree import SyntaxTreeNode

from corollary.extras import installing
from corollary.messages import speak, spoken
from corollary.parallel import Workers
from corollary.render.markdown import parser
from corollary.render.mathml import APPLY, CLOSING, formula
from corollary.render.pictures import as_svg, lifted
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


USUAL, LARGE = "11pt", "18pt"
STANDARD: Final = "ua-1"
"""With it Typst refuses to write a file in which a formula or a picture has no words."""

NO_LETTER: Final = "could not be displayed with font"
ALL_FONTS: Final = (
    0x180  # characters below are those of Latin 1 and Latin Extended-A, which Typst's own fonts have
)


class CannotTypeset(RuntimeError):
    """There is no Typst here, or it refuses what was to be set; one sentence says which, and what to do."""


def typesetter(module: str) -> Any:
    """A module of the extra `pdf`. Raises CannotTypeset where it is not installed."""
    try:
        return import_module(module)
    except ImportError as error:
        raise CannotTypeset(
            f"PDF needs the Python package {module}; install it with: {installing('pdf')}"
        ) from error


def pdf(sheets: Sequence[str], title: str, *, large: bool = False) -> bytes:
    """One file with these sheets, each with its own count of pages. Raises CannotTypeset."""
    size, show = (LARGE if large else USUAL), literal(spoken())
    opening = f"#show: paper.with(lang: {show}, title: {literal(title)}, size: {size})\n\n"
    source = (_style() + opening + "\n\n".join(sheets)).encode("utf-8", "replace")
    typst = typesetter("typst")
    for others in (False, True):
        try:
            return _compiler(others).compile(input=source, format="pdf", pdf_standards=STANDARD)
        except typst.TypstError as error:
            refused = error
            if NO_LETTER not in error.message:
                break
    why = f"no font on this machine has a character of the text ({refused.message}); install one that has it"
    why = why if NO_LETTER in refused.message else refused.message
    raise CannotTypeset(f"{title} cannot be set on paper: {why}") from refused


def without_font(texts: Iterable[str]) -> frozenset[str]:
    """The texts with a character that neither Typst's fonts nor this machine's have. Raises CannotTypeset without the extra `pdf`.

    They are tried in a process of their own: Typst starts threads, and a process forked after that waits for them for ever."""
    odd = [text for text in texts if any(ord(letter) >= ALL_FONTS for letter in text)]
    if not odd:
        return frozenset()
    typesetter("typst")
    with Workers(1, speak, spoken()) as pool:
        return pool.submit(_without_font, odd).result()


def _without_font(texts: Iterable[str]) -> frozenset[str]:
    return frozenset(text for text in texts if not _has_font(text))


def _has_font(text: str) -> bool:
    typst = typesetter("typst")
    source = f"#set document(title: {literal(spoken())})\n{words_of(text)}".encode("utf-8", "replace")
    for others in (False, True):
        try:
            _compiler(others).compile(input=source, format="pdf", pdf_standards=STANDARD)
            return True
        except typst.TypstError as error:
            if NO_LETTER not in error.message:
                raise CannotTypeset(f"{text} cannot be set on paper: {error.message}") from None
    return False


@lru_cache(maxsize=2)
def _compiler(others: bool) -> Any:
    """One for all files of this process: fonts are loaded once, and what was laid out before is remembered. `others`: with the
    fonts of the machine too, for letters that Typst's own do not have."""
    typst = typesetter("typst")
    return typst.Compiler(font_paths=typst.Fonts(include_system_fonts=others))


@lru_cache(maxsize=1)
def _style() -> str:
    return files("corollary.render").joinpath("templates", "paper.typ").read_text(encoding="utf-8")
