"""Scenes composed at random are the same however they are written down."""

import pytest
from benchmarks.scenes_retold import compared

# Found this way, and mended: slips that turn back at once, that begin while their pull turns, and what a rod and a rough table both hold.
MENDED = (180, 488, 546, 650)


@pytest.mark.parametrize("number", [*range(8), *MENDED])
def test_a_scene_told_twice_is_the_same(number):
    outcome, why = compared(number, 1)
    assert outcome in ("agreed", "agreed, with large errors", "refused"), why
    assert number not in MENDED or outcome != "refused", why
