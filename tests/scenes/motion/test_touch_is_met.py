"""A contact begins and ends where bodies touch, not where rounding lets it be seen: a dashpot feels each rounding of the way."""

import math

import pytest

from corollary.scenes.forces.bonds import Rod
from corollary.scenes.forces.contact import Contact, HardWall
from corollary.scenes.forces.fields import Weight
from corollary.scenes.plan import play
from corollary.scenes.run import Observable as O
from corollary.scenes.scene import Body, Scene

pytestmark = pytest.mark.whole


@pytest.mark.parametrize("stiffness", [1e4, 1e6, 1e8, 1e10])
@pytest.mark.parametrize("share", [0.3, 0.6, 0.9])
@pytest.mark.parametrize("tolerance", [1e-10, 1e-12])
def test_a_damped_contact_far_from_the_origin(stiffness, share, tolerance):
    """Half a damped swing, with this share of critical damping; a third body far off makes the places long."""
    a, b, speed = 1.3, 0.4, 2.0
    mass = a * b / (a + b)
    w = math.sqrt(stiffness / mass)
    contact = Contact(stiffness, 1.0, 2.0 * share * w * mass)
    bodies = (
        Body(a, (0.3, 0.0), (speed, 0.0), 0.1),
        Body(b, (0.7, 0.0), (0.0, 0.0), 0.12),
        Body(1.0, (9.0, 7.0), (0.0, 0.0), 0.05),
    )
    swings = math.sqrt(1.0 - share**2)
    out = speed * math.exp(-math.pi * share / swings)
    first = (a * speed - b * out) / (a + b)
    found = play(Scene(bodies, (contact,), until=0.5), {O.VELOCITIES, O.DURATION}, tolerance)
    for name, i, truth in (
        ("velocities", 0, first),
        ("velocities", 2, first + out),
    ):
        assert abs(found.observed[name][i] - truth) <= found.errors[name][i] < 1e-6
    assert abs(found.observed["duration"] - math.pi / w / swings) <= found.errors["duration"]


@pytest.mark.parametrize("nail", [0.05, 0.85])
def test_a_point_that_no_contact_serves_is_not_overlapped(nail):
    mass, speed, stiffness = 1.0, 1.0, 1e4
    bodies = (
        Body(mass, (0.0, 0.0), (speed, 0.0), 0.1),
        Body(mass, (0.3, 0.0), (0.0, 0.0), 0.1),
        Body(math.inf, (nail, 0.03), (0.0, 0.0)),
    )
    scene = Scene(bodies, (Contact(stiffness, 1.0, chosen=((0, 1),)),), until=1.0)
    found = play(scene, {O.LARGEST_OVERLAP}).measured["largest_overlap"]
    assert abs(found.value - speed * math.sqrt(0.5 * mass / stiffness)) <= found.error < 1e-11


@pytest.mark.parametrize("restitution", [0.3, 0.5, 0.8, 1.0])
def test_a_pendulum_that_is_put_back_on_its_rod_hits_its_wall_once(restitution):
    """The second hit, at once, is of rounding: it is no other order of what happens."""
    nail, bob = Body(math.inf, (0.0, 0.0), (0.0, 0.0)), Body(0.2, (-0.6, -0.56), (0.0, 0.0), 0.044)
    wall = HardWall((-1.0, 0.0), -0.295, restitution=restitution, only=(1,))
    scene = Scene((nail, bob), (Rod((0, 1)), Weight(9.8), wall), until=1.2)
    assert play(scene, {O.VELOCITIES}, 1e-6).warnings == ()
