"""Happenings without end: those that come to rest are followed to it, those that do not are refused by name."""

import math

import pytest

from corollary.scenes.forces.rod import String
from corollary.scenes.forces.wall import HardWall
from corollary.scenes.forces.weight import Weight
from corollary.scenes.motion.follow import follow
from corollary.scenes.plan import play
from corollary.scenes.run import BadSetting
from corollary.scenes.run import Observable as O
from corollary.scenes.scene import Body, Scene

NAIL = Body(math.inf, (0.0,), (0.0,))
G = 9.8


def hung(upper, lower, restitution, until=20.0):
    """Two balls of 2 kg and 0.7 kg on strings of 1 m and 0.8 m below each other, let go from these places."""
    strings = String((0, 1), 1.0, restitution), String((1, 2), 0.8, restitution)
    balls = Body(2.0, (upper,), (0.0,)), Body(0.7, (lower,), (0.0,))
    return Scene((NAIL, *balls), (*strings, Weight(G)), until=until)


@pytest.mark.parametrize("restitution", [0.3, 0.5153, 0.8])
def test_a_string_that_jerks_below_a_taut_one_comes_to_rest_when_its_bounces_are_over(restitution):
    path = follow(hung(-1.0, -1.3, restitution), 1e-10)
    fall = math.sqrt(2.0 * 0.5 / G)  # and each time up and down again a share of it
    assert path.rests[-1] == pytest.approx(fall * (1.0 + 2.0 * restitution / (1.0 - restitution)), abs=1e-5)
    assert path.state == pytest.approx((0.0, -1.0, -1.8, 0.0, 0.0, 0.0), abs=1e-9)


@pytest.mark.parametrize(("upper", "lower"), [(-0.9, -1.3), (-0.5, -0.6), (-0.2, -0.9)])
def test_strings_that_jerk_by_turns_come_to_rest_taut_together(upper, lower):
    found = play(hung(upper, lower, 0.5), {O.VELOCITIES, O.TRAJECTORY}, times=(20.0,))
    assert found.outcome == "sticks"
    assert found.observed["trajectory"] == pytest.approx((0.0, -1.0, -1.8), abs=1e-9)
    assert any("Zeno" in warning for warning in found.warnings)


def closing(until, restitution=1.0, radius=0.0):
    """A ball between a wall that comes with 1 m/s and one at rest, 2 m apart."""
    walls = HardWall((1.0,), 0.0, restitution, velocity=1.0), HardWall((-1.0,), -2.0, restitution)
    return Scene((Body(1.0, (1.0,), (0.3,), radius),), walls, until=until)


@pytest.mark.parametrize("restitution", [1.0, 0.4, 0.0])
def test_walls_that_leave_a_ball_no_room_are_refused_as_the_scene_is_made(restitution):
    with pytest.raises(BadSetting, match="no room between them from 2 s on"):
        closing(3.0, restitution)
    with pytest.raises(BadSetting, match=r"no room between them from 1\.5 s on"):
        closing(1.9, restitution, radius=0.25)
    assert play(closing(1.4, restitution), {O.VELOCITIES}).observed["velocities"]


def test_so_are_walls_that_functions_move():
    def swings(t):
        return 2.0 * math.sin(t), 2.0 * math.cos(t), -2.0 * math.sin(t)

    def made(until, only=()):
        walls = HardWall((0.0, 1.0), moves=swings), HardWall((0.0, -1.0), -1.9, only=only)
        return Scene(
            (Body(1.0, (0.0, 0.5), (0.0, 0.3)), Body(1.0, (1.0, 0.6), (0.0, 0.0))), walls, until=until
        )

    with pytest.raises(BadSetting, match=r"leave body \d no room"):
        made(2.0)
    made(1.0)
    for only in ((0,), (1,)):
        with pytest.raises(BadSetting, match=f"leave body {only[0]} no room"):
            made(2.0, only)
