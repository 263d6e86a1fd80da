"""A student's number and unit, read once and shown back."""

from __future__ import annotations

import math
import re
import tracemalloc
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from corollary.answers.quantity import Reading, in_si, read_quantity
from corollary.answers.vector_quantity import components_in, read_quantities
from corollary.formula.errors import ParseError
from corollary.units.unit import Unit, read_unit, show, unit

IMPULSE = unit("kg*m/s")


@pytest.mark.parametrize(
    ("text", "si", "shown"),
    [
        ("8.6 kg m/s", "8.6", "8.6 kg m/s"),
        ("8,6 Ns", "8.6", "8.6 N s"),
        ("8.6N s", "8.6", "8.6 N s"),
        ("p = 8.6 kg·m/s", "8.6", "8.6 kg m/s"),
        ("Δp ≈ 8.60 kgm/s", "8.6", "8.60 kg m/s"),
        ("8.6 kg*m/s", "8.6", "8.6 kg m/s"),
        ("1,2·10^3 Ns", "1200", "1200 N s"),
        ("1.2e-5 N s", "0.000012", "1.2e-5 N s"),
        ("8600 g m/s", "8.6", "8600 g m/s"),
        ("0.43 kg*72 km/h", "8.6", "8.6 kg m/s"),
        ("1/2 kg m/s", "1/2", "0.5 kg m/s"),
        ("−8.6 kN ms", "-8.6", "-8.6 kN ms"),
    ],
)
def test_equivalent_units_convert(text, si, shown):
    found = read_quantity(text, IMPULSE)
    if si is None:
        assert isinstance(found, ParseError)
        return
    assert isinstance(found, Reading)
    assert (found.si, found.fit, found.as_read) == ((Fraction(si), 0), "fits", shown)


def test_a_comma_before_an_exponent_is_a_decimal_comma():
    found = read_quantity("1,2e3 N", unit("N"))
    assert isinstance(found, Reading)
    assert found.si == (1200, 0)


def test_a_wrong_dimension_says_what_was_expected_and_how_it_was_read():
    found = read_quantity("8.6 N", IMPULSE)
    assert isinstance(found, Reading)
    assert found.fit == "wrong dimension"
    assert found.why == "a momentum or an impulse is expected, for example in kg m/s; 8.6 N is a force"


def test_a_missing_unit_is_its_own_result():
    found = read_quantity("8.6", IMPULSE)
    assert isinstance(found, Reading)
    assert (found.fit, found.unit) == ("unit missing", None)
    assert found.why == "the unit is missing; write for example 8.6 kg m/s"


def test_nothing_needs_no_unit():
    found = read_quantity("0", IMPULSE)
    assert isinstance(found, Reading)
    assert (found.fit, found.si) == ("fits", (0, 0))


def test_a_full_stop_ends_a_sentence():
    found = read_quantity("p = 8.6 kg m/s.", IMPULSE)
    assert isinstance(found, Reading)
    assert found.as_read == "8.6 kg m/s"


@pytest.mark.parametrize(
    ("text", "expected", "si", "fit"),
    [
        ("30°", "rad", (Fraction(1, 6), 1), "fits"),
        ("30 deg", "rad", (Fraction(1, 6), 1), "fits"),
        ("0.5", "rad", (Fraction(1, 2), 0), "fits"),
        ("30", "deg", (Fraction(1, 6), 1), "unit missing"),
        ("85 %", "1", (Fraction(17, 20), 0), "fits"),
        ("0.85", "1", (Fraction(17, 20), 0), "fits"),
        ("5 m", "1", (Fraction(5), 0), "wrong dimension"),
        ("72 km/h", "m/s", (Fraction(20), 0), "fits"),
        ("5 /s", "Hz", (Fraction(5), 0), "fits"),
        ("5 1/s", "Hz", (Fraction(5), 0), "fits"),
    ],
)
def test_angles_ratios_and_rates(text, expected, si, fit):
    found = read_quantity(text, unit(expected))
    assert isinstance(found, Reading)
    assert (found.si, found.fit) == (si, fit)


def test_si_as_a_float():
    found = read_quantity("90 deg", None)
    assert isinstance(found, Reading)
    assert in_si(found) == pytest.approx(math.pi / 2, rel=1e-15)


@pytest.mark.parametrize(
    "text",
    [
        "3 m - 4 s",
        "nan m",
        "inf m",
        "1e400 m",
        "3 m 5",
        "9**9**9",
        "10**10**10 m",
        "1e999999999",
        "",
        "m",
        "8.6 n s",
        "5 dB",
        "1e300 km^9",
    ],
)
def test_what_is_no_quantity_is_refused(text):
    found = read_quantity(text, None)
    assert isinstance(found, ParseError)
    assert found.status == "refused"
    assert found.position is None or 0 <= found.position <= len(text)


@pytest.mark.parametrize(("text", "at"), [("8.6 J/kg m", 9), ("p = 1,234 N", 4), ("5 ms^-1", 2)])
def test_two_readings_are_asked_about(text, at):
    found = read_quantity(text, IMPULSE)
    assert isinstance(found, ParseError)
    assert (found.status, found.position) == ("asked", at)
    assert len(found.choices) == 2


@pytest.mark.parametrize(
    ("text", "values"),
    [
        ("(3, 4) m/s", (3, 4)),
        ("[3; 4] m/s", (3, 4)),
        ("(3 4) m/s", (3, 4)),
        ("v = (3, 4) m/s", (3, 4)),
        ("(-3.5,-4.25) m/s", (-3.5, -4.25)),
        ("(3,5; 4,2) m/s", (3.5, 4.2)),
        ("(1,5, 2,5) m/s", (1.5, 2.5)),
        ("3 m/s, 4 m/s", (3, 4)),
        ("3 m/s; 400 cm/s", (3, 4)),
        ("3; 4 m/s", (3, 4)),
        ("3 i + 4 j m/s", (3, 4)),
        ("(3 i - 4 j) m/s", (3, -4)),
        ("3 m/s i + 4 m/s j", (3, 4)),
        ("(3î+4ĵ) m/s", (3, 4)),
        ("-4j m/s", (0, -4)),
        ("i - j m/s", (1, -1)),
        ("5 m/s at 90°", (0, 5)),
        ("5 m/s ∠ 180 deg", (-5, 0)),
    ],
)
def test_a_vector_in_words(text, values):
    found = read_quantities(text, unit("m/s"), 2)
    assert isinstance(found, tuple), found
    assert [each.si for each in found] == [(Fraction(str(value)), 0) for value in values]
    assert all(each.fit == "fits" for each in found)


def test_a_length_and_an_angle():
    found = read_quantities("5,0 m/s at 30 deg", unit("m/s"), 2)
    assert isinstance(found, tuple)
    assert [in_si(each) for each in found] == pytest.approx([5 * math.cos(math.pi / 6), 2.5], rel=1e-15)
    assert [each.as_read for each in found] == ["4.33 m/s", "2.50 m/s"]


def test_components_without_units_say_so():
    found = read_quantities("(3, 4)", unit("m/s"), 2)
    assert isinstance(found, tuple)
    assert [each.fit for each in found] == ["unit missing"] * 2


def test_three_components():
    found = read_quantities("(1, 2, 3) N", unit("N"), 3)
    assert isinstance(found, tuple)
    assert [each.si[0] for each in found] == [1, 2, 3]


@pytest.mark.parametrize(
    ("text", "status"),
    [
        ("3 m/s", "refused"),
        ("(3, 4, 5) m/s", "refused"),
        ("(1,5,2,5) m/s", "asked"),
        ("(3, x) m/s", "refused"),
        ("5 m/s at 30", "refused"),
        ("3 i + 4 i", "refused"),
        ("3 k + 1 j", "refused"),
        ("", "refused"),
        ("at", "refused"),
        (" at 3 deg at 4 deg", "refused"),
        ("()", "refused"),
        ("i" * 190, "refused"),
        (
            "1e-300 m/s at 89.9999999 deg",
            "refused",
        ),  # its component along the first axis is below all that is meant
    ],
)
def test_what_is_no_vector(text, status):
    found = read_quantities(text, unit("m/s"), 2)
    assert isinstance(found, ParseError)
    assert found.status == status


MOST_CALLS = 400000

HOSTILE = [
    "9**9**9",
    "10**10**10 m",
    "1e999999999",
    "9" * 1_000_000,
    "(" * 3000,
    "-" * 100_000,
    "1" + " 000" * 60,
    "1/" * 90,
    "m" * 79,
    "m*" * 39,
    "m/" * 39,
    "N" * 9,
    "1 " + "mmmmmmmmm" * 8,
    "1," * 90,
    "1." * 90,
    "i " * 90,
    "3 i + " * 30,
    "at " * 60,
    ";" * 200,
    "__import__('os').getpid()",
    "\x00" * 200,
    "𝟏𝟐𝟑",
    "é" * 200,
    "1e" + "9" * 190,
    "m^" + "9" * 70,
    "m⁹⁹⁹⁹⁹⁹⁹",
    "½" * 190,
    "1" * 40 + "e300 Gm^9",
    "[[[[3;4]]]] m/s",
    "\u202e8.6",
    "a=1" * 60,
    "√" * 190,
    "\\frac{" * 30,
    "(1 " * 60,
    "1 " + "newton" * 30,
    "9^9*" * 45,
    "1e300*1e300",
    "the " * 49,
    "1 m/s at " + "3°" * 80,
]


@pytest.mark.parametrize("text", HOSTILE, ids=[repr(text[:20]) for text in HOSTILE])
def test_hostile_text_is_read_or_refused_with_little_work_and_memory(text, calls_of):
    assert isinstance(read_quantity(text, IMPULSE), Reading | ParseError)
    assert isinstance(read_quantities(text, IMPULSE, 2), tuple | ParseError)
    assert calls_of(lambda: (read_quantity(text, IMPULSE), read_quantities(text, IMPULSE, 2))) < MOST_CALLS
    tracemalloc.start()
    read_quantity(text, IMPULSE)
    read_quantities(text, IMPULSE, 2)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert peak < 50e6


@pytest.mark.parametrize(
    ("text", "expected", "shown"),
    [
        ("5 K", "K", "5 K"),
        ("2,5 mA", "A", "2.5 mA"),
        ("4.7 kΩ", "ohm", "4.7 kΩ"),
        ("4.7 kOhm", "kohm", "4.7 kΩ"),
        ("230 Volt", "V", "230 V"),
        ("3 A s", "C", "3 A s"),
        ("3 As", "C", "3 A s"),
        ("12 V * 2 A", "W", "24 W"),
        ("0.1 mol", "mol", "0.1 mol"),
        ("20 µT", "T", "20 µT"),
        ("3 V/A", "ohm", "3 V/A"),
        ("5 Kgm/s", "N s", "5 kg m/s"),  # kg, not kelvin times gram
    ],
)
def test_units_beyond_mechanics(text, expected, shown):
    found = read_quantity(text, unit(expected))
    assert isinstance(found, Reading), found
    assert (found.fit, found.as_read) == ("fits", shown)


@pytest.mark.parametrize(
    ("text", "expected", "meant"),
    [("5 T", "kg", "t"), ("72 km/H", "m/s", "km/h"), ("3 H", "s", "h")],
)
def test_a_capital_too_many_is_asked_about_where_its_small_letter_fits(text, expected, meant):
    """Tonnes and hours have capital letters more often than a mass is given in tesla."""
    found = read_quantity(text, unit(expected))
    assert isinstance(found, ParseError)
    assert found.suggestion == f"did you mean {meant}?"
    assert isinstance(read_quantity(text, None), Reading)


@pytest.mark.parametrize(
    ("text", "expected", "shown"),
    [
        ("8.6 KG M/S", "kg m/s", "8.6 kg m/s"),
        ("20 KM/H", "m/s", "20 km/h"),
        ("400 w", "W", "400 W"),
        ("20 Kj", "J", "20 kJ"),
        ("8 3/5 kg m/s", "kg m/s", "8.6 kg m/s"),
        ("-8 3/5 N", "N", "-8.6 N"),
        ("1 1/2", "1", "1.5"),
        ("20 1/s", "1/s", "20 1/s"),
    ],
)
def test_capitals_and_mixed_numbers_as_a_teacher_reads_them(text, expected, shown):
    found = read_quantity(text, unit(expected))
    assert isinstance(found, Reading)
    assert (found.as_read, found.fit) == (shown, "fits")


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("5 KGM", "kg"),
        ("5 MOHM", "ohm"),
        ("5 KQ", "kg"),
        ("3 KG", "m"),
        ("8 5/3 kg", "kg"),
        ("8.5 3/5 kg", "kg"),
        ("8 + 0.6 kg", "kg"),
    ],
)
def test_what_may_be_something_else_is_not_guessed(text, expected):
    """`8 + 0.6` may be a value and its uncertainty, `8 5/3` two numbers; the sentence says to write one."""
    assert isinstance(read_quantity(text, unit(expected)), ParseError)


def test_a_unit_of_another_subject_is_a_wrong_dimension():
    found = read_quantity("5 T", unit("N"))
    assert isinstance(found, Reading)
    assert found.why == "a force is expected, for example in N; 5 T is a magnetic field"


def test_a_length_and_an_angle_are_a_vector_in_a_plane_only():
    found = read_quantities("5 m/s at 30 deg", unit("m/s"), 3)
    assert isinstance(found, ParseError)
    assert (found.status, found.why) == ("refused", "a length and an angle give a vector in a plane only")


def test_a_length_and_an_angle_are_for_axes_and_not_for_two_bodies():
    found = read_quantities("5 m/s at 30 deg", unit("m/s"), 2, ("A", "B"))
    assert isinstance(found, ParseError)
    assert found.status == "refused"
    assert isinstance(read_quantities("5 m/s at 30 deg", unit("m/s"), 2, ("v_x", "v_y")), tuple)


@pytest.mark.parametrize(
    ("text", "expected", "shown"),
    [
        ("8.6 NS", "kg m/s", "8.6 N s"),
        ("8.6 N S", "kg m/s", "8.6 N s"),
        ("8.6 KGM/S", "N s", "8.6 kg m/s"),
        ("8.6 KGMS-1", "N s", "8.6 kg m/s"),
        ("5 KGM/S2", "N", "5 kg m/s²"),
        ("5 KNM", "J", "5 kN m"),
        ("5 NM", "m", "5 nm"),
        ("5 PA", "Pa", "5 Pa"),
        ("5 M/S", "m/s", "5 m/s"),
        ("5 MJ", "J", "5 MJ"),  # what fits as it stands is read as it stands
    ],
)
def test_capitals_throughout_are_what_is_asked_for_where_they_can_be_nothing_else(text, expected, shown):
    found = read_quantity(text, unit(expected))
    assert isinstance(found, Reading), found
    assert (found.as_read, found.fit) == (shown, "fits")


@pytest.mark.parametrize(
    ("text", "expected", "choices"),
    [("5 MS", "s", ("ms", "Ms")), ("5 MM", "m", ("mm", "Mm")), ("5 MNS", "N s", ("mN s", "MN s"))],
)
def test_capitals_that_can_be_two_units_are_asked_about(text, expected, choices):
    found = read_quantity(text, unit(expected))
    assert isinstance(found, ParseError)
    assert (found.status, found.choices, found.position) == ("asked", choices, 2)


@pytest.mark.parametrize(("text", "expected"), [("8.6 ns", "N s"), ("5 MS", "m/s"), ("8.6 NS", "m/s")])
def test_what_is_not_of_the_kind_asked_for_stays_what_it_says(text, expected):
    """Small letters are never cut where they are a unit: `ns` are nanoseconds."""
    found = read_quantity(text, unit(expected))
    assert isinstance(found, Reading)
    assert found.fit == "wrong dimension"


FACTORS = st.sampled_from(
    [
        "kg",
        "g",
        "mg",
        "t",
        "m",
        "mm",
        "cm",
        "km",
        "s",
        "ms",
        "us",
        "min",
        "h",
        "N",
        "kN",
        "mN",
        "MN",
        "J",
        "kJ",
        "mJ",
        "MJ",
        "W",
        "kW",
        "Pa",
        "kPa",
        "MPa",
        "Hz",
        "kHz",
    ]
)


@given(
    above=st.lists(FACTORS, min_size=1, max_size=3),
    below=st.lists(FACTORS, max_size=1),
    power=st.sampled_from(["", "2", "^2"]),
    between=st.sampled_from(["", " ", "*"]),
)
def test_capitals_are_never_read_as_another_size(above, below, power, between):
    """What is typed in capitals is the unit itself, or asked about, or refused; only what fits as it stands is taken so."""
    meant = " ".join(above) + "".join("/" + each + power for each in below)
    expected = unit(meant)
    typed = (between.join(above) + "".join("/" + each + power for each in below)).upper()
    as_it_stands = read_unit(typed)
    found = read_quantity(f"8.6 {typed}", expected)
    if isinstance(found, ParseError) or found.fit == "wrong dimension":
        return
    if isinstance(as_it_stands, Unit) and as_it_stands.dimension == expected.dimension:
        assert found.unit == as_it_stands
    else:
        assert found.si == expected.to_si(Fraction("8.6"))
        assert found.as_read == f"8.6 {show(found.unit)}".rstrip() != f"8.6 {typed}"


def test_most_units_of_mechanics_are_read_in_capitals():
    """Those that are not can be two: `MS`, `MM`; so the rule is no empty one."""
    listed = "kg,g,t,m,cm,km,s,h,min,N,kN,J,kJ,W,kW,Pa,kPa,Hz,m/s,km/h,cm/s,m/s^2,kg m/s,N s,N/m,kN/m,J/kg,kg/s,kg/m,kg m^2,N m,kg m^2/s"
    for each in listed.split(","):
        lone = each in ("t", "s", "h")  # `5 T`, `5 S` and `5 H` are units of electricity
        for between in ("", " "):
            found = read_quantity("8.6 " + each.replace(" ", between).upper(), unit(each))
            assert isinstance(found, ParseError if lone else Reading), (each, found)
            assert lone or found.si == unit(each).to_si(Fraction("8.6")), each


def test_a_text_may_be_as_long_as_the_refusal_says():
    refused = components_in("1, 2" + " " * 5_000, 2)
    assert isinstance(refused, ParseError)
    most = int(re.search(r"longer than (\d+) characters", refused.why)[1])
    assert components_in("(1, 2)".ljust(most), 2) == components_in("(1, 2)", 2)
    assert isinstance(components_in("(1, 2)".ljust(most + 1), 2), ParseError)


@pytest.mark.parametrize(
    ("text", "value"),
    [("6.72/2*10^2 N", 336), ("6.72/2·10² N", 336), ("6.72/2×10² N", 336), ("6.72/2*10**2 N", 336), ("6.72*1/2*10^2 N", 336), ("0.32*21/2*10^2 N", 336),
     ("33.6/1*10^1 N", 336), ("6.72/2*10^-2 N", 0.0336), ("6/2e3 N", 0.003), ("6/(2*10^3) N", 0.003)],
)  # fmt: skip
def test_a_product_behind_a_fraction_is_taken_from_the_left(text, value):
    found = read_quantity(text, unit("N"))
    assert not isinstance(found, ParseError)
    assert float(found.value) == pytest.approx(value)


@pytest.mark.parametrize("text", ["6/2x10^3 N", "6.72/2 x 10^-2 N", "6/2 10^3 N"])
def test_a_power_of_ten_with_a_cross_below_a_line_is_asked_about(text):
    found = read_quantity(text, unit("N"))
    assert isinstance(found, ParseError)
    assert (found.status, len(found.choices)) == ("asked", 2)
