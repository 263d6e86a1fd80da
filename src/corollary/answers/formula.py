"""Formulas out of what a student typed: in the symbols of the problem, with the dimension asked for."""

from __future__ import annotations

import math
import re
from collections.abc import Collection, Sequence

from corollary.answers.answer import Formulas, Unclear
from corollary.answers.left_side import (
    as_formula,
    gives,
    gives_what_is_asked,
    is_another_given,
    named,
    solvable,
    turns,
    unknown_letter,
)
from corollary.answers.motion_words import motion_in_number
from corollary.answers.name import is_name, keyboard
from corollary.answers.number_words import product_in_signs
from corollary.answers.preamble import answer_in
from corollary.answers.question import Question
from corollary.answers.remark import remark_in
from corollary.formula.abbreviations import arity, function_words
from corollary.formula.arithmetics import DOUBLES, ready
from corollary.formula.ast import Expr, names
from corollary.formula.by_hand import by_hand
from corollary.formula.errors import ParseError, refused, sentence
from corollary.formula.line import Lean
from corollary.formula.numerals import LONGEST, TO_ASCII
from corollary.formula.plain_text import text as formula_text
from corollary.formula.syntax import parse
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
EQUALS = re.compile(r"[=≈]|\\(?:approx|simeq|sim)\b|\s~\s")
TWO_LINES = re.compile(
    r"[\w)\]}²³]\s*\n\s*[\w(\[{\\]"
)  # no sign at the end of one or the beginning of the next
GLUED_BELOW = re.compile(r"/\s*[0-9]+(?:[.,][0-9]+)?[^\W\d_]")
MINUS = re.compile(r"\s*(?:minus|negative)\s+(?=\S)", re.IGNORECASE)
LOGARITHM = re.compile(r"(?<![A-Za-z])log(?![A-Za-z0-9_])")


def formula(text: str, question: Question, lean: Lean = "ask") -> Expr | ParseError:
    """A formula that uses at least one symbol of the problem."""
    tree = formula_in(text, question.symbol_names, question.unit, lean, question)
    if not isinstance(tree, ParseError) and not names(tree) - {"pi"}:
        return refused(_("this has no letters of the problem in it"))
    return tree


def formula_in(
    text: str,
    letters: Collection[str],
    unit: Unit | None,
    lean: Lean = "ask",
    question: Question | None = None,
) -> Expr | ParseError:
    """The formula in these letters that a text is; `unit` may stand behind it, being what is asked for."""
    if len(text) > LONGEST:
        return parse(text, letters, lean=lean)
    if TWO_LINES.search(text):
        return refused(_("these are two lines"), None, _("write one formula"))
    sides: tuple[str, ...] = ()
    if (minus := MINUS.match(text)) is not None and not EQUALS.search(text):
        text = "-".rjust(minus.end()) + text[minus.end() :]
    if EQUALS.search(text):
        text, _skipped, sides = answer_in(by_hand(text).translate(TO_ASCII))
    tree = _right_side(text, letters, unit, lean)
    if isinstance(tree, ParseError):
        return tree.without_place() if sides else tree
    return _trouble_with(sides, tree, letters, question) or tree


def _right_side(text: str, letters: Collection[str], unit: Unit | None, lean: Lean) -> Expr | ParseError:
    tree = parse(text, letters, lean=lean)
    if not isinstance(tree, ParseError):
        return tree
    bare = answer_in(motion_in_number(by_hand(text)).translate(TO_ASCII), in_letters=True).text
    pointed = with_points(bare)
    for candidate in dict.fromkeys((bare, pointed, _in_signs(pointed, letters, unit))):
        again = parse(candidate, letters, lean=lean)
        if not isinstance(again, ParseError) or again.status == "asked":
            return again
    return tree


def _trouble_with(
    sides: Sequence[str], tree: Expr, letters: Collection[str], question: Question | None
) -> ParseError | None:
    """What is asked about left sides that are neither a name nor the same formula: `2*p = m*v`, `a^2 + b^2 = c^2`."""
    if len(sides) == 1 and question is not None and is_another_given(sides[0], question.unit, question):
        why = _("{letter} is given, and is not what is asked for", letter=sides[0].strip())
        return ParseError("asked", why, None, _("write the formula alone"))
    if len(sides) == 1 and (letter := keyboard(sides[0]).strip()) in names(tree):
        why = _("{letter} stands on both sides", letter=letter)
        return ParseError("asked", why, None, _("write the formula alone"))
    if not sides or named(sides, question):
        return None
    for side in sides:
        same = parse(side, letters)
        if (
            isinstance(same, ParseError)
            and question is not None
            and gives_what_is_asked(side, question.unit.dimension, question)
        ):
            continue  # `p_1 - p_0 = m*v` where a change is asked for
        if isinstance(same, ParseError) or not _same(same, tree):
            why = _("{side} stands on the left, not the answer alone", side=side)
            return ParseError("asked", why, None, _("write the formula alone"))
    return None


def _same(one: Expr, other: Expr) -> bool:
    """True if two formulas agree at three places, which is enough to pass over one of two sides."""
    letters = sorted((names(one) | names(other)) - {"pi"})
    for start in (1.3, 0.7, 2.1):
        values = {name: start + 0.37 * place for place, name in enumerate(letters)}
        try:
            first, second = ready(one, DOUBLES)(values), ready(other, DOUBLES)(values)
        except (ValueError, OverflowError, ZeroDivisionError):
            continue
        if not math.isclose(first, second, rel_tol=1e-9, abs_tol=1e-12):
            return False
    return True


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
    """The formula, where the reading that stops early (`(cos θ)/M`) alone measures what is asked for; else asked about, with
    the readings that do: `ln m0/m1` and, whatever fits, a number and a letter glued below a slash, `m v/2dt`."""
    if (solved := _solved(text, question)) is not None:
        return solved
    good = [
        tree if dimension_in(tree, question) == question.unit.dimension else None
        for tree in (formula(text, question, "near"), formula(text, question, "far"))
        if not isinstance(tree, ParseError)
    ]
    found = tuple(tree for tree in good if tree is not None)
    if len(found) == 1 and found[0] is good[0] and not GLUED_BELOW.search(text.translate(TO_ASCII)):
        return found[0]
    if not found:
        return None
    read = formula(text, question)
    why = sentence(read) if isinstance(read, ParseError) else _("this formula can be read in two ways")
    return Unclear(why, as_typed(text), tuple(formulas(tree) for tree in found))


def _solved(text: str, question: Question) -> Unclear | None:
    """`2*F = m*v/dt`, solved for the letter that is no given; None where the left side is something else."""
    bare, _skipped, sides = answer_in(by_hand(text).translate(TO_ASCII))
    found = solvable(sides[0], question) if len(sides) == 1 and not is_name(sides[0], question) else None
    tree = _right_side(bare, question.symbol_names, question.unit, "ask") if found else None
    of_angle = turns(found) and question.unit.is_angle
    if (
        found is None
        or tree is None
        or isinstance(tree, ParseError)
        or not (of_angle or unknown_letter(found.name, question))
    ):
        return None
    alone = as_formula(found, tree)
    if dimension_in(alone, question) != question.unit.dimension:
        return None
    read = formula_text(alone)
    why = gives(sides[0], formula_text(tree), found, read)
    ending = _("type the angle") if of_angle else _("write the formula alone")
    return Unclear(f"{why}; {ending}", as_typed(text), (formulas(alone),), benefit=True)


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
