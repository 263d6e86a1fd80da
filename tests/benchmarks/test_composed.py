"""One scene of every composed family: right within its stated error, against a reference that shares nothing with the engine."""

import math

import pytest
from benchmarks.composed.case import judged
from benchmarks.scenes_composed import FAMILIES, cases

pytestmark = pytest.mark.whole

EDGES = {"nearly_upright"}
"""Where a motion turns back or goes over by a hair, errors are large and are said to be."""


@pytest.mark.parametrize("family", FAMILIES, ids=lambda family: family.__name__)
def test_a_composed_scene_is_right(family):
    for case in cases(1, 12, (family,)):
        assert all(math.isfinite(x) or math.isnan(x) for truth in case.truth.values() for x in truth)
        verdict = judged(case)
        assert verdict.outcome == "right" or family.__name__ in EDGES, verdict.why
        assert verdict.outcome in ("right", "honest"), verdict.why
