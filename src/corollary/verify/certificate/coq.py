"""Formulas and polynomials as Coq writes them, in real numbers."""

from __future__ import annotations

import re
from collections.abc import Iterable
from fractions import Fraction
from typing import Any, assert_never

from corollary.formula.arithmetics import constant
from corollary.formula.ast import (
    ONE,
    TWO,
    ZERO,
    Call,
    Expr,
    Name,
    Negative,
    Number,
    Power,
    Product,
    Quotient,
    Relation,
    Sum,
    map_children,
)

WORDS = (
    "as at by cofix do else end exists exists2 fix for forall fun if IF in let match mod open or return Set Prop SProp Type "
    "then using where with R I E PI sqrt pow Rabs sin cos tan exp ln positive nonnegative nonzero equations solved"
)
RESERVED = frozenset(WORDS.split())  # by Coq, its library of real numbers, and our tactics
HALF = Fraction(1, 2)
STEMS = {"sqrt": "root", "sin": "sine", "cos": "cosine"}
LARGEST_POWER = 12


class NotAlgebraic(ValueError):
    """A formula that is not made by the four operations, powers and square roots; one sentence says of what."""


class Roots:
    """Square roots, sines and cosines as letters of their own: of a root only its square and its sign are said, of an angle
    only that sine and cosine lie on the unit circle. What holds for all such letters holds for the roots and angles."""

    def __init__(self, letters: Iterable[str]) -> None:
        self.names = {coq_name(name) for name in letters}
        self.made: dict[Expr, str] = {}
        self.known: list[Relation] = []

    def without(self, tree: Expr) -> Expr:
        """The formula with these letters. Raises NotAlgebraic."""
        below = map_children(tree, self.without)
        match below:
            case Call("sqrt", (inner,)):
                return self._root(inner)
            case Power(inner, exponent) if constant(exponent) == HALF:
                return self._root(inner)
            case Call("sin", (angle,)) if (half := _half(angle)) is not None:
                parts = (self.without(Call(name, (half,))) for name in ("sin", "cos"))
                return Product((TWO, *parts))
            case Call("cos", (angle,)) if (half := _half(angle)) is not None:
                sine, cosine = (self.without(Call(name, (half,))) for name in ("sin", "cos"))
                return Sum((Product((cosine, cosine)), Negative(Product((sine, sine)))))
            case Call("sin" | "cos", (angle,)):
                sine, cosine = (self._letter(Call(name, (angle,))) for name in ("sin", "cos"))
                circle = Relation("=", Sum((Power(sine, TWO), Power(cosine, TWO))), ONE)
                if circle not in self.known:
                    self.known.append(circle)
                return self._letter(below)
            case Call("abs", (inner,)):
                raise NotAlgebraic("it has the size of a number, |…|")
            case Call(function, _):
                raise NotAlgebraic(f"it has {function}")
            case _:
                return below

    def _root(self, inner: Expr) -> Name:
        tree = Call("sqrt", (inner,))
        fresh = tree not in self.made
        letter = self._letter(tree)
        if fresh:
            self.known.append(Relation("=", Product((letter, letter)), inner))
            self.known.append(Relation(">=", letter, ZERO))
        return letter

    def _letter(self, tree: Call) -> Name:
        if tree not in self.made:
            stem = STEMS[tree.function]
            name = next(each for place in range(1, 1000) if (each := f"{stem}{place}") not in self.names)
            self.names.add(name)
            self.made[tree] = name
        return Name(self.made[tree])


def _half(angle: Expr) -> Expr | None:
    """Half of an angle that is written as a double one."""
    if not isinstance(angle, Product) or TWO not in angle.factors:
        return None
    place = angle.factors.index(TWO)
    rest = (*angle.factors[:place], *angle.factors[place + 1 :])
    return rest[0] if len(rest) == 1 else Product(rest)


def coq_name(name: str) -> str:
    """A letter of ours as an identifier of Coq: another one for each letter, since none of ours has an apostrophe."""
    if name == "pi":
        return "PI"
    ascii_name = "".join(
        each if each.isascii() and (each.isalnum() or each == "_") else f"'{ord(each):x}'" for each in name
    )
    identifier = ascii_name not in RESERVED and ascii_name[:1].isalpha()
    return ascii_name if identifier else f"x'{ascii_name}"


def comment(text: str) -> str:
    """A comment of Coq: comments nest there, and a quotation mark in one begins a text that hides its end."""
    printable = "".join(each if each.isprintable() else " " for each in text).replace('"', "'")
    return f"(* {re.sub(r'(?<=[(*])(?=[*)])', ' ', printable)} *)"


def coq(tree: Expr) -> str:
    """Raises NotAlgebraic."""
    match tree:
        case Number(value):
            return number(value)
        case Name(name):
            return coq_name(name)
        case Negative(term):
            return f"(- {coq(term)})"
        case Sum(terms):
            return f"({' + '.join(map(coq, terms))})"
        case Product(factors):
            return f"({' * '.join(map(coq, factors))})"
        case Quotient(top, bottom):
            return f"({coq(top)} / {coq(bottom)})"
        case Power(base, exponent):
            power = constant(exponent)
            if power is None or power.denominator > 1 or abs(power) > LARGEST_POWER:
                raise NotAlgebraic("it has a power that is not a whole number")
            return f"(1 / {_times(base, -power)})" if power < 0 else _times(base, power)
        case Call(function, _):
            raise NotAlgebraic(f"it has {function}")
        case Relation(">" | ">=", left, right):  # turned round: nsatz takes >= for an equation, and fails
            return f"{coq(right)} {'<' if tree.sign == '>' else '<='} {coq(left)}"
        case Relation(sign, left, right):
            return f"{coq(left)} {'<>' if sign == '!=' else sign} {coq(right)}"
        case _:
            assert_never(tree)


def _times(base: Expr, count: Fraction) -> str:
    """A power as a product: nsatz does not read powers."""
    return f"({' * '.join([coq(base)] * int(count))})" if count else "1"


def number(value: Fraction) -> str:
    if value.denominator == 1:
        return str(value) if value >= 0 else f"(- {-value})"
    sign = "- " if value < 0 else ""
    return f"({sign}{abs(value.numerator)} / {value.denominator})"


def polynomial(found: Any) -> str:
    """A polynomial of python-flint."""
    names = found.context().names()
    terms: list[str] = []
    for powers, coefficient in found.to_dict().items():
        factors = [
            coq_name(name) for name, power in zip(names, map(int, powers), strict=True) for _ in range(power)
        ]
        whole = int(coefficient)
        terms.append(" * ".join([number(Fraction(whole)), *factors]))
    return f"({' + '.join(terms)})" if terms else "0"
