"""Numbers with their units as they stand in the formulas of a worked solution."""

from __future__ import annotations

from corollary.formula.numerals import decimal_text
from corollary.problem.variant import Variant, number
from corollary.units.unit import Unit, si_unit
from corollary.units.unit import latex as unit_latex

FIGURES = 4  # one more than students' numbers have, so that a value can be used again without rounding anew


def given_numbers(variant: Variant) -> dict[str, str]:
    """Each given as it stands in a formula: number and unit."""
    numbers: dict[str, str] = {}
    for given in variant.problem.givens:
        unit, value = given.unit, variant.values[given.symbol]
        if unit.offset:  # a formula takes a temperature in kelvin
            unit, value = si_unit(unit.dimension), unit.to_si(value)[0]
        symbol = unit_latex(unit)
        text = number(given, value).replace("−", "-")
        mantissa, _, power = text.partition("e")
        text = rf"{mantissa}\cdot 10^{{{power}}}" if power else mantissa
        numbers[given.symbol] = _bracketed(text + (rf"\,{symbol}" if symbol else ""), text)
    return numbers


def quantity(value: float, unit: Unit, *, in_formula: bool = False) -> str:
    """A value in SI, in a unit; in a formula it stands in brackets."""
    in_unit = unit.from_si(value)
    text = decimal_text(in_unit, FIGURES) if in_unit else "0"
    mantissa, _, power = text.partition("e")
    text = rf"{mantissa}\cdot 10^{{{power}}}" if power else mantissa
    symbol = unit_latex(unit)
    whole = text + (rf"\,{symbol}" if symbol else "")
    return _bracketed(whole, text) if in_formula else whole


def _bracketed(whole: str, text: str) -> str:
    """In brackets where a sign or a unit could be misread inside a product or a power."""
    return rf"({whole})" if whole != text or text.startswith("-") else whole
