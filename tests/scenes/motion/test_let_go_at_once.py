"""Bodies that have nothing to do with each other, and whose friction lets go of them at one moment."""

import math

import pytest

from corollary.scenes.forces.friction import Friction
from corollary.scenes.forces.function import ForceFunction
from corollary.scenes.forces.wall import HardWall
from corollary.scenes.forces.weight import Weight
from corollary.scenes.plan import play
from corollary.scenes.run import Observable as O
from corollary.scenes.run import components
from corollary.scenes.scene import Body, Scene

G, HARDER, UNTIL = 9.8, 4.0, 2.0


def pulled(mass, way):
    """A force that grows as time does."""
    return lambda t, x, v: tuple(mass * HARDER * t * w for w in way)


@pytest.mark.parametrize("count", [1, 2, 3])
@pytest.mark.parametrize("static", [0.3, 0.4])
@pytest.mark.parametrize("way", [(1.0,), (1.0, 0.0), (0.6, 0.8)])
def test_blocks_pulled_alike_set_off_together(way, static, count):
    """Each began to slip, had the others held anew, and was held anew as they began: no time passed."""
    nothing = (0.0,) * len(way)
    masses = [1.0 + 0.3 * i for i in range(count)]
    bodies = tuple(Body(m, (3.0 * i, *nothing[1:]), nothing) for i, m in enumerate(masses))
    forces = [ForceFunction(i, pulled(m, way)) for i, m in enumerate(masses)]
    forces += [Friction(i, 0.3, static=static) for i in range(count)]
    found = play(Scene(bodies, tuple(forces), until=UNTIL), {O.VELOCITIES}, 1e-9)
    begun = static * G / HARDER
    speed = 0.5 * HARDER * (UNTIL**2 - begun**2) - 0.3 * G * (UNTIL - begun)
    true = [speed * w for w in way] * count
    errors = components(found.errors["velocities"])
    assert all(abs(a - b) <= e for a, b, e in zip(found.observed["velocities"], true, errors, strict=True))
    # Where friction holds as much as it takes, a puck that is pulled across has no direction as it sets off.
    if static > 0.3 or way != (0.6, 0.8):
        assert max(errors) < 1e-8


@pytest.mark.parametrize("tolerance", [1e-6, 1e-10])
@pytest.mark.parametrize("other", [(0.5, 0.05), (1.0, 0.1)])
def test_balls_on_one_plate_that_begin_to_skid_together(other, tolerance):
    """All balls of one kind are held by the same share of their weight: two on a swinging rough slope let go together, as each does alone."""
    slope, often = 0.5, 12.0
    wide = 0.5 * G / often**2

    def moves(t):
        return (
            wide * math.sin(often * t),
            wide * often * math.cos(often * t),
            -wide * often**2 * math.sin(often * t),
        )

    along, off = (math.cos(slope), math.sin(slope)), (-math.sin(slope), math.cos(slope))

    def ball(far, mass, radius):
        place = tuple(far * a + radius * n for a, n in zip(along, off, strict=True))
        return Body(mass, place, tuple(wide * often * n for n in off), radius)

    plate = HardWall(off, 0.0, 0.0, 0.2, moves=moves)
    played = [
        play(Scene(bodies, (Weight(G), plate), until=0.6), {O.VELOCITIES}, tolerance)
        for bodies in ((ball(0.0, 1.0, 0.1),), (ball(0.0, 1.0, 0.1), ball(1.0, *other)))
    ]
    (alone, off_alone), (both, off_both) = (
        (f.observed["velocities"], components(f.errors["velocities"])) for f in played
    )
    assert max(off_both) < 1e3 * tolerance
    for i in range(4):
        assert abs(both[i] - alone[i % 2]) <= off_both[i] + off_alone[i % 2]
