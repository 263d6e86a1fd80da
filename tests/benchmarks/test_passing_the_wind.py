"""Quadratic drag where a body all but stops in the wind: thrown up steeply, its speed is least at the top, and bends there."""

from __future__ import annotations

import math
from random import Random

import numpy as np
import pytest
from benchmarks.composed.reference import follow

from corollary.scenes.forces.drag import Drag
from corollary.scenes.forces.weight import Weight
from corollary.scenes.plan import play
from corollary.scenes.run import Observable as O
from corollary.scenes.scene import Body, Scene

G = 9.8


@pytest.mark.parametrize("number", range(8))
def test_a_steep_throw_in_wind_is_within_its_error(number):
    """A step over the top hides it from its estimate, in two runs alike: places had been off by five times what was stated."""
    draw = Random(f"steep {number}")
    mass, quadratic = draw.uniform(0.1, 1.0), draw.uniform(0.02, 0.3)
    wind = draw.uniform(-1.0, 1.0), draw.uniform(-1.0, 1.0)
    across, until = 10.0 ** draw.uniform(-2.0, -1.0), draw.uniform(0.8, 2.0)
    velocity = wind[0] + across, wind[1] + draw.uniform(2.0, 8.0)

    def slope(t, y, flags):
        u, w = y[2] - wind[0], y[3] - wind[1]
        pull = quadratic / mass * np.sqrt(u * u + w * w)
        return [y[2], y[3], -pull * u, -G - pull * w]

    true = follow(slope, (0.0, 0.0, *velocity), until)
    scene = Scene(
        (Body(mass, (0.0, 0.0), velocity),), (Weight(G), Drag(0, 0.0, quadratic, wind)), until=until
    )
    for tolerance in (1e-8, 1e-10, 1e-12):
        found = play(scene, {O.VELOCITIES, O.TRAJECTORY}, tolerance, (until,))
        for name, values in (("trajectory", true[:2]), ("velocities", true[2:])):
            off = [abs(float(x - y)) for x, y in zip(found.observed[name], values, strict=True)]
            assert all(x <= error for x, error in zip(off, found.errors[name], strict=True))
            assert max(found.errors[name]) < 1e3 * tolerance


def test_a_throw_straight_up_in_a_plane_passes_its_top():
    """There drag is not smooth at all; steps go there as near as they resolve, and then over it."""
    fast = math.sqrt(G / 0.2)
    for tolerance in (1e-6, 1e-9, 1e-12):
        scene = Scene(
            (Body(1.0, (0.0, 0.0), (0.0, 5.0)),),
            (Weight(G), Drag(0, 0.0, 0.2)),
            until=fast / G * math.atan(5.0 / fast) + 1.0,
        )
        found = play(scene, {O.VELOCITIES}, tolerance)
        assert (
            abs(found.observed["velocities"][1] + fast * math.tanh(G / fast)) <= found.errors["velocities"][1]
        )
