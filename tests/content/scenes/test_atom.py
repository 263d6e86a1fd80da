"""The atom in its well: closed cases, facts of the geometry, and the edge between bound and free."""

import math

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.ready_scene_files import names_in

from corollary.derive.ready_scenes import run
from corollary.scenes.models.certain import found as evaluated
from corollary.scenes.plan import play
from corollary.scenes.run import Observable, components
from corollary.scenes.scene import Body, Scene

Well, in_well = (names_in("atom")[name] for name in ("Well", "in_well"))
SWING = 2 * math.pi * math.sqrt(2.0 / 100.0)


def test_on_a_line_it_swings():
    found = run("atom", {"dimension": 1, "v0": 1.0})
    assert found.observed["period"] == pytest.approx(SWING, rel=1e-15)
    reach = math.sqrt(2.0 / 100.0)
    assert found.observed["turning_points"] == pytest.approx((1 - reach, 1 + reach), rel=1e-15)
    assert (found.outcome, found.model) == ("bound", "piecewise exact")


def test_on_a_line_a_fast_one_comes_back_from_the_core_as_fast():
    found = run("atom", {"dimension": 1, "r0": 2.0, "v0": -5.0})
    assert found.observed["velocities"] == pytest.approx((5.0,), rel=1e-14)
    assert found.observed["turning_points"] == (0.6,)
    inside = math.asin(0.4 / math.sqrt(0.16 + 2 * (25 - 8) / 2 * 2 / 100))
    assert found.observed["duration"] == pytest.approx(0.6 / 5 + 4 * inside * math.sqrt(0.02), rel=0.5)


def test_one_that_starts_at_the_core_on_its_way_in_turns_at_once():
    """x = 1 + A sin(w t - arcsin(0.4/A)) until the edge, then as fast as it was."""
    scene = Scene((Body(2.0, (0.6,), (-2.0,)),), (Well(100.0, 1.0, 0.4),), until=0.3)
    found = play(scene, {Observable.TRAJECTORY}, times=(0.1, 0.3)).measured["trajectory"]
    w, reach = math.sqrt(50.0), math.sqrt(0.16 + 4.0 / 50.0)
    begin = math.asin(0.4 / reach)
    exact = 1.0 + reach * math.sin(0.1 * w - begin), 1.4 + 2.0 * (0.3 - 2.0 * begin / w)
    for value, error, true in zip(components(found.value), components(found.error), exact, strict=True):
        assert abs(value - true) <= error < 1e-10


@pytest.mark.parametrize("place", [(0.6, 0.0), (0.36, 0.48), (0.0, -0.6)])
@pytest.mark.parametrize("across", [0.5, 1.0])
def test_one_that_starts_at_the_core_in_a_plane_goes_as_one_that_is_thrown_back(place, across):
    """Energy and angular momentum are kept, and what is thrown back by a mirror goes as its image."""
    (x, y), well = place, (Well(100.0, 1.0, 0.4),)
    ways = [((s * x - across * y) / 0.6, (s * y + across * x) / 0.6) for s in (-2.0, 2.0)]
    scenes = [Scene((Body(2.0, place, way),), well, until=0.5) for way in ways]
    inward, outward = (
        play(s, {Observable.VELOCITIES, Observable.TRAJECTORY}, times=(0.5,)).measured for s in scenes
    )
    for name in ("velocities", "trajectory"):
        a, b = (components(each[name].value) for each in (inward, outward))
        for one, other, error in zip(a, b, components(inward[name].error), strict=True):
            assert abs(one - other) <= 2.0 * error + 1e-15
    (u, v), (at, up) = components(inward["velocities"].value), components(inward["trajectory"].value)
    off = math.hypot(*components(inward["velocities"].error))
    assert abs(math.hypot(u, v) - math.hypot(2.0, across)) <= off < 1e-9
    assert at * v - up * u == pytest.approx(0.6 * across, rel=1e-9)


def test_a_circle_is_a_circle():
    r = 1.2
    speed = math.sqrt(100.0 * (r - 1.0) * r / 2.0)
    found = run("atom", {"r0": r, "v0": speed}).observed
    assert found["turning_points"] == pytest.approx((r, r), rel=1e-9)
    # Small radial swings about a circle: w_r^2 = k/m + 3 v^2/r^2.
    assert found["period"] == pytest.approx(2 * math.pi / math.sqrt(50.0 + 3 * (speed / r) ** 2), rel=1e-9)


@pytest.mark.parametrize(("part", "outcome"), [(0.99, "bound"), (1.01, "escaped")])
def test_the_edge_between_bound_and_free(part, outcome):
    """Tangential start at r = b: it leaves when v^2 > (k/m) d (b + d)^2 d / (d (2 b + d))."""
    b, d = 1.0, 0.4
    edge = math.sqrt(50.0 * d * d / (1 - b * b / (b + d) ** 2))
    assert run("atom", {"v0": part * edge}).outcome == outcome


@given(st.floats(0.7, 1.3), st.floats(-2.0, 2.0), st.floats(-2.0, 2.0))
@settings(max_examples=60, deadline=None)
def test_energy_and_spin_at_the_turning_points_are_those_of_the_start(r, u, v):
    found = run("atom", {"r0": (r, 0.0), "v0": (u, v)})
    if found.outcome == "bound":
        energy = u * u + v * v + 50.0 * (r - 1.0) ** 2
        for turn in found.observed["turning_points"]:
            # At a turning point only the speed across is left.
            assert (r * v / turn) ** 2 + 50.0 * (turn - 1.0) ** 2 == pytest.approx(
                energy, rel=1e-9, abs=1e-12
            )
        assert 0.6 <= found.observed["turning_points"][0] <= r * (1 + 1e-12)
        assert 1.4 >= found.observed["turning_points"][1] >= r * (1 - 1e-12)
    else:
        far = u * u + v * v + 50.0 * ((r - 1.0) ** 2 - 0.16)
        assert math.hypot(*found.observed["velocities"]) ** 2 == pytest.approx(far, rel=1e-9)


def test_a_slow_tangential_start_turns_as_the_small_excess_says():
    """Radial excess for small v: r_max - b is 2 m v^2 / (k b) to leading order."""
    v = 1e-3
    low, high = run("atom", {"v0": v}).observed["turning_points"]
    assert low == 1.0
    assert high - 1.0 == pytest.approx(2 * 2.0 * v * v / 100.0, rel=1e-6)


def test_it_passes_outside():
    found = run("atom", {"r0": (2.0, 1.5), "v0": (-5.0, 0.0)})
    assert found.outcome == "missed"
    assert found.observed["velocities"] == pytest.approx((-5.0, 0.0), abs=1e-14)


@pytest.mark.parametrize("far", [3.0, 100.0, 1e4])
@pytest.mark.parametrize("beside", [0.0, 0.3, 0.7, 1.2])
def test_an_atom_that_comes_from_far_meets_the_well_and_its_core(far, beside):
    """Where it goes must agree with how fast energy and angular momentum say it is: a step from far away leaps over the whole molecule."""
    speed, start = 41.9, -1.07 * far
    until = 1.5 * abs(start) / speed
    scene = Scene((Body(2.0, (start, beside), (speed, 0.0)),), (Well(100.0, 1.0, 0.4),), until=until)
    found = play(scene, {Observable.TRAJECTORY}, times=(until, 0.99 * until))
    places = found.observed["trajectory"]
    known = evaluated(lambda: in_well(Well(100.0, 1.0, 0.4), 2.0, (start, beside), (speed, 0.0), True))
    velocities = known.observed["velocities"]
    for i in range(2):
        gone = (places[i] - places[i + 2]) / (0.01 * until)
        allowed = 2.0 * max(found.errors["trajectory"]) / (0.01 * until) + known.errors["velocities"][i]
        assert abs(gone - velocities[i]) <= allowed + 1e-9 * speed
