"""Checks of a solved derivation: laws put back, cases, dimensions, and the obligations that hold for all numbers."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import chain

from corollary.derive.put_back import PutBack, put_laws_back
from corollary.derive.solution import Solution
from corollary.derive.solve import SolvedDerivation
from corollary.formula.ast import Expr, Relation, names
from corollary.formula.errors import ParseError, sentence
from corollary.formula.operators import measured
from corollary.problem.bank import Bank
from corollary.problem.diagnostic import name_in_bank
from corollary.problem.sampling import sample
from corollary.problem.variant import chapter, written_apart
from corollary.units.dimensional_analysis import Dimension, dimension_of
from corollary.verify.checked import Tally
from corollary.verify.obligations.claims import laws_of
from corollary.verify.obligations.obligation import Settled
from corollary.verify.obligations.settle import settled

DRAWS = 100


def check_laws(solved: SolvedDerivation, tally: Tally) -> None:
    """Every equation holds with all that was found put in: by algebra, or at the sample points where that does not see it."""
    tally.put_back = put_laws_back(solved.solvers)
    tally.count(
        "laws put back", sum(not each.complaint and each.how != "simulated" for each in tally.put_back)
    )
    for complaint in dict.fromkeys(each.complaint for each in tally.put_back if each.complaint):
        tally.complain(complaint)


def check_cases(bank: Bank, solution: Solution, tally: Tally) -> None:
    """Exactly one case holds, for the chapter's own numbers and for each draw."""
    problem = solution.problem
    path, line = (
        name_in_bank(bank.solution(problem)),
        min((each.line for each in solution.regimes), default=0),
    )
    cases = solution.regimes and solution.template is None
    for variant in (chapter(problem), *sample(problem, DRAWS)) if cases else ():
        found = solution.regimes_at(variant.exact)
        if not tally.check(len(found) == 1, "cases"):
            which = " and ".join(repr(each.text) for each in found) or "no case"
            numbers = ", ".join(f"{name} = {value}" for name, value in written_apart(variant).items())
            tally.complain(
                f"{path}:{line}: {which} holds for {variant.label} ({numbers}); correct the conditions, so that exactly one case holds"
            )
            return


def dimensions_of(solution: Solution) -> dict[str, Dimension]:
    """The dimension of every letter of a derivation: its givens, variables, finds and functions."""
    found = {each.symbol: each.unit.dimension for each in solution.problem.letters}
    for find in solution.unknowns:
        found |= dict(zip(find.names, find.dimensions, strict=True))
        for function in find.functions:
            found |= function.dimensions
    return found


def check_dimensions(bank: Bank, solution: Solution, tally: Tally) -> None:
    """Every law and every condition of the derivation, as it stands here, has the same dimension on both sides."""
    others = {regime.place: regime.solution for regime in solution.regimes if regime.place}
    for other in others.values():
        check_dimensions(bank, other, tally)
    dimensions = dimensions_of(solution)
    path = bank.solution(solution.problem)
    for left in solution.neglected:
        dimensions |= dict(zip(left.bound.names, left.bound.dimensions, strict=True))
        dimensions |= {value.stated.name: value.dimension for value in left.supposing}
    stated: list[tuple[str, int, Expr]] = list(_conditions(solution))
    for find in (*solution.unknowns, *(left.bound for left in solution.neglected)):
        for law in (*find.laws, *(law for route in find.routes for law in route.stated.laws)):
            stated += [(law.name, find.statement.line, measured(relation)) for relation in law.here]
    complaints: list[str] = []
    for name, line, relation in stated:
        if names(relation) - {"pi"} - dimensions.keys():
            continue  # an unknown met only inside a step: its dimension follows from the law itself
        found = dimension_of(relation, dimensions)
        tally.count("dimensions")
        if isinstance(found, ParseError):
            complaints.append(f"{name_in_bank(path)}:{line}: {name}: {sentence(found)}")
    for each in dict.fromkeys(complaints):  # of a case that holds in several ways each has its relations
        tally.complain(each)


def _conditions(solution: Solution) -> Iterator[tuple[str, int, Relation]]:
    """The conditions of cases, options, roots and claims, each with what it is a condition of, and its line."""
    for regime in solution.regimes:
        yield from ((f"the case {regime.text!r}", regime.line, one) for one in regime.conditions)
    for find in solution.unknowns:
        yield from (("where=", find.statement.line, one) for one in find.where or ())
    for choice in solution.choices.values():
        for letter, ways in choice.options.items():
            yield from (
                (f"option {letter}", choice.statement.line, one)
                for one in dict.fromkeys(chain.from_iterable(ways))
            )
    for claim in solution.always:
        yield from (
            (f"always({claim.words!r})", claim.line, one) for clause in claim.conditions for one in clause
        )


def check_obligations(bank: Bank, solution: Solution, tally: Tally, variants: int) -> None:
    """Comes after the laws were put back; `variants` are walked besides."""
    file = name_in_bank(bank.solution(solution.problem))
    for found in settled(solution, variants):
        each = _as_put_back(found, tally.put_back) if found.kind == "laws hold" else found
        tally.obligations.append(each)
        if (
            each.outcome == "counter-example" and each is found and each.kind != "mistakes differ"
        ):  # which is a note already
            tally.complain(f"{file}:{each.line}: {what_is_wrong(each)}")
    tally.count("obligations", len(tally.obligations))


def _as_put_back(each: Settled, put_back: Sequence[PutBack]) -> Settled:
    """How the laws of a step held when all that was found was put in; what does not is complained of already."""
    step = each.line, each.claim, each.case  # several steps, or cases, may stand on one line
    here = [one for one in put_back if (one.line, laws_of(one.names), one.case) == step]
    broken = next((one for one in here if one.how == "differ"), None)
    if broken is not None:
        return replace(each, outcome="counter-example", by="a point", numbers=broken.at)
    if each.outcome in ("proven", "sampled") and any(one.how == "undecided" for one in here):
        return replace(each, outcome="undecided", by="neither algebra nor numbers decide it")
    if each.outcome == "proven" and any(one.how == "points" for one in here):
        return replace(each, outcome="sampled", by="no algebra decides it, it holds at points")
    return each


def what_is_wrong(each: Settled) -> str:
    """What is wrong, for which numbers, and what to do."""
    numbers = ", ".join(f"{name} = {value}" for name, value in each.numbers.items())
    text = f"it does not hold that {each.claim}" + (f": {numbers}" if numbers else "")
    if each.exclude:
        share = f"{100 * each.broken:.1f} %" if each.broken else "few"
        text += f" ({share} of the draws); where: {each.exclude}, in the problem, would exclude that"
    return text
