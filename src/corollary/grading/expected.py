"""What a key expects of each part, as the answer types judge by it: what takes a replay is left until it is asked for."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from functools import partial

from corollary.answers.evaluation import as_exact
from corollary.answers.expected import (
    Claim,
    Expected,
    FollowThrough,
    NamedLaw,
    Point,
    Quantity,
    Requirement,
    RightOption,
    Values,
)
from corollary.answers.questions import question_of
from corollary.answers.verdict import Verdict
from corollary.derive.solution import AppliedLaw
from corollary.derive.statements import Explain
from corollary.formula.ast import Name
from corollary.formula.ball import RationalPi, Undefined, certified
from corollary.grading.follow_through import consequences
from corollary.grading.key import Key, Truth, named
from corollary.grading.misconceptions import slips_of_input, wrong_formulas, wrong_values
from corollary.grading.replay import replay
from corollary.problem.part import Part
from corollary.problem.problem import Problem
from corollary.problem.sampling import sample

POINTS = 6  # variants at which the lines of a proof are tried


def expected_of(
    key: Key,
    part: Part,
    earlier: Mapping[str, Values] | None = None,
    runs: Mapping[str, Callable[[], Verdict]] | None = None,
) -> Expected:
    """What is right for a part; `earlier` are the student's own values of earlier parts, in SI, `runs` what was run for it."""
    truth = key.truths.get(part.id)
    letter = key.choices.get(part.id)
    return Expected(
        question_of(key.variant.problem, part),
        None if truth is None else _quantity(key, truth, earlier or {}),
        None if letter is None else RightOption(letter, key.solution.choices[part.id].mistakes),
        _requirement(key, part.id) if part.id in key.solution.examples else None,
        _claim(key, part.id) if part.id in key.solution.proofs else None,
        _rubric(key, part.id) if truth is None else (),
        runs or {},
    )


def _quantity(key: Key, truth: Truth, earlier: Mapping[str, Values]) -> Quantity:
    return Quantity(
        truth.values,
        truth.scale,
        truth.tolerance,
        truth.uncertain,
        lambda: key.variant.exact,
        key.find(truth).in_givens,
        partial(domain, key.variant.problem),
        partial(wrong_formulas, key, truth.place),
        partial(_follow_through, key, truth, {}),
        partial(_follow_through, key, truth, earlier),
    )


def _follow_through(key: Key, truth: Truth, earlier: Mapping[str, Values]) -> Iterator[FollowThrough]:
    for each in consequences(key, truth, earlier):
        yield FollowThrough(
            each.values,
            each.earlier,
            partial(wrong_values, key, truth, each),
            partial(slips_of_input, key, truth, each),
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
        partial(lawful_points, key),
    )


def _rubric(key: Key, part: str) -> tuple[str, ...]:
    """What earns credit in a part that a person marks."""
    entries = (entry for entry in key.solution.entries if isinstance(entry, Explain))
    return next((entry.rubric for entry in entries if entry.statement.part == part), ())


def lawful_points(key: Key) -> list[Point]:
    """Givens drawn anew, with everything found for them: points where every law of the derivation holds."""
    solution, points = key.solution, list[Point]()
    for variant in sample(key.variant.problem, POINTS, salt="proof"):
        try:
            values = replay(solution, variant.exact)
        except Undefined:
            continue
        found = {
            name: as_exact(value)
            for find, numbers in zip(solution.unknowns, values, strict=True)
            for name, value in zip(find.names, numbers, strict=True)
        }
        points.append(variant.exact | found)
    return points


def domain(problem: Problem) -> Mapping[str, tuple[float, float]]:
    """Where the problem's letters live: the grid of each given, in SI; one that is fixed is widened by a tenth."""
    box: dict[str, tuple[float, float]] = {}
    for given in problem.givens:
        ends = (
            RationalPi(value * given.unit.factor, given.unit.pi)
            for value in (given.grid.first, given.grid.last)
        )
        low, high = sorted(certified(Name("x"), {"x": end}).value for end in ends)
        if low == high:
            low, high = sorted((0.9 * low, 1.1 * high))
        box[given.symbol] = low, high
    return box
