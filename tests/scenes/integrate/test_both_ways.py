"""Compiled kernels are the same functions as plain ones: the same values to the last few places; and the same refusals."""

import math
from functools import partial

import pytest

from corollary.derive.ready_scenes import run
from corollary.scenes import line_collision
from corollary.scenes.forces.contact import Contact
from corollary.scenes.integrate import both_ways, regularised, single_contact
from corollary.scenes.models.pair import Pair, meet
from corollary.scenes.row import RowOfBodies
from corollary.scenes.run import BadSetting, GuardFailed

pytestmark = pytest.mark.fast


@pytest.fixture
def compiled():
    return partial(regularised.collide, compiled=True)


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
    "damped": RowOfBodies((1.0, 2.0, 0.5), (1.0, 0.0, 0.0), (0.0, 0.3), (Contact(1.0, 1.5, 0.2),) * 2),
    "stuck": RowOfBodies((1.0, 2.0), (1.0, 0.0), (0.1,), (Contact(1.0, 1.5, 20.0),)),
    "dropped": RowOfBodies((math.inf, 0.1), (0.0, -1.0), (0.02,), (Contact(1e4, 1.5, 0.5),), weight=9.8),
    "at rest": RowOfBodies((math.inf, 0.1), (0.0, 0.0), (0.0,), (Contact(1e4, 1.5, 90.0),), weight=9.8),
    "long": cradle(40, 1.5),
}


# The same operations in the same order: what is left is how each machine's library rounds powers.
PLACES = 1e-14


@pytest.mark.parametrize("name", LINES)
def test_the_same_to_the_last_few_places(compiled, name):
    line = LINES[name]
    found, plain = compiled(line, 1e-13), regularised.collide(line, 1e-13)
    speed = max(map(abs, (*line.velocities, *plain.velocities)))
    assert found.velocities == pytest.approx(plain.velocities, rel=PLACES, abs=PLACES * speed)
    assert found.duration == pytest.approx(plain.duration, rel=PLACES)
    assert found.overlaps == pytest.approx(plain.overlaps, rel=PLACES)
    assert found.forces == pytest.approx(plain.forces, rel=PLACES)
    assert (found.outcome, found.openings) == (plain.outcome, plain.openings)
    assert found.evaluations == plain.evaluations


@pytest.mark.parametrize("eta", [0.0, 1.0, 5.0, 20.0])
@pytest.mark.parametrize("across", [0.0, 0.018, 0.039])
@pytest.mark.parametrize("q", [1.0, 1.37, 1.5, 3.0])
def test_one_contact_is_the_same_to_the_last_few_places(compiled, monkeypatch, eta, across, q):
    pair = Pair(
        0.1, 0.1, (0.08, across), ((0.0, 0.0), (-1.0, 0.0)), 0.04, Contact(2e4 * 0.005 ** (1.5 - q), q, eta)
    )
    met, found = meet(pair), []
    for way in ("0", "1"):
        monkeypatch.setenv(both_ways.ASKED_BY, way)
        found.append(single_contact.follow(pair, met, 1e-12))
    plain, fast = found
    for name in ("turned", "outward", "spin", "duration", "overlap", "force"):
        assert getattr(fast, name) == pytest.approx(getattr(plain, name), rel=PLACES, abs=1e-16), name
    assert (fast.sticks, fast.evaluations) == (plain.sticks, plain.evaluations)


def test_long_rows(compiled):
    found, plain = compiled(cradle(50, 1.5), 1e-12), regularised.collide(cradle(50, 1.5), 1e-12)
    assert found.velocities == pytest.approx(plain.velocities, abs=1e-11)
    longest = compiled(cradle(200, 1.5), 1e-12)
    assert longest.openings == 199
    assert math.fsum(v * v for v in longest.velocities) == pytest.approx(1.0, abs=1e-10)


def test_nothing_moves_nothing_happens(compiled):
    for velocities in ((0.0, 0.0), (0.0, 1.0), (-1.0, 1.0)):
        found = compiled(RowOfBodies((1.0, 1.0), velocities, (0.1,), (Contact(1.0, 1.5),)), 1e-12)
        assert (found.outcome, found.velocities, found.duration) == ("missed", velocities, 0.0)


def test_a_middle_ball_lighter_than_dust_is_refused(compiled):
    with pytest.raises(GuardFailed, match="does not end"):
        compiled(RowOfBodies((1.0, 1e-11, 1.0), (1.0, 0.0, 0.0), (0.0, 0.0), (Contact(1.0, 1.5),) * 2), 1e-12)


def test_out_of_all_range_is_an_overflow(compiled):
    with pytest.raises(OverflowError):
        compiled(RowOfBodies((1.0, 1.0), (1e200, 0.0), (0.0,), (Contact(1.0, 1.5),)), 1e-12)


@pytest.mark.parametrize("eta", [0.0, 0.1])
def test_it_is_used_where_it_is_asked_for(compiled, monkeypatch, eta):
    line = RowOfBodies((1.0, 2.0, 1.0), (1.0, 0.0, 0.0), (0.0, 0.0), (Contact(1.0, 1.5, eta),) * 2)
    calls, taken = [], both_ways.compiled
    monkeypatch.setattr(both_ways, "compiled", lambda module: calls.append(module) or taken(module))
    for value, count in (("", 0), ("0", 0), ("1", 1)):
        monkeypatch.setenv(both_ways.ASKED_BY, value)
        line_collision.collide.cache_clear()
        line_collision.collide(line, 1e-12)
        assert calls == ["row_motion"] * count
    line_collision.collide.cache_clear()


def test_without_numba_it_says_what_to_install(monkeypatch):
    monkeypatch.setenv(both_ways.ASKED_BY, "1")
    monkeypatch.setattr(both_ways.importlib.util, "find_spec", lambda name: None)
    for module in list(both_ways.sys.modules):
        if module.endswith(both_ways.SUFFIX):
            monkeypatch.delitem(both_ways.sys.modules, module)
    line_collision.collide.cache_clear()
    with pytest.raises(BadSetting, match=r'pip install "corollary-physics\[fast\]"'):
        run("cradle", {"N": 4.0, "q": 1.5})
