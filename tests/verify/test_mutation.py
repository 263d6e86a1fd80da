"""Laws bent on purpose: what would be noticed is noticed by verify itself, and what would not is named with a line that would."""

from __future__ import annotations

import json
from collections.abc import Generator
from contextlib import contextmanager
from dataclasses import asdict

import pytest

from corollary.derive.time_limit import TooLong
from corollary.formula.plain_text import text
from corollary.laws.law import law, own_letters
from corollary.problem.bank import Bank
from corollary.problem.reader import read_problem
from corollary.verify.checked import MutationScore, from_data
from corollary.verify.mutation.numeric_roots import NumericEquations
from corollary.verify.mutation.score import bends
from corollary.verify.verify import verify

PROBLEM = """\
---
code: X1.1
title: A sledge
given:
  m: {is: mass, value: 2, from: 1, to: 4, step: 0.5, unit: kg}
  F: {is: force, value: 10, from: 8, to: 14, step: 0.5, unit: N}
  f: {is: friction, value: 3, from: 1, to: 5, step: 0.5, unit: N}
  t: {is: time, value: 3, from: 1, to: 5, step: 0.5, unit: s}
require:
  - m > 0
  - F > 0
  - f > 0
  - t > 0
---
A sledge of {{m}} is pulled with {{F}} against {{f}} for {{t}}.

## Acceleration {#a .value unit="m/s^2" ATTRIBUTES}
What is its acceleration?

## Speed {#b .value unit="m/s"}
What has it at the end?
"""
SOLUTION = '''\
"""A sledge."""

from corollary.author import *
from corollary.laws import *


def derive(m, F, f, t):
    a, v = unknowns("a v")
    return derivation(
        step(a, "Newton.", law("Newton's second law", "m*a = {newton}"), answers="a",
             mistakes=[mistake("Friction is left out.", wrong("m*a = F"))]),
        step(v, "Evenly.", law("Velocity", "{velocity}"), answers="b"{more}),
        {claims}
    )
'''


@pytest.fixture
def checked(tmp_path):
    def verified(newton="F - f", velocity="v = a*t", claims="", attributes="", more="", scene=""):
        for folder in ("problems", "solutions"):
            (tmp_path / folder / "x").mkdir(parents=True, exist_ok=True)
        problem = tmp_path / "problems" / "x" / "sledge.md"
        problem.write_text(PROBLEM.replace("ATTRIBUTES", attributes), encoding="utf-8")
        solution = SOLUTION.format(newton=newton, velocity=velocity, claims=claims, more=more) + scene
        (tmp_path / "solutions" / "x" / "sledge.py").write_text(solution, encoding="utf-8")
        return verify(Bank(tmp_path), read_problem(problem), 20)

    return verified


def unnoticed(found, name: str = "") -> set[str]:
    assert found.complaints == ()
    return {each.bend for each in found.mutation.unnoticed if not name or each.law == name}


def test_every_kind_of_slip_is_bent():
    with own_letters({}):
        stated = law("Pull", "x = 3*y^2 - z*cos(u)", x=1, y=2, z=3, u=4)
    found = {(each.kind, text(each.law.textbook)) for each in bends(stated)}
    assert {
        ("sign", "x = -3*y^2 - z*cos(u)"),
        ("sign", "x = 3*y^2 + z*cos(u)"),
        ("term dropped", "x = 3*y^2"),
        ("term dropped", "x = -z*cos(u)"),
        ("factor 2", "x = 3*y^2 - 2*z*cos(u)"),
        ("factor 1/2", "x = (1/2)*3*y^2 - z*cos(u)"),
        ("factor pi", "x = 3*y^2 - pi*z*cos(u)"),
        ("prefix 10^3", "x = 3*y^2 - 1000*z*cos(u)"),
        ("exponent", "x = 3*y^3 - z*cos(u)"),
        ("exponent", "x = 3*y - z*cos(u)"),
        ("sine for cosine", "x = 3*y^2 - z*sin(u)"),
        ("sign", "x = -(3*y^2 - z*cos(u))"),
        ("factor 2", "x = 2*(3*y^2 - z*cos(u))"),
    } <= found
    assert len(found) == len({bent for _, bent in found}), "each once"


def test_what_nothing_checks_is_named_with_a_line_that_would(checked):
    found = checked()
    assert {"m*a = F + f", "m*a = 2*F - f"} <= unnoticed(found, "Newton's second law")
    assert {"v = 2*a*t", "v = -a*t"} <= unnoticed(found, "Velocity")
    assert "m*a = F" not in unnoticed(found), "that is the mistake, and no draw is left"
    assert found.mutation.by["dimensions"] > 0
    assert found.mutation.noticed + len(found.mutation.unnoticed) == found.mutation.bends
    assert found.mutation.proposal
    assert 0 < found.mutation.caught <= len(found.mutation.unnoticed)
    assert not [note for note in found.notes if "nothing but dimensions" in note]


@pytest.mark.parametrize(
    ("changes", "by", "noticed", "left"),
    [
        ({"attributes": 'expected="about 3 m/s^2"'}, "expected", {"m*a = 3*F - f", "m*a = 1000*F - f"}, {"m*a = F - 2*f"}),
        ({"claims": 'printed("a", "3.5 m/s^2", "(1)"),'}, "printed", {"m*a = F + f", "m*a = F - 2*f"}, {"v = 2*a*t"}),
        ({"claims": "at(f=F, a=0),"}, "at", {"m*a = F + f", "m*a = 2*F - f"}, {"m*a = 2*(F - f)"}),
        ({"claims": "limit(a, m, oo, 0), limit(v, t, 0, 0),"}, "", set(), {"m*a = F + f", "v = 2*a*t"}),
        ({"claims": "limit(a, f, 0, F/m),"}, "limit", {"m*a = 2*F - f"}, {"m*a = F + f"}),
        ({"claims": 'confirm("Momentum.", law("p", "m*v = F*t - f*t")),'}, "confirm", {"m*a = F + f", "v = 2*a*t", "v = -a*t"}, set()),
        ({"more": ', routes=[route("Momentum.", law("p", "m*v = F*t - f*t"))]'}, "route", {"m*a = F + f", "v = 2*a*t"}, set()),
        ({"claims": 'always("it speeds up", a > 0),'}, "always", {"m*a = -F - f"}, {"m*a = F + f"}),
    ],
)  # fmt: skip
def test_each_check_notices_what_it_would_contradict(checked, changes, by, noticed, left):
    found = checked(**changes)
    missed = unnoticed(found)
    assert not noticed & missed
    assert left <= missed
    assert not by or found.mutation.by.get(by), found.mutation.by


@pytest.mark.parametrize(
    ("changes", "bent"),
    [
        ({"attributes": 'expected="about 3 m/s^2"'}, {"newton": "3*F - f"}),
        ({"claims": 'printed("a", "3.5 m/s^2", "(1)"),'}, {"newton": "F + f"}),
        ({"claims": "at(f=F, a=0),"}, {"newton": "2*F - f"}),
        ({"claims": "limit(a, f, 0, F/m),"}, {"newton": "2*F - f"}),
        ({"claims": 'confirm("Momentum.", law("p", "m*v = F*t - f*t")),'}, {"velocity": "v = 2*a*t"}),
        ({"more": ', routes=[route("Momentum.", law("p", "m*v = F*t - f*t"))]'}, {"velocity": "v = 2*a*t"}),
        ({"claims": 'always("it speeds up", a > 0),'}, {"newton": "-F - f"}),
        ({}, {"newton": "F"}),
    ],
)
def test_verify_itself_complains_of_what_is_said_to_be_noticed(checked, changes, bent):
    assert checked(**changes).complaints == ()
    assert checked(**changes, **bent).complaints


def test_a_law_that_is_the_mistake_is_said_to_be_the_likeliest(checked):
    complaints = checked(newton="F").complaints
    assert any("100 % of the draws" in each and "your law may be the mistake" in each for each in complaints)


SCENE = """

def scene(m, F, f, t, answer):
    from corollary.scenes.forces.fields import ForceFunction
    from corollary.scenes.scene import Body, Scene

    pull = ForceFunction(0, lambda time, place, velocity: (F - f,))
    return [simulate(Scene((Body(m, (0.0,), (0.0,)),), (pull,), until=t), velocities=(answer["b"],))]
"""


def test_a_scene_notices_what_changes_its_answer(checked):
    found = checked(scene=SCENE)
    assert found.mutation.by["scene"] > 10
    assert not unnoticed(found)


def test_a_scale_of_both_sides_is_no_bend(checked):
    """What is said of F_net cancels where it is used: the answers stay as they are."""
    found = checked(velocity="v = a*t", claims="")
    with_both = checked(newton="F - f", velocity="v*m = a*t*m")
    assert found.mutation is not None
    assert with_both.mutation is not None
    assert "2*v*m = 2*a*t*m" not in unnoticed(with_both)


def test_a_score_is_kept_as_data(checked):
    found = checked().mutation
    assert from_data(json.loads(json.dumps(asdict(found)))) == found
    assert from_data(None) is None
    assert (
        found.lines[0]
        == found.sentence
        == f"signs and factors: {found.noticed} of {found.bends} bends noticed"
    )
    assert MutationScore(0, 0).sentence == "signs and factors: no law to bend"


@pytest.mark.parametrize(
    ("laws", "unknowns", "letters", "near", "roots"),
    [
        (["a*x = b"], "x", {"a": 2.0, "b": 6.0}, (1.0,), [(3.0,)]),
        (["x^2 = b"], "x", {"b": 9.0}, (1.0,), [(-3.0,), (3.0,)]),
        (["x^2 = -b"], "x", {"b": 9.0}, (1.0,), []),
        (["0 = v*x - a*x^2/2"], "x", {"v": 20 / 3, "a": 1.8}, (7.4,), [(0.0,), (2 * 20 / 3 / 1.8,)]),
        (["x^3 = b"], "x", {"b": 8.0}, (1.0,), [(2.0,)]),
        (["exp(x) = b"], "x", {"b": 8.0}, (1.0,), [(2.0794415416798357,)]),
        (["x + y = a", "x - y = b"], "x y", {"a": 5.0, "b": 1.0}, (1.0, 1.0), [(3.0, 2.0)]),
        (["x + y = a", "x^2 + y^2 = b"], "x y", {"a": 3.0, "b": 5.0}, (1.5, 2.5), [(1.0, 2.0), (2.0, 1.0)]),
        (["x + y = a", "x + y = b"], "x y", {"a": 5.0, "b": 1.0}, (1.0, 1.0), []),
        (["x + y = a", "2*x + 2*y = 2*a"], "x y", {"a": 5.0}, (1.0, 1.0), None),
        (["x*y = a", "x/y = b"], "x y", {"a": 8.0, "b": 2.0}, (3.0, 1.5), [(-4.0, -2.0), (4.0, 2.0)]),
    ],
)
def test_all_roots_are_found_in_numbers(laws, unknowns, letters, near, roots):
    from corollary.formula.syntax import author_formula

    found = NumericEquations([author_formula(each) for each in laws], unknowns.split()).roots(letters, near)
    if roots is None:
        assert found is None
        return
    assert found is not None
    assert sorted(found) == [pytest.approx(each, rel=1e-9) for each in roots]


def test_a_claim_with_an_integral_notices_what_it_contradicts(checked):
    balance = 'confirm("Work.", law("Work", "m*v = int(F - f, x, 0, t)")),'
    found = checked(claims=balance)
    assert found.complaints == ()
    assert found.mutation.by["confirm"] > 0
    assert checked(claims=balance, velocity="v = 2*a*t").complaints


def test_a_law_with_an_integral_is_tried_as_every_other(checked):
    found = checked(velocity="v = int(a, x, 0, t)")
    assert found.mutation.untried == ()
    assert {"v = 2*int(a, x, 0, t)", "v = -int(a, x, 0, t)"} <= unnoticed(found, "Velocity")
    assert {"m*a = F + f"} <= unnoticed(found, "Newton's second law")


def test_laws_that_are_not_tried_are_named_and_not_counted(checked, monkeypatch):
    """What takes too long to solve with a slip in it is said to be checked by nothing, not to be noticed."""

    @contextmanager
    def over_at_once(*_seconds: float) -> Generator[None]:
        raise TooLong("it ran longer than it may")
        yield

    monkeypatch.setattr("corollary.verify.mutation.resolved.time_limit", over_at_once)
    found = checked(velocity="v = int(a, x, 0, t)")
    assert found.complaints == ()
    assert found.mutation.undecided > 0
    (untried,) = found.mutation.untried
    assert untried.startswith("sledge.py:")
    assert untried.endswith(": Velocity")
    assert any("only dimensions check the signs in " + untried in line for line in found.mutation.lines)
    assert not [each for each in found.mutation.unnoticed if each.law == "Velocity"]
