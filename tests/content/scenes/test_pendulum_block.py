"""What the hit of pendulum and block leaves out, against a pendulum that goes on swinging while they touch."""

import math

import pytest

from corollary.derive.ready_scenes import run
from corollary.scenes.run import BadSetting, GuardFailed


def swinging_hit(k, m=1.0, block=2.0, length=1.0, g=9.8, steps=4000):
    """Velocities (sphere level, block) after the touch: the sphere on its arc, the block on the table, Runge-Kutta steps of order 4."""
    v = math.sqrt(2.0 * g * length)
    touch = (
        1.05 * run("pendulum_block", {"m": m, "M": block, "L": length, "g": g, "k": k}).observed["duration"]
    )

    def slope(y):
        angle, turning, _, pushed = y
        force = k * max(length * math.sin(angle) - y[2], 0.0) ** 1.5
        return (
            turning,
            -g / length * math.sin(angle) - force * math.cos(angle) / (m * length),
            pushed,
            force / block,
        )

    def ahead(y, dy, h):
        return [a + h * b for a, b in zip(y, dy, strict=True)]

    y, h = [0.0, v / length, 0.0, 0.0], touch / steps
    for _ in range(steps):
        a = slope(y)
        b = slope(ahead(y, a, 0.5 * h))
        c = slope(ahead(y, b, 0.5 * h))
        d = slope(ahead(y, c, h))
        y = [
            now + h / 6.0 * (p + 2.0 * q + 2.0 * r + s) for now, p, q, r, s in zip(y, a, b, c, d, strict=True)
        ]
        if length * math.sin(y[0]) < y[2]:
            break
    return length * y[1] * math.cos(y[0]), y[3]


@pytest.mark.parametrize("k", [1e5, 1e6, 1e7])
def test_the_swing_during_the_touch_stays_within_the_error_stated(k):
    found = run("pendulum_block", {"k": k})
    true = swinging_hit(k)
    off = math.dist(true, found.observed["velocities"]) / found.observed["speed_before"]
    assert 1e-3 * found.relative_error("velocities") < off < found.relative_error("velocities")
    height = (true[0] ** 2 / 19.6 - found.observed["height"]) / 1.0
    assert abs(height) < found.relative_error("height")


def test_a_sphere_that_all_but_stops_is_known_no_better_than_the_swing_lets_it():
    """With a block as heavy as itself it keeps next to nothing: what the swing adds is all there is."""
    settings = {"m": 9.0625, "M": 9.0077, "L": 0.11743, "g": 25.112, "k": 4.4e5}
    found = run("pendulum_block", settings)
    level, _ = swinging_hit(4.4e5, 9.0625, 9.0077, 0.11743, 25.112)
    off = abs(level**2 / (2.0 * 25.112) - found.observed["height"])
    assert 3.0 * found.observed["height"] < off < found.errors["height"]


@pytest.mark.parametrize(
    "settings",
    [
        {"m": 1e300, "M": 1.7976931348623157e308, "L": 1e-300, "g": 1e-300, "k": 5e-324},
        {"m": 1e300, "M": 1e-300, "L": 1.79e308, "g": 1.79e308, "k": 6e-256},
    ],
)
def test_what_no_double_holds_is_refused_in_a_sentence(settings):
    with pytest.raises((BadSetting, GuardFailed), match="number"):
        run("pendulum_block", settings)
