"""Kinds of scenes that are not followed: each is refused by its name, as it is made, and at once."""

from __future__ import annotations

import math

import pytest

from corollary.scenes.forces.bonds import Rod, Spring, String
from corollary.scenes.forces.contact import Contact, Friction, HardWall
from corollary.scenes.forces.fields import ForceFunction, Weight
from corollary.scenes.plan import play
from corollary.scenes.run import BadSetting, Observable
from corollary.scenes.scene import Body, Scene

NAIL = Body(math.inf, (0.0, 0.0), (0.0, 0.0))
A, B = Body(1.0, (0.0, 0.0), (1.0, 0.0), 0.1), Body(2.0, (1.0, 0.0), (0.0, 0.0), 0.1)
ON_A_LINE = Body(1.0, (0.0,), (1.0,)), Body(2.0, (1.0,), (1.0,))
FLOOR = HardWall((0.0, 1.0), -1.0)
PUSH = ForceFunction(0, lambda t, x, v: (0.0, 1.0))
S = math.sqrt(0.5)
MOVED = NAIL, Body(math.inf, (1.0, 0.0), (-1.0, 0.0), 0.1)

REMOVED = {
    "friction between bodies": ((A, B), (Contact(1e4, mu=0.3),)),
    "friction between bodies, static only": ((A, B), (Contact(1e4, static=0.3),)),
    "a plate that a function swings": ((A,), (HardWall((0.0, 1.0), -1.0, moves=lambda t: (0.0, 0.0, 0.0)),)),
    "two tables": (ON_A_LINE[:1], (Friction(0, 0.3), Friction(0, 0.2))),
    "a wall that moves": ((A,), (HardWall((0.0, 1.0), -1.0, velocity=0.5),)),
    "a lift on a line": (ON_A_LINE[:1], (HardWall((1.0,), -1.0, velocity=-0.5),)),
    "bounces on a rough wall": ((A,), (HardWall((0.0, 1.0), -1.0, restitution=0.5, mu=0.1),)),
    "bounces on a wall that holds": ((A,), (HardWall((0.0, 1.0), -1.0, static=0.1),)),
    "a belt": (ON_A_LINE[:1], (Friction(0, 0.3, belt=(2.0,)),)),
    "two rough walls": (
        (A,),
        (HardWall((0.0, 1.0), -1.0, 0.0, mu=0.1), HardWall((1.0, 0.0), -1.0, 0.0, mu=0.1)),
    ),
    "a puck alone": ((A,), (Friction(0, 0.3),)),
    "a puck on a belt": ((A,), (Friction(0, 0.3, belt=(0.0, 2.0)),)),
    "a puck and a rough wall": ((A,), (Friction(0, 0.3), HardWall((0.0, 1.0), -1.0, 0.0, mu=0.1))),
    "a train on a table": (ON_A_LINE, (Rod((0, 1)), Friction(0, 0.3), Friction(1, 0.3))),
    "blocks on a string on a table": (ON_A_LINE, (String((0, 1), 2.0), Friction(0, 0.3), Friction(1, 0.3))),
    "a dumbbell on a rough floor": ((A, B), (Rod((0, 1)), HardWall((0.0, 1.0), -1.0, 0.0, mu=0.1))),
    "a puck that is pushed": ((A,), (Friction(0, 0.3), PUSH)),
    "a puck on a spring": ((A, B), (Friction(0, 0.3), Spring((0, 1), 5.0))),
    "a puck on a rod": ((NAIL, B), (Friction(1, 0.3), Rod((0, 1)))),
    "a puck at a cushion": ((A,), (Friction(0, 0.3), HardWall((1.0, 0.0), -1.0))),
    "pucks that collide": ((A, B), (Friction(0, 0.3), Contact(1e4))),
    "a ball in a groove": (
        (A,),
        (Weight(9.8), HardWall((S, S), -1.0), HardWall((-S, S), -1.0 - 1e-3), FLOOR),
    ),
    "a dumbbell over a floor": ((A, B), (Rod((0, 1)), FLOOR)),
    "a string and a wall": ((NAIL, B), (String((0, 1)), FLOOR)),
    "bodies without end of mass that near each other": (MOVED, ()),
    "a rod between such": (MOVED, (Rod((0, 1)),)),
    "a contact between such": (MOVED, (Contact(1e4),)),
    "strings in turn": ((A, B), (String((0, 1), 2.0, restitution=0.5), String((1, 0), 3.0, restitution=0.5))),
}
NAMED = {
    "friction between bodies": "friction between bodies is not followed",
    "friction between bodies, static only": "friction between bodies is not followed",
    "a plate that a function swings": "HardWall with moves: a wall that moves is not followed",
    "a wall that moves": "HardWall with velocity: a wall that moves is not followed",
    "a lift on a line": "HardWall with velocity: a wall that moves is not followed",
    "bounces on a rough wall": "bounces on a rough wall are not followed",
    "bounces on a wall that holds": "bounces on a rough wall are not followed",
    "a belt": "a belt that moves is not followed",
    "a puck alone": "a puck on a table is not followed",
    "a puck on a belt": "a belt that moves is not followed",
    "two tables": "several frictions act on body 0",
    "two rough walls": "several frictions act on body 0",
    "a puck and a rough wall": "a puck on a table is not followed",
    "a train on a table": "rods or strings tie bodies 0, 1, and friction acts on each",
    "blocks on a string on a table": "rods or strings tie bodies 0, 1, and friction acts on each",
    "a dumbbell on a rough floor": "rods or strings tie bodies 0, 1, and friction acts on each",
    "a puck that is pushed": "a puck on a table is not followed",
    "a puck on a spring": "a puck on a table is not followed",
    "a puck on a rod": "a puck on a table is not followed",
    "a puck at a cushion": "a puck on a table is not followed",
    "pucks that collide": "a puck on a table is not followed",
    "a ball in a groove": "hits at one moment with restitution are not followed",
    "a dumbbell over a floor": "hits at one moment with restitution are not followed",
    "a string and a wall": "hits at one moment with restitution are not followed",
    "bodies without end of mass that near each other": "different velocities: such bodies are not followed",
    "a rod between such": "different velocities: such bodies are not followed",
    "a contact between such": "different velocities: such bodies are not followed",
    "strings in turn": "strings that jerk in turn with restitution are not followed",
}


@pytest.mark.parametrize("kind", REMOVED)
def test_what_is_not_followed_is_refused_by_its_name_as_it_is_made(kind):
    bodies, forces = REMOVED[kind]
    with pytest.raises(BadSetting, match="^scene: .*" + NAMED[kind]) as refused:
        Scene(bodies, forces, until=1.0)
    assert str(refused.value).endswith(".")
    assert "\n" not in str(refused.value)


def test_it_is_refused_before_anything_is_followed():
    """No step is made: nothing of the integration is even asked for a slope."""
    asked = []

    def force(t, x, v):
        asked.append(t)
        return 0.0, 0.0

    with pytest.raises(BadSetting):
        Scene((A, B), (ForceFunction(0, force), Rod((0, 1)), FLOOR), until=1e6)
    assert set(asked) <= {0.0}
    assert len(asked) < 10


NEAR_TO_IT = {
    "walls that move as one": ((MOVED[1], Body(math.inf, (3.0, 0.0), (-1.0, 0.0)), A), (Contact(1e4),)),
    "one table for each of two blocks that nothing ties": (ON_A_LINE, (Friction(0, 0.3), Friction(1, 0.3))),
    "a block that pulls another over a table": (ON_A_LINE, (Rod((0, 1)), Friction(0, 0.3))),
    "a billiard": ((A,), (FLOOR, HardWall((1.0, 0.0), -1.0), HardWall((-1.0, 0.0), -3.0))),
    "a groove that gives nothing back": (
        (A,),
        (Weight(9.8), HardWall((S, S), -1.0, restitution=0.0), HardWall((-S, S), -1.0, restitution=0.0)),
    ),
    "a dumbbell that a wall is there for at one end": (
        (A, B),
        (Rod((0, 1)), HardWall((0.0, 1.0), -1.0, only=(0,))),
    ),
    "a flywheel in a corner, rubbed on one side": (
        (Body(1.0, (0.1, 0.1), (0.0, 0.0), 0.1, spin=5.0),),
        (HardWall((0.0, 1.0), 0.0, 0.0, mu=0.5), HardWall((1.0, 0.0), 0.0, 0.0), Weight(9.8)),
    ),
}


@pytest.mark.parametrize("kind", NEAR_TO_IT)
def test_what_is_near_to_it_is_followed(kind):
    bodies, forces = NEAR_TO_IT[kind]
    bodies = (
        tuple(Body(b.mass, b.place, (0.0, 0.0), b.radius) for b in bodies) if "dumbbell" in kind else bodies
    )
    found = play(Scene(bodies, forces, until=0.5), {Observable.VELOCITIES})
    assert found.measured["velocities"].relative_error < 1e-6
