"""A record made ready to be solved: its letters and what they measure, its laws, and which roots its wording admits."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import islice, product

from corollary.audit.contractor import NoContractor, turning_letters
from corollary.audit.enclosed_roots import MOST_TURNS, POSSIBLE, EnclosedRoots, enclosed_roots, middle
from corollary.audit.record import ExerciseRecord, StatedGiven
from corollary.derive.system import SystemRoot, stated, system_roots
from corollary.formula.arithmetics import constant
from corollary.formula.ast import Power, Relation, calls, names, walk
from corollary.formula.ball import RationalPi, certified, holds
from corollary.formula.enclosure import Enclosure
from corollary.formula.errors import Undefined
from corollary.formula.numerals import decimal_text, figures_apart
from corollary.formula.syntax import author_formula
from corollary.laws.law import Law
from corollary.problem.conditions import relations
from corollary.problem.variant import with_unit
from corollary.units.constants import CONSTANTS
from corollary.units.inferred import DimensionInference
from corollary.units.unit import Dimension, Unit, show, si_unit

USUAL_GRAVITY = ("9.8", "9.81", "10")  # m/s^2, tried where a text does not say g
MOST_ALTERNATIVES = 12
SHARP = 1e-10  # relative: a root enclosed so narrowly has all the figures that anybody prints
TURN = Enclosure(-3.2, 3.2)  # a little more, for an angle of half a turn is not to be on the edge
NEARLY_A_TURN = Enclosure(-3.0, 3.28)  # and a little less: nothing is a whole turn from anything else
FIGURES = 6  # figures of a number in a sentence

Numbers = Mapping[str, RationalPi]


@dataclass(frozen=True, slots=True)
class AdmittedRoot:
    """The value of every letter in SI, the givens' too; `against` is the condition it contradicts ("": none).

    `left` are the laws that only numbers are left of, each with its two sides.
    """

    values: Mapping[str, float]
    left: tuple[tuple[str, float, float], ...]
    against: str = ""


@dataclass(frozen=True, slots=True)
class SolvedExercise:
    """The roots that were found at some numbers; `proven`: there are no others that the conditions admit."""

    roots: list[AdmittedRoot]
    proven: bool


@dataclass(frozen=True, slots=True)
class PublishedExercise:
    """`givens` include constants and what is assumed; `dimensions` has every letter for which the laws tell what it measures.

    Without `by_algebra` the laws are solved by intervals alone, where algebra takes too long.
    """

    record: ExerciseRecord
    givens: Mapping[str, StatedGiven]
    unknowns: tuple[str, ...]
    laws: tuple[Law, ...]
    where: tuple[tuple[Relation, str], ...]
    dimensions: Mapping[str, Dimension]
    by_algebra: bool = True

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

    @property
    def square(self) -> bool:
        """Whether there are as many laws of unknowns as unknowns: then intervals can decide."""
        live = [each for each in self.equations if names(each) & set(self.unknowns)]
        return len(live) == len(self.unknowns)

    @property
    def equations(self) -> list[Relation]:
        """The laws as they are written."""
        found = (author_formula(law.formula) for law in self.record.laws)
        return [each for each in found if isinstance(each, Relation)]

    def roots(self, at: Numbers) -> list[AdmittedRoot]:
        """The real roots at these numbers. Raises NoRoot where the laws do not fix the unknowns."""
        return self.solved(at).roots

    def solved(self, at: Numbers) -> SolvedExercise:
        """The real roots at these numbers, by intervals where these find them all, else by algebra. Raises NoRoot.

        Intervals leave out what contradicts a condition, unless nothing else is left.
        """
        with suppress(NoContractor):
            found = self._by_intervals(at, [relation for relation, _ in self.where])
            if found.none:
                besides = self.enclosed(self._by_intervals(at, ()).roots, at)
                return SolvedExercise([each for each in besides if each.against], proven=True)
            if found.complete and found.roots and self._sharp(found):
                return SolvedExercise(self.enclosed(found.roots, at), proven=True)
        if not self.by_algebra:
            return SolvedExercise([], proven=False)
        roots = list(self.admitted(system_roots(self.laws, self.unknowns, at), at))
        return SolvedExercise(roots, proven=all(map(_polynomial, self.equations)))

    def _by_intervals(self, at: Numbers, conditions: Sequence[Relation]) -> EnclosedRoots:
        asked = {each.letter for each in self.record.asked}
        within = dict.fromkeys(self._turning() - asked, TURN)
        return enclosed_roots(self.equations, conditions, self.unknowns, at, within, turns=MOST_TURNS)

    def _turning(self) -> set[str]:
        """The unknown angles of which the laws and conditions tell no turn: one a whole turn away is the same."""
        return turning_letters([*self.equations, *(relation for relation, _ in self.where)], self.unknowns)

    def near(self, letter: str, within: Enclosure) -> EnclosedRoots:
        """The roots that the conditions admit where a letter is within bounds. Raises NoContractor."""
        conditions = [relation for relation, _ in self.where]
        turning = dict.fromkeys(self._turning(), TURN)
        bounds = turning | {letter: within}
        return enclosed_roots(self.equations, conditions, self.unknowns, self.numbers, bounds)

    def around(self, letter: str, value: float) -> EnclosedRoots:
        """The roots that the conditions admit at any value of a letter; at an angle those within half a turn of the value."""
        if letter not in self._turning():
            return self.near(letter, POSSIBLE)
        return self.near(letter, Enclosure(value + NEARLY_A_TURN.low, value + NEARLY_A_TURN.high))

    def enclosed(self, found: Iterable[Mapping[str, Enclosure]], at: Numbers) -> list[AdmittedRoot]:
        """Proven roots, each with the condition that it contradicts."""
        roots: list[AdmittedRoot] = []
        for each in found:
            values = {name: 0.0 if interval.has(0) else middle(interval) for name, interval in each.items()}
            roots.append(AdmittedRoot(values | self._in_si(at), self._left(at), self.against(values, at)))
        return roots

    def _sharp(self, found: EnclosedRoots) -> bool:
        """Whether the figures of all that is asked are known; of what comes to nothing only algebra says that it is 0."""
        asked = {each.letter for each in self.record.asked}
        inside = [root[letter] for root in found.roots for letter in asked & root.keys()]
        return not self.by_algebra or all(each.width <= SHARP * abs(middle(each)) for each in inside)

    def _left(self, at: Numbers) -> tuple[tuple[str, float, float], ...]:
        """The laws that only numbers are left of, each with its sides."""
        found: list[tuple[str, float, float]] = []
        for law, relation in zip(self.record.laws, self.equations, strict=True):
            if not names(relation) & set(self.unknowns):
                with suppress(Undefined):
                    left, right = (certified(side, at).value for side in (relation.left, relation.right))
                    found.append((law.name, left, right))
        return tuple(found)

    def admitted(self, found: tuple[SystemRoot, ...], at: Numbers) -> Iterator[AdmittedRoot]:
        """Of the roots those that are real at these numbers, each with the condition that it contradicts."""
        for root in found:
            values = root.at(at)
            if values is not None:
                sides = [(each.law, each.at(at)) for each in root.left]
                left = tuple((law, *both) for law, both in sides if both is not None)
                yield AdmittedRoot(values | self._in_si(at), left, self.against(values, at))

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


def contradictions(root: AdmittedRoot, within: float) -> Iterator[tuple[str, float, float]]:
    """Each law that only numbers are left of and whose sides differ by more than a share of them, with its sides."""
    for law, left, right in root.left:
        if abs(left - right) > within * max(abs(left), abs(right)):
            yield law, left, right


def _polynomial(relation: Relation) -> bool:
    """Whether algebra finds every root: there is no function and no broken power."""
    return not any(calls(relation)) and all(
        (power := constant(node.exponent)) is not None and power.denominator == 1
        for node in walk(relation)
        if isinstance(node, Power)
    )


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
        raise ValueError(
            f"{len(record.laws)} laws for {len(unknowns)} unknowns ({', '.join(unknowns)}){_missing(record, unknowns)}"
        )
    dimensions = _dimensions(record, givens)
    laws = stated([(each.name, each.formula) for each in record.laws], signs(givens), unknowns)
    found = PublishedExercise(record, givens, unknowns, laws, (), dimensions)
    units = {name: found.unit_of(name) for name in (*givens, *unknowns)}
    known = {name: each for name, each in units.items() if each is not None}
    return replace(found, where=tuple(each for text in record.where for each in _condition(text, known)))


def _missing(record: ExerciseRecord, unknowns: tuple[str, ...]) -> str:
    """What may have been left out: none of what is asked for, and a constant of nature sooner than anything else."""
    asked = {each.letter for each in record.asked}
    left = [each for each in unknowns if each not in asked]
    usual = [each for each in left if each in CONSTANTS or each == "g"]
    short = len(unknowns) - len(record.laws)
    missing = left if len(left) <= short else usual[:short]
    if not missing:
        return f"; {short} of {', '.join(left)} must be given" if left else ""
    listed = ", ".join(missing)
    constant = f", or constants: [{', '.join(missing)}]" if set(missing) <= CONSTANTS.keys() else ""
    verb, them = ("is", "it") if len(missing) == 1 else ("are", "them")
    return f"; {listed} {verb} missing: write {them} into given{constant}"


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


def quantities_apart(values: Sequence[float], unit: Unit | None, figures: int = FIGURES) -> tuple[str, ...]:
    """Values in SI as people read them, with as many more figures as it takes to see which differ."""
    figures = figures_apart([each if unit is None else unit.from_si(each) for each in values], figures)
    return tuple(quantity(each, unit, figures) for each in values)


def quantity(value: float, unit: Unit | None, figures: int = FIGURES) -> str:
    """A value in SI as people read it."""
    if unit is None:
        return decimal_text(value, figures)
    return with_unit(decimal_text(unit.from_si(value), figures), unit).replace("\N{NO-BREAK SPACE}", " ")
