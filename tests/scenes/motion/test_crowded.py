"""A body that is hit from two sides all but at once: the order of the hits decides, and where errors decide the order both are stated."""

import math

import pytest

from corollary.scenes.forces.rod import String
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


@pytest.mark.parametrize(
    ("lean", "restitution", "said"),
    [
        (0.9, 0.0, True),
        (0.9, 0.5, True),
        (0.6, 1.0, True),
        (0.6, 0.0, False),
        (math.pi / 4.0, 0.5, False),
        (math.pi / 4.0, 0.0, False),
    ],
)
def test_into_the_very_bottom_of_a_groove_the_order_of_the_hits_may_matter(lean, restitution, said):
    """It matters where one side after the other leaves the body otherwise; then it is said, and the rule taken."""
    sides = (math.cos(lean), math.sin(lean)), (-math.cos(lean), math.sin(lean))
    in_turn = [0.0, -1.0]
    for normal in sides * 20:
        in_turn = bounced(in_turn, normal, restitution)
    assert (math.dist(in_turn, (0.0, restitution)) > 1e-6) == said
    walls = tuple(HardWall(normal, restitution=restitution) for normal in sides)
    found = play(Scene((Body(1.0, (0.0, 1.0), (0.0, -1.0)),), walls, until=1.5), {O.VELOCITIES})
    assert found.observed["velocities"] == pytest.approx((0.0, restitution), abs=1e-7)
    assert any("one after the other they would leave it otherwise" in each for each in found.warnings) == said


@pytest.mark.parametrize(("fast", "said"), [(1.0, True), (0.0, False)])
def test_a_jerk_that_meets_a_taut_elastic_string(fast, said):
    """The middle body hangs on both: in turn, the second string would throw back what the first one has set moving."""
    bodies = tuple(Body(1.0, (x,), (fast * (x > 1.0),)) for x in (0.0, 0.6, 1.1))
    strings = String((0, 1), 0.6, 0.5), String((1, 2), 0.6, 0.5)
    found = play(Scene(bodies, strings, until=0.5), {O.VELOCITIES})
    assert any("hit while something else holds it" in each for each in found.warnings) == said


def test_hits_at_one_moment_are_taken_together():
    walls = HardWall((0.0, 1.0)), HardWall((1.0, 0.0))
    found = play(Scene((Body(1.0, (1.0, 1.0), (-1.0, -1.0)),), walls, until=1.5), {O.VELOCITIES})
    assert found.observed["velocities"] == pytest.approx((1.0, 1.0), abs=1e-11)
    assert not any("several sides" in each for each in found.warnings)
