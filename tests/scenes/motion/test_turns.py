"""Where the distance from the origin turns, and after how long it does again."""

from __future__ import annotations

import math

import pytest
from scipy.integrate import quad
from scipy.optimize import brentq
from tests.ready_scene_files import names_in
from tests.shares import share

from corollary.scenes.body import Body
from corollary.scenes.forces.bonds import Spring
from corollary.scenes.forces.contact import Friction, HardWall
from corollary.scenes.forces.fields import ForceFunction, InverseSquare, Weight
from corollary.scenes.forces.flows import Drag
from corollary.scenes.motion.observe import extremes
from corollary.scenes.motion.path import Turn
from corollary.scenes.plan import play
from corollary.scenes.run import BadSetting, Observable, components
from corollary.scenes.scene import Scene

Well = names_in("atom")["Well"]

pytestmark = pytest.mark.whole


@pytest.mark.parametrize("height", [0.7, 1.0, 2.0])
@pytest.mark.parametrize("flights", [2.2, 2.7, 3.7, 6.1])
def test_a_ball_thrown_back_at_the_origin_itself_returns_once_a_flight(height, flights):
    """Rounding puts the floor a little before or behind the origin: the distance would turn twice, and a third of the flights were one too many."""
    flight = 2.0 * math.sqrt(2.0 * height / 9.8)
    ball = Body(1.0, (height,), (0.0,))
    found = play(Scene((ball,), (Weight(9.8), HardWall((1.0,))), until=flights * flight), {Observable.PERIOD})
    measured = found.measured["period"]
    assert abs(measured.value - flight) <= measured.error < 1e-11


def test_returns_that_are_not_alike_are_no_period():
    """Of a ball whose floor is below the origin the distance is least three times a flight."""
    ball = Body(1.0, (1.0,), (0.0,))
    with pytest.raises(BadSetting, match=r"after 0\.044.* s and after 0\.9035.* s: there is no period"):
        play(Scene((ball,), (Weight(9.8), HardWall((1.0,), -0.1)), until=3.0), {Observable.PERIOD})


@pytest.mark.parametrize("heavy", [1e3, 1e4, 1e5])
def test_a_body_that_hardly_moves_turns_where_it_does(heavy):
    """Two ions seen from where they would meet: the heavy one turns at its share of the least distance, which energy gives."""
    light, strength, far = 0.1, 0.0012, 0.08
    share, reduced = light / (light + heavy), light * heavy / (light + heavy)
    rest = heavy / (light + heavy)
    ions = Body(heavy, (-share * far,), (share,)), Body(light, (rest * far,), (-rest,))
    nearest = strength / (0.5 * reduced + strength / far)
    measured = play(
        Scene(ions, (InverseSquare((0, 1), -strength),), until=0.32), {Observable.TURNING_POINTS}
    ).measured["turning_points"]
    (value,), (error,) = components(measured.value), components(measured.error)
    assert abs(value - share * nearest) <= error < 1e-10


def test_a_slow_swing_beside_a_fast_body_has_its_turns():
    nail, ball, fast = Body(math.inf, (0.0,), (0.0,)), Body(1.0, (1.001,), (0.0,)), Body(1.0, (5.0,), (1e6,))
    found = play(
        Scene((ball, nail, fast), (Spring((0, 1), 1.0, 1.0),), until=20.0),
        {Observable.TURNING_POINTS, Observable.PERIOD},
    )
    assert found.observed["turning_points"] == pytest.approx((0.999, 1.001), abs=1e-9)
    assert found.observed["period"] == pytest.approx(2.0 * math.pi, abs=1e-6)


@pytest.mark.parametrize("tolerance", [1e-6, 1e-8, 1e-10, 1e-12])
@pytest.mark.parametrize("until", [2.7, 6.0])
def test_a_swing_that_just_touches_the_origin_returns_once_a_period(tolerance, until):
    """x = 1 + cos 2 pi t: as it comes to nothing a rounding of its place is 1e-8 of its period."""
    nail, ball = Body(math.inf, (1.0,), (0.0,)), Body(1.0, (2.0,), (0.0,))
    scene = Scene((ball, nail), (Spring((0, 1), 4.0 * math.pi**2),), until=until)
    found = play(scene, {Observable.PERIOD}, tolerance).measured["period"]
    assert abs(found.value - 1.0) <= found.error < max(10.0 * tolerance, 1e-7)
    assert abs(found.value - 1.0) < 0.1 * tolerance + 1e-13


@pytest.mark.parametrize("tolerance", [1e-6, 1e-10])
def test_what_is_far_away_does_not_hide_a_period(tolerance):
    nail, ball = Body(math.inf, (0.0,), (0.0,)), Body(1.0, (2.0,), (0.0,))
    far = Body(math.inf, (1e6,), (0.0,))
    scene = Scene((ball, nail, far), (Spring((0, 1), 9.0, 1.5),), until=6.0)
    found = play(scene, {Observable.PERIOD}, tolerance).measured["period"]
    assert abs(found.value - 2.0 * math.pi / 3.0) <= found.error < 10.0 * tolerance + 1e-8


@pytest.mark.parametrize("tolerance", [1e-8, 1e-10])
@pytest.mark.parametrize("beside", [(1e4, 0.0), (0.0, 1e3), (1e4, 1e3)])
def test_returns_that_are_known_no_better_tell_so(tolerance, beside):
    """An ellipse about its centre, beside what is far away or fast: steps know its returns less well."""
    far, fast = beside
    nail, planet = Body(math.inf, (0.0, 0.0), (0.0, 0.0)), Body(1.0, (1.0, 0.0), (0.0, 1.1))
    others = Body(math.inf, (far, 0.0), (0.0, 0.0)), Body(1.0, (0.0, 5.0), (fast, 0.0))
    scene = Scene((planet, nail, *others), (Spring((0, 1), 1.0),), until=20.0)
    found = play(scene, {Observable.PERIOD}, tolerance).measured["period"]
    assert abs(found.value - math.pi) <= found.error < 2e3 * tolerance


def test_of_many_turns_the_nearest_and_the_farthest_are_told():
    """1.5 + 0.5 exp(-t/4) cos w t, let go at rest: it is nearest after half a swing, and farthest at the start."""
    nail, ball = Body(math.inf, (0.0,), (0.0,)), Body(1.0, (2.0,), (0.0,))
    scene = Scene((ball, nail), (Spring((0, 1), 9.0, 1.5), Drag(0, 0.5)), until=10.0)
    found = play(scene, {Observable.TURNING_POINTS}).measured["turning_points"]
    nearest = 1.5 - 0.5 * math.exp(-0.25 * math.pi / math.sqrt(9.0 - 0.25**2))
    for value, error, exact in zip(
        components(found.value), components(found.error), (nearest, 2.0), strict=True
    ):
        assert abs(value - exact) <= error < 1e-8


@pytest.mark.parametrize("tolerance", [1e-3, 1e-6, 1e-8, 1e-10])
@pytest.mark.parametrize("until", share([13.1, 46.7, 569.0], 2))
def test_a_long_watch_at_a_loose_tolerance_has_its_period_still(tolerance, until):
    """About a charged wire: the period is the integral of the radial motion, from one turning point to the other and back."""
    pull, mass, place, speed = 2.65, 2.3, (-1.358, 0.681), (-0.43, -0.86)
    spin = place[0] * speed[1] - place[1] * speed[0]
    energy = 0.5 * mass * math.hypot(*speed) ** 2 + pull * math.log(math.hypot(*place))

    def squared(r):
        return 2.0 * (energy - pull * math.log(r)) / mass - (spin / r) ** 2

    low, high = brentq(squared, 0.05, math.hypot(*place)), brentq(squared, math.hypot(*place), 9.0)
    middle, half = 0.5 * (high + low), 0.5 * (high - low)
    truth, _ = quad(
        lambda a: 2.0 * half * math.cos(a) / math.sqrt(squared(middle + half * math.sin(a))),
        -0.5 * math.pi,
        0.5 * math.pi,
    )
    wire = ForceFunction(
        0,
        lambda t, x, v: tuple(-pull * c / (x[0] ** 2 + x[1] ** 2) for c in x),
        energy=lambda x: pull * math.log(math.hypot(*x)),
    )
    measured = play(
        Scene((Body(mass, place, speed),), (wire,), until=until), {Observable.PERIOD}, tolerance
    ).measured["period"]
    assert abs(measured.value - truth) <= measured.error < 0.02 * truth


@pytest.mark.parametrize(
    "scene",
    [
        Scene(
            (Body(2.0, (1.0, 5.0), (1.0, 0.7), 0.1),),
            (Weight(9.8), HardWall((0.0, 1.0), restitution=0.8)),
            until=3.0,
        ),
        Scene((Body(1.0, (1.0,), (0.3,)),), (Well(10.0, 1.0, 0.9), Drag(0, linear=0.5)), until=20.0),
    ],
    ids=["thrown far", "damped"],
)
def test_returns_to_other_distances_are_no_period(scene):
    with pytest.raises(BadSetting, match=r"least at .* m once and at .* another time: there is no period"):
        play(scene, {Observable.PERIOD})


@pytest.mark.parametrize("tolerance", [1e-4, 1e-8, 1e-12])
@pytest.mark.parametrize(
    ("body", "forces", "truth"),
    [
        (Body(1.0, (1.358,), (0.0,)), (Spring((0, 1), 1.0, 1.0, damping=2.5),), (1.358,)),
        (Body(1.0, (1.817,), (0.0,)), (Spring((0, 1), 1.0, 1.0, damping=3.0),), (1.817,)),
        (Body(1.0, (1.491,), (0.979,)), (Drag(0, linear=20.0),), ()),
        (Body(0.48, (1.432,), (-0.71,)), (Friction(0, 0.57),), ()),
        (Body(3.0, (0.138,), (0.099,)), (Friction(0, 0.3),), ()),
        (Body(1.0, (1.934,), (0.0,)), (Spring((0, 1), 50.0, 1.0), Friction(0, 0.3)), (0.1836, 1.934)),
    ],
    ids=["creeps", "creeps slowly", "fades", "slides in", "slides out", "stops at a turn"],
)
def test_what_comes_to_rest_does_not_turn_there(body, forces, truth, tolerance):
    nail = Body(math.inf, (0.0,), (0.0,))
    found = play(Scene((body, nail), forces, until=30.0), {Observable.TURNING_POINTS}, tolerance)
    values, errors = found.observed["turning_points"], found.errors["turning_points"]
    assert len(values) == len(truth)
    assert all(abs(a - b) <= max(e, 1e-15) < 1e-4 for a, b, e in zip(values, truth, errors, strict=True))
    assert found.warnings == ()


@pytest.mark.parametrize(
    ("distances", "turns"),
    [
        ([1.0, 1.0, 1.0], []),
        ([1.0, 1.0 - 1e-9, 1.0, 1.0 + 1e-9], []),
        ([1.0, 2.0, 2.0 - 1e-9, 2.0], [(0, True)]),
        ([1.0, 2.0, 2.0 - 1e-9, 2.0 + 1e-9, 1.0], [(0, True), (3, False)]),
        ([2.0, 1e-12, 2e-12, 0.0, 2.0, 1.0], [(0, False), (3, True), (4, False)]),
    ],
)
def test_ways_of_rounding_are_no_turns(distances, turns):
    passed = [Turn(float(i), distance, False) for i, distance in enumerate(distances)]
    assert [(turn.time, turn.inward) for turn in extremes(passed, 1e-6)] == turns


@pytest.mark.parametrize("tolerance", [1e-6, 1e-10, 1e-12])
@pytest.mark.parametrize(("slope", "mu"), [(0.5, 0.1), (0.8, 0.3), (1.0, 0.2)])
def test_a_block_turns_where_it_stops_on_a_rough_incline(slope, mu, tolerance):
    """Friction goes the other way from there: a step ends as it turns."""
    across, up = math.cos(slope), math.sin(slope)
    incline = HardWall((-up, across), restitution=0.0, mu=mu)
    block = Body(1.0, (across, up), (1.5 * across, 1.5 * up))
    found = play(Scene((block,), (Weight(9.8), incline), until=0.4), {Observable.TURNING_POINTS}, tolerance)
    (value,), (error,) = found.observed["turning_points"], found.errors["turning_points"]
    assert abs(value - 1.0 - 1.5**2 / (2.0 * 9.8 * (up + mu * across))) <= error < 10.0 * tolerance
