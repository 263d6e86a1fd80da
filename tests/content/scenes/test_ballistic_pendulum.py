"""The bullet that takes its time to stop, in a block that swings meanwhile."""

import math
from itertools import pairwise

import pytest
from tests.ready_scene_files import names_in

from corollary.derive.ready_scenes import run
from corollary.scenes.run import BadSetting

AT_ONCE = (2.45 / 1.01) ** 2 / 19.6


def test_the_swing_costs_height_as_the_square_of_the_time():
    lost = [
        1.0 - run("ballistic_pendulum", {"dt": dt}).observed["height"] / AT_ONCE for dt in (1e-4, 1e-3, 1e-2)
    ]
    assert lost[0] > 1e-11
    assert [b / a for a, b in pairwise(lost)] == pytest.approx([100.0, 100.0], rel=1e-2)


@pytest.mark.parametrize(("length", "dt"), [(1.0, 1e-3), (0.5, 1e-3), (2.0, 1e-2)])
def test_it_costs_less_than_what_the_rope_can_pull_in_that_time(length, dt):
    """As the solution bounds it: the ropes lean by at most v dt/L, and carry (mA + mB)(g + v^2/L)."""
    found = run("ballistic_pendulum", {"L": length, "dt": dt})
    v = 2.45 / 1.01
    taken = (9.8 + v**2 / length) * (v * dt / length) * dt / v
    lost = 1.0 - found.observed["height"] / AT_ONCE
    assert found.error < 1e-3 * lost < lost < 2.0 * taken


def test_the_effect_does_not_come_from_the_steps():
    fine, coarse = (
        run("ballistic_pendulum", {"dt": 1e-3}, tolerance).observed["height"] for tolerance in (1e-14, 1e-8)
    )
    assert coarse == pytest.approx(fine, rel=1e-8)


def test_angle_and_height_belong_together_even_on_a_very_long_rope():
    found = run("ballistic_pendulum", {"L": 1e9}).observed
    assert found["angle"] == pytest.approx(math.sqrt(2.0 * found["height"] / 1e9), rel=1e-12)


@pytest.mark.parametrize(
    ("settings", "says"), [({"dt": 0.1}, "shorten dt"), ({"v": 1000.0}, "above the rope's fixing")]
)
def test_what_is_no_ballistic_pendulum_is_refused(settings, says):
    with pytest.raises(BadSetting, match=says):
        run("ballistic_pendulum", settings)


def test_a_block_that_would_swing_for_ever_under_the_bullet_is_refused_before_a_step(monkeypatch):
    monkeypatch.setitem(names_in("ballistic_pendulum"), "DOP853", None)
    for mb in (1e-17, 1e-300):
        with pytest.raises(BadSetting, match="so light"):
            run("ballistic_pendulum", {"mA": 1e3, "mB": mb, "v": 1.0, "dt": 1e-2})
