"""Scenes composed as a physicist would, each against a reference found another way: nothing that happens is missed."""

import math

import pytest
from scipy.integrate import quad

from corollary.scenes.forces.bonds import Spring
from corollary.scenes.forces.contact import Contact, Friction, HardWall
from corollary.scenes.forces.fields import InverseSquare, Weight
from corollary.scenes.plan import play
from corollary.scenes.run import BadSetting, GuardFailed
from corollary.scenes.run import Observable as O
from corollary.scenes.scene import Body, Scene

pytestmark = pytest.mark.whole

NAIL = Body(math.inf, (0.0,), (0.0,))


def holds(found, name, *expected):
    """The values lie within what is stated, and that is no more than a millionth."""
    measured = found.measured[name]
    for value, error, truth in zip(measured.value, measured.error, expected, strict=True):
        assert abs(value - truth) <= error, (value, truth, error)
        assert error <= 1e-6 * max(measured.size, 1.0)


@pytest.mark.parametrize("restitution", [0.0, 0.3, 1.0])
def test_a_block_at_rest_on_a_wall_does_not_end_the_fall_of_a_ball(restitution):
    floor = HardWall((0.0, 1.0), restitution=restitution)
    bodies = Body(1.0, (0.0, 0.5), (0.0, 0.0), 0.5), Body(1.0, (5.0, 10.0), (0.0, 0.0), 0.1)
    found = play(Scene(bodies, (Weight(9.8), floor), until=0.4), {O.VELOCITIES, O.TRAJECTORY}, times=(0.4,))
    holds(found, "velocities", 0.0, 0.0, 0.0, -3.92)
    holds(found, "trajectory", 0.0, 0.5, 5.0, 10.0 - 4.9 * 0.16)


def friction_turns(x, k, m, mu, static, g=9.8):
    """Where a block on a spring with friction turns, one after the other, until it stays: half swings about +-mu m g/k."""
    shift, holding = mu * m * g / k, static * m * g / k
    places = [x]
    while abs(places[-1]) > holding:
        x = places[-1]
        places.append(-(abs(x) - 2.0 * shift) * math.copysign(1.0, x))
    return places


@pytest.mark.parametrize(
    ("mu", "static", "start"), [(0.2, 0.2, 0.3), (0.1, 0.25, 0.31), (0.05, 0.05, 0.2), (0.3, 0.9, 0.25)]
)
def test_a_block_on_a_spring_with_friction_swings_on_until_it_is_held(mu, static, start):
    k, m = 100.0, 1.0
    places = friction_turns(start, k, m, mu, static)
    half = math.pi * math.sqrt(m / k)
    scene = Scene(
        (NAIL, Body(m, (1.0 + start,), (0.0,))),
        (Spring((0, 1), k, 1.0), Friction(1, mu, static=static)),
        until=half * len(places) + 0.5,
    )
    times = tuple(half * i for i in range(len(places)))
    found = play(scene, {O.VELOCITIES, O.TRAJECTORY}, times=times)
    assert found.outcome == "sticks"
    holds(found, "velocities", 0.0, 0.0)
    holds(found, "trajectory", *(x for place in places for x in (0.0, 1.0 + place)))


def test_a_disc_does_not_fly_through_a_peg():
    """Against the integrals of one contact with a fixed centre: energy and angular momentum, by quadrature."""
    m, radius, peg, k, q, v, b = 1.0, 0.05, 0.01, 1e5, 1.5, 3.0, 0.01
    scene = Scene(
        (Body(m, (-1.0, b), (v, 0.0), radius), Body(math.inf, (0.0, 0.0), (0.0, 0.0), peg)),
        (Contact(k, q),),
        until=1.0,
    )
    found = play(scene, {O.VELOCITIES, O.LARGEST_OVERLAP, O.PEAK_FORCE, O.TRAJECTORY}, times=(1.0,))
    reach = radius + peg

    def inward(r):
        return v * v - (b * v / r) ** 2 - 2.0 * k / (m * (q + 1.0)) * (reach - r) ** (q + 1.0)

    low, high = 1e-3 * reach, reach
    for _ in range(200):
        middle = 0.5 * (low + high)
        low, high = (low, middle) if inward(middle) > 0.0 else (middle, high)
    # r = nearest + (reach - nearest) sin^2 takes the root out of the integrand at the nearest point.
    turned, _ = quad(
        lambda a: (
            2.0 * b * v * (reach - high) * math.sin(a) * math.cos(a) / r**2 / math.sqrt(inward(r))
            if (r := high + (reach - high) * math.sin(a) ** 2) > high
            else 0.0
        ),
        0.0,
        0.5 * math.pi,
        epsabs=1e-11,
        epsrel=1e-11,
    )
    # In the direction -x at first; deflected by pi less twice the angles before and within the contact.
    angle = math.pi - 2.0 * (math.asin(b / reach) + turned)
    holds(found, "velocities", v * math.cos(angle), v * math.sin(angle), 0.0, 0.0)
    overlap, force = found.observed["largest_overlap"], found.observed["peak_force"]
    assert overlap == pytest.approx(reach - high, rel=1e-8)
    assert force == pytest.approx(k * overlap**q, rel=1e-8)


@pytest.mark.parametrize("amplitude", [0.10000001, 0.1001, 0.2, 0.9])
@pytest.mark.parametrize("restitution", [1.0, 0.5])
def test_an_oscillator_does_not_skip_a_wall_however_briefly_it_would_be_behind_it(amplitude, restitution):
    """Each hit turns the velocity: the phase goes on from where the mirrored swing is."""
    w, wall = 3.0, 0.1
    scene = Scene(
        (NAIL, Body(2.0, (1.0 - amplitude,), (0.0,))),
        (Spring((0, 1), 2.0 * w * w, 1.0), HardWall((-1.0,), -1.0 - wall, restitution)),
        until=1.4,
    )
    found = play(scene, {O.VELOCITIES, O.TRAJECTORY}, times=(1.4,))
    hit = math.acos(-wall / amplitude) / w
    speed = restitution * amplitude * w * math.sin(w * hit)
    left = 1.4 - hit
    x = wall * math.cos(w * left) - speed / w * math.sin(w * left)
    v = -wall * w * math.sin(w * left) - speed * math.cos(w * left)
    holds(found, "trajectory", 0.0, 1.0 + x)
    holds(found, "velocities", 0.0, v)


def test_the_outcome_does_not_depend_on_what_is_asked():
    bodies = (
        Body(0.3, (0.0, 0.0), (2.0, 0.0), 0.05),
        Body(0.2, (1.0, 0.06), (0.0, 0.0), 0.05),
        Body(0.5, (1.3, 0.3), (0.0, -0.4), 0.08),
    )
    scene = Scene(bodies, (Contact(2e4, 1.5, 0.4), HardWall((0.0, 1.0), -0.3, 0.7)), until=3.0)
    asked = {O.VELOCITIES, O.DURATION, O.LARGEST_OVERLAP, O.PEAK_FORCE, O.ENERGY, O.IMPULSE, O.TRAJECTORY}
    together = play(scene, asked, times=(1.0, 2.0))
    for one in asked:
        alone = play(scene, {one}, times=(1.0, 2.0) if one is O.TRAJECTORY else ())
        assert alone.observed[one.value] == together.observed[one.value]
        assert alone.errors[one.value] == together.errors[one.value]
        assert alone.outcome == together.outcome


def test_two_hits_at_the_same_moment_are_both_met():
    """A point runs into a corner; two balls reach the floor together."""
    corner = Scene(
        (Body(1.0, (1.0, 1.0), (-2.0, -2.0)),), (HardWall((1.0, 0.0)), HardWall((0.0, 1.0))), until=1.0
    )
    found = play(corner, {O.VELOCITIES, O.TRAJECTORY}, times=(1.0,))
    holds(found, "velocities", 2.0, 2.0)
    holds(found, "trajectory", 1.0, 1.0)
    twins = Scene(
        (Body(1.0, (0.0, 1.0), (0.0, 0.0)), Body(3.0, (1.0, 1.0), (0.0, 0.0))),
        (Weight(9.8), HardWall((0.0, 1.0), 0.0, 0.5)),
        until=0.6,
    )
    t = math.sqrt(2.0 / 9.8)
    v = 0.5 * 9.8 * t - 9.8 * (0.6 - t)
    holds(play(twins, {O.VELOCITIES}), "velocities", 0.0, v, 0.0, v)


def test_bounces_without_end_are_named_and_the_ball_slides_on():
    scene = Scene(
        (Body(1.0, (0.0, 1.0), (2.0, 0.0)),), (Weight(9.8), HardWall((0.0, 1.0), 0.0, 0.5)), until=3.0
    )
    found = play(scene, {O.VELOCITIES, O.TRAJECTORY}, times=(3.0,))
    ends = math.sqrt(2.0 / 9.8) * 1.5 / 0.5
    assert any("Zeno" in warning and f"{ends:.3f}"[:4] in warning for warning in found.warnings)
    holds(found, "velocities", 2.0, 0.0)
    holds(found, "trajectory", 6.0, 0.0)


def test_what_is_impossible_is_refused_by_name():
    apart = Body(1.0, (0.0,), (1.0,), 0.1), Body(1.0, (1.0,), (0.0,), 0.1)
    with pytest.raises(GuardFailed, match="begin to overlap and no contact acts between them"):
        play(Scene(apart, (Weight(0.0),), until=2.0), {O.VELOCITIES})
    passing = play(Scene(apart, (Weight(0.0),), until=2.0, passes=((0, 1),)), {O.VELOCITIES})
    assert passing.observed["velocities"] == (1.0, 0.0)
    with pytest.raises(BadSetting, match=r"starts 0\.5 m where it cannot be"):
        play(Scene((Body(1.0, (0.5,), (0.0,)),), (HardWall((1.0,), 1.0),), until=1.0), {O.VELOCITIES})
    sun = Scene((Body(1.0, (1.0,), (0.0,)), NAIL), (InverseSquare((0, 1), 1.0),), until=3.0)
    with pytest.raises(GuardFailed, match=r"grows without end|energy changed"):
        play(sun, {O.VELOCITIES})


def test_a_spring_on_a_line_turns_its_force_where_the_bodies_change_sides():
    """Pushed by L - x on one side of a nail and pulled back by x + L on the other: two arcs of a circle in phase space."""
    w, start = 2.0, 1.8
    scene = Scene((NAIL, Body(1.0, (start,), (0.0,))), (Spring((0, 1), w * w, 0.5),), until=2.0)
    reach = start - 0.5
    first = math.acos(-0.5 / reach) / w
    speed = reach * w * math.sin(w * first)
    left = 2.0 - first
    # Beyond the nail it rests at -0.5: x + 0.5 = 0.5 cos - speed/w sin.
    x = -0.5 + 0.5 * math.cos(w * left) - speed / w * math.sin(w * left)
    holds(play(scene, {O.TRAJECTORY}, times=(2.0,)), "trajectory", 0.0, x)


def test_what_fades_fast_and_then_follows_slowly_is_stiff_and_still_right():
    """A heavily damped spring creeps back: the slow root of m s^2 + c s + k, which the fast one (-1e5/s) would hide."""
    m, c, k, t = 1e-2, 1e3, 100.0, 20.0
    root = math.sqrt(c * c - 4.0 * m * k)
    slow, fast = -2.0 * k / (c + root), -(c + root) / (2.0 * m)
    x = 0.2 * (fast * math.exp(slow * t) - slow * math.exp(fast * t)) / (fast - slow)
    scene = Scene((NAIL, Body(m, (1.2,), (0.0,))), (Spring((0, 1), k, 1.0, damping=c),), until=t)
    holds(play(scene, {O.TRAJECTORY}, times=(t,)), "trajectory", 0.0, 1.0 + x)


def test_what_is_out_of_reach_is_refused_before_it_is_tried():
    fast = Scene((NAIL, Body(1.0, (1.2,), (0.0,))), (Spring((0, 1), 1e12, 1.0),), until=1.0)
    with pytest.raises(GuardFailed, match="out of reach"):
        play(fast, {O.VELOCITIES})
    light = Body(1e-30, (0.0, 0.0), (1.0, 0.0), 0.05)
    others = Body(1.0, (1.0, 0.03), (0.0, 0.0), 0.05), Body(1.0, (3.0, 0.03), (0.0, 0.0), 0.05)
    with pytest.raises(BadSetting, match="do not show"):
        play(Scene((light, *others), (Contact(1e5),)), {O.VELOCITIES})


def test_chaos_is_announced_and_its_errors_grow_with_it():
    """A disc about a round peg in a box: each hit spreads neighbouring ways further."""
    walls = (
        HardWall((1.0, 0.0), -0.5),
        HardWall((-1.0, 0.0), -0.5),
        HardWall((0.0, 1.0), -0.5),
        HardWall((0.0, -1.0), -0.5),
    )
    bodies = Body(1.0, (0.4, 0.35), (1.0, 0.37), 0.02), Body(math.inf, (0.0, 0.0), (0.0, 0.0), 0.3)
    short, long = (
        play(Scene(bodies, (Contact(1e6, 1.5), *walls), until=until), {O.VELOCITIES}) for until in (3.0, 9.0)
    )
    finer = play(Scene(bodies, (Contact(1e6, 1.5), *walls), until=9.0), {O.VELOCITIES}, tolerance=1e-13)
    assert max(short.errors["velocities"]) < 1e-6
    assert max(long.errors["velocities"]) > 100.0 * max(short.errors["velocities"])
    assert long.measured["velocities"].condition > 100.0 * short.measured["velocities"].condition
    for value, error, other in zip(
        long.observed["velocities"], long.errors["velocities"], finer.observed["velocities"], strict=True
    ):
        assert abs(value - other) <= error


@pytest.mark.parametrize("excess", [1e-9, 1e-8, 1e-7, -1e-9, -1e-7])
@pytest.mark.parametrize("tolerance", [1e-5, 1e-7, 1e-9])
def test_a_touch_that_errors_decide_is_announced_and_both_ways_are_within_the_error(excess, tolerance):
    """An oscillator that just reaches a wall without restitution, or just does not."""
    w, wall, until = 2.0, 0.1, 2.5
    amplitude = wall * (1.0 + excess)
    scene = Scene(
        (NAIL, Body(1.0, (1.0 - amplitude,), (0.0,))),
        (Spring((0, 1), w * w, 1.0), HardWall((-1.0,), -1.0 - wall, 0.0)),
        until=until,
    )
    found = play(scene, {O.TRAJECTORY, O.VELOCITIES}, tolerance, times=(until,))
    reached = min(amplitude, wall)
    hit = math.acos(-min(wall / amplitude, 1.0)) / w
    truth = 1.0 + reached * math.cos(w * (until - hit))
    value, error = found.observed["trajectory"][1], found.errors["trajectory"][1]
    assert abs(value - truth) <= error
    if abs(excess) * wall < tolerance:
        assert any("grazes" in warning for warning in found.warnings)


@pytest.mark.parametrize("tolerance", [1e-2, 1e-4, 1e-6, 1e-12])
def test_errors_hold_at_any_tolerance(tolerance):
    """Two runs with steps so long that they are the same would not know their error."""
    k, m, mu, start = 100.0, 1.0, 0.1, 0.2
    places = friction_turns(start, k, m, mu, mu)
    until = math.pi * math.sqrt(m / k) * (len(places) + 0.3)
    scene = Scene(
        (NAIL, Body(m, (1.0 + start,), (0.0,))), (Spring((0, 1), k, 1.0), Friction(1, mu)), until=until
    )
    found = play(scene, {O.TRAJECTORY}, tolerance, times=(until,))
    value, error = found.observed["trajectory"][1], found.errors["trajectory"][1]
    assert abs(value - 1.0 - places[-1]) <= error <= max(10.0 * tolerance, 1e-10)


def test_a_slip_that_ends_in_the_very_middle_of_a_step_is_seen():
    """Along a line the speed falls through zero as evenly as it can, and one of the runs lays a step round it."""
    start, v, mu, until = 1.0, 2.2928498041, 0.4867669783239723, 1.2686597121663663
    found = play(
        Scene((Body(0.5, (start,), (v,)),), (Friction(0, mu),), until=until),
        {O.VELOCITIES, O.TRAJECTORY},
        times=(until,),
    )
    holds(found, "velocities", 0.0)
    holds(found, "trajectory", start + v * v / (2 * mu * 9.8))


def test_equal_balls_that_all_but_stand_still_are_not_waited_for():
    """Each hands its velocity on and keeps errors of steps, with which it would come to the next in a million seconds."""
    row = tuple(Body(0.3, (0.3 * i,), (1.0 if i == 0 else 0.0,), 0.05) for i in range(5))
    contacts = tuple(
        Contact(10.0 ** (5 + i % 2), 1.0 + 0.5 * (i % 2), chosen=((i, i + 1),)) for i in range(4)
    )
    holds(play(Scene(row, contacts), {O.VELOCITIES}), "velocities", 0.0, 0.0, 0.0, 0.0, 1.0)
