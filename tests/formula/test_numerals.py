"""Numbers as students write them."""

from __future__ import annotations

from decimal import ROUND_HALF_EVEN, Context, Decimal
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from corollary.formula.errors import ParseError
from corollary.formula.numerals import TO_ASCII, Written, decimal_text, figures_apart, scan_number


def number_in(text: str) -> Written | ParseError | None:
    """The number a whole text stands for; None where more than a number is in it."""
    found = scan_number(text.translate(TO_ASCII))
    if isinstance(found, ParseError):
        return found
    return None if text[found[1] :].strip() else found[0]


@pytest.mark.parametrize(
    ("text", "value", "figures", "least"),
    [
        ("8.6", "8.6", 2, 2),
        ("8,6", "8.6", 2, 2),
        (" 8.60 ", "8.6", 3, 3),
        ("-3", "-3", 1, 1),
        ("−3", "-3", 1, 1),
        ("+3", "3", 1, 1),
        ("20", "20", 2, 1),
        ("20.", "20", 2, 1),
        ("8.6.", "8.6", 2, 2),
        ("20.0", "20", 3, 3),
        ("0.0200", "0.02", 3, 3),
        (".5", "0.5", 1, 1),
        (",5", "0.5", 1, 1),
        ("0", "0", 1, 1),
        ("1.2e3", "1200", 2, 2),
        ("1,2e3", "1200", 2, 2),
        ("1.2E-3", "0.0012", 2, 2),
        ("1,2·10^3", "1200", 2, 2),
        ("1.2*10**3", "1200", 2, 2),
        ("1.2 x 10^3", "1200", 2, 2),
        ("1.2×10³", "1200", 2, 2),
        ("1.2 · 10^{-3}", "0.0012", 2, 2),
        ("1.2·10⁻³", "0.0012", 2, 2),
        ("10^-3", "0.001", 0, 0),
        ("1.234,5", "1234.5", 5, 5),
        ("1,234.5", "1234.5", 5, 5),
        ("1 234", "1234", 4, 4),
        ("12\u202f345,6", "12345.6", 6, 6),
        ("1'000", "1000", 4, 1),
        ("1,234,567", "1234567", 7, 7),
        ("1234,567", "1234.567", 7, 7),
        ("0,234", "0.234", 3, 3),
        ("1,2345", "1.2345", 5, 5),
        ("1,234e3", "1234", 4, 4),
        ("1.234", "1.234", 4, 4),
        ("1/2", "1/2", 0, 0),
        ("-3/4", "-3/4", 0, 0),
        ("½", "1/2", 0, 0),
        ("2½", "5/2", 0, 0),
        ("1e300", "1e300", 1, 1),
    ],
)
def test_a_number_is_read_as_it_is_meant(text, value, figures, least):
    assert number_in(text) == Written(Fraction(value), figures, least)


def test_a_comma_that_may_part_thousands_is_asked_about():
    found = number_in("1,234")
    assert isinstance(found, ParseError)
    assert (found.status, found.choices) == ("asked", ("1.234", "1234"))


@pytest.mark.parametrize(
    "text",
    [
        "",
        " ",
        "abc",
        "nan",
        "inf",
        "-",
        ".",
        ",",
        "1.2.3",
        "1,2,3",
        "5,",
        "1e400",
        "1e",
        "1e999999999",
        "10^10^10",
        "9**9",
        "1_000",
        "0x10",
        "٣",
        "1 2",
        "1 23",
        "1/0",
        "1/",
        "1//2",
        "1 000 00",
        "--3",
        "3-",
        "8.6 ± 0.1",
        "1" * 41,
        "9" * 10**6,
        "1e3 5",
        "3%%",
        "i",
        "1j",
    ],
)
def test_what_is_no_number_is_refused(text):
    found = number_in(text)
    if found is None:
        return  # it begins with a number, and something is left over
    assert isinstance(found, ParseError)
    assert found.status == "refused"
    assert found.why
    assert found.position is None or 0 <= found.position <= len(text)


@given(
    st.decimals(
        min_value=Decimal("-1e12"), max_value=Decimal("1e12"), allow_nan=False, allow_infinity=False, places=5
    )
)
def test_decimals_come_back(number):
    found = number_in(f"{number:f}")
    assert isinstance(found, Written)
    assert found.value == Fraction(number)


@given(st.integers(1, 10**18), st.integers(-40, 40), st.integers(1, 15))
def test_what_people_are_shown_is_rounded_half_to_even(mantissa, power, figures):
    number = Fraction(mantissa) * Fraction(10) ** power
    expected = Context(prec=figures, rounding=ROUND_HALF_EVEN).create_decimal(Decimal(mantissa).scaleb(power))
    shown = number_in(decimal_text(number, figures))
    assert isinstance(shown, Written)
    assert shown.value == Fraction(expected)
    assert shown.least <= figures <= max(shown.figures, len(str(int(number))))


@given(st.fractions())
def test_exactly_means_exactly(number):
    assert Fraction(decimal_text(number, 0)) == number


@pytest.mark.parametrize(
    ("number", "figures", "text"),
    [
        (8.6, 2, "8.6"),
        (8.6, 3, "8.60"),
        (20.0, 2, "20"),
        (1234.5, 3, "1230"),
        (0.000012345, 3, "1.23e-5"),
        (999.96, 4, "1000"),
        (0.00123, 2, "0.0012"),
        (2.5e6, 2, "2.5e6"),
        (-4.5, 1, "-4"),
        (0.0, 3, "0.00"),
        (-0.0, 1, "0"),
        (0.43, 0, "0.43"),
        (float("inf"), 3, "inf"),
        (5e-324, 2, "4.9e-324"),
        (1e300, 0, "1e300"),
    ],
)
def test_numbers_for_people(number, figures, text):
    assert decimal_text(number, figures) == text


@given(
    st.lists(
        st.one_of(st.fractions(max_denominator=10**12), st.floats(allow_nan=False, allow_infinity=False)),
        min_size=1,
        max_size=4,
    ),
    st.integers(1, 8),
    st.integers(0, 20),
)
def test_values_that_differ_are_written_apart(values, least, places):
    values = [*values, values[0], Fraction(values[0]) + Fraction(1, 10**places)]
    figures = figures_apart(values, least)
    texts = {decimal_text(each, figures): each for each in values}
    assert len(texts) == len(set(values))
    assert figures == least or len({decimal_text(each, figures - 1) for each in values}) < len(set(values))
