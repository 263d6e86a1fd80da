"""Bounces on a rough wall die away and are left out from some height on: what friction takes in them is known from momentum."""

import math

import pytest

from corollary.scenes.forces.wall import HardWall
from corollary.scenes.forces.weight import Weight
from corollary.scenes.plan import play
from corollary.scenes.run import Observable as O
from corollary.scenes.scene import Body, Scene

pytestmark = pytest.mark.whole

G = 9.8
TOLERANCES = (1e-6, 1e-8, 1e-10, 1e-12)


def bounced(speed, mu, restitution, later, tolerance, radius=0.0, spin=0.0, slope=0.0, height=0.6):
    """A ball let go above a rough slope; the speeds (m/s) down it and off it, and the spin, some time after its last bounce, all with errors."""
    along, off = (math.cos(slope), -math.sin(slope)), (math.sin(slope), math.cos(slope))
    fall = math.sqrt(2.0 * height / (G * math.cos(slope)))
    until = later * fall * (1.0 + 2.0 * restitution / (1.0 - restitution))
    place = tuple((height + radius) * n for n in off)
    ball = Body(0.7, place, tuple(speed * t for t in along), radius, spin=-spin)
    wall = HardWall(off, restitution=restitution, mu=mu)
    found = play(
        Scene((ball,), (Weight(G), wall), until=until), {O.VELOCITIES, O.SPINS} if radius else {O.VELOCITIES},
        tolerance,
    )  # fmt: skip
    velocity, error = found.observed["velocities"], max(found.errors["velocities"])
    down, up = (velocity[0] * x + velocity[1] * y for x, y in (along, off))
    turned = -found.observed["spins"][0] if radius else 0.0
    return until, down, up, turned, error


@pytest.mark.parametrize("tolerance", TOLERANCES)
@pytest.mark.parametrize(("radius", "restitution"), [(0.0, 0.3), (0.1, 0.5), (0.1, 0.9)])
def test_what_slips_all_the_time_is_braked_by_all_that_bears_it(tolerance, radius, restitution):
    """The floor gives all of the weight's momentum back, whatever the bounces: friction takes mu times as much."""
    until, down, up, _, error = bounced(80.0, 0.2, restitution, 1.2, tolerance, radius)
    assert down == pytest.approx(80.0 - 0.2 * G * until, abs=1e-11)
    assert (up, error < 80.0 * max(tolerance, 1e-11)) == (pytest.approx(0.0, abs=1e-12), True)


@pytest.mark.parametrize("tolerance", TOLERANCES)
@pytest.mark.parametrize("slope", [0.3, -0.3])
def test_what_rolls_in_the_end_keeps_its_angular_momentum_about_the_wall(tolerance, slope):
    """(1 + 2/5) v = v0 + 2/5 w0 r + g t sin: friction has no arm there."""
    until, down, _, turned, error = bounced(1.0, 0.9, 0.6, 1.5, tolerance, 0.2, 6.0, slope)
    assert down == pytest.approx((1.0 + 0.4 * 6.0 * 0.2 + G * until * math.sin(slope)) / 1.4, abs=2e-11)
    assert (turned * 0.2, error < 1e-6) == (pytest.approx(down, abs=1e-12), True)


def test_bounces_end_where_places_have_become_coarse():
    """Two hundred metres from where it began a bounce of 1e-13 m is none; they went on without end, and were refused."""
    slope = 0.8689309693312387
    until, down, up, turned, _ = bounced(
        3.4065027764534905, 1.2804396633900625, 0.8555046351938117, 1.00001, 1e-12, 0.3, 18.747411283493243, slope,
        1.317991901340249,
    )  # fmt: skip
    begun = 3.4065027764534905 + 0.4 * 18.747411283493243 * 0.3
    assert down == pytest.approx((begun + G * until * math.sin(slope)) / 1.4, abs=1e-9)
    assert (up, turned * 0.3) == (pytest.approx(0.0, abs=1e-12), pytest.approx(down, abs=1e-9))
