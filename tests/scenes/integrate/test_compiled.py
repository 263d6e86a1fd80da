"""Compiled steps are the steps of plain Python: the same velocities, durations, crests and counts; and the same refusals."""

import math

import pytest

from corollary.scenes import collision
from corollary.scenes.catalogue import run
from corollary.scenes.forces.contact import Contact
from corollary.scenes.integrate import regularised
from corollary.scenes.row import RowOfBodies
from corollary.scenes.run import BadSetting, GuardFailed


@pytest.fixture(scope="module")
def compiled():
    pytest.importorskip("numba", reason="compiled steps need numba (pip install 'corollary[fast]')")
    from corollary.scenes.integrate import compiled

    return compiled


def cradle(count, q, **others):
    velocities = (1.0, *(0.0,) * (count - 1))
    return RowOfBodies(
        (1.0,) * count, velocities, (0.0,) * (count - 1), (Contact(1.0, q),) * (count - 1), **others
    )


LINES = {
    **{
        f"cradle {n} {q:g}": cradle(n, q)
        for n in (2, 3, 5, 8)
        for q in (1.0, 1.25, 1.37, 1.5, 2.0, 3.0, 10.0)
    },
    "gaps": RowOfBodies(
        (1.0, 2.0, 0.5, 1.0),
        (1.0, 0.0, 0.3, -0.5),
        (0.2, 0.0, 3.0),
        (Contact(2.0, 1.5), Contact(0.3, 2.0), Contact(1.0)),
    ),
    "wall": RowOfBodies((math.inf, 0.1, 0.3), (0.0, 0.0, -2.0), (0.0, 0.1), (Contact(1e4, 1.5),) * 2),
    "squeezed": RowOfBodies((1.0, 1.0, 3.0), (0.0, 0.0, 0.0), (-0.1, 0.0), (Contact(5.0, 1.5),) * 2),
    "simultaneous": RowOfBodies((1.0, 1.0, 1.0), (1.0, 0.0, -1.0), (0.0, 0.0), (Contact(1.0, 1.5),) * 2),
    "heavy": RowOfBodies((1.0, 1e2, 1.0), (1.0, 0.0, 0.0), (0.0, 0.0), (Contact(1.0, 1.5),) * 2),
    "light": RowOfBodies((1.0, 1e-3, 1.0), (1.0, 0.0, 0.0), (0.0, 0.0), (Contact(1.0, 1.5),) * 2),
}


@pytest.mark.parametrize("name", LINES)
def test_the_same_to_twelve_digits(compiled, name):
    line = LINES[name]
    found, plain = compiled.collide(line, 1e-13), regularised.collide(line, 1e-13)
    speed = max(map(abs, plain.velocities))
    assert found.velocities == pytest.approx(plain.velocities, rel=1e-12, abs=1e-12 * speed)
    assert found.duration == pytest.approx(plain.duration, rel=1e-12)
    assert found.overlaps == pytest.approx(plain.overlaps, rel=1e-12)
    assert found.forces == pytest.approx(plain.forces, rel=1e-11)
    assert found.outcome == plain.outcome
    # Rounding may turn a decision about a step, and with q = 10 whether a contact too faint to matter opens once more.
    assert found.evaluations == pytest.approx(plain.evaluations, rel=0.1)
    if line.contacts[0].q < 10.0:
        assert found.openings == plain.openings


def test_long_rows(compiled):
    found, plain = compiled.collide(cradle(50, 1.5), 1e-12), regularised.collide(cradle(50, 1.5), 1e-12)
    assert found.velocities == pytest.approx(plain.velocities, abs=1e-11)
    longest = compiled.collide(cradle(200, 1.5), 1e-12)
    assert longest.openings == 199
    assert math.fsum(v * v for v in longest.velocities) == pytest.approx(1.0, abs=1e-10)


def test_nothing_moves_nothing_happens(compiled):
    for velocities in ((0.0, 0.0), (0.0, 1.0), (-1.0, 1.0)):
        found = compiled.collide(RowOfBodies((1.0, 1.0), velocities, (0.1,), (Contact(1.0, 1.5),)), 1e-12)
        assert (found.outcome, found.velocities, found.duration) == ("missed", velocities, 0.0)


def test_a_middle_ball_lighter_than_dust_is_refused(compiled):
    with pytest.raises(GuardFailed, match="did not end"):
        compiled.collide(
            RowOfBodies((1.0, 1e-11, 1.0), (1.0, 0.0, 0.0), (0.0, 0.0), (Contact(1.0, 1.5),) * 2), 1e-12
        )


def test_out_of_all_range_is_an_overflow(compiled):
    with pytest.raises(OverflowError):
        compiled.collide(RowOfBodies((1.0, 1.0), (1e200, 0.0), (0.0,), (Contact(1.0, 1.5),)), 1e-12)


def test_it_is_used_where_it_is_asked_for(compiled, monkeypatch):
    plain = run("cradle", {"N": 4.0, "q": 1.5})
    calls = []
    monkeypatch.setattr(
        compiled,
        "collide",
        lambda line, tolerance, real=compiled.collide: calls.append(line) or real(line, tolerance),
    )
    for value, count in (("", 0), ("0", 0), ("1", 2)):
        monkeypatch.setenv(collision.COMPILED, value)
        collision.collide.cache_clear()
        found = run("cradle", {"N": 4.0, "q": 1.5})
        assert found.observed["velocities"] == pytest.approx(plain.observed["velocities"], abs=1e-13)
        assert len(calls) == count
    damped = RowOfBodies((1.0, 1.0), (1.0, 0.0), (0.0,), (Contact(1.0, 1.5, 0.1),))
    collision.collide(damped, 1e-12)
    assert len(calls) == 2  # what it does not know is left to plain Python
    collision.collide.cache_clear()


def test_without_numba_it_says_what_to_install(monkeypatch):
    monkeypatch.setenv(collision.COMPILED, "1")
    monkeypatch.setattr(collision.importlib.util, "find_spec", lambda name: None)
    collision.collide.cache_clear()
    with pytest.raises(BadSetting, match=r"corollary\[fast\]"):
        run("cradle", {"N": 4.0, "q": 1.5})
