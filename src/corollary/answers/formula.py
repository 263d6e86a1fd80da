"""Formulas out of what a student typed: in the symbols of the problem, with the dimension asked for."""

from __future__ import annotations

import re
from collections.abc import Collection

from corollary.answers.answer import Formulas, Unclear
from corollary.answers.motion_words import motion_in_number
from corollary.answers.number_words import product_in_signs
from corollary.answers.preamble import answer_in
from corollary.answers.question import Question
from corollary.answers.remark import remark_in
from corollary.formula.abbreviations import arity, function_words
from corollary.formula.ast import Expr, names
from corollary.formula.by_hand import by_hand
from corollary.formula.errors import ParseError, refused, sentence
from corollary.formula.line import Lean
from corollary.formula.numerals import LONGEST, TO_ASCII
from corollary.formula.syntax import parse
from corollary.formula.text import text as formula_text
from corollary.messages import catalogue
from corollary.units.dimensional_analysis import dimension_of
from corollary.units.unit import Dimension, Unit, called, read_unit, show

_ = catalogue(__name__)

LONGEST_QUOTED = 80
MOST_WORDS = 20
# `1,234` may be thousands, and the comma may part the two numbers of a function.
DECIMAL_COMMA = re.compile(
    r"(?<=[0-9]),(?=(?:[0-9]{1,2}|[0-9]{4,})(?![0-9.,]))|(?<=0)(?<![0-9.,]0),(?=[0-9]{3}(?![0-9.,]))"
)
SEVERAL = re.compile(
    rf"(?<![A-Za-z])(?:{'|'.join(sorted(word for word, name in function_words().items() if arity(name) > 1 or name == 'ln'))})(?![A-Za-z])"
)
LOGARITHM = re.compile(r"(?<![A-Za-z])log(?![A-Za-z0-9_])")


def formula(text: str, question: Question, lean: Lean = "ask") -> Expr | ParseError:
    """A formula that uses at least one symbol of the problem."""
    tree = formula_in(text, question.symbol_names, question.unit, lean)
    if not isinstance(tree, ParseError) and not names(tree) - {"pi"}:
        return refused(_("this has no letters of the problem in it"))
    return tree


def formula_in(
    text: str, letters: Collection[str], unit: Unit | None, lean: Lean = "ask"
) -> Expr | ParseError:
    """The formula in these letters that a text is; `unit` may stand behind it, being what is asked for."""
    tree = parse(text, letters, lean=lean)
    if not isinstance(tree, ParseError) or len(text) > LONGEST:
        return tree
    bare, _skipped = answer_in(motion_in_number(by_hand(text)).translate(TO_ASCII))
    pointed = with_points(bare)
    for candidate in dict.fromkeys((bare, pointed, _in_signs(pointed, letters, unit))):
        again = parse(candidate, letters, lean=lean)
        if not isinstance(again, ParseError) or again.status == "asked":
            return again
    return tree


def with_points(formula: str) -> str:
    """Decimal commas as points, where they can be nothing else: `0,5*m*v^2`, but not `1,234*v` nor `hypot(3,4)`."""
    return formula if SEVERAL.search(formula) else DECIMAL_COMMA.sub(".", formula)


def _in_signs(text: str, letters: Collection[str], unit: Unit | None) -> str:
    """`2 x v`, `twice v` as `2*v`; without the unit asked for, or harmless words, behind it."""
    remark = remark_in(text)
    text = product_in_signs(remark.text if remark and remark.harmless else text, cross="x" not in letters)
    words = text.split(" ")
    for start in range(1, len(words)) if unit and unit.factor == 1 and len(words) <= MOST_WORDS else ():
        if read_unit(" ".join(words[start:])) == unit:
            return " ".join(words[:start])
    return text


def fitting(text: str, question: Question) -> Expr | Unclear | None:
    """Of the readings of `m v cos θ/M`, the one with the dimension asked for; both, when both have it."""
    trees = [formula(text, question, lean) for lean in ("near", "far")]
    good = [
        tree
        for tree in trees
        if not isinstance(tree, ParseError) and dimension_in(tree, question) == question.unit.dimension
    ]
    if len(good) < 2:
        return good[0] if good else None
    read = formula(text, question)
    why = sentence(read) if isinstance(read, ParseError) else _("this formula can be read in two ways")
    return Unclear(why, as_typed(text), tuple(formulas(tree) for tree in good))


def formulas(*trees: Expr, typed: str = "") -> Formulas:
    """The answer, shown as it was read: `2mv` is 2*m*v, and the `log` that was typed is the natural one."""
    texts = ", ".join(map(formula_text, trees))
    return Formulas(trees, with_remark(texts if len(trees) == 1 else f"({texts})", typed))


def with_remark(as_read: str, typed: str) -> str:
    """A formula as it was read, with a remark where `log` was typed for it."""
    if not LOGARITHM.search(typed):
        return as_read
    return _("{formula}, where log is the natural logarithm", formula=as_read)


def dimension_in(tree: Expr, question: Question) -> Dimension | ParseError:
    """What a formula of the problem's symbols measures."""
    return dimension_of(tree, question.dimensions)


def other_dimension(tree: Expr, dimension: Dimension, unit: Unit) -> str:
    """What is said of a formula that measures something else than was asked for."""
    return _(
        "{formula} is not in {unit}: it is {kind}",
        formula=as_typed(formula_text(tree)),
        unit=show(unit) or _("plain numbers"),
        kind=called(dimension),
    )


def symbols_note(question: Question, more: str = "") -> str:
    """How each symbol is typed and what it stands for, below a question that is answered in formulas."""
    known = ", ".join(f"`{symbol.name}` ({symbol.meaning})" for symbol in question.symbols)
    return _("Letters: {known}{more}. Write `*` for a product and `^` for a power.", known=known, more=more)


def as_typed(text: str) -> str:
    """What was typed, cut short where it is long."""
    stripped = text.strip()
    return stripped if len(stripped) <= LONGEST_QUOTED else stripped[: LONGEST_QUOTED - 1] + "…"
