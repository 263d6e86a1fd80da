"""Programs for the atom in the well: right ones are right, each usual wrong one is told so, and the reference is a reference."""

import math
import random

import pytest
from tests.judges import judges

from corollary.derive.ready_scenes import run
from corollary.derive.statements import Fault
from corollary.grading.programs.convergence import Called

from .conftest import RIGHT, euler_cromer, forward_euler, in_well

catch_inputs, judge_catch = judges("projects/catching_an_atom/judge_catch.py", "catch_inputs judge_catch")
Pull, judge_orbit, moved, orbit_inputs, pull_of, start_of = judges(
    "projects/catching_an_atom/judge_orbit.py", "Pull judge_orbit moved orbit_inputs pull_of start_of"
)


def orbits(seed, step=euler_cromer, change=lambda well, case: well):
    cases = orbit_inputs({}, random.Random(seed).uniform)
    ends = [
        in_well(change(pull_of(case), case), start_of(case), case["T"], case["dt"], step) for case in cases
    ]
    return judge_orbit(
        {}, [Called(case, tuple(map(float, end[:2]))) for case, end in zip(cases, ends, strict=True)]
    )


def catches(seed, step=euler_cromer, keeps=0.5, pull=1.0):
    def end(case):
        well = pull_of(case)
        x, y, u, w = in_well(well, start_of(case), case["t1"], case["dt"], step)
        after = Pull(pull * well.stiffness, well.b, well.edge)
        return in_well(after, (x, y, keeps * u, keeps * w), case["T"] - case["t1"], case["dt"], step)[:2]

    cases = catch_inputs({}, random.Random(seed).uniform)
    return judge_catch({}, [Called(case, tuple(map(float, end(case)))) for case in cases])


@pytest.mark.whole
@pytest.mark.parametrize("step", RIGHT)
@pytest.mark.parametrize("seed", range(3))
@pytest.mark.parametrize("judged", [orbits, catches])
def test_any_method_is_right(judged, step, seed):
    assert judged(seed, step) is None


@pytest.mark.parametrize("case", orbit_inputs({}, random.Random(12).uniform)[::2])
def test_half_the_steps_for_the_reference_change_less_than_a_thousandth_of_the_tolerance(case):
    coarse, fine = (moved(pull_of(case), start_of(case), case["T"], least=least)[:2] for least in (200, 400))
    assert math.dist(coarse, fine) < 1e-5 * case["b"]


def test_the_reference_swings_as_long_and_as_far_as_the_scene_says():
    settings = {"m": 2.0, "k": 100.0, "b": 1.0, "d": 0.4, "r0": 1.0, "v0": 3.0}
    seen = run("atom", settings).observed
    x, y, u, w = moved(Pull(50.0, 1.0, 1.4), (1.0, 0.0, 0.0, 3.0), seen["period"], least=2000)
    assert math.hypot(x, y) == pytest.approx(1.0, abs=1e-9)
    assert math.atan2(y, x) == pytest.approx(seen["angle"], abs=1e-8)
    assert math.hypot(u, w) == pytest.approx(3.0, abs=1e-8)


WRONG = [
    (orbits, {"step": forward_euler}, "forward Euler"), (catches, {"step": forward_euler}, "forward Euler"),
    (orbits, {"change": lambda well, case: Pull(-well.stiffness, well.b, well.edge)}, "minus"),
    (orbits, {"change": lambda well, case: Pull(well.stiffness * case["m"], well.b, well.edge)}, "mass is missing"),
    (orbits, {"change": lambda well, case: Pull(well.stiffness, well.b, math.inf)}, "beyond b + d"),
    (orbits, {"change": lambda well, case: Pull(well.stiffness, 0.0, well.edge)}, "relaxed at the distance b"),
    (catches, {"keeps": 1.0}, "velocity is not changed"), (catches, {"keeps": 0.5**0.5}, "kinetic energy"),
    (catches, {"pull": 0.5}, "not the force"), (catches, {"pull": 2.0}, "not the mass"),
]  # fmt: skip


@pytest.mark.parametrize(("judged", "changed", "words"), WRONG)
@pytest.mark.parametrize("seed", range(3))
def test_usual_wrong_programs_are_told_what_is_wrong(judged, changed, words, seed):
    said = judged(seed, **changed)
    assert isinstance(said, Fault)
    assert said.known
    assert words in said.sentence


def test_too_few_numbers_are_told():
    said = judge_orbit({}, [Called(case, (1.0,)) for case in orbit_inputs({}, random.Random(1).uniform)])
    assert isinstance(said, Fault)
    assert "pair" in said.sentence


def test_an_atom_that_is_nowhere_near_is_told_what_to_check():
    cases = orbit_inputs({}, random.Random(1).uniform)
    fault = judge_orbit({}, [Called(case, (50.0 + place, -40.0)) for place, case in enumerate(cases)])
    assert isinstance(fault, Fault)
    assert not fault.known
    assert "not where it should be" in fault.sentence
