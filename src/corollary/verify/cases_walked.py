"""Draws by the case of the solution that they belong to, and cases of which no draw may be assigned."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, field

from corollary.derive.solution import Regime, Solution
from corollary.problem.variant import Variant

MANY = 20  # draws of a case, all refused, are enough where there are more


@dataclass(slots=True)
class CaseDraws:
    """How many draws of a case were tried and assigned, and why others were refused."""

    regime: Regime
    tried: int = 0
    assigned: int = 0
    reasons: Counter[str] = field(default_factory=Counter[str])


class CasesWalked:
    """Counts the draws of each case of a solution."""

    def __init__(self, solution: Solution) -> None:
        self.solution = solution
        self.cases: dict[int, CaseDraws] = {}
        for regime in solution.regimes:
            self.cases.setdefault(regime.place, CaseDraws(regime))

    def count(self, variant: Variant, reason: str) -> None:
        """One draw; `reason` says why it may not be assigned, and is "" where it may."""
        for regime in self.solution.regimes_at(variant.exact) if self.cases else ():
            case = self.cases[regime.place]
            case.tried += 1
            case.assigned += not reason
            if reason:
                case.reasons[reason] += 1

    def never_dealt(self, every: bool) -> Iterator[tuple[int, str]]:
        """The line of each case of which no draw may be assigned, and a sentence; `every`: all draws there are were counted."""
        for case in self.cases.values():
            if case.tried >= (1 if every else MANY) and not case.assigned:
                ((reason, _),) = case.reasons.most_common(1)
                yield (
                    case.regime.line,
                    f"the case {case.regime.text!r} is never dealt: all of its {case.tried} draws are refused ({reason})",
                )
