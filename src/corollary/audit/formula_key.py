"""A published formula held against the laws as a function, for all numbers of the ranges."""

from __future__ import annotations

import random
from collections.abc import Mapping
from dataclasses import replace
from fractions import Fraction

from corollary.answers.equality import Different, Equal, Undecided, compare, hint
from corollary.audit.exercise import PublishedExercise, exact, exercise_of, quantities_apart, quantity
from corollary.audit.outcome import AuditedAnswer
from corollary.audit.record import StatedGiven
from corollary.derive.roots import NoRoot
from corollary.derive.system import SystemRoot, system_roots
from corollary.formula.arithmetics import as_formula
from corollary.formula.ast import Expr, Relation, names, substitute
from corollary.formula.ball import certified
from corollary.formula.errors import ParseError, Undefined
from corollary.formula.plain_text import text
from corollary.formula.rational_pi import RationalPi
from corollary.formula.syntax import author_formula, parse
from corollary.polynomials.polynomial import TooLarge
from corollary.polynomials.translate import Translation
from corollary.units.dimensional_analysis import dimension_of
from corollary.units.unit import PURE, show, si_unit


def identical(one: Expr, other: Expr, domain: Mapping[str, tuple[float, float]]) -> bool | None:
    """True: the same wherever both have values. False: quotients of polynomials, and not the same. None: not decided this way.

    `domain` has bounds of the letters in SI, by which the root of a square is what was squared. pi counts as a letter, which
    is right, for no polynomial with fractions vanishes at it.
    """
    bounds = {name: (Fraction(low), Fraction(high)) for name, (low, high) in domain.items()}
    try:
        translation = Translation((one, other), bounds)
        gap = translation.fraction(one) - translation.fraction(other)
    except (TooLarge, Undefined, KeyError):
        return None
    if gap.top.is_zero():
        return True
    return None if translation.meanings else False


LONGEST = 200  # characters that still tell a reader something


def derived_formula(outcome: AuditedAnswer) -> str:
    """The formula of the root that the outcome was compared with; "" where none is found, or it is too long to be read."""
    exercise = exercise_of(outcome.record)
    try:
        roots = system_roots(exercise.laws, exercise.unknowns)
    except NoRoot:
        return ""
    for root in roots:
        values = root.at(exercise.numbers)
        displayed = {
            name: quantity(value, exercise.unit_of(name), 4) for name, value in (values or {}).items()
        }
        tree = root.formula(outcome.asked) if displayed == outcome.values else None
        if tree is not None and len(written := text(tree)) <= LONGEST:
            return written
    return ""


POINTS = 24  # of the box: at them is seen which roots the wording admits, and where a formula fails
ANYWHERE = (Fraction(1, 10), Fraction(10))  # in the given's unit, where only that is known
ANY_ANGLE = (Fraction(1, 20), Fraction(3, 2))  # rad
TWICE = 2  # a number that stands for any is varied from its half to its double
APART = 1e-12  # relative: values of a formula and a root that differ by more than doubles are rounded


def formula_in(exercise: PublishedExercise, published: str) -> Expr | None:
    """The published answer as a formula in letters of the exercise; None where it is a number or cannot be read as one."""
    letters = {*exercise.givens, *exercise.unknowns}
    written = published.strip()
    for side in (written, written.partition("=")[2]):
        try:
            tree = author_formula(side, letters)
        except ValueError:
            tree = parse(side, letters)
        if not isinstance(tree, ParseError | Relation) and names(tree) - {"pi"}:
            return tree
    return None


def function_outcome(exercise: PublishedExercise, nothing: AuditedAnswer, formula: Expr) -> AuditedAnswer:
    """What is found of a published formula. Raises NoRoot where the laws give none to compare with."""
    letter = nothing.asked
    if letter in names(formula):
        return replace(nothing, why=f"the published formula for {letter} has {letter} in it")
    roots = system_roots(exercise.laws, exercise.unknowns)
    box = box_of(exercise, formula)
    everywhere = points_of(box, exercise)
    points = [point for point in everywhere if any(_admitted(exercise, root, point) for root in roots)]
    if not points:
        return replace(
            nothing,
            finding="impossible",
            why="nowhere in the ranges is there a real root as the wording has it",
        )
    candidates = [root for root in roots if any(_admitted(exercise, root, point) for point in points)]
    numbers = {
        name: exact_tree(exercise.givens[name]) for name, (low, high) in box.items() if low == high
    }  # put in exactly: at the nearest double to pi/4 a sine is not what it is there
    derived = {id(root): _with(root.formula(letter), numbers) for root in candidates}
    if None in derived.values():
        return replace(
            nothing,
            why=f"{letter} has no formula to compare with: the laws give a root of a cubic or the like",
        )
    displayed = {id(root): text(tree) for root in candidates if (tree := root.formula(letter)) is not None}
    domain = {name: (min(bounds), max(bounds)) for name, bounds in _si(box, exercise).items()}
    matching, undecided, way = None, "", "points"
    difference: Different | None = None
    others_proven: list[bool] = []
    for root in candidates:
        theirs, mine = substitute(_in_givens(formula, root, exercise), numbers), derived[id(root)]
        assert mine is not None
        same = identical(theirs, mine, domain)
        seen = Equal() if same else compare(theirs, mine, domain)
        if same or (same is None and isinstance(seen, Equal)):
            matching, way = root, "algebra" if same else "points"
            break
        others_proven.append(same is False)
        match seen:
            case Different():
                difference = seen
            case Undecided(why):
                undecided = why
            case Equal():
                pass
    others = tuple(dict.fromkeys(displayed[id(root)] for root in candidates if root is not matching))
    if matching is not None:
        rivals = _rivals(exercise, matching, candidates, points, letter)
        found = replace(
            nothing,
            finding="agrees",
            derived=displayed[id(matching)],
            formula=displayed[id(matching)],
            compared=way,
        )
        if rivals:
            why = f"the statement admits {', '.join(displayed[id(each)] for each in rivals)} as well"
            return replace(found, finding="not unique", why=why, others=others)
        return replace(found, why=_nowhere(exercise, everywhere, points))
    found = replace(
        nothing, derived=displayed[id(candidates[0])], formula=displayed[id(candidates[0])], others=others[1:]
    )
    if all(others_proven):
        found = replace(found, compared="algebra")
    failing = _counterexample(exercise, formula, candidates, points, letter)
    if failing is None and found.compared:
        return replace(
            found, finding="wrong", why="the two are not the same formula, though no double tells them apart"
        )
    if failing is None:
        return replace(
            found, why=undecided or "the formulas could not be told apart, nor shown to be the same"
        )
    why = _misfit(exercise, formula, derived[id(candidates[0])]) or (hint(difference) if difference else "")
    return replace(found, finding="wrong", counterexample=failing, why=why)


def _with(tree: Expr | None, numbers: Mapping[str, Expr]) -> Expr | None:
    return None if tree is None else substitute(tree, numbers)


def exact_tree(given: StatedGiven) -> Expr:
    """A given with one value, in SI, as a formula without letters."""
    return as_formula(exact(given))


def _nowhere(
    exercise: PublishedExercise,
    everywhere: list[dict[str, RationalPi]],
    admitted: list[dict[str, RationalPi]],
) -> str:
    """That there are numbers in the ranges for which the statement has no answer, and such numbers; "" where none was met."""
    failing = next((point for point in everywhere if point not in admitted), None)
    if failing is None or any(given.low is None for given in exercise.givens.values()):
        return ""  # where a letter may be anything, the ranges are not the exercise's
    numbers = ", ".join(
        f"{name} = {_as_given(exercise.givens[name], value)}" for name, value in failing.items()
    )
    return f"a part of the ranges admits no answer: {numbers}"


def box_of(exercise: PublishedExercise, formula: Expr) -> dict[str, tuple[Fraction, Fraction]]:
    """For each given its least and largest value, in its own unit; a number that the formula has a letter for may be any like it."""
    named = {each.symbol for each in exercise.record.given} & names(formula)
    return {name: _range(given, name in named) for name, given in exercise.givens.items()}


def _range(given: StatedGiven, varied: bool) -> tuple[Fraction, Fraction]:
    if given.low is None or given.high is None:
        angle = given.unit.dimension == PURE.dimension and given.unit.pi
        return (ANY_ANGLE[0] * 57, ANY_ANGLE[1] * 57) if angle else ANYWHERE
    if given.fixed and varied:
        return (
            (given.low / TWICE, given.low * TWICE)
            if given.low > 0
            else (given.low * TWICE, given.low / TWICE)
        )
    return given.low, given.high


def points_of(
    box: Mapping[str, tuple[Fraction, Fraction]], exercise: PublishedExercise
) -> list[dict[str, RationalPi]]:
    """Points of the box: its middle, and others drawn by the record's id, in SI and exactly."""
    draw = random.Random(exercise.record.id)
    shares = [{name: Fraction(1, 2) for name in box}]
    shares += [{name: Fraction(draw.randint(0, 1000), 1000) for name in box} for _ in range(POINTS - 1)]
    return [
        {
            name: exact(replace(exercise.givens[name], low=low + (high - low) * share[name], high=None))
            for name, (low, high) in box.items()
        }
        for share in shares
    ]


def _si(
    box: Mapping[str, tuple[Fraction, Fraction]], exercise: PublishedExercise
) -> dict[str, tuple[float, float]]:
    return {
        name: (quantity_si(exercise.givens[name], low), quantity_si(exercise.givens[name], high))
        for name, (low, high) in box.items()
    }


def quantity_si(given: StatedGiven, number: Fraction) -> float:
    """A number of a given's unit in SI."""
    return float(number) * given.unit.si + float(given.unit.offset)


def _admitted(exercise: PublishedExercise, root: SystemRoot, point: Mapping[str, RationalPi]) -> bool:
    return any(not each.against for each in exercise.admitted((root,), point))


def _in_givens(formula: Expr, root: SystemRoot, exercise: PublishedExercise) -> Expr:
    """The formula with what the root says in place of other unknowns. Raises NoRoot where that is no formula."""
    inside = names(formula) & set(exercise.unknowns)
    meaning: dict[str, Expr] = {}
    for name in inside:
        tree = root.formula(name)
        if tree is None:
            raise NoRoot(f"the published formula uses {name}, for which the laws give no formula")
        meaning[name] = tree
    return substitute(formula, meaning)


def _rivals(
    exercise: PublishedExercise,
    matching: SystemRoot,
    candidates: list[SystemRoot],
    points: list[dict[str, RationalPi]],
    letter: str,
) -> list[SystemRoot]:
    """The other roots that somewhere are admitted together with the one published, and differ from it there."""
    found: list[SystemRoot] = []
    for other in candidates:
        for point in points if other is not matching else []:
            if not (_admitted(exercise, other, point) and _admitted(exercise, matching, point)):
                continue
            one, two = matching.at(point), other.at(point)
            if one is not None and two is not None and _differ(one[letter], two[letter]):
                found.append(other)
                break
    return found


def _counterexample(
    exercise: PublishedExercise,
    formula: Expr,
    candidates: list[SystemRoot],
    points: list[dict[str, RationalPi]],
    letter: str,
) -> dict[str, str] | None:
    """Numbers of the box at which the formula gives none of the admitted roots: the first found."""
    for point in points:
        roots = [root.at(point) for root in candidates if _admitted(exercise, root, point)]
        values = [each[letter] for each in roots if each is not None]
        if not values:
            continue
        theirs = {_value(_in_givens(formula, root, exercise), point) for root in candidates}
        if not any(each is not None and not _differ(each, value) for each in theirs for value in values):
            unit = exercise.unit_of(letter)
            given = {name: _as_given(exercise.givens[name], value) for name, value in point.items()}
            published = next((each for each in theirs if each is not None), None)
            if published is None:
                return given | {"published": "no value", "derived": quantity(values[0], unit)}
            theirs_there, ours = quantities_apart((published, values[0]), unit)
            return given | {"published": theirs_there, "derived": ours}
    return None


def _value(formula: Expr, point: Mapping[str, RationalPi]) -> float | None:
    try:
        return certified(formula, point).value
    except Undefined:
        return None


def _differ(one: float, other: float) -> bool:
    return abs(one - other) > APART * max(abs(one), abs(other))


def _as_given(given: StatedGiven, value: RationalPi) -> str:
    number = (value.ratio - given.unit.offset) / given.unit.factor
    return replace(given, low=number, high=number).text


def _misfit(exercise: PublishedExercise, formula: Expr, derived: Expr | None) -> str:
    """That the published formula measures something else, or cannot measure anything."""
    measured = dict(exercise.dimensions)
    if derived is None or not names(formula) | names(derived) <= {*measured, "pi"}:
        return ""
    theirs, mine = dimension_of(formula, measured), dimension_of(derived, measured)
    if isinstance(theirs, ParseError):
        return theirs.why
    if isinstance(mine, ParseError) or theirs == mine:
        return ""
    return f"it is in {show(si_unit(theirs)) or 'plain numbers'}, not in {show(si_unit(mine)) or 'plain numbers'}"
