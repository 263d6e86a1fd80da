"""One scene of every composed family: right within its stated error, against a reference that shares nothing with the engine."""

import pytest
from benchmarks.composed.case import judged
from benchmarks.scenes_composed import cases


@pytest.mark.parametrize("case", cases(1, seed=12), ids=lambda case: case.family.replace(" ", "-"))
def test_a_composed_scene_is_right(case):
    verdict = judged(case)
    assert verdict.outcome == "right", verdict.why
