"""Left sides of an answer: names, multiples and functions of one letter, and formulas of the answer."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cache

from corollary.answers.name import CUSTOMARY, SYMBOL, apart, is_name, is_talk, keyboard
from corollary.answers.question import Question
from corollary.formula.abbreviations import calculator_words
from corollary.formula.ast import TWO, Call, Expr, Number, Power, Product, Quotient, walk
from corollary.formula.ast import names as letters_of
from corollary.formula.errors import ParseError
from corollary.formula.symbols import GREEK
from corollary.formula.syntax import parse
from corollary.messages import catalogue
from corollary.units.dimensional_analysis import dimension_of
from corollary.units.unit import ONE, Dimension, Unit, unit

_ = catalogue(__name__)

NUMBER = r"[0-9]+(?:[.,][0-9]+)?(?:\s*/\s*[0-9]+)?"
MULTIPLE = re.compile(
    rf"\s*(?P<sign>[-+]?)\s*(?:(?P<factor>{NUMBER})\s*\*?\s*)?(?P<name>{SYMBOL}?)(?:\s*/\s*(?P<divisor>[0-9]+(?:[.,][0-9]+)?)|\s*\*\s*(?P<behind>{NUMBER}))?\s*"
)
INVERSE = re.compile(rf"\s*1\s*/\s*(?P<name>{SYMBOL})\s*")
CALL = re.compile(
    rf"\s*(?P<function>[A-Za-z]{{2,6}}(?:10)?|√)\s*(?:\(\s*(?P<inside>{SYMBOL})\s*\)|\s(?P<bare>{SYMBOL})|(?<=√)(?P<root>{SYMBOL}))\s*"
)
CHANGE = re.compile(
    r"\b(?:change|changes|difference|increase|decrease|gain|loss|impulse|änderung|\w*änderung|differenz|zunahme|abnahme|kraftstoß|endring|forskjell)\b",
    re.IGNORECASE,
)
GIVEN_AWAY = re.compile(
    r"\b(?:give|gives|given|pass\w*|hand\w*|transfer\w*|gibt|abgibt|gir|overfør\w*)\b", re.IGNORECASE
)
RATIO = re.compile(rf"\s*(?P<one>{SYMBOL})\s*/\s*(?P<other>{SYMBOL})\s*")
# An index, and that of the same letter later: only so a difference is a change, and a quotient what is left.
LATER = frozenset(
    {("0", "1"), ("1", "2"), ("0", "2"), ("", "1"), ("", "2"), ("i", "f"), ("initial", "final"), ("before", "after"), ("", "'"),
     ("vor", "nach"), ("vorher", "nachher"), ("før", "etter"), ("", "after"), ("", "final"), ("", "f"), ("0", "f"), ("0", "")}
)  # fmt: skip
EARLIER = frozenset({"", "0", "1", "i", "before", "initial"})
DIFFERENCE = re.compile(rf"\s*(?P<one>{SYMBOL})\s*-\s*(?P<other>{SYMBOL})\s*")


@dataclass(frozen=True, slots=True)
class Solved:
    """A left side in one unknown letter: `name` is `factor` times the right side, after the inverse of `function`."""

    name: str
    factor: Fraction = Fraction(1)
    function: str = ""


def gives(side: str, value: str, found: Solved, choice: str) -> str:
    """What is said of a left side that was solved: `2*F = 172 N gives F = 86 N`."""
    return _(
        "{side} = {value} gives {name} = {choice}",
        side=side.strip(),
        value=value,
        name=found.name,
        choice=choice,
    )


def solvable(side: str, question: Question | None = None) -> Solved | None:
    """The one letter of a left side that is a multiple, a reciprocal or an invertible function of it."""
    side = apart(side)
    if (found := INVERSE.fullmatch(side)) is not None and is_name(found["name"], question):
        return Solved(found["name"], function="1/")
    if (found := MULTIPLE.fullmatch(side)) is not None and found["name"]:
        if found["factor"] and found["behind"]:
            return None
        size = _ratio(found["factor"] or found["behind"] or "1") / _ratio(found["divisor"] or "1")
        size = -size if found["sign"] == "-" else size
        return Solved(found["name"], 1 / size) if size and is_name(found["name"], question) else None
    if (found := CALL.fullmatch(side)) is not None:
        function = "sqrt" if found["function"] == "√" else calculator_words().get(found["function"], "")
        name = found["inside"] or found["bare"] or found["root"]
        return Solved(name, function=function) if function in INVERSES and is_name(name, question) else None
    return None


def _power_of_ten(value: float) -> float:
    return math.pow(10.0, value)


def _square(value: float) -> float:
    return value**2 if value >= 0 else math.nan


def _reciprocal(value: float) -> float:
    return 1 / value


INVERSES: dict[str, Callable[[float], float]] = {
    "sin": math.asin, "cos": math.acos, "tan": math.atan, "ln": math.exp, "log10": _power_of_ten, "exp": math.log,
    "sqrt": _square, "1/": _reciprocal,
}  # fmt: skip


def solved_value(found: Solved, value: float) -> float | None:
    """The letter's value for this value of the left side; None where it has none. Angles come in radians."""
    try:
        result = INVERSES[found.function](value) if found.function else value
    except (ValueError, OverflowError, ZeroDivisionError):
        return None
    result = float(result) * float(found.factor)
    return result if math.isfinite(result) else None


def gives_what_is_asked(side: str, expected: Dimension, question: Question | None) -> Expr | bool:
    """The formula of the givens alone that stands for the answer; True for a product in customary letters of its dimension."""
    if question is not None and CHANGE.search(question.title) and (between := DIFFERENCE.fullmatch(side)):
        return _is_later(between["one"], between["other"])
    if (over := RATIO.fullmatch(side)) is not None and expected == ONE:
        return _is_over(over["one"], over["other"], question)
    givens = question.dimensions if question is not None else {}
    if (tree := _in_givens(side, givens)) is not None:
        return tree if dimension_of(tree, givens) == expected else False
    names = _letters_in(side, givens)
    tree = parse(side, names)
    if isinstance(tree, ParseError) or not isinstance(tree, Product | Quotient):
        return False
    used = sorted(letters_of(tree) - {"pi"})
    if len(used) < 2:
        return False
    if isinstance(tree, Quotient) and expected == ONE:
        return False  # nobody says which is asked over which
    customary = {name: _dimensions()[base] for name in used if (base := _base(name)) in CUSTOMARY}
    return len(customary) == len(used) and dimension_of(tree, {**customary, **givens}) == expected


def _in_givens(side: str, givens: Mapping[str, Dimension]) -> Expr | None:
    """The side as a formula of the givens alone; None where it is none."""
    tree = parse(side, givens) if givens else None
    return None if tree is None or isinstance(tree, ParseError) or not letters_of(tree) - {"pi"} else tree


def turned_over(side: str, expected: Dimension, question: Question | None) -> Solved | None:
    """The very quotient or difference that the question asks for, out of a side that has it upside down: `K0/K1`, `p0 - p1`."""
    if question is None:
        return None
    if (over := RATIO.fullmatch(side)) is not None and expected == ONE:
        one, other = over["one"], over["other"]
        certain = _is_over(other, one, question) and not _is_over(one, other, question)
        return Solved(f"{other}/{one}", function="1/") if certain else None
    if (between := DIFFERENCE.fullmatch(side)) is not None and CHANGE.search(question.title):
        one, other = between["one"], between["other"]
        certain = _is_later(other, one) and not _is_later(one, other)
        return Solved(f"{other} - {one}", Fraction(-1)) if certain else None
    return None


def _is_later(one: str, other: str) -> bool:
    """True if both are the same letter, the first later than the second: `p_1` and `p_0`, `K'` and `K`."""
    first, second = _bare(one), _bare(other)
    return first[:1] == second[:1] and (second[1:], first[1:]) in LATER


def _bare(name: str) -> str:
    """A letter and its index as they are typed, without what joins them: `K1` of `K_{1}`."""
    return re.sub(r"[\s_{}()]", "", keyboard(name))


def _is_over(one: str, other: str, question: Question | None) -> bool:
    """True if a quotient of one kind of thing stands as the question asks for it: `ΔK/K`, `K1/K0`, `J_e/J_s`, `K_B/K_A`."""
    first, second = _bare(one), _bare(other)
    if changed := re.match(r"Delta|delta|d(?=[A-Za-z])", first):
        return first[changed.end() :][:1] == second[:1] and second[1:] in EARLIER
    if question is None or not question.ratio:
        return False
    if first[:1] != second[:1] or first[:1] in question.symbol_names:
        return False
    if (second[1:], first[1:]) in LATER - {("1", "2")}:
        return CHANGE.search(question.title) is None
    top, bottom = (_place(index[1:], question.ratio) for index in (first, second))
    if top is None or bottom is None or top == bottom:
        return False
    return top > bottom if GIVEN_AWAY.search(question.ratio) else top < bottom


def _place(index: str, words: str) -> int | None:
    """Where the body or kind with this index is spoken of first: `e` of *elastic*, `A`."""
    found = (
        re.search(rf"\b{re.escape(index)}{'' if index.isupper() else '[a-z]*'}\b", words)
        if index.isalpha()
        else None
    )
    return found.start() if found else None


def _letters_in(side: str, givens: Mapping[str, Dimension]) -> Collection[str]:
    """The names a left side may be made of: the givens, and each run of letters with its index, or its letters one by one."""
    found = set(givens)
    for run in re.findall(r"(?:(?:delta|Delta|[Δ∆])\s*)?[^\W\d_](?:_\{\w+\}|\w)*", side):
        name = re.sub(r"[^A-Za-z0-9_]", "", keyboard(run))
        if name in calculator_words() or name == "pi":
            continue
        found |= (
            {name}
            if "_" in name or re.search(r"\d$|^Delta|^d[a-z]$", name) or name in GREEK.values()
            else set(name)
        )
    return found


def _base(name: str) -> str:
    name = re.sub(r"^(?:Delta|delta|d(?=[A-Za-z]))", "", name)
    return next(
        (word for word in sorted(set(GREEK.values()), key=len, reverse=True) if name.startswith(word)),
        name[:1],
    )


@cache
def _dimensions() -> dict[str, Dimension]:
    return {name: unit(text).dimension for name, text in CUSTOMARY.items()}


def _ratio(text: str) -> Fraction:
    above, _, below = text.replace(",", ".").replace(" ", "").partition("/")
    return Fraction(above) / Fraction(below or "1") if Fraction(below or "1") else Fraction(0)


def unknown_letter(name: str, question: Question | None) -> bool:
    """True if a letter is none of the givens, so that it can stand for the answer."""
    typed = re.sub(r"[^A-Za-z0-9]", "", keyboard(name))
    return question is not None and typed not in {each.replace("_", "") for each in question.symbol_names}


def is_another_given(side: str, wanted: Unit, question: Question | None) -> bool:
    """True for the letter of a given that measures something else than is asked for: `m = 86 N`."""
    found = {symbol.name.replace("_", ""): symbol.unit for symbol in question.symbols} if question else {}
    its_unit = found.get(side.strip().replace("_", ""))
    return its_unit is not None and its_unit.dimension != wanted.dimension


def as_formula(found: Solved, tree: Expr) -> Expr:
    """The formula of the letter: its left side undone on the right one."""
    match found.function:
        case "sin" | "cos" | "tan" | "ln" | "exp":
            undone: Expr = Call({"ln": "exp", "exp": "ln"}.get(found.function, f"a{found.function}"), (tree,))
        case "log10":
            undone = Power(Number(Fraction(10)), tree)
        case "sqrt":
            undone = Power(tree, TWO)
        case "1/":
            undone = Quotient(Number(Fraction(1)), tree)
        case _:
            undone = tree
    top, bottom = Number(Fraction(found.factor.numerator)), Number(Fraction(found.factor.denominator))
    scaled = undone if top.value == 1 else Product((top, undone))
    return scaled if bottom.value == 1 else Quotient(scaled, bottom)


def turns(found: Solved | None) -> bool:
    """True for the sine, cosine or tangent of one letter."""
    return found is not None and found.function in ("sin", "cos", "tan")


def is_calculation(side: str) -> bool:
    """True for a side of numbers, operators and functions alone: `8.6/0`, `sqrt(-1)`."""
    return re.search(r"\d", side) is not None and all(
        word in calculator_words() for word in re.findall(r"[^\W\d_]+", side)
    )


def measures_otherwise(side: str, expected: Dimension, question: Question | None) -> bool:
    """True for a formula of the givens alone that measures something else than is asked for, as `m*v` for a force."""
    givens = question.dimensions if question is not None else {}
    tree = _in_givens(side, givens)
    if tree is None or any(isinstance(node, Number) and node.value.numerator > 4 for node in walk(tree)):
        return False  # in `v^2/20` of metres a number may stand for a quantity
    found = dimension_of(tree, givens)
    return not isinstance(found, ParseError) and found != expected


def has_letters(side: str, expected: Unit | None, question: Question | None) -> bool:
    """True for a side whose letters are no units: one letter to solve for, or a formula of what is asked for, `sqrt(2 g L)`."""
    if solvable(side, question):
        return True
    return expected is not None and gives_what_is_asked(side, expected.dimension, question) is not False


def named(sides: Sequence[str], question: Question | None = None) -> bool:
    """True if one of the sides is a name or talk: then the last side is its value."""
    return any(is_name(side, question) or is_talk(side, question) for side in sides)
