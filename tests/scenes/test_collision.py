"""A collision on a line by its planned model: what it states of its error holds, and nothing is found twice."""

import pytest

from corollary.scenes.forces.contact import Contact
from corollary.scenes.integrate import regularised
from corollary.scenes.line_collision import collide
from corollary.scenes.row import RowOfBodies


def cradle(count, q, masses=None):
    velocities = (1.0, *(0.0,) * (count - 1))
    return RowOfBodies(
        masses or (1.0,) * count, velocities, (0.0,) * (count - 1), (Contact(1.0, q),) * (count - 1)
    )


def off(found, line):
    """The largest difference of a velocity from a run as fine as doubles allow."""
    exact = regularised.collide(line, 1e-14)
    return max(abs(a - b) for a, b in zip(found.result.velocities, exact.velocities, strict=True))


@pytest.mark.parametrize("mass", [1e-5, 1e-4, 1e-3, 1.0])
def test_a_light_spring_ball_is_known_as_well_as_is_stated(mass):
    line = cradle(3, 1.0, (1.0, mass, 1.0))
    found = collide(line, 1e-12)
    assert off(found, line) <= found.errors["velocities"] + 1e-13 / mass


@pytest.mark.parametrize("count", [3, 5, 30])
@pytest.mark.parametrize("tolerance", [1e-6, 1e-9])
def test_the_error_stated_is_never_less_than_the_true_one(count, tolerance):
    line = cradle(count, 1.5)
    found = collide(line, tolerance)
    assert off(found, line) <= found.errors["velocities"] <= 1e3 * tolerance


def test_a_collision_is_found_once_and_kept():
    assert collide(cradle(3, 1.5), 1e-9) is collide(cradle(3, 1.5), 1e-9)
