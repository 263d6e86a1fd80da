"""Expectations of a key for each part, as the answer types judge by them; replays are left until asked for."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from functools import partial

from corollary.answers.evaluation import as_exact, number
from corollary.answers.expected import (
    Claim,
    Expected,
    NamedLaw,
    Point,
    Quantity,
    Requirement,
    RightOption,
    Values,
)
from corollary.answers.questions import question_in
from corollary.answers.verdict import Verdict
from corollary.derive.solution import AppliedLaw
from corollary.derive.statements import Explain
from corollary.formula.ast import Name, Relation
from corollary.formula.ball import RationalPi, Undefined, certified
from corollary.grading.follow_through import AsWritten, consequences
from corollary.grading.forces_on_body import free_body
from corollary.grading.key import Key, Truth, named
from corollary.grading.mistakes import overlooked, wrong_formulas
from corollary.grading.replay import replay
from corollary.grading.rounded_by_hand import explained_by_rounding
from corollary.problem.given import Given
from corollary.problem.part import Part
from corollary.problem.problem import Problem
from corollary.problem.sampling import sample
from corollary.units.unit import Dimension

POINTS = 6  # variants at which the lines of a proof are tried


def expected_of(
    key: Key,
    part: Part,
    earlier: Mapping[str, Values] | None = None,
    runs: Mapping[str, Callable[[], Verdict]] | None = None,
    written: Mapping[str, AsWritten] | None = None,
) -> Expected:
    """What is right for a part; `earlier` are the student's own values of earlier parts, in SI, and how they were `written`; `runs`
    what was run for it."""
    truth = key.truths.get(part.id)
    letter = key.choices.get(part.id)
    return Expected(
        question_in(replace(key.variant, problem=replace(key.variant.problem, renamed=())), part),
        None if truth is None else _quantity(key, truth, earlier or {}, written),
        None if letter is None else RightOption(letter, overlooked(key, part)),
        _requirement(key, part.id) if part.id in key.solution.examples else None,
        _claim(key, part.id) if part.id in key.solution.proofs else None,
        rubric=rubric_of(key, part.id) if truth is None else (),
        runs=runs or {},
        free_body=free_body(key.solution.forces[part.id], key.variant)
        if part.id in key.solution.forces
        else None,
    )


def _quantity(
    key: Key, truth: Truth, earlier: Mapping[str, Values], written: Mapping[str, AsWritten] | None
) -> Quantity:
    return Quantity(
        truth.values,
        truth.scale,
        truth.tolerance,
        truth.uncertain,
        lambda: key.variant.exact,
        key.find(truth).in_givens,
        partial(domain, key.variant.problem),
        partial(wrong_formulas, key, truth.place),
        partial(consequences, key, truth, {}),
        partial(consequences, key, truth, earlier, written),
        truth.scales,
        truth.residue,
        truth.counted,
        truth.signed,
        explained_by_rounding=partial(explained_by_rounding, key, truth),
    )


def _requirement(key: Key, part: str) -> Requirement:
    example = key.solution.examples[part]
    known = key.variant.exact | named(key.solution, list(key.values))
    return Requirement(example.unknowns, tuple(map(_law, example.laws)), known, example.apart, example.scale)


def _law(law: AppliedLaw) -> NamedLaw:
    return NamedLaw(law.name, law.here)


def _claim(key: Key, part: str) -> Claim:
    proof = key.solution.proofs[part]
    return Claim(
        tuple(equation for law in proof.laws for equation in law.here),
        proof.target.here[0],
        tuple((law.here[0], mistake.text) for mistake in proof.mistakes for law in mistake.rule),
        partial(lawful_points, key, [equation for law in proof.given for equation in law.here]),
        tuple(equation for law in proof.given for equation in law.here),
        partial(domain, key.variant.problem),
        proof.rates,
    )


def rubric_of(key: Key, part: str) -> tuple[str, ...]:
    """What earns credit in a part that a person marks."""
    entries = (entry for entry in key.solution.entries if isinstance(entry, Explain))
    return next((entry.rubric for entry in entries if entry.statement.part == part), ())


def lawful_points(key: Key, given: Sequence[Relation] = ()) -> list[Point]:
    """Givens drawn anew, with everything found for them: points where every law of the derivation holds.

    What is given besides, such as `mB = mA`, sets the letter on its left, where no step finds it.
    """
    solution, points = key.solution, list[Point]()
    found_in_steps = {name for find in solution.unknowns for name in find.names}
    for place, variant in enumerate(sample(key.variant.problem, POINTS, salt="proof")):
        drawn = {
            given.symbol: _off_the_grid(given, variant.exact[given.symbol], 10 * place + 1 + which)
            for which, given in enumerate(key.variant.problem.givens)
        }
        try:
            for equation in given:
                if isinstance(equation.left, Name) and equation.left.name not in found_in_steps:
                    drawn[equation.left.name] = as_exact(number(equation.right, drawn))
            values = replay(solution, drawn)
        except Undefined:
            continue
        found = {
            name: as_exact(value)
            for find, numbers in zip(solution.unknowns, values, strict=True)
            for name, value in zip(find.names, numbers, strict=True)
        }
        points.append(drawn | found)
    return points


def _off_the_grid(given: Given, value: RationalPi, place: int) -> RationalPi:
    """A little smaller, each by another share, so that no two givens are equal by chance; a count stays what it is."""
    counted = given.unit.dimension == Dimension() and given.grid.step.denominator == 1
    return value if counted else RationalPi(value.ratio * (1 - Fraction(place, 100_003)), value.pi)


def domain(problem: Problem) -> Mapping[str, tuple[float, float]]:
    """Where the problem's letters live: the grid of each given, in SI; one that is fixed is widened by a tenth; the domain of each
    variable."""
    box: dict[str, tuple[float, float]] = {}
    for given in problem.givens:
        ends = (RationalPi(*given.unit.to_si(value)) for value in (given.grid.first, given.grid.last))
        low, high = sorted(certified(Name("x"), {"x": end}).value for end in ends)
        if low == high:
            low, high = sorted((0.9 * low, 1.1 * high))
        box[given.symbol] = low, high
    return box | {each.symbol: each.ends for each in problem.variables}
