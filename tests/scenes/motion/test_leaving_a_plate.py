"""What has rested forgets how it began; what throws it up again may make very much of a rounding, and errors are to know that."""

import math

import mpmath as mp
import pytest

from corollary.scenes.forces.wall import HardWall
from corollary.scenes.forces.weight import Weight
from corollary.scenes.motion.follow import follow
from corollary.scenes.plan import play
from corollary.scenes.run import Observable as O
from corollary.scenes.scene import Body, Scene

G = 9.8
WIDE, OFTEN, UNTIL = 0.059722441248018114, 34.67523727077692, 3.6240186379199404


def swung(wide, often, restitution, until):
    """A ball that rests on a plate as the plate, at a sin(w t), is fastest: it leaves, and is hit again and again."""

    def moves(t):
        return (
            wide * math.sin(often * t),
            wide * often * math.cos(often * t),
            -wide * often**2 * math.sin(often * t),
        )

    plate = HardWall((1.0,), restitution=restitution, moves=moves)
    return Scene((Body(1.0, (0.0,), (wide * often,)),), (Weight(G), plate), until=until)


def truth(wide, often, restitution, until, hits):
    """Place and velocity in the end: hit by hit, near these times (s), in 60 digits."""
    with mp.workdps(60):
        a, w, g, e = (mp.mpf(x) for x in (wide, often, G, restitution))
        t = mp.asin(g / (a * w * w)) / w
        y, v = a * mp.sin(w * t), a * w * mp.cos(w * t)
        for near in hits:
            then = mp.findroot(
                lambda s, y=y, v=v, t=t: y + v * (s - t) - g * (s - t) ** 2 / 2 - a * mp.sin(w * s),
                mp.mpf(near),
            )
            closing = v - g * (then - t) - a * w * mp.cos(w * then)
            t, y, v = then, a * mp.sin(w * then), a * w * mp.cos(w * then) - e * closing
        left = mp.mpf(until) - t
        return y + v * left - g * left**2 / 2, v - g * left


@pytest.mark.parametrize("tolerance", [1e-8, 1e-10, 1e-12, 1e-14])
@pytest.mark.parametrize(
    ("wide", "often", "restitution", "until"),
    [
        (WIDE, OFTEN, 0.9, UNTIL),
        (0.2000016638728229, 14.731317283483575, 0.9, 5.5447457563699345),
        (0.04655586374064796, 65.49235812578262, 0.9, 0.9593768627344725),
        (0.030666422261903987, 80.15780612010359, 0.95, 1.3325483242643785),
    ],
)
def test_what_hits_make_of_a_rounding_is_in_the_errors(wide, often, restitution, until, tolerance):
    """Two runs fall and fly alike, to the last digit: off by up to 800 times what they stated."""
    scene = swung(wide, often, restitution, until)
    hits = [each.time for each in follow(scene, 1e-12).happenings if each.what.startswith("hit")]
    place, velocity = truth(wide, often, restitution, until, hits)
    found = play(scene, {O.VELOCITIES, O.TRAJECTORY}, tolerance, (until,))
    assert abs(found.observed["velocities"][0] - velocity) <= found.errors["velocities"][0]
    assert abs(found.observed["trajectory"][0] - place) <= found.errors["trajectory"][0]


def test_how_much_that_is_can_be_seen_in_the_condition():
    found = play(swung(WIDE, OFTEN, 0.9, UNTIL), {O.VELOCITIES})
    assert found.measured["velocities"].condition > 1e5


def test_what_a_plate_carries_far_away_is_put_back_on_it_only_where_it_has_left_it():
    """Rounding of places, far from where they began, was more than is allowed to steps: each was followed by a new beginning."""

    def moves(t):
        return 0.48 * t + 3.35 * t * t, 0.48 + 6.7 * t, 6.7

    plate = HardWall((0.0, 1.0), restitution=0.16, mu=0.0165, moves=moves)
    ball = Body(0.13, (0.0, 0.074), (-1.46, 1.2), 0.05)
    path = follow(Scene((ball,), (Weight(13.4), plate), until=3.16), 5e-14)
    assert len(path.stretches) < 200
