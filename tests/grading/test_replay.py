"""A derivation worked out again on numbers, with one rule exchanged: whole, or only what is made of it."""

from __future__ import annotations

from fractions import Fraction

import pytest

from corollary.answers.evaluation import ball_of, balls
from corollary.answers.verdict import Mistaken
from corollary.derive import ready_scenes
from corollary.derive.solution import ClosedForms, SceneOutcome
from corollary.formula.ball import Undefined
from corollary.grading.from_json import from_json
from corollary.grading.judge import judge
from corollary.grading.key import make_key
from corollary.grading.mistakes import wrong_values
from corollary.grading.replay import BY_THE_RULES, WhatIf, ancestors, exchanged, replay, simulated
from corollary.problem.variant import chosen

from .small import solved


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


@pytest.mark.parametrize(
    ("code", "part", "answer"),
    [("X12.10", "b", "0 J"), ("S12.5pi", "c", "0"), ("S12.5two", "c", "0.0 J"), ("E12.3.1s", "d", "0 N")],
)
def test_a_mistake_that_gives_zero_is_met_by_zero_whatever_is_left_where_doubles_cancel(
    key, code, part, answer
):
    made = key(code)
    truth = made.truths[part]
    zero = next(text for values, text in wrong_values(made, truth, BY_THE_RULES) if not any(values))
    ((verdict,), _text) = judge(made, {part: from_json(answer)})[part]
    assert verdict == Mistaken(zero, nothing=True)


def test_a_tiny_value_in_which_nothing_cancels_stays_what_it_is(tmp_path):
    """An energy without its c² is some 1e-17 of the right one; what is fallen through less what it gives is nothing."""
    steps = """
        u, E = unknowns("u E")
        return derivation(
            step(u, "It falls.", law("Fall", "u^2 = 2*g*h", u=u, g=g, h=h), answers="a", where=u > 0),
            step(
                E,
                "At rest.",
                law("Rest energy", "E = m*c^2", c=c, m=m),
                answers="b",
                mistakes=[
                    mistake("Without c.", law("Rest energy", "E = m*u/u", m=m, u=u)),
                    mistake("Of the fall.", law("Rest energy", "E = m*u^2 - 2*m*g*h", m=m, u=u, g=g, h=h)),
                ],
            ),
        )
    """
    givens = """
        m: {is: mass, value: 0.30, unit: kg}
        h: {is: height, value: 1.70, unit: m}
        g: {is: acceleration of gravity, value: 9.81, unit: m/s^2}
        c: {is: speed of light, value: 299792458, unit: m/s}
    """
    solution = solved(tmp_path, givens, "a m/s\nb J", steps, "m, h, g, c")
    made = make_key(solution, chosen(solution.problem, dict[str, Fraction]()))
    found = {text: values for values, text in wrong_values(made, made.truths["b"], BY_THE_RULES)}
    assert found == {"Without c.": (0.3,), "Of the fall.": (0.0,)}


def test_several_observed_values_of_one_scene_are_of_one_run(monkeypatch):
    played = []
    run = ready_scenes.run
    monkeypatch.setattr(
        ready_scenes, "run", lambda name, *rest, **more: played.append(name) or run(name, *rest, **more)
    )
    settings = (("m", 0.61), ("k", 5.3e4), ("v0", -1.37))
    for observe in ("largest_overlap", "duration", "peak_force"):
        simulated("ball_on_floor", settings, observe, "")
    assert played == ["ball_on_floor"]
