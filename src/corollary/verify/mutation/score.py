"""The mutation score of a problem: each law bent in each way, held against its checks; the line that would catch most."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import islice

from corollary.derive.again import SolvedAgain, differential
from corollary.derive.applied import applied
from corollary.derive.given_signs import symbol_of
from corollary.derive.load import Loaded
from corollary.derive.one_entry import with_one_entry
from corollary.derive.simulation import Simulation
from corollary.derive.solution import Solution
from corollary.derive.solve import solvers
from corollary.derive.statements import Confirm, Step
from corollary.formula.arithmetics import NotAvailable
from corollary.formula.ast import (
    ONE,
    TWO,
    ZERO,
    Call,
    Expr,
    Name,
    Negative,
    Number,
    Power,
    Product,
    Quotient,
    Relation,
    Sum,
    children,
    cofunction,
    names,
    negated,
    replace_child,
    unsigned,
)
from corollary.formula.ball import Undefined
from corollary.formula.errors import ParseError
from corollary.formula.from_sympy import NoTree
from corollary.formula.operators import OPERATORS, as_stated, measured
from corollary.formula.plain_text import text
from corollary.grading.key import Key, make_key
from corollary.laws.law import Law
from corollary.problem.diagnostic import name_in_bank
from corollary.problem.given import Given
from corollary.problem.part import Part
from corollary.problem.sampling import sample
from corollary.scenes.run import Run
from corollary.units.dimensional_analysis import Dimension, dimension_of
from corollary.units.unit import show
from corollary.verify.checked import MutationScore, Unnoticed
from corollary.verify.expected_answers import difference, in_order
from corollary.verify.laws import dimensions_of
from corollary.verify.mutation.notices import EXACT, Checks, MutationCase, off
from corollary.verify.mutation.numeric_roots import FAILURES, Values
from corollary.verify.mutation.resolved import Laws, Replacement, Resolver
from corollary.verify.mutation.spots import (
    BentEquations,
    Contradicted,
    FindInDoubles,
    MutationSpot,
    bent_values,
    founds,
    spot_at,
    spot_of,
)

FACTORS: tuple[tuple[str, Expr], ...] = (
    ("factor 2", TWO),
    ("factor 1/2", Quotient(ONE, TWO)),
    ("factor 3", Number(Fraction(3))),
    ("factor 4", Number(Fraction(4))),
    ("factor pi", Name("pi")),
    ("prefix 10^3", Number(Fraction(1000))),
    ("prefix 10^-3", Quotient(ONE, Number(Fraction(1000)))),
)


@dataclass(frozen=True, slots=True)
class Bend:
    """One law otherwise: the kind of slip, and the law with it."""

    kind: str
    law: Law

    @property
    def text(self) -> str:
        return text(as_stated(self.law.textbook))


def bends(law: Law) -> Iterator[Bend]:
    """Every bend of a law, each once."""
    whole = law.textbook
    seen = {whole, Relation("=", whole.right, whole.left)}
    for kind, bent in _of_sides(whole):
        if bent not in seen:
            seen.add(bent)
            yield Bend(kind, replace(law, textbook=bent))


def _of_sides(whole: Relation) -> Iterator[tuple[str, Relation]]:
    """Of the right side, and of the left where it is more than one letter: a factor there is its inverse on the right."""
    left, right = whole.left, whole.right
    if right != ZERO:
        for kind, bent in _of(right, top=True):
            yield kind, Relation("=", left, bent)
        if isinstance(right, Sum) and left != ZERO:
            for kind, bent in _of_term(right):
                yield kind, Relation("=", left, bent)
    if not isinstance(left, Name):
        single = not isinstance(left, Sum)
        for kind, bent in _of(left, top=not single):
            yield kind, Relation("=", bent, right)


def _of(tree: Expr, *, top: bool) -> Iterator[tuple[str, Expr]]:
    """A formula with one slip in it; signs and factors of the whole only at the `top`, of terms everywhere."""
    if top and not isinstance(tree, Sum):
        yield from _of_term(tree)
    match tree:
        case Sum(terms):
            for place, term in enumerate(terms):
                for kind, bent in _of_term(term):
                    yield kind, replace_child(tree, place, bent)
                rest = (*terms[:place], *terms[place + 1 :])
                yield "term dropped", rest[0] if len(rest) == 1 else Sum(rest)
        case Power(base, Number(value)):
            for step in (1, -1):
                yield "exponent", _power(base, value + step)
        case Call("sin" | "cos"):
            yield "sine for cosine", cofunction(tree)
        case _:
            pass
    if isinstance(tree, Call) and tree.function in OPERATORS:
        return  # what stands in a derivative is no factor
    for place, part in enumerate(children(tree)):
        if isinstance(tree, Power) and place == 1:
            continue
        bent_parts = _of(part, top=False)
        if isinstance(part, Name) and isinstance(tree, Product | Quotient):
            bent_parts = iter([("exponent", _power(part, Fraction(2))), ("exponent", ONE)])
        for kind, bent in bent_parts:
            yield kind, replace_child(tree, place, bent)


def _of_term(term: Expr) -> Iterator[tuple[str, Expr]]:
    if term == ZERO:
        return
    inner = unsigned(term)
    yield "sign", negated(term)
    for kind, factor in FACTORS:
        product = Product((factor, *(inner.factors if isinstance(inner, Product) else (inner,))))
        yield kind, Negative(product) if isinstance(term, Negative) else product


def _power(base: Expr, exponent: Fraction) -> Expr:
    return ONE if exponent == 0 else base if exponent == 1 else Power(base, Number(exponent))


CASES = 8  # special cases of one problem that are tried
MOST = 24  # bends that proposals are tried on: the others are of the same laws
FEW = 0.5  # of the unnoticed: a line that catches less is not worth more than a value from elsewhere


@dataclass(frozen=True, slots=True)
class Candidate:
    """A line, and the unnoticed bends that it would notice, by place."""

    line: str
    notices: frozenset[int]


def proposed(checks: Sequence[Checks], unnoticed: Sequence[Laws]) -> tuple[str, int]:
    """The line, and how many it would notice; "" where all are noticed or none is known."""
    if not unnoticed:
        return "", 0
    candidates = [
        each for one in checks for each in _candidates(one, unnoticed[:: 1 + len(unnoticed) // MOST])
    ]
    if not candidates:
        return "", 0
    best = max(candidates, key=lambda each: len(each.notices))
    share = len(best.notices) / len(unnoticed[:: 1 + len(unnoticed) // MOST])
    return (best.line, round(share * len(unnoticed))) if best.notices else ("", 0)


def _candidates(checks: Checks, unnoticed: Sequence[Laws]) -> Iterator[Candidate]:
    case, problem = checks.case, checks.case.solution.problem
    steps = [checks.bent_steps(laws).equations for laws in unnoticed]
    spot = case.spots[0]
    if case.printed:
        for part_id in checks.parts:
            if part_id not in checks.expected and not problem.asks_of_variable(part_id):
                line = f'expected="about …{_unit(problem.part(part_id))}" on part {part_id}'
                yield Candidate(line, _with_estimate(checks, part_id, steps, spot))
    letters = sorted({name for found in checks.parts.values() for name in found.find.names})
    for case_text, there in islice(_special_cases(checks, spot), CASES):
        noticed = _at(checks, letters, steps, there)
        for letter in letters:
            yield Candidate(f"at: `{case_text}, {letter}=…`", noticed[letter])
    for part_id, found in checks.parts.items():
        line = f"confirm: with another law below it that {', '.join(found.find.names)} must obey"
        yield Candidate(line, _changed(checks, part_id, steps, spot))


def _unit(part: Part) -> str:
    return f" {show(part.unit)}" if show(part.unit) else ""


def _with_estimate(
    checks: Checks, part_id: str, steps: Sequence[dict[int, BentEquations]], spot: MutationSpot
) -> frozenset[int]:
    """The bends that an estimate as good as the key would notice."""
    part, found = checks.case.solution.problem.part(part_id), checks.parts[part_id]
    true = tuple(spot.letters[name] for name in found.find.names)
    zeros = tuple(float(unit.offset) for unit in part.units_for(len(true)))
    return frozenset(
        place
        for place, bent in enumerate(steps)
        if (values := _values(checks, bent, spot, found.find.names)) is not None
        and difference(in_order(part, true), in_order(part, values), zeros)
    )


def _changed(
    checks: Checks, part_id: str, steps: Sequence[dict[int, BentEquations]], spot: MutationSpot
) -> frozenset[int]:
    found = checks.parts[part_id]
    return frozenset(
        place
        for place, bent in enumerate(steps)
        if (values := _values(checks, bent, spot, found.find.names)) is not None
        and any(off(values[at], spot.letters[name]) > EXACT for at, name in enumerate(found.find.names))
    )


def _values(
    checks: Checks, bent: dict[int, BentEquations], spot: MutationSpot, letters: Sequence[str]
) -> Values | None:
    try:
        return bent_values(checks.case.every, bent, spot).of(letters)
    except (Contradicted, NotAvailable, *FAILURES):
        return None


def _special_cases(checks: Checks, spot: MutationSpot) -> Iterator[tuple[str, MutationSpot]]:
    """A given that is nothing, or as large as another of its kind, where the answers have values then."""
    problem = checks.case.solution.problem
    givens = [given for given in problem.givens if not given.words and not given.source]
    numbers = {given.symbol: spot.letters[given.symbol] for given in givens}
    others = {name: value for name, value in spot.letters.items() if name not in numbers}
    for given in givens:
        alike = [each for each in givens if each is not given and _comparable(each, given)]
        nothing = [] if symbol_of(problem, given.symbol).is_positive else [("0", 0.0)]
        for word, value in [*nothing, *((each.symbol, numbers[each.symbol]) for each in alike)]:
            there = spot_at(others | numbers | {given.symbol: value}, checks.case.every)
            if there is not None:
                yield f"{given.symbol}={word}", there


def _comparable(one: Given, other: Given) -> bool:
    """Whether an author would set two givens equal: the same quantity of two bodies, times or places, by letter or by words."""
    if one.unit.dimension != other.unit.dimension:
        return False
    stems = [re.sub(r"[_\d].*|[A-Z]?$", "", each.symbol) or each.symbol for each in (one, other)]
    words = [set(re.findall(r"[^\W\d_]{4,}", each.meaning.casefold())) for each in (one, other)]
    return stems[0].casefold() == stems[1].casefold() or bool(words[0] & words[1])


def _at(
    checks: Checks, letters: Sequence[str], steps: Sequence[dict[int, BentEquations]], there: MutationSpot
) -> dict[str, frozenset[int]]:
    """For each letter the bends that change it there."""
    found: dict[str, set[int]] = {letter: set() for letter in letters}
    for place, bent in enumerate(steps):
        values = _values(checks, bent, there, letters)
        for letter, value in zip(letters, values or (), strict=False):
            if off(value, there.letters[letter]) > EXACT:
                found[letter].add(place)
    return {letter: frozenset(places) for letter, places in found.items()}


DRAWS = 5  # of those walked whose keys the bends are tried on, besides the printed numbers
RARE = 200  # draws among which one is sought for a case that those walked do not have
Played = Sequence[tuple[Key, Sequence[tuple[Simulation, Run]]]]


@dataclass(frozen=True, slots=True)
class BentLaw:
    """A bend of a law at a line, and the first check that it fails ("" for none)."""

    law: Law
    line: int
    bend: Bend
    by: str
    laws: Laws


def score(loaded: Loaded, solution: Solution, own: Key, played: Played) -> MutationScore:
    """The score of a problem whose derivation is solved; `own` is the key of the printed numbers, `played` has the keys of draws
    with the scenes that were run for them."""
    if solution.template is not None:
        loaded, solution = with_one_entry(loaded, solution, own.variant)
        own = make_key(solution, own.variant)
        played = list(_of_same_numbers(solution, played))
    checks = _checks(loaded, solution, own, played)
    every = list(_tried(loaded, solution, checks))
    counted = [each for each in every if each.by not in ("same", "undecided")]
    by = Counter(each.by for each in counted if each.by)
    file = name_in_bank(loaded.path)
    unnoticed = [each for each in counted if not each.by]
    proposal, caught = proposed(checks, [each.laws for each in unnoticed])
    return MutationScore(
        len(counted),
        sum(by.values()),
        dict(by.most_common()),
        tuple(
            Unnoticed(each.law.name, file, each.line, each.bend.kind, each.bend.text) for each in unnoticed
        ),
        sum(each.by == "undecided" for each in every),
        proposal,
        caught,
        tuple(
            dict.fromkeys(f"{file}:{each.line}: {each.law.name}" for each in every if each.by == "undecided")
        ),
    )


def _of_same_numbers(
    solution: Solution, played: Played
) -> Iterator[tuple[Key, Sequence[tuple[Simulation, Run]]]]:
    """The keys of the same numbers by another solution, but for those for which it has no answer."""
    for key, runs in played:
        with suppress(Undefined):
            yield make_key(solution, key.variant), runs


def _tried(loaded: Loaded, solution: Solution, checks: Sequence[Checks]) -> Iterator[BentLaw]:
    dimensions = _dimensions(solution)
    for law, line in _laws(loaded):
        for bend in bends(law):
            here = written(bend)
            if here is None:
                continue
            laws = {id(law): Replacement(bend.law, here)}
            by = "dimensions" if _misfits(here, dimensions) else _noticed(checks, laws)
            yield BentLaw(law, line, bend, by, laws)


def written(bend: Bend) -> tuple[Relation, ...] | None:
    """The law in the problem's letters; None for one that no author could state, as a vector to a power."""
    try:
        return applied(bend.law).here
    except (ValueError, TypeError):
        return None


def _noticed(checks: Sequence[Checks], laws: Laws) -> str:
    """The first check of the first case that fails; "same" where no answer changes, "undecided" where it is not solved in numbers."""
    having = [each for each in checks if not laws.keys().isdisjoint(each.laws)]
    if not having:
        return "undecided"
    found: list[str | None] = []
    for each in having:
        try:
            by = each.notice(laws)
        except NotAvailable:
            return "undecided"
        if by:
            return by
        found.append(by)
    return "same" if all(each is None for each in found) else ""


def _laws(loaded: Loaded) -> Iterator[tuple[Law, int]]:
    """Each law of a step once, with the line of the first step in which it stands."""
    seen: set[int] = set()
    for branch in loaded.branches:
        for entry in branch.derivation.entries:
            for law in entry.laws if isinstance(entry, Step) else ():
                if id(law) not in seen:
                    seen.add(id(law))
                    yield law, entry.statement.line


def _checks(loaded: Loaded, solution: Solution, own: Key, played: Played) -> list[Checks]:
    """The checks of each case for which a spot is known."""
    cases = [(each.solution, each.place) for each in solution.regimes] or [(solution, 0)]
    found: list[Checks] = []
    for one, place in cases:
        branch = loaded.branches[place]
        keys = [key for key in (own, *(key for key, _ in played)) if key.solution is one or len(cases) == 1]
        keys = keys or list(islice(_keys_in(solution, one), DRAWS))
        try:
            every = founds(one, branch.derivation.entries)
            spots = [spot_of(key, every) for key in keys]
            if spots:
                entries, printed = branch.derivation.entries, keys[0] is own
                resolver = _resolver(solution, loaded, place, every)
                case = MutationCase(one, loaded, entries, every, spots, printed, played, resolver)
                found.append(Checks(case))
        except (NotAvailable, NoTree, Undefined):
            continue
    return found


def _keys_in(solution: Solution, case: Solution) -> Iterator[Key]:
    """The keys of draws for which a rare case holds."""
    for variant in sample(solution.problem, RARE):
        with suppress(Undefined):
            key = make_key(solution, variant)
            if key.solution is case:
                yield key


def _resolver(
    solution: Solution, loaded: Loaded, place: int, every: Sequence[FindInDoubles]
) -> Resolver | None:
    """What solves steps again; None where no law of a step, of a route or of a claim has derivatives, integrals or functions."""
    entries = loaded.branches[place].derivation.entries
    laws = [law for each in entries if isinstance(each, Step | Confirm) for law in each.laws]
    routes = [route for each in entries if isinstance(each, Step) for route in each.routes]
    if not any(map(differential, (*laws, *(law for route in routes for law in route.laws)))):
        return None
    solver = solvers(solution.problem, loaded)[place]
    return Resolver(SolvedAgain(solver, [each.entry for each in every]), every)


def _dimensions(solution: Solution) -> dict[str, Dimension]:
    """Of every letter; of a case's own, those of the first case that has it."""
    found: dict[str, Dimension] = {}
    for one in [each.solution for each in solution.regimes] or [solution]:
        found = dimensions_of(one) | found
    return found


def _misfits(here: Sequence[Relation], dimensions: Mapping[str, Dimension]) -> bool:
    """Whether the check of dimensions would refuse a law."""
    return any(
        isinstance(dimension_of(measured(relation), dimensions), ParseError)
        for relation in here
        if not names(measured(relation)) - {"pi"} - dimensions.keys()
    )
