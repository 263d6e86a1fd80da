"""A record made ready to be solved: its letters and what they measure, its laws, and which roots its wording admits."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import islice, product

from corollary.audit.record import ExerciseRecord, StatedGiven
from corollary.derive.system import NamedEquation, SystemRoot, stated, system_roots
from corollary.formula.ast import Relation, names
from corollary.formula.ball import RationalPi, holds
from corollary.formula.errors import Undefined
from corollary.formula.numerals import decimal_text
from corollary.formula.syntax import author_formula
from corollary.laws.law import Law
from corollary.problem.conditions import relations
from corollary.problem.variant import with_unit
from corollary.units.constants import CONSTANTS
from corollary.units.inferred import DimensionInference
from corollary.units.unit import Dimension, Unit, show, si_unit

USUAL_GRAVITY = ("9.8", "9.81", "10")  # m/s^2, tried where a text does not say g
MOST_ALTERNATIVES = 12
FIGURES = 6  # figures of a number in a sentence

Numbers = Mapping[str, RationalPi]


@dataclass(frozen=True, slots=True)
class AdmittedRoot:
    """The value of every letter in SI, the givens' too; `against` is the condition it contradicts ("": none)."""

    values: Mapping[str, float]
    left: tuple[NamedEquation, ...]
    against: str = ""


@dataclass(frozen=True, slots=True)
class PublishedExercise:
    """`givens` include constants and what is assumed; `dimensions` has every letter for which the laws tell what it measures."""

    record: ExerciseRecord
    givens: Mapping[str, StatedGiven]
    unknowns: tuple[str, ...]
    laws: tuple[Law, ...]
    where: tuple[tuple[Relation, str], ...]
    dimensions: Mapping[str, Dimension]

    @property
    def fixed(self) -> bool:
        """Whether every given has one value."""
        return all(given.fixed for given in self.givens.values())

    @property
    def numbers(self) -> dict[str, RationalPi]:
        """The givens in SI that have one value."""
        return {name: exact(given) for name, given in self.givens.items() if given.fixed}

    def unit_of(self, letter: str) -> Unit | None:
        """A given's own unit, the SI unit of anything else; None where the laws leave open what it measures."""
        if letter in self.givens:
            return self.givens[letter].unit
        return si_unit(self.dimensions[letter]) if letter in self.dimensions else None

    def roots(self, at: Numbers) -> list[AdmittedRoot]:
        """The real roots at these numbers. Raises NoRoot where the laws do not fix the unknowns."""
        return list(self.admitted(system_roots(self.laws, self.unknowns, at), at))

    def contradicted(self, letter: str, value: RationalPi, within: float) -> bool:
        """Whether the laws cannot hold with this value of an unknown, the others being whatever they must be."""
        others = tuple(each for each in self.unknowns if each != letter)
        found = system_roots(self.laws, others, {**self.numbers, letter: value})
        return all(any(True for _ in contradictions(root.left, within)) for root in found)

    def admitted(self, found: tuple[SystemRoot, ...], at: Numbers) -> Iterator[AdmittedRoot]:
        """Of the roots those that are real at these numbers, each with the condition that it contradicts."""
        for root in found:
            values = root.at(at)
            if values is not None:
                yield AdmittedRoot(values | self._in_si(at), root.left, self.against(values, at))

    def against(self, values: Mapping[str, float], at: Numbers) -> str:
        """The first condition that does not hold for these values of the unknowns, or ""."""
        everything = dict(at) | {name: RationalPi(Fraction(value)) for name, value in values.items()}
        for relation, text in self.where:
            try:
                if not holds(relation, everything):
                    return text
            except (Undefined, KeyError):
                return text
        return ""

    def otherwise(self) -> Iterator[tuple[PublishedExercise, str]]:
        """The same exercise under other usual conventions, and what is assumed then."""
        assumed = [each for each in self.record.assumed if each.symbol in self.givens]
        choices = [each.values for each in assumed]
        for place, each in enumerate(assumed):
            if each.symbol == "g" and show(each.unit) == "m/s²":
                usual = map(Fraction, USUAL_GRAVITY)
                choices[place] = tuple(dict.fromkeys((*each.values, *usual)))
        for values in islice(product(*choices), 1, MOST_ALTERNATIVES):
            changed = {each.symbol: each.given(value) for each, value in zip(assumed, values, strict=True)}
            words = ", ".join(f"{name} = {given.text}" for name, given in changed.items())
            yield replace(self, givens=dict(self.givens) | changed), words

    def _in_si(self, at: Numbers) -> dict[str, float]:
        return {name: float(value) for name, value in at.items()}


def contradictions(left: Sequence[NamedEquation], within: float) -> Iterator[tuple[str, float, float]]:
    """Each law that only numbers are left of and whose sides differ by more than a share of them, with its sides."""
    for equation in left:
        sides = equation.at({})
        if sides is not None and abs(sides[0] - sides[1]) > within * max(map(abs, sides)):
            yield equation.law, *sides


def exercise_of(record: ExerciseRecord) -> PublishedExercise:
    """The exercise of a record with laws. Raises ValueError with a sentence where they cannot be meant so."""
    used = {letter for each in record.laws for letter in names(author_formula(each.formula))} - {"pi"}
    givens = {each.symbol: each for each in record.given}
    givens |= {
        each.symbol: each.given(each.values[0])
        for each in record.assumed
        if each.symbol in used - givens.keys()
    }
    for name in record.constants:
        if name in used - givens.keys():
            constant = CONSTANTS[name]
            givens[name] = StatedGiven(name, constant.unit, constant.value, constant.value)
    unknowns = tuple(sorted(used - givens.keys()))
    for asked in record.asked:
        if asked.letter not in unknowns:
            where = (
                "given"
                if asked.letter in givens
                else f"in none of the laws (they have {', '.join(sorted(used))})"
            )
            raise ValueError(f"{asked.letter} is asked for, and is {where}")
    if len(record.laws) < len(unknowns):
        named = [each for each in unknowns if each in CONSTANTS]
        remedy = f"; is {named[0]} a constant? then write constants: [{named[0]}]" if named else ""
        raise ValueError(
            f"{len(record.laws)} laws for {len(unknowns)} unknowns ({', '.join(unknowns)}){remedy}"
        )
    dimensions = _dimensions(record, givens)
    laws = stated([(each.name, each.formula) for each in record.laws], signs(givens), unknowns)
    found = PublishedExercise(record, givens, unknowns, laws, (), dimensions)
    units = {name: found.unit_of(name) for name in (*givens, *unknowns)}
    known = {name: each for name, each in units.items() if each is not None}
    return replace(found, where=tuple(each for text in record.where for each in _condition(text, known)))


def _dimensions(record: ExerciseRecord, givens: Mapping[str, StatedGiven]) -> dict[str, Dimension]:
    inference = DimensionInference({name: given.unit.dimension for name, given in givens.items()})
    for law in record.laws:
        try:
            inference.learn(author_formula(law.formula))
        except ValueError as error:
            raise ValueError(f"{law.name}: {error}") from None
    for asked in record.asked:
        if (
            asked.unit is not None
            and inference.dimensions.get(asked.letter, asked.unit.dimension) != asked.unit.dimension
        ):
            raise ValueError(f"{asked.letter} is not measured in {show(asked.unit) or 'plain numbers'}")
    return inference.dimensions


def _condition(text: str, units: Mapping[str, Unit]) -> list[tuple[Relation, str]]:
    try:
        return relations(text, units)
    except ValueError as error:
        raise ValueError(f"where {text}: {error}") from None


def signs(givens: Mapping[str, StatedGiven]) -> dict[str, int]:
    """The sign that each given has for all of its values, or 0."""
    return {name: _sign(given) for name, given in givens.items()}


def _sign(given: StatedGiven) -> int:
    if given.low is None or given.high is None:
        return 1
    return 1 if given.low > 0 else -1 if given.high < 0 else 0


def exact(given: StatedGiven) -> RationalPi:
    """A given with one value in SI."""
    assert given.low is not None
    return RationalPi(*given.unit.to_si(given.low))


def quantity(value: float, unit: Unit | None, figures: int = FIGURES) -> str:
    """A value in SI as people read it."""
    if unit is None:
        return decimal_text(value, figures)
    return with_unit(decimal_text(unit.from_si(value), figures), unit).replace("\N{NO-BREAK SPACE}", " ")
