"""A force of somebody's own is one class: defined here, it is integrated, stopped at its events, watched and planned like the house's."""

import math
from dataclasses import dataclass

import pytest

from corollary.scenes.plan import plan, play
from corollary.scenes.run import BadSetting, GuardFailed, Observable
from corollary.scenes.scene import (
    Body,
    Conserves,
    ContactForce,
    Event,
    Force,
    Scene,
    overlap,
    place,
    seen_from,
    velocity,
)

V = {Observable.VELOCITIES}
ENERGY = {Observable.ENERGY}


@dataclass(frozen=True)
class QuadraticDrag(Force):
    """-c |v| v on one body."""

    body: int
    c: float

    def act(self, scene, state, masses, since):
        v = velocity(scene, state, self.body)
        yield self.body, [-self.c * math.hypot(*v) * x for x in v]

    @property
    def bodies(self):
        return (self.body,)


@dataclass(frozen=True)
class QuarticSpring(Force):
    """Every body is pulled to the origin of a line by k x^3; `forgotten` is a factor too much in its potential."""

    k: float
    forgotten: float = 1.0

    def act(self, scene, state, masses, since):
        for i in range(len(scene.bodies)):
            yield i, [-self.k * place(scene, state, i)[0] ** 3]

    def potential(self, scene, state):
        places = (place(scene, state, i)[0] for i in range(len(scene.bodies)))
        return self.forgotten * sum(self.k * x**4 / 4.0 for x in places)

    @property
    def conserves(self):
        return Conserves.ENERGY


@dataclass(frozen=True)
class Mud(Force):
    """A constant brake where x is between two places."""

    brake: float
    begins: float
    ends: float

    def act(self, scene, state, masses, since):
        if self.begins <= place(scene, since, 0)[0] < self.ends:
            yield 0, [-self.brake]

    def events(self, scene):
        yield Event(lambda y: place(scene, y, 0)[0] - self.begins)
        yield Event(lambda y: place(scene, y, 0)[0] - self.ends)


@dataclass(frozen=True)
class Mirror(Force):
    """Turns the velocity round at x = 1, in no time."""

    def act(self, scene, state, masses, since):
        return ()

    def events(self, scene):
        yield Event(lambda y: 1.0 - place(scene, y, 0)[0], 0, lambda y: [-v for v in velocity(scene, y, 0)])


@dataclass(frozen=True)
class Cushion(ContactForce):
    """A contact that pushes k (overlap + overlap^2)."""

    k: float

    def between(self, scene, state, a, b):
        depth, _ = overlap(scene, state, a, b)
        apart, _ = seen_from(scene, state, a, b)
        push = self.k * (depth + depth**2) if depth > 0.0 else 0.0
        return [push * x / math.hypot(*apart) for x in apart]

    def potential(self, scene, state):
        depth = max(overlap(scene, state, 0, 1)[0], 0.0)
        return self.k * (depth**2 / 2.0 + depth**3 / 3.0)

    @property
    def conserves(self):
        return Conserves.ENERGY | Conserves.MOMENTUM


def on_a_line(x, v, *forces, until=2.0, mass=1.0):
    return Scene((Body(mass, (x,), (v,)),), forces, until=until)


def test_quadratic_drag_slows_as_its_closed_form_says():
    found = play(
        on_a_line(0.0, 3.0, QuadraticDrag(0, 0.8), mass=2.0), V | {Observable.TRAJECTORY}, times=(2.0,)
    )
    assert found.model == "integration"
    assert found.observed["velocities"] == pytest.approx((3.0 / (1.0 + 0.4 * 3.0 * 2.0),), rel=1e-9)
    assert found.observed["trajectory"] == pytest.approx((math.log1p(0.4 * 3.0 * 2.0) / 0.4,), rel=1e-9)


def test_a_quartic_spring_keeps_its_period_and_its_energy():
    k, m, far = 5.0, 0.3, 0.7
    quarter = 0.25 * math.sqrt(m / k) / far * math.gamma(0.25) ** 2 / math.sqrt(math.pi)
    scene = on_a_line(far, 0.0, QuarticSpring(k), until=quarter, mass=m)
    found = play(scene, V | {Observable.TRAJECTORY}, times=(quarter,)).observed
    assert found["velocities"] == pytest.approx((-math.sqrt(k / (2.0 * m)) * far**2,), rel=1e-8)
    assert found["trajectory"] == pytest.approx((0.0,), abs=1e-8)
    assert (
        plan(scene, ENERGY).model == "integration"
    )  # that it is kept is the author's word until it is followed
    energy = play(scene, ENERGY)
    assert abs(energy.observed["energy"] - k * far**4 / 4.0) <= energy.errors["energy"] < 1e-10


def test_a_potential_that_is_not_the_force_s_is_found_out():
    with pytest.raises(GuardFailed, match="the energy changed by"):
        play(on_a_line(0.7, 0.0, QuarticSpring(5.0, forgotten=1.001), until=0.3), V)
    with pytest.raises(GuardFailed, match="the energy changed by"):
        play(on_a_line(0.7, 0.0, QuarticSpring(5.0, forgotten=1.001), until=0.3), ENERGY)


def test_a_force_that_begins_and_ends_at_a_place_is_stopped_at_there():
    scene = on_a_line(0.0, 3.0, Mud(4.0, 1.0, 1.5), until=1.0)
    found = play(scene, V)
    assert found.observed["velocities"] == pytest.approx((math.sqrt(9.0 - 2.0 * 4.0 * 0.5),), rel=1e-12)
    assert plan(scene, ENERGY).model == "integration"


def test_a_force_that_acts_in_no_time_turns_a_body():
    found = play(on_a_line(0.0, 2.0, Mirror(), until=1.0), V | {Observable.TRAJECTORY}, times=(0.25, 1.0))
    assert found.observed["velocities"] == (-2.0,)
    assert found.observed["trajectory"] == pytest.approx((0.5, 0.0), abs=1e-12)


def test_a_contact_of_ones_own_ends_the_scene_when_all_is_apart():
    bodies = (Body(1.0, (0.0, 0.0), (1.0, 0.0), 0.1), Body(3.0, (0.5, 0.0), (0.0, 0.0), 0.1))
    found = play(Scene(bodies, (Cushion(4e3),)), V | {Observable.PEAK_FORCE, Observable.LARGEST_OVERLAP})
    assert found.outcome == "released"
    assert found.observed["velocities"] == pytest.approx((-0.5, 0.0, 0.5, 0.0), abs=1e-8)
    deepest = found.observed["largest_overlap"]
    assert 4e3 * (deepest**2 / 2.0 + deepest**3 / 3.0) == pytest.approx(0.5 * 0.75, rel=1e-7)
    assert found.observed["peak_force"] == pytest.approx(4e3 * (deepest + deepest**2), rel=1e-7)
    assert play(Scene(bodies, (Cushion(4e3),)), {Observable.MOMENTUM}).model == "conservation"


def test_a_force_that_names_a_body_that_is_not_there_is_refused():
    with pytest.raises(BadSetting, match="names a body that is not there"):
        on_a_line(0.0, 1.0, QuadraticDrag(1, 0.8))
