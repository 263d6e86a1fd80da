"""A ball that its damping keeps on the floor."""

import pytest

from corollary.scenes.catalogue import run


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
