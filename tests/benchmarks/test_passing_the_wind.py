"""Quadratic drag where a body all but stops in the wind: thrown up steeply, its speed is least at the top, and bends there."""

from __future__ import annotations

import math
from random import Random

import pytest
from benchmarks.composed.case import judged
from benchmarks.composed.fields import thrown_steeply

from corollary.scenes.forces.fields import Weight
from corollary.scenes.forces.flows import Drag
from corollary.scenes.plan import play
from corollary.scenes.run import Observable as O
from corollary.scenes.scene import Body, Scene

pytestmark = pytest.mark.whole

G = 9.8


@pytest.mark.parametrize("number", range(8))
def test_a_steep_throw_in_wind_is_within_its_error(number):
    """A step over the top hides it from its estimate, in two runs alike: places had been off by five times what was stated."""
    case = thrown_steeply(Random(f"steep {number}"))
    for tolerance in (1e-8, 1e-10, 1e-12):
        verdict = judged(case, tolerance)
        assert verdict.outcome == "right", verdict.why
        assert verdict.relative < 1e3 * tolerance


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
