"""What masses that change, moments that all but coincide with the end, and forces that leave all range do to an answer."""

import math

import pytest

from corollary.scenes.forces.absorption import Absorption
from corollary.scenes.forces.drag import Drag
from corollary.scenes.forces.friction import Friction
from corollary.scenes.forces.function import ForceFunction
from corollary.scenes.forces.thrust import Thrust
from corollary.scenes.forces.wall import HardWall
from corollary.scenes.forces.weight import Weight
from corollary.scenes.plan import play
from corollary.scenes.run import BadSetting, GuardFailed, Observable, Run, components
from corollary.scenes.scene import Body, Force, Scene

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


def test_a_wall_whose_speed_changes_within_a_rounding_of_the_time_gives_no_more_digits_than_that():
    lasts = 2e-4

    def bump(t: float) -> tuple[float, float, float]:
        s = (t - 5.0) / lasts
        high = math.exp(-s * s)
        return high, -2.0 * s / lasts * high, (4.0 * s * s - 2.0) / lasts**2 * high

    found = played(Body(1.0, (0.3,), (0.0,)), HardWall((1.0,), moves=bump), until=8.0)
    assert off(found, "velocities", 2.0 * 0.3 * 2.0 * math.sqrt(-math.log(0.3)) / lasts) <= 1.0


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
