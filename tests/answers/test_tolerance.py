"""When numbers are near enough: distances, signs, and what the figures that were written can tell."""

from __future__ import annotations

import math
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from corollary.answers.answer import Numbers
from corollary.answers.tolerance import coarse, coarse_polar, last_place, same_signs, same_value, within

DEGREE = math.pi / 180


def test_a_distance_is_that_of_the_whole_vector():
    assert within((3.0, 4.0), (3.0, 4.03), 0.01, 5.0)
    assert not within((3.0, 4.0), (3.04, 4.04), 0.01, 5.0)


@pytest.mark.parametrize("values", [(1.0,), (1.0, math.nan), (1.0, math.inf), (1.0, 2.0, 3.0)])
def test_what_is_no_vector_of_that_many_numbers_is_near_nothing(values):
    assert not within(values, (1.0, 2.0), 100.0, 1.0)


@pytest.mark.parametrize(
    ("values", "target", "agree"),
    [
        ((1.0, 1e-3), (1.0, 1e-3), True),
        ((1.0, -1e-3), (1.0, 1e-3), False),  # off by 0.2 % of the length only, and the wrong way
        ((1.0, -1e-3), (1.0, 1e-5), True),  # rounding alone may turn so small a component
        ((1.0, 0.0), (1.0, 1e-3), True),
        ((-1.0, 1e-3), (1.0, 1e-3), False),
    ],
)
def test_each_component_points_the_right_way_where_rounding_leaves_it_a_sign(values, target, agree):
    assert same_signs(values, target, (1e-4, 1e-4)) == agree


@pytest.mark.parametrize(
    ("value", "figures", "target", "few"),
    [
        (8.6, 2, 8.64, 2),
        (8.6, 2, 8.65, 2),  # the half is rounded either way
        (8.6, 2, 8.66, 0),
        (9.0, 1, 8.6, 1),
        (0.0, 1, 0.3, 0),
        (8.6, 0, 8.64, 0),  # calculated, not written
    ],
)
def test_figures_tell_how_far_a_number_was_rounded(value, figures, target, few):
    assert coarse((value,), (figures,), (target,), (1.0,), (0.0,)) == few


def test_a_component_that_is_near_has_figures_enough():
    assert coarse((8.6, 1.0), (2, 1), (8.64, 1.0001), (1.0, 1.0), (0.01, 0.01)) == 2


def test_figures_are_counted_in_the_unit_that_was_written():
    kmh = 1 / 3.6
    assert last_place(72 * kmh, 2, kmh) == pytest.approx(kmh)
    assert coarse((72 * kmh,), (2,), (72.4 * kmh,), (kmh,), (0.0,)) == 2
    assert coarse((72 * kmh,), (2,), (72.6 * kmh,), (kmh,), (0.0,)) == 0


@pytest.mark.parametrize(
    ("length", "figures", "angle", "angle_figures", "target", "few"),
    [
        (4.8, 2, 30.0, 2, (4.83, 30.0), 2),
        (4.8, 2, 30.0, 2, (4.8, 30.4), 2),
        (4.8, 2, 30.0, 2, (4.8, 30.6), 0),
        (4.8, 2, 30.45, 4, (4.83, 30.0), 0),  # a coarse length says nothing of the direction
        (4.83, 3, 30.0, 2, (4.83, 30.4), 2),
        (4.83, 3, 151.0, 3, (4.83, 151.4), 2),  # whole degrees, whichever they are
        (4.83, 3, 8.0, 1, (4.83, 8.4), 1),
        (4.83, 3, -179.0, 3, (4.83, 180.6), 2),  # across the seam
    ],
)
def test_a_length_and_an_angle_are_bounded_each_by_its_own_figures(
    length, figures, angle, angle_figures, target, few
):
    def vector(size: float, degrees: float) -> tuple[float, float]:
        return size * math.cos(degrees * DEGREE), size * math.sin(degrees * DEGREE)

    polar = (
        Numbers((length,), (figures,), "", sizes=(1.0,)),
        Numbers((angle * DEGREE,), (angle_figures,), "", sizes=(DEGREE,)),
    )
    assert coarse_polar(vector(length, angle), polar, vector(*target), 1.0, 0.0005) == few


DECIMALS = st.integers(-999_999, 999_999).filter(bool).map(lambda n: Fraction(n, 10_000))
SHARES = st.integers(1, 2000).map(lambda n: Fraction(n, 10_000))


@given(DECIMALS, SHARES, st.sampled_from([-1, 1]), st.integers(-30, 30))
def test_the_edge_of_a_tolerance_is_inside_on_both_sides_and_what_is_beyond_is_not(
    target, share, side, power
):
    """In exact fractions the answer lies on the edge, or a millionth beyond; the doubles next to them are judged alike."""
    target *= Fraction(10) ** power
    edge, beyond = target * (1 + side * share), target * (1 + side * (share + Fraction(1, 10**6)))
    assert within((float(edge),), (float(target),), float(share), abs(float(target)))
    assert not within((float(beyond),), (float(target),), float(share), abs(float(target)))


@given(DECIMALS, st.sampled_from([-1, 1]))
def test_two_sides_of_an_equation_may_be_a_twentieth_apart_either_way(reference, side):
    edge = reference * (1 + side * Fraction(1, 20))
    beyond = reference * (1 + side * Fraction(50_001, 10**6))
    assert same_value(float(edge), float(reference))
    assert not same_value(float(beyond), float(reference))


def test_a_small_value_is_no_zero_on_the_other_side():
    assert not same_value(1e-13, 5e-13)
    assert not same_value(1e-13, 0.0)
    assert same_value(1e-13, 0.0, 1e-12)


@given(st.integers(-60_00, 60_00).map(lambda n: Fraction(n, 100)), st.integers(0, 2))
def test_a_temperature_rounded_in_kelvins_is_met_by_its_figures(celsius, decimals):
    kelvin = celsius + Fraction("273.15")
    written = round(kelvin, decimals)
    figures = 3 + decimals
    off = Fraction(6, 10) / 10**decimals
    for number, met in ((written, True), (kelvin + off, False), (kelvin - off, False)):
        found = coarse(
            (float(number - Fraction("273.15")),), (figures,), (float(celsius),), (1.0,), (0.0,), (-273.15,)
        )
        assert bool(found) == met
