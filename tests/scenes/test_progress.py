"""How far a scene has got is told while it is played: never less than before, and all of it in the end."""

from itertools import pairwise

import pytest

from corollary.scenes.catalogue import run
from corollary.scenes.condition import with_conditions
from corollary.scenes.forces.drag import Drag
from corollary.scenes.forces.wall import HardWall
from corollary.scenes.forces.weight import Weight
from corollary.scenes.plan import play
from corollary.scenes.progress import part, reported_to, tell
from corollary.scenes.run import Observable as O
from corollary.scenes.scene import Body, Scene


def bounces():
    floor = HardWall((1.0,), restitution=0.8)
    play(
        Scene((Body(1.0, (2.1234,), (0.0,)),), (Weight(9.8), Drag(0, 0.03), floor), until=2.0), {O.VELOCITIES}
    )


@pytest.mark.parametrize(
    ("played", "least"),
    [
        (bounces, 10),
        (lambda: run("cradle", {"N": 3, "q": 1.5001}), 3),
        (lambda: with_conditions(run("cradle", {"N": 3, "q": 1.5002}), 1e-9), 10),
    ],
)
def test_a_listener_is_told_ever_more(played, least):
    told = []
    with reported_to(told.append):
        played()
        tell(1.0)
    assert len(told) > least
    # Two runs one after the other, each of them told as a whole, begin anew; within each it only grows.
    falls = [(a, b) for a, b in pairwise(told) if b < a]
    assert all(b == 0.0 for _, b in falls)
    assert min(told) >= 0.0
    assert max(told) == 1.0


def test_a_part_is_a_share_of_the_whole():
    told = []
    with reported_to(told.append), part(0.5, 1.0), part(0.0, 0.5):
        tell(0.5)
    assert told == [0.5, 0.5, 0.625, 0.75, 1.0]


def test_nobody_need_listen():
    with part(0.0, 0.5):
        tell(0.3)
