"""Laws with derivatives and integrals bent on purpose: solved again with the slip in them, and held against every check."""

from __future__ import annotations

import pytest

from corollary.problem.bank import Bank
from corollary.problem.reader import read_problem
from corollary.verify.verify import Verification

PROBLEM = """\
---
code: X1.1
title: Honey
given:
  m: {is: mass, value: 2, from: 1, to: 4, step: 0.5, unit: kg}
  b: {is: drag by speed, value: 0.5, from: 0.2, to: 1, step: 0.1, unit: kg/s}
  g: {is: gravity, value: 9.81, from: 9, to: 11, step: 0.25, unit: m/s^2}
  t1: {is: time, value: 3, from: 1, to: 5, step: 0.5, unit: s}
require:
  - m > 0
  - b > 0
  - g > 0
  - t1 > 0
---
A ball of {{m}} falls in honey, which pulls it back with {{b}} times its speed, for {{t1}}; g = {{g}}.

## Speed {#a .value unit="m/s" ATTRIBUTES}
How fast is it?

## Way {#c .value unit="m"}
How far has it come?
"""
SOLUTION = '''\
"""Honey."""

from corollary.author import *
from corollary.laws import *


def derive(m, b, g, t1):
    t = variable("t")
    v = function("v", t)
    r, v1, s = unknowns("r v1 s")
    return derivation(
        step(r, "Drag by mass.", law("Rate", "r = {rate}")),
        step(v1, "Newton.", law("Newton's second law", "{newton}"), law("Released", "v(0) = {start}"),
             law("Asked for", "v1 = v(t1)"), answers="a"{more}),
        step(s, "It adds up.", law("Way", "s = {way}"), answers="c"),
        {claims}
    )
'''
NEWTON = "dv/dt = g - r*v"
TRUE = {"rate": "b/m", "newton": NEWTON, "start": "0", "way": "int(v, t, 0, t1)"}


@pytest.fixture
def checked(tmp_path):
    def verified(claims="", attributes="", more="", until="", **laws):
        for folder in ("problems", "solutions"):
            (tmp_path / folder / "x").mkdir(parents=True, exist_ok=True)
        problem = tmp_path / "problems" / "x" / "honey.md"
        problem.write_text(PROBLEM.replace("ATTRIBUTES", attributes), encoding="utf-8")
        solution = SOLUTION.format(**(TRUE | laws), claims=claims, more=more)
        (tmp_path / "solutions" / "x" / "honey.py").write_text(solution, encoding="utf-8")
        verification = Verification(Bank(tmp_path), read_problem(problem), 20)
        for stage in verification.stages():
            if stage == until:
                break
        return verification.checked()

    return verified


def unnoticed(found, name: str) -> set[str]:
    assert found.complaints == ()
    assert found.mutation.untried == ()
    assert found.mutation.undecided == 0
    return {each.bend for each in found.mutation.unnoticed if each.law == name}


@pytest.mark.whole
def test_a_wrong_sign_or_factor_in_a_differential_equation_is_named_where_nothing_checks_it(checked):
    found = checked()
    assert {"dv/dt = g + r*v", "dv/dt = g - 2*r*v", "dv/dt = 3*g - r*v", "dv/dt = g"} <= unnoticed(
        found, "Newton's second law"
    )
    assert {"s = 2*int(v, t, 0, t1)", "s = (1/2)*int(v, t, 0, t1)"} <= unnoticed(found, "Way")
    assert {"r = 2*(b/m)", "r = 3*(b/m)"} <= unnoticed(found, "Rate")
    assert found.mutation.proposal
    assert found.mutation.caught > 0
    assert "s = -int(v, t, 0, t1)" not in unnoticed(found, "Way"), "how far asks for no sign"


CHECKS = [
    ({"attributes": 'expected="about 20 m/s"'}, "expected", {"newton": "dv/dt = 3*g - r*v"}),
    ({"claims": 'printed("a", "20.7 m/s", "(1)"),'}, "printed", {"newton": "dv/dt = g + r*v"}),
    ({"claims": "limit(v1, t1, oo, m*g/b),"}, "limit", {"newton": "dv/dt = g - 2*r*v"}),
    ({"claims": "at(t1=0, v1=0),"}, "", {"start": "0"}),
    ({"claims": 'confirm("Terminal.", law("No force", "g*m - b*v = m*dv/dt")),'}, "confirm", {"rate": "2*b/m"}),
    ({"claims": 'confirm("Momentum.", law("p", "m*v1 = m*g*t1 - b*s")),'}, "confirm", {"newton": "dv/dt = g + r*v"}),
    ({"claims": 'confirm("Momentum.", law("p", "m*v1 = m*g*t1 - b*s")),'}, "confirm", {"way": "2*int(v, t, 0, t1)"}),
    ({"claims": 'confirm("Released.", law("At rest", "v(0) = 0")),'}, "", {"rate": "b/m"}),
    ({"more": ', routes=[route("Solved.", law("f", "v1 = m*g/b*(1 - exp(-b*t1/m))"))]'}, "route", {"newton": "dv/dt = g - 2*r*v"}),
    ({"more": ", mistakes=[mistake('Drag forgotten.', wrong('dv/dt = g'), instead=\"Newton's second law\")]"}, "mistake", {"newton": "dv/dt = g"}),
    ({"claims": 'always("it falls", v1 > 0),'}, "always", {"newton": "dv/dt = -g - r*v"}),
]  # fmt: skip


@pytest.mark.whole
@pytest.mark.parametrize(("changes", "by", "bent"), CHECKS)
def test_what_is_said_to_be_noticed_verify_itself_complains_of(checked, changes, by, bent):
    found = checked(**changes)
    assert found.complaints == ()
    assert found.mutation.untried == ()
    ((which, law),) = bent.items()
    whole = {"newton": law, "way": f"s = {law}", "rate": f"r = {law}", "start": f"v(0) = {law}"}[which]
    assert whole not in {each.bend for each in found.mutation.unnoticed}
    if by:
        assert found.mutation.by.get(by), found.mutation.by
        assert checked(**changes, **bent).complaints


@pytest.mark.parametrize(
    ("claims", "bent"),
    [
        ("limit(v1, t1, oo, m*g/b),", {"newton": "dv/dt = 2*g - 2*r*v"}),
        ("at(g=0, v1=0),", {"newton": "dv/dt = 2*g - r*v"}),
        ('confirm("Released.", law("At rest", "v(0) = 0")),', {"newton": "dv/dt = g + r*v"}),
        ('confirm("Momentum.", law("p", "m*v1 = m*g*t1 - b*s")),', {}),
    ],
)
@pytest.mark.whole
def test_what_holds_for_a_bent_law_too_does_not_notice_it(checked, claims, bent):
    found = checked(claims=claims)
    assert found.complaints == ()
    assert checked(claims=claims, **bent, until="bent laws").complaints == ()
    for each in bent.values():
        if "2*g - 2" not in each:
            assert each in unnoticed(found, "Newton's second law")
