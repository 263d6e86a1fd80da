"""Forces of somebody's own that act for shorter than the steps before them last: each kick is felt, whatever it hits."""

import math
from collections.abc import Sequence

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.optimize import brentq

from corollary.scenes.forces.contact import Contact, Friction, HardWall
from corollary.scenes.forces.fields import ForceFunction, Weight
from corollary.scenes.motion.own_forces import LOOKS
from corollary.scenes.plan import play
from corollary.scenes.run import GuardFailed, Observable, Run, components
from corollary.scenes.scene import Body, Force, Scene

WHEN, IMPULSE = 5.0, 2.0
LASTS = 1e-2


def kick(t: float, lasts: float = LASTS) -> float:
    """A bell of a force (N) with a known impulse."""
    return IMPULSE / (lasts * math.sqrt(math.pi)) * math.exp(-(((t - WHEN) / lasts) ** 2))


def kicked(lasts: float = LASTS, body: int = 0) -> ForceFunction:
    return ForceFunction(body, lambda t, x, v: (kick(t, lasts),))


def played(*forces: Force, until: float = 10.0, bodies: Sequence[Body] = (Body(1.0, (0.0,), (0.0,)),)) -> Run:
    return play(
        Scene(tuple(bodies), forces, until=until),
        {Observable.VELOCITIES, Observable.TRAJECTORY},
        times=(until,),
    )


def assert_true(found: Run, name: str, *true: float) -> None:
    for value, error, exact in zip(
        components(found.observed[name]), components(found.errors[name]), true, strict=True
    ):
        assert abs(value - exact) <= error < 1e-5, (name, value, error, exact)


@pytest.mark.parametrize("lasts", [1.0, 1e-2, 3.0 * 10.0 / LOOKS])
def test_a_kick_in_the_middle_of_free_flight_gives_its_impulse(lasts):
    found = played(kicked(lasts))
    assert_true(found, "velocities", IMPULSE)
    assert_true(found, "trajectory", IMPULSE * (10.0 - WHEN))


def test_steps_that_a_strong_short_kick_makes_short_are_no_sign_of_an_end_out_of_reach():
    strong = ForceFunction(0, lambda t, x, v: (3e4 * math.exp(-(((t - 0.5) / 1e-4) ** 2)),))
    found = played(strong, until=1.0, bodies=[Body(0.5, (0.0,), (0.0,))])
    assert_true(found, "velocities", 3e4 * 1e-4 * math.sqrt(math.pi) / 0.5)


def test_a_kick_told_as_a_table_of_measured_forces():
    at, newtons = [5.0, 5.002, 5.004, 5.007, 5.01], [0.0, 800.0, 1200.0, 300.0, 0.0]

    force = ForceFunction(0, lambda t, x, v: (float(np.interp(t, at, newtons)),))
    found = played(force, bodies=[Body(0.43, (0.0,), (0.0,))])
    assert_true(found, "velocities", float(np.trapezoid(newtons, at)) / 0.43)


def test_a_kick_tears_a_block_off_that_friction_holds():
    brake = 0.2 * 9.8
    begins = WHEN - LASTS * math.sqrt(math.log(kick(WHEN) / brake))

    def speed(t: float) -> float:
        pushed = 0.5 * IMPULSE * (math.erf((t - WHEN) / LASTS) - math.erf((begins - WHEN) / LASTS))
        return pushed - brake * (t - begins)

    ends = float(brentq(speed, WHEN, 9.0, xtol=1e-15, rtol=1e-15))
    slid = sum(quad(speed, a, b, epsabs=1e-13, epsrel=1e-13)[0] for a, b in ((begins, 5.1), (5.1, ends)))
    found = played(Friction(0, 0.2), kicked())
    assert found.outcome == "sticks"
    assert_true(found, "trajectory", slid)


def test_a_kick_lifts_a_ball_off_the_floor():
    weight = 9.8
    leaves = WHEN - LASTS * math.sqrt(math.log(kick(WHEN) / weight))
    pushed = 0.5 * IMPULSE * (1.0 - math.erf((leaves - WHEN) / LASTS))
    found = played(Weight(weight), HardWall((1.0,), restitution=0.5), kicked(), until=5.2)
    assert_true(found, "velocities", pushed - weight * (5.2 - leaves))


def test_what_is_kicked_hits_what_lies_ahead():
    bodies = [Body(1.0, (0.0,), (0.0,), 0.1), Body(1.0, (1.0,), (0.0,), 0.1)]
    assert_true(played(Contact(1e5, 1.5), kicked(), bodies=bodies), "velocities", 0.0, IMPULSE)


def test_a_narrow_well_on_the_way_is_passed_sooner_than_none():
    deep, wide = 0.05, 1e-2

    def well(x: Sequence[float]) -> float:
        return -deep * math.exp(-(((x[0] - 5.0) / wide) ** 2))

    pull = ForceFunction(0, lambda t, x, v: (2.0 * (x[0] - 5.0) / wide**2 * well(x),), energy=well)
    found = played(pull, bodies=[Body(1.0, (0.0,), (1.0,))])
    saved, _ = quad(
        lambda x: 1.0 - 1.0 / math.sqrt(1.0 - 2.0 * well([x])), 4.9, 5.1, points=[5.0], epsabs=1e-14
    )
    assert_true(found, "trajectory", 10.0 + saved)


def test_a_law_of_somebody_elses_is_searched_and_those_of_the_package_are_not():
    class Kick(Force):
        def act(self, scene, state, masses, since):
            return ()

        def act_at(self, scene, time, state, masses, since):
            yield 0, (kick(time),)

    assert Kick().may_be_brief
    assert not Weight().may_be_brief
    assert not HardWall((1.0,)).may_be_brief
    assert_true(played(Kick()), "velocities", IMPULSE)


def test_a_push_known_to_be_smooth_gives_the_same_and_is_not_looked_at_thousands_of_times():
    asked = []

    def push(t, x, v):
        asked.append(t)
        return (3.0,)

    calls, found = [], []
    for smooth in (False, True):
        asked.clear()
        found.append(played(ForceFunction(0, push, smooth=smooth)))
        calls.append(len(asked))
        assert_true(found[-1], "velocities", 30.0)
    assert calls[1] < LOOKS < calls[0]
    assert found[0].observed == found[1].observed


def rubbed(push):
    """A block that is thrown and brought to rest by a force of somebody's own."""
    return Scene((Body(1.0, (0.0,), (1e-3,)),), (ForceFunction(0, push),), until=1.0)


def test_a_force_that_jumps_with_the_velocity_is_refused_with_what_to_take_instead():
    with pytest.raises(
        GuardFailed, match="a force that jumps with the velocity, as dry friction does, is a Friction"
    ):
        play(rubbed(lambda t, x, v: (-0.5 * math.copysign(1.0, v[0]),)), {Observable.VELOCITIES})


def test_a_velocity_that_only_passes_where_a_force_jumps_goes_on():
    """Driven ten times as hard as it is braked: it turns ten times, in no time at all."""
    drive = 5.0
    force = ForceFunction(0, lambda t, x, v: (drive * math.cos(t) - 0.1 * drive * math.copysign(1.0, v[0]),))
    scene = Scene((Body(1.0, (0.0,), (0.0,)),), (force,), until=31.0)
    found = play(scene, {Observable.VELOCITIES})
    assert abs(found.observed["velocities"][0]) < drive
    assert found.errors["velocities"][0] < 1e-6 * drive


def test_one_that_is_out_of_reach_for_being_fast_is_told_so():
    with pytest.raises(GuardFailed, match="soften what is stiff"):
        play(rubbed(lambda t, x, v: (-1e16 * x[0],)), {Observable.VELOCITIES})
