"""A program of assignments, one after the other, in anybody's notation: which letters are drawn, and the key as a formula in them."""

from __future__ import annotations

import re
from dataclasses import dataclass, field

from corollary.audit.record import StatedGiven
from corollary.formula.ast import Expr, Relation, names, substitute
from corollary.formula.exact import constant
from corollary.formula.syntax import author_formula
from corollary.formula.text import text as written
from corollary.units.unit import PURE

LONGEST = 2000  # characters of an expression: a key is shorter
NAMED_OTHERWISE = {
    "arcsin": "asin", "arccos": "acos", "arctan": "atan", "ln": "ln", "log": "ln", "log10": "log10", "Math.sqrt": "sqrt",
}  # fmt: skip
IN_DEGREES = {"deg2rad", "radians"}
TO_DEGREES = {"rad2deg", "degrees"}
MODULES = re.compile(r"\b(?:math|np|numpy)\.")
CALL = re.compile(r"\b([A-Za-z_]\w*)\s*\(")
LETTER = re.compile(r"[A-Za-z][A-Za-z0-9_]*$")


class NotRead(ValueError):
    """What a reader cannot make out; one sentence says what."""


@dataclass(slots=True)
class StraightLine:
    """`drawn` are the letters that differ from student to student; `formulas` what every other letter is, in these."""

    drawn: dict[str, StatedGiven] = field(default_factory=dict[str, StatedGiven])
    formulas: dict[str, Expr] = field(default_factory=dict[str, Expr])

    def draw(self, letter: str, low: str, high: str) -> None:
        """A letter drawn between two numbers. Raises NotRead."""
        self._new(letter)
        least, most = (constant(formula_from(each)) for each in (low, high))
        if least is None or most is None or not least < most:
            raise NotRead(f"{letter} is drawn between {low} and {high}, which is no range of numbers")
        self.drawn[letter] = StatedGiven(letter, PURE, least, most)

    def draw_among(self, letter: str, values: list[str]) -> None:
        """A letter that is one of some numbers. Raises NotRead."""
        found = [constant(formula_from(each)) for each in values]
        numbers = [each for each in found if each is not None]
        if len(numbers) < len(found) or len(set(numbers)) < 2:
            raise NotRead(f"{letter} is drawn from a list that is not of different numbers")
        self._new(letter)
        self.drawn[letter] = StatedGiven(letter, PURE, min(numbers), max(numbers))

    def assign(self, letter: str, expression: str) -> None:
        """A letter that is an expression of those before it. Raises NotRead."""
        self._new(letter)
        self.formulas[letter] = self.inlined(expression)

    def inlined(self, expression: str) -> Expr:
        """The expression in letters drawn alone. Raises NotRead."""
        tree = formula_from(expression)
        if strange := names(tree) - self.drawn.keys() - self.formulas.keys() - {"pi"}:
            raise NotRead(f"{sorted(strange)[0]} is not known where it is used")
        return substitute(tree, self.formulas)

    def key(self, expression: str) -> tuple[str, tuple[StatedGiven, ...]]:
        """The key as a text in letters drawn, and these. Raises NotRead."""
        tree = self.inlined(expression)
        if len(text := written(tree)) > LONGEST:
            raise NotRead("the key is too long a formula")
        return text, tuple(self.drawn.values())

    def refuse_again(self, letter: str) -> None:
        """Raises NotRead for a letter that has a value already: what follows would mean another one."""
        if letter in self.drawn or letter in self.formulas:
            raise NotRead(f"{letter} is given a value twice")

    def _new(self, letter: str) -> None:
        if not LETTER.match(letter) or letter == "pi":
            raise NotRead(f"{letter} is no letter of a formula")
        self.refuse_again(letter)


def formula_from(expression: str) -> Expr:
    """An expression of Perl, Python, R or Moodle as a formula. Raises NotRead for whatever is none."""
    if len(expression) > LONGEST:
        raise NotRead("an expression is too long to be a key")
    text = MODULES.sub("", expression.strip()).replace("**", "^")
    text = re.sub(r"\bpi\s*\(\s*\)", "pi", text)
    text = re.sub(r"(?<=\d)[lL]\b", "", text)  # R's whole numbers: 5L
    try:
        tree = author_formula(_calls(text, 0))
    except ValueError as error:
        raise NotRead(str(error)) from None
    if isinstance(tree, Relation):
        raise NotRead(f"{expression!r} compares, and is no key")
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
    depth, at, begin = 1, start, start
    found: list[str] = []
    for at in range(start, len(text)):
        letter = text[at]
        depth += (letter in "([{") - (letter in ")]}")
        if depth == 0 or (depth == 1 and letter == ","):
            found.append(text[begin:at].strip())
            begin = at + 1
        if depth == 0:
            return [each for each in found if each], at + 1
    raise NotRead("a bracket is not closed")
