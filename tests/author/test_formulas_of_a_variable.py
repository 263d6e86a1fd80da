"""Parts that ask for a formula of a variable: no number is dealt for it, and what is claimed holds on its whole domain."""

from __future__ import annotations

import re

import pytest

from corollary.answers.verdict import word
from corollary.api import judge, solve
from corollary.derive.load import NotDerivable
from corollary.grading.key_record import key_record
from corollary.grading.solutions import Solutions
from corollary.problem.bank import Bank, find
from corollary.problem.count import variants
from corollary.problem.diagnostic import Malformed
from corollary.problem.variant import chapter
from corollary.verify.verify import verify

PROBLEM = """\
---
code: N1.1
title: A cart slows down
given:
  v0: {is: speed at first, value: 6, from: 2, to: 9, step: 1, unit: m/s}
  tau: {is: time constant, value: 4, from: 2, to: 5, step: 0.1, unit: s}
variables:
  t: {is: time, from: 0, to: 20, unit: s}
require: [v0 > 0, tau > 0]
---
A cart has a speed of {{v0}} at first, which fades with a time constant of {{tau}}.

## Speed {#a .expression of="t" unit="km/h" points=2}
Which speed, in km/h, has it at the time $t$?

## Way {#b .value unit="m" points=1}
How far does it come in all?
"""
SOLUTION = """\
A cart that is slowed down by the air.

## (a) v(t)

The air brakes it in proportion to its speed.

- law: Drag, `tau*dv/dt = -v`
- law: Speed at first, `v(0) = v0`
- always: it gets no faster `v <= v0`
- mistake: The speed does not fall evenly. `v = v0*(1 - t/tau)` instead of "Drag" and "Speed at first"
- mistake: It is slowed down, not sped up. `tau*dv/dt = v` instead of "Drag"

## (b) s

The way is the integral of the speed.

- law: Way, `s = v0*tau`
- mistake: The speed is not constant. `s = v0*tau/2`
- mistake: That is the mean of two ways. `s = 2*v0*tau`
"""


@pytest.fixture
def bank(tmp_path):
    def put(*changes: tuple[str, str]) -> Bank:
        texts = {"problems/cart.md": PROBLEM, "solutions/cart.md": SOLUTION}
        for old, new in changes:
            assert any(old in text for text in texts.values())
            texts = {name: text.replace(old, new) for name, text in texts.items()}
        for name, text in texts.items():
            (tmp_path / name).parent.mkdir(exist_ok=True)
            (tmp_path / name).write_text(text, encoding="utf-8")
        return Bank(tmp_path)

    return put


def test_the_function_that_is_solved_answers_the_part_and_has_no_number(bank):
    solutions = Solutions(bank())
    problem = find(solutions.bank, "N1.1")
    found = key_record(solve(problem), chapter(problem))
    assert set(found["parts"]["a"]) == {"unit", "expression", "domain"}
    assert (found["parts"]["a"]["unit"], found["parts"]["a"]["domain"]) == ("m/s", {"t": [0.0, 20.0]})
    assert found["given"].keys() == chapter(problem).values.keys() == {"v0", "tau"}
    assert variants(problem) == (8 * 31, True)
    worked = solutions.worked_solution(chapter(problem))
    (numbers,) = re.findall(r"With the numbers:\s+\$\$(.*)\$\$", worked)
    assert numbers.startswith("v(t) = ")
    assert numbers.count("=") == 1
    assert numbers.count("t") > 2


@pytest.mark.parametrize(
    ("answer", "verdict"),
    [
        ("v0*exp(-t/tau)", "right"),
        ("v(t) = v0 e^(-t/tau)", "right"),
        ("21.6*exp(-t/4)", "right"),  # 6 m/s, in the unit of the part
        ("21.6*exp(-0.25 t)", "right"),
        ("v0*(1 - t/tau)", "mistaken"),
        ("21.6*(1 - t/4)", "mistaken"),
        ("6*exp(-t/4)", "wrong"),
        ("v0*exp(-2*t/tau)", "wrong"),
        ("v0", "wrong"),
        ("21.6", "unread"),
        ("v0*exp(-t)", "unread"),
    ],
)
def test_formulas_in_letters_and_in_own_numbers_are_marked_alike(bank, answer, verdict):
    (part, _other) = judge(find(bank(), "N1.1"), {"a": answer}).parts
    assert word(part.verdict) == verdict


@pytest.mark.parametrize(
    ("change", "line", "words"),
    [
        (('.expression of="t"', '.expression of="x"'), 13, "x: {is: "),
        (('.expression of="t"', ".expression"), 8, 'of="t"'),
        (('.expression of="t"', '.value of="t"'), 13, "ask for an .expression"),
        (("from: 0, to: 20", "from: 0"), 8, "`to`"),
        (("from: 0, to: 20", "from: 20, to: 20"), 8, "from must be less than to"),
        (("from: 0, to: 20", "value: 3, from: 0, to: 20"), 8, "no number is dealt for it"),
        (("  t: {is", "  tau: {is"), 8, "tau is a given, too"),
        (("at the time $t$", "at {{t}}"), 14, "$t$"),
        (("tau > 0]", "tau > 0, t > 0 s]"), 9, "variables:"),
    ],
)
def test_what_is_wrong_with_a_variable_is_said_with_line_and_remedy(bank, change, line, words):
    with pytest.raises(Malformed) as caught:
        solve(find(bank(change), "N1.1"))
    assert len(caught.value.complaints) == 1, caught.value.complaints
    assert caught.value.complaints[0].line == line
    assert words in caught.value.complaints[0].sentence


def test_a_number_cannot_depend_on_a_variable(bank):
    with pytest.raises(NotDerivable, match=r'cart\.md:\d+: part b: it depends on t, .*of="t".*v\(t1\)'):
        solve(find(bank(("`s = v0*tau`", "`s = v*tau`")), "N1.1"))


@pytest.mark.parametrize(
    ("claim", "outcome"),
    [
        ("v > 0", "proven"),
        ("t <= 5*v0*tau/v0", "counter-example"),
        ("v >= 0.02*v0", "counter-example"),  # exp(-20/4) is 0.007: it fails late in the domain only
        ("(t - tau)^2 > (tau/100000)^2", "not proven"),  # it fails in a sliver that no grid meets
        ("(t + tau)^2 > (tau/2)^2", "proven"),
    ],
)
def test_what_is_claimed_is_proven_on_the_whole_domain_or_not_at_all(bank, claim, outcome):
    bank_of_claim = bank(("it gets no faster `v <= v0`", f"it is so `{claim}`"))
    checked = verify(bank_of_claim, find(bank_of_claim, "N1.1"), 10)
    (found,) = [each for each in checked.obligations if each.kind == "claimed"]
    assert (found.outcome != "proven") if outcome == "not proven" else (found.outcome == outcome), found
    if outcome == "counter-example":
        assert "t" in found.numbers
        assert not checked.ok
