"""The mutation score of a problem: each law bent in each way, and held against the checks that the problem has."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from itertools import islice

from corollary.derive.again import SolvedAgain, differential
from corollary.derive.applied import applied
from corollary.derive.load import Loaded
from corollary.derive.simulation import Simulation
from corollary.derive.solution import Solution
from corollary.derive.solve import solvers
from corollary.derive.statements import Confirm, Step
from corollary.formula.arithmetics import NotAvailable
from corollary.formula.ast import Relation, names
from corollary.formula.ball import Undefined
from corollary.formula.errors import ParseError
from corollary.formula.from_sympy import NoTree
from corollary.formula.operators import measured
from corollary.grading.key import Key, make_key
from corollary.laws.law import Law
from corollary.problem.sampling import sample
from corollary.scenes.run import Run
from corollary.units.dimensional_analysis import Dimension, dimension_of
from corollary.verify.laws import dimensions_of
from corollary.verify.mutation.bends import Bend, bends
from corollary.verify.mutation.notices import Checks, MutationCase
from corollary.verify.mutation.proposal import proposed
from corollary.verify.mutation.record import MutationScore, Unnoticed
from corollary.verify.mutation.resolved import Laws, Replacement, Resolver
from corollary.verify.mutation.spots import FindInDoubles, founds, spot_of

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
    checks = _checks(loaded, solution, own, played)
    every = list(_tried(loaded, solution, checks))
    counted = [each for each in every if each.by not in ("same", "undecided")]
    by = Counter(each.by for each in counted if each.by)
    file = loaded.path.name
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
