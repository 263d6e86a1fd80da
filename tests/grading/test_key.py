"""The key against another library's arithmetic, and what rounding may do to an answer."""

from __future__ import annotations

import math
from fractions import Fraction

import pytest
import sympy

from corollary.derive.solution import ClosedForms
from corollary.formula.ball import Undefined
from corollary.formula.plain_text import text
from corollary.grading.key import make_key
from corollary.grading.replay import WhatIf, replay
from corollary.problem.sampling import sample

CODES = ("X12.5", "X12.7", "X12.8", "X12.10", "P12.14")


def with_sympy(formula: str, values: dict[str, sympy.Expr]) -> float:
    """The nearest double to the value at 60 figures, by mpmath."""
    expression = sympy.parse_expr(
        formula.replace("^", "**"), local_dict={name: sympy.Symbol(name, positive=True) for name in values}
    )
    return float(
        expression.subs({sympy.Symbol(name, positive=True): value for name, value in values.items()}).evalf(
            60
        )
    )


@pytest.mark.parametrize("code", CODES)
def test_certified_values_are_those_of_mpmath(solution, code):
    solved = solution(code)
    for variant in sample(solved.problem, 3, salt="key test"):
        key = make_key(solved, variant)
        known = {name: sympy.Rational(each.ratio) * sympy.pi**each.pi for name, each in variant.exact.items()}
        for truth in key.truths.values():
            in_givens = key.find(truth).in_givens
            if in_givens is None:
                continue
            assert truth.proven
            assert truth.error == 0
            assert truth.values == tuple(with_sympy(text(tree), known) for tree in in_givens)


@pytest.mark.parametrize("code", CODES)
def test_a_replay_by_the_rules_meets_the_key(solution, code):
    solved = solution(code)
    for variant in sample(solved.problem, 3, salt="replay test"):
        key = make_key(solved, variant)
        for found, values in zip(replay(solved, variant.exact), key.values, strict=True):
            assert found == pytest.approx(values, rel=1e-13, abs=1e-300)


def test_a_replay_stops_where_it_is_told(solution):
    solved = solution("X12.5")
    givens = next(sample(solved.problem, 1)).exact
    assert len(replay(solved, givens, until=1)) == 2


def test_what_is_held_is_carried_on(solution, key):
    solved, own = solution("X12.5"), key("X12.5")
    found = replay(solved, own.variant.exact, WhatIf(held={0: (5.0,)}))
    assert [values[0] for values in found[:3]] == pytest.approx([5.0, 5.0, 50.0])
    assert found[3:] == replay(solved, own.variant.exact)[3:]


def test_a_rule_exchanged_changes_what_comes_after(solution, key):
    solved, own = solution("X12.5"), key("X12.5")
    wrong = solved.unknowns[0].mistakes[0].rule  # the kinetic energy in the place of the momentum
    assert isinstance(wrong, ClosedForms)
    found = replay(solved, own.variant.exact, WhatIf(rules={0: wrong}))
    assert found[2][0] == pytest.approx(0.43 * 20**2 / 2 / 0.1)


def test_a_replay_rounds_at_every_step(solution, key):
    solved, own = solution("X12.10"), key("X12.10")
    found = replay(solved, own.variant.exact, WhatIf(rounding=lambda x: float(f"{x:.2e}")))
    assert [float(f"{x:.2e}") for values in found for x in values] == [x for values in found for x in values]
    assert found[-1] != own.values[-1]


def test_what_does_not_exist_is_undefined(solution, key):
    givens = key("X12.5").variant.exact
    with pytest.raises(Undefined):
        replay(solution("X12.5"), givens, WhatIf(held={0: (math.inf,)}))


@pytest.mark.parametrize("code", CODES)
def test_tolerances_keep_their_bounds_and_come_out_the_same_again(solution, code):
    solved = solution(code)
    for variant in sample(solved.problem, 5, salt="tolerance test"):
        key, again = make_key(solved, variant), make_key(solved, variant)
        for part, truth in key.truths.items():
            assert 0.005 <= truth.tolerance <= 0.02
            assert truth.tolerance == again.truths[part].tolerance
            assert truth.tolerance >= min(0.02, truth.noise)
            assert len(truth.uncertain) == len(truth.values)
            if truth.tolerance < 0.02:
                assert max(truth.uncertain) <= (truth.tolerance + 2e-9) * truth.scale


def test_sums_that_cancel_and_g_widen_the_tolerance(key):
    loss = key("X12.10").truths["b"]
    assert loss.tolerance > key("X12.5").truths["a"].tolerance
    square = key("P12.14").truths["c"]  # a height: the square of a rounded speed
    assert square.tolerance > 0.008


@pytest.mark.parametrize(
    ("code", "part", "given", "by_hand", "too_far"),
    [
        # 11.3 - 2.94 - 23.9 = -15.5, / 10.2 = -1.52; 11.3 + 12.3 - 12.0 = 11.6, / 2.1 = 5.52
        ("S12.5gen", "b", {"mA": "8.1", "mB": "2.1", "vA": "1.4", "vB": "-5.7"}, 5.52, 5.44),
        # 2350/1410 = 1.67, ln 1.67 = 0.513, 0.513 * 3600 = 1850
        ("E12.7.2", "a", {"m0": "2350", "m1": "1410", "vrel": "3600", "dv": "1100"}, 1850, 1880),
        # 4300/1750 = 2.46, exp 2.46 = 11.7, 1280/11.7 = 109
        ("E12.7.2", "b", {"m0": "1280", "m1": "320", "vrel": "1750", "dv": "4300"}, 109, 107),
    ],
)
def test_an_answer_rounded_at_every_operation_is_near_enough(key, code, part, given, by_hand, too_far):
    """Worked out with paper and pencil, each number in the comments written down with three figures before it is used."""
    truth = key(code, **given).truths[part]
    assert truth.noise * truth.scale < abs(by_hand - truth.values[0]) <= truth.tolerance * truth.scale
    assert abs(too_far - truth.values[0]) > truth.tolerance * truth.scale


def test_what_decides_whether_numbers_are_drawn_is_the_rounding_of_whole_steps(solution, key):
    """m0/m1 = 1.18 has a logarithm that its last figure moves by 2.5 %: the tolerance stops at 2 %, and the numbers stay."""
    truth = key("E12.7.2", m0="1000", m1="850", dv="3000").truths["a"]
    assert (truth.tolerance, truth.noise < 0.005) == (0.02, True)


def test_the_key_follows_the_numbers_given(key):
    assert key("X12.5", m="0.5").truths["a"].values == (10.0,)
    tiny = key("X12.5", m=str(Fraction(43, 10**152)))
    assert tiny.truths["a"].values[0] == pytest.approx(8.6e-150, rel=1e-15)
