"""Mistakes that give a wrong published answer: those that the record lists first, then those that everybody makes."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import replace
from fractions import Fraction
from itertools import combinations, islice
from math import isclose

from corollary.audit.examine import PublishedNumber, published_number
from corollary.audit.exercise import PublishedExercise, exercise_of, signs
from corollary.audit.formula_key import APART, box_of, formula_in, points_of
from corollary.audit.outcome import AuditedAnswer
from corollary.audit.record import ExerciseRecord, LawText, StatedGiven, WrongLaw
from corollary.derive.roots import NoRoot
from corollary.derive.statements import Exchange, Mistake
from corollary.derive.system import in_letters, stated
from corollary.formula.ast import Expr, Name, Number, Power, Product, Quotient, Relation, names, walk
from corollary.formula.ball import certified
from corollary.formula.errors import Undefined
from corollary.formula.plain_text import text
from corollary.formula.rational_pi import RationalPi
from corollary.formula.syntax import author_formula
from corollary.misconceptions import (
    diameter_for_radius,
    half_forgotten,
    left_out,
    not_squared,
    radius_for_diameter,
    sign_reversed,
    sine_for_cosine,
    swapped,
    upside_down,
)
from corollary.units.unit import UNITS, show, si_unit

ENOUGH = 2  # figures of a published number: one figure is met by chance
MOST_TRIED = 80
TRIED_AT = (
    2  # points at which a formula is held against what a mistake gives: two functions meet at one by chance
)
ONE, TWO = Number(Fraction(1)), Number(Fraction(2))


def mistake_in(outcome: AuditedAnswer) -> tuple[str, str]:
    """What was done wrong where that gives the published answer, and the law concerned; "" where no mistake known does."""
    exercise = exercise_of(outcome.record)
    asked = next(each for each in outcome.record.asked if each.letter == outcome.asked)
    number = published_number(exercise, asked, outcome.published)
    formula = formula_in(exercise, outcome.published) if outcome.counterexample else None
    if formula is not None:
        points = points_of(box_of(exercise, formula), exercise)[:TRIED_AT]
        return _first(exercise, lambda changed: _gives_formula(changed, outcome.asked, formula, points))
    if isinstance(number, str) or not exercise.fixed:
        return "", ""
    if (number.figures or number.reading.figures or ENOUGH) < ENOUGH:
        return "", ""
    return _first(exercise, lambda changed: _gives_number(changed, outcome.asked, number))


def _first(exercise: PublishedExercise, gives: Callable[[PublishedExercise], bool]) -> tuple[str, str]:
    for says, law, changed in islice(_mistaken(exercise), MOST_TRIED):
        try:
            if gives(changed):
                return says, law
        except (NoRoot, ValueError):  # what somebody mistakes can be solved by nobody
            continue
    return "", ""


def _gives_number(changed: PublishedExercise, letter: str, number: PublishedNumber) -> bool:
    roots = changed.roots(changed.numbers)
    return any(number.agreement(root.values[letter]) == "agrees" for root in roots)


def _gives_formula(
    changed: PublishedExercise, letter: str, formula: Expr, points: Sequence[Mapping[str, RationalPi]]
) -> bool:
    """Whether a formula without unknowns is at some points what the mistake gives there."""
    if names(formula) & set(changed.unknowns):
        return False
    for point in points:
        try:
            theirs = certified(formula, point).value
        except Undefined:
            return False
        if not any(isclose(theirs, root.values[letter], rel_tol=APART) for root in changed.roots(point)):
            return False
    return bool(points)


def _mistaken(exercise: PublishedExercise) -> Iterator[tuple[str, str, PublishedExercise]]:
    """What is wrong, the law concerned ("": a unit), and the exercise with it."""
    for each in exercise.record.mistakes:
        with suppress(ValueError):
            law, laws = _exchanged(exercise.record, each)
            yield each.says, law, _with_laws(exercise, laws)
    for says, changed in _units_mistaken(exercise):
        yield says, "", changed
    for law in exercise.record.laws:
        for says, formula in _bent(exercise, law):
            laws = tuple(
                replace(law, formula=formula) if each is law else each for each in exercise.record.laws
            )
            with suppress(ValueError):
                yield f"{says} (in {law.name})", law.name, _with_laws(exercise, laws)


def _with_laws(exercise: PublishedExercise, laws: tuple[LawText, ...]) -> PublishedExercise:
    """The same exercise by other laws, whose sides need not measure the same. Raises ValueError."""
    texts = [(each.name, each.formula) for each in laws]
    record = replace(exercise.record, laws=laws)
    return replace(exercise, record=record, laws=stated(texts, signs(exercise.givens), exercise.unknowns))


def _exchanged(record: ExerciseRecord, wrong: WrongLaw) -> tuple[str, tuple[LawText, ...]]:
    """The name of a law and all laws with it replaced: the one named, the only one, or the one with the same left side. Raises ValueError."""
    places = [place for place, law in enumerate(record.laws) if law.name == wrong.instead]
    if not wrong.instead:
        left = _sides(wrong.formula).left
        places = [place for place, law in enumerate(record.laws) if _sides(law.formula).left == left]
        places = [0] if len(record.laws) == 1 else places
    if len(places) != 1:
        raise ValueError(f"the mistake {wrong.says!r} does not name the law it replaces: write instead:")
    changed = LawText(record.laws[places[0]].name, wrong.formula, wrong.line)
    return changed.name, (*record.laws[: places[0]], changed, *record.laws[places[0] + 1 :])


def _units_mistaken(exercise: PublishedExercise) -> Iterator[tuple[str, PublishedExercise]]:
    for name, given in exercise.givens.items():
        if given.unit.pi:
            as_number = replace(given, unit=UNITS["rad"])
            yield f"degrees were taken for radians ({name})", _with_given(exercise, name, as_number)
        elif not given.unit.bare:
            unconverted = replace(given, unit=si_unit(given.unit.dimension))
            yield (
                f"{name} was not converted from {show(given.unit)}",
                _with_given(exercise, name, unconverted),
            )


def _with_given(exercise: PublishedExercise, name: str, given: StatedGiven) -> PublishedExercise:
    return replace(exercise, givens={**exercise.givens, name: given})


def _bent(exercise: PublishedExercise, law: LawText) -> Iterator[tuple[str, str]]:
    """The usual misconceptions that the law allows for, by what was done, with the wrong law."""
    relation = _sides(law.formula)
    letters = sorted(names(relation) - {"pi"})
    given = [each for each in letters if each in exercise.givens]
    squares = [each for each in letters if Power(Name(each), TWO) in set(walk(relation))]
    bends: list[tuple[str, Callable[[], Mistake[Exchange]]]] = [
        ("sine and cosine are interchanged", lambda: sine_for_cosine(law.formula))
    ]
    if _has_half(relation.right):
        bends.append(("the factor one half is missing", lambda: half_forgotten(law.formula)))
    bends += [(f"{each} is not squared", _call(not_squared, law.formula, each)) for each in squares]
    bends += [
        (f"the sign of {each} is reversed", _call(sign_reversed, law.formula, each, each)) for each in letters
    ]
    bends += [(f"{each} is left out", _call(left_out, law.formula, each, each)) for each in letters]
    for each in (name for name in given if name[0] in "rRdD"):
        bends.append(
            (f"the diameter stands for the radius {each}", _call(diameter_for_radius, law.formula, each))
        )
        bends.append(
            (f"the radius stands for the diameter {each}", _call(radius_for_diameter, law.formula, each))
        )
    alike = [
        pair
        for pair in combinations(given, 2)
        if exercise.givens[pair[0]].unit.dimension == exercise.givens[pair[1]].unit.dimension
    ]
    bends += [
        (f"{one} and {two} are interchanged", _call(swapped, law.formula, one, two, "")) for one, two in alike
    ]
    if isinstance(relation.right, Quotient):
        bends.append(("the fraction is upside down", lambda: upside_down(law.formula)))
    with in_letters(signs(exercise.givens), exercise.unknowns):
        for says, bend in bends:
            with suppress(ValueError):  # the law has nothing of the kind
                (wrong,) = bend().rule.laws
                yield says, text(wrong.textbook)


def _has_half(tree: Expr) -> bool:
    return any(
        (isinstance(node, Quotient) and node.bottom == TWO)
        or (isinstance(node, Product) and Quotient(ONE, TWO) in node.factors)
        for node in walk(tree)
    )


def _call(bend: Callable[..., Mistake[Exchange]], *arguments: str) -> Callable[[], Mistake[Exchange]]:
    return lambda: bend(*arguments)


def _sides(formula: str) -> Relation:
    relation = author_formula(formula)
    assert isinstance(relation, Relation)
    return relation
