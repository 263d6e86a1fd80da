"""Obligations of small problems: what is proven for all numbers, by whom, and the numbers where something does not hold."""

from __future__ import annotations

from dataclasses import replace

import pytest

from corollary.formula.syntax import author_formula
from corollary.problem.conditions import relations
from corollary.problem.reader import read_problem
from corollary.verify import laws
from corollary.verify.obligations import nonlinear, settle
from corollary.verify.obligations.box import Box
from corollary.verify.obligations.obligation import Obligation

RIVER = """\
---
code: X1.1
title: A boat
given:
  m: {is: mass, value: 0.5, from: 0.2, to: 0.9, step: 0.1, unit: kg}
  v: {is: speed of the boat, value: 3, from: 1, to: 9, step: 0.1, unit: m/s}
  t: {is: speed of the water, value: 1.5, from: 1, to: 2.2, step: 0.1, unit: m/s}
%s---
A boat crosses a river.

## Speed {#a .value unit="m/s"}
How fast does it cross?
"""
CROSSING = """\
(u,) = unknowns("u,")
return derivation(step(u, "Pythagoras.", law("Velocities", "u^2 = v^2 - t^2/4", u=u, v=v, t=t), where=u >= 0, answers="a"%s))
"""
METER = """\
---
code: X1.1
title: Carts
given:
  m: {is: mass, value: 0.5, from: 0.2, to: 0.9, step: 0.1, unit: kg}
  v: {is: speed of A, value: 3, from: 1, to: 5, step: 0.1, unit: m/s}
  t: {is: speed of B afterwards, value: 2, from: 1, to: %s, step: 0.1, unit: m/s}
---
Two carts of mass m meet; B was at rest.

## Velocity {#a .value unit="m/s"}
How fast is A afterwards?
"""
MEETING = """\
(u,) = unknowns("u,")
return derivation(
    step(u, "Momentum.", conservation_of_momentum(before=[(m, v), (m, 0)], after=[(m, u), (m, t)]),
         answers="a", scale=v))
"""


def of_kind(checked, kind: str) -> list:
    return [each for each in checked.obligations if each.kind == kind]


def test_everything_is_proven_of_a_sound_problem(verified):
    checked = verified()
    assert checked.ok, checked.complaints
    assert {each.outcome for each in checked.obligations} == {"proven"}
    kinds = {each.kind for each in checked.obligations}
    assert kinds == {"laws hold", "value exists", "one root", "not zero", "mistake apart"}


def test_a_root_of_a_negative_number_is_found_with_its_numbers(verified):
    """Where the boat does 1 m/s and the water more than 2 m/s: at 2 of 1053 points."""
    checked = verified(CROSSING % "", problem=RIVER % "")
    assert not checked.ok
    (found,) = [each for each in of_kind(checked, "value exists") if each.outcome == "counter-example"]
    assert float(found.numbers["v"]) < float(found.numbers["t"]) / 2
    assert any(each.startswith("cart.py:9: ") and "would exclude" in each for each in checked.complaints)


def test_a_condition_that_excludes_it_is_enough(verified):
    checked = verified(CROSSING % "", problem=RIVER % "where:\n  - v > t/2\n")
    assert checked.ok, checked.complaints
    assert {each.outcome for each in of_kind(checked, "value exists")} == {"proven"}
    assert {each.outcome for each in of_kind(checked, "one root")} == {"proven"}


def test_without_z3_the_same_is_settled(verified, monkeypatch):
    monkeypatch.setattr(settle, "installed", lambda: False)
    checked = verified(CROSSING % "", problem=RIVER % "where:\n  - v > t/2\n")
    assert checked.ok, checked.complaints
    assert {each.by for each in checked.obligations if each.outcome == "proven"} <= {
        "algebra",
        "subdivision",
        "enumeration",
    }


@pytest.mark.parametrize(
    ("claim", "holds"),
    [
        ("v^2 + t^2 >= 2*v*t", True),
        ("v*t < 20 m^2/s^2", True),
        ("sin(v/t)^2 < v/t*v/t + 1", True),
        ("v > t", False),
    ],
)
def test_z3_decides(tmp_path, claim, holds):
    (tmp_path / "x.md").write_text(RIVER % "", encoding="utf-8")
    problem = read_problem(tmp_path / "x.md")
    ((need, _),) = relations(claim, {given.symbol: given.unit for given in problem.givens})
    found = nonlinear.no_exception(Box(problem), (need,))
    assert (found is True) == holds
    if not holds:
        assert isinstance(found, dict)  # the grid point next to what was found


def test_numbers_that_make_a_mistake_right_are_redrawn(verified):
    """Half of t² equals t at t = 2 only."""
    wrong = ',\n    mistakes=[mistake("No half.", law("Velocities", "u^2 = v^2 - t^2/(1 + v/v)^2*(v/t)^2*4/9", u=u, v=v, t=t))]'
    checked = verified(CROSSING % wrong, problem=RIVER % "where:\n  - v > t/2\n")
    (found,) = of_kind(checked, "mistake apart")
    assert (found.outcome, found.by.split(" (")[0]) == ("sampled", "redrawn otherwise")
    assert found.numbers


@pytest.mark.parametrize(("most", "ok"), [("1", True), ("5", False)])
def test_kinetic_energy_that_is_created(verified, most, ok):
    """B cannot be faster than A was."""
    checked = verified(MEETING, problem=METER % most)
    assert checked.ok == ok, checked.complaints
    energy = [each for each in of_kind(checked, "not created") if "energy" in each.claim]
    assert [each.outcome for each in energy] == ["proven" if ok else "counter-example"]
    assert all(float(each.numbers["t"]) > float(each.numbers["v"]) for each in energy if not ok)


@pytest.mark.parametrize(
    ("sign", "outcomes"), [(">=", ["proven"]), ("<=", ["counter-example"])], ids=["speed", "no speed"]
)
def test_a_speed_is_not_negative(verified, sign, outcomes):
    """The part asks how fast: the other root of the same equation is no answer to that."""
    checked = verified(
        CROSSING.replace("u >= 0", f"u {sign} 0") % "", problem=RIVER % "where:\n  - v > 1.15 m/s\n"
    )
    signs = of_kind(checked, "claimed sign")
    assert [each.outcome for each in signs] == outcomes
    assert signs[0].claim == "part a is not negative, for it asks 'how fast'"
    assert checked.ok == (sign == ">="), checked.complaints


@pytest.mark.parametrize(
    ("claim", "outcomes"),
    [
        ("u < v", ["proven"]),
        ("(u < v) & (u > 0)", ["proven"]),
        ("u > v/2", ["counter-example"]),
        ("'u < v'", ["proven"]),
        ("'(v - t)/(v - t) > 0'", ["counter-example"]),  # a factor that cancels, and is zero at v = t
        ("(v - t)/(v - t) > 0", ["undecided"]),  # sympy has cancelled it before anybody can look
    ],
)
def test_what_the_statement_says_of_all_numbers(verified, claim, outcomes):
    """The boat is slower for all numbers; more than half as fast it is not, where t² is more than 3v²."""
    always = f'), always("it is slower than in still water", {claim}))'
    crossing = CROSSING.replace('"u,"', '"u"').replace("%s))", always)
    checked = verified(crossing, problem=RIVER % "where:\n  - v > 1.15 m/s\n")
    found = of_kind(checked, "claimed")
    assert [each.outcome for each in found] == outcomes
    assert checked.ok == (outcomes != ["counter-example"]), checked.complaints
    if not checked.ok:
        assert "it does not hold that it is slower than in still water: " in checked.complaints[0]
        t, v = (float(found[0].numbers[name]) for name in "tv")
        assert t == v if "- t" in claim else t**2 >= 3 * v**2


LEVER = """\
---
code: X1.1
title: A lever
given:
  m: {is: first force, value: 5, from: 1, to: 9, step: 1, unit: N}
  v: {is: second force, value: 2, from: 1, to: 9, step: 1, unit: N}
  t: {is: length, value: 2, from: 1, to: 4, step: 0.5, unit: m}
%s---
Two forces act on opposite sides of a rod.

## Place {#a .value unit="m"}
Where does it not turn?
"""
BALANCE = """\
(x,) = unknowns("x")
return derivation(step(x, "The torques balance.", law("Balance of torques", "%s"), answers="a"%s))
"""


@pytest.mark.parametrize(
    ("law", "where", "outcome", "equal"),
    [
        ("(m - v)*x = (m - v)*t/2", "", "counter-example", True),
        ("(m - v)*x = (m - v)*t/2", "where:\n  - m > v\n", "proven", False),
        ("m*x = v*(t - x)", "", "proven", False),
        ("(m - v)*exp(x/t) = 3*(m - v)", "", "counter-example", True),
        ("m*exp(x/t) = 3*(m + v)", "", "proven", False),
        ("(m - v)*x^2 = (m - v)*t^2", "", "counter-example", True),
    ],
)
def test_a_coefficient_that_vanishes_leaves_more_than_one_root(verified, law, where, outcome, equal):
    """Linear in x, but at m = v every x fulfils it."""
    condition = ", where=x > 0" if "^2" in law else ""
    checked = verified(BALANCE % (law, condition), problem=LEVER % where)
    (found,) = of_kind(checked, "one root")
    assert found.outcome == outcome, (found, checked.complaints)
    if equal:
        assert found.numbers["m"] == found.numbers["v"]
        assert any("would exclude that" in each for each in checked.complaints)


def test_of_no_numbers_nothing_is_proven(verified):
    checked = verified(BALANCE % ("m*x = v*(t - x)", ""), problem=LEVER % "require:\n  - m > m + v\n")
    assert not checked.ok
    assert {each.outcome for each in checked.obligations} == {"undecided"}


@pytest.mark.parametrize(
    "claim",
    ["(v - t)/(v - t) > 0", "v*sqrt(-1) - v*sqrt(-1) = 0", "sin(sqrt(-2/3)) <= v", "sqrt(t - v)^2 >= 0"],
)
def test_what_has_no_value_does_not_hold(tmp_path, claim):
    (tmp_path / "x.md").write_text(RIVER % "", encoding="utf-8")
    settling = settle.Settling(Box(read_problem(tmp_path / "x.md")))
    found = settling.settle(Obligation("claimed", "it", 1, ((author_formula(claim),),)))
    assert (found.outcome, bool(found.numbers)) == ("counter-example", True)


def test_an_empty_clause_is_proven_by_nobody(tmp_path):
    """No relation of none holds, whatever z3 has proven before."""
    (tmp_path / "x.md").write_text(RIVER % "", encoding="utf-8")
    settling = settle.Settling(Box(read_problem(tmp_path / "x.md")))
    found = settling.settle(Obligation("claimed", "it", 1, ((),)))
    assert found.outcome == "counter-example"
    assert found.numbers


ON_ONE_LINE = """\
u, w = unknowns("u w")
return derivation(step(u, "Half.", law("Half", "u = t/2")), step(w, "As fast.", law("Same", "w = v"), answers="a"))
"""


@pytest.mark.parametrize("other", ["u", "w"])
def test_two_steps_on_one_line_have_outcomes_of_their_own(verified, monkeypatch, other):
    put_back = laws.put_laws_back

    def only_at_points(solvers):
        return [replace(each, how="points") if each.names == (other,) else each for each in put_back(solvers)]

    monkeypatch.setattr(laws, "put_laws_back", only_at_points)
    found = of_kind(verified(ON_ONE_LINE, problem=RIVER % ""), "laws hold")
    assert len({each.line for each in found}) == 1
    outcomes = {each.claim: each.outcome for each in found}
    assert outcomes == {
        f"the laws of {name} hold for what is found": "sampled" if name == other else "proven"
        for name in "uw"
    }


IN_CASES = """\
(u,) = unknowns("u")
def found(formula):
    return step(u, "So.", law("Speed", formula), answers="a")
return derivation(cases(case("slow", 2*t <= v, found("u = t/2")), case("fast", 2*t > v, found("u = t"))))
"""


def test_two_cases_on_one_line_have_outcomes_of_their_own(verified, monkeypatch):
    put_back = laws.put_laws_back

    def only_at_points(solvers):
        return [replace(each, how="points") if each.case == "fast" else each for each in put_back(solvers)]

    monkeypatch.setattr(laws, "put_laws_back", only_at_points)
    checked = verified(IN_CASES, problem=RIVER % "")
    found = of_kind(checked, "laws hold")
    assert [(each.case, each.outcome) for each in found] == [("slow", "proven"), ("fast", "sampled")], (
        checked.complaints
    )
