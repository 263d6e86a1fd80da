"""All that follows from some equations between polynomials, where certain factors are known not to be zero."""

# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false, reportUnknownArgumentType=false, reportMissingTypeStubs=false

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from typing import Any

from flint import fmpz_mpoly_vec

from corollary.polynomials.polynomial import (
    Polynomial,
    RationalFunction,
    TooLarge,
    checked,
    factored,
    power,
    product,
)
from corollary.polynomials.polynomial_signs import Signs

# Polynomials in a basis, terms in each, bits in a coefficient: a derivation's bases have fewer than ten.
LIMITS = (40, 600, 4000)


class Ideal:
    """Equations `polynomial = 0`, with what is known of the letters; asks whether another equation follows.

    Each equation that is linear in a letter, with a factor that is never zero, is solved for it; of the rest a Gröbner basis
    is made. `spare` is the place of a letter that stands in no equation.
    """

    def __init__(self, known: Signs, spare: int, nonzero: Iterable[Polynomial] = ()) -> None:
        self.known, self.spare = known, spare
        self.solved: list[tuple[int, RationalFunction]] = []
        self.rest: list[Polynomial] = []
        self.nonzero = list(nonzero)
        self._divisors: list[Polynomial] = []  # irreducible, in the letters that are left
        self._basis: Any = None
        self._refresh()

    def copy(self) -> Ideal:
        made = Ideal(self.known, self.spare)
        made.solved, made.rest, made.nonzero = list(self.solved), list(self.rest), list(self.nonzero)
        made._basis, made._divisors = self._basis, list(self._divisors)
        return made

    def exclude(self, polynomial: Polynomial) -> None:
        """Takes it as known that this polynomial is not zero."""
        if not polynomial.is_constant() and polynomial not in self.nonzero:
            self.nonzero.append(polynomial)
            self._refresh()

    def with_equation(self, polynomial: Polynomial) -> Ideal:
        """The ideal with one equation more. Raises TooLarge."""
        made = self.copy()
        made.add(polynomial)
        return made

    def add(self, polynomial: Polynomial) -> None:
        """Raises TooLarge."""
        waiting = [polynomial]
        while waiting:
            new = self.core(self.substituted(waiting.pop()))
            if new.is_zero():
                continue
            self._basis = None
            solved = self._solve(new)
            if solved is None:
                self.rest.append(new)
                continue
            self.solved.append(solved)
            self._refresh()
            waiting += self.rest
            self.rest = []

    def contains(self, polynomial: Polynomial) -> bool:
        """Whether it is zero wherever the equations hold and nothing is zero that must not be. Raises TooLarge."""
        asked = self.substituted(polynomial)
        if asked.is_zero() or not self.rest:
            return asked.is_zero()
        asked = self.core(asked)
        if asked.is_constant():
            return False
        if self._basis is None:
            self._basis = _basis(self.rest)
        if asked.reduction_primitive_part(self._basis).is_zero():
            return True
        return self._vanishes_with(asked) or self._vanishes_squared(asked)

    def _vanishes_squared(self, asked: Polynomial) -> bool:
        """Whether A - B is zero because A^2 - B^2 is, and A + B has one sign: a root has no sign that could be the other."""
        context = asked.context()
        signs = [self.known.of(each) for each in context.gens()]
        positive = context.from_dict(
            {
                exponents: abs(int(coefficient))
                * math.prod(
                    each**exponent for each, exponent in zip(signs, exponents, strict=True) if exponent
                )
                for exponents, coefficient in asked.to_dict().items()
            }
        )
        if not self.known.of(positive):
            return False
        squares = product(asked, positive)
        return squares.reduction_primitive_part(self._basis).is_zero() or self._vanishes_with(squares)

    def _vanishes_with(self, asked: Polynomial) -> bool:
        """Whether no point is left where `asked`, and each of the letters and factors known not to be zero, is not zero."""
        letters = asked.context().gens()
        outside = asked
        for place, letter in enumerate(letters):
            if self.known.of(letter) and any(each.degrees()[place] for each in self.rest):
                outside = product(outside, letter)
        for factor in self._divisors:
            outside = product(outside, factor)
        trick = letters[self.spare] * outside - 1
        return any(each.is_constant() for each in _basis([*self.rest, trick]))

    def core(self, polynomial: Polynomial) -> Polynomial:
        """Its factors that may be zero, each once."""
        if polynomial.is_zero():
            return polynomial
        made = polynomial.context().constant(1)
        for factor, _ in factored(polynomial)[1]:
            if not self.never_zero(factor):
                made = product(made, factor)
        return made

    def never_zero(self, factor: Polynomial) -> bool:
        """Whether an irreducible polynomial is known not to be zero."""
        return bool(self.known.of(factor)) or factor in self._divisors or -factor in self._divisors

    def substituted(self, polynomial: Polynomial) -> Polynomial:
        """The numerator, with the letters replaced for which equations were solved. Raises TooLarge."""
        for place, value in self.solved:
            polynomial = _replaced(polynomial, place, value)
        return polynomial

    def _refresh(self) -> None:
        left = [self.substituted(each) for each in self.nonzero]
        factors = [factor for each in left if not each.is_zero() for factor, _ in factored(each)[1]]
        self._divisors = [each for each in factors if not self.known.of(each)]
        self._basis = None

    def _solve(self, equation: Polynomial) -> tuple[int, RationalFunction] | None:
        """A letter in which the equation is linear, and what it is; that with the shortest factor."""
        degrees, best = equation.degrees(), None
        for place, degree in enumerate(degrees):
            if degree != 1 or place == self.spare:
                continue
            slope, rest = _coefficients(equation, place)[1], _coefficients(equation, place)[0]
            if all(self.never_zero(factor) for factor, _ in factored(slope)[1]) and (
                best is None or len(slope) < len(best[1].bottom)
            ):
                best = place, RationalFunction(-rest, slope)
        return best


def _basis(polynomials: Sequence[Polynomial]) -> Any:
    """A Gröbner basis. Raises TooLarge."""
    context = polynomials[0].context()
    found, done = fmpz_mpoly_vec(list(polynomials), context).buchberger_naive(limits=LIMITS)
    if not done:
        raise TooLarge
    return found


def _coefficients(polynomial: Polynomial, place: int) -> list[Polynomial]:
    """As a polynomial in one letter: the coefficients of its powers, from 0."""
    parts: list[dict[tuple[int, ...], Any]] = [{} for _ in range(polynomial.degrees()[place] + 1)]
    for exponents, coefficient in polynomial.to_dict().items():
        without = (*exponents[:place], 0, *exponents[place + 1 :])
        parts[exponents[place]][without] = coefficient
    return [polynomial.context().from_dict(part) for part in parts]


def _replaced(polynomial: Polynomial, place: int, value: RationalFunction) -> Polynomial:
    if polynomial.is_zero() or not polynomial.degrees()[place]:
        return polynomial
    coefficients = _coefficients(polynomial, place)
    highest, made = len(coefficients) - 1, polynomial.context().constant(0)
    for exponent, coefficient in enumerate(coefficients):
        if not coefficient.is_zero():
            powers = product(power(value.top, exponent), power(value.bottom, highest - exponent))
            made = checked(made + product(coefficient, powers))
    while not made.is_zero() and not (shared := made.gcd(value.bottom)).is_constant():
        made = made / shared  # what is solved for has a bottom that is never zero
    return made
