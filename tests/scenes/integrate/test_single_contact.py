"""One contact of two spheres: steps against quadrature, the chapter's edge between release and sticking, invariants."""

import math
from dataclasses import replace

import pytest
from flint import arb
from hypothesis import example, given, settings
from hypothesis import strategies as st

from corollary.scenes.forces.contact import Contact, stored
from corollary.scenes.integrate import single_contact
from corollary.scenes.integrate.single_contact import follow
from corollary.scenes.models.certain import double_of
from corollary.scenes.models.pair import (
    NEAREST,
    Pair,
    Parting,
    Touching,
    after_parting,
    deepest,
    meet,
    turned_and_lasted,
)
from corollary.scenes.models.two_bodies import contact_time, largest_overlap
from corollary.scenes.run import BadSetting, GuardFailed


def chapter(eta=0.0, across=0.018, k=2e4, q=1.5):
    return Pair(0.1, 0.1, (0.08, across), ((0.0, 0.0), (-1.0, 0.0)), 0.04, Contact(k, q, eta))


def oblique(pair, met):
    """An undamped contact by its two integrals, as doubles."""
    overlap, turned, lasted = (
        double_of(lambda i=i: turned_and_lasted(pair, arb(met.inward), arb(met.spin))[i]) for i in range(3)
    )
    force = pair.contact.k * overlap**pair.contact.q
    return Parting(turned, met.inward, met.spin, lasted, overlap, force, False, 0)


def as_hard_as_the_chapters(q):
    return 2e4 * 0.005 ** (1.5 - q)


@pytest.mark.parametrize("q", [1.0, 1.25, 1.5, 2.0, 2.6, 4.0])
@pytest.mark.parametrize("across", [0.0, 0.018, 0.039, 0.04 * (1 - 1e-7)])
def test_without_damping_steps_and_integrals_agree(q, across):
    pair = chapter(across=across, q=q, k=as_hard_as_the_chapters(q))
    met = meet(pair)
    stepped, integrated = follow(pair, met, 1e-14), oblique(pair, met)
    assert after_parting(pair, met, stepped) == pytest.approx(after_parting(pair, met, integrated), abs=2e-13)
    assert stepped.duration == pytest.approx(integrated.duration, rel=1e-12)
    assert stepped.overlap == pytest.approx(integrated.overlap, rel=1e-12)
    assert stepped.force == pytest.approx(integrated.force, rel=2e-12)


def test_head_on_it_is_the_contact_of_the_reduced_mass():
    met = meet(chapter(across=0.0))
    found = oblique(chapter(across=0.0), met)
    assert found.duration == pytest.approx(contact_time(0.05, 2e4, 1.5, 1.0), rel=1e-14)
    assert found.overlap == pytest.approx(largest_overlap(0.05, 2e4, 1.5, 1.0), rel=1e-14)


@pytest.mark.parametrize(("across", "edge"), [(0.018, 9.575), (0.0, 9.820)])
def test_beyond_some_damping_the_contact_never_ends(across, edge):
    for eta, sticks in ((edge - 0.002, False), (edge + 0.002, True)):
        pair = chapter(eta, across)
        assert follow(pair, meet(pair), 1e-12).sticks is sticks


@pytest.mark.parametrize("tolerance", [1e-9, 1e-12, 1e-14, 1e-15])
def test_a_force_that_rises_at_both_ends_of_a_long_step_has_its_maximum_between(tolerance):
    """Where the drag across is most of the force the spring adds little, and the drag along pulls before the spheres part."""
    grazing = Pair(
        0.06666158308458792,
        0.022565781510702362,
        (0.1, 0.03999999996836441),
        ((0.0, 0.0), (-1.3679514483229138, 0.0)),
        0.04,
        Contact(20000.0, 1.0, 0.0005033909726686724),
    )
    met = meet(grazing)
    assert follow(grazing, met, tolerance).force == pytest.approx(6.886146779309877e-4, rel=1e-14)


@given(st.floats(0.0, 9.0), st.floats(-0.039, 0.039), st.sampled_from([1.0, 1.5, 2.0, 3.0]))
@example(0.0, 1e-12, 3.0)
@example(1e-9, 1e-300, 3.0)
@settings(max_examples=25, deadline=None)
def test_spin_fades_with_time_as_the_drag_says_and_energy_only_falls(eta, across, q):
    pair = chapter(eta, across, q=q, k=as_hard_as_the_chapters(q))
    met = meet(pair)
    found = follow(pair, met, 1e-12)
    assert 0.0 < found.overlap < 0.2 * pair.reach
    speed = math.hypot(*after_parting(pair, met, found))
    assert speed <= 1.0 + 1e-10
    if not found.sticks:
        assert found.spin == pytest.approx(
            met.spin * math.exp(-eta / 0.05 * found.duration), rel=1e-10, abs=1e-15
        )


@given(st.floats(0.0, 1e-3), st.floats(-0.039, 0.039), st.floats(1.0, 5.0), st.floats(-3.0, 0.0))
@settings(max_examples=25, deadline=None)
def test_however_soft_there_is_an_answer_until_the_centres_all_but_meet(eta, across, q, softness):
    """Very soft spheres swing round each other's centres; what goes through the middle is refused as too soft, and nothing else is."""
    pair = chapter(eta, across, q=q, k=0.1 / 0.04 ** (q + 1.0) * 10.0**softness)
    met = meet(pair)
    depth = deepest(pair, met)
    if depth > (1.0 - 0.9 * NEAREST) * pair.reach and eta == 0.0:
        with pytest.raises(BadSetting, match="pass through each other"):
            follow(pair, met, 1e-12)
        return
    try:
        found = follow(pair, met, 1e-12)
    except BadSetting:
        assert depth > (1.0 - 1.1 * NEAREST) * pair.reach
        return
    if eta == 0.0:
        exact = oblique(pair, met)
        assert after_parting(pair, met, found) == pytest.approx(after_parting(pair, met, exact), abs=1e-11)


@given(st.floats(0.5, 20.0), st.floats(-3.0, 3.0))
def test_the_meeting_point_is_on_the_line_of_flight_at_the_reach(away, turn):
    c, s = math.cos(turn), math.sin(turn)
    x, y = 0.04 * away + 0.04, 0.01
    pair = Pair(1.0, 2.0, (c * x - s * y, s * x + c * y), ((0.0, 0.0), (-c, -s)), 0.04, Contact(1.0))
    met = meet(pair)
    place = [a + v * met.after for a, v in zip(pair.apart, pair.relative, strict=True)]
    assert math.hypot(*place) == pytest.approx(0.04, rel=1e-10)
    assert math.remainder(math.atan2(place[1], place[0]) - met.angle, 2 * math.pi) == pytest.approx(
        0.0, abs=1e-9
    )
    assert met.inward**2 + (met.spin / 0.04) ** 2 == pytest.approx(1.0, rel=1e-12)


@given(
    st.one_of(st.floats(-300.0, -3.0), st.floats(-20.0, -3.0)),
    st.sampled_from([1.0, 1.5, 3.0]),
    st.sampled_from([0.0, 0.018, 0.0399]),
)
@example(-15.0, 1.5, 0.0)
@settings(max_examples=40, deadline=None)
def test_a_start_that_overlaps_by_a_rounding_is_the_touch(exponent, q, across):
    """Head on, energy gives the speed and the depth; the time to cross the overlap that is there already is missing."""
    pair = chapter(across=across, q=q, k=as_hard_as_the_chapters(q))
    met = meet(pair)
    touch = oblique(pair, met)
    share = 10.0**exponent
    overlap = share * touch.overlap
    found = follow(pair, replace(met, overlap=overlap), 1e-13)
    moved = math.dist(after_parting(pair, met, found), after_parting(pair, met, touch))
    assert moved <= 2.0 * (share + share ** (q + 1.0)) + 1e-11
    if across == 0.0:
        gained = 1.0 + share ** (q + 1.0)
        assert found.outward == pytest.approx(math.sqrt(gained), rel=1e-12)
        assert found.overlap == pytest.approx(touch.overlap * gained ** (1.0 / (q + 1.0)), rel=1e-12)
        whole = touch.duration * gained ** (1.0 / (q + 1.0) - 0.5)
        assert found.duration == pytest.approx(
            whole - overlap * (1.0 - 0.5 * share ** (q + 1.0) * (q + 1.0) / (q + 2.0)), rel=1e-11
        )


@given(
    st.floats(-200.0, -3.0),
    st.sampled_from([1.0, 1.5, 3.0]),
    st.sampled_from([(0.0, 1.0), (-1.0, 0.0), (-1.0, 1.0), (-1e-9, 1.0)]),
)
@settings(max_examples=30, deadline=None)
def test_an_overlap_that_does_not_grow_ends_at_once(exponent, q, way):
    pair = chapter(q=q, k=as_hard_as_the_chapters(q))
    met = Touching(0.0, 10.0**exponent * 0.04, way[0], way[1] * 0.04, 0.0)
    found = follow(pair, met, 1e-12)
    across = found.spin / pair.reach
    kept = 0.5 * math.hypot(*way) ** 2 + stored(pair.contact, met.overlap) / pair.mass
    # What is inside the reach turns faster: its spin is counted there.
    kept += 0.5 * (way[1] * 0.04) ** 2 * (1.0 / (0.04 - met.overlap) ** 2 - 1.0 / 0.04**2)
    assert not found.sticks
    assert found.overlap == pytest.approx(met.overlap, rel=1e-15)
    assert 0.5 * (found.outward**2 + across**2) == pytest.approx(kept, rel=1e-11)


def test_a_contact_that_does_not_end_is_not_blamed_on_damping_where_there_is_none(monkeypatch):
    monkeypatch.setattr(single_contact, "MOST_STEPS", 3)
    for eta, remedy in ((0.0, "Start the spheres apart, or faster"), (1.0, "Choose less damping")):
        pair = chapter(eta=eta)
        with pytest.raises(GuardFailed, match=remedy):
            follow(pair, meet(pair), 1e-12)


def test_two_at_rest_whose_overlap_moves_nothing_do_not_meet():
    assert meet(Pair(1.0, 1.0, (0.9e-200, 0.0), ((0.0, 0.0), (0.0, 0.0)), 1e-200, Contact(1.0))) is not None
    assert meet(Pair(1.0, 1.0, (0.9e-300, 0.0), ((0.0, 0.0), (0.0, 0.0)), 1e-300, Contact(1.0))) is None


def test_spheres_that_pass_or_part_never_meet():
    assert meet(Pair(1.0, 1.0, (0.08, 0.041), ((0.0, 0.0), (-1.0, 0.0)), 0.04, Contact(1.0))) is None
    assert meet(Pair(1.0, 1.0, (0.08, 0.0), ((0.0, 0.0), (1.0, 0.0)), 0.04, Contact(1.0))) is None
    assert meet(Pair(1.0, 1.0, (0.08, 0.0), ((0.0, 0.0), (0.0, 0.0)), 0.04, Contact(1.0))) is None


@pytest.mark.parametrize("tolerance", [1e-3, 1e-6, 1e-12])
def test_a_force_far_below_what_turns_a_pair_aside_has_its_maximum(tolerance):
    """Soft and oblique: the pair passes a hundredth of its reach deep, where a steep force is next to nothing; a drag is less."""
    pair = Pair(0.1, 0.0233, (0.06, 0.03978), ((0.0, 0.0), (-1.0, 0.0)), 0.04, Contact(6.5e25, 10.0, 1e-20))
    met = meet(pair)
    found, integrated = follow(pair, met, tolerance), oblique(pair, met)
    assert integrated.force < 1e-10
    assert found.force == pytest.approx(integrated.force, rel=1e-6)
