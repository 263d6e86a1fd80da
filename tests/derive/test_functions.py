"""Functions of time found from laws with derivatives and integrals; what each comes to is held against quadrature or a textbook."""

from __future__ import annotations

import math
from fractions import Fraction

import pytest
from scipy.integrate import solve_ivp
from tests.derive.conftest import problem_of

from corollary.derive.put_back import put_laws_back
from corollary.derive.solve import solve, solved_derivation
from corollary.derive.worked_solution import worked_solution
from corollary.formula.ball import RationalPi, certified
from corollary.formula.plain_text import text
from corollary.grading.key import make_key
from corollary.problem.variant import chapter
from corollary.verify.verify import verify

SPEED = '## Speed {#a .value unit="m/s"}\n?\n'
PLACE = '## Place {#a .value unit="m"}\n?\n'
FRONT = """\
code: X1.1
title: A body
given:
  m: {is: mass, value: 2, from: 1, to: 4, step: 0.5, unit: kg}
  b: {is: drag, value: 0.5, from: 0.2, to: 1, step: 0.1, unit: UNIT}
  g: {is: gravity, value: 9.81, unit: m/s^2}
  t1: {is: time, value: 3, from: 1, to: 5, step: 0.5, unit: s}
require:
  - m > 0
  - b > 0
  - g > 0
  - t1 > 0
"""
OPENING = """\
\"\"\"A body.\"\"\"
from corollary.author import *
from corollary.laws import *

def derive(m, b, g, t1):
    t = variable("t")
    v, x = function("v", t), function("x", t)
    v1, s, T = unknowns("v1 s T")
    return derivation(step(ASKED, "So.", LAWS, answers="a"))
"""
NUMBERS = {"m": 2.0, "b": 0.5, "g": 9.81, "t1": 3.0}


def whole(asked: str, *laws: str) -> str:
    stated = ", ".join(f'law("Law {place}", "{formula}")' for place, formula in enumerate(laws))
    return OPENING.replace("ASKED", asked).replace("LAWS", stated)


@pytest.fixture
def value(solved):
    def of(asked: str, *laws: str, asks: str = SPEED, unit: str = "kg/s") -> float:
        found = solved(whole=whole(asked, *laws), asks=asks, front=FRONT.replace("UNIT", unit))
        givens = {name: RationalPi(Fraction(str(number))) for name, number in NUMBERS.items()}
        return certified(found.answer("a").in_givens[0], givens).value

    return of


def simulated(rate, y0: tuple[float, ...]) -> tuple[float, ...]:
    """The state after 3 s, in small steps."""
    return tuple(solve_ivp(rate, (0, 3), y0, rtol=1e-11, atol=1e-12).y[:, -1])


@pytest.mark.parametrize(
    ("law", "unit", "rate"),
    [
        ("m*dv/dt = m*g - b*v", "kg/s", lambda t, v: 9.81 - 0.25 * v),
        ("d(m*v)/dt = m*g - b*v", "kg/s", lambda t, v: 9.81 - 0.25 * v),
        ("m*dv/dt = m*g - b*v^2", "kg/m", lambda t, v: 9.81 - 0.25 * v**2),
        ("m*dv/dt = -m*g/10 - b*v^2/100", "kg/m", lambda t, v: -0.981 - 0.0025 * v**2),
        ("dv/dt = g*sin(t/t1) - b*v/m", "kg/s", lambda t, v: 9.81 * math.sin(t / 3) - 0.25 * v),
    ],
)
def test_a_velocity_is_what_small_steps_give(value, law, unit, rate):
    found = value("v1", law, "v(0) = g*t1/10", "v1 = v(t1)", unit=unit)
    assert found == pytest.approx(simulated(rate, (2.943,))[0], rel=1e-8)


@pytest.mark.parametrize(
    ("law", "rate"),
    [
        ("m*d2x/dt2 = -b*x/t1", lambda t, y: (y[1], -0.5 / 3 / 2 * y[0])),
        ("m*d2x/dt2 = -b*dx/dt - m*x/t1^2*100", lambda t, y: (y[1], -0.25 * y[1] - 100 / 9 * y[0])),
        ("m*d2x/dt2 = -9*m/t1*dx/dt - m*x/t1^2", lambda t, y: (y[1], -3 * y[1] - y[0] / 9)),
        ("d2x/dt2 = -2/t1*dx/dt - x/t1^2", lambda t, y: (y[1], -2 / 3 * y[1] - y[0] / 9)),
        ("m*d2x/dt2 = m*g - b*dx/dt", lambda t, y: (y[1], 9.81 - 0.25 * y[1])),
        ("d2x/dt2 = g*t/t1", lambda t, y: (y[1], 9.81 * t / 3)),
    ],
)
def test_a_place_is_what_small_steps_give(value, law, rate):
    found = value("s", law, "v = dx/dt", "x(0) = g*t1^2/100", "v(0) = g*t1/10", "s = x(t1)", asks=PLACE)
    assert found == pytest.approx(simulated(rate, (0.8829, 2.943))[0], rel=1e-8)


COUPLED = {
    "between two walls": (
        ("m*d2x/dt2 = -9*b*x - b*(x - y)", "m*d2y/dt2 = -b*(y - x) - 9*b*y"),
        lambda t, u: (u[2], u[3], (-9 * u[0] - u[0] + u[1]) / 4, (-9 * u[1] - u[1] + u[0]) / 4),
    ),
    "two masses that nothing else holds": (
        ("m*d2x/dt2 = -b*(x - y)", "m*d2y/dt2 = -b*(y - x)"),
        lambda t, u: (u[2], u[3], (u[1] - u[0]) / 4, (u[0] - u[1]) / 4),
    ),
    "unlike masses, and weight": pytest.param(
        ("m*d2x/dt2 = -9*b*x - b*(x - y) + m*g", "3*m*d2y/dt2 = -b*(y - x) + 3*m*g"),
        lambda t, u: (u[2], u[3], (-10 * u[0] + u[1]) / 4 + 9.81, (u[0] - u[1]) / 12 + 9.81),
        marks=pytest.mark.whole,
    ),
    "the same damping": pytest.param(
        ("m*d2x/dt2 = -9*b*x - b*(x - y) - m/t1*dx/dt", "m*d2y/dt2 = -b*(y - x) - 9*b*y - m/t1*dy/dt"),
        lambda t, u: (
            u[2],
            u[3],
            (-10 * u[0] + u[1]) / 4 - u[2] / 3,
            (-10 * u[1] + u[0]) / 4 - u[3] / 3,
        ),
        marks=pytest.mark.whole,
    ),
}


@pytest.mark.parametrize(("laws", "rate"), COUPLED.values(), ids=COUPLED)
def test_two_functions_of_coupled_equations_are_what_small_steps_give(solved, laws, rate):
    """Two bodies on springs: their places after 3 s, from places and velocities that are all different."""
    start = (
        "x(0) = g*t1^2/100",
        "y(0) = 0",
        "v = dx/dt",
        "v(0) = g*t1/10",
        "w = dy/dt",
        "w(0) = -g*t1/30",
        "s = y(t1)",
    )
    text_of = whole("s", *laws, *start)
    text_of = text_of.replace(
        'v, x = function("v", t), function("x", t)', 'v, w, x, y = (function(n, t) for n in "vwxy")'
    )
    found = solved(whole=text_of, asks=PLACE, front=FRONT.replace("UNIT", "N/m"))
    givens = {name: RationalPi(Fraction(str(number))) for name, number in NUMBERS.items()}
    here = certified(found.answer("a").in_givens[0], givens).value
    assert here == pytest.approx(simulated(rate, (0.8829, 0.0, 2.943, -0.981))[1], rel=1e-7)


CIRCUITS = {
    "two loops with a common resistor": (
        ("m*dv/dt = g*m - b*v - b*(v + w)", "m*dw/dt = -b*w - b*(v + w)"),
        lambda t, u: (9.81 - (2 * u[0] + u[1]) / 4, -(u[0] + 2 * u[1]) / 4),
    ),
    "one that swings": pytest.param(
        ("m*dv/dt = g*m - b*v - 9*m/t1*w", "dw/dt = v/t1 - b*w/(9*m)"),
        lambda t, u: (9.81 - u[0] / 4 - 3 * u[1], u[0] / 3 - u[1] / 36),
        marks=pytest.mark.whole,
    ),
}


@pytest.mark.parametrize(("laws", "rate"), CIRCUITS.values(), ids=CIRCUITS)
def test_two_functions_of_first_order(solved, laws, rate):
    """As currents in two loops, or a current and a voltage, are."""
    text_of = whole("s", *laws, "v(0) = 0", "w(0) = 0", "s = w(t1)").replace(
        'v, x = function("v", t), function("x", t)', 'v, w = function("v", t), function("w", t)'
    )
    found = solved(whole=text_of, asks=SPEED, front=FRONT.replace("UNIT", "kg/s"))
    givens = {name: RationalPi(Fraction(str(number))) for name, number in NUMBERS.items()}
    here = certified(found.answer("a").in_givens[0], givens).value
    assert here == pytest.approx(simulated(rate, (0.0, 0.0))[1], rel=1e-7)


def test_a_time_is_asked_for(value):
    asks = '## Half {#a .value unit="s"}\n?\n'
    assert value("T", "m*dv/dt = -b*v", "v(0) = g*t1", "v(T) = g*t1/2", asks=asks) == pytest.approx(
        4 * math.log(2)
    )


def test_a_beginning_is_asked_for(value):
    assert value("v1", "dv/dt = -g", "v(0) = v1", "v(t1) = 0") == pytest.approx(29.43)


def test_both_ends_of_a_way_fix_it(value):
    found = value("v1", "d2x/dt2 = -g", "x(0) = 0", "x(t1) = 0", "v = dx/dt", "v1 = v(0)")
    assert found == pytest.approx(9.81 * 1.5)


def test_a_force_is_integrated_over_time(value):
    asks = '## Impulse {#a .value unit="N*s"}\n?\n'
    found = value("v1", "x = m*g*sin(pi*t/t1)", "v1 = int(x, t, 0, t1)", asks=asks)
    assert found == pytest.approx(2 * 9.81 * 3 * 2 / math.pi)


def test_a_quotient_of_letters_stays_one(solved):
    found = solved(
        'dt, dp = t, unknown("dp")\nreturn derivation(step(p, "So.", law("A", "p = dp/dt*dt", dt=t, dp=m*v), answers="a"))'
    )
    assert text(found.answer("a").local.trees[0]) == "m*v"


@pytest.mark.parametrize(
    ("laws", "said"),
    [
        (("m*dv/dt = m*g - b*v", "v1 = v(t1)"), "add the initial value of v, such as v(0) = …"),
        (("v1 = v(t1)",), "these laws do not determine v(t)"),
        (("dv/dt = g", "v(0) = 0", "v1 = v*t1"), "t is not a number here; say where, as in v(0)"),
        (("v1 = d(m*g)/dt", "dv/dt = g", "v(0) = 0"), "g*m does not depend on t"),
        (("m*d2x/dt2 = -b*x*g", "v1 = x(t1)", "x(0) = 0"), "too few laws"),
        (("v1 = int(g, t)",), "an integral is int(what, letter, from, to)"),
        (("v1 = b(t1)",), "b is not a function; write * for a product, or say what it depends on"),
        (("v1 = foo(t1)",), "foo(…) is not a function here"),
        (("dv/dt = -x*g/t1", "dx/dt = v^2/g"), "only linear ones with constant coefficients"),
        (
            ("m*dv/dt = b*x", "m*dx/dt = -b*v", "v(0) = 0"),
            "for v and x is of order 2 and needs 2 initial values",
        ),
        (("m*d2v/dt = 4*g",), "as often above the line as below it"),
        (("(dv/dt)^2 = g^2", "v(0) = 0", "v1 = v(t1)"), "stands in a power or a root"),
        pytest.param(
            ("dv/dt = g*exp(-(t/t1)^2)*ln(1 + t/t1)", "v(0) = 0", "v1 = v(t1)"),
            "has no closed form",
            marks=pytest.mark.whole,
        ),
    ],
)
def test_faults_are_said_at_the_step(make, refused, laws, said):
    line, sentence = refused(whole=whole("v1", *laws), asks=SPEED, front=FRONT.replace("UNIT", "kg/s"))
    assert line == 9
    assert said in sentence


def test_what_decides_the_kind_of_motion_may_not_differ_among_the_draws(refused):
    laws = (
        "m*d2x/dt2 = -10*b*dx/dt - m*x/(1.7*t1^2)*9",
        "v = dx/dt",
        "x(0) = 0",
        "v(0) = g*t1",
        "v1 = v(t1)",
    )
    _line, sentence = refused(whole=whole("v1", *laws), asks=SPEED, front=FRONT.replace("UNIT", "kg/s"))
    assert "bound them by require:" in sentence


def test_it_verifies_and_the_worked_solution_shows_the_function(make):
    laws = ("m*dv/dt = m*g - b*v", "v(0) = 0", "v1 = v(t1)")
    bank = make(whole=whole("v1", *laws), asks=SPEED, front=FRONT.replace("UNIT", "kg/s"))
    problem = problem_of(bank)
    checked = verify(bank, problem, 3)
    assert checked.complaints == ()
    assert checked.checks["dimensions"] == 4 - 1  # of every law, and none of the answer
    assert [each.complaint for each in put_laws_back(solved_derivation(bank, problem).solvers)] == [""] * 3
    solution = solve(bank, problem)
    key = make_key(solution, chapter(problem))
    told = worked_solution(solution, chapter(problem), key.values, {}, ())
    assert r"\frac{\mathrm{d} v}{\mathrm{d}t}" in told
    assert "(linear, of first order)" in told
    assert r"$$v(t) = " in told


def test_an_ohm_that_is_a_farad_is_seen_in_a_differential_equation(make):
    bank = make(
        whole=whole("v1", "m*dv/dt = m*g - b*v", "v(0) = 0", "v1 = v(t1)"),
        asks=SPEED,
        front=FRONT.replace("UNIT", "kg/m"),
    )
    (complaint,) = verify(bank, problem_of(bank), 3).complaints
    assert "the dimensions do not fit" in complaint
