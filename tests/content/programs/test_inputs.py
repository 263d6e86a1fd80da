"""What students' programs are called with: the cases that were promised, in the sizes of a laboratory and of the scenes."""

import math
import random
from functools import cache

import numpy as np
import pytest
from tests.judges import judges

from .conftest import two

(catch_inputs,) = judges("projects/catching_an_atom/judge_catch.py", "catch_inputs")
(bounce_inputs,) = judges("impulse/ball_on_the_floor_program/judge_bounce.py", "bounce_inputs")
(ion_inputs,) = judges("collisions/two_ions/judge_ions.py", "ion_inputs")
ORBIT, moved, orbit_inputs, pull_of, start_of = judges(
    "projects/catching_an_atom/judge_orbit.py", "ORBIT moved orbit_inputs pull_of start_of"
)
(cradle_inputs,) = judges("projects/newtons_cradle/judge_cradle.py", "cradle_inputs")
(sphere_inputs,) = judges("collisions/colliding_spheres/judge_spheres.py", "sphere_inputs")


@cache
def drawn(inputs, ends=True):
    """The cases with their longer step: of two seeds, and with all that is drawn at its least and at its largest."""
    draws = [random.Random(seed).uniform for seed in range(2)]
    draws += [min, max] if ends else []
    return [inputs({}, draw)[::2] for draw in draws]


def least_and_most(cases, *names):
    values = [case[name] for case in cases for name in names]
    return min(values), max(values)


def every(cases):
    return [case for some in cases for case in some]


@pytest.mark.parametrize(
    "inputs", [ion_inputs, sphere_inputs, cradle_inputs, bounce_inputs, orbit_inputs, catch_inputs]
)
def test_each_case_comes_again_with_half_the_step(inputs):
    cases = inputs({}, random.Random(1).uniform)
    for case, again in zip(cases[::2], cases[1::2], strict=True):
        assert again == {**case, "dt": case["dt"] / 2}


def test_ions_are_on_a_table_and_turn_round_between_a_quarter_and_half_of_their_distance():
    for head_on, oblique, chased in drawn(ion_inputs):
        assert head_on["rB"][1] == 0.0
        assert oblique["rB"][1] == pytest.approx(0.3 * oblique["rB"][0], abs=1e-4)
        assert head_on["vB"] == oblique["vB"] == (0.0, 0.0)
        assert chased["vB"] == (-0.4, 0.0)
        for case in (head_on, oblique, chased):
            reduced = case["mA"] * case["mB"] / (case["mA"] + case["mB"])
            r0, v = case["rB"][0], case["vA"][0] - case["vB"][0]
            turned = case["C"] / (reduced * v**2 / 2 + case["C"] / r0)
            assert 0.249 * r0 <= turned <= 0.501 * r0
            assert case["rB"][1] == round(case["rB"][1], 4)
            assert case["T"] == pytest.approx(4 * r0 / v, abs=1e-4)
    cases = every(drawn(ion_inputs))
    assert least_and_most(cases, "mA", "mB") == (0.05, 0.3)
    assert (min(case["rB"][0] for case in cases), max(case["rB"][0] for case in cases)) == (0.06, 0.15)
    assert (min(case["vA"][0] for case in cases), max(case["vA"][0] for case in cases)) == (0.6, 1.6)


def test_ions_have_parted_again_when_the_time_is_over():
    """Well beyond the closest approach, each feels less than a tenth of the largest force."""
    for case in every(drawn(ion_inputs, ends=False)):
        forces = []

        def force(x, y, u, w, C=case["C"], forces=forces):
            r = math.hypot(x, y)
            forces.append(C / r**2)
            return -C * x / r**3, -C * y / r**3

        two(case, force, steps=400)
        assert forces[-1] < 0.1 * max(forces)
        assert 40 < np.argmax(forces) < 360


def test_spheres_meet_head_on_then_obliquely_then_with_damping_and_have_parted():
    for head_on, oblique, damped in drawn(sphere_inputs):
        assert head_on["rB"][1] == 0.0 == head_on["eta"] == oblique["eta"]
        assert 0.5 <= damped["eta"] <= 1.5
        assert oblique["rB"][1] == pytest.approx(0.8 * oblique["R"], abs=1e-5)
        assert damped["rB"][1] == pytest.approx(0.6 * damped["R"], abs=1e-5)
        for case in (head_on, oblique, damped):
            assert case["rB"][0] == pytest.approx(2.2 * case["R"])
            gaps = []

            def force(x, y, u, w, R=case["R"], k=case["k"], eta=case["eta"], gaps=gaps):
                r = math.hypot(x, y)
                gaps.append(r - 2 * R)
                if r >= 2 * R:
                    return 0.0, 0.0
                push = -k * (2 * R - r) ** 1.5 / r
                return push * x + eta * u, push * y + eta * w

            two(case, force)
            assert gaps[0] > 0 > min(gaps)
            assert gaps[-1] > 0
            assert 5 < sum(gap < 0 for gap in gaps) / len(gaps) * 100 < 90
    cases = every(drawn(sphere_inputs))
    assert least_and_most(cases, "mA", "mB") == (0.05, 0.3)
    assert least_and_most(cases, "R") == (0.015, 0.03)
    assert least_and_most(cases, "k") == (1e4, 4e4)


def test_rows_have_two_to_four_balls_and_two_laws_of_contact():
    for cases in drawn(cradle_inputs):
        assert [(case["N"], case["q"]) for case in cases] == [(2, 1.0), (3, 1.0), (3, 1.5), (4, 1.5)]
    cases = every(drawn(cradle_inputs))
    assert least_and_most(cases, "m") == (0.05, 0.4)
    assert least_and_most(cases, "v0") == (0.4, 2.5)
    assert least_and_most([case for case in cases if case["q"] == 1], "k") == (4e3, 4e4)
    assert least_and_most([case for case in cases if case["q"] == 1.5], "k") == (1e6, 1e7)
    for case in cases:  # the time of a contact of a linear spring: half a swing of the reduced mass
        if case["q"] == 1:
            assert case["dt"] == pytest.approx(math.pi * math.sqrt(case["m"] / 2 / case["k"]) / 100)


def test_balls_fall_hard_then_far_then_softly():
    for hard, far, soft in drawn(bounce_inputs):
        for case in (hard, far, soft):
            assert 0.015 <= case["R"] <= 0.04
            assert case["g"] == 9.8
        assert 0.001 <= round(hard["y0"] - hard["R"], 4) <= 0.01
        assert 0.05 <= round(far["y0"] - far["R"], 4) <= 0.15
        assert 0.001 <= round(soft["y0"] - soft["R"], 4) <= 0.003
        assert -4.0 <= hard["v0"] <= -1.5 <= far["v0"] <= -0.8 < -0.6 <= soft["v0"] <= -0.3
    hard, far, soft = zip(*drawn(bounce_inputs), strict=True)
    assert least_and_most([*hard, *far], "k") == (5e5, 2e6)
    assert least_and_most([*hard, *far], "m") == (0.05, 0.2)
    assert least_and_most(soft, "k") == (2e4, 5e4)
    assert least_and_most(soft, "m") == (0.3, 0.6)


def energy(case):
    """Above the bottom of the well, in parts of its depth, where the atom starts."""
    r, v = math.hypot(case["x"], case["y"]), math.hypot(case["vx"], case["vy"])
    depth = case["k"] * case["d"] ** 2 / 2
    within = case["k"] * (r - case["b"]) ** 2 / 2 if r < case["b"] + case["d"] else depth
    return (within + case["m"] * v**2 / 2) / depth


def test_atoms_are_bound_across_the_radius_then_obliquely_then_fly_past_then_away():
    for across, oblique, past, away in drawn(orbit_inputs):
        assert (across["x"], across["y"], across["vx"]) == (across["b"], 0.0, 0.0)
        assert 0.08 < energy(across) < 0.26
        assert 0.17 < energy(oblique) < 0.35
        assert math.hypot(oblique["x"], oblique["y"]) == pytest.approx(
            oblique["b"] + 0.3 * oblique["d"], abs=2e-4
        )
        outside = past["x"] * past["vx"] + past["y"] * past["vy"]
        assert math.hypot(past["x"], past["y"]) > past["b"] + past["d"]
        assert outside < 0
        assert energy(past) > 1.3
        assert energy(away) > 1.7
        assert away["x"] * away["vx"] + away["y"] * away["vy"] > 0
        for case in (across, oblique, past, away):
            swing = 2 * math.pi * math.sqrt(case["m"] / case["k"])
            assert case["T"] == pytest.approx(1.6 * swing, rel=1e-3)
            assert case["dt"] == pytest.approx(swing / 200, rel=0.01)


@pytest.mark.parametrize("inputs", [orbit_inputs, catch_inputs])
def test_molecules_have_masses_springs_and_lengths_of_the_same_sizes(inputs):
    cases = every(drawn(inputs))
    assert least_and_most(cases, "m") == (0.5, 4.0)
    assert least_and_most(cases, "k") == (40, 300)
    assert least_and_most(cases, "b") == (0.8, 1.6)
    assert all(0.349 <= case["d"] / case["b"] <= 0.601 for case in cases)


def test_oblique_atoms_start_anywhere_about_the_molecule():
    cases = [orbit_inputs({}, random.Random(seed).uniform)[2] for seed in range(16)]
    assert {(case["x"] > 0, case["y"] > 0) for case in cases} == {
        (True, True), (True, False), (False, True), (False, False)
    }  # fmt: skip


def test_the_time_of_the_catch_is_when_an_atom_from_outside_first_is_b_away():
    for case in every(drawn(catch_inputs)):
        pull, start = pull_of(case), start_of(case)
        assert math.hypot(*start[:2]) > case["b"] + case["d"]
        assert math.hypot(*moved(pull, start, case["t1"])[:2]) == pytest.approx(case["b"], abs=1e-9)
        for part in (0.5, 0.9, 0.99):
            assert math.hypot(*moved(pull, start, part * case["t1"])[:2]) > case["b"]
        swing = 2 * math.pi * math.sqrt(case["m"] / case["k"])
        assert case["dt"] == pytest.approx(swing / 200, rel=0.02)
        assert case["t1"] / case["dt"] == pytest.approx(round(case["t1"] / case["dt"]))
        assert case["T"] - case["t1"] == pytest.approx(5 / (2 * math.pi) * swing, abs=case["dt"])


def test_an_atom_one_percent_too_far_out_is_off_by_one_percent_of_its_distance_or_of_b():
    for case in orbit_inputs({}, random.Random(3).uniform)[::2]:
        x, y = moved(pull_of(case), start_of(case), case["T"])[:2]
        far = max(case["b"], math.hypot(x, y))
        assert ORBIT.standard(case).errors((x + 0.01 * far, y)) == pytest.approx((0.01,))
