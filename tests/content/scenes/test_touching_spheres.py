"""Two spheres that push each other and fall: whatever they do to each other, weight alone changes the total momentum."""

import math

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from corollary.derive.ready_scenes import run
from corollary.scenes.run import BadSetting

masses, speeds = st.floats(0.05, 2.0), st.floats(-10.0, 10.0)


@given(masses, masses, speeds, st.floats(0.004, 0.05), st.floats(0.0, 5.0), st.sampled_from([1.0, 1.5]))
@settings(max_examples=12, deadline=None)
def test_the_momentum_of_both_changes_by_the_impulse_of_their_weight(ma, mb, up, t, eta, q):
    found = run(
        "touching_spheres", {"mA": ma, "mB": mb, "vB": (-0.75, up), "t": t, "eta": eta, "q": q, "k": 1e5}
    )
    x, y = found.observed["momentum_change"]
    pull = (ma + mb) * 9.8 * t
    assert abs(y + pull) <= (3.0 * found.relative_error("momentum_change") + 1e-13) * pull
    assert abs(x) <= (3.0 * found.relative_error("momentum_change") + 1e-13) * pull
    assert found.observed["momentum"] == pytest.approx(
        (3.0 * ma - 0.75 * mb, 4.0 * ma + up * mb - pull), abs=1e-11
    )


def test_relative_to_each_other_falling_spheres_do_as_if_there_were_no_weight():
    """Once they have parted, after less than 10 ms, the two runs differ by g t for each sphere."""
    falling, floating = (
        run("touching_spheres", {"eta": 1.0, "q": 1.5, "k": 1e5, "g": g, "t": 0.02}) for g in (9.8, 0.0)
    )
    lost = 9.8 * 0.02
    ax, ay, bx, by = floating.observed["velocities"]
    assert falling.observed["velocities"] == pytest.approx((ax, ay - lost, bx, by - lost), abs=1e-11)
    assert falling.observed["largest_overlap"] == pytest.approx(
        floating.observed["largest_overlap"], rel=1e-10
    )


def test_without_weight_they_collide_as_the_two_spheres_of_the_section():
    """Two models that share nothing but the law of force: steps in a plane, and two integrals (or one contact in its own time)."""
    there = {
        "mA": 0.1,
        "mB": 0.2,
        "R": 0.02,
        "k": 2e4,
        "q": 1.5,
        "dx": 0.06,
        "dy": 0.018,
        "vA": (1.0, 0.2),
        "vB": (-0.5, 0.0),
    }
    for eta in (0.0, 3.0):
        watched = run("touching_spheres", there | {"eta": eta, "g": 0.0, "t": 0.1}).observed
        known = run("spheres", there | {"eta": eta}).observed
        for name in ("velocities", "duration", "largest_overlap", "energy_ratio"):
            assert watched[name] == pytest.approx(known[name], rel=1e-9, abs=1e-10), name
        assert watched["mean_force"] == pytest.approx(
            [-part / 0.1 for part in known["impulse"]], rel=1e-9, abs=1e-10
        )
        assert "momentum_change" not in watched


@pytest.mark.parametrize("t", [1e-5, 1e-6, 1e-7])
def test_in_a_moment_the_mean_force_is_the_force(t):
    """The force changes at some 1.5 (rate of overlap)/overlap < 600/s: the mean over t is off by at most that times t."""
    there = {
        "mA": 0.1,
        "mB": 0.1,
        "R": 0.02,
        "k": 2e4,
        "q": 1.5,
        "eta": 1.0,
        "dx": 0.03,
        "dy": 0.018,
        "vA": (0.0, 0.0),
        "vB": (-1.0, 0.5),
    }
    r = math.hypot(0.03, 0.018)
    push = 2e4 * (0.04 - r) ** 1.5
    force = (-push * 0.03 / r - 1.0, -push * 0.018 / r + 0.5)
    seen = run("touching_spheres", there | {"g": 9.8, "t": t}).observed["mean_force"]
    off = math.dist(seen, force) / math.hypot(*force)
    assert 1e-3 * 600.0 * t < off < 600.0 * t


def test_spheres_that_miss_each_other_fall():
    found = run("touching_spheres", {"dx": 1.0, "dy": 0.0, "vA": (0.0, 0.0), "vB": (1.0, 1.0), "t": 0.5})
    assert found.outcome == "missed"
    assert found.observed["velocities"] == pytest.approx((0.0, -4.9, 1.0, -3.9), abs=1e-12)
    assert "mean_force" not in found.observed


@pytest.mark.parametrize(
    ("settings", "says"),
    [
        ({"dx": 0.0, "dy": 0.0}, "one centre on the other"),
        ({"eta": 1e9}, "lower eta"),
        ({"k": 1.0, "t": 0.05}, "so soft"),
        ({"vA": (1.0, 2.0, 3.0)}, "components"),
    ],
)
def test_what_cannot_be_watched_is_refused_in_a_sentence(settings, says):
    with pytest.raises(BadSetting, match=says):
        run("touching_spheres", settings)


def test_an_error_is_a_share_of_the_largest_speed_on_the_way():
    """What two spheres that all but stand still are off by is what they were off by when they were fast."""
    found = run(
        "touching_spheres", {"vA": (0.0, 4.9), "vB": (0.0, 4.9), "dx": 0.039, "dy": 0.0, "k": 1e-3, "t": 0.5}
    )
    speeds = found.measured["velocities"]
    assert max(map(abs, speeds.value)) < 0.01
    assert speeds.size >= 4.9


def test_spheres_that_begin_to_squeeze_are_as_far_off_as_is_said():
    """The power 3/2 leaves a root behind at the very start, which both runs had stepped over alike."""
    there = {
        "mA": 1.1488973, "mB": 1.1665915, "R": 0.05, "q": 1.5, "k": 169705.62748, "eta": 0.00117735583,
        "dx": 0.0, "dy": 0.1, "vA": (-0.24706920, 1.6485109), "vB": (-0.32623850, 0.062924044), "t": 0.014536986,
    }  # fmt: skip
    known = run("touching_spheres", there, 1e-12)
    for tolerance in (1e-7, 1e-8, 1e-9, 1e-10):
        found = run("touching_spheres", there, tolerance)
        for value, true, error in zip(
            found.observed["velocities"],
            known.observed["velocities"],
            found.errors["velocities"],
            strict=True,
        ):
            assert abs(value - true) <= error


@pytest.mark.parametrize("g", [0.0, 9.8])
def test_long_after_they_have_parted_they_fall_in_a_few_steps(g):
    short, long = (run("touching_spheres", {"g": g, "t": t}) for t in (0.02, 2e4))
    assert long.evaluations < 4 * short.evaluations
    assert long.observed["largest_overlap"] == short.observed["largest_overlap"]
    for i, (early, late) in enumerate(
        zip(short.observed["velocities"], long.observed["velocities"], strict=True)
    ):
        fallen = g * (2e4 - 0.02) * (i % 2)
        assert late == pytest.approx(early - fallen, abs=long.errors["velocities"][i])


@pytest.mark.parametrize("far", [1e2, 3e3])
def test_spheres_that_come_from_afar_meet_however_long_they_are_watched(far):
    there = {"dx": far, "dy": 0.02, "vA": (5.0, 0.0), "vB": (-5.0, 0.0), "g": 1e-3, "q": 1.5, "k": 1e5}
    found = run("touching_spheres", there | {"t": 10.0 * far})
    known = run(
        "spheres",
        {name: x for name, x in (there | {"eta": 0.0}).items() if name != "g"}
        | {"R": 0.05, "mA": 0.2, "mB": 0.3},
    )
    assert found.observed["largest_overlap"] == pytest.approx(
        known.observed["largest_overlap"], abs=found.errors["largest_overlap"]
    )


def test_spheres_too_soft_for_what_comes_from_afar_are_refused_where_they_meet():
    with pytest.raises(BadSetting, match="so soft"):
        run(
            "touching_spheres",
            {"dx": 1e3, "dy": 0.0, "vA": (5.0, 0.0), "vB": (0.0, 0.0), "k": 1e-3, "t": 1e6},
        )


@pytest.mark.parametrize("radii", [1e3, 1e5, 1e8])
@pytest.mark.parametrize("g", [0.0, 9.8])
def test_spheres_that_come_from_however_far_touch_as_near_ones_do(radii, g):
    """Weight makes both alike faster on the way."""
    near, far = (
        run(
            "touching_spheres",
            {"dx": 0.05 * each, "dy": 0.03, "vA": (1.0, 0.0), "vB": (0.0, 0.0), "g": g, "t": 0.06 * each},
        )
        for each in (10.0, radii)
    )
    assert far.outcome == "released"
    assert far.evaluations < 2 * near.evaluations
    assert far.observed["duration"] == pytest.approx(near.observed["duration"], rel=1e-10)
    assert far.observed["largest_overlap"] == pytest.approx(near.observed["largest_overlap"], rel=1e-10)
    for i, (early, late) in enumerate(
        zip(near.observed["velocities"], far.observed["velocities"], strict=True)
    ):
        fallen = g * 0.06 * (radii - 10.0) * (i % 2)
        assert abs(early - fallen - late) <= near.errors["velocities"][i] + far.errors["velocities"][i]
    assert max(far.errors["velocities"]) < 1e-12 + 2e-15 * g * 0.06 * radii


@pytest.mark.parametrize(("before", "outcome"), [(1e-7, "missed"), (-1e-7, "released")])
def test_whether_they_have_touched_by_then_is_told_from_afar(before, outcome):
    """Head-on they touch after (1e6 - 0.1) s."""
    there = {"dx": 1e6, "dy": 0.0, "vA": (1.0, 0.0), "vB": (0.0, 0.0)}
    found = run("touching_spheres", there | {"t": 1e6 - 0.1 - before})
    assert found.outcome == outcome
    assert ("mean_force" in found.observed) == (outcome == "released")
    if outcome == "released":
        assert found.observed["largest_overlap"] == pytest.approx(1e-7, rel=1e-2)


def test_spheres_that_do_not_touch_in_time_fall_without_a_step():
    found = run("touching_spheres", {"dx": 1.0, "dy": 0.0, "vA": (0.0, 0.0), "vB": (-1.0, 1.0), "t": 0.5})
    assert (found.outcome, found.evaluations, found.model) == ("missed", 0, "conservation")


def test_spheres_at_rest_that_squeeze_each_other_have_no_energy_to_compare_with():
    found = run("touching_spheres", {"dx": 0.09, "dy": 0.0, "vA": (0.0, 0.0), "vB": (0.0, 0.0), "t": 1.0})
    known = run("spheres", {"mA": 0.2, "mB": 0.3, "R": 0.05, "k": 1.2e4, "q": 1.0, "eta": 0.0, "dx": 0.09, "dy": 0.0, "vA": (0.0, 0.0), "vB": (0.0, 0.0)})  # fmt: skip
    assert "energy_ratio" not in found.observed
    fallen = (0.0, 9.8, 0.0, 9.8)
    assert found.observed["velocities"] == pytest.approx(
        [v - f for v, f in zip(known.observed["velocities"], fallen, strict=True)], abs=1e-10
    )


def test_two_that_move_fast_together_and_slowly_toward_each_other_are_followed():
    """What they squeeze is too little to see in their places."""
    found = run(
        "touching_spheres",
        {"dx": 0.1, "dy": 0.0, "vA": (1.0, 1e-13), "vB": (1.0 - 1e-13, 0.0), "k": 1e9, "g": 0.0, "t": 1e-3},
    )
    assert found.observed["velocities"] == pytest.approx((1.0, 0.0, 1.0, 0.0), abs=2e-12)
