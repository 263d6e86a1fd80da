"""One scene of every composed family: right within its stated error, against a reference that shares nothing with the engine."""

import math

import pytest
from benchmarks.composed import falls
from benchmarks.composed.case import judged
from benchmarks.scenes_composed import EXACT, UNSEEN, cases


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


def test_the_friction_of_bounces_that_are_left_out_is_in_the_error():
    """Two runs left out the same bounces of a fall on a rough incline, and told nothing of each other."""
    for case in cases(2, 5002, (falls.down_a_rough_incline,)):
        assert judged(case).outcome in ("right", "honest")
