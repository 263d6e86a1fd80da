"""Warning about pools whose problems earn different points."""

from __future__ import annotations

from corollary.cli.ending import say
from corollary.problem.problem_set import ProblemSet


def warn_of_pools(problem_set: ProblemSet) -> None:
    """The problems of a pool earn different points, so that not every sheet is out of the same."""
    for pool in problem_set.pools:
        dealt = {
            each.code: problem_set.points(each) for each in problem_set.problems if each.code in pool.codes
        }
        if len(set(dealt.values())) > 1:
            each = ", ".join(f"{code} {most:g}" for code, most in dealt.items())
            say(
                f"warning: sheets of {problem_set.name} have different totals, since the problems of a pool have unequal "
                f"points ({each}); make them equal with weight: or points: in the set's file"
            )
