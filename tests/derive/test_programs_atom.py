"""Programs for the atom in the well: right ones are right, each usual wrong one is told so, and the reference is a reference."""

import math
import random

import pytest

from corollary.derive.programs_atom import (
    Well,
    catch_inputs,
    judge_catch,
    judge_orbit,
    moved,
    orbit_inputs,
    stepped,
    well_of,
)
from corollary.scene.catalogue import run

DICE = random.Random(12)
ORBITS = [case for _ in range(4) for case in orbit_inputs({}, DICE.uniform)]
CATCHES = [case for _ in range(3) for case in catch_inputs({}, DICE.uniform)]


def start(case):
    return case["x"], case["y"], case["vx"], case["vy"]


def by_the_book(case, **changed):
    return stepped(well_of(case | changed), start(case), case["T"], round(case["T"] / case["dt"]))[:2]


@pytest.mark.parametrize("case", ORBITS)
def test_the_method_of_the_book_is_right(case):
    assert judge_orbit({}, case, by_the_book(case)) is None


@pytest.mark.parametrize("case", ORBITS)
def test_half_the_steps_for_the_reference_change_less_than_a_thousandth_of_the_tolerance(case):
    coarse, fine = (moved(well_of(case), start(case), case["T"], least=least)[:2] for least in (200, 400))
    assert math.dist(coarse, fine) < 1e-5 * case["b"]


def test_the_reference_swings_as_long_and_as_far_as_the_scene_says():
    settings = {"m": 2.0, "k": 100.0, "b": 1.0, "d": 0.4, "r0": 1.0, "v0": 3.0}
    seen = run("atom", settings).observed
    x, y, u, w = moved(Well(50.0, 1.0, 1.4), (1.0, 0.0, 0.0, 3.0), seen["period"], least=2000)
    assert math.hypot(x, y) == pytest.approx(1.0, abs=1e-9)
    assert math.atan2(y, x) == pytest.approx(seen["angle"], abs=1e-8)
    assert math.hypot(u, w) == pytest.approx(3.0, abs=1e-8)


@pytest.mark.parametrize(
    ("place", "changed", "words"),
    [(0, {"k": -1.0}, "minus"), (0, {"m": 1.0}, "mass is missing"), (3, {"d": 1e9}, "beyond b + d"),
     (0, {"b": 0.0}, "relaxed at the distance b")],
)  # fmt: skip
def test_usual_wrong_programs_are_told_what_is_wrong(place, changed, words):
    case = ORBITS[place]
    changed = {name: value * case["k"] if name == "k" else value for name, value in changed.items()}
    if changed.get("b") == 0.0:
        changed["d"] = case["b"] + case["d"]
    said = judge_orbit({}, case, by_the_book(case, **changed))
    assert said is not None
    assert said.known
    assert words in said.sentence


def caught(case, velocity=0.5, pull=1.0):
    before, after = round(case["t1"] / case["dt"]), round((case["T"] - case["t1"]) / case["dt"])
    well = well_of(case)
    x, y, u, w = stepped(well, start(case), case["t1"], before)
    other = Well(well.pull * pull, well.b, well.edge)
    return stepped(other, (x, y, velocity * u, velocity * w), case["T"] - case["t1"], after)[:2]


@pytest.mark.parametrize("case", CATCHES)
def test_a_right_catch_is_right_and_wrong_ones_are_known(case):
    assert judge_catch({}, case, caught(case)) is None
    usual = (({"velocity": 1.0}, "velocity is not changed"), ({"pull": 0.5}, "not the force"), ({"pull": 2.0}, "not the mass"))
    for wrong, words in usual:
        said = judge_catch({}, case, caught(case, **wrong))
        assert said is not None
        assert said.known, wrong
        assert words in said.sentence


def test_too_few_numbers_are_told():
    assert "pair" in judge_orbit({}, ORBITS[0], [1.0]).sentence
