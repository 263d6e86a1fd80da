"""Values with an uncertainty: read without it up to a tenth, and refused beyond."""

from __future__ import annotations

import pytest

from corollary.answers.quantity import Reading, read_quantity
from corollary.formula.errors import ParseError
from corollary.units.unit import unit


@pytest.mark.parametrize(
    ("written", "value"),
    [
        ("8.6 ± 0.1 N", 8.6),
        ("8.6 N ± 0.1 N", 8.6),
        ("(8.6 ± 0.1) N", 8.6),
        ("8,6 ± 0,1 N", 8.6),
        ("8.6 +/- 0.1 N", 8.6),
        ("8.6 N +- 0.1", 8.6),
        ("8.6 N ± 5 %", 8.6),
        ("8.6 N ± 86 cN", 8.6),
        ("F = -8.6 ± 0.86 N", -8.6),
        ("10 ± 1 N", 10.0),
        ("8.6 N ± 0", 8.6),
    ],
)
def test_a_small_uncertainty_is_passed_over(written, value):
    found = read_quantity(written, unit("N"))
    assert isinstance(found, Reading), found
    assert float(found.value) == value
    assert found.fit == "fits"


@pytest.mark.parametrize(
    "written",
    [
        "9.9 ± 5 N",
        "9.9 N ± 5 N",
        "(9.9 ± 5) N",
        "10 ± 1.1 N",
        "-10 ± 10 N",
        "9.9 N ± 50 %",
        "9.9 N ± 1 kN",
        "9.9 N ± 0.1 m",
        "0 ± 1 N",
        "86 ± 80 N",
        "0.43*20 ± 5 N",
    ],
)
def test_a_wide_one_leaves_the_value_open(written):
    found = read_quantity(written, unit("N"))
    assert isinstance(found, ParseError), found
    assert "uncertainty" in found.why


@pytest.mark.parametrize(
    ("written", "choices"),
    [
        ("65.0(5) N", ("65.0 ± 0.5", "65.0*5")),
        ("F = 65(12) N", ("65 ± 12", "65*12")),
        ("-8,65(12)", ("-8,65 ± 0,12", "-8,65*12")),
        ("0.43(20) N", ("0.43 ± 0.20", "0.43*20")),
    ],
)
def test_one_in_brackets_may_be_a_factor_and_is_asked_about(written, choices):
    found = read_quantity(written, unit("N"))
    assert isinstance(found, ParseError)
    assert (found.status, found.choices) == ("asked", choices)


def test_one_in_brackets_before_a_power_of_ten_is_not_read():
    for written in ("6.50(5)e1 N", "6.50(5)·10^1 N"):
        found = read_quantity(written, unit("N"))
        assert isinstance(found, ParseError)
        assert (found.status, found.suggestion) == ("refused", "write ± or *")


def test_what_is_plainly_a_product_or_the_same_either_way_is_read():
    for written, value in (
        ("8.6(1) N", 8.6),
        ("(0.43)(20) N", 8.6),
        ("0.43(20)/0.1 N", 86.0),
        ("2(3+4) N", 14.0),
    ):
        found = read_quantity(written, unit("N"))
        assert isinstance(found, Reading), found
        assert float(found.value) == pytest.approx(value)


def test_a_share_may_be_uncertain_by_as_many_percent_as_it_has():
    """The percent behind both belong to both."""
    found = read_quantity("96 ± 2 %", unit("1"))
    assert isinstance(found, Reading)
    assert float(found.si[0]) == 0.96
    assert isinstance(read_quantity("96 ± 20 %", unit("1")), ParseError)
