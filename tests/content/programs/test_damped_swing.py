"""A program of an example bank, judged by a file of that bank: right by any method that converges, and usual mistakes named."""

from __future__ import annotations

import random
from pathlib import Path

import pytest
from scipy.integrate import solve_ivp

from corollary.derive.statements import Code
from corollary.grading.solutions import Solutions
from corollary.problem.bank import Bank, find
from corollary.programs import Called, Fault, Remark

from .conftest import RIGHT, euler_cromer, forward_euler

PACKAGE = Path(__file__).parents[3] / "examples" / "banks" / "corollary-mechanics"
BANK = Bank(PACKAGE / "src" / "corollary_mechanics")


@pytest.fixture(scope="module")
def program() -> Code:
    entries = Solutions(BANK).of(find(BANK, "OSC.4")).entries
    (found,) = (each for each in entries if isinstance(each, Code))
    return found


def said(program: Code, move, seed=0) -> Fault | Remark | None:
    cases = program.inputs({}, random.Random(seed).uniform)
    return program.judge({}, [Called(each, tuple(map(float, move(**each)))) for each in cases])


def by(step, drag=1.0):
    def move(m, k, b, x, v, T, dt):
        for _ in range(round(T / dt)):
            x, v = step(lambda x, v: -(k * x + drag * b * v) / m, x, v, dt)
        return x, v

    return move


@pytest.mark.parametrize("step", RIGHT)
@pytest.mark.parametrize("seed", range(3))
def test_any_method_that_converges_is_right(program, step, seed):
    assert not isinstance(said(program, by(step), seed), Fault)


def test_a_solver_with_steps_of_its_own_is_right(program):
    def move(m, k, b, x, v, T, dt):
        return solve_ivp(lambda _t, y: [y[1], -(k * y[0] + b * y[1]) / m], (0, T), [x, v], rtol=1e-8).y[:, -1]

    found = said(program, move)
    assert isinstance(found, Remark)
    assert "Halving `dt` changes nothing" in found.sentence


@pytest.mark.parametrize(
    ("move", "words"),
    [
        (by(euler_cromer, drag=0.0), "The drag is missing"),
        (by(euler_cromer, drag=-1.0), "The drag drives the swing"),
        (by(forward_euler), "This is forward Euler"),
    ],
)
@pytest.mark.parametrize("seed", range(3))
def test_a_usual_mistake_is_named(program, move, words, seed):
    fault = said(program, move, seed)
    assert isinstance(fault, Fault)
    assert fault.known
    assert words in fault.sentence


def test_what_is_none_of_them_is_wrong(program):
    found = said(program, lambda **given: (given["x"], given["v"]))
    assert found.sentence.endswith(
        "Place and velocity after the time T are not right: check the two forces, and that you reach T."
    )
    assert not found.known
    assert said(program, lambda **given: (1.0,)).sentence == (
        "It returns one number; return the pair of place and velocity (x, v)."
    )
