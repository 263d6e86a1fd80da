"""Numbers out of what a student handed in: a machine number, or text with a unit."""

from __future__ import annotations

import math
import re
from dataclasses import replace
from fractions import Fraction
from itertools import product

from corollary.answers.answer import Blank, Formulas, Numbers, Unclear
from corollary.answers.components import place_named
from corollary.answers.formula import as_typed, dimension_in, fitting, formula
from corollary.answers.quantity import Reading, components_in, read_quantities, read_quantity
from corollary.formula.ast import Expr, Number
from corollary.formula.errors import ParseError, sentence
from corollary.formula.numerals import decimal_text
from corollary.formula.value import Complex, Exact, Items, Measured, Nothing, Real, Refused, Text, Value
from corollary.problem.problem import Problem
from corollary.units.unit import ONE, Unit, show

PLACEHOLDERS = {"", "...", "…", "?", "None"}
FORMULA, OWN_NUMBER = re.compile(r"[*^/()·√]"), re.compile(r"^\W*[0-9]")
AMBIGUOUS = re.compile(r"[0-9]+(?:[.,][0-9]+)+")
COARSE = 4  # a machine number whose shortest form has more digits than this was calculated, not typed


def scalar(given: Value, unit: Unit, problem: Problem) -> Numbers | Formulas | Blank | Unclear:
    """One number in SI, or a formula of the givens when the text is one."""
    while isinstance(given, Items) and len(given.items) == 1:
        given = given.items[0]
    match given:
        case Nothing():
            return Blank()
        case Real(value):
            return machine((value,), unit)
        case Exact(value):
            return exact(value, unit)
        case Complex(real, imaginary):
            if abs(imaginary) <= 1e-12 * abs(real) or imaginary == 0:
                return machine((real,), unit)
            return Unclear(
                "this is a complex number; a measured quantity is real", f"{real:g} + {imaginary:g}i"
            )
        case Measured(value, of):
            return typed(f"{value!r} {of}", unit, problem)
        case Text(text):
            return typed(text, unit, problem)
        case Items(items, _):
            return Unclear(f"one number is asked for, not {len(items)}", "a list")
        case Refused(why, shown):
            return Unclear(why, shown)


def vector(
    given: Value, unit: Unit, names: int | tuple[str, ...], problem: Problem
) -> Numbers | Formulas | Blank | Unclear:
    """As many numbers as there are components (their count, or their names: then an answer may name them in another order)."""
    count, called = (names, ()) if isinstance(names, int) else (len(names), names)
    match given:
        case Nothing():
            return Blank()
        case Text(text) if text.strip() in PLACEHOLDERS:
            return Blank()
        case Text(text):
            return _in_one_text(text, unit, count, called, problem)
        case Items((Text(length), Text(angle)), _) if count == 2 and _is_angle(angle, unit):
            return vector(Text(f"{length} at {angle}"), unit, names, problem)
        case Items(items, shape):
            if all(isinstance(item, Nothing) for item in items):
                return Blank()
            items = _flat(items, unit, count)
            if isinstance(items, Unclear):
                return items
            if any(isinstance(item, Items) and len(item.items) != 1 for item in items):
                return Unclear(
                    f"a list of {count} numbers is asked for, not a table of {' by '.join(map(str, shape))}",
                    "an array",
                )
            if len(items) != count:
                return Unclear(
                    f"{count} components are asked for, not {len(items)}", f"a list of {len(items)}"
                )
            return _together([scalar(item, unit, problem) for item in _in_order(items, called)])
        case Refused(why, shown):
            return Unclear(why, shown)
        case _:
            return Unclear(f"{count} components are asked for: write them as a list", "one number")


def _in_one_text(
    text: str, unit: Unit, count: int, names: tuple[str, ...], problem: Problem
) -> Numbers | Formulas | Blank | Unclear:
    found = read_quantities(text, unit, count, names)
    if not isinstance(found, ParseError):
        return _together([_reading(each, unit) for each in found])
    pieces = components_in(text, count, names)
    each = [typed(piece, unit, problem) for piece in pieces] if isinstance(pieces, list) else []
    if each and (found.status == "asked" or not any(isinstance(one, (Unclear, Blank)) for one in each)):
        return _together(each)
    return Unclear(sentence(found), as_typed(text))


def _flat(items: tuple[Value, ...], unit: Unit, count: int) -> tuple[Value, ...] | Unclear:
    """Lists within a list, and pairs in one text, opened where that gives the components one after the other."""
    opened: list[Value] = []
    for item in items:
        match item:
            case Items(inside, _) if len(items) != count:
                opened += inside
            case Text(text) if len(items) != count and count % len(items) == 0:
                pieces = components_in(text, count // len(items))
                opened += [Text(piece) for piece in pieces] if isinstance(pieces, list) else [item]
            case _:
                opened.append(item)
    return tuple(opened) if len(opened) == count else items


def _in_order(items: tuple[Value, ...], names: tuple[str, ...]) -> tuple[Value, ...]:
    """Texts that name their components (`p_y = 4`), in the order asked for."""
    places = [
        place_named(item.text, names) if isinstance(item, Text) and "=" in item.text else None
        for item in items
    ]
    if None in places or len(set(places)) != len(items):
        return items
    return tuple(item for _, item in sorted(zip(places, items, strict=True), key=lambda pair: pair[0] or 0))


def machine(values: tuple[float, ...], unit: Unit) -> Numbers | Unclear:
    """Machine numbers, in the part's own unit."""
    for value in values:
        if math.isnan(value) or math.isinf(value):
            return Unclear(
                "the result is not a number" if math.isnan(value) else "the result is infinite", str(value)
            )
    size = float(unit.factor) * math.pi**unit.pi
    digits = [
        len(repr(value).replace(".", "").lstrip("-0").partition("e")[0].rstrip("0")) for value in values
    ]
    digits = [
        sure(count, len(f"{abs(value):.0f}")) if value and value == int(value) else count
        for count, value in zip(digits, values, strict=True)
    ]
    figures = tuple(count if count <= COARSE else 0 for count in digits)
    shown = ", ".join(f"{value:.6g}" for value in values)
    return Numbers(tuple(value * size for value in values), figures, _with_unit(shown, unit))


def exact(value: Fraction, unit: Unit) -> Numbers | Unclear:
    """An exact number in the part's own unit; one beyond all doubles is a number all the same, and wrong."""
    size = unit.factor
    try:
        number = float(value * size) * math.pi**unit.pi
    except OverflowError:
        number = math.inf if value > 0 else -math.inf
        return Numbers((number,), (0,), "a number too large to show")
    whole = str(abs(value.numerator)) if value.denominator == 1 and abs(value) < 10**9 else ""
    digits = sure(len(whole.rstrip("0")), len(whole)) if value else 0
    shown = (
        decimal_text(value, 6)
        if value.denominator > 1
        else (str(value) if abs(value) < 10**12 else f"{float(value):.6g}")
    )
    return Numbers((number,), (digits if digits <= COARSE else 0,), _with_unit(shown, unit))


def sure(least: int, most: int) -> int:
    """How many figures a number shows: 170 has two that are sure; 20, with one, was hardly rounded to tens."""
    return least if least > 1 else most


def typed(text: str, unit: Unit, problem: Problem) -> Numbers | Formulas | Blank | Unclear:
    """A text: a number with a unit; else a formula of the givens, if its dimension is what is asked for."""
    if text.strip() in PLACEHOLDERS:
        return Blank()
    found = read_quantity(text, unit)
    if isinstance(found, Reading) and found.fit != "wrong dimension":
        return _reading(found, unit)
    tree = formula(text, problem)
    if isinstance(tree, ParseError) and tree.status == "asked":
        tree = fitting(text, unit, problem) or tree
    if isinstance(tree, Unclear):
        return tree
    if not isinstance(tree, ParseError):
        dimension = dimension_in(tree, problem)
        if dimension == unit.dimension:
            return Formulas((tree,), text.strip())
        if isinstance(found, ParseError) or (FORMULA.search(text) and not OWN_NUMBER.search(text)):
            why = (
                sentence(dimension)
                if isinstance(dimension, ParseError)
                else f"this formula is not in {show(unit) or 'plain numbers'}"
            )
            return Unclear(why, as_typed(text))
    if isinstance(found, ParseError):
        if isinstance(tree, ParseError) and FORMULA.search(text) and not OWN_NUMBER.search(text):
            return Unclear(sentence(tree), as_typed(text))
        return Unclear(sentence(found), as_typed(text), meanings(found, text, unit))
    return _reading(found, unit)


def meanings(trouble: ParseError, text: str, unit: Unit) -> tuple[Numbers, ...]:
    """What an ambiguous text could mean: each choice put in the place of the number it is about."""
    number = (
        AMBIGUOUS.search(text) if trouble.status == "asked" else None
    )  # only a text short enough to be read is asked about
    if number is None:
        return ()
    read = (
        read_quantity(text[: number.start()] + choice + text[number.end() :], unit)
        for choice in trouble.choices
    )
    return tuple(
        _reading(each, unit) for each in read if isinstance(each, Reading) and each.fit != "wrong dimension"
    )


def _is_angle(text: str, unit: Unit) -> bool:
    """Whether a text is an angle where something else is asked for: then it is a direction."""
    found = read_quantity(text, None)
    return (
        unit.dimension != ONE
        and isinstance(found, Reading)
        and found.unit is not None
        and found.unit.text in ("deg", "rad")
    )


def _reading(found: Reading, unit: Unit) -> Numbers:
    ratio, pi = found.si
    unitless = found.fit == "unit missing"
    if unitless:
        ratio, pi = ratio * unit.factor, pi + unit.pi
    try:
        value = float(ratio) * math.pi**pi
    except OverflowError:
        value = math.inf if ratio > 0 else -math.inf
    size = (float(found.unit.factor) * math.pi**found.unit.pi,) if found.unit is not None else ()
    why = found.why if found.fit == "wrong dimension" else ""
    polar = (_reading(found.polar[0], unit), _reading(found.polar[1], unit)) if found.polar else None
    return Numbers(
        (value,), (sure(found.least, found.figures),), found.shown, unitless, why, sizes=size, polar=polar
    )


def _together(found: list[Numbers | Formulas | Blank | Unclear]) -> Numbers | Formulas | Blank | Unclear:
    for each in found:
        if isinstance(each, Unclear):
            return replace(each, readings=_combined(found))
    if any(isinstance(each, Blank) for each in found):
        return Unclear("a component is missing", ", ".join(each.shown or "—" for each in found))
    shown = f"({', '.join(each.shown for each in found)})"
    numbers = [each for each in found if isinstance(each, Numbers)]
    if len(numbers) == len(found):
        values, figures = (
            tuple(each.values[0] for each in numbers),
            tuple(each.figures[0] for each in numbers),
        )
        unitless = any(each.unitless and each.values[0] != 0 for each in numbers)
        sizes = tuple(size for each in numbers for size in each.sizes)
        misfit = next((each.misfit for each in numbers if each.misfit), "")
        sizes = sizes if len(sizes) == len(values) else ()
        return Numbers(values, figures, shown, unitless, misfit, sizes=sizes, polar=numbers[0].polar)
    trees = [_tree(each) for each in found]
    return Formulas(tuple(trees), shown)


def _combined(found: list[Numbers | Formulas | Blank | Unclear]) -> tuple[Numbers, ...]:
    """Every combination of what the components could mean; none when a component has no meaning at all, or there are too many."""
    choices = [
        each.readings if isinstance(each, Unclear) else (each,) if isinstance(each, Numbers) else ()
        for each in found
    ]
    if math.prod(map(len, choices)) > 16:
        return ()
    together = (_together(list(each)) for each in product(*choices))
    return tuple(each for each in together if isinstance(each, Numbers))


def _tree(each: Numbers | Formulas | Blank | Unclear) -> Expr:
    match each:
        case Formulas(trees, _):
            return trees[0]
        case Numbers(values, _, _):
            return Number(Fraction(values[0]))
        case _:
            raise AssertionError("blank and unclear components were turned away before")


def _with_unit(shown: str, unit: Unit) -> str:
    name = show(unit)
    return f"{shown} {name}" if name not in {"", "1"} else shown
