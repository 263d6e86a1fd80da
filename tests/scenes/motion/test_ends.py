"""What masses that change, moments that all but coincide with the end, and forces that leave all range do to an answer."""

import math

import pytest

from corollary.scenes.forces.contact import Contact, Friction, HardWall
from corollary.scenes.forces.fields import ForceFunction, Weight
from corollary.scenes.forces.flows import Absorption, Drag, Thrust
from corollary.scenes.plan import play
from corollary.scenes.run import BadSetting, GuardFailed, Observable, Run, components
from corollary.scenes.scene import Body, Force, Scene

pytestmark = pytest.mark.whole

G = 9.8


def played(body: Body, *forces: Force, until: float) -> Run:
    return play(Scene((body,), forces, until=until), {Observable.VELOCITIES, Observable.ENERGY})


def off(found: Run, name: str, true: float) -> float:
    """How far a value is from the true one, in units of the stated error."""
    return abs(components(found.observed[name])[0] - true) / components(found.errors[name])[0]


def test_a_rocket_on_a_rough_track_weighs_what_is_left_of_it():
    found = played(Body(10.0, (0.0,), (0.0,)), Thrust(0, (-50.0,), 1.0), Friction(0, 0.2), until=5.0)
    assert off(found, "velocities", 50.0 * math.log(2.0) - 0.2 * G * 5.0) <= 1.0


def test_a_rocket_too_weak_at_first_sets_off_when_it_is_light_enough():
    found = played(Body(10.0, (0.0,), (0.0,)), Thrust(0, (-15.0,), 1.0), Friction(0, 0.2), until=5.0)
    light = 15.0 / (0.2 * G)
    assert off(found, "velocities", 15.0 * math.log(light / 5.0) - 0.2 * G * (light - 5.0)) <= 1.0


def test_sand_makes_a_cart_press_harder():
    found = played(Body(2.0, (0.0,), (6.0,)), Absorption(0, (0.0,), 0.4), Friction(0, 0.2), until=2.0)
    assert off(found, "velocities", (12.0 - 0.2 * G * (2.0 * 2.0 + 0.2 * 2.0**2)) / 2.8) <= 1.0


def test_the_energy_of_a_rocket_is_that_of_what_is_left():
    found = played(Body(10.0, (0.0,), (0.0,)), Thrust(0, (-50.0,), 1.0), Weight(G), until=5.0)
    speed = 50.0 * math.log(2.0) - G * 5.0
    high = 50.0 * (5.0 - 5.0 * math.log(2.0)) - 0.5 * G * 25.0
    assert off(found, "energy", 0.5 * 5.0 * speed**2 + 5.0 * G * high) <= 1.0


@pytest.mark.parametrize("until", [math.nextafter(0.5, 1.0), 0.5, 0.5 - 1e-13, 0.5 + 1e-13])
def test_a_hit_at_the_very_end_is_in_doubt(until):
    found = played(Body(1.0, (0.0,), (1.0,)), HardWall((-1.0,), -0.5), until=until)
    assert components(found.errors["velocities"])[0] >= 2.0
    assert found.warnings


@pytest.mark.parametrize(("until", "true"), [(0.5 - 1e-6, 1.0), (0.5 + 1e-6, -1.0)])
def test_a_hit_a_microsecond_from_the_end_is_not(until, true):
    found = played(Body(1.0, (0.0,), (1.0,)), HardWall((-1.0,), -0.5), until=until)
    assert off(found, "velocities", true) <= 1.0
    assert components(found.errors["velocities"])[0] < 1e-7


def test_a_steep_wall_of_ones_own_throws_a_ball_back():
    push = ForceFunction(
        0, lambda t, x, v: (100.0 * math.exp(-x[0] / 0.01),), energy=lambda x: math.exp(-x[0] / 0.01)
    )
    assert off(played(Body(1.0, (5.0,), (-1.0,)), push, until=10.5), "velocities", 1.0) <= 1.0


@pytest.mark.parametrize(
    "force",
    [
        ForceFunction(0, lambda t, x, v: (v[0] / abs(v[0]) if v[0] else math.nan,)),
        ForceFunction(0, lambda t, x, v: (math.nan if t >= 0.5 else 0.0,)),
        ForceFunction(0, lambda t, x, v: (-1.0 / x[0] if x[0] else math.inf,)),
    ],
)
def test_a_force_that_is_no_number_ends_a_run_by_name(force):
    with pytest.raises((BadSetting, GuardFailed)):
        played(Body(1.0, (0.0,), (0.0,)), force, until=1.0)


def test_drag_counts_the_mass_at_the_time():
    found = played(Body(2.0, (0.0,), (3.0,)), Thrust(0, (0.0,), 0.5), Drag(0, linear=0.3), until=2.0)
    assert off(found, "velocities", 3.0 * (1.0 / 2.0) ** (0.3 / 0.5)) <= 1.0


@pytest.mark.parametrize("tolerance", [1e-6, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12])
def test_steps_that_nothing_holds_back_are_not_those_of_the_run_they_are_compared_with(tolerance):
    """Steps that grew alike in both runs gave a rocket's place with the same error of 2e-11 in both: none was seen."""
    mass, burn, out = 0.6217966439958414, 0.17170669673256134, 4.115053159026445
    rocket = Body(mass, (0.7, -0.13), (0.0, 0.0))
    others = [
        Body(1.2, (-1.18, -0.98), (-2.4, 1.3)),
        Body(1.03, (1.9, -1.09), (0.0, 0.0)),
        Body(0.1, (-1.2, -0.34), (0.0, 0.0), 0.17),
    ]
    forces = [
        Contact(145.0, 1.0),
        Thrust(0, (-1.3353705073546616, -out), burn),
        Weight(G),
        HardWall((0.0, 1.0), -2.5),
    ]
    times = tuple(0.02 * i for i in range(1, 35))
    found = play(
        Scene((rocket, *others), tuple(forces), until=1.3), {Observable.TRAJECTORY}, tolerance, times
    )
    places = components(found.observed["trajectory"])[1::8]
    errors = components(found.errors["trajectory"])[1::8]
    for time, place, error in zip(times, places, errors, strict=True):
        left = mass - burn * time
        risen = out / burn * (burn * time + left * math.log(left / mass))
        assert abs(place - (-0.13 + risen - 0.5 * G * time**2)) <= error


def test_balls_that_touch_from_the_start_are_known_though_a_later_touch_is_in_doubt():
    radius = 0.05
    far = 2.0 * radius * math.sqrt(3.0) / 2.0
    balls = (
        Body(0.1, (-2.0 * far - 0.01, 0.0), (1.0, 0.0), radius),
        Body(0.1, (0.0, radius), (0.0, 0.0), radius),
        Body(0.1, (0.0, -radius), (0.0, 0.0), radius),
    )
    found = play(Scene(balls, (Contact(1e6, 1.5),), until=0.1), {Observable.VELOCITIES})
    _, _, *both = components(found.observed["velocities"])
    assert both == pytest.approx([both[0], both[1], both[0], -both[1]], abs=1e-9)
    assert max(components(found.errors["velocities"])) < 1e-8


def test_an_overlap_that_still_grows_at_the_end_is_that_of_the_end():
    balls = (Body(0.1, (0.0,), (1.0,), 0.05), Body(0.3, (0.1,), (0.0,), 0.05))
    found = play(
        Scene(balls, (Contact(2e4, 1.5),), until=1e-3),
        {Observable.LARGEST_OVERLAP, Observable.TRAJECTORY},
        times=(1e-3,),
    )
    first, second = components(found.observed["trajectory"])
    stated = components(found.errors["largest_overlap"])[0] + sum(components(found.errors["trajectory"]))
    assert abs(components(found.observed["largest_overlap"])[0] - (0.1 - (second - first))) <= stated < 1e-11


def test_a_block_at_the_origin_goes_on_resting_from_where_rounding_left_it():
    """At (9e-18, 0) m all of the scene's places are rounding: a gap of 5e-18 m was a drop, and the block bounced and slid."""
    slope = HardWall((0.6, 0.8), restitution=0.0, mu=0.7125, static=0.825)
    for place in ((0.0, 0.0), (8.99e-18, 0.0), (-3e-17, 2e-17)):
        block = Body(1.0, place, (9e-17, 0.0))
        found = play(Scene((block,), (Weight(9.8), slope), until=0.3), {Observable.VELOCITIES})
        assert max(map(abs, found.observed["velocities"])) < 1e-11
        assert found.outcome == "sticks"


@pytest.mark.parametrize("speed", [2.0 * math.sin(math.pi), 1e-12, 1e-10, 1e-3])
@pytest.mark.parametrize("place", [0.0, 1.0])
def test_a_block_that_hardly_moves_comes_to_rest(speed, place):
    """The first step was 1e12 times as long as its slip lasts, and the moment of its stop a rounding of that: it never came."""
    block = Scene((Body(1.0, (place,), (speed,)),), (Friction(0, 0.3),), until=1.0)
    found = play(block, {Observable.VELOCITIES})
    assert (found.outcome, found.observed["velocities"]) == ("sticks", (0.0,))
    assert max(found.errors["velocities"]) < 1e-9 * speed


@pytest.mark.parametrize("gap", [1e-13, 1e-11, 1e-9, 1e-5])
def test_a_block_let_go_a_hair_above_a_slope_is_not_followed_for_ever(gap):
    """The hair was the size of the scene, and the second that is watched out of reach of steps as long."""
    slope = HardWall((0.6, 0.8), restitution=0.0, mu=0.825)
    block = Body(1.0, (0.6 * gap, 0.8 * gap), (0.0, 0.0))
    found = play(Scene((block,), (Weight(9.8), slope), until=0.3), {Observable.VELOCITIES})
    assert found.outcome == "sticks"
    assert max(map(abs, found.observed["velocities"])) < 1e-9
