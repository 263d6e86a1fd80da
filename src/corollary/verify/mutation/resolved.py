"""Steps with derivatives or integrals, their laws bent and solved again by the derivation's own solver."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

from corollary.derive.again import Functions, OtherRoots, SolvedAgain, functions_of
from corollary.derive.assumptions import FoundFunction
from corollary.derive.statements import Optimum, Step
from corollary.derive.time_limit import TooLong, time_limit
from corollary.formula.arithmetics import DOUBLES, NotAvailable, ready
from corollary.formula.ast import Relation, names
from corollary.laws.law import Law
from corollary.verify.mutation.numeric_roots import FAILURES, SAME, NumericEquations, Values
from corollary.verify.mutation.spots import BentEquations, BentValues, Contradicted, FindInDoubles

SOLVING_S, SOLVING_WALL_S = 10.0, 30.0
"""Seconds of the processor, and on the wall, for one step with one bend: what takes longer is left undecided."""


@dataclass(frozen=True, slots=True)
class Replacement:
    """A bent law that stands in the place of another, and its equations in the letters of the problem."""

    law: Law
    here: tuple[Relation, ...]


Laws = Mapping[int, Replacement]
"""Bent laws by the identity of the law: what is stated once may stand in several places."""


class RootFormulas:
    """The roots of a step as formulas in the letters found before it."""

    angular = False

    def __init__(self, unknowns: Sequence[str], found: OtherRoots):
        """Raises NotAvailable where a formula has no doubles."""
        self.unknowns = tuple(unknowns)
        self.letters = frozenset(name for root in found.formulas for one in root for name in names(one))
        self.letters -= {"pi"}
        self.formulas = [[ready(one, DOUBLES) for one in root] for root in found.formulas]

    def roots(self, letters: Mapping[str, float], near: Values) -> list[Values] | None:
        """The roots that have a value, each once."""
        found: list[Values] = []
        for each in self.formulas:
            try:
                root = tuple(one(letters) for one in each)
            except FAILURES:
                continue
            apart = all(math.dist(root, other) > SAME * math.hypot(*root, *other) for other in found)
            if all(map(math.isfinite, root)) and (apart or not found):
                found.append(root)
        return found


@dataclass(slots=True)
class BentSteps:
    """The equations of the steps that bent laws change, by place, and the functions that are another with them, by name; `written`
    are laws in which these are put in, by the identity of the law."""

    equations: dict[int, BentEquations] = field(default_factory=dict[int, BentEquations])
    functions: dict[str, FoundFunction] = field(default_factory=dict[str, FoundFunction])
    written: dict[int, list[NumericEquations]] = field(default_factory=dict[int, list[NumericEquations]])


class Resolver:
    """The steps of a derivation with derivatives or integrals, each solved again for a bend that changes it."""

    def __init__(self, again: SolvedAgain, every: Sequence[FindInDoubles]):
        self.again, self.every = again, every
        self.written: dict[int, tuple[Law, list[NumericEquations]]] = {}

    def bent_steps(self, laws: Laws) -> BentSteps:
        """The steps with derivatives or integrals that bent laws change.

        Raises Contradicted where one cannot be solved, as the derivation could not, and NotAvailable where it was not tried to the
        end.
        """
        steps, changed = BentSteps(), set[str]()
        for found in self.every:
            entry = found.entry
            bent = isinstance(entry, Step) and any(id(law) in laws for law in entry.laws)
            if isinstance(entry, Step) and found.place in self.again.differential:
                instead = [laws[id(law)].law if id(law) in laws else law for law in entry.laws]
                if self.again.takes_formulas(found.place, instead, changed):
                    raise NotAvailable("a formula that is bent is derived or integrated")
                if bent or steps.functions.keys() & functions_of(instead):
                    steps.equations[found.place] = self._solved(found, entry, instead, steps)
                    bent = True
            elif isinstance(entry, Optimum) and functions_of(entry) & steps.functions.keys():
                raise NotAvailable("an extremum of a function that is bent")
            if bent or found.needs & changed:
                changed.update(found.own)
        return steps

    def _solved(
        self, found: FindInDoubles, entry: Step, laws: Sequence[Law], steps: BentSteps
    ) -> RootFormulas:
        try:
            with time_limit(SOLVING_S, SOLVING_WALL_S):
                roots = self.again.roots(found.place, laws, steps.functions)
        except TooLong as error:
            raise NotAvailable("it takes too long to solve") from error
        except ValueError as error:  # of the solver: the derivation would say so
            raise Contradicted(str(error)) from error
        if roots.functions and entry.also and len(roots.formulas) > 1:
            raise NotAvailable("which of several functions is meant is not said")
        steps.functions |= roots.functions
        return RootFormulas(found.own, roots)

    def holds(
        self, law: Law, laws: Laws, steps: BentSteps, now: BentValues, true: Mapping[str, float]
    ) -> bool:
        """Whether a law with derivatives, integrals or functions holds at the bent values, as far as it can be said: what cannot be
        written out, or does not hold at the true ones, says nothing."""
        if id(law) not in self.written:
            self.written[id(law)] = law, self._written_out(law, {})
        usual = self.written[id(law)][1]
        if id(law) not in steps.written:
            bent = laws[id(law)].law if id(law) in laws else law
            same = bent is law and not steps.functions
            steps.written[id(law)] = usual if same else self._written_out(bent, steps.functions)
        return not any(
            not (other.letters & now.unknown)
            and other.letters <= now.letters.keys()
            and not other.hold(now.letters)
            and one.hold(true)
            for one, other in zip(usual, steps.written[id(law)], strict=False)
        )

    def _written_out(self, law: Law, functions: Functions) -> list[NumericEquations]:
        """The equations of a law at some moments; none where it cannot be written so."""
        try:
            with time_limit(SOLVING_S, SOLVING_WALL_S):
                return [NumericEquations([each], ()) for each in self.again.written_out(law, functions)]
        except (ValueError, NotAvailable, TooLong):  # NoTree among them
            return []
