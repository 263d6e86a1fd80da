"""What confirms a formula shares none with it: each ready scene's second way meets its first within what both state."""

import math

import pytest

from corollary.derive.ready_scenes import run
from corollary.scenes.run import BadSetting, components

CASES = [
    ("absorbed_drop", {"F": 3.0, "dt": 1e-3}, {"velocities", "momentum_change"}),
    ("atom", {}, {"period", "turning_points", "angle", "escapes"}),
    ("atom", {"dimension": 1.0, "v0": 1.0}, {"period", "turning_points", "escapes"}),
    ("atom", {"v0": 9.0}, {"velocities", "escapes"}),
    (
        "ball_on_floor",
        {},
        {"velocities", "duration", "peak_force", "impulse", "largest_overlap", "rebound_speed"},
    ),
    ("bullet_block", {"v": 20.0}, {"velocities", "energy_change", "distance"}),
    ("chain", {"N": 100.0}, {"impulse", "work", "energy_lost", "mean_force"}),
    ("cradle", {"N": 2.0, "q": 1.5}, {"velocities", "duration", "largest_overlap", "peak_force"}),
    ("growing_drop", {"u": 2.0}, {"velocities", "way", "mass"}),
    ("growing_drop", {"m": 2.23e-4, "t": 0.024, "v": -1.2, "R": 0.117}, {"velocities", "way"}),
    ("ions", {"s": 0.02}, {"turning_points", "peak_force"}),
    ("kick", {"pulse": 3.0}, {"velocities", "impulse", "way", "peak_force"}),
    ("railway_car", {"ux": 1.0}, {"mean_force", "impulse", "work", "energy_lost"}),
    ("rocket", {"N": 100.0}, {"velocities"}),
    ("snowball", {}, {"momentum", "velocities", "velocities_after_throw", "peak_force"}),
    ("snowball", {"Ms": 0.01, "theta": 1.0}, {"momentum", "velocities", "peak_force"}),
    (
        "spheres",
        {"eta": 0.0},
        {"velocities", "duration", "largest_overlap", "peak_force", "impulse", "energy_ratio"},
    ),
    ("two_blocks", {}, {"velocities", "impulse"}),
    ("wall", {}, {"velocities", "momentum_change", "impulse", "mean_force", "duration"}),
]


@pytest.mark.parametrize(("scene", "settings", "names"), CASES)
def test_both_ways_agree_within_what_they_state(scene, settings, names):
    first, second = (run(scene, settings, second_way=way) for way in (False, True))
    assert names <= second.observed.keys()
    assert second.error_is == "estimate"
    for name in names:
        rows = (first.observed[name], second.observed[name], first.errors[name], second.errors[name])
        for a, b, e, f in zip(*map(components, rows), strict=True):
            assert abs(a - b) <= e + 3.0 * f, name
    assert max(second.relative_error(name) for name in names) < (0.02 if scene == "rocket" else 1e-8)


@pytest.mark.parametrize("way", [False, True])
@pytest.mark.parametrize("v0", [0.0, -2.0])
def test_a_ball_that_starts_in_the_floor_is_refused_either_way(way, v0):
    with pytest.raises(BadSetting, match="inside the floor"):
        run("ball_on_floor", {"y0": 0.01, "v0": v0}, second_way=way)


def test_ions_that_meet_head_on_turn_even_at_the_start_of_a_step():
    """One turning point lies between the first two samples of a step; the distance is that of the energies, C/r = C/r0 + mu v^2/2."""
    settings = {"C": 0.0011, "mA": 0.3, "mB": 0.05, "v": 0.5, "r0": 0.165, "s": 0.0}
    nearest = 1.0 / (1.0 / 0.165 + 0.5 * (0.3 * 0.05 / 0.35) * 0.25 / 0.0011)
    found = run("ions", settings, tolerance=1e-10, second_way=True)
    assert components(found.observed["turning_points"]) == pytest.approx((nearest,), rel=1e-9)


def test_on_a_circle_both_turning_points_are_its_radius_and_no_noise_is_a_period():
    """m v^2/r = k (r - b); what errors of steps make of the distance is neither a turn nor a swing."""
    m, k, b, r = 2.0, 100.0, 1.0, 1.3
    settings = {"m": m, "k": k, "b": b, "d": 0.4, "r0": r, "v0": math.sqrt(k * (r - b) * r / m)}
    found = run("atom", settings, tolerance=1e-10, second_way=True)
    assert found.outcome == "bound"
    assert "period" not in found.observed
    assert found.observed["escapes"] == 0.0
    for distance, error in zip(
        *map(components, (found.observed["turning_points"], found.errors["turning_points"])), strict=True
    ):
        assert abs(distance - r) <= error < 1e-6


def test_what_is_left_of_a_stiff_motion_is_counted():
    """To e^-40 in 1e-9 s, too: steps of a method without a bound on what fades left more than they were allowed to."""
    settings = {"m": 4.8, "dm": 1.5, "v": 2.2, "u": -5.6, "dt": 1e-9}
    found = run("absorbed_drop", settings, tolerance=1e-10, second_way=True)
    common = (4.8 * 2.2 - 1.5 * 5.6) / 6.3
    error = components(found.errors["velocities"])
    off = [abs(v - common) for v in components(found.observed["velocities"])]
    assert all(a <= b for a, b in zip(off, error, strict=True))
    assert max(error) < 1e-8
