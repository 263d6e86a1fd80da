"""One scene of every composed family: right within its stated error, against a reference that shares nothing with the engine."""

import math

import pytest
from benchmarks.composed import falls
from benchmarks.composed.case import judged
from benchmarks.composed.discs import Composed, Disc, Plate
from benchmarks.composed.enumerated import Course, Fineness, observed
from benchmarks.scenes_composed import ENUMERATED, EXACT, UNSEEN, cases


@pytest.mark.parametrize("case", cases(1, seed=12), ids=lambda case: case.family.replace(" ", "-"))
def test_a_composed_scene_is_right(case):
    verdict = judged(case)
    assert verdict.outcome == "right", verdict.why


@pytest.mark.whole
@pytest.mark.parametrize("family", UNSEEN, ids=lambda family: family.__name__)
def test_a_scene_that_nothing_was_made_for_is_right(family):
    for case in cases(2, 2, (family,)):
        assert all(math.isfinite(x) for truth in case.truth.values() for x in truth)
        verdict = judged(case)
        assert verdict.outcome == "right", verdict.why


@pytest.mark.whole
@pytest.mark.parametrize("family", EXACT, ids=lambda family: family.__name__)
def test_a_scene_with_a_closed_form_is_right_or_honest(family):
    for case in cases(2, 3, (family,)):
        verdict = judged(case)
        assert verdict.outcome in ("right", "honest"), verdict.why


@pytest.mark.parametrize("family", ENUMERATED, ids=lambda family: family.__name__)
def test_a_scene_whose_modes_are_enumerated_is_right_or_honest(family):
    for case in cases(1, 4, (family,)):
        assert all(math.isfinite(x) for truth in case.truth.values() for x in truth)
        assert all(doubt < 1e-9 for doubt in case.doubt.values())
        verdict = judged(case)
        assert verdict.outcome in ("right", "honest"), verdict.why


def test_the_enumerated_modes_know_how_a_disc_comes_to_roll():
    """It is dropped on a rough floor, bounces to rest, and slips until it rolls: at 5/7 of its speed, as every sphere that did not spin."""
    height, e, mu, g, speed = 0.1, 0.5, 0.25, 9.8, 3.5
    disc = Disc(0.7, (0.0, height + 0.2), (speed, 0.0), 0.2)
    given = Composed((disc,), g, (Plate((0.0, 1.0), 0.0, e, mu),))
    seen = observed(Course(given, Fineness()), (), 2.0)
    assert seen["velocities"] == pytest.approx((speed * 5 / 7, 0.0), abs=1e-12)
    assert seen["spins"] == pytest.approx((-speed * 5 / 7 / 0.2,), abs=1e-11)
    assert seen["energy"] == pytest.approx((0.7 * (speed * speed * 5 / 14 + g * 0.2),), abs=1e-11)
    first = math.sqrt(2 * g * height) * (1 + e)  # what the first bounce gives, and friction mu of that
    early = observed(Course(given, Fineness()), (), math.sqrt(2 * height / g) + 0.01)
    assert early["velocities"][0] == pytest.approx(speed - mu * first, abs=1e-12)


def test_the_friction_of_bounces_that_are_left_out_is_in_the_error():
    """Two runs left out the same bounces of a fall on a rough incline, and told nothing of each other."""
    for case in cases(2, 5002, (falls.down_a_rough_incline,)):
        assert judged(case).outcome in ("right", "honest")
