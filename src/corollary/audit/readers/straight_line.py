"""A program of assignments, one after the other, in anybody's notation: which letters are drawn, and the key as a formula in them."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Collection
from dataclasses import dataclass, field
from fractions import Fraction

from corollary.audit.record import StatedGiven
from corollary.formula.arithmetics import constant
from corollary.formula.ast import Expr, Name, Relation, children, names, substitute
from corollary.formula.ball import certified
from corollary.formula.errors import Undefined
from corollary.formula.plain_text import text as written
from corollary.formula.syntax import author_formula
from corollary.units.unit import PURE
from corollary.units.unit import unit as unit_named

LONGEST = 2000  # characters of an expression: a key is shorter
MOST_STATEMENTS, MOST_ANSWERS = 3000, 100  # of one program
MOST_NODES, DEEPEST = (
    2000,
    100,
)  # of a formula with all others put in: doubling each letter makes 2^n of n lines
NAMED_OTHERWISE = {
    "arcsin": "asin", "arccos": "acos", "arctan": "atan", "ln": "ln", "log": "ln", "log10": "log10", "Math.sqrt": "sqrt",
}  # fmt: skip
IN_DEGREES = {"deg2rad", "radians"}
TO_DEGREES = {"rad2deg", "degrees"}
CALL = re.compile(r"\b([A-Za-z_]\w*)\s*\(")
DRAWS = re.compile(r"(?:sample|runif)\s*\(")
LETTER = re.compile(r"[A-Za-z][A-Za-z0-9_]*$")
DECIMAL = re.compile(r"-?(?:0|[1-9]\d{0,15})(?:\.\d{1,20})?")  # which needs no formula to be read
LONGEST_SENTENCE = 300  # characters
BRACKET = re.compile(r"[][(){},]")
OCTAL = re.compile(r"(?<![\w.])0\d")  # 010 is 8 in Perl, and 10 in R
SAME_PI = 1e-6  # relative: 3.141593 is meant for it, 3.14 is what the key was worked out with


class NotRead(ValueError):
    """What a reader cannot make out; one sentence says what. `letter` is the one that could not be, where it is not the one asked for."""

    def __init__(self, sentence: str, letter: str = "") -> None:
        super().__init__(shortened(f"{letter}: {sentence}" if letter else sentence))
        self.letter, self.cause = letter, sentence


@dataclass(frozen=True, slots=True)
class PublishedFormula:
    """A key in the letters drawn, these, and the letters that the program works out from them."""

    text: str
    drawn: tuple[StatedGiven, ...]
    worked_out: frozenset[str]


@dataclass(slots=True)
class StraightLine:
    """`drawn` are the letters that differ from student to student; `formulas` what every other letter is, in these; `unread` says
    why a letter could not be made out, which counts only where the key needs it."""

    drawn: dict[str, StatedGiven] = field(default_factory=dict[str, StatedGiven])
    formulas: dict[str, Expr] = field(default_factory=dict[str, Expr])
    unread: dict[str, NotRead] = field(default_factory=dict[str, NotRead])
    sizes: dict[str, tuple[int, int]] = field(default_factory=dict[str, tuple[int, int]])

    def attempt(self, letter: str, assignment: Callable[[], None]) -> None:
        """An assignment to a letter, which may fail. Raises NotRead where the letter was drawn: the statement shows one of both."""
        if letter in self.drawn:
            raise NotRead(f"{letter} is given a value twice")
        try:
            assignment()
            self.unread.pop(letter, None)
        except NotRead as error:
            self.formulas.pop(letter, None)
            self.unread[letter] = error if error.letter else NotRead(str(error), letter)

    def draw(self, letter: str, low: str, high: str) -> None:
        """A letter drawn between two numbers. Raises NotRead."""
        self._refuse_again(letter)
        least, most = (_number(each) for each in (low, high))
        if least is None or most is None or not least < most:
            raise NotRead(f"{letter} is drawn between {low} and {high}, which is not a range of numbers")
        self.drawn[letter] = StatedGiven(letter, PURE, least, most)

    def draw_among(self, letter: str, values: list[str]) -> None:
        """A letter that is one of some numbers. Raises NotRead."""
        self._refuse_again(letter)
        if len(values) > MOST_STATEMENTS:
            raise NotRead(f"{letter} is drawn from more than {MOST_STATEMENTS} numbers")
        found = [_number(each) for each in values]
        numbers = [each for each in found if each is not None]
        if len(numbers) < len(found) or len(set(numbers)) < 2:
            raise NotRead(f"{letter} is drawn from a list that is not of different numbers")
        self.drawn[letter] = StatedGiven(letter, PURE, min(numbers), max(numbers))

    def assign(self, letter: str, expression: str) -> None:
        """A letter that is an expression of those before it, itself among them. Raises NotRead."""
        tree, size = self._inlined(expression)
        if letter == "pi":
            _refuse_other_pi(tree)
            return
        if not LETTER.match(letter):
            raise NotRead(f"{letter} is not a letter of a formula")
        if letter in self.drawn:
            self._refuse_again(letter)
        self.formulas[letter], self.sizes[letter] = tree, size

    def _inlined(self, expression: str) -> tuple[Expr, tuple[int, int]]:
        """The expression in letters drawn alone, and its size. Raises NotRead."""
        tree = formula_from(expression)
        for name in sorted(self.unread.keys() & (names(tree) | set(CALL.findall(expression)))):
            raise NotRead(self.unread[name].cause, self.unread[name].letter)
        if strange := names(tree) - self.drawn.keys() - self.formulas.keys() - {"pi"}:
            raise NotRead(f"{sorted(strange)[0]} is not known where it is used")
        nodes, depth = self._size(tree)
        if nodes > MOST_NODES or depth > DEEPEST:
            raise NotRead("the key is too long a formula")
        return substitute(tree, self.formulas), (nodes, depth)

    def _size(self, tree: Expr) -> tuple[int, int]:
        """The nodes of a formula with all letters put in, and how deep they are nested."""
        if isinstance(tree, Name):
            return self.sizes.get(tree.name, (1, 1))
        below = [self._size(each) for each in children(tree)]
        return 1 + sum(nodes for nodes, _ in below), 1 + max((depth for _, depth in below), default=0)

    def key(self, expression: str) -> PublishedFormula:
        """The key as a text in letters drawn. Raises NotRead."""
        tree, _ = self._inlined(expression)
        if len(text := written(tree)) > LONGEST:
            raise NotRead("the key is too long a formula")
        return PublishedFormula(text, tuple(self.drawn.values()), frozenset(self.formulas))

    def _refuse_again(self, letter: str) -> None:
        """Raises NotRead for a letter that has a value already: what follows would mean another one."""
        if not LETTER.match(letter) or letter == "pi":
            raise NotRead(f"{letter} is not a letter of a formula")
        if letter in self.drawn or letter in self.formulas:
            raise NotRead(f"{letter} is given a value twice")


def shortened(sentence: str) -> str:
    """A sentence of a length that people read, whatever it quotes."""
    return sentence if len(sentence) <= LONGEST_SENTENCE else f"{sentence[: LONGEST_SENTENCE - 1]}…"


def refuse_long(expression: str) -> None:
    """Raises NotRead for what no key is as long as."""
    if len(expression) > LONGEST:
        raise NotRead("an expression is too long to be a key")


def in_figures(number: Fraction) -> str:
    """A number worked out, as it is published. Raises NotRead where it has no double."""
    try:
        return f"{float(number):.15g}"
    except OverflowError:
        raise NotRead("the answer is too large a number") from None


def known_unit(words: str) -> bool:
    """Whether what stands behind an answer is a unit, and no other words."""
    try:
        unit_named(words)
    except ValueError:
        return False
    return bool(words)


def _number(text: str) -> Fraction | None:
    return Fraction(text) if DECIMAL.fullmatch(text) else constant(formula_from(text))


def _refuse_other_pi(tree: Expr) -> None:
    """Raises NotRead where a program's own pi is not so exact that it is meant for it."""
    try:
        value = certified(tree, {}).value
    except (Undefined, KeyError):
        raise NotRead("the program has a pi of its own") from None
    if not math.isclose(value, math.pi, rel_tol=SAME_PI):
        raise NotRead(f"the program has a pi of its own, {value:.6g}")


def formula_from(expression: str) -> Expr:
    """An expression of Perl, Python, R or Moodle as a formula. Raises NotRead for whatever is none."""
    refuse_long(expression)
    if "[" in expression:
        raise NotRead(f"{expression!r} has square brackets, which make a list")
    if OCTAL.search(expression):
        raise NotRead(f"{expression!r} has a number that begins with 0, which not every language reads alike")
    text = expression.strip().replace("**", "^")
    text = re.sub(r"\bpi\s*\(\s*\)", "pi", text)
    text = re.sub(r"(?<=\d)[lL]\b", "", text)  # R's whole numbers: 5L
    try:
        tree = author_formula(_calls(text, 0))
    except ValueError as error:
        raise NotRead(str(error)) from None
    if isinstance(tree, Relation):
        raise NotRead(f"{expression!r} compares, and is not a key")
    return tree


def _calls(text: str, depth: int) -> str:
    """The calls that are written otherwise here: powers, logarithms, conversions of degrees."""
    if depth > 20:
        raise NotRead("an expression is nested too deeply")
    found = CALL.search(text)
    if found is None:
        return text
    inside, end = arguments_at(text, found.end())
    parts = [_calls(each, depth + 1) for each in inside]
    name = found[1]
    if name == "pow" and len(parts) == 2:
        called = f"(({parts[0]})^({parts[1]}))"
    elif name in IN_DEGREES and len(parts) == 1:
        called = f"(({parts[0]})*pi/180)"
    elif name in TO_DEGREES and len(parts) == 1:
        called = f"(({parts[0]})*180/pi)"
    elif name == "float" and len(parts) == 1:
        called = f"({parts[0]})"
    else:
        called = f"{NAMED_OTHERWISE.get(name, name)}({', '.join(parts)})"
    return text[: found.start()] + called + _calls(text[end:], depth + 1)


def arguments_at(text: str, start: int) -> tuple[list[str], int]:
    """The arguments of a call whose bracket has just been opened, and where the text goes on. Raises NotRead."""
    depth, begin = 1, start
    found: list[str] = []
    for bracket in BRACKET.finditer(text, start):
        letter, at = bracket[0], bracket.start()
        depth += (letter in "([{") - (letter in ")]}")
        if depth == 0 or (depth == 1 and letter == ","):
            found.append(text[begin:at].strip())
            begin = at + 1
        if depth == 0:
            return [each for each in found if each], at + 1
    raise NotRead("a bracket is not closed")


def unrounded(expression: str, rounds: Collection[str]) -> str:
    """What is rounded for the page, before it is: the formula is compared, not its figures. Raises NotRead where more is rounded off."""
    found = CALL.match(expression)
    if found is None or found[1] not in rounds:
        return expression
    inside, end = arguments_at(expression, found.end())
    if not inside or expression[end:].strip():
        return expression
    if found[1] == "round" and len(inside) == 1 and DRAWS.match(inside[0]) is None:
        raise NotRead("a number that is worked out is rounded to a whole one")
    if any(each.rpartition("=")[2].strip().startswith("-") for each in inside[1:]):
        raise NotRead(f"{expression!r} rounds before the decimal point")
    return inside[0]
