"""The checks of one derivation at given values of its letters: which of them a bent law would fail."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

from corollary.answers.tolerance import within
from corollary.derive.again import differential
from corollary.derive.applied import applied
from corollary.derive.derivation import Always, Entry, Limit, Special, clauses, ways
from corollary.derive.forces import sum_along
from corollary.derive.load import Loaded, NotDerivable
from corollary.derive.ready_scenes import run
from corollary.derive.roots import exchanged
from corollary.derive.simulation import Seen, Simulation, simulations_of
from corollary.derive.solution import ClosedForms, Solution
from corollary.derive.statements import Choice, Confirm, Forces, Printed, Step
from corollary.formula.arithmetics import DOUBLES, Evaluation, NotAvailable, ready
from corollary.formula.ast import Name, Relation
from corollary.formula.from_sympy import NoTree, tree
from corollary.grading.assign import APART
from corollary.grading.key import Key
from corollary.grading.mistakes import ListedMistake, visible_mistakes
from corollary.grading.neglect import neglected_in
from corollary.grading.replay import ancestors
from corollary.grading.signs import size_asked
from corollary.laws.law import Law
from corollary.scenes.plan import followed
from corollary.scenes.run import BadSetting, GuardFailed, Run
from corollary.verify.expected_answers import difference, foreseen, in_order
from corollary.verify.mutation.numeric_roots import FAILURES, NumericEquations, Values
from corollary.verify.mutation.resolved import BentSteps, Laws, Resolver
from corollary.verify.mutation.spots import (
    BentEquations,
    BentValues,
    Contradicted,
    FindInDoubles,
    MutationSpot,
    bent_values,
    compared,
    fulfilled,
    spot_at,
)
from corollary.verify.printed import as_printed, readings_of
from corollary.verify.walk import meets
from corollary.verify.words.asked_sign import magnitudes_asked

FAR, NEAR = (
    (1e6, 1e3, 30.0),
    1e-6,
)  # times a given: as large (or, where that overflows, less), or as small, as a limit is tried at
CLEAR = 1e-3  # relative: what differs so much in a limit is another
EXACT = 1e-9  # relative: what differs so little is the same
COARSE, BEYOND = 1e-4, 0.01  # relative: the error of a run for a bend, and what it must be off to count
RUNS = 40  # scenes of one problem run for bends: those whose settings follow from the answers
AT_LEAST = 4  # draws on which a mistake must coincide with the bent truth, to say that it does on all


@dataclass(frozen=True, slots=True)
class MutationCase:
    """One regime of a problem as its checks see it: the derivation solved and stated, its scenes played, and spots to try."""

    solution: Solution
    loaded: Loaded
    entries: Sequence[Entry]
    every: Sequence[FindInDoubles]
    spots: Sequence[MutationSpot]  # the first is that of the printed numbers, where the case holds for them
    printed: bool
    played: Sequence[tuple[Key, Sequence[tuple[Simulation, Run]]]]
    resolver: Resolver | None  # where a law holds derivatives, integrals or functions


class Checks:
    """The checks of one case, made ready once, and asked for each bend."""

    def __init__(self, case: MutationCase):
        self.case = case
        problem, solution = case.solution.problem, case.solution
        self.parts = {found.find.part: found for found in case.every if found.find.part}
        key = case.spots[0].key if case.spots else None
        self.laws = {id(law) for each in case.entries if isinstance(each, Step) for law in each.laws}
        self.expected: dict[str, Values] = {}
        for part_id, text in problem.expected if case.printed else ():
            numbers = foreseen(problem, problem.part(part_id), text)
            if numbers is not None and part_id in self.parts:
                self.expected[part_id] = numbers
        self.printed: list[Printed] = [
            each
            for each in solution.entries
            if isinstance(each, Printed) and not each.erratum and case.printed
        ]
        asked = magnitudes_asked(problem)
        self.sized = {part for part in self.parts if part in asked or size_asked(problem.part(part))}
        self.always = [_conditions(each.condition) for each in case.entries if isinstance(each, Always)]
        self.options = [
            (
                each.statement.part,
                {letter: _option(held) for letter, held in each.options.items()},
                each.mistakes,
            )
            for each in case.entries
            if isinstance(each, Choice)
        ]
        self.claims = [each for each in case.entries if isinstance(each, Special | Limit)]
        self.mistakes = visible_mistakes(solution)
        self.rules = {
            id(each): [ready(tree, DOUBLES) for tree in each.mistake.rule.trees]
            for each in self.mistakes
            if isinstance(each.mistake.rule, ClosedForms)
        }
        self.key = key
        self.runs: dict[tuple[float, ...], bool] = {}
        # made once, for thousands of bends ask for the same; what the numbers stand for is kept, so that none is mistaken
        self.confirmed = {
            id(law): applied(law).here
            for each in case.entries
            if isinstance(each, Confirm)
            for law in each.laws
        }
        self.unexchanged = {id(each): self._unexchanged(each) for each in self.mistakes}
        self.differential: dict[int, tuple[Law, bool]] = {}
        self.again: dict[int, tuple[Laws, BentSteps]] = {}
        self.held: dict[int, tuple[Sequence[Relation], NumericEquations | None]] = {}
        self.tried: dict[tuple[int, int], list[tuple[MutationSpot, dict[str, Evaluation], float]]] = {}

    def equations(self, found: FindInDoubles, laws: Laws) -> NumericEquations:
        """The equations of a step, with bent laws in the places of theirs."""
        assert isinstance(found.entry, Step)
        here = [
            relation
            for law, own in zip(found.entry.laws, found.find.laws, strict=True)
            for relation in (laws[id(law)].here if id(law) in laws else own.here)
        ]
        return NumericEquations(here, found.own)

    def bent_steps(self, laws: Laws) -> BentSteps:
        """The equations of the steps that bent laws change. Raises Contradicted where one cannot be solved."""
        if id(laws) not in self.again:
            resolver = self.case.resolver
            steps = BentSteps() if resolver is None else resolver.bent_steps(laws)
            for found in self.case.every:
                stated = found.entry.laws if isinstance(found.entry, Step) else ()
                if found.place not in steps.equations and any(id(law) in laws for law in stated):
                    steps.equations[found.place] = self.equations(found, laws)
            if resolver is None:
                return steps
            self.again[id(laws)] = (
                laws,
                steps,
            )  # solving again takes long, and the proposal asks for it once more
        return self.again[id(laws)][1]

    def notice(self, laws: Laws) -> str | None:
        """The first check that fails where laws are bent; "" for none, None where no answer changes at all."""
        try:
            bent_steps = self.bent_steps(laws)
        except Contradicted:
            return "derivation"
        steps = bent_steps.equations
        bent: list[BentValues] = []
        changed = False
        for at, spot in enumerate(self.case.spots):
            try:
                now = bent_values(self.case.every, steps, spot)
            except Contradicted:
                return "derivation"
            bent.append(now)
            changed = changed or self._changed(spot, now)
            if not changed:
                continue
            if at == 0 and (by := self._of_the_printed_numbers(spot, now)):
                return by
            if by := self._at(spot, now, laws, bent_steps):
                return by
        if not changed:
            return None
        if by := self._claimed(steps):
            return by
        if by := self._coinciding(bent, steps, laws):
            return by
        return "scene" if self._contradicts_a_scene(bent) else ""

    def _changed(self, spot: MutationSpot, now: BentValues) -> bool:
        """Whether an answer that is asked is another."""
        for found in self.parts.values():
            values, true = now.of(found.find.names), _true(spot, found)
            if values is None or math.dist(values, true) > EXACT * math.hypot(*values, *true):
                return True
        return any(
            _held(options, now) != _held(options, BentValues(spot.letters))
            for _part, options, _wrong in self.options
        )

    def _of_the_printed_numbers(self, spot: MutationSpot, now: BentValues) -> str:
        problem = self.case.solution.problem
        for part_id, numbers in self.expected.items():
            part, values = problem.part(part_id), now.of(self.parts[part_id].find.names)
            zeros = tuple(float(unit.offset) for unit in part.units_for(len(numbers)))
            if (
                values is not None
                and len(values) == len(numbers)
                and difference(in_order(part, numbers), in_order(part, values), zeros)
            ):
                return "expected"
        for entry in self.printed:
            if self._printed_otherwise(entry, spot, now):
                return "printed"
        return ""

    def _printed_otherwise(self, entry: Printed, spot: MutationSpot, now: BentValues) -> bool:
        part = self.case.solution.problem.part(entry.statement.part)
        for part_id, options, _wrong in self.options:
            if part_id == part.id:
                held = _held(options, now)
                return held is not None and held != [entry.text.strip("() ").lower()]
        found = self.parts.get(part.id)
        values = now.of(found.find.names) if found else None
        if values is None or self.key is None:
            return False
        readings = readings_of(part, entry)
        if readings:
            each = zip(values, readings, part.units_for(len(values)), strict=False)
            return any(
                as_printed(value, text, read, unit) in ("differs", "order", "last figure")
                for value, (text, read), unit in each
            )
        return not self.key.truths[part.id].is_met_by(values, APART)

    def _at(self, spot: MutationSpot, now: BentValues, laws: Laws, steps: BentSteps) -> str:
        """A check of the derivation itself that fails at these values."""
        for part_id in self.sized:
            values = now.of(self.parts[part_id].find.names)
            if (
                values is not None
                and len(values) == 1
                and values[0] < 0 <= _true(spot, self.parts[part_id])[0]
            ):
                return "words of the question"
        for found in self.case.every:
            for route in found.find.routes if isinstance(found.entry, Step) else ():
                assert isinstance(found.entry, Step)
                stated = next(each for each in found.entry.routes if each.line == route.stated.line)
                for law, own in zip(stated.laws, route.stated.laws, strict=True):
                    if not self._holds(law, own.here, laws, steps, now, spot):
                        return "route"
        for entry in self.case.entries:
            if isinstance(entry, Confirm):
                for law in entry.laws:
                    if not self._holds(law, self.confirmed[id(law)], laws, steps, now, spot):
                        return "confirm"
            elif isinstance(entry, Forces) and not self._balanced(entry, laws, spot):
                return "forces"
        for conditions in self.always:
            if not now.unknown and any(
                all(fulfilled(one, now.letters) is False for one in clause) for clause in conditions
            ):
                return "always"
        for _part, options, _wrong in self.options:
            held = _held(options, now)
            if held is not None and len(held) != 1:
                return "choice"
        return ""

    def _balanced(self, entry: Forces[Any, Law], laws: Laws, spot: MutationSpot) -> bool:
        """Whether the forces add up to one side of each bent law, or to what its sides differ by; True where it cannot be said."""
        slope = self.case.solution.problem.part(entry.statement.part).slope
        try:
            for balance in entry.balances:
                if id(balance.law) not in laws:
                    continue
                total = ready(sum_along(entry, balance.way, slope), DOUBLES)(spot.letters)
                for relation in laws[id(balance.law)].here:
                    left, right = (
                        ready(side, DOUBLES)(spot.letters) for side in (relation.left, relation.right)
                    )
                    if all(off(each, total) > EXACT for each in (left, right, left - right, right - left)):
                        return False
        except (NotAvailable, *FAILURES):  # NoTree, and a direction that is none, are ValueErrors
            return True
        return True

    def _claimed(self, steps: Mapping[int, BentEquations]) -> str:
        """A claim of a special case, or of a limit, that fails: at the first spot of which it can be said."""
        for claim in self.claims:
            for spot in self.case.spots[:3]:
                holds = self.claim_holds(claim, steps, spot)
                if holds is False:
                    return "at" if isinstance(claim, Special) else "limit"
        return ""

    def claim_holds(
        self, claim: Special | Limit, steps: Mapping[int, BentEquations], spot: MutationSpot
    ) -> bool | None:
        """Whether a claim is met, tried in numbers; None where that cannot be said, or the true values do not meet it."""
        for true, wanted, allowed in self._attempts(claim, spot):
            try:
                now = bent_values(self.case.every, steps, true)
                bent = {name: each(now.letters) for name, each in wanted.items()}
            except Contradicted:
                continue
            except FAILURES:
                continue
            if now.unknown:
                continue
            return not any(off(now.letters[name], value) > allowed for name, value in bent.items())
        return None

    def _attempts(
        self, claim: Special | Limit, spot: MutationSpot
    ) -> list[tuple[MutationSpot, dict[str, Evaluation], float]]:
        """Where a claim can be tried: the true values there, which meet it, what letters must be, and how far off they may be."""
        memo = id(claim), id(spot)
        if memo not in self.tried:
            found: list[tuple[MutationSpot, dict[str, Evaluation], float]] = []
            self.tried[memo] = found
            try:
                attempts = (
                    _special(claim, spot, self.case)
                    if isinstance(claim, Special)
                    else _limit(claim, spot, self.case)
                )
            except (NoTree, NotAvailable, *FAILURES):
                return found
            for there, wanted, allowed in attempts:
                true = spot_at(there, self.case.every)
                if true is not None and _met(true, wanted, allowed / 10):
                    found.append((true, wanted, allowed))
        return self.tried[memo]

    def _holds(
        self,
        law: Law,
        here: Sequence[Relation],
        laws: Laws,
        steps: BentSteps,
        now: BentValues,
        spot: MutationSpot,
    ) -> bool:
        """Whether a law holds at the bent values, as far as it can be said: what does not hold at the true ones says nothing."""
        if id(law) not in self.differential:
            self.differential[id(law)] = law, self.case.resolver is not None and differential(law)
        if self.case.resolver is not None and self.differential[id(law)][1]:
            return self.case.resolver.holds(law, laws, steps, now, spot.letters)
        if id(law) in laws:
            here = laws[id(law)].here
        if id(here) not in self.held:
            try:
                self.held[id(here)] = here, NumericEquations(here, ())
            except NotAvailable:
                self.held[id(here)] = here, None
        equations = self.held[id(here)][1]
        if (
            equations is None
            or equations.letters & now.unknown
            or not equations.letters <= now.letters.keys()
        ):
            return True
        return equations.hold(now.letters) or not equations.hold(spot.letters)

    def _coinciding(self, bent: Sequence[BentValues], steps: Mapping[int, BentEquations], laws: Laws) -> str:
        """Whether nearly no draw could be dealt: on all that are tried a mistake is the truth, or an answer is nothing or absurd."""
        drawn = [
            (spot, now)
            for at, (spot, now) in enumerate(zip(self.case.spots, bent, strict=True))
            if not (at == 0 and self.case.printed)
        ]
        if len(drawn) < AT_LEAST:
            return ""
        reasons = [self._refused(spot, now, steps, laws) for spot, now in drawn]
        return "" if "" in reasons else max(set(reasons), key=reasons.count)

    def _refused(
        self, spot: MutationSpot, now: BentValues, steps: Mapping[int, BentEquations], laws: Laws
    ) -> str:
        problem = self.case.solution.problem
        for part_id, found in self.parts.items():
            values, part = now.of(found.find.names), problem.part(part_id)
            if values is None:
                continue
            if part.plausible and not all(
                part.plausible[0] <= part.unit.from_si(value) <= part.plausible[1] for value in values
            ):
                return "plausible"
            if not any(values) and found.find.scale is None and not part.rows:
                return "no answer"
        for each in self.mistakes:
            if self._coincides(each, spot, now, steps, laws):
                return "mistake"
        return ""

    def _coincides(
        self,
        each: ListedMistake,
        spot: MutationSpot,
        now: BentValues,
        steps: Mapping[int, BentEquations],
        laws: Laws,
    ) -> bool:
        rule, every = self.rules.get(id(each)), self.case.every
        if rule is None or spot.key is None or each.part not in spot.key.truths:
            return False
        own, last = every[each.place], every[each.at]
        truth = now.of(last.find.names)
        if truth is None or now.unknown & own.needs or self.unexchanged[id(each)] & laws.keys():
            return False
        letters = dict(now.letters)
        try:
            letters |= zip(own.find.names, [made(letters) for made in rule], strict=True)
            for place in range(each.place + 1, each.at + 1):
                if each.place in ancestors(self.case.solution, place):
                    found = every[place]
                    if place in steps or not found.rule:
                        return False
                    letters |= zip(found.find.names, [made(letters) for made in found.rule], strict=True)
        except FAILURES:
            return False
        values = tuple(letters[name] for name in last.find.names)
        true = spot.key.truths[each.part]
        if true.scales:
            scaled = tuple(abs(value) for value in truth)
            return replace(true, values=truth, scales=scaled).is_met_by(values, APART)
        return within(values, truth, true.tolerance + APART, math.hypot(*truth) or true.scale)

    def _unexchanged(self, each: ListedMistake) -> set[int]:
        """The laws of its step, by identity, that a mistake keeps: where one of them is bent, what it leads to is another."""
        found = self.case.every[each.place]
        if not isinstance(found.entry, Step):
            return set()
        wanted = each.mistake.line, each.mistake.text
        of = [one for one in found.entry.mistakes if (one.line, one.text) == wanted]
        own = {id(law) for law in found.entry.laws}
        return own & {id(law) for one in of for law in exchanged(found.entry.laws, one)} if of else own

    def _contradicts_a_scene(self, bent: Sequence[BentValues]) -> bool:
        if self.case.loaded.scene is None:
            return False
        by_key = {id(spot.key): now for spot, now in zip(self.case.spots, bent, strict=True)}
        for at, (key, usual) in enumerate(self.case.played):
            now = by_key.get(id(key))
            if now is None or not usual:
                continue
            answers: dict[str, Seen] = {}
            for part in key.truths:
                values = now.of(self.parts[part].find.names)
                if values is None:
                    return False
                answers[part] = values if len(values) != 1 else values[0]
            try:
                wanted = simulations_of(self.case.loaded, key.variant, answers, neglected_in(key))
            except NotDerivable:
                return True
            if len(wanted) != len(usual):
                return True
            for one, (other, played) in zip(wanted, usual, strict=True):
                if _same_scene(one, other):
                    if not all(meets(one, played, name) for name in one.expect):
                        return True
                elif at == 0 and self._played_otherwise(one, answers):
                    return True
        return False

    def _played_otherwise(self, wanted: Simulation, answers: Mapping[str, Seen]) -> bool:
        """Whether a scene that follows from the answers, played anew, contradicts them; False where that is not tried any more."""
        flat = [x for value in answers.values() for x in (value if isinstance(value, tuple) else (value,))]
        memo = (float(wanted.line), *(float(f"{x:.10g}") for x in flat))
        if memo not in self.runs:
            if len(self.runs) >= RUNS:
                return False
            self.runs[memo] = _contradicted(wanted)
        return self.runs[memo]


def _contradicted(wanted: Simulation) -> bool:
    """Whether a scene shows something else, by a run that is as coarse as can be: what it shows is far beyond its errors."""
    try:
        found = (
            run(wanted.scene, wanted.settings, tolerance=COARSE, bank=wanted.bank)
            if isinstance(wanted.scene, str)
            else followed(wanted.scene, wanted.expect.keys(), tolerance=COARSE)
        )
    except (BadSetting, GuardFailed):
        return True
    loose = replace(wanted, neglected=wanted.neglected + BEYOND)
    return not all(meets(loose, found, name) for name in wanted.expect)


Option = bool | list[list[tuple[str, Evaluation, Evaluation]]] | None


def _option(held: object) -> Option:
    """An option's condition ready to be held against letters; None where it joins no relations of formulas."""
    if isinstance(held, bool):
        return held
    try:
        return [[compared(each) for each in way] for way in ways(held)]
    except (ValueError, NotAvailable):
        return None


def _held(options: Mapping[str, Option], now: BentValues) -> list[str] | None:
    """The options that hold; None where that cannot be said."""
    found: list[str] = []
    for letter, each in options.items():
        if each is None:
            return None
        if isinstance(each, bool):
            held = [[each]]
        elif now.unknown:
            return None
        else:
            held = [[fulfilled(one, now.letters) for one in way] for way in each]
        if any(None in way for way in held):
            return None
        if any(map(all, held)):
            found.append(letter)
    return found


def _conditions(condition: object) -> list[list[tuple[str, Evaluation, Evaluation]]]:
    if isinstance(condition, bool):
        return []
    try:
        return [[compared(each) for each in clause] for clause in clauses(condition)]
    except (ValueError, NotAvailable):
        return []


def _true(spot: MutationSpot, found: FindInDoubles) -> Values:
    return tuple(spot.letters[name] for name in found.find.names)


def _met(spot: MutationSpot, wanted: Mapping[str, Evaluation], within: float) -> bool:
    """Whether letters are what they must be."""
    try:
        return all(off(spot.letters[name], value(spot.letters)) <= within for name, value in wanted.items())
    except FAILURES:
        return False


def _same_scene(one: Simulation, other: Simulation) -> bool:
    try:
        return bool(one.scene == other.scene and one.settings == other.settings)
    except ValueError:  # of arrays
        return False


def off(one: float, other: float) -> float:
    if not math.isfinite(one) or not math.isfinite(other):
        return 0.0
    return abs(one - other) / (abs(one) + abs(other)) if one != other else 0.0


Attempts = list[tuple[dict[str, float], dict[str, Evaluation], float]]
"""Givens to try a claim at, what letters must be there, and how far off they may be."""


def _special(claim: Special, spot: MutationSpot, case: MutationCase) -> Attempts:
    givens = {each.symbol for each in case.solution.problem.letters}
    own = {name: spot.letters[name] for name in givens}
    there = {
        name: ready(tree(value), DOUBLES)(spot.letters)
        for name, value in claim.values.items()
        if name in givens
    }
    wanted = {name: ready(tree(value), DOUBLES) for name, value in claim.values.items() if name not in givens}
    exact = [(own | there, wanted, EXACT)]
    near = {name: value + NEAR * (own[name] or 1.0) for name, value in there.items()}
    return [*exact, (own | near, wanted, CLEAR)]


def _limit(claim: Limit, spot: MutationSpot, case: MutationCase) -> Attempts:
    letter, of = claim.letter.name, tree(claim.of)
    own = {each.symbol: spot.letters[each.symbol] for each in case.solution.problem.letters}
    if letter not in own or not isinstance(of, Name):
        return []
    if claim.to.is_infinite:
        sign = 1 if claim.to.is_extended_positive else -1
        tried = [far * abs(own[letter] or 1.0) * sign for far in FAR]
    else:
        tried = [ready(tree(claim.to), DOUBLES)(spot.letters) + NEAR * (own[letter] or 1.0)]
    wanted = {of.name: ready(tree(claim.equals), DOUBLES)}
    return [(own | {letter: there}, wanted, CLEAR) for there in tried]
