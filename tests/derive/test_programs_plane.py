"""Programs for two bodies in a plane: right ones are right, and the chapter's printed signs are told to be wrong."""

import math
import random

import pytest

from corollary.derive.programs_plane import (
    converged,
    ion_force,
    ion_inputs,
    judge_ions,
    judge_spheres,
    sphere_force,
    sphere_inputs,
    stepped,
)
from corollary.scene.catalogue import run

DICE = random.Random(7)
SPHERES = [case for _ in range(4) for case in sphere_inputs({}, DICE.uniform)]
IONS = [case for _ in range(4) for case in ion_inputs({}, DICE.uniform)]


def force_of(case, **changed):
    return sphere_force(case["R"], case["k"], case["eta"], **changed)


@pytest.mark.parametrize("case", SPHERES)
def test_the_method_of_the_book_is_right_for_spheres(case):
    assert judge_spheres({}, case, stepped(case, force_of(case))) is None


@pytest.mark.parametrize("case", SPHERES)
def test_stepping_ever_finer_leads_where_the_scene_leads(case):
    (ax, ay), (bx, by) = case["rA"], case["rB"]
    settings = {name: case[name] for name in ("mA", "mB", "R", "k", "eta", "vA", "vB")}
    seen = run("spheres", settings | {"dx": bx - ax, "dy": by - ay}).observed["velocities"]
    assert math.dist(converged(case, force_of(case), 1e-5), seen) < 5e-4


PRINTED = [({"spring": 1.0}, "pull each other"), ({"drag": -1.0}, "braking"), ({"q": 1.0}, "3/2")]


@pytest.mark.parametrize(("changed", "words"), PRINTED)
def test_the_signs_and_the_power_as_printed_in_12_119_are_known_mistakes(changed, words):
    case = SPHERES[2]
    said = judge_spheres({}, case, stepped(case, force_of(case, **changed)))
    assert said is not None
    assert said.known
    assert words in said.sentence


def test_newtons_third_law_is_missed_when_it_is_missing():
    said = judge_spheres({}, SPHERES[1], stepped(SPHERES[1], force_of(SPHERES[1]), both=False))
    assert said is not None
    assert "only A feels a force" in said.sentence


@pytest.mark.parametrize("case", IONS)
def test_ions_right_attracting_and_falling_off_too_slowly(case):
    assert judge_ions({}, case, stepped(case, ion_force(case["C"]))) is None
    for wrong, words in ((ion_force(case["C"], sign=1.0), "attract"), (ion_force(case["C"], power=2.0), "division")):
        said = judge_ions({}, case, stepped(case, wrong))
        assert said is not None
        assert words in said.sentence


def test_ions_head_on_turn_the_relative_velocity_round():
    case = {"C": 0.0012, "mA": 0.1, "mB": 0.15, "rA": (0.0, 0.0), "vA": (1.0, 0.0), "rB": (0.08, 0.0), "vB": (0.0, 0.0)}
    au, _, bu, _ = converged(case | {"T": 40.0, "dt": 1e-2}, ion_force(0.0012), 1e-5)
    energy = 0.06 * 1.0**2 / 2 + 0.0012 / 0.08
    assert bu - au == pytest.approx(math.sqrt(2 * energy / 0.06), rel=2e-3)
