"""Collisions on a line: closed forms, 20-digit references, conservation, and ends that are named instead of hung upon."""

import json
import math
from pathlib import Path

import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from corollary.scenes import line_collision
from corollary.scenes.forces.contact import Contact
from corollary.scenes.integrate import row_motion
from corollary.scenes.integrate.regularised import collide
from corollary.scenes.models import two_bodies
from corollary.scenes.row import RowOfBodies, conserved, guard
from corollary.scenes.run import GuardFailed

REFERENCES = json.loads((Path(__file__).parent.parent / "references.json").read_text())


def cradle(count, q, **others):
    return RowOfBodies(
        (1.0,) * count,
        (1.0,) + (0.0,) * (count - 1),
        (0.0,) * (count - 1),
        (Contact(1.0, q),) * (count - 1),
        **others,
    )


@pytest.mark.parametrize("name", REFERENCES)
def test_cradles_agree_with_thirty_digit_arithmetic_to_twelve(name):
    count, q = name.split()
    found = collide(cradle(int(count), float(q)), 3e-14)
    assert found.outcome == "released"
    worst = max(abs(a - float(b)) for a, b in zip(found.velocities, REFERENCES[name], strict=True))
    assert worst < 1e-12


@pytest.mark.parametrize("q", [1.0, 1.25, 1.37, 1.5, 2.0, math.pi, 5.0, 10.0])
def test_two_balls_agree_with_beta_functions(q):
    found = collide(cradle(2, q), 1e-13)
    assert found.velocities == pytest.approx((0.0, 1.0), abs=1e-12)
    assert found.duration == pytest.approx(two_bodies.contact_time(0.5, 1.0, q, 1.0), rel=2e-12)
    assert found.overlaps[0] == pytest.approx(two_bodies.largest_overlap(0.5, 1.0, q, 1.0), rel=1e-12)
    assert found.forces[0] == pytest.approx(found.overlaps[0] ** q, rel=1e-14)


def test_a_tighter_tolerance_costs_little_and_gains_much():
    exact = [float(v) for v in REFERENCES["3 1.5"]]
    cost, error = [], []
    for tolerance in (1e-8, 1e-10, 1e-12):
        found = collide(cradle(3, 1.5), tolerance)
        cost.append(found.evaluations)
        error.append(max(abs(a - b) for a, b in zip(found.velocities, exact, strict=True)))
    # Order 8: error falls as evaluations^-8, so four decades of error cost less than 10^(4/7).
    assert cost[2] < 3.8 * cost[0]
    assert error[2] < 1e-3 * error[0] < 1e-9
    assert cost[2] < 1500


lines = st.integers(2, 5).flatmap(
    lambda n: st.builds(
        RowOfBodies,
        st.tuples(*[st.floats(0.1, 10.0)] * n),
        st.tuples(*[st.integers(-100, 100).map(lambda v: v / 100.0)] * n),
        st.tuples(*[st.sampled_from([0.0, 1e-9, 0.1, 3.0])] * (n - 1)),
        st.tuples(
            *[st.builds(Contact, st.floats(0.1, 10.0), st.sampled_from([1.0, 1.25, 1.5, 2.0, 3.0]))] * (n - 1)
        ),
    )
)


@given(lines)
@settings(max_examples=20, deadline=None)
def test_momentum_and_energy_are_kept_and_no_body_passes_through_another(line):
    found = collide(line, 1e-11)
    momentum = [m * v for m, v in zip(line.masses, line.velocities, strict=True)]
    after = [m * v for m, v in zip(line.masses, found.velocities, strict=True)]
    assert math.fsum(after) == pytest.approx(
        math.fsum(momentum), abs=1e-13 * sum(map(abs, momentum + after)) + 1e-15
    )
    start, none = conserved(line, [0.0] * len(line.gaps), line.velocities)[0], [0.0] * len(line.gaps)
    assert conserved(line, none, found.velocities)[0] == pytest.approx(start, rel=1e-8, abs=1e-12)
    speed = max(map(abs, line.velocities), default=0.0)
    for left, right in zip(found.velocities, found.velocities[1:], strict=False):
        assert left <= right + 1e-8 * speed


def test_an_overlap_that_nearly_ends_and_turns_back():
    """Its own variable does not grow where its speed turns: the time must take over."""
    line = RowOfBodies(
        (5.392647120560536, 0.3111643669578199, 9.093658973051353, 5.569843140251806, 3.6224949109301647),
        (1.0, 0.66, -0.66, 0.37, 0.0),
        (3.0, 0.1, 0.0, 0.0),
        (
            Contact(8.48762618655357, 3.0),
            Contact(7.580655855363958, 1.25),
            Contact(6.219551606411619, 1.0),
            Contact(4.0, 1.0),
        ),
    )
    found = collide(line, 1e-11)
    assert found.evaluations < 10_000
    assert found.velocities == pytest.approx(collide(line, 1e-13).velocities, abs=1e-9)


@given(lines, st.floats(0.01, 3.0))
@settings(max_examples=10, deadline=None)
def test_damping_never_gives_energy(line, eta):
    first, *others = line.contacts
    damped = RowOfBodies(line.masses, line.velocities, line.gaps, (Contact(first.k, first.q, eta), *others))
    found = collide(damped, 1e-10)
    none = [0.0] * len(line.gaps)
    assert (
        conserved(line, none, found.velocities)[0]
        <= conserved(line, none, line.velocities)[0] * (1.0 + 1e-9) + 1e-12
    )


def test_simultaneous_openings():
    found = collide(
        RowOfBodies((1.0, 1.0, 1.0), (1.0, 0.0, -1.0), (0.0, 0.0), (Contact(1.0, 1.5),) * 2), 1e-13
    )
    assert found.velocities == pytest.approx((-1.0, 0.0, 1.0), abs=1e-12)
    assert found.openings == 2


def test_wide_gaps_make_separate_collisions_found_without_a_step_of_flight():
    near = collide(RowOfBodies((1.0,) * 3, (1.0, 0.0, 0.0), (1e3, 1e3), (Contact(1.0, 1.5),) * 2), 1e-13)
    far = collide(RowOfBodies((1.0,) * 3, (1.0, 0.0, 0.0), (1e9, 1e9), (Contact(1.0, 1.5),) * 2), 1e-13)
    assert far.velocities == pytest.approx((0.0, 0.0, 1.0), abs=1e-12)
    assert far.evaluations == near.evaluations


def test_a_damped_contact_of_a_spring_has_its_closed_restitution():
    m, k, c = 0.1, 2000.0, 4.0
    found = collide(RowOfBodies((math.inf, m), (0.0, -3.0), (0.0,), (Contact(k, 1.0, c),)), 1e-13)
    # x'' = -(k/m) x - (c/m) x' from x = 0; it is back at zero after half a damped swing.
    swing = math.sqrt(k / m - (c / (2 * m)) ** 2)
    assert found.velocities[1] / 3.0 == pytest.approx(math.exp(-c / (2 * m) * math.pi / swing), rel=1e-11)
    assert found.duration == pytest.approx(math.pi / swing, rel=1e-11)
    assert found.forces[0] == pytest.approx(peak_of_damped_spring(m, k, c, 3.0), rel=1e-10)


def peak_of_damped_spring(m, k, c, v):
    rate, swing = c / (2 * m), math.sqrt(k / m - (c / (2 * m)) ** 2)

    def force(t):
        x = v / swing * math.exp(-rate * t) * math.sin(swing * t)
        return k * x + c * (v * math.exp(-rate * t) * math.cos(swing * t) - rate * x)

    return max(force(math.pi / swing * i / 200_000) for i in range(200_001))


@pytest.mark.parametrize("c", [28.3, 40.0, 1e4])
def test_an_overdamped_spring_sticks(c):
    """c^2 > 4 k m: the overlap only fades."""
    found = collide(RowOfBodies((math.inf, 0.1), (0.0, -3.0), (0.0,), (Contact(2000.0, 1.0, c),)), 1e-12)
    assert found.outcome == "sticks"
    assert found.velocities == (0.0, 0.0)
    assert math.isinf(found.duration)


def test_nothing_moves_nothing_happens():
    assert collide(RowOfBodies((1.0, 1.0), (0.0, 0.0), (0.1,), (Contact(1.0),)), 1e-12).outcome == "missed"
    assert collide(RowOfBodies((1.0, 1.0), (0.0, 1.0), (0.0,), (Contact(1.0),)), 1e-12).outcome == "missed"


@given(
    st.sampled_from([1.0, 1.25, 1.5, 2.0, 3.0]),
    st.one_of(st.floats(-3.0, 9.0), st.floats(-0.6, 0.3)),
    st.sampled_from([0.0, 9.8]),
    st.sampled_from([1e-3, 0.1, 3.0]),
    st.sampled_from([1e-6, 1e-8, 1e-10, 1e-12]),
)
@example(1.25, 5.1845, 9.8, 0.25, 1e-6)  # past the top its variable would run back
@example(2.0, 6.0, 0.0, 0.1, 1e-10)  # too faint to be seen before its damping has decided
@settings(max_examples=60, deadline=None)
def test_whatever_the_damping_a_ball_is_released_or_sticks(q, thickness, weight, speed, tolerance):
    """Energy falls with damping, and without a jump: a little more of it never gives a rebound far from the first."""
    k, m = 1e6 * 0.001 ** (1.5 - q), 0.1
    critical = 2.0 * math.sqrt(k * m * two_bodies.largest_overlap(m, k, q, speed) ** (q - 1.0))

    def kept(more):
        eta = critical * 10.0**thickness * more
        line = RowOfBodies((math.inf, m), (0.0, -speed), (0.0,), (Contact(k, q, eta),), weight=weight)
        found = line_collision.collide(line, tolerance)
        assert found.result.outcome in ("released", "sticks")
        return (found.result.velocities[1] / speed) ** 2, found.errors["velocities"]

    (less, error), (more, _) = kept(1.001), kept(1.0)
    assert -10.0 * (error + tolerance) <= more - less <= 0.01 + 10.0 * (error + tolerance)


def with_wrong_steps(monkeypatch, change):
    """Every step's velocities are changed, and the step does not know it."""
    right = row_motion.try_step

    def badly_tried(*arguments):
        found = right(*arguments)
        after = arguments[-1][row_motion.AFTER]
        after[::2] = change(*after[::2])
        return found

    monkeypatch.setattr(row_motion, "try_step", badly_tried)


THREE = RowOfBodies((1.0, 1.0, 1.0), (1.0, 0.0, 0.0), (0.0, 0.0), (Contact(1.0, 1.5),) * 2)


def test_steps_that_lose_momentum_but_no_energy_are_found_out(monkeypatch):
    """Turning the velocities of equal masses, as if they were one vector, leaves their squares as they are."""
    c, s = math.cos(1e-7), math.sin(1e-7)
    with_wrong_steps(monkeypatch, lambda u, v, w: (c * u - s * v, s * u + c * v, w))
    with pytest.raises(GuardFailed, match="the momentum by"):
        collide(THREE)


def test_what_many_steps_round_off_the_momentum_is_no_fault():
    """A light ball thrown to and fro between heavy ones takes a million evaluations; each rounds."""
    before, after = (1.0, 1.0, 1.0), (1.0, 1.0 - 4e-12, 1.0)
    guard(THREE, before, after, 1e-9, 2_000_000)
    with pytest.raises(GuardFailed, match="the momentum by"):
        guard(THREE, before, after, 1e-9, 2_000)


@pytest.mark.parametrize("wrong", [1e-6, -1e-6])
def test_steps_that_gain_or_lose_energy_are_found_out(monkeypatch, wrong):
    with_wrong_steps(monkeypatch, lambda *speeds: [v * (1.0 + wrong) for v in speeds])
    with pytest.raises(GuardFailed, match="the energy by"):
        collide(THREE)
