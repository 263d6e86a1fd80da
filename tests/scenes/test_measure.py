"""Durations of contacts that were stepped through: closed contact times, and errors that are no less than what they say."""

import math

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from corollary.scenes import measure
from corollary.scenes.forces.contact import Contact, HardWall
from corollary.scenes.forces.fields import Weight
from corollary.scenes.forces.flows import Drag
from corollary.scenes.measure import measured
from corollary.scenes.models.two_bodies import contact_time
from corollary.scenes.plan import play
from corollary.scenes.run import BadSetting, Observable, components
from corollary.scenes.scene import Body, Scene

MASS, HARD = 0.06, {1.0: 1.4e3, 1.5: 2e4, 3.0: 1.6e11}


def two_balls(q, gap, speed, at=0.0, turned=0.0):
    """A ball meets one at rest; the gap is in m, `at` shifts both."""
    c, s = math.cos(turned), math.sin(turned)
    away = 0.02 + 0.02 + gap
    a = Body(0.1, (at, 0.0), (speed * c, speed * s), 0.02)
    b = Body(0.15, (at + away * c, away * s), (0.0, 0.0), 0.02)
    return Scene((a, b), (Contact(HARD[q], q),))


def gap_of(scene):
    a, b = (body.place for body in scene.bodies)
    return math.dist(a, b) - 0.04


@given(
    st.sampled_from([1.0, 1.5, 3.0]),
    st.one_of(st.just(0.0), st.floats(-18.0, -1.0).map(lambda x: 10.0**x)),
    st.floats(-2.0, 0.3).map(lambda x: 10.0**x),
    st.sampled_from([0.0, 0.3, 1.0, 2.0, 3.14]),
    st.sampled_from([1e-4, 1e-7, 1e-10, 1e-12]),
)
@example(1.5, 0.0, 1.0, 0.0, 1e-10)
@example(1.0, 0.0, 0.029, 2.0, 1e-4)
@example(3.0, 0.0, 0.206, 2.0, 1e-4)
@example(1.0, 0.0, 0.01, 0.0, 1e-4)
@example(3.0, 1e-17, 2.0, 1.0, 1e-10)
@example(3.0, 0.0, 10.0**-0.671875, 0.0, 1e-4)
@example(3.0, 10.0**-1.5625, 0.01, 0.0, 1e-4)
@settings(max_examples=40, deadline=None)
def test_a_duration_is_as_exact_as_it_says(q, gap, speed, turned, tolerance):
    scene = two_balls(q, gap, speed, turned=turned)
    found = measured(scene, {Observable.DURATION}, tolerance, "asked")
    exact = contact_time(MASS, HARD[q], q, speed)
    # A gap that rounding made an overlap cuts the contact short by the time it takes to cross it.
    cut = max(-gap_of(scene), 0.0) / speed
    assert found.outcome == "released"
    assert (
        abs(found.observed["duration"] - exact)
        <= found.relative_error("duration") * exact + cut + 2e-15 * exact
    )
    assert found.relative_error("duration") <= 100.0 * tolerance + 1e-9


@pytest.mark.parametrize("at", [1e2, 1e5])
def test_far_from_the_origin_the_rounding_of_places_is_in_the_error(at):
    scene = two_balls(1.5, 1e-3, 1.0, at=at)
    found = measured(scene, {Observable.DURATION}, 1e-10, "asked")
    exact = contact_time(MASS, HARD[1.5], 1.5, 1.0)
    assert abs(found.observed["duration"] / exact - 1.0) <= found.relative_error("duration")
    assert 1e-16 * at < found.relative_error("duration") < 1e-8 * at


def test_a_contact_that_begins_at_the_start_and_is_watched_for_a_part():
    scene = two_balls(1.5, 0.0, 1.0)
    exact = contact_time(MASS, HARD[1.5], 1.5, 1.0)
    for part in (0.3, 0.9):
        watched = Scene(scene.bodies, scene.forces, until=part * exact)
        found = measured(watched, {Observable.DURATION}, 1e-10, "asked")
        assert found.observed["duration"] == pytest.approx(part * exact, rel=1e-13)


def test_a_miss_lasts_no_time():
    apart = Scene(
        (Body(0.1, (0.0, 0.0), (1.0, 0.0), 0.02), Body(0.1, (0.1, 0.05), (0.0, 0.0), 0.02)), (Contact(2e4),)
    )
    found = measured(apart, {Observable.DURATION}, 1e-10, "asked")
    assert (found.outcome, found.observed["duration"]) == ("missed", 0.0)


@pytest.mark.parametrize("until", [None, 0.2])
@pytest.mark.parametrize("asked", [Observable.VELOCITIES, Observable.DURATION, Observable.LARGEST_OVERLAP])
@pytest.mark.parametrize("others", [0, 1])
def test_balls_so_soft_that_they_pass_through_each_other_are_refused_by_every_model(until, asked, others):
    more = tuple(Body(0.1, (0.1 + 0.05 * i,), (0.0,), 0.02) for i in range(others))
    for k, refused in ((2e4, False), (3.0, True)):
        scene = Scene(
            (Body(0.1, (0.0,), (1.0,), 0.02), Body(0.1, (0.05,), (0.0,), 0.02), *more),
            (Contact(k),),
            until=until,
        )
        if refused:
            with pytest.raises(BadSetting, match="pass through each other"):
                play(scene, {asked})
        else:
            assert play(scene, {asked}).outcome in ("released", "bound")


@pytest.mark.parametrize("start", [(-1.0,), (-0.7,), (-0.3, -0.7), (-0.1, 0.3)])
@pytest.mark.parametrize("drag", [0.0, 0.1])
def test_what_flies_through_the_origin_turns_there_but_for_rounding(start, drag):
    body = Body(1.0, start, tuple(-x for x in start))
    found = play(Scene((body,), (Drag(0, drag),), until=2.0), {Observable.TURNING_POINTS})
    (nearest,), (error,) = found.observed["turning_points"], found.errors["turning_points"]
    assert nearest <= 0.5 * error < 1e-11
    assert not found.warnings


def test_values_and_errors_are_floats_whatever_numbers_a_scene_is_made_of():
    given = np.float64(0.06), (np.float64(0.5), np.float32(1.0)), (np.float64(0.3), np.int64(0))
    wall = Body(math.inf, (np.float64(5.0), np.float64(5.0)), (np.float64(0.1), np.float64(0.2)))
    scene = Scene(
        (Body(*given), wall),
        (Weight(np.float64(9.8)), HardWall((0.0, 1.0), only=(0,))),
        until=np.float64(0.7),
    )
    asked = {o for o in Observable if o is not Observable.PERIOD}
    found = play(scene, asked, times=(np.float64(0.2),))
    for each in (*found.observed.values(), *found.errors.values()):
        assert {type(x) for x in components(each)} <= {float}


def test_what_no_force_moves_is_known_however_badly_the_others_are():
    """Two nails, beside a swing followed roughly, and a disc that all but misses a peg."""
    nail = Body(math.inf, (0.0, 0.0), (0.0, 0.0), 0.1)
    other = Body(math.inf, (40.0, 40.0), (0.0, 0.0))
    disc = Body(1.0, (-1.0, 0.2 - 2e-17), (3.0, 0.0), 0.1)
    scene = Scene((nail, other, disc), (Contact(1e9, 1.5), Weight(9.8)), until=0.5)
    found = play(scene, {Observable.VELOCITIES, Observable.TRAJECTORY}, 1e-4, times=(0.25, 0.5))
    assert found.observed["velocities"][:4] == (0.0, 0.0, 0.0, 0.0)
    assert max(found.errors["velocities"][:4]) < 1e-11 < found.errors["velocities"][4]
    for begin in (0, 6):
        seen, off = (
            components(each)[begin : begin + 6]
            for each in (found.observed["trajectory"], found.errors["trajectory"])
        )
        truth = 0.0, 0.0, 40.0, 40.0
        assert all(abs(a - b) <= e < 1e-10 for a, b, e in zip(seen, truth, off, strict=False))
        assert off[4] > 1e-9


@pytest.mark.parametrize("tolerance", [1e-2, 1e-5, 1e-9])
def test_a_scene_is_followed_three_times_however_loose_the_tolerance(tolerance):
    """A looser one than the loosest is taken for that, and not followed once more for the question whether something grazes."""
    scene = Scene((Body(1.0, (3.0,), (-1.0,)),), (Weight(9.8), HardWall((1.0,), restitution=0.5)), until=1.5)
    followed, follow = [], measure.follow

    def counted(*given, **named):
        followed.append(follow(*given, **named))
        return followed[-1]

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(measure, "follow", counted)
        measure._paths.cache_clear()
        found = play(scene, {Observable.VELOCITIES}, tolerance)
    assert len(followed) == 3
    assert found.evaluations == sum(path.evaluations for path in followed)
