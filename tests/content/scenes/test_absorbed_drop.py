"""A body takes up a drop: momentum of both, with or without a force from outside."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from corollary.derive.ready_scenes import run

masses, speeds = st.floats(0.05, 10.0), st.floats(-12.0, 12.0)


@given(masses, masses, speeds, speeds)
def test_both_move_on_with_the_velocity_of_their_centre_of_mass(m, dm, v, u):
    found = run("absorbed_drop", {"m": m, "dm": dm, "v": v, "u": u})
    common = (m * v + dm * u) / (m + dm)
    assert found.observed["velocities"] == pytest.approx(
        (common, common), abs=1e-13 * max(abs(v), abs(u), 1.0)
    )
    assert abs(found.observed["momentum_change"]) <= 1e-13 * (m + dm) * max(abs(v), abs(u), 1.0)


@given(masses, masses, speeds, speeds, st.floats(-9.0, 9.0), st.floats(0.1, 30.0))
def test_a_force_adds_its_impulse_to_both_together(m, dm, v, u, force, t):
    found = run("absorbed_drop", {"m": m, "dm": dm, "v": v, "u": u, "F": force, "t": t})
    size = (m + dm) * max(abs(v), abs(u), abs(force) * t / (m + dm), 1.0)
    assert found.observed["momentum_change"] == pytest.approx(force * t, abs=1e-13 * size)


def test_while_it_is_caught_slowly_newtons_second_law_holds_for_each():
    """m dv/dt = F - pull, and dm du/dt = pull, where the pull is the dashpot's: by differences of a hundred-thousandth of the time."""
    slow = {"F": 3.0, "dt": 1.0}
    early, here, late = (
        run("absorbed_drop", slow | {"t": 0.05 + h}).observed["velocities"] for h in (-1e-5, 0.0, 1e-5)
    )
    pull = 40.0 * (2.0 * 0.4 / 2.4) * (here[0] - here[1])
    # The pull fades 40 times a second: a central difference is off by (40 h)^2/6 of the slope.
    assert 2.0 * (late[0] - early[0]) / 2e-5 == pytest.approx(3.0 - pull, rel=1e-6)
    assert 0.4 * (late[1] - early[1]) / 2e-5 == pytest.approx(pull, rel=1e-6)


def test_the_drop_lags_behind_a_force_by_what_the_dashpot_needs_to_drag_it():
    """The dashpot fades by e^-40 in dt: it drags the drop's share of the force when the lag is F dt / (40 m)."""
    for dt in (1e-1, 1e-3, 1e-6):
        found = run("absorbed_drop", {"F": 3.0, "t": 2.0, "dt": dt})
        body, drop = found.observed["velocities"]
        assert body - drop == pytest.approx(
            3.0 * dt / 80.0, abs=2.0 * sum(found.errors["velocities"]) + 1e-15
        )
