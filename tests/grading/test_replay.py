"""A derivation worked out again on numbers, with one rule exchanged: whole, or only what is made of it."""

from __future__ import annotations

import pytest

from corollary.answers.evaluation import ball_of, balls
from corollary.derive.solution import ClosedForms, SceneOutcome
from corollary.formula.ball import Undefined
from corollary.grading.replay import WhatIf, ancestors, exchanged, replay


@pytest.mark.parametrize("code", ["T1", "E12.3.1s"])
def test_what_is_made_of_an_exchanged_rule_is_what_the_whole_derivation_gives(key, code):
    """The rule is exchanged for that of an earlier step."""
    made = key(code)
    solution, givens = made.solution, made.variant.exact
    plain = replay(solution, givens)
    known = dict(balls(givens))
    for find, values in zip(solution.unknowns, plain, strict=True):
        known |= zip(find.names, map(ball_of, values), strict=True)
    rules = [find.local for find in solution.unknowns]
    tried = set()
    for place, find in enumerate(solution.unknowns):
        for other in rules[:place]:
            if len(find.names) != len(plain[rules.index(other)]):
                continue
            for until in range(place, len(rules)):
                if until == place or place in ancestors(solution, until):
                    try:
                        whole = replay(solution, givens, WhatIf(rules={place: other}), until)[until]
                    except Undefined:
                        continue
                    assert exchanged(solution, known, place, other, until) == pytest.approx(whole, rel=1e-12)
                    tried.add(type(solution.unknowns[until].local))
    assert ClosedForms in tried
    assert code == "T1" or SceneOutcome in tried
