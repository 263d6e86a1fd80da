"""Right programs for a ball on the floor are taken whatever their method; the usual wrong ones are told what is wrong."""

import math
import random

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from tests.judges import judges

from corollary.derive.statements import Fault, Remark
from corollary.grading.programs.convergence import Called

from .conftest import RIGHT, bounce, forward_euler

ARGUMENTS, BOUNCE, bounce_inputs, judge_bounce, reference, wrong_bounce = judges(
    "impulse/ball_on_the_floor_program/judge_bounce.py",
    "ARGUMENTS BOUNCE bounce_inputs judge_bounce reference wrong_bounce",
)

OWN = {"m": 0.1, "k": 1e6, "R": 0.02, "y0": 0.021, "v0": -2.8, "g": 9.8}


def drawn(seed):
    return bounce_inputs({}, random.Random(seed).uniform)


def stepped(m, k, R, y0, v0, g, dt, *, euler=False, weight=1.0, power=1.5):
    """Rows (t, y, v, net force), a little beyond the contact."""
    y, v, rows, touched, after = y0, v0, [], False, 0
    while after < 30:
        squeezed = max(R - y, 0.0)
        touched = touched or squeezed > 0
        after += touched and squeezed == 0
        force = k * squeezed**power - weight * m * g
        rows.append((len(rows) * dt, y, v, force))
        new = v + force / m * dt
        y, v = y + (v if euler else new) * dt, new
    return np.array(rows)


def judged(seed, program):
    return judge_bounce({}, [Called(inputs, tuple(program(inputs))) for inputs in drawn(seed)])


@pytest.mark.parametrize("seed", range(4))
def test_the_reference_is_what_an_adaptive_method_finds(seed):
    for inputs in drawn(seed)[::2]:
        numbers = {name: inputs[name] for name in ARGUMENTS}
        truth = reference(**numbers)
        m, k, R, y0, v0, g = numbers.values()
        touch = -math.sqrt(v0**2 + 2 * g * (y0 - R))

        def up(t, s, R=R):
            return s[0] - R

        up.terminal, up.direction = True, 1
        run = solve_ivp(
            lambda t, s, m=m, k=k, R=R, g=g: [s[1], k * max(R - s[0], 0.0) ** 1.5 / m - g], (0, 1), [R, touch],
            method="DOP853", rtol=1e-10, atol=1e-13, events=[up], max_step=truth.duration / 50,
        )  # fmt: skip
        assert run.t_events[0][0] == pytest.approx(truth.duration, rel=1e-7)
        assert run.y_events[0][0][1] == pytest.approx(truth.velocity, rel=1e-8)


@pytest.mark.parametrize("step", RIGHT)
@pytest.mark.parametrize("interpolated", [False, True])
@pytest.mark.parametrize("seed", range(2))
def test_right_programs_are_right_by_any_method_and_however_they_read_crossings(step, interpolated, seed):
    assert judged(seed, lambda inputs: bounce(inputs, step, interpolated)) is None


def test_a_program_that_does_not_step_with_dt_is_right_and_told():
    def exact(inputs):
        truth = reference(**{name: inputs[name] for name in ARGUMENTS})
        return truth.velocity, truth.force, truth.duration

    assert isinstance(judged(3, exact), Remark)
    said = judged(3, lambda inputs: (1.1 * exact(inputs)[0], *exact(inputs)[1:]))
    assert isinstance(said, Fault)
    assert "uses its own step" in said.sentence


@pytest.mark.parametrize(
    ("wrong", "word"), [({"step": forward_euler}, "Euler"), ({"weight": 0.0}, "ravity"), ({"power": 1.0}, "spring")],
)  # fmt: skip
@pytest.mark.parametrize("seed", range(5))
def test_the_usual_wrong_programs_are_named(wrong, word, seed):
    said = judged(seed, lambda inputs: bounce(inputs, **wrong))
    assert isinstance(said, Fault)
    assert said.known
    assert word in said.sentence


def test_the_force_of_the_floor_is_not_the_net_force():
    def program(inputs):
        v, force, duration = bounce(inputs)
        return v, force + inputs["m"] * inputs["g"], duration

    said = judged(0, program)
    assert isinstance(said, Fault)
    assert "weight" in said.sentence


def test_a_contact_not_waited_for_with_the_shorter_step_is_told():
    def program(inputs):
        """Right with the longer step; with the shorter one it runs out of steps on the way down."""
        return bounce(inputs) if inputs in drawn(0)[::2] else (0.3, 0.0, 0.0)

    said = judged(0, program)
    assert isinstance(said, Fault)
    assert "fixed number of steps" in said.sentence


@pytest.mark.parametrize(
    "answer", [[], [1.0], [2.8, 249.0], [-2.8, 0.0, 0.0], [0.0, 0.0, 0.0], [math.nan] * 3, [math.inf] * 3]
)
def test_nonsense_is_refused_with_a_sentence(answer):
    said = judged(1, lambda inputs: answer)
    assert isinstance(said, Fault)
    assert said.sentence.endswith(".")


def test_a_velocity_that_is_still_the_first_is_told():
    def not_stepped(inputs):
        truth = reference(**{name: inputs[name] for name in ARGUMENTS})
        return inputs["v0"], truth.force, truth.duration

    fault = judged(3, not_stepped)
    assert isinstance(fault, Fault)
    assert "still the one at the start" in fault.sentence


def test_what_is_allowed_is_a_few_percent_of_the_velocity_and_of_the_force():
    """The book's method errs by a percent and less with a hundred steps in a contact: eight times that is the bound."""
    for inputs in drawn(2):
        velocity, force, _time = BOUNCE.standard(inputs).allowed(Called(inputs, (0.0, 0.0, 0.0)))
        assert velocity < 0.1
        assert force < 0.1


def test_the_force_of_the_floor_is_the_net_force_and_the_weight():
    """Of a wrong program that returns it, not even a newton is missing where the weight is five."""
    found = wrong_bounce("floor", 0.5, 3e4, 0.03, 0.032, -0.4, 9.8, 1e-6)
    assert found is not None
    truth = reference(0.5, 3e4, 0.03, 0.032, -0.4, 9.8)
    assert found[1] == pytest.approx(truth.force + 0.5 * 9.8, rel=2e-3)
