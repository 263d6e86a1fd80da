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
