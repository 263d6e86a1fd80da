"""The form of an equation, term by term: whether it is a law in which letters are replaced by what they are equal to."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import reduce
from itertools import permutations

from corollary.formula.arithmetics import constant
from corollary.formula.ast import (
    Expr,
    Negative,
    Number,
    Power,
    Product,
    Quotient,
    Relation,
    Sum,
    substitute,
    walk,
)

MOST_TERMS = 10
MOST_FACTORS = 6
MOST_NODES = 600

Same = Callable[[Expr, Expr], bool]
"""Whether two formulas are equal by what is known."""
Nonzero = Callable[[Expr], bool]
"""Whether a formula is never zero by what is known."""


@dataclass(frozen=True, slots=True)
class Term:
    """A number times powers of factors; a bracket is one factor, whatever stands in it."""

    number: Fraction
    factors: tuple[tuple[Expr, Fraction], ...]


def in_full(relation: Relation, meaning: Mapping[str, Expr]) -> Relation | None:
    """The equation with letters of the student's own replaced; None where that is too long."""
    for _again in range(len(meaning) + 1):
        if len(list(walk(relation))) > MOST_NODES:
            return None
        replaced = substitute(relation, meaning)
        if replaced == relation:
            return relation
        relation = replaced
    return None


def has_form_of(relation: Relation, law: Relation, same: Same, nonzero: Nonzero) -> bool:
    """Whether the terms of one are those of the other, one by one, up to a factor that they all share and that is never zero."""
    return any(
        len(mine) == len(theirs)
        and 1 < len(mine) <= MOST_TERMS
        and any(_paired(mine, theirs, ratio, same) for ratio in _ratios(mine, theirs[0], same))
        for mine in (terms(relation, _multiplied_out, nonzero), terms(relation, _one_by_one, nonzero))
        for theirs in (terms(law, _multiplied_out, nonzero), terms(law, _one_by_one, nonzero))
    )


def has_terms_of(relation: Relation, other: Relation, same: Same) -> bool:
    """Whether the terms have the values of the other's, one by one, up to a common factor, whatever their form."""
    return any(
        _are_values_of(list(map(_tree, mine)), list(map(_tree, theirs)), same)
        for mine in _both_ways(relation)
        for theirs in _both_ways(other)
    )


def _both_ways(relation: Relation) -> tuple[list[Term], list[Term]]:
    return terms(relation, _multiplied_out, _never), terms(relation, _one_by_one, _never)


def _never(base: Expr) -> bool:
    """No factor is taken out."""
    return False


def _are_values_of(mine: list[Expr], theirs: list[Expr], same: Same) -> bool:
    if len(mine) != len(theirs) or not 0 < len(mine) <= MOST_TERMS:
        return len(mine) > MOST_TERMS
    for place in range(len(theirs)):
        first, left = theirs[place], theirs[:place] + theirs[place + 1 :]
        for term in mine[1:]:
            found = next(
                (each for each in left if same(Product((term, first)), Product((each, mine[0])))), None
            )
            if found is None:
                break
            left.remove(found)
        else:
            return True
    return False


def _tree(term: Term) -> Expr:
    powers = (Power(base, Number(exponent)) for base, exponent in term.factors)
    return Product((Number(term.number), *powers))


def repeats(relation: Relation, other: Relation) -> bool:
    """Whether two equations are the same but for their order and their sides."""
    mine, theirs = (
        {
            (term.number, frozenset(term.factors))
            for term in (*_one_by_one(each.left), *map(_opposite, _one_by_one(each.right)))
        }
        for each in (relation, other)
    )
    return mine in (theirs, {(-number, factors) for number, factors in theirs})


def terms(relation: Relation, of: Callable[[Expr], list[Term]], nonzero: Nonzero) -> list[Term]:
    """Left minus right, without a factor that all terms share and that is never zero."""
    found = [term for term in (*of(relation.left), *map(_opposite, of(relation.right))) if term.number]
    if not found:
        return []
    shared = dict(found[0].factors)
    for term in found[1:]:
        own = dict(term.factors)
        shared = {base: min(power, own.get(base, Fraction(0))) for base, power in shared.items()}
    shared = {base: power for base, power in shared.items() if power and nonzero(base)}
    return [_divided(term, shared) for term in found]


def _opposite(term: Term) -> Term:
    return Term(-term.number, term.factors)


def _inverse(term: Term) -> Term:
    return Term(1 / term.number, tuple((base, -power) for base, power in term.factors))


def _divided(term: Term, by: Mapping[Expr, Fraction]) -> Term:
    left = [(base, power - by.get(base, Fraction(0))) for base, power in term.factors]
    missing = [(base, -power) for base, power in by.items() if base not in dict(term.factors)]
    return Term(term.number, tuple((base, power) for base, power in (*left, *missing) if power))


def _multiplied_out(tree: Expr) -> list[Term]:
    """The terms of a sum, and those of the one sum that a factor stands before; where two sums are factors, each is one factor."""
    match tree:
        case Sum(parts):
            return [term for part in parts for term in _multiplied_out(part)]
        case Negative(part):
            return [_opposite(term) for term in _multiplied_out(part)]
        case Product(parts):
            each = [_multiplied_out(part) for part in parts]
            sums = [found for found in each if len(found) > 1]
            if len(sums) != 1:
                return [_term(tree)]
            rest = [_term(part) for part, found in zip(parts, each, strict=True) if len(found) < 2]
            return [reduce(_times, rest, term) for term in sums[0]]
        case Quotient(top, bottom) if _term(bottom).number:
            return [_times(term, _inverse(_term(bottom))) for term in _multiplied_out(top)]
        case _:
            return [_term(tree)]


def _one_by_one(tree: Expr) -> list[Term]:
    """The terms of a sum; a bracket that a factor stands before is one factor."""
    match tree:
        case Sum(parts):
            return [term for part in parts for term in _one_by_one(part)]
        case Negative(part):
            return [_opposite(term) for term in _one_by_one(part)]
        case _:
            return [_term(tree)]


def _term(tree: Expr) -> Term:
    """A formula as one term: what is a sum is a factor of it."""
    value = constant(tree)
    match tree:
        case _ if value is not None:
            return Term(value, ())
        case Negative(part):
            return _opposite(_term(part))
        case Product(parts):
            return reduce(_times, map(_term, parts))
        case Quotient(top, bottom) if (below := _term(bottom)).number:
            return _times(_term(top), _inverse(below))
        case Power(base, exponent) if (power := constant(exponent)) is not None:
            return Term(Fraction(1), ((base, power),))
        case _:
            return Term(Fraction(1), ((tree, Fraction(1)),))


def _times(left: Term, right: Term) -> Term:
    powers = dict(left.factors)
    for base, power in right.factors:
        powers[base] = powers.get(base, Fraction(0)) + power
    return Term(left.number * right.number, tuple((base, power) for base, power in powers.items() if power))


def _ratios(mine: list[Term], first: Term, same: Same) -> set[Fraction]:
    """By which number all of mine may be larger than theirs."""
    return {sign * term.number / first.number for term in mine for sign in _signs(term, first, same)}


def _paired(mine: list[Term], theirs: list[Term], ratio: Fraction, same: Same) -> bool:
    left = list(theirs)
    for term in mine:
        found = next(
            (
                other
                for other in left
                for sign in (
                    _signs(term, other, same) if abs(term.number) == abs(ratio * other.number) else ()
                )
                if sign * term.number == ratio * other.number
            ),
            None,
        )
        if found is None:
            return False
        left.remove(found)
    return True


def _signs(term: Term, other: Term, same: Same) -> set[int]:
    """1 where the factors of both are equal one by one, -1 where they are but for the sign."""
    if len(term.factors) != len(other.factors) or len(term.factors) > MOST_FACTORS:
        return set()
    mine = [each for each in term.factors if each not in other.factors]
    theirs = [each for each in other.factors if each not in term.factors]
    if len(mine) > 4:
        return set()
    found: set[int] = set()
    for order in permutations(theirs):
        sign = 1
        for (base, power), (base_2, power_2) in zip(mine, order, strict=True):
            if power != power_2:
                break
            if same(base, base_2):
                continue
            if power.denominator > 1 or not same(base, Negative(base_2)):
                break
            sign *= (-1) ** power.numerator
        else:
            found.add(sign)
    return found
