"""Programs for a row of balls: right by any method that converges, told by what halving the step does, and usual mistakes known."""

import random

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from tests.judges import judges

from corollary.derive.ready_scenes import run
from corollary.derive.statements import Fault, Remark
from corollary.grading.programs.convergence import OWN_STEPS, STEPS, Called
from corollary.programs import contact_time

from .conftest import RIGHT, forward_euler, row

CRADLE, bounds, cradle_inputs, judge_contact, judge_cradle = judges(
    "projects/newtons_cradle/judge_cradle.py", "CRADLE bounds cradle_inputs judge_contact judge_cradle"
)


def judged(program, seed=0):
    return judge_cradle(
        {},
        [
            Called(inputs, tuple(map(float, program(inputs))))
            for inputs in cradle_inputs({}, random.Random(seed).uniform)
        ],
    )


def exact(inputs):
    return run("cradle", {name: inputs[name] for name in ("N", "m", "k", "q", "v0")}).observed["velocities"]


@pytest.mark.parametrize("step", RIGHT)
@pytest.mark.parametrize("seed", range(3))
def test_right_programs_by_any_method_are_right(step, seed):
    assert judged(lambda inputs: row(inputs, step), seed) is None


@pytest.mark.parametrize("method", ["RK45", "DOP853", "LSODA"])
@pytest.mark.parametrize("stepped", [True, False])
def test_a_solver_of_scipy_with_its_usual_tolerance_is_right(method, stepped):
    def program(inputs):
        n, m, k, q = (inputs[name] for name in ("N", "m", "k", "q"))

        def slope(t, y):
            force = k * np.clip(y[: n - 1] - y[1:n], 0, None) ** q / m
            return np.concatenate([y[n:], np.append(0, force) - np.append(force, 0)])

        until, start = 3 * contact_time(m, k, q, inputs["v0"]), np.zeros(2 * n)
        start[n] = inputs["v0"]
        return solve_ivp(
            slope, (0, until), start, method=method, max_step=inputs["dt"] if stepped else np.inf
        ).y[n:, -1]

    said = judged(program, 1)
    assert said is None if stepped and method != "LSODA" else not isinstance(said, Fault)


def test_a_closed_form_is_right_and_told_that_it_does_not_step():
    said = judged(exact)
    assert isinstance(said, Remark)
    assert "changes nothing" in said.sentence


def test_errors_that_stay_or_fall_too_slowly_are_told_and_cost_nothing():
    def off(order):
        def program(inputs):
            steps = contact_time(inputs["m"], inputs["k"], inputs["q"], inputs["v0"]) / inputs["dt"]
            truth = np.array(exact(inputs))
            (bound,) = bounds(inputs["N"], inputs["q"])
            shift = bound.allowed(STEPS) * 0.2 * inputs["v0"] * (STEPS / steps) ** (order or 1e-3)
            return truth + shift * np.array([1.0, -1.0] + [0.0] * (inputs["N"] - 2)) / 2**0.5

        return program

    stays, slow = judged(off(0)), judged(off(1))
    assert isinstance(stays, Remark)
    assert isinstance(slow, Remark)
    assert "does not reduce the error" in stays.sentence
    assert "first order" in slow.sentence
    assert judged(off(2)) is None


@pytest.mark.parametrize(
    ("wrong", "words"),
    [
        ({"step": forward_euler}, "forward Euler"),
        ({"sign": -1.0, "most": 250}, "sign of the force"),
        ({"both": 0.0}, "half of the pair forces"),
    ],
)
@pytest.mark.parametrize("seed", range(4))
def test_usual_wrong_programs_are_known(wrong, words, seed):
    said = judged(lambda inputs: row(inputs, **wrong), seed)
    assert isinstance(said, Fault)
    assert said.known
    assert words in said.sentence


def test_what_grows_beyond_all_numbers_is_known():
    said = judged(lambda inputs: [float("inf")] * inputs["N"])
    assert isinstance(said, Fault)
    assert said.known
    assert "Check the sign" in said.sentence


def test_a_step_too_large_of_ones_own_is_told():
    said = judged(lambda inputs: row(inputs, dt=60 * max(inputs["dt"], 2e-5)))
    assert isinstance(said, Fault)
    assert "uses its own step" in said.sentence or "step is small enough" in said.sentence


def test_a_fixed_number_of_steps_is_right_with_one_step_and_told_with_the_other():
    def program(inputs):
        known = contact_time(inputs["m"], inputs["k"], inputs["q"], inputs["v0"])
        return (
            row(inputs) if known / inputs["dt"] < 1.5 * STEPS else [inputs["v0"] / inputs["N"]] * inputs["N"]
        )

    said = judged(program)
    assert isinstance(said, Fault)
    assert "fixed number of steps" in said.sentence


def test_a_shift_that_half_the_step_does_not_shrink_is_wrong_once_it_is_beyond_the_bound():
    def program(inputs):
        return np.array(exact(inputs)) * (
            1 - 1.5 * bounds(inputs["N"], inputs["q"])[0].allowed(STEPS) * (1 + inputs["dt"])
        )

    assert isinstance(judged(program), Fault)


def test_the_bound_shrinks_with_the_step_and_stays_below_what_a_program_without_steps_may_err():
    for balls, q in ((2, 1.0), (3, 1.0), (3, 1.5), (4, 1.5)):
        (bound,) = bounds(balls, q)
        assert bound.order == 2
        assert bound.allowed(25) / bound.allowed(50) == pytest.approx(4)
        assert bound.allowed(2 * STEPS) < bound.allowed(STEPS) < OWN_STEPS / 5


def test_a_contact_is_judged_by_what_it_does():
    given = {"m": 0.1, "v0": 1.0}
    assert judge_contact(given, [Called({}, (1e9, 6.0))]) is None
    soft = judge_contact(given, [Called({}, (1e9, 1.0))])
    assert soft is not None
    assert "middle ball keeps" in soft.sentence
    for nonsense in ((1.0,), (-1.0, 2.0), (1e9, 0.5), (float("nan"), 2.0)):
        assert judge_contact(given, [Called({}, nonsense)]) is not None


def test_the_safety_factor_is_what_right_methods_need_and_no_more():
    worst = 0.0
    for inputs in cradle_inputs({}, random.Random(9).uniform):
        standard = CRADLE.standard(inputs)
        for step in RIGHT:
            call = Called(inputs, tuple(map(float, row(inputs, step))))
            worst = max(worst, standard.errors(call.returned)[0] / standard.allowed(call)[0])
    assert 0.3 < worst < 0.7
