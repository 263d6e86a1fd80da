"""Programs for two bodies in a plane: right ones are right, and the chapter's printed signs are told to be wrong."""

import math
import random

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from tests.judges import judges

from corollary.derive.ready_scenes import run
from corollary.derive.statements import Fault, Remark
from corollary.grading.programs.convergence import Called

from .conftest import RIGHT, euler_cromer, forward_euler, two

IONS, closest, ion_force, ion_inputs, judge_ions = judges(
    "collisions/two_ions/judge_ions.py", "IONS closest ion_force ion_inputs judge_ions"
)
SPHERES, judge_spheres, sphere_force, sphere_inputs = judges(
    "collisions/colliding_spheres/judge_spheres.py", "SPHERES judge_spheres sphere_force sphere_inputs"
)
(converged,) = judges("collisions/two_bodies.py", "converged")


def spheres(seed, step=euler_cromer, eta=1.0, **changed):
    cases = sphere_inputs({}, random.Random(seed).uniform)
    forces = [sphere_force(case["R"], case["k"], eta * case["eta"], **changed) for case in cases]
    return judge_spheres(
        {}, [Called(case, tuple(two(case, force, step))) for case, force in zip(cases, forces, strict=True)]
    )


def ions(seed, step=euler_cromer, **changed):
    cases = ion_inputs({}, random.Random(seed).uniform)
    return judge_ions(
        {}, [Called(case, tuple(two(case, ion_force(case["C"], **changed), step))) for case in cases]
    )


@pytest.mark.parametrize("step", RIGHT)
@pytest.mark.parametrize("seed", range(2))
def test_spheres_are_right_by_any_method(step, seed):
    assert spheres(seed, step) is None


@pytest.mark.parametrize("step", RIGHT)
def test_ions_are_right_by_any_method(step):
    assert ions(5, step) is None


@pytest.mark.parametrize("seed", range(3))
def test_forward_euler_is_named(seed):
    for said in (spheres(seed, forward_euler), ions(seed, forward_euler)):
        assert isinstance(said, Fault)
        assert said.known
        assert "forward Euler" in said.sentence


@pytest.mark.parametrize("seed", range(2))
def test_velocities_that_do_not_keep_the_momentum_are_told_so(seed):
    """The second sphere is left with a third of the first one's speed too much, and nothing has pushed it."""

    def told(share):
        calls = []
        for case in sphere_inputs({}, random.Random(seed).uniform):
            ax, ay, bx, by = two(case, sphere_force(case["R"], case["k"], case["eta"]), euler_cromer)
            calls.append(Called(case, (ax, ay, bx + share * math.hypot(*case["vA"]), by)))
        return judge_spheres({}, calls)

    assert told(0.0) is None
    assert "the total momentum is not kept" in told(1 / 3).sentence


WRONG = [
    (spheres, {"spring": 1.0}, "pull each other"), (spheres, {"drag": -1.0}, "braking"), (spheres, {"q": 1.0}, "3/2"),
    (spheres, {"eta": 0.0}, "no damping"), (ions, {"sign": 1.0}, "attract"), (ions, {"power": 2.0}, "division"),
]  # fmt: skip


@pytest.mark.parametrize(("judged", "changed", "words"), WRONG)
@pytest.mark.parametrize("seed", range(3))
def test_signs_and_powers_as_printed_in_12_119_and_other_usual_mistakes_are_known(
    judged, changed, words, seed
):
    said = judged(seed, **changed)
    assert isinstance(said, Fault)
    assert said.known
    assert words in said.sentence


def test_newtons_third_law_is_missed_when_it_is_missing():
    cases = sphere_inputs({}, random.Random(2).uniform)

    def alone(case):
        au, aw, *_ = two({**case, "mB": 1e12}, sphere_force(case["R"], case["k"], case["eta"]))
        return au, aw, *case["vB"]

    said = judge_spheres({}, [Called(case, alone(case)) for case in cases])
    assert isinstance(said, Fault)
    assert said.known
    assert "only A feels a force" in said.sentence


def test_what_the_scene_says_is_right_and_told_to_be_no_stepping():
    def exact(case):
        (ax, ay), (bx, by) = case["rA"], case["rB"]
        settings = {name: case[name] for name in ("mA", "mB", "R", "k", "eta", "vA", "vB")}
        return run("spheres", settings | {"dx": bx - ax, "dy": by - ay}).observed["velocities"]

    cases = sphere_inputs({}, random.Random(4).uniform)
    assert isinstance(judge_spheres({}, [Called(case, exact(case)) for case in cases]), Remark)


def test_three_numbers_are_not_four():
    said = judge_ions(
        {}, [Called(case, (1.0, 2.0, 3.0)) for case in ion_inputs({}, random.Random(1).uniform)]
    )
    assert isinstance(said, Fault)
    assert "four velocities" in said.sentence


def test_the_reference_of_ions_turns_the_relative_velocity_round_and_knows_the_closest_approach():
    case = {
        "C": 0.0012,
        "mA": 0.1,
        "mB": 0.15,
        "rA": (0.0, 0.0),
        "vA": (1.0, 0.0),
        "rB": (0.08, 0.0),
        "vB": (0.0, 0.0),
    }
    au, _, bu, _ = converged(case | {"T": 40.0, "dt": 1e-1}, ion_force(0.0012), 1e-6)
    energy = 0.06 * 1.0**2 / 2 + 0.0012 / 0.08
    assert bu - au == pytest.approx(math.sqrt(2 * energy / 0.06), rel=2e-3)
    assert closest(0.0012, 0.1, 0.15, 0.08, 1.0) == pytest.approx(0.0012 / energy)


def test_the_numbers_drawn_are_a_student_s_own_and_short():
    """Two students have other dampings and distances, none with more figures than one types."""
    drawn = [sphere_inputs({}, random.Random(seed).uniform)[4] for seed in range(8)]
    damped = [case["eta"] for case in drawn]
    assert len(set(damped)) > 4
    assert all(0.5 <= eta <= 1.5 for eta in damped)
    for seed in range(8):
        for case in ion_inputs({}, random.Random(seed).uniform):
            assert case["rB"][0] == round(case["rB"][0], 3)


def ionic(inputs, r):
    return -inputs["C"] / r**3


def pressed(inputs, r):
    return -inputs["k"] * max(2 * inputs["R"] - r, 0.0) ** 1.5 / r


@pytest.mark.parametrize("seed", range(3))
@pytest.mark.parametrize(
    ("drawn", "family", "push"), [(ion_inputs, IONS, ionic), (sphere_inputs, SPHERES, pressed)]
)
def test_what_an_adaptive_method_finds_is_no_error(drawn, family, push, seed):
    """scipy's DOP853 at 1e-11, on the printed equations: the references agree to a millionth."""
    inputs = drawn({}, random.Random(seed).uniform)[2]
    start = [number for name in ("rA", "rB", "vA", "vB") for number in inputs[name]]

    def slope(t, z):
        apart = z[2:4] - z[0:2]
        on_a = push(inputs, math.hypot(*apart)) * apart
        return np.array([*z[4:], *(on_a / inputs["mA"]), *(-on_a / inputs["mB"])])

    span, step = (0.0, inputs["T"]), inputs["T"] / 400
    found = solve_ivp(slope, span, start, "DOP853", rtol=1e-11, atol=1e-13, max_step=step)
    assert max(family.standard(inputs).errors(tuple(map(float, found.y[4:, -1])))) < 1e-6
