"""What is read off a path: where the distance from the origin turns."""

from __future__ import annotations

import math

import pytest

from corollary.scenes.body import Body
from corollary.scenes.forces.wall import HardWall
from corollary.scenes.forces.weight import Weight
from corollary.scenes.plan import play
from corollary.scenes.run import Observable
from corollary.scenes.scene import Scene


@pytest.mark.parametrize("height", [0.7, 1.0, 2.0])
@pytest.mark.parametrize("flights", [2.2, 2.7, 3.7, 6.1])
def test_a_ball_thrown_back_at_the_origin_itself_returns_once_a_flight(height, flights):
    """Rounding puts the floor a little before or behind the origin: the distance would turn twice, and a third of the flights were one too many."""
    flight = 2.0 * math.sqrt(2.0 * height / 9.8)
    ball = Body(1.0, (height,), (0.0,))
    found = play(Scene((ball,), (Weight(9.8), HardWall((1.0,))), until=flights * flight), {Observable.PERIOD})
    measured = found.measured["period"]
    assert abs(measured.value - flight) <= measured.error < 1e-11
