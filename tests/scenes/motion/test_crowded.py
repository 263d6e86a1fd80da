"""A body that is hit from two sides all but at once: the order of the hits decides, and where errors decide the order both are stated."""

import math

import pytest

from corollary.scenes.forces.wall import HardWall
from corollary.scenes.plan import play
from corollary.scenes.run import Observable as O
from corollary.scenes.scene import Body, Scene


def bounced(velocity, normal, restitution):
    along = sum(v * n for v, n in zip(velocity, normal, strict=True))
    return [v - (1.0 + restitution) * min(along, 0.0) * n for v, n in zip(velocity, normal, strict=True)]


@pytest.mark.parametrize("tolerance", [1e-6, 1e-10])
@pytest.mark.parametrize("aside", [1e-3, 1e-8, 1e-12, -1e-8, -1e-12])
@pytest.mark.parametrize(("lean", "restitution"), [(0.9, 0.5), (0.6, 0.3)])
def test_into_a_groove_a_little_beside_its_bottom(aside, lean, restitution, tolerance):
    """The near side is hit first, then the other, and so on, at one place, until it leaves both."""
    sides = (math.cos(lean), math.sin(lean)), (-math.cos(lean), math.sin(lean))
    velocity = [-0.1, -1.0]
    for normal in (sides[::-1] if aside > 0.0 else sides) * 4:
        velocity = bounced(velocity, normal, restitution)
    walls = tuple(HardWall(normal, restitution=restitution) for normal in sides)
    scene = Scene((Body(1.0, (0.1 + aside, 1.0), (-0.1, -1.0)),), walls, until=1.5)
    found = play(scene, {O.VELOCITIES}, tolerance)
    values, errors = found.observed["velocities"], found.errors["velocities"]
    said = any("from several sides all but at once" in each for each in found.warnings)
    assert said == (abs(aside) < 10.0 * tolerance or abs(aside) < 1e-9)
    if said:
        assert max(errors) > 1e-2
    if abs(aside) >= 1e-3:
        assert max(errors) < 1e-4
    assert all(abs(a - b) <= e for a, b, e in zip(values, velocity, errors, strict=True)), (values, velocity)


def test_hits_at_one_moment_are_taken_together():
    walls = HardWall((0.0, 1.0)), HardWall((1.0, 0.0))
    found = play(Scene((Body(1.0, (1.0, 1.0), (-1.0, -1.0)),), walls, until=1.5), {O.VELOCITIES})
    assert found.observed["velocities"] == pytest.approx((1.0, 1.0), abs=1e-11)
    assert not any("several sides" in each for each in found.warnings)
