"""The one line that would notice most of the bends which nothing notices."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import islice

from corollary.formula.arithmetics import NotAvailable
from corollary.problem.part import Part
from corollary.units.unit import show
from corollary.verify.expected_answers import difference, in_order
from corollary.verify.mutation.notices import EXACT, Checks, off
from corollary.verify.mutation.numeric_roots import FAILURES, Values
from corollary.verify.mutation.resolved import Laws
from corollary.verify.mutation.spots import BentEquations, Contradicted, MutationSpot, bent_values, spot_at

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
            if part_id not in checks.expected:
                line = f'expected="about …{_unit(problem.part(part_id))}" on part {part_id}'
                yield Candidate(line, _with_estimate(checks, part_id, steps, spot))
    letters = sorted({name for found in checks.parts.values() for name in found.find.names})
    for case_text, there in islice(_special_cases(checks, spot), CASES):
        noticed = _at(checks, letters, steps, there)
        for letter in letters:
            yield Candidate(f"at({case_text}, {letter}=…)", noticed[letter])
    for part_id, found in checks.parts.items():
        line = f'confirm(law("…", "…")): another law that {", ".join(found.find.names)} must obey'
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
        alike = [each for each in givens if each.unit.dimension == given.unit.dimension and each is not given]
        for word, value in [("0", 0.0), *((each.symbol, numbers[each.symbol]) for each in alike)]:
            there = spot_at(others | numbers | {given.symbol: value}, checks.case.every)
            if there is not None:
                yield f"{given.symbol}={word}", there


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
