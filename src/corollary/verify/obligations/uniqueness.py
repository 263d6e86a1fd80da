"""Uniqueness of the root of a step's laws: linear systems, invertible functions, and polynomials whose roots are all known."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from itertools import combinations
from typing import Any

from corollary.formula.arithmetics import exactly
from corollary.formula.ast import (
    ZERO,
    Call,
    Expr,
    Name,
    Negative,
    Number,
    Power,
    Product,
    Relation,
    Sum,
    children,
    map_children,
    names,
    substitute,
    walk,
)
from corollary.formula.ball import holds
from corollary.formula.errors import Undefined
from corollary.formula.rational_pi import RationalPi
from corollary.polynomials.ideal import Ideal
from corollary.polynomials.polynomial import Polynomial, TooLarge, factored
from corollary.polynomials.translate import Translation, makes_a_letter
from corollary.verify.obligations.box import Box
from corollary.verify.obligations.obligation import Clause, Equations

INVERTIBLE = frozenset({"exp", "ln", "log10", "sqrt", "atan", "asin", "acos", "sinh", "tanh"})
LARGEST_SYSTEM = 6  # unknowns: a determinant of n rows has up to n! terms
MOST_MINORS = 20
ARGUMENT = "@argument"
STEPS_AWAY = tuple(Fraction(sign * each, 7) for each in (7, 1, 60) for sign in (1, -1))


class NotPolynomial(ValueError):
    """Laws that are no polynomials in their unknowns."""


def leading(box: Box, equations: Equations) -> tuple[Clause, ...] | None:
    """Clauses under which the equations have no root but those that are meant, rejected or otherwise known, wherever the clauses have a
    value: determinants and leading coefficients do not vanish. None where algebra does not say."""
    try:
        laws, unknowns = equations.laws, equations.unknowns
        system, inside = PolynomialSystem.of(laws, unknowns)
        if system.degree <= 1:
            own = system.determinants()
            return None if own is None else (*own, *inside)
        if inside or not _complete(system, box, equations):
            return None
        return system.not_zero(system.of_power(system.tops[0], system.degree))
    except (NotPolynomial, TooLarge, Undefined, KeyError):
        return None


def another_root(equations: Equations, values: Mapping[str, RationalPi]) -> dict[str, Fraction] | None:
    """A second root for these givens, which fulfils the conditions, too: a rational number, of a linear system on a line of roots through
    the one that is meant. None where none is found."""
    meant = [exactly(equations.meant[name], values) for name in equations.unknowns]
    at = [each.ratio if each is not None and not each.pi else None for each in meant]
    for root in _candidates(equations, values, at):
        found = dict(zip(equations.unknowns, root, strict=True))
        if list(root) != at and fulfils(
            (*equations.laws, *equations.where),
            {name: Number(value) for name, value in found.items()},
            values,
        ):
            return found
    return None


def _candidates(
    equations: Equations, values: Mapping[str, RationalPi], meant: Sequence[Fraction | None]
) -> Iterator[tuple[Fraction, ...]]:
    if len(meant) == 1:
        yield from (((meant[0] or 0) + step,) for step in STEPS_AWAY)
        return
    try:
        rows = PolynomialSystem(equations.laws, equations.unknowns).rows_at(values)
    except (NotPolynomial, TooLarge, Undefined, KeyError):
        return
    for direction in _null_space(rows or []):
        for step in STEPS_AWAY:
            root = [each + step * by for each, by in zip(meant, direction, strict=True) if each is not None]
            if len(root) == len(meant):
                yield tuple(root)


def fulfils(
    relations: Iterable[Relation], root: Mapping[str, Expr], values: Mapping[str, RationalPi]
) -> bool:
    """Whether a root fulfils the relations for these givens. Where an equation of irrational numbers cannot be decided, to thousands of
    bits nothing speaks against it."""
    try:
        for each in relations:
            found = holds(substitute(each, root), values)
            if found is False or (found is None and each.sign != "="):
                return False
    except (Undefined, KeyError):
        return False
    return True


class PolynomialSystem:
    """Laws as polynomials in their unknowns, the coefficients polynomials in givens and in letters for what else is made of givens alone.

    Raises NotPolynomial, TooLarge, and Undefined where something is divided by zero.
    """

    def __init__(self, laws: Sequence[Relation], unknowns: Sequence[str]) -> None:
        self.unknowns = tuple(unknowns)
        self.letters: dict[Expr, str] = {}
        opened = [self.opened(each) for each in laws]
        if any(makes_a_letter(node) and names(node) & set(unknowns) for law in opened for node in walk(law)):
            raise NotPolynomial
        translation = Translation([*opened, *map(Name, unknowns)], {})
        tops = [
            (translation.fraction(left) - translation.fraction(right)).top
            for left, right in map(children, opened)
        ]
        self.tops = [top for top in tops if not top.is_zero()]
        self.names: tuple[str, ...] = translation.context.names()
        self.places: list[int] = [self.names.index(name) for name in unknowns]

    @classmethod
    def of(
        cls, laws: Sequence[Relation], unknowns: Sequence[str]
    ) -> tuple[PolynomialSystem, tuple[Clause, ...]]:
        """The system; of an unknown that stands in an invertible function only, such as exp(k*x), the system for the function's value, and
        what must not vanish so that the value fixes the unknown."""
        try:
            return cls(laws, unknowns), ()
        except NotPolynomial:
            call = _outermost(laws, unknowns)
            if call is None:
                raise
        value, (argument,) = Name("@value"), call.arguments
        replaced = [_exchanged(each, call, value) for each in laws]
        inner, deeper = cls.of([Relation("=", argument, Name(ARGUMENT))], unknowns)
        inside = inner.determinants() if inner.degree == 1 else None
        if inside is None or any(names(each) & set(unknowns) for each in replaced):
            raise NotPolynomial
        if any(ARGUMENT in names(each) for clause in (*inside, *deeper) for each in clause):
            raise NotPolynomial
        return cls([each for each in replaced if isinstance(each, Relation)], [value.name]), (
            *inside,
            *deeper,
        )

    @property
    def degree(self) -> int:
        """In the unknowns together."""
        return max(
            (sum(powers[at] for at in self.places) for top in self.tops for powers in _terms(top)),
            default=0,
        )

    def determinants(self) -> tuple[Clause, ...] | None:
        """That no factor of the determinant vanishes; of more laws than unknowns, that not all minors do."""
        size = len(self.unknowns)
        rows = [[_coefficient(top, place, 1) for place in self.places] for top in self.tops]
        minors = list(combinations(rows, size))
        if size > LARGEST_SYSTEM or len(minors) > MOST_MINORS:
            return None
        left = [each for each in map(_determinant, minors) if not each.is_zero()]
        if any(each.is_constant() for each in left):
            return ()
        if len(left) == 1:
            return self.not_zero(left[0])
        return (tuple(Relation("!=", self.tree(each), ZERO) for each in left),) if left else None

    def of_power(self, top: Polynomial, power: int) -> Polynomial:
        """Of the only unknown."""
        return _coefficient(top, self.places[0], power)

    def not_zero(self, polynomial: Polynomial) -> tuple[Clause, ...]:
        """That none of its factors is zero."""
        return tuple((Relation("!=", self.tree(factor), ZERO),) for factor, _ in factored(polynomial)[1])

    def rows_at(self, values: Mapping[str, RationalPi]) -> list[list[Fraction]] | None:
        """The coefficients of the unknowns for these givens; None where they are not rational, or the system is not linear."""
        if self.degree > 1:
            return None
        rows = [
            [exactly(self.tree(_coefficient(top, place, 1)), values) for place in self.places]
            for top in self.tops
        ]
        if any(each is None or each.pi for row in rows for each in row):
            return None
        return [[each.ratio for each in row if each is not None] for row in rows]

    def opened(self, tree: Expr) -> Expr:
        """The formula with a letter for each root, sine and the like of givens alone."""
        if makes_a_letter(tree) and not names(tree) & set(self.unknowns):
            return Name(self.letters.setdefault(tree, f"@{len(self.letters)}"))
        return map_children(tree, self.opened)

    def tree(self, polynomial: Polynomial, meant: bool = True) -> Expr:
        """The polynomial as a formula, with what its letters are `meant` to be."""
        meanings = {name: tree for tree, name in self.letters.items()} if meant else {}
        terms: list[Expr] = []
        for powers, coefficient in _terms(polynomial).items():
            bases = [
                (meanings.get(name, Name(name)), power)
                for name, power in zip(self.names, powers, strict=True)
                if power
            ]
            factors: list[Expr] = [
                base if power == 1 else Power(base, Number(Fraction(power))) for base, power in bases
            ]
            if abs(coefficient) != 1 or not factors:
                factors.insert(0, Number(Fraction(abs(coefficient))))
            term = factors[0] if len(factors) == 1 else Product(tuple(factors))
            terms.append(term if coefficient > 0 else Negative(term))
        return ZERO if not terms else terms[0] if len(terms) == 1 else Sum(tuple(terms))


def _null_space(rows: list[list[Fraction]]) -> Iterator[list[Fraction]]:
    """A basis of what all rows take to zero, by elimination."""
    left, pivots = [list(row) for row in rows], list[int]()
    for column in range(len(rows[0]) if rows else 0):
        row = next((row for row in left[len(pivots) :] if row[column]), None)
        if row is None:
            continue
        left.remove(row)
        scaled = [each / row[column] for each in row]
        left = [[a - b * other[column] for a, b in zip(other, scaled, strict=True)] for other in left]
        left.insert(len(pivots), scaled)
        pivots.append(column)
    for free in (column for column in range(len(rows[0]) if rows else 0) if column not in pivots):
        direction = [Fraction(int(column == free)) for column in range(len(rows[0]))]
        for row, pivot in zip(left, pivots, strict=False):
            direction[pivot] = -row[free]
        yield direction


def _complete(system: PolynomialSystem, box: Box, equations: Equations) -> bool:
    """Whether the only law is its leading coefficient times the distances from as many roots as its degree: then there are no others."""
    if len(system.tops) != 1 or len(system.unknowns) != 1:
        return False
    ((top,), (name,)) = system.tops, system.unknowns
    known = [equations.meant, *equations.rejected, *equations.others]
    roots = [each[name] for each in known if name in each]
    if len(roots) != system.degree:
        return False
    apart = [Sum((Name(name), Negative(each))) for each in roots]
    made = Product((system.tree(system.of_power(top, system.degree)), *apart))
    translation = Translation(
        [made, system.tree(top)], {name: axis.bounds for name, axis in box.axes.items()}
    )
    gap = translation.fraction(system.tree(top)) - translation.fraction(made)
    ideal = Ideal(translation.known, translation.spare, translation.divisors)
    for each in translation.relations:
        ideal.add(each)
    return bool(ideal.contains(gap.top))


def _outermost(laws: Sequence[Relation], unknowns: Sequence[str]) -> Call | None:
    """The one invertible function that holds the only unknown."""
    inside = {
        node for law in laws for node in walk(law) if makes_a_letter(node) and names(node) & set(unknowns)
    }
    outer = [
        each for each in inside if not any(each is not other and each in set(walk(other)) for other in inside)
    ]
    if len(outer) != 1 or len(unknowns) != 1 or not isinstance(outer[0], Call):
        return None
    return outer[0] if outer[0].function in INVERTIBLE else None


def _exchanged(tree: Expr, part: Expr, other: Expr) -> Expr:
    if tree == part:
        return other
    return map_children(tree, lambda each: _exchanged(each, part, other))


def _terms(polynomial: Polynomial) -> dict[tuple[int, ...], int]:
    return {tuple(map(int, powers)): int(coefficient) for powers, coefficient in polynomial.to_dict().items()}


def _coefficient(polynomial: Polynomial, place: int, power: int) -> Polynomial:
    """Of a letter's power, as a polynomial in all other letters."""
    found = {
        tuple(0 if at == place else each for at, each in enumerate(powers)): coefficient
        for powers, coefficient in _terms(polynomial).items()
        if powers[place] == power
    }
    return polynomial.context().from_dict(found)


def _determinant(rows: Sequence[Sequence[Any]]) -> Any:
    """By the first row. Raises TooLarge."""
    first, *rest = rows
    if not rest:
        return first[0]
    total = first[0].context().constant(0)
    for place, entry in enumerate(first):
        if not entry.is_zero():
            minor = _determinant([[*row[:place], *row[place + 1 :]] for row in rest])
            total += (1 if place % 2 == 0 else -1) * entry * minor
    return total
