"""Damped contacts that never end, in scenes of an author's own: no duration is told, and nothing else suffers from it."""

import math

import pytest

from corollary.scenes.forces.contact import Contact
from corollary.scenes.motion.conserved import used_up
from corollary.scenes.plan import followed, plan, play
from corollary.scenes.run import NEVER_PART, BadSetting
from corollary.scenes.run import Observable as O
from corollary.scenes.scene import Body, Scene

pytestmark = pytest.mark.whole

K, R = 1e4, 0.2


def two(q, eta, axes, gap=0.6):
    """Two balls of 1 kg in a plane or on a line, the first with 1 m/s toward the other."""
    a, b = (Body(1.0, (x, 0.1)[:axes], (v, 0.0)[:axes], R) for x, v in ((0.0, 1.0), (2.0 * R + gap, 0.0)))
    return Scene((a, b), (Contact(K, q, eta),))


def row(q, eta, axes, contacts=None):
    """Three balls of 1, 2 and 1 kg that touch, the first with 1 m/s toward the others."""
    balls = zip((1.0, 2.0, 1.0), (0.0, 0.2, 0.4), (1.0, 0.0, 0.0), strict=True)
    bodies = tuple(Body(m, (x, 0.0)[:axes], (v, 0.0)[:axes], 0.1) for m, x, v in balls)
    return Scene(bodies, contacts or (Contact(K, q, eta),))


@pytest.mark.parametrize("axes", [1, 2])
@pytest.mark.parametrize(("q", "eta"), [(1.0, 200.0), (1.0, 1e3), (1.0, 1e5), (1.5, 1e3), (2.0, 1e3)])
@pytest.mark.parametrize("tolerance", [1e-6, 1e-10])
def test_two_that_never_part_have_no_duration(q, eta, axes, tolerance):
    """mu x'' = -k x - eta x' is overdamped beyond eta = 2 sqrt(k mu) = 141.4 kg/s."""
    found = play(two(q, eta, axes), {O.DURATION}, tolerance)
    assert (found.outcome, found.measured, found.warnings) == ("sticks", {}, (NEVER_PART,))
    found = play(two(q, eta, axes), {O.DURATION, O.LARGEST_OVERLAP}, tolerance)
    assert found.measured.keys() == {"largest_overlap"}
    assert found.warnings == (NEVER_PART,)


def test_it_is_as_dear_as_the_others():
    assert plan(two(1.0, 1e3, 1), {O.DURATION, O.VELOCITIES}).model == "piecewise exact"


@pytest.mark.parametrize("q", [1.0, 1.5])
@pytest.mark.parametrize("eta", [100.0, 130.0])
def test_what_parts_late_has_its_duration(q, eta):
    """Below critical damping half a damped swing; with q = 1.5 the dashpot wins where the overlap is small."""
    found = play(two(q, eta, 1), {O.DURATION, O.VELOCITIES})
    if q == 1.0:
        swings = math.sqrt(K / 0.5 - eta * eta)
        assert found.observed["duration"] == pytest.approx(math.pi / swings, rel=1e-12)
    else:
        assert found.observed.keys() == {"velocities"}
        assert found.observed["velocities"] == pytest.approx((0.5, 0.5), abs=1e-9)


@pytest.mark.parametrize("q", [1.0, 1.5])
def test_what_is_followed_beside_it_is_known_as_well_as_ever(q):
    """A trajectory of two, by the dashpot and the spring in closed form where it is one."""
    mu, eta, t = 0.5, 1e3, 0.7
    found = play(two(q, eta, 1), {O.DURATION, O.TRAJECTORY, O.VELOCITIES}, times=(t,))
    assert found.observed.keys() == {"trajectory", "velocities"}
    assert found.warnings == (NEVER_PART,)
    assert found.observed["velocities"] == pytest.approx((0.5, 0.5), abs=1e-9)
    if q == 1.0:
        half, after = eta / (2.0 * mu), t - 0.6
        slow = math.sqrt(half * half - K / mu)
        deep = (math.exp(-(half - slow) * after) - math.exp(-(half + slow) * after)) / (2.0 * slow)
        a, b = found.observed["trajectory"]
        assert a - b + 2.0 * R == pytest.approx(deep, abs=1e-10)
        assert a + b == pytest.approx(1.0 + t, abs=1e-10)


CHOSEN = Contact(K, 1.0, 1e3, chosen=((0, 1), (1, 2))), Contact(K, 1.0, chosen=((0, 2),))


@pytest.mark.parametrize(
    "scene",
    [row(1.0, 1e3, 1), row(1.5, 1e3, 1), row(1.0, 1e3, 2), row(1.5, 1e3, 2), row(1.0, 1e3, 1, CHOSEN)],
    ids=["line", "line, 1.5", "plane", "plane, 1.5", "chosen"],
)
def test_three_that_stay_together_go_on_as_one(scene):
    found = play(scene, {O.DURATION, O.VELOCITIES})
    assert found.outcome == "sticks"
    assert found.observed.keys() == {"velocities"}
    assert NEVER_PART in found.warnings
    assert not any("chaos" in warning for warning in found.warnings)
    v = found.observed["velocities"]
    assert v[:: scene.axes] == pytest.approx((0.25,) * 3, abs=1e-9)
    assert max(found.errors["velocities"]) < 1e-9


def test_the_second_way_tells_no_duration_either():
    found = followed(two(1.5, 1e3, 1), {"duration", "velocities"}, 1e-8)
    assert found.observed.keys() == {"velocities"}


def test_who_is_still_on_the_way_is_waited_for():
    """Two have come to rest in each other when a third, far behind and faster, comes: they have not yet settled."""
    bodies = tuple(
        Body(m, (x,), (v,), 0.1) for m, x, v in ((1.0, -0.3, 1.0), (2.0, 0.0, 0.0), (1.0, -10.0, 2.0))
    )
    scene = Scene(bodies, (Contact(K, 1.5, 1e3), Contact(K, 1.5, chosen=((1, 2),))))
    found = play(scene, {O.VELOCITIES})
    assert found.observed["velocities"] == pytest.approx((0.75,) * 3, abs=1e-9)
    together = [0.0, 0.2 - 1e-12, -10.0, 0.3, 0.3, 2.0]
    assert not used_up(scene, 1.0, together, 1e-10, 1.0)
    assert used_up(scene, 1.0, [*together[:5], 0.0], 1e-10, 1.0)


@pytest.mark.parametrize("apart", [0.3, 0.4, 1.4])
@pytest.mark.parametrize("axes", [1, 2])
@pytest.mark.parametrize(("q", "eta"), [(1.0, 0.0), (1.5, 0.0), (1.5, 1.0)])
def test_what_is_at_rest_has_no_energy_ratio_in_any_model(apart, axes, q, eta):
    bodies = tuple(Body(1.0, (x, 0.0)[:axes], (0.0, 0.0)[:axes], R) for x in (0.0, apart))
    for asked in ({O.ENERGY_RATIO}, {O.ENERGY_RATIO, O.VELOCITIES}):
        for until in (None, 1.0):
            with pytest.raises(BadSetting, match="nothing moves at the start"):
                play(Scene(bodies, (Contact(K, q, eta),), until=until), asked)
