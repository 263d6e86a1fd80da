"""Quantities and formulas as people type them: sums, units in words and brackets, Euler's number, lost raising, TeX."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from corollary.answers.read_case import read_case


def value(text: str, unit: str):
    found = read_case({"text": text, "field": "quantity", "unit": unit})
    return found["value"] if found["status"] == "ok" and found["verdict"] == "compatible" else found["status"]


@pytest.mark.parametrize(
    ("text", "unit", "si"),
    [
        ("3 N + 4 N", "N", 7), ("80 N+6 N", "N", 86), ("96 N-10 N", "N", 86), ("1-0.6", "1", 0.4), ("0.43*20 - 0", "1", 8.6), ("9.4 m-2 cm", "m", 9.38),
        ("5*4+3*2", "1", 26), ("1 h 30 min", "s", 5400), ("1h30min", "s", 5400), ("1 m 20 cm", "m", 1.2), ("5 ft 3 in", "m", 1.6002), ("2 kg 300 g", "kg", 2.3),
        ("25 W m-2 K-1", "W/(m^2 K)", 25), ("3 W/mK", "W/(m K)", 3), ("3 W/(mK)", "W/(m K)", 3),
        ("2 acres", "m^2", 8093.7452), ("3 yrs", "s", 94672800), ("2 y", "s", 63115200), ("1.5 a", "yr", 47336400), ("2 months", "s", 5259600),
        ("3 light years", "m", 2.838219e16), ("3 light-years", "m", 2.838219e16), ("3 mm Hg", "Pa", 399.967), ("3 cP", "Pa s", 0.003), ("3 cSt", "m^2/s", 3e-6),
        ("3 gm", "kg", 0.003), ("25 centigrade", "K", 298.15), ("5 kilohm", "ohm", 5000), ("5 megohm", "ohm", 5e6), ("5 MOhm", "ohm", 5e6), ("3 Mhz", "Hz", 3e6),
        ("3 per mille", "1", 0.003), ("3 rotations/min", "rad/s", 0.314159265), ("3.09 times a second", "1/s", 3.09), ("3.09 times per second", "1/s", 3.09),
        ("60 litres a minute", "m^3/s", 0.001), ("2 a.u.", "m", 2.991957414e11), ("0.5 g's", "m/s^2", 4.903325),
        ("5! N", "N", 120), ("0.8/2!", "1", 0.4), ("(2*3)*2!", "1", 12),
        # units
        ("60 mins", "s", 3600), ("5 kohms", "ohm", 5000), ("5 cms", "m", 0.05), ("1 mPas", "Pa s", 1e-3), ("12 cNm", "N m", 0.12), ("5 (m/s)^2", "m^2/s^2", 5),
        ("86 kg m (s^2)^-1", "N", 86), ("(-36 kJ)/mol", "J/mol", -36000), ("(3/2)*(m/s)", "m/s", 1.5), ("3 square meters", "m^2", 3), ("3 m squared", "m^2", 3),
        ("3 gram per cubic centimeter", "kg/m^3", 3000), ("4 Quadratmeter", "m^2", 4), ("7 in", "m", 0.1778), ("0.6 c", "m/s", 179875474.8),
        ("938 MeV/c^2", "kg", 1.67214e-27),
        ("1 hp", "W", 745.69987), ("1 psi", "Pa", 6894.757), ("5 cycles/s", "Hz", 5), ("5 cycles/s", "rad/s", 10 * math.pi), ("83.6 in J", "J", 83.6),
        ("445.5 kilo", "kg", 445.5),
        ("25 ⁰C", "degC", 298.15), ("25 oC", "K", 298.15), ("77 F", "degC", 298.15), ("20°", "degC", 293.15),
        # numbers
        ("0.123 456 m", "m", 0.123456), ("1.5 E 3 N", "N", 1500), ("16.3 e1", "1", 163), ("2.179x10-3", "1", 2.179e-3), ("10^2.5", "1", 10**2.5), ("|-5| N", "N", 5),
        ("1 ¾ m", "m", 1.75), ("⁻3.2 m/s", "m/s", -3.2), ("5*Pi/3", "1", 5 * math.pi / 3), ("log_10(100)", "1", 2), ("arccot(1)", "rad", math.pi / 4),
        ("5*cos(90°) N", "N", 0), ("86 N = F", "N", 86), ("-8.6 N s = p_x", "N s", -8.6),
        ("(F = 86 N)", "N", 86), ("[F = 86 N]", "N", 86), ("F → 86 N", "N", 86), ("F -> -86 N", "N", -86), ("F (average) = 86 N", "N", 86),
        ("316 million km", "m", 3.16e11), ("5 thousand N", "N", 5000), ("2,5 Millionen km", "m", 2.5e9),
        ("a right angle", "rad", math.pi / 2), ("ein rechter Winkel", "deg", math.pi / 2),
        # Euler's number
        ("1/e", "1", math.exp(-1)), ("5*e^(-2) N", "N", 5 * math.exp(-2)), ("10*e^-1 V", "V", 10 * math.exp(-1)), ("5 e^(-1.5) m/s", "m/s", 5 * math.exp(-1.5)),
        ("1/np.e", "1", math.exp(-1)), ("2 e", "C", 2 * 1.602176634e-19),
        # TeX
        (r"5\,\mathrm{\mu m}", "m", 5e-6), (r"5\,\mathrm{k\Omega}", "ohm", 5000), (r"9.8~\frac{m}{s^2}", "m/s^2", 9.8), (r"86\,\frac{\mathrm{kg\,m}}{\mathrm{s}^2}", "N", 86),
    ],
)  # fmt: skip
def test_a_quantity_is_read(text, unit, si):
    assert value(text, unit) == pytest.approx(si, rel=1e-5, abs=1e-20)


@pytest.mark.parametrize(
    ("text", "unit"),
    [
        ("3x108 m/s", "m/s"), ("5 x 104 N", "N"), ("0x10", "1"), ("11*", "1"), ("86!", "N"), ("8-9 N", "N"), ("8 + 0.6 kg", "kg"),
        ("F (left) = 86 N", "N"),
        ("F (half) = 86 N", "N"), ("F (double) = 86 N", "N"), ("F (right) = 86 N", "N"), ("(F = 86 N) = 43", "N"), ("1.029 - 21.609 J", "J"), ("86 N is 86 J", "N"),
        ("3 Cal", "J"), ("3 1/min", "rad/s"), ("3 mhz", "Hz"), ("5 MOHM", "ohm"), ("20°", "K"), ("3 m + 4 s", "m"),
        ("3 m+4 s", "m"), ("1 min 2 h", "s"), ("a,b", "1"), ("86 N = 2F", "N"), ("86 N = m a", "N"), ("86 N = 96 N", "N"),
        ("not a right angle", "rad"), ("less than a right angle", "rad"), ("half a right angle", "rad"),
    ],
)  # fmt: skip
def test_what_has_two_readings_or_none_is_not_guessed(text, unit):
    assert value(text, unit) in ("asked", "refused")


@pytest.mark.parametrize(
    ("text", "names", "same"),
    [
        (r"\{m+M\} v", "m M v", "(m + M)*v"), (r"\left\{v+w\right\}\frac{m}{2}", "m v w", "m*(v + w)/2"), ("v[0]^2/2", "v v0", "v0^2/2"), ("ħ*w", "hbar w", "hbar*w"),
        ("∛x", "x", "x^(1/3)"), ("xⁿ", "x n", "x^n"), ("ln|x|", "x", "ln(abs(x))"), (r"\sqrt[3]{x}", "x", "x^(1/3)"), ("log_3(x)", "x", "ln(x)/ln(3)"),
        ("R1||R2", "R1 R2", "R1*R2/(R1+R2)"),
        ("Sin(x)", "x", "sin(x)"), ("2*Pi*x", "x", "2*pi*x"), (r"{x \over y}", "x y", "x/y"), (r"\sin \cos x", "x", "sin(cos(x))"),
        ("arcsec(x)", "x", "acos(1/x)"), ("x^+5", "x", "x^5"),
    ],
)  # fmt: skip
def test_a_formula_is_read(text, names, same):
    found = read_case({"text": text, "field": "expression", "names": names.split(), "equals": same})
    assert found["verdict"] == "equal", found


@pytest.mark.parametrize(
    ("text", "names"),
    [
        ("e^2x", "x"), ("10^2x", "x"), ("r^1/2", "r"), ("e^-x/2", "x"), ("2E+3*x", "E x"), ("2e-3", "e"), ("m[1]*v", "m v"), ("n!", "n"),
        (r"\int (x+a)", "x a"), ("int(x+a)", "x a"),
        ("a,b,c", "a b c"), ("(-b+-sqrt(b))/2", "b"), ("x ± y", "x y"),
    ],
)  # fmt: skip
def test_a_formula_with_two_readings_is_asked_about(text, names):
    found = read_case({"text": text, "field": "expression", "names": names.split()})
    assert found["status"] in ("asked", "refused"), found


def test_the_stages_of_a_reading_are_told():
    found = read_case({"text": "the force F = 86 N", "field": "quantity", "unit": "N"}, explain=True)
    assert [each["stage"] for each in found["stages"]][-3:] == [
        "solve_left_side",
        "parse_number",
        "parse_unit",
    ]
    assert found["stages"][-1] == {"stage": "parse_unit", "took": "N", "left": ""}


@pytest.mark.parametrize(
    ("text", "read"),
    [
        ("12 N because F = ma", 12),
        ("12 N because left is negative", "asked"),
        ("12 N since it moves left", "asked"),
        ("12 N due to the push left", "asked"),
        ("12 N because it moves towards the wall", "asked"),
        ("12 N, because it loses energy", "asked"),
    ],
)
def test_a_reason_behind_a_number_gives_no_sign(text: str, read: object):
    assert value(text, "N") == read


@pytest.mark.parametrize(
    ("text", "unit", "told"),
    [
        ("1.571 rad^2", "rad", "wrong dimension"), ("90 deg^2", "deg", "wrong dimension"), ("3 sr", "rad", "wrong dimension"), ("0.3 1/rad", "rad", "wrong dimension"),
        ("0.5 rad^2", "1", "wrong dimension"), ("3 rad^2/s", "rad/s", "wrong dimension"), ("5 %", "rad", "asked"),
        ("12 % N", "N", "asked"), ("12 N %", "N", "asked"), ("12 ‰ N", "N", "asked"), ("12 ° N", "N", "asked"), ("50 %^2", "1", "asked"),
        ("5 rad/s", "Hz", "asked"), ("300 °/s", "Hz", "asked"), ("60 rpm", "1/s", "asked"), ("5 Hz", "rad/s", "asked"),
    ],
)  # fmt: skip
def test_a_power_of_an_angle_a_share_of_a_unit_and_a_turn_are_not_what_has_their_dimension(text, unit, told):
    found = read_case({"text": text, "field": "quantity", "unit": unit})
    assert told in (found["status"], found["verdict"])


@pytest.mark.parametrize(
    ("text", "unit", "si"),
    [
        ("5 G", "T", 5e-4), ("0.5 kG", "T", 0.05), ("300 mG", "T", 3e-5), ("5 Gs", "T", 5e-4), ("60 rpm", "Hz", 1), ("60 rev/min", "Hz", 1),
        ("60 rpm", "rad/s", 2 * math.pi),
        ("5 1/s", "rad/s", 5), ("3 rad m/s", "m/s", 3), ("9 rad^2 m/s^2", "m/s^2", 9), ("4 N m", "N m/rad", 4), ("4 N m/rad", "N m/rad", 4),
        ("5 %/s", "1/s", 0.05), ("5 sr", "rad^2", 5),
    ],
)  # fmt: skip
def test_radians_may_be_left_out_and_a_gauss_is_short_where_a_field_is_asked_for(text, unit, si):
    assert value(text, unit) == pytest.approx(si, rel=1e-12)


@given(
    st.sampled_from(["rad", "deg", "mrad", "turn", "gon", "arcmin"]),
    st.integers(-3, 3).filter(bool),
    st.sampled_from(["rad", "deg", "1"]),
)
def test_of_the_powers_of_an_angle_only_the_first_is_an_angle_or_a_number(angle, power, asked):
    found = read_case({"text": f"2 {angle}^{power}", "field": "quantity", "unit": asked})
    assert (found["verdict"] == "compatible") == (power == 1)


@pytest.mark.parametrize(
    ("text", "unit", "si"),
    [("5 kwh", "J", 1.8e7), ("5 KWH", "J", 1.8e7), ("5 kWh", "J", 1.8e7), ("5 wh", "J", 18000), ("5 kn", "m/s", 5 * 463 / 900), ("2000 mAh", "C", 7200)],
)  # fmt: skip
def test_an_hour_may_be_written_on_to_a_watt_in_any_case(text, unit, si):
    assert value(text, unit) == pytest.approx(si, rel=1e-9)


@pytest.mark.parametrize(("text", "unit"), [("5 kn", "N"), ("5 t", "T"), ("5 s", "S"), ("5 h", "H")])
def test_a_small_letter_of_another_unit_is_asked_about_where_its_capital_fits(text, unit):
    assert value(text, unit) == "asked"
