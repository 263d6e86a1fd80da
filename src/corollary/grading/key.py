"""The key of a variant: every answer with certified digits, its tolerance, and what mistakes and earlier slips would give."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction

from corollary.answers.evaluation import BITS, as_exact, finite_double, number
from corollary.answers.expected import Values
from corollary.answers.tolerance import ROUNDING_NOISE, within
from corollary.derive.numbered_list import solution_for
from corollary.derive.solution import ClosedForms, Rule, SceneOutcome, Solution, Unknown, Ways, once
from corollary.formula.arithmetics import exactly
from corollary.formula.ast import (
    ONE,
    Call,
    Expr,
    Name,
    Negative,
    Number,
    Power,
    Product,
    Quotient,
    Sum,
    children,
    map_children,
    names,
)
from corollary.formula.ball import Ball, RationalPi, Undefined, certified, evaluate, holds, precision_of
from corollary.formula.functions import FUNCTIONS
from corollary.grading.replay import Answered, ancestors, compute, simulated
from corollary.grading.rounding import Noise, noise_of, tolerance_of
from corollary.grading.signs import signed
from corollary.problem.given import Given
from corollary.problem.part import Part
from corollary.problem.problem import Problem
from corollary.problem.sampling import sample
from corollary.problem.variant import Variant
from corollary.units.unit import Unit

TRIED = 40  # draws for which a formula of counts must give a whole number: halves show in one of two


def is_counted(solution: Solution, place: int, part: Part, known: Mapping[str, RationalPi]) -> bool:
    """True if the part at a place asks for an `.integer`, or its steps make whole numbers of whole numbers, for all draws and these.

    `known` are the values of all letters. A ratio that comes out whole is none where its steps have other numbers in them; of several
    components each has to be one.
    """
    if part.answer_type == "integer":
        return True
    if part.unit.text != "1" or not _whole_by_its_steps(solution, place):
        return False
    used = names(*(solution.unknowns[place].in_givens or ()))
    return all(_is_whole(known[name]) for name in used if name in known)


@once
def _whole_by_its_steps(solution: Solution, place: int) -> bool:
    problem, find = solution.problem, solution.unknowns[place]
    trees = find.in_givens or ()
    used = names(*trees)
    if not all(names(tree) or _is_stated(name, find) for name, tree in zip(find.names, trees, strict=True)):
        return False
    counts = {given.symbol for given in problem.givens if _counts(given)}
    for each in solution.unknowns[: place + 1]:
        local = each.local.trees if isinstance(each.local, ClosedForms) else ()
        if local and all(names(tree) <= counts for tree in local):
            counts |= set(each.names)
    if not trees or not used <= counts or not counts.issuperset(find.names):
        return False
    found = (exactly(tree, draw.exact) for draw in sample(problem, TRIED, salt="counts") for tree in trees)
    return all(value is not None and _is_whole(value) for value in found)


def _is_stated(name: str, find: Unknown) -> bool:
    """True if a law says of a letter, whatever the numbers, how many there are: `N = 2*2`, and not what a ratio comes to."""
    stated = (relation for law in find.laws for relation in law.here if relation.left == Name(name))
    return any(_is_counting(relation.right) for relation in stated)


def _is_counting(tree: Expr) -> bool:
    match tree:
        case Number(value):
            return value.denominator == 1
        case Sum() | Product() | Negative():
            return all(map(_is_counting, children(tree)))
        case _:
            return False


def _counts(given: Given) -> bool:
    """True if a given is a plain whole number whatever is drawn."""
    ends = (given.value, given.grid.first, given.grid.step, *given.grid.values)
    return given.unit.text == "1" and not given.words and all(each.denominator == 1 for each in ends)


def _is_whole(value: RationalPi) -> bool:
    return not value.pi and value.ratio.denominator == 1


BELOW_A_ROOT = Number(
    Fraction(100)
)  # times a residue: the root of 1e-16, in parts of ROUNDING_NOISE, and some more
SMALLER = 1e-3  # of the smallest given of the dimension: a residue is far below whatever the problem is about


def residue_of(
    problem: Problem, find: Unknown, units: Sequence[Unit], known: Mapping[str, RationalPi]
) -> Values:
    """For each component (absolute, SI) what calculators and doubles may leave of it where its terms cancel.

    A share of the terms, or of the largest given of the dimension where there are none; and always far below its smallest.
    """
    letters = dict(known)
    for each in problem.givens:
        if each.symbol in known and not known[each.symbol].ratio:
            letters[each.symbol] = _usual_size(each)
    trees = find.in_givens or (find.local.trees if isinstance(find.local, ClosedForms) else ())
    found: list[float] = []
    for place, unit in enumerate(units):
        alike = [
            abs(float(known[each.symbol]))
            for each in problem.givens
            if not each.words and each.unit.dimension == unit.dimension
        ]
        terms = _terms(trees[place], letters) if len(trees) == len(units) else 0.0
        size = max(terms or max(alike, default=0.0), abs(float(unit.offset)))
        smallest = min(filter(None, alike), default=math.inf)
        found.append(min(ROUNDING_NOISE * size, SMALLER * smallest))
    return tuple(found)


def _terms(tree: Expr, known: Mapping[str, RationalPi]) -> float:
    """What is added up before anything cancels; 0 where it has no value."""
    sizes = {_size(name): RationalPi(abs(value.ratio), value.pi) for name, value in known.items()}
    try:
        return abs(number(_added(tree), {**known, **sizes}))
    except Undefined:
        return 0.0


def _size(name: str) -> str:
    return f"|{name}|"


def _added(tree: Expr) -> Expr:
    """The formula with every subtraction above the line made an addition, and 1 for what takes plain numbers: doubles make no
    exact 0 of `cos(90°)`. Below a root a residue of 1e-16 is one of 1e-8."""
    match tree:
        case Name(name):
            return tree if name == "pi" else Name(_size(name))
        case Number(value):
            return Number(abs(value))
        case Negative(term):
            return _added(term)
        case Sum() | Product():
            return map_children(tree, _added)
        case Quotient(top, bottom):
            return Quotient(_added(top), bottom)
        case Power(base, Number(exponent)) if exponent > 0:
            whole = Power(_added(base), Number(exponent))
            return whole if exponent >= 1 else Product((BELOW_A_ROOT, whole))
        case Call("abs", (argument,)):
            return _added(argument)
        case Call("sqrt", (argument,)):
            return Product((BELOW_A_ROOT, Call("sqrt", (_added(argument),))))
        case Call("acos" | "asin"):
            return BELOW_A_ROOT
        case Call(function) if function in FUNCTIONS and FUNCTIONS[function].dimension is None:
            return ONE
        case _:
            return tree


def _usual_size(given: Given) -> RationalPi:
    """The largest value that a given may have, in SI."""
    ends = (RationalPi(*given.unit.to_si(value)) for value in (given.grid.first, given.grid.last))
    return max(ends, key=lambda end: abs(end.ratio))


MARGIN = 1.25  # beyond the largest of a few dozen random roundings there are rarer ones
MAGNIFIED = 1024.0  # how much further than rounding does settings are moved to see what rounding does
LEAST_ROUNDING = 1e-12  # relative: of what cannot be looked at closer
COUNTED = 1e-9  # relative: two whole numbers are further apart, and the doubles of one nearer together
TINY = 1e-9  # of the length: a component so small is a remainder of the arithmetic


@dataclass(frozen=True, slots=True)
class Truth:
    """The answer to one part: SI values, whether their digits are certified, and what may be off.

    `scale` is what the tolerance is relative to: the length of the answer, or what the problem names where that is zero.
    `noise` is how far rounding the answers of whole steps moves it, relative as the tolerance: what decides whether the numbers
    may be drawn. `uncertain` is how far rounding moves each component (absolute): a smaller component has no sign of its own.
    `scales` are those of each entry of a table, which are numbers of their own: then `scale` is the largest of them (0 where one is),
    and `tolerance` and `noise` those of the entry that may be off most. `residue` says of each component that is zero how large
    (absolute) a number may be that stands for it. `counted`: a whole number, which nobody rounds. `signed` says which components
    have a sign to get wrong (empty: each).
    """

    place: int
    values: Values
    proven: bool
    error: float
    scale: float
    tolerance: float
    noise: float
    uncertain: Values
    scales: Values = ()
    residue: Values = ()
    counted: bool = False
    signed: tuple[bool, ...] = ()

    def is_met_by(self, values: Values, more: float = 0.0) -> bool:
        """Whether values are within the tolerance, and so much `more`; of a table, whether every entry is."""
        tolerance = self.tolerance + more
        if not self.scales:
            return within(values, self.values, tolerance, self.scale, max(self.residue, default=0.0))
        residue = self.residue or (0.0,) * len(self.values)
        return len(values) == len(self.values) and all(
            within((value,), (target,), tolerance, scale, left)
            for value, target, scale, left in zip(values, self.values, self.scales, residue, strict=True)
        )

    @property
    def value(self) -> float | tuple[float, ...]:
        """The number, or one for each component, in SI."""
        return self.values[0] if len(self.values) == 1 else self.values


@dataclass(frozen=True, slots=True)
class Key:
    """Everything a variant can be marked with; `values` are the finds in the solution's order, `choices` the letters of the right
    options as the sheet has them (empty: it does not)."""

    solution: Solution
    variant: Variant
    values: tuple[Values, ...]
    truths: Mapping[str, Truth]
    choices: Mapping[str, str]

    def __getitem__(self, part: str) -> Truth:
        """The answer to a part that asks for a quantity or a formula."""
        return self.truths[part]

    @property
    def asked(self) -> set[str]:
        """The parts that the sheet asks: a set may leave some out."""
        return {part.id for part in self.variant.problem.parts}

    def find(self, truth: Truth) -> Unknown:
        return self.solution.unknowns[truth.place]


def make_key(solution: Solution, variant: Variant) -> Key:
    """The key of one variant. Raises Undefined when an answer does not exist for these numbers."""
    givens = variant.exact
    solution = solution_for(solution, givens)
    stated: list[Answered] = []
    for find, found in zip(solution.unknowns, answers(solution, variant), strict=True):
        if found.why:
            what = f"part {find.part}" if find.part else ", ".join(find.names)
            raise Undefined(f"{what} has {found.why}")
        stated.append(found)
    values = [each.values for each in stated]
    noise = noise_of(solution, givens, values)
    truths: dict[str, Truth] = {}
    known = givens | named(solution, values)
    parts = {part.id: part for part in variant.problem.parts}
    for place, find in enumerate(solution.unknowns):
        part = parts.get(find.part)
        if not find.part:
            continue
        if part is not None and part.rows:
            truth = table_truth(place, stated[place], noise[place], part, find, known)
        else:
            truth = _truth(place, stated[place], noise[place], part, find, known)
        truths[find.part] = (
            truth
            if part is None
            else _zeros_counts_and_signs(truth, stated[place], part, find, solution, known)
        )
    choices = {
        part: parts[part].letter_asked(option_that_holds(truth.options, givens, part))
        for part, truth in solution.choices.items()
        if part in parts
    }
    return Key(solution, variant, tuple(values), truths, choices)


def _truth(
    place: int,
    stated: Answered,
    noise: Noise,
    part: Part | None,
    find: Unknown,
    known: Mapping[str, RationalPi],
) -> Truth:
    """All components together. A sheet from before a correction need not have every part of today's solution."""
    # Of 20 °C one per cent is 0.2 K.
    zero = float(part.unit.offset) if part is not None else 0.0
    above = tuple(value - zero for value in stated.values)
    # what a scene gives in the place of zero is none of its digits
    left = all(abs(x) <= error for x, error in zip(above, stated.errors, strict=True))
    scale = scale_of(find, (0.0,) * len(above) if left else above, known)
    error = max(stated.errors) / scale if scale else 0.0
    off = MARGIN * noise.distance / scale if scale else 0.0
    uncertain = tuple(MARGIN * each + TINY * scale for each in noise.components)
    by_steps = MARGIN * noise.by_steps / scale if scale else 0.0
    tolerance = tolerance_of(part.tolerance if part is not None else 0.0, off, error)
    return Truth(place, stated.values, stated.certified, error, scale, tolerance, by_steps, uncertain)


def _zeros_counts_and_signs(
    truth: Truth,
    stated: Answered,
    part: Part,
    find: Unknown,
    solution: Solution,
    known: Mapping[str, RationalPi],
) -> Truth:
    """The truth with what stands for its zeros, with no tolerance where it is a whole number, and with what has a sign."""
    units = part.units_for(len(stated.values))
    zeros = [
        abs(value - float(unit.offset)) <= error
        for value, unit, error in zip(stated.values, units, stated.errors, strict=True)
    ]
    if any(zeros):
        residue = residue_of(solution.problem, find, units, known)
        residue = tuple(each if zero else 0.0 for each, zero in zip(residue, zeros, strict=True))
        truth = replace(truth, residue=residue if truth.scales or all(zeros) else ())
    if not part.tolerance and is_counted(solution, truth.place, part, known):
        truth = replace(truth, counted=True, tolerance=COUNTED, noise=0.0)
    return replace(truth, signed=signed(solution, truth.place, part, stated.values))


def table_truth(
    place: int, stated: Answered, noise: Noise, part: Part, find: Unknown, known: Mapping[str, RationalPi]
) -> Truth:
    """Each entry compared with itself; one that is zero with the largest in the same unit, or with what the problem names."""
    named = 0.0 if find.scale is None else scale_of(find, (0.0,), known)
    sizes = [
        abs(value)
        or max(abs(x) for x, its_unit in zip(stated.values, part.units, strict=True) if its_unit == unit)
        or named
        for value, unit in zip(stated.values, part.units, strict=True)
    ]
    uncertain = tuple(MARGIN * each + TINY * size for each, size in zip(noise.components, sizes, strict=True))
    complete = all(sizes)

    def most(several: Sequence[float]) -> float:
        return max(each / size for each, size in zip(several, sizes, strict=True)) if complete else 0.0

    error = most(stated.errors)
    tolerance = tolerance_of(part.tolerance, MARGIN * most(noise.components), error)
    return Truth(
        place,
        stated.values,
        stated.certified,
        error,
        max(sizes) if complete else 0.0,
        tolerance,
        MARGIN * most(noise.components_by_steps),
        uncertain,
        tuple(sizes),
    )


def answers(solution: Solution, variant: Variant) -> Iterator[Answered]:
    """What each unknown comes to, in the solution's order."""
    before: list[Answered] = []
    missing: set[int] = set()
    for place, find in enumerate(solution.unknowns):
        lost = find.in_givens is None and missing & (ancestors(solution, place) - {place})
        try:
            if lost:
                raise Undefined(
                    f"it follows from {solution.unknowns[min(lost)].names[0]}, which has no value"
                )
            found = answer(solution, find, variant, before)
        except Undefined as why:
            missing.add(place)
            unknown, exact = (math.nan,) * len(find.names), (0.0,) * len(find.names)
            found = Answered(unknown, False, exact, False, f"no value for these numbers: {why}")
        before.append(found)
        yield found


def answer(solution: Solution, find: Unknown, variant: Variant, before: Sequence[Answered]) -> Answered:
    """An unknown's values from its closed form, certified; or from its scene, or from what came from one, with the error that has."""
    if find.in_givens is not None:
        givens = variant.exact
        found = [certified(tree, givens) for tree in find.in_givens]
        return Answered(
            tuple(each.value for each in found), all(each.proven for each in found), (0.0,) * len(found), True
        )
    known = variant.exact | named(solution, [each.values for each in before])
    match find.local:
        case SceneOutcome(scene, settings, observe, bank=bank):
            unrounded = {
                name: evaluate(tree, variant.exact, BITS)
                for earlier, _ in zip(solution.unknowns, before, strict=False)
                for name, tree in zip(earlier.names, earlier.in_givens or (), strict=False)
            }
            letters = dict[str, RationalPi | Ball](known) | unrounded
            at = {name: evaluate(tree, letters, BITS) for name, tree in settings.items()}
            return simulated_at(scene, at, observe, bank)
        case rule:
            return propagated(rule, known, solution, before)


def simulated_at(scene: str, exact: Mapping[str, Ball], observe: str, bank: str) -> Answered:
    """What a scene gives, and how far it may be off: the run's own error, and what the rounding of its settings to doubles changes.

    The second is the difference to a run whose settings are moved further: a proven bound only where nothing is rounded.
    """
    at = {name: finite_double(ball) for name, ball in exact.items()}
    seen = simulated(scene, tuple(at.items()), observe, bank)
    with precision_of(BITS):
        rounded = {name: float((ball - Ball(at[name])).mid()) for name, ball in exact.items()}
    if not any(rounded.values()):
        return seen
    moved = tuple((name, value + MAGNIFIED * rounded[name]) for name, value in at.items())
    try:
        other = simulated(scene, moved, observe, bank).values
    except Undefined:
        other = ()
    if len(other) != len(seen.values):
        other = tuple(x * (1.0 + MAGNIFIED * LEAST_ROUNDING) for x in seen.values)
    changed = (abs(x - y) / MAGNIFIED for x, y in zip(seen.values, other, strict=True))
    return Answered(
        seen.values, False, tuple(e + c for e, c in zip(seen.errors, changed, strict=True)), False
    )


def propagated(
    rule: Rule, known: Mapping[str, RationalPi], solution: Solution, before: Sequence[Answered]
) -> Answered:
    """What follows from values that are known up to an error: the rule in balls as wide as these."""
    values = compute(rule, known)
    if not isinstance(rule, ClosedForms):
        return Answered(values, False, tuple(LEAST_ROUNDING * abs(x) for x in values), False)
    uncertain = {
        name: Ball(value, error)
        for find, stated in zip(solution.unknowns, before, strict=False)
        for name, value, error in zip(find.names, stated.values, stated.errors, strict=True)
        if error
    }
    balls = [evaluate(tree, dict[str, RationalPi | Ball](known) | uncertain, BITS) for tree in rule.trees]
    with precision_of(BITS):
        errors = tuple(float(abs(ball - Ball(x)).upper()) for ball, x in zip(balls, values, strict=True))
    letters = names(*rule.trees)
    bound = all(
        stated.bound
        for find, stated in zip(solution.unknowns, before, strict=False)
        if letters & set(find.names)
    )
    return Answered(values, False, errors, bound)


def named(solution: Solution, values: Sequence[Values]) -> dict[str, RationalPi]:
    """The unknowns found so far, by their letters, as exact numbers."""
    return {
        name: as_exact(value)
        for find, numbers in zip(solution.unknowns, values, strict=False)
        for name, value in zip(find.names, numbers, strict=True)
        if math.isfinite(value)
    }


def scale_of(find: Unknown, values: Values, known: Mapping[str, RationalPi]) -> float:
    """The length of the answer; where the answer is zero, what the solution names, or the largest given of its dimension."""
    length = math.hypot(*values)
    if length > 0 or find.scale is None:
        return length
    try:
        return abs(number(find.scale, known))
    except Undefined:
        return 0.0


def option_that_holds(options: Mapping[str, Ways], givens: Mapping[str, RationalPi], part: str) -> str:
    """The letter of the one option that holds. Raises Undefined when it is not exactly one."""
    true = [
        letter
        for letter, ways in options.items()
        if any(all(holds(each, givens) for each in way) for way in ways)
    ]
    if len(true) != 1:
        raise Undefined(f"part {part}: {len(true)} options hold ({', '.join(true)}); exactly one must")
    return true[0]
