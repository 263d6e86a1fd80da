"""One record examined: its exercise solved at its numbers, and each published answer held against the laws and what breaks them."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import combinations

from corollary.answers.quantity import Reading, read_quantity
from corollary.answers.tolerance import last_place
from corollary.audit.contractor import NoContractor, periodic_arguments
from corollary.audit.exercise import (
    AdmittedRoot,
    PublishedExercise,
    contradictions,
    exercise_of,
    quantities_apart,
    quantity,
)
from corollary.audit.formula_key import formula_in, function_outcome
from corollary.audit.outcome import AuditedAnswer
from corollary.audit.record import AskedLetter, ExerciseRecord, ForgivenError
from corollary.derive.roots import NoRoot
from corollary.formula.ast import Call, Expr, Name, Relation, names
from corollary.formula.ball import RationalPi, certified
from corollary.formula.enclosure import Enclosure
from corollary.formula.errors import ParseError, Undefined, sentence
from corollary.formula.syntax import author_formula
from corollary.units.dimensional_analysis import dimension_of
from corollary.units.unit import ONE, PURE, UNITS, Dimension, Unit, si_unit
from corollary.verify.printed import ABOUT, EXACTLY, HALF_AN_ORDER, Agreement, as_printed

FIGURES = 4  # of the sides; more where these are the same
ROUNDING = 1e-9  # relative: sides so near are the same


@dataclass(frozen=True, slots=True)
class BrokenLaw:
    """A law by its name, and its two sides as they come out."""

    law: str
    written: tuple[str, str]


def broken_law(
    exercise: PublishedExercise, root: AdmittedRoot, letter: str, published: RationalPi
) -> BrokenLaw | None:
    """The law that breaks, with the published answer for a letter and all else as derived."""
    values = {name: RationalPi(Fraction(value)) for name, value in root.values.items()} | exercise.numbers
    relations = [(law.name, author_formula(law.formula)) for law in exercise.record.laws]
    return most_broken(
        relations, letter, values | {letter: published}, exercise.dimensions, exercise.unknowns
    )


def most_broken(
    relations: Iterable[tuple[str, Expr]],
    letter: str,
    values: Mapping[str, RationalPi],
    dimensions: Mapping[str, Dimension],
    unknowns: Collection[str],
) -> BrokenLaw | None:
    """Of the relations that a letter breaks the one with the fewest other unknowns, which decides it most nearly; of several
    such the one whose sides differ most, as a share of them. None where none is broken."""
    known = {name for name in values if name not in unknowns}
    best: tuple[int, float] | None = None
    found = None
    for law, relation in relations:
        if not isinstance(relation, Relation) or letter not in names(relation):
            continue
        try:
            left, right = (certified(side, values).value for side in (relation.left, relation.right))
        except (Undefined, KeyError):
            continue
        size = max(abs(left), abs(right))
        share = abs(left - right) / size if size else 0.0
        rank = (len(names(relation) - known), -share)
        if share > ROUNDING and (best is None or rank < best):
            best, unit = rank, _unit(relation, dimensions)
            found = BrokenLaw(law, _written(left, right, unit))
    return found


def _written(left: float, right: float, unit: Unit | None) -> tuple[str, str]:
    one, other = quantities_apart((left, right), unit, FIGURES)
    return one, other


def _unit(relation: Relation, dimensions: Mapping[str, Dimension]) -> Unit | None:
    if not names(relation) <= {*dimensions, "pi"}:
        return None
    measured = dimension_of(relation, dimensions)
    return None if isinstance(measured, ParseError) else si_unit(measured)


UNDIRECTED = tuple(UNITS[each].dimension for each in ("kg", "s", "K", "mol", "ohm", "F", "H"))
MOST_TURNED = 10  # letters: of more it is not tried which are turned round together
SAME = 1e-9  # relative


def reversible(exercise: PublishedExercise, root: AdmittedRoot, letter: str) -> bool:
    """Whether a letter's sign is a matter of direction: with the opposite one the laws hold, some others being turned round, too.

    `s = abs(v)` has no minus, whichever direction is positive.
    """
    directed = _directed(exercise)
    if letter not in directed:
        return False
    others = sorted(directed & root.values.keys() - {letter})
    if len(others) > MOST_TURNED:
        return True
    values = {name: RationalPi(Fraction(value)) for name, value in root.values.items()} | exercise.numbers
    for count in range(len(others) + 1):
        for turned in combinations(others, count):
            opposite = {name: RationalPi(-values[name].ratio, values[name].pi) for name in (letter, *turned)}
            if all(_holds(each, values | opposite) for each in exercise.equations):
                return True
    return False


def _directed(exercise: PublishedExercise) -> set[str]:
    """The letters that may have a direction: no mass, time, temperature or resistance, and of plain numbers the angles alone."""
    angles = {name for name, given in exercise.givens.items() if given.unit.pi}
    angles |= {each.letter for each in exercise.record.asked if each.unit is not None and each.unit.pi}
    for equation in exercise.equations:
        for argument in periodic_arguments(equation, [*exercise.unknowns, *exercise.givens]):
            angles |= names(argument)
    dimensions = {name: given.unit.dimension for name, given in exercise.givens.items()}
    dimensions |= dict(exercise.dimensions)
    return {
        name
        for name, dimension in dimensions.items()
        if dimension not in UNDIRECTED and (dimension != ONE or name in angles)
    }


def _holds(equation: Relation, values: Mapping[str, RationalPi]) -> bool:
    try:
        left, right = (certified(side, values).value for side in (equation.left, equation.right))
    except (Undefined, KeyError):
        return False
    return abs(left - right) <= SAME * max(abs(left), abs(right))


MORE_FIGURES = 2  # than the published number has, in what is shown beside it
LEAST_FIGURES, MOST_FIGURES = 4, 12
MOST_OTHERS = 4  # of the roots that go on for ever
UNPROVEN = "no root that the conditions admit was found, and that there is none is not proven; narrow `where`"
TOO_COARSE = (
    "it is rounded more coarsely than its question forgives, which refuses the answer to more figures"
)
CONTRADICTION = (
    0.02  # relative: sides of a law that only givens fix; closer ones differ by how the givens were rounded
)


@dataclass(frozen=True, slots=True)
class PublishedNumber:
    """A published answer that is a number: how it reads, and the unit in which it is compared."""

    text: str
    reading: Reading
    unit: Unit
    figures: int | None

    def agreement(self, value: float) -> Agreement:
        found = as_printed(value, self.text, self.reading, self.unit, self.figures)
        one_figure = (self.figures or self.reading.figures) == 1  # 7 for 6 is no matter of rounding
        return "differs" if found == "last figure" and one_figure else found

    def refuses(self, forgiven: ForgivenError | None, value: float) -> bool:
        """Whether a question with this key refuses what the laws give."""
        unit = self.reading.unit or self.unit
        return forgiven is not None and forgiven.refuses(unit.from_si(value), unit.from_si(float(self.exact)))

    def fits(self, value: float) -> bool:
        return self.agreement(value) in ("agrees", "last figure")

    @property
    def interval(self) -> Enclosure:
        """In SI: all values that it may stand for, and those that differ by one in the last figure."""
        number, unit = float(self.exact), self.reading.unit or self.unit
        if self.text.startswith(ABOUT):
            ends = number * 10**-HALF_AN_ORDER, number * 10**HALF_AN_ORDER
            return Enclosure(min(ends), max(ends))
        number -= float(unit.offset)
        figures = self.figures or self.reading.figures
        away = EXACTLY * abs(number)
        if figures and number:
            least = self.figures or max(1, self.reading.least)
            away = max(1.5 * last_place(number, figures, unit.si), last_place(number, least, unit.si) / 2)
        number += float(unit.offset)
        return Enclosure(number - away, number + away)

    @property
    def exact(self) -> RationalPi:
        """In SI."""
        return RationalPi(*self.reading.si)

    def written(self, value: float) -> str:
        figures = (self.figures or self.reading.figures) + MORE_FIGURES
        return quantity(value, self.reading.unit or self.unit, min(max(LEAST_FIGURES, figures), MOST_FIGURES))


def examine(record: ExerciseRecord, by_algebra: bool = True) -> tuple[AuditedAnswer, ...]:
    """What is found of each published answer of a record that states its laws. It takes as long as the algebra takes."""
    if record.unread:
        return cannot_say(record, record.unread)
    try:
        exercise = replace(exercise_of(record), by_algebra=by_algebra)
    except ValueError as error:
        return cannot_say(record, str(error))
    forgives = record.forgives or (None,) * len(record.asked)
    found = [
        _outcome(exercise, asked, published, forgiven)
        for asked, published, forgiven in zip(record.asked, record.published, forgives, strict=True)
    ]
    return tuple(
        replace(each, why="; ".join(filter(None, (each.why, record.note)))) if record.note else each
        for each in found
    )


def cannot_say(record: ExerciseRecord, why: str) -> tuple[AuditedAnswer, ...]:
    """The same for all that is asked; one outcome even where nothing is known to be asked."""
    asked = [each.letter for each in record.asked] or [""]
    published = list(record.published) or [""]
    published += [""] * (len(asked) - len(published))
    return tuple(
        AuditedAnswer(record, letter, text, "cannot say", why)
        for letter, text in zip(asked, published, strict=False)
    )


def _outcome(
    exercise: PublishedExercise, asked: AskedLetter, published: str, forgiven: ForgivenError | None
) -> AuditedAnswer:
    nothing = AuditedAnswer(exercise.record, asked.letter, published, "cannot say")
    try:
        number = published_number(exercise, asked, published)
        fits = isinstance(number, PublishedNumber) and number.reading.fit != "wrong dimension"
        formula = (
            None if fits else formula_in(exercise, published)
        )  # `8.0 s` is no formula, be s given or not
        if formula is not None:
            return function_outcome(exercise, nothing, formula)
        if isinstance(number, str):
            return replace(nothing, why=number)
        if not fits:
            return replace(
                nothing, finding="wrong", why=number.reading.why, derived=_first(exercise, asked.letter)
            )
        if not exercise.fixed:
            ranges = ", ".join(name for name, given in exercise.givens.items() if not given.fixed)
            return replace(nothing, why=f"{ranges} has a range, and the published answer is one number")
        found = _number_outcome(exercise, nothing, number, forgiven)
    except (NoRoot, ValueError) as error:
        return replace(nothing, why=str(error))
    return (
        found
        if found.finding != "wrong" or found.why == TOO_COARSE
        else _under_conventions(exercise, number, found)
    )


def published_number(
    exercise: PublishedExercise, asked: AskedLetter, published: str
) -> PublishedNumber | str:
    """The published number, or why it cannot be compared."""
    text = published.strip()
    unit = asked.unit or exercise.unit_of(asked.letter)
    typed = text.removeprefix(ABOUT).strip()
    read = read_quantity(typed, unit)
    if isinstance(read, ParseError) and asked.unit is None and unit is not None:
        # Laws do not say whether a rate counts turns or radians: its unit means what it means in `given:`.
        as_given = read_quantity(typed, None)
        if isinstance(as_given, Reading) and as_given.unit is not None and as_given.unit.measures(unit):
            read = as_given
    if isinstance(read, ParseError):
        return f"the published answer {published!r} cannot be read: {sentence(read)}"
    if read.unit is None and asked.unit is None and read.fit == "unit missing":
        return f"the published answer {published!r} has no unit; write `asked: {asked.letter} in …`"
    if unit is None and read.unit is None:
        return f"the laws leave open what {asked.letter} measures; write `asked: {asked.letter} in …`"
    return PublishedNumber(text, read, unit or PURE, exercise.record.figures)


def _number_outcome(
    exercise: PublishedExercise,
    nothing: AuditedAnswer,
    number: PublishedNumber,
    forgiven: ForgivenError | None,
) -> AuditedAnswer:
    letter = nothing.asked
    solved = exercise.solved(exercise.numbers)
    stated = [root for root in solved.roots if not root.against]
    admitted = _keeping_all(stated)
    if not solved.proven and not any(number.fits(root.values[letter]) for root in admitted):
        near = _put_in(exercise, number, letter)
        if near is None and exercise.square:
            return replace(nothing, why=UNPROVEN)
        admitted = [*(near or ()), *(admitted or _elsewhere(exercise, number, letter))]
        if not admitted and not stated:
            return replace(nothing, why=UNPROVEN)
    if not admitted and stated:
        law, left, right = next(contradictions(stated[0], CONTRADICTION))
        displayed = quantities_apart((left, right), None)
        why = f"the givens contradict each other: {law}"
        return replace(nothing, finding="impossible", why=why, violates=law, sides=displayed)
    if not admitted:
        why = _why_impossible(exercise, number, letter, solved.roots)
        return replace(nothing, finding="impossible", why=why)
    distinct = _distinct(admitted, letter)
    judged = [(number.agreement(root.values[letter]), root) for root in distinct]
    best = next((each for name in ("agrees", "last figure") for each in judged if each[0] == name), judged[0])
    agreement, root = best
    others = tuple(number.written(each.values[letter]) for _, each in judged if each is not root)
    values = {
        name: quantity(root.values[name], exercise.unit_of(name), LEAST_FIGURES) for name in exercise.unknowns
    }
    found = replace(nothing, derived=number.written(root.values[letter]), others=others, values=values)
    if agreement in ("agrees", "last figure") and number.refuses(forgiven, root.values[letter]):
        return replace(found, finding="wrong", why=TOO_COARSE)
    if agreement == "agrees" and others:
        listed = ", ".join(others)
        return replace(found, finding="not unique", why=f"the statement admits {listed} as well")
    if agreement == "agrees":
        return replace(found, finding="agrees")
    if agreement == "last figure":
        return replace(found, finding="last figure", why="it differs by one in the last figure")
    broken = broken_law(exercise, root, letter, number.exact)
    return replace(
        found,
        finding="wrong",
        why="it is of another order of magnitude" if agreement == "order" else "",
        violates=broken.law if broken else "",
        sides=broken.written if broken else None,
    )


def _under_conventions(
    exercise: PublishedExercise, number: PublishedNumber, found: AuditedAnswer
) -> AuditedAnswer:
    """The finding, or *ambiguous* where a convention that the statement leaves open gives the published answer."""
    letter = found.asked
    for other, words in exercise.otherwise():
        if any(_agrees(number, root, letter) for root in _keeping_all(other.roots(other.numbers))):
            why = f"it is right with {words}, which the statement does not say"
            return replace(found, finding="ambiguous", why=why, violates="", sides=None)
    roots = [root for root in exercise.roots(exercise.numbers) if not root.against]
    for root in _keeping_all(roots):
        turned = dict(root.values) | {letter: -root.values[letter]}
        if number.agreement(turned[letter]) == "agrees" and not exercise.record.directions:
            unknowns = {name: turned[name] for name in exercise.unknowns}
            admitted = not exercise.against(unknowns, exercise.numbers)
            if admitted and reversible(exercise, root, letter):
                why = "only its sign differs, and no convention says which direction is positive"
                return replace(found, finding="ambiguous", why=why, violates="", sides=None)
        if _inverses(exercise, letter):
            for turn in (-math.tau, math.tau):
                values = {name: root.values[name] for name in exercise.unknowns}
                values[letter] += turn
                if number.fits(values[letter]) and not exercise.against(values, exercise.numbers):
                    why = "it is a whole turn further, the same direction; `where` can say which is meant"
                    return replace(found, finding="ambiguous", why=why, violates="", sides=None)
        bare_angle = number.unit.dimension == ONE and number.reading.unit is None and number.unit.bare
        if (
            bare_angle
            and replace(number, unit=UNITS["deg"], reading=_in_degrees(number.reading)).agreement(
                root.values[letter]
            )
            == "agrees"
        ):
            why = "it is right in degrees, and has no unit"
            return replace(found, finding="ambiguous", why=why, violates="", sides=None)
    return found


def _keeping_all(roots: Sequence[AdmittedRoot]) -> list[AdmittedRoot]:
    """Of more laws than unknowns some are left over: what contradicts one of them is no root."""
    return [root for root in roots if not any(contradictions(root, CONTRADICTION))]


def _in_degrees(reading: Reading) -> Reading:
    return replace(reading, unit=UNITS["deg"], si=UNITS["deg"].to_si(reading.value))


def _agrees(number: PublishedNumber, root: AdmittedRoot, letter: str) -> bool:
    return not root.against and number.agreement(root.values[letter]) == "agrees"


def _distinct(roots: Sequence[AdmittedRoot], letter: str) -> list[AdmittedRoot]:
    """One root for each value of the letter: the others differ in what nobody asks for."""
    found: dict[str, AdmittedRoot] = {}
    for root in roots:
        found.setdefault(f"{root.values[letter]:.9e}", root)
    return list(found.values())


def _put_in(exercise: PublishedExercise, number: PublishedNumber, letter: str) -> list[AdmittedRoot] | None:
    """The proven roots at the published number, as it is printed; None where it is proven neither that there are, nor that not."""
    try:
        found = exercise.near(letter, number.interval)
    except NoContractor:
        return None
    roots = [root for root in exercise.enclosed(found.roots, exercise.numbers) if not root.against]
    return roots if roots or found.none else None


def _elsewhere(exercise: PublishedExercise, number: PublishedNumber, letter: str) -> list[AdmittedRoot]:
    """The nearest of the proven roots that the conditions admit, where there may be any number of them."""
    try:
        found = exercise.around(letter, float(number.exact))
    except NoContractor:
        return []
    roots = [root for root in exercise.enclosed(found.roots, exercise.numbers) if not root.against]
    published = float(number.exact)
    return sorted(roots, key=lambda root: abs(root.values[letter] - published))[:MOST_OTHERS]


INVERSES = {
    "atan": ("tan", "-90 deg and 90 deg"),
    "asin": ("sin", "-90 deg and 90 deg"),
    "acos": ("cos", "0 and 180 deg"),
    "atan2": ("tan", "-180 deg and 180 deg"),
}
"""Functions of which a law may state an angle outright: those of the angle itself, and where their values lie."""


def _inverses(exercise: PublishedExercise, letter: str) -> list[str]:
    """The functions that state a letter outright, as in `b = atan(y/x)`."""
    found: list[str] = []
    for each in exercise.equations:
        for side, other in ((each.left, each.right), (each.right, each.left)):
            if side == Name(letter) and isinstance(other, Call) and other.function in INVERSES:
                found.append(other.function)
    return found


def _why_impossible(
    exercise: PublishedExercise, number: PublishedNumber, letter: str, roots: Sequence[AdmittedRoot]
) -> str:
    if not roots:
        laws = ", ".join(each.name for each in exercise.record.laws)
        wording = ", ".join(exercise.record.where)
        return f"no real numbers satisfy: {laws}" + (f", where {wording}" if wording else "")
    seen = "; ".join(
        f"{letter} = {number.written(root.values[letter])} against {root.against}" for root in roots
    )
    why = f"no root is as the wording has it: {seen}"
    for function in _inverses(exercise, letter)[:1]:
        of, between = INVERSES[function]
        why += f"; {function} lies between {between}, so state {of}({letter}) = … instead"
    return why


def _first(exercise: PublishedExercise, letter: str) -> str:
    roots = exercise.roots(exercise.numbers) if exercise.fixed else []
    roots = _keeping_all([root for root in roots if not root.against])
    return quantity(roots[0].values[letter], exercise.unit_of(letter), LEAST_FIGURES) if roots else ""
