"""Every unit of the table is what pint says it is, in size and in dimension; temperatures have a zero of their own."""

from __future__ import annotations

import math
from fractions import Fraction

import pint
import pytest

from corollary.answers.quantity import Reading, read_quantity
from corollary.formula.errors import ParseError
from corollary.units.unit import BASE, canonical, latex, read_unit, show, unit
from corollary.units.unit_table import PREFIXES, ROWS, TYPED, WITH_PREFIXES

PINT = pint.LazyRegistry()
IN_PINT = {
    "t": "metric_ton",
    "%": "percent",
    "u": "unified_atomic_mass_unit",
    "e": "elementary_charge",
    "au": "astronomical_unit",
    "ly": "light_year",
    "pc": "parsec",
    "delta_degC": "kelvin",
    "delta_degF": "delta_degF",
    "delta_K": "kelvin",
    "Torr": "torr",
    "g": "gram",
    "h": "hour",
    "d": "day",
    "yr": "year",
    "min": "minute",
    "l": "liter",
    "T": "tesla",
    "F": "farad",
    "C": "coulomb",
    "kn": "knot",
    "c": "speed_of_light",
    "oz": "ounce",
    "gal": "gallon",
    "cc": "cubic_centimeter",
    "in": "inch",
    "M": "molar",
    "rem": "rem",
    "PS": "metric_horsepower",
}
OF_PINT = {  # pint has no torr, 760 of which are an atmosphere, and the parsec of before 2015
    "torr": (101325 / 760, "pascal"),
    "parsec": (648000 / math.pi, "astronomical_unit"),
    "dpt": (1, "1/meter"),  # in pint a tenth of a pint
    "ppb": (1e-9, "dimensionless"),
    "‰": (1e-3, "dimensionless"),
    "gauss": (1e-4, "tesla"),  # in pint a unit of another system
}
NAMES = [row[0].split()[0] for row in ROWS]


def pint_size(name):
    """Size and dimension of a unit by pint."""
    size, called = OF_PINT.get(IN_PINT.get(name, name), (1, IN_PINT.get(name, name)))
    found = (size * PINT(f"1 {called}")).to_base_units()
    return float(found.magnitude), dict(found.unit_items())


@pytest.mark.parametrize("name", [each for each in NAMES if each not in {"degC", "degF"}])
def test_a_row_is_what_pint_has(name):
    size, powers = pint_size(name)
    long = dict(
        zip(BASE, ("kilogram", "meter", "second", "ampere", "kelvin", "mole", "candela"), strict=True)
    )
    ours = unit(name)
    found = {long[base]: float(power) for base, power in ours.dimension.powers().items()}
    assert ours.si == pytest.approx(size, rel=1e-14)
    assert found == {
        base: float(power) for base, power in powers.items() if base not in {"radian", "count"} and power
    }


TYPED_FOR_ANOTHER = {"Tm", "Grad", "dag", "PS"}
"""T m, degrees in German, a day in Norwegian, a metric horsepower."""


@pytest.mark.parametrize("prefix", [each for each in PREFIXES if each])
def test_a_prefix_is_what_pint_has(prefix):
    """On every unit that takes prefixes: `mPa` is no metre times a pascal, `Mbar` no millibar."""
    size = float(PINT(f"1 {prefix}Hz").to("Hz").magnitude)
    for name in {each.text for each in WITH_PREFIXES.values()}:
        for sign in TYPED.get(prefix, (prefix,)):
            if sign + name not in TYPED_FOR_ANOTHER:
                assert canonical(unit(sign + name)) == prefix + name
                assert unit(sign + name).si == pytest.approx(size * unit(name).si, rel=1e-12)


@pytest.mark.parametrize(("typed", "meant"), [("Tm", "T m"), ("Grad", "deg"), ("dag", "d")])
def test_what_looks_like_a_prefix_and_is_none(typed, meant):
    assert unit(typed) == unit(meant)


@pytest.mark.parametrize("celsius", [-40, 0, 20, 37, 100])
def test_temperatures_have_a_zero_of_their_own(celsius):
    kelvin = PINT.Quantity(celsius, "degC").to("kelvin").magnitude
    fahrenheit = PINT.Quantity(celsius, "degC").to("degF").magnitude
    for text in (f"{celsius} °C", f"{celsius} deg C", f"{celsius} degrees Celsius", f"{fahrenheit:.10g} °F"):
        read = read_quantity(text, unit("K"))
        assert isinstance(read, Reading)
        assert (float(read.si[0]), read.fit) == (pytest.approx(kelvin), "fits")
    bare = read_quantity(str(celsius), unit("°C"))
    assert isinstance(bare, Reading)
    assert float(bare.si[0]) == pytest.approx(kelvin)


@pytest.mark.parametrize(
    ("text", "factor"),
    [
        ("J/(kg °C)", 1),
        ("°C/min", Fraction(1, 60)),
        ("Δ°C", 1),
        ("delta K", 1),
        ("W/(m^2*degF)", Fraction(9, 5)),
    ],
)
def test_in_a_product_a_temperature_is_a_difference(text, factor):
    found = unit(text)
    assert (found.factor, found.offset) == (factor, 0)
    assert unit(canonical(found)) == found
    assert "delta" not in show(found) + latex(found)


def test_a_difference_of_temperatures_is_read_as_one():
    read = read_quantity("20 °C", unit("Δ°C"))
    assert isinstance(read, Reading)
    assert (read.si, read.as_read) == ((20, 0), "20 °C")


def test_an_angstrom_has_two_signs_and_three_spellings():
    for typed in ("Å", "\N{ANGSTROM SIGN}", "Ångström", "ångstrøm", "angstroms"):
        assert unit(typed).si == 1e-10
    assert show(unit("eV/Å")) == "eV/Å"
    assert canonical(unit("eV/Å")) == "eV/angstrom"


def test_what_is_no_unit_says_why():
    for text in ("dB", "Np", "decibel"):
        found = read_unit(text)
        assert isinstance(found, ParseError)
        assert (
            found.why
            == f"{text} is a logarithm of a ratio, not a unit: give the ratio itself, or the quantity"
        )
