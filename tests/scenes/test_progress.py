"""How far a scene has got is told while it is played: never less than before, and all of it in the end; at a terminal it is shown."""

import io
import math
import sys
import time
from itertools import pairwise

import pytest

from corollary import api
from corollary.derive.ready_scenes import run, with_conditions
from corollary.scenes import progress
from corollary.scenes.forces.contact import HardWall
from corollary.scenes.forces.fields import ForceFunction, Weight
from corollary.scenes.forces.flows import Drag
from corollary.scenes.plan import play
from corollary.scenes.progress import part, reported_to, tell, with_bar
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
        (lambda: run("ballistic_pendulum", {"mB": 1e-3, "v": 1.0}), 10),
        (lambda: api.play("cradle", N=3, q=1.5003), 10),
        (lambda: api.play("cradle", N=3, q=1.5004, conditions=False), 3),
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


class Terminal(io.StringIO):
    """Standard error as somebody looks at it."""

    def isatty(self):
        return True


def looked_at(monkeypatch):
    """Standard error as a terminal; within a test, for pytest takes it back before each."""
    monkeypatch.setenv("TERM", "xterm")
    terminal = Terminal()
    monkeypatch.setattr(sys, "stderr", terminal)
    return terminal


def pushed_until(seen):
    """A scene whose force waits, once it is asked on the way, until something is to be seen; for half a minute in all."""
    waits = iter(range(3000))

    def push(t, x, v):
        while t > 0.0 and not seen() and next(waits, None) is not None:
            time.sleep(0.01)
        return (math.sin(t),)

    return Scene((Body(1.0, (0.0,), (0.0,)),), (ForceFunction(0, push),), until=1.0, name="pushed")


def test_who_waits_at_a_terminal_sees_a_bar_and_how_far_it_has_got(monkeypatch):
    screen = looked_at(monkeypatch)
    with with_bar("scene cradle", after=0.0):
        tell(0.25)
        tell(0.5)
    assert "scene cradle" in screen.getvalue()
    assert "0:00:0" in screen.getvalue()


def test_a_scene_played_in_python_brings_its_bar_along(monkeypatch):
    screen = looked_at(monkeypatch)
    play(pushed_until(screen.getvalue), {O.VELOCITIES})
    assert "scene pushed" in screen.getvalue()


def test_who_listens_sees_no_bar(monkeypatch):
    screen = looked_at(monkeypatch)
    told = []
    with reported_to(told.append), with_bar("scene cradle", after=0.0):
        tell(0.5)
    assert told == [0.5]
    assert screen.getvalue() == ""


def test_a_short_wait_is_not_shown(monkeypatch):
    screen = looked_at(monkeypatch)
    with with_bar("scene cradle", after=3600.0):
        tell(0.5)
    assert screen.getvalue() == ""


def test_where_nobody_looks_nothing_is_drawn_and_nothing_waits_to_be(monkeypatch, capsys):
    monkeypatch.setattr(progress, "Thread", None)
    bounces()
    api.play("cradle", N=3, q=1.5005)
    with with_bar("scene cradle", after=0.0):
        tell(0.5)
    assert capsys.readouterr() == ("", "")


def test_without_any_standard_error_scenes_are_played(monkeypatch):
    monkeypatch.setattr(sys, "stderr", None)
    bounces()
