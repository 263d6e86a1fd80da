"""The argument of a derivation: which line is a law, which follows from lines above it, and which stands on nothing."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from itertools import combinations
from typing import Literal

from corollary.answers.answer import Equation
from corollary.answers.proof.form import Same, has_form_of, has_terms_of, in_full
from corollary.formula.ast import (
    Expr,
    Name,
    Negative,
    Number,
    Power,
    Quotient,
    Relation,
    folded,
    names,
    substitute,
    walk,
)
from corollary.formula.errors import Undefined
from corollary.polynomials.ideal import Ideal
from corollary.polynomials.polynomial import Polynomial, TooLarge, factored
from corollary.polynomials.polynomial_signs import Bounds
from corollary.polynomials.translate import Translation

Kind = Literal["definition", "empty", "law", "follows", "open", "undecided"]


@dataclass(frozen=True, slots=True)
class Grounds:
    """What a derivation stands on: the problem's laws, what is given besides, what is to be shown, what is known of the letters.

    `unknowns` are the letters that are no givens. `known` are the bounds of the givens; `seen` the signs of unknowns wherever
    the laws hold, by which a root is chosen and nothing else: a law times an unknown is not the law.
    """

    laws: tuple[Relation, ...]
    given: tuple[Relation, ...]
    target: Relation
    unknowns: tuple[str, ...]
    known: tuple[tuple[str, Bounds], ...]
    seen: tuple[tuple[str, Bounds], ...] = ()

    @property
    def equations(self) -> tuple[Relation, ...]:
        return (*self.laws, *self.given, self.target)


@dataclass(frozen=True, slots=True)
class Standing:
    """What a line is; `law` is the place of the law that it states, `claims` whether it is what is to be shown; `divisor` is what it
    divides by though that may be zero."""

    kind: Kind
    law: int = -1
    claims: bool = False
    divisor: Expr | None = None


def standings(steps: Sequence[Equation], grounds: Grounds) -> tuple[Standing, ...]:
    """One for each step."""
    try:
        return _Reader(steps, grounds).standings()
    except TooLarge:  # already in the laws, or in a letter of the student's own
        return tuple(Standing("undecided") for _step in steps)


def equal_to(step: Equation, others: Sequence[Relation], steps: Sequence[Equation], grounds: Grounds) -> int:
    """The place of the equation that a step says the same as; -1: of none."""
    try:
        reader = _Reader(steps, grounds, others)
        stated = reader.translation.equation(step.relation)
        return next(
            (
                place
                for place, each in enumerate(others)
                if reader.equivalent(stated, reader.translation.equation(each))
            ),
            -1,
        )
    except (TooLarge, Undefined):
        return -1


@lru_cache(maxsize=256)
def sufficient(grounds: Grounds) -> tuple[frozenset[int], ...]:
    """The least sets of laws that imply the claim, by the laws' places; none where that is not found out."""
    found: list[frozenset[int]] = []
    try:
        reader = _Reader((), grounds)
        for size in range(1, len(grounds.laws) + 1):
            for chosen in combinations(range(len(grounds.laws)), size):
                if any(less <= set(chosen) for less in found):
                    continue
                ideal = reader.with_signs_seen()
                for place in chosen:
                    ideal.add(reader.laws[place])
                if ideal.contains(reader.target):
                    found.append(frozenset(chosen))
    except (TooLarge, Undefined):
        return ()
    return tuple(found)


def _proportional(one: Polynomial, other: Polynomial) -> bool:
    """Whether one is the other times a number."""
    return len(one) == len(other) > 0 and one * other.coeffs()[0] == other * one.coeffs()[0]


class _Reader:
    """The steps as polynomials, in the order in which they stand."""

    def __init__(self, steps: Sequence[Equation], grounds: Grounds, others: Sequence[Relation] = ()) -> None:
        self._steps, self._grounds = steps, grounds
        trees: list[Expr] = [*(step.relation for step in steps), *grounds.equations, *others]
        trees += [Name(name) for name, _bounds in (*grounds.known, *grounds.seen)]
        self.translation = Translation(trees, dict(grounds.known), dict(grounds.seen))
        self.laws = [self.translation.equation(law) for law in grounds.laws]
        self.target = self.translation.equation(grounds.target)
        given = [self.translation.equation(each) for each in grounds.given]
        self._relations = 0
        self.base = Ideal(self.translation.known, self.translation.spare, self.translation.divisors)
        for each in given:
            self.base.add(each)
        self._add_relations(self.base)
        self._lawful = self.with_signs_seen()
        for law in self.laws:
            self._lawful.add(law)
        self._without_lines = self._lawful.copy()
        self._without_lines.known = self.translation.known
        self._above = self.with_signs_seen()
        self._renamed: dict[str, int] = {}
        self._meaning: dict[str, Expr] = {}
        self._written: dict[str, Expr] = {}
        self._define()
        self._catch_up()

    def with_signs_seen(self) -> Ideal:
        """What is given, and the signs that unknowns have wherever the laws hold."""
        made = self.base.copy()
        made.known = self.translation.seen
        return made

    def _define(self) -> None:
        """Letters of the student's own, each after those that it is made of. Raises TooLarge."""
        waiting = [step for step in self._steps if step.defines]
        while waiting:
            own = {step.defines for step in waiting}
            step = next(each for each in waiting if not names(each.meaning) & own)
            waiting.remove(step)
            try:
                value = self.translation.fraction(step.meaning)
            except Undefined:
                raise TooLarge from None
            self._catch_up()
            renamed = self._renames(step)
            self.translation.definitions[step.defines] = (
                self.translation.letter(renamed) if renamed else value
            )
            self._meaning[step.defines] = Name(renamed) if renamed else step.meaning

    def _renames(self, step: Equation) -> str:
        """The problem's letter that a letter of the student's own takes the place of: with it, the definition is a law."""
        for unknown in self._grounds.unknowns:
            polynomial = self.translation.equation(Relation("=", Name(unknown), step.meaning))
            for place, law in enumerate(self.laws):
                if not self.base.contains(law) and self.equivalent(polynomial, law):
                    self._renamed[step.defines] = place
                    return unknown
        return ""

    def standings(self) -> tuple[Standing, ...]:
        return tuple(
            replace(self._standing(step), divisor=self._divisor(step.relation)) for step in self._steps
        )

    def _divisor(self, relation: Relation) -> Expr | None:
        """What an equation divides by and neither the laws nor the signs keep from being zero."""
        for node in walk(relation):
            match node:
                case Quotient(_, below):
                    pass
                case Power(below, Negative(Number())):
                    pass
                case Power(below, Number(value)) if value < 0:
                    pass
                case _:
                    continue
            try:
                value = self.translation.fraction(below).top
                if not any(
                    self._never_zero(each) for each in (value, self._without_lines.substituted(value))
                ):
                    return below
            except (TooLarge, Undefined):
                return below
        return None

    def _standing(self, step: Equation) -> Standing:
        if step.defines:
            if step.defines not in self._renamed:
                return Standing("definition")
            return self._states(self._renamed[step.defines])
        try:
            polynomial = self.translation.equation(step.relation)
            self._catch_up()
            if self.base.contains(polynomial):
                return Standing("empty")
            claims = self.equivalent(polynomial, self.target)
            if claims and self._above.contains(polynomial):
                return Standing("follows", claims=True)
            claims = claims and not self._is_a_law_alone(polynomial)
            for place, law in enumerate(self.laws):
                if self.equivalent(polynomial, law):
                    self._note(step.relation)
                    return self._states(place, claims)
            if self._above.contains(polynomial):
                return Standing("follows", claims=claims)
            if (place := self._written_out(step.relation, claims)) >= 0:
                return self._states(place, claims)
            for place, law in enumerate(self._grounds.laws):
                if self._puts_in(step.relation, law) and not (claims and self._repeats_target(step.relation)):
                    return self._states(place, claims)
            return Standing("open", claims=claims)
        except (TooLarge, Undefined):
            return Standing("undecided")

    def _never_zero(self, polynomial: Polynomial) -> bool:
        """True if the laws, what is given and the signs of the givens keep it from being zero."""
        return not polynomial.is_zero() and all(
            self._without_lines.never_zero(factor) for factor, _ in factored(polynomial)[1]
        )

    def _states(self, law: int, claims: bool = False) -> Standing:
        self._above.add(self.laws[law])
        return Standing("law", law, claims)

    def equivalent(self, one: Polynomial, other: Polynomial) -> bool:
        """Whether each follows from the other, by what is given and no law. Raises TooLarge."""
        mine, theirs = (self.base.core(self.base.substituted(each)) for each in (one, other))
        if mine in (theirs, -theirs):
            return True
        if mine.is_constant() or theirs.is_constant() or not self.base.rest:
            return False
        return self.base.with_equation(mine).contains(theirs) and self.base.with_equation(theirs).contains(
            mine
        )

    def _note(self, law: Relation) -> None:
        """Which letter a law gives, as the student wrote it."""
        if isinstance(law.left, Name) and law.left.name not in names(law.right):
            self._written[law.left.name] = law.right

    def _written_out(self, relation: Relation, claims: bool) -> int:
        """The place of the law that this is once the very words of lines above are put back for their letters, or their letters
        for them; -1: of none. Below p = m v, K = p v/2 is K = m v^2/2; below v = p/m, K = m (p/m)^2/2 is.

        A claim with words for its letters would be a law that nobody wrote.
        """
        ways = [folded(relation, self._written)] + ([] if claims else [substitute(relation, self._written)])
        for way in ways:
            if way != relation and isinstance(way, Relation):
                polynomial = self.translation.equation(way)
                self._catch_up()
                for place, law in enumerate(self.laws):
                    if self.equivalent(polynomial, law):
                        return place
        return -1

    def _puts_in(self, relation: Relation, law: Relation) -> bool:
        """Whether this is the law with letters replaced by what the lines above say they are."""
        whole = in_full(relation, self._meaning)
        return whole is not None and has_form_of(whole, law, self._same(self._above), self._nonzero)

    def _is_a_law_alone(self, polynomial: Polynomial) -> bool:
        """Whether this is a law, and the claim only times a factor that is never zero: m g h = m v^2/2 where v^2 = 2 g h is to be shown."""
        return not _proportional(polynomial, self.target) and any(
            _proportional(polynomial, law) for law in self.laws
        )

    def _repeats_target(self, relation: Relation) -> bool:
        whole = in_full(relation, self._meaning)
        return whole is None or has_terms_of(whole, self._grounds.target, self._same(self.base))

    def _nonzero(self, tree: Expr) -> bool:
        value = self.translation.fraction(tree).top
        return all(self.base.never_zero(factor) for factor, _ in factored(value)[1])

    def _same(self, ideal: Ideal) -> Same:
        def same(one: Expr, other: Expr) -> bool:
            return one == other or ideal.contains(self.translation.equation(Relation("=", one, other)))

        return same

    def _add_relations(self, ideal: Ideal) -> None:
        for relation in self.translation.relations[self._relations :]:
            ideal.add(relation)

    def _catch_up(self) -> None:
        """What was translated since may have made roots and sines, and divided by something."""
        for ideal in (self.base, self._lawful, self._above):
            self._add_relations(ideal)
        self._relations = len(self.translation.relations)
        for divisor in self.translation.divisors:
            if divisor not in self.base.nonzero and not self._lawful.contains(divisor):
                for ideal in (self.base, self._lawful, self._above):
                    ideal.exclude(divisor)
