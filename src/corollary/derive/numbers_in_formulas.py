"""Numbers with units as they stand in formulas, and chains of equalities in lines that fit a page."""

from __future__ import annotations

import re

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
        text = number(given, value).replace("−", "-")
        mantissa, _, power = text.partition("e")
        text = rf"{mantissa}\cdot 10^{{{power}}}" if power else mantissa
        numbers[given.symbol] = _bracketed(_with_unit(text, unit), text)
    return numbers


def quantity(value: float, unit: Unit, *, in_formula: bool = False) -> str:
    """A value in SI, in a unit; in a formula it stands in brackets."""
    in_unit = unit.from_si(value)
    text = decimal_text(in_unit, FIGURES) if in_unit else "0"
    mantissa, _, power = text.partition("e")
    text = rf"{mantissa}\cdot 10^{{{power}}}" if power else mantissa
    whole = _with_unit(text, unit)
    return _bracketed(whole, text) if in_formula else whole


def whole_quantity(value: float, unit: Unit) -> str:
    """A whole number in SI, in a unit."""
    return _with_unit(f"{round(unit.from_si(value))}", unit)


def _with_unit(text: str, unit: Unit) -> str:
    """A number and its unit; degrees stand at their number."""
    symbol = unit_latex(unit)
    return text + (symbol if unit.text == "deg" else rf"\,{symbol}" if symbol else "")


def _bracketed(whole: str, text: str) -> str:
    """In brackets where a sign or a unit could be misread inside a product or a power."""
    return rf"({whole})" if whole != text or text.startswith("-") else whole


WIDEST = 75  # letters: about what fits on a line of A4 between the margins
FRACTION = re.compile(r"\\frac\{((?:[^{}]|\{[^{}]*\})*)\}\{((?:[^{}]|\{[^{}]*\})*)\}")
COMMAND = re.compile(r"\\(?:left|right|mathrm|cdot|sqrt|,)|[{}\\ ^]")


def without_repetition(steps: list[str]) -> list[str]:
    """A chain in which no side is the one before it in brackets: `(14.10) = 14.10` says nothing."""
    found: list[str] = []
    for step in steps:
        if found and _bare(found[-1]) == _bare(step):
            found.pop()
        found.append(step)
    return found


def _bare(step: str) -> str:
    return re.sub(r"\\left|\\right|[() ]", "", step)


def broken(steps: list[str]) -> list[str]:
    """A chain of equalities in lines that fit a page; a new line begins with its equals sign."""
    lines = [steps[0]]
    for step in steps[1:]:
        if width(lines[-1]) + width(step) > WIDEST and lines[-1] != steps[0]:
            lines.append(f"= {step}")
        else:
            lines[-1] += f" = {step}"
    return lines


def width(formula: str) -> int:
    """About how many letters wide a formula is set: the wider line of a fraction counts, commands do not."""
    while (inner := FRACTION.search(formula)) is not None:
        formula = formula[: inner.start()] + max(inner[1], inner[2], key=len) + formula[inner.end() :]
    return len(COMMAND.sub("", formula))
