"""The solutions of a bank, each solved once while a command runs."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from functools import partial

from corollary.derive.cache import solution_of
from corollary.derive.load import source
from corollary.derive.solution import Solution
from corollary.derive.translated import translated
from corollary.derive.worked_solution import whole, worked_steps
from corollary.grading.assign import AssignedVariant, assign_variant
from corollary.grading.key import Key, make_key
from corollary.grading.neglect import neglects
from corollary.messages import spoken
from corollary.problem.bank import Bank
from corollary.problem.problem import Problem
from corollary.problem.translation import text_in_language
from corollary.problem.variant import Variant


def worked_steps_of(key: Key) -> Sequence[str]:
    """The worked solution of a variant as Markdown, step by step."""
    left_out = [(each.most, each.share) for each in neglects(key)]
    return worked_steps(key.solution, key.variant, key.values, key.choices, left_out)


@dataclass(slots=True)
class Solutions:
    """Solutions by the code of their problem; solved when first asked for."""

    bank: Bank
    known: dict[str, Solution] = field(default_factory=dict[str, Solution])

    def of(self, problem: Problem) -> Solution:
        """Solved at the first call, or recalled from an earlier command; its texts in the language spoken then. Raises NotDerivable."""
        problem = problem.as_written
        if problem.code not in self.known:
            found = solution_of(self.bank, problem)
            self.known[problem.code] = (
                found if spoken() == "en" else translated(found, partial(text_in_language, problem))
            )
        return self.known[problem.code]

    def source(self, problem: Problem) -> bytes:
        """The solution's text, to tell whether it has changed. Raises NotDerivable."""
        return source(self.bank, problem)

    def key(self, variant: Variant) -> Key:
        """Raises NotDerivable, and Undefined where an answer does not exist."""
        return make_key(self.of(variant.problem), variant)

    def assign_variant(
        self, problem: Problem, secret: bytes, student: str, in_use: Iterable[int]
    ) -> AssignedVariant:
        """`in_use` are the indices of other students' variants. Raises NotDerivable and NoVariant."""
        return assign_variant(self.of(problem), secret, student, in_use)

    def worked_solution(self, variant: Variant) -> str:
        """The worked solution with these numbers, as Markdown."""
        return self.worked_solution_of(self.key(variant))

    def worked_solution_of(self, key: Key) -> str:
        """The same, where the key is at hand."""
        return whole(worked_steps_of(key))

    def __reduce__(self):
        """Sent to another process it is found again there: programs are functions of a file, and do not travel."""
        return Solutions, (self.bank,)
