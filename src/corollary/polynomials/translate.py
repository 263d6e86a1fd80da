"""From our trees to quotients of polynomials: roots and functions become letters; sines and cosines are written in those of single angles."""

# pyright: reportMissingTypeStubs=false, reportUnknownArgumentType=false, reportUnknownMemberType=false, reportUnknownVariableType=false

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from fractions import Fraction
from typing import Any, Protocol

from flint.utils.flint_exceptions import DomainError

from corollary.formula.arithmetics import constant
from corollary.formula.ast import (
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
    calls,
    names,
    walk,
)
from corollary.polynomials.polynomial import Polynomial, RationalFunction, TooLarge, context, factored
from corollary.polynomials.polynomial_signs import Bounds, Signs

MOST_MULTIPLES = 8
POSITIVE: Bounds = (Fraction(0), None)


class LetterMaker(Protocol):
    """What makes a letter, and holds what is true of it."""

    known: Signs
    relations: list[Any]

    def number(self, value: Fraction) -> RationalFunction: ...
    def made(self, meaning: tuple[object, ...], bounds: Bounds = ...) -> tuple[RationalFunction, bool]: ...


class Angles:
    """An angle is taken apart into terms; the sine and the cosine of each (of its half, when `parts` is 2) get a letter."""

    def __init__(self, letters: LetterMaker, parts: int) -> None:
        self._letters, self._parts = letters, parts

    def of(self, function: str, angle: RationalFunction) -> RationalFunction:
        """sin or cos of an angle. Raises TooLarge for a multiple that is too high."""
        cosine, sine = self._letters.number(Fraction(1)), self._letters.number(Fraction(0))
        for coefficient, term in _terms(angle):
            more_cosine, more_sine = self._term(coefficient, term)
            cosine, sine = (
                cosine * more_cosine - sine * more_sine,
                sine * more_cosine + cosine * more_sine,
            )
        return sine if function == "sin" else cosine

    def _term(
        self, coefficient: Fraction, term: RationalFunction
    ) -> tuple[RationalFunction, RationalFunction]:
        name = str(term.top) if term.bottom.is_one() else ""
        if name == "pi" and (2 * coefficient).denominator == 1:
            quarter = int(2 * coefficient) % 4
            return tuple(self._letters.number(Fraction((1, 0, -1, 0)[(quarter - up) % 4])) for up in (0, 1))  # type: ignore[return-value]
        multiple = coefficient * self._parts
        if multiple.denominator > 1:
            return self._letter("cos", coefficient, term, ""), self._letter("sin", coefficient, term, "")
        if abs(multiple) > MOST_MULTIPLES:
            raise TooLarge
        base = Fraction(1, self._parts)
        one = self._letter("cos", base, term, name), self._letter("sin", base, term, name)
        cosine, sine = self._letters.number(Fraction(1)), self._letters.number(Fraction(0))
        for _again in range(abs(int(multiple))):
            cosine, sine = cosine * one[0] - sine * one[1], sine * one[0] + cosine * one[1]
        return cosine, (-sine if multiple < 0 else sine)

    def _letter(
        self, function: str, coefficient: Fraction, term: RationalFunction, name: str
    ) -> RationalFunction:
        low, high = self._letters.known.get(name, (None, None))
        acute = low is not None and high is not None and low > 0 and float(coefficient * high) < math.pi / 2
        bounds = POSITIVE if acute else (None, None)
        key = str(coefficient), str(term)
        cosine, new = self._letters.made(("cos", *key), bounds)
        sine, _ = self._letters.made(("sin", *key), bounds)
        if new:
            one = self._letters.number(Fraction(1))
            self._letters.relations.append((cosine * cosine + sine * sine - one).top)
        return sine if function == "sin" else cosine


def _terms(angle: RationalFunction) -> list[tuple[Fraction, RationalFunction]]:
    """The angle as a sum of multiples; as one where something stands below the line."""
    top, bottom = angle.top, angle.bottom
    if not bottom.is_constant():
        content, primitive = top.primitive() if not top.is_zero() else (0, top)
        return [(Fraction(int(content)), RationalFunction(primitive, bottom))]
    below, context = int(bottom.coeffs()[0]), top.context()
    return [
        (
            Fraction(int(coefficient), below),
            RationalFunction(context.term(coeff=1, exp_vec=exponents), context.constant(1)),
        )
        for exponents, coefficient in top.to_dict().items()
    ]


MOST_MADE = 24  # letters for roots, sines and the like


class Translation:
    """One context of letters for some equations, and what is true of the letters made for roots, sines and the like.

    `known` are bounds that hold whatever the equations say; `seen` further ones, that hold where all laws do.
    `definitions` are the meanings of letters that stand for formulas. `relations` are equations of the letters made,
    `divisors` all that a quotient was divided by so far.
    """

    def __init__(
        self, trees: Iterable[Expr], known: Mapping[str, Bounds], seen: Mapping[str, Bounds] | None = None
    ) -> None:
        trees = list(trees)
        letters = sorted(names(*trees) | {"pi"})
        nodes = [node for tree in trees for node in walk(tree)]
        count = min(MOST_MADE, 2 * sum(map(makes_a_letter, nodes)))
        self.context = context((*letters, *(f"#{place}" for place in range(count)), "#spare"))
        self.known = Signs({"pi": POSITIVE} | {name: known[name] for name in letters if name in known})
        self.seen = Signs(self.known | dict(seen or {}))
        self.spare = len(letters) + count
        self.relations: list[Polynomial] = []
        self.divisors: list[Polynomial] = []
        self.definitions: dict[str, RationalFunction] = {}
        self._made: dict[tuple[Any, ...], RationalFunction] = {}
        self._free = list(range(len(letters), self.spare))
        halves = any(
            isinstance(inner, Quotient) or (isinstance(inner, Number) and inner.value.denominator > 1)
            for tree in trees
            for call in calls(tree)
            if call.function in ("sin", "cos", "tan")
            for inner in walk(call)
        )
        self._angles = Angles(self, 2 if halves else 1)

    @property
    def meanings(self) -> Mapping[tuple[Any, ...], RationalFunction]:
        """The letters made, by what they stand for: ("root", degree, of), ("sin", multiple, angle), (function, arguments…)."""
        return self._made

    def equation(self, relation: Relation) -> Polynomial:
        """The numerator of left minus right. Raises TooLarge, and Undefined where something is divided by 0."""
        return (self.fraction(relation.left) - self.fraction(relation.right)).top

    def fraction(self, tree: Expr) -> RationalFunction:
        """Raises TooLarge, and Undefined where something is divided by 0."""
        match tree:
            case Number(value):
                return self.number(value)
            case Name(name):
                return self.definitions[name] if name in self.definitions else self.letter(name)
            case Negative(term):
                return -self.fraction(term)
            case Sum(terms):
                return self._added(terms)
            case Product(factors):
                made = self.number(Fraction(1))
                for factor in factors:
                    made = made * self.fraction(factor)
                return made
            case Quotient(top, bottom):
                below = self.fraction(bottom)
                if not below.top.is_constant():
                    self.divisors.append(below.top)
                return self.fraction(top) * below.inverse()
            case Power(base, exponent):
                return self._power(self.fraction(base), exponent)
            case Call(function, arguments):
                return self._call(function, tuple(map(self.fraction, arguments)))
            case Relation():
                raise TooLarge

    def number(self, value: Fraction) -> RationalFunction:
        return RationalFunction(
            self.context.constant(value.numerator), self.context.constant(value.denominator)
        )

    def letter(self, name: str) -> RationalFunction:
        return RationalFunction(
            self.context.gen(self.context.variable_to_index(name)), self.context.constant(1)
        )

    def made(
        self, meaning: tuple[Any, ...], bounds: Bounds = (None, None), seen: Bounds | None = None
    ) -> tuple[RationalFunction, bool]:
        """The letter that stands for this, and whether it is new. Raises TooLarge where there are too many."""
        new = meaning not in self._made
        if new:
            if not self._free:
                raise TooLarge
            place = self._free.pop(0)
            name = self.context.names()[place]
            self.known[name], self.seen[name] = bounds, seen or bounds
            self._made[meaning] = self.letter(name)
        return self._made[meaning], new

    def _added(self, terms: tuple[Expr, ...]) -> RationalFunction:
        made = self.fraction(terms[0])
        for term in terms[1:]:
            made = made + self.fraction(term)
        return made

    def _power(self, base: RationalFunction, exponent: Expr) -> RationalFunction:
        value = constant(exponent)
        if value is None:
            return self._opaque("power", base, self.fraction(exponent))
        if value.denominator > 1:
            base = self.root(base, value.denominator)
        if value < 0 and not base.top.is_constant():
            self.divisors.append(base.top)
        return base**value.numerator

    def _call(self, function: str, arguments: tuple[RationalFunction, ...]) -> RationalFunction:
        match function:
            case "sqrt":
                return self.root(arguments[0], 2)
            case "abs":
                return self.root(arguments[0] * arguments[0], 2)
            case "sin" | "cos":
                return self._angles.of(function, arguments[0])
            case "tan":
                below = self._angles.of("cos", arguments[0])
                self.divisors.append(below.top)
                return self._angles.of("sin", arguments[0]) * below.inverse()
            case _:
                return self._opaque(function, *arguments)

    def root(self, of: RationalFunction, degree: int) -> RationalFunction:
        """The root that is not negative; a polynomial where there is one of known sign, else a letter."""
        if degree == 2 and (exact := self._exact_root(of)) is not None:
            return exact
        known, seen = (
            POSITIVE
            if sign_by_factors(of.top, signs) * sign_by_factors(of.bottom, signs) > 0
            else (None, None)
            for signs in (self.known, self.seen)
        )
        root, new = self.made(("root", degree, str(of)), known, seen)
        if new:
            self.relations.append(((root**degree) - of).top)
        return root

    def _exact_root(self, of: RationalFunction) -> RationalFunction | None:
        try:
            top, bottom = of.top.sqrt(), of.bottom.sqrt()
        except DomainError:
            return None
        its_sign = sign_by_factors(top, self.seen) * sign_by_factors(bottom, self.seen)
        if top.is_zero():
            return RationalFunction(top, bottom)
        return RationalFunction(its_sign * top, bottom) if its_sign else None

    def _opaque(self, function: str, *arguments: RationalFunction) -> RationalFunction:
        """Some number: nothing is known of it but that equal arguments give an equal one, and that powers of e are positive."""
        return self.made((function, *map(str, arguments)), POSITIVE if function == "exp" else (None, None))[0]


def makes_a_letter(node: Expr) -> bool:
    """Whether this is no quotient of polynomials."""
    match node:
        case Call():
            return True
        case Power(_, exponent):
            value = constant(exponent)
            return value is None or value.denominator > 1
        case _:
            return False


def sign_by_factors(polynomial: Polynomial, signs: Signs) -> int:
    """1 or -1 of a polynomial that has one sign, by those of its factors; 0 where that is not known."""
    content, factors = factored(polynomial)
    return math.prod(
        (signs.of(factor) ** (2 - exponent % 2) for factor, exponent in factors),
        start=1 if content > 0 else -1,
    )
