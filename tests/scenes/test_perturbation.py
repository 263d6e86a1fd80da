"""What is changed to find how strongly values hang on the data, and that nothing which they hang on is forgotten."""

import math

import pytest

from corollary.scenes.forces.bonds import Rod
from corollary.scenes.forces.contact import Contact, HardWall
from corollary.scenes.forces.fields import Weight
from corollary.scenes.measure import CHANGED, perturbed
from corollary.scenes.plan import play
from corollary.scenes.run import Observable
from corollary.scenes.scene import Body, Scene

V = Observable.VELOCITIES


def condition(scene: Scene) -> float:
    found = play(scene, {V}, 1e-9).measured["velocities"].condition
    assert found is not None
    return found


def test_a_ball_let_go_from_rest_has_a_condition():
    ball, peg = Body(1.0, (0.31, 2.0), (0.0, 0.0), 0.1), Body(math.inf, (0.0, 0.0), (0.0, 0.0), 0.5)
    fallen = [condition(Scene((ball, peg), (Weight(9.8), Contact(1e6)), until=until)) for until in (0.4, 0.9)]
    assert fallen[1] > 1.0 > 1e6 * fallen[0]


def test_a_ball_that_flies_along_an_axis_has_a_condition_of_where_it_flies():
    pegs = [
        Body(math.inf, (2.0 * math.cos(a), 2.0 * math.sin(a)), (0.0, 0.0), radius=1.7)
        for a in (math.pi / 2, math.pi * 7 / 6, math.pi * 11 / 6)
    ]
    ball = Body(1.0, (0.01, 0.0), (3.0, 0.0), radius=0.05)
    scene = Scene((ball, *pegs), (Contact(k=1e6, q=1.5),), until=1.0)
    assert condition(scene) > 100.0


def test_what_touches_or_is_held_keeps_its_place():
    balls = [Body(1.0, (0.2 * i, 0.0), (3.0 if i == 0 else 0.0, 0.0), radius=0.1) for i in range(3)]
    hung = [Body(math.inf, (5.0, 1.0), (0.0, 0.0)), Body(2.0, (5.0, 0.0), (0.0, 0.0))]
    lies = Body(1.0, (8.0, -0.5), (0.0, 0.0))
    free = Body(1.0, (9.0, 4.0), (0.0, 0.0))
    scene = Scene(
        (*balls, *hung, lies, free),
        (Contact(k=1e6, q=1.5), Rod((3, 4)), Weight(9.8), HardWall((0.0, 1.0), -0.5, only=(5,))),
        until=1.0,
    )
    other = perturbed(scene)
    kept = [a.place == b.place for a, b in zip(scene.bodies, other.bodies, strict=True)]
    assert kept == [True] * 6 + [False]
    assert math.dist(other.bodies[6].place, free.place) == pytest.approx(CHANGED * 9.0, rel=1.0)
    assert all(a.mass != b.mass for a, b in zip(scene.bodies, other.bodies, strict=True) if a.mass < math.inf)
    assert not any(any(b.velocity) for b in other.bodies[1:])
