"""Steps in time: their error follows the tolerance, also where a contact ends or a body leaves the edge of a well."""

import math

import pytest
from tests.ready_scene_files import names_in

from corollary.derive.ready_scenes import run
from corollary.scenes.forces.contact import Contact, HardWall
from corollary.scenes.forces.fields import Weight
from corollary.scenes.forces.flows import Drag
from corollary.scenes.motion import stepper
from corollary.scenes.motion.conserved import never_meets
from corollary.scenes.motion.follow import follow
from corollary.scenes.plan import play
from corollary.scenes.run import GuardFailed, components
from corollary.scenes.run import Observable as O
from corollary.scenes.scene import Body, Scene, start_of, velocity

Well = names_in("atom")["Well"]

PAIR = (Body(0.1, (0.0, 0.0), (1.0, 0.0), 0.02), Body(0.1, (0.08, 0.018), (0.0, 0.0), 0.02))


@pytest.mark.parametrize("q", [1.0, 1.5, 2.0])
@pytest.mark.parametrize("tolerance", [1e-8, 1e-10, 1e-11, 1e-12, 1e-13])
def test_a_contact_ends_as_exactly_as_it_was_followed(q, tolerance):
    k = 2e4 * 0.005 ** (1.5 - q)
    path = follow(Scene(PAIR, (Contact(k, q),)), tolerance)
    exact = run("spheres", {"eta": 0.0, "q": q, "k": k}).observed["velocities"]
    found = (*velocity(Scene(PAIR, ()), path.state, 0), *velocity(Scene(PAIR, ()), path.state, 1))
    assert math.dist(found, exact) < 10.0 * tolerance


@pytest.mark.parametrize("tolerance", [1e-8, 1e-10, 1e-12])
@pytest.mark.parametrize(
    ("place", "speed"), [((2.0, 0.3), (-5.0, 0.0)), ((1.0, 0.0), (0.0, 9.0)), ((2.0, 0.0), (-5.0, 0.0))]
)
def test_a_force_that_ends_at_an_edge_costs_no_accuracy(place, speed, tolerance):
    path = follow(Scene((Body(2.0, place, speed),), (Well(100.0, 1.0, 0.4),), until=2.0), tolerance)
    exact = run("atom", {"r0": place, "v0": speed}).observed["velocities"]
    assert math.dist(path.state[2:], exact) < 50.0 * tolerance * math.hypot(*speed)


def test_any_moment_can_be_looked_up():
    path = follow(Scene(PAIR, (Contact(2e4),)), 1e-12)
    stretches = path.stretches
    assert path.at(0.0) == list(stretches[0].before)
    for stretch in stretches[1:]:
        assert path.at(stretch.begin) == pytest.approx(stretch.before, abs=1e-14)
    half = 0.5 * stretches[0].lasts
    assert path.at(half)[:2] == pytest.approx((half, 0.0), abs=1e-14)


def _misses(scene):
    return never_meets(scene, start_of(scene))


def test_what_never_touches_is_seen_at_the_start():
    assert not _misses(Scene(PAIR, (Contact(1.0),)))
    assert _misses(Scene((PAIR[0], Body(0.1, (0.08, 0.041), (0.0, 0.0), 0.02)), (Contact(1.0),)))


@pytest.mark.parametrize("wrong", [3e-5, -3e-5])
def test_a_motion_whose_steps_are_wrong_is_not_handed_out(monkeypatch, wrong):
    """Each step makes all velocities a little too large or too small and does not know it: energy tells."""

    class Wrong(stepper.DOP853):
        def step(self):
            message = super().step()
            half = len(self.y) // 2
            self.y[half:] *= 1.0 + wrong
            return message

    monkeypatch.setattr(stepper, "DOP853", Wrong)
    with pytest.raises(GuardFailed, match="the energy changed by"):
        follow(Scene(PAIR, (Contact(2e4),)), 1e-10)


@pytest.mark.parametrize("rate", [150.0, 400.0, 2000.0])
@pytest.mark.parametrize("tolerance", [1e-6, 1e-8, 1e-10, 1e-12])
def test_a_fall_in_a_thick_fluid_takes_few_steps_and_its_error_holds(rate, tolerance):
    """What fades at `rate` (per s) holds explicit steps down; an implicit method follows the rest of the second."""
    u, v, g = 3.0, -2.0, 9.8
    scene = Scene((Body(1.0, (0.0, 0.0), (u, v)),), (Weight(g), Drag(0, linear=rate)), until=1.0)
    times = tuple(0.05 * i for i in range(21))
    found = play(scene, {O.VELOCITIES, O.TRAJECTORY}, tolerance, times)
    settled = g / rate

    def way(t):
        gone = -math.expm1(-rate * t)
        return u * gone / rate, (v + settled) * gone / rate - settled * t

    left = math.exp(-rate)
    truth = {
        "velocities": (u * left, (v + settled) * left - settled),
        "trajectory": [x for t in times for x in way(t)],
    }
    for name, values in truth.items():
        rows = zip(components(found.observed[name]), components(found.errors[name]), values, strict=True)
        assert all(abs(x - true) <= error for x, error, true in rows), name
        assert max(components(found.errors[name])) < 50.0 * tolerance
    assert len(follow(scene, tolerance).stretches) < 80


def test_bounces_gain_no_energy_from_how_touches_are_met():
    restitution, height, weight = 0.78, 0.39, 9.8
    scene = Scene(
        (Body(1.0, (3.0, height), (0.0, 0.0)),),
        (Weight(weight), HardWall((0.0, 1.0), 0.0, restitution)),
        until=2.15,
    )
    time, speed, bounces = math.sqrt(2.0 * height / weight), math.sqrt(2.0 * height * weight), 0
    while time < scene.until:
        time, speed, bounces = time + 2.0 * speed * restitution / weight, speed * restitution, bounces + 1
    found = follow(scene, 1e-11)
    assert len(found.happenings) == bounces == 11
    assert found.state[3] == pytest.approx(weight * (time - scene.until) - speed, abs=1e-12)
