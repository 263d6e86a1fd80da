"""A ball that its damping keeps on the floor, and one that only lies there."""

import math

import mpmath as mp
import pytest

from corollary.derive.ready_scenes import run
from corollary.scenes.run import BadSetting


@pytest.mark.parametrize("q", [1.0, 1.5, 3.0])
@pytest.mark.parametrize("eta", [15.0, 21.8, 60.0, 1e4])
def test_the_floor_carries_what_it_has_stopped(q, eta):
    """It comes down so slowly that nothing on the way pushes as hard as its weight does in the end."""
    m, g = 0.46, 9.8
    found = run("ball_on_floor", {"m": m, "k": 2.4e4, "v0": -0.01, "R": 1.0, "y0": 1.0, "q": q, "eta": eta})
    assert found.outcome == "sticks"
    assert found.observed["peak_force"] >= m * g * (1.0 - 1e-12)
    assert found.observed["largest_overlap"] >= (m * g / 2.4e4) ** (1.0 / q) * (1.0 - 1e-12)


def test_a_ball_that_its_weight_makes_faster_is_stopped_by_more_than_its_weight():
    """Newton's second law in steps of 1e-5 s: it is met slowly, gains speed, and has to lose it before it rests."""
    m, k, v, eta, g = 0.45652582896429345, 24203.625059209153, 0.10495319506253988, 21.841234744012915, 9.8
    found = run(
        "ball_on_floor", {"m": m, "k": k, "v0": -v, "R": 1.0, "y0": 1.0, "q": 3.0, "eta": eta, "g": g}
    )
    overlap, hardest, h = 0.0, 0.0, 1e-5
    for _ in range(50_000):
        halfway = overlap + 0.5 * h * v
        force = k * halfway**3 + eta * v
        v += h * (g - force / m) / (1.0 + 0.5 * h * eta / m)
        overlap = halfway + 0.5 * h * v
        hardest = max(hardest, force)
    assert found.observed["peak_force"] == pytest.approx(hardest, rel=1e-3)
    assert hardest > 1.05 * m * g


@pytest.mark.parametrize("q", [1.0, 1.5, 2.5])
def test_a_ball_laid_on_the_floor_sinks_in(q):
    """From rest it goes to where the floor pushes q + 1 times as hard as weight, and back; the duration by tanh-sinh quadrature."""
    m, k, g = 0.1, 1e6, 9.8
    found = run("ball_on_floor", {"m": m, "k": k, "q": q, "y0": 0.02, "v0": 0.0, "g": g})
    deep = ((q + 1.0) * m * g / k) ** (1.0 / q)
    half = mp.quad(lambda u: 1 / mp.sqrt(u - u ** (mp.mpf(q) + 1)), [0, 0.5, 1])
    wanted = {
        "peak_force": (q + 1.0) * m * g,
        "largest_overlap": deep,
        "duration": float(mp.sqrt(2 * deep / g) * half),
        "rebound_speed": 0.0,
    }
    assert found.outcome == "released"
    for name, value in wanted.items():
        assert found.observed[name] == pytest.approx(value, rel=1e-9)
    assert "energy_ratio" not in found.observed
    near = run("ball_on_floor", {"m": m, "k": k, "q": q, "y0": 0.02, "v0": -1e-9, "g": g})
    assert near.observed["duration"] == pytest.approx(wanted["duration"], rel=1e-5)
    with pytest.raises(BadSetting, match="lies on the floor"):
        run("ball_on_floor", {"y0": 0.02, "v0": 0.0, "eta": 0.1})


@pytest.mark.parametrize("thick", [1e-6, 1e-13])
def test_a_fall_that_is_rounding_of_what_weight_does_is_refused_before_it_is_followed(thick):
    """Steps never saw whether it leaves again, and said so after 400 000 of them."""
    deep = (9.8 / 1e4) ** (1.0 / 1.5)
    eta = thick * math.sqrt(1e4 * math.sqrt(deep))
    given = {"m": 1.0, "k": 1e4, "q": 1.5, "R": 1e-30, "v0": 0.0, "g": 9.8, "eta": eta}
    with pytest.raises(BadSetting, match="all but lies on the floor"):
        run("ball_on_floor", given | {"y0": 1e-18 * deep})
    assert run("ball_on_floor", given | {"y0": 1e-12 * deep}).outcome in ("released", "sticks")
