"""Numbers out of what a student handed in: one, or one for each component, each a machine number or a text with a unit."""

from __future__ import annotations

import math
import re
from dataclasses import replace
from fractions import Fraction
from itertools import product

from corollary.answers.answer import Blank, Formulas, Numbers, Unclear
from corollary.answers.components import place_named
from corollary.answers.formula import as_typed, dimension_in, fitting, formula, formulas, other_dimension
from corollary.answers.machine_number import exact, machine, sure
from corollary.answers.quantity import Reading, components_in, read_quantities, read_quantity
from corollary.answers.question import Question
from corollary.formula.ast import Expr, Number
from corollary.formula.errors import ParseError, sentence
from corollary.formula.value import Complex, Exact, Items, Measured, Nothing, Real, Refused, Text, Value
from corollary.messages import catalogue
from corollary.units.unit import ONE, Unit

_ = catalogue(__name__)

# What stands for no answer: the blank itself, and what people leave where they mean to come back.
PLACEHOLDERS = {"", "...", "…", "?", "None"}
# A text with an operator that does not begin with digits was meant as a formula; then the formula's trouble is told.
FORMULA, OWN_NUMBER = re.compile(r"[*^/()·√]"), re.compile(r"^\W*[0-9]")
AMBIGUOUS = re.compile(r"[0-9]+(?:[.,][0-9]+)+")


def scalar(value: Value, question: Question) -> Numbers | Formulas | Blank | Unclear:
    """One number in SI, or a formula of the givens when the text is one."""
    unit = question.unit
    while isinstance(value, Items) and len(value.items) == 1:
        value = value.items[0]
    match value:
        case Nothing():
            return Blank()
        case Real(number):
            return machine(number, unit)
        case Exact(number):
            return exact(number, unit)
        case Complex(real, imaginary):
            if abs(imaginary) <= 1e-12 * abs(real) or imaginary == 0:
                return machine(real, unit)
            return Unclear(
                _("this is a complex number; a measured quantity is real"), f"{real:g} + {imaginary:g}i"
            )
        case Measured(number, of):
            return typed(f"{number!r} {of}", question)
        case Text(text):
            return typed(text, question)
        case Items(items, _shape):
            return Unclear(_("one number is asked for, not {count}", count=len(items)), _("a list"))
        case Refused():
            return turned_away(value)


def turned_away(value: Refused) -> Unclear:
    """A value from which no answer can be read; what is wrong with it is a predicate, `is a set`."""
    return Unclear(_("it {predicate}", predicate=value.why), value.excerpt)


def vector(value: Value, question: Question) -> Numbers | Formulas | Blank | Unclear:
    """As many numbers as there are components; texts may name theirs, and then stand in another order."""
    count, names = len(question.components), ", ".join(question.components)
    match value:
        case Nothing():
            return Blank()
        case Text(text) if text.strip() in PLACEHOLDERS:
            return Blank()
        case Text(text):
            return _in_one_text(text, question)
        case Items((Text(length), Text(angle)), _shape) if count == 2 and _is_angle(angle, question.unit):
            return vector(Text(f"{length} at {angle}"), question)
        case Items(items, shape):
            if all(isinstance(item, Nothing) for item in items):
                return Blank()
            items = _flat(items, count)
            if any(isinstance(item, Items) and len(item.items) != 1 for item in items):
                return Unclear(
                    _(
                        "a list of {count} numbers is asked for, [{names}], not a table of {sides}",
                        count=count,
                        names=names,
                        sides=_(" by ").join(map(str, shape)),
                    ),
                    _("an array"),
                )
            if len(items) != count:
                return Unclear(
                    _(
                        "{count} components are asked for, [{names}], not {given}",
                        count=count,
                        names=names,
                        given=len(items),
                    ),
                    _("a list of {count}", count=len(items)),
                )
            return _together([scalar(item, question) for item in _in_order(items, question.components)])
        case Refused():
            return turned_away(value)
        case _:
            return Unclear(
                _(
                    "{count} components are asked for: write them as a list, [{names}]",
                    count=count,
                    names=names,
                ),
                _("one number"),
            )


def _in_one_text(text: str, question: Question) -> Numbers | Formulas | Blank | Unclear:
    count = len(question.components)
    found = read_quantities(text, question.unit, count, question.components)
    if not isinstance(found, ParseError):
        return _together([_reading(each, question.unit) for each in found])
    pieces = components_in(text, count, question.components)
    each = [typed(piece, question) for piece in pieces] if isinstance(pieces, list) else []
    if each and (found.status == "asked" or not any(isinstance(one, (Unclear, Blank)) for one in each)):
        return _together(each)
    return Unclear(sentence(found), as_typed(text))


def _flat(items: tuple[Value, ...], count: int) -> tuple[Value, ...]:
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


def typed(text: str, question: Question) -> Numbers | Formulas | Blank | Unclear:
    """A text: a number with a unit; else a formula of the givens, if its dimension is what is asked for."""
    if text.strip() in PLACEHOLDERS:
        return Blank()
    unit = question.unit
    found = read_quantity(text, unit)
    if isinstance(found, Reading) and found.fit != "wrong dimension":
        return _reading(found, unit)
    tree = formula(text, question)
    if isinstance(tree, ParseError) and tree.status == "asked":
        tree = fitting(text, question) or tree
    if isinstance(tree, Unclear):
        return tree
    looks_like_one = FORMULA.search(text) and not OWN_NUMBER.search(text)
    if not isinstance(tree, ParseError):
        dimension = dimension_in(tree, question)
        if dimension == unit.dimension:
            return formulas(tree)
        if isinstance(found, ParseError) or looks_like_one:
            why = (
                sentence(dimension)
                if isinstance(dimension, ParseError)
                else other_dimension(tree, dimension, unit)
            )
            return Unclear(why, as_typed(text))
    if isinstance(found, ParseError):
        if isinstance(tree, ParseError) and looks_like_one:
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
    try:
        value = float(ratio) * math.pi**pi
    except OverflowError:
        value = math.inf if ratio > 0 else -math.inf
    size = (found.unit.si,) if found.unit is not None else ()
    missing = found.why if found.fit == "unit missing" else ""
    misfit = found.why if found.fit == "wrong dimension" else ""
    polar = (_reading(found.polar[0], unit), _reading(found.polar[1], unit)) if found.polar else None
    figures = (sure(found.least, found.figures),)
    return Numbers((value,), figures, found.as_read, missing, misfit, sizes=size, polar=polar)


def _together(found: list[Numbers | Formulas | Blank | Unclear]) -> Numbers | Formulas | Blank | Unclear:
    for each in found:
        if isinstance(each, Unclear):
            return replace(each, readings=_combined(found))
    if any(isinstance(each, Blank) for each in found):
        return Unclear(_("a component is missing"), ", ".join(each.as_read or "—" for each in found))
    as_read = f"({', '.join(each.as_read for each in found)})"
    numbers = [each for each in found if isinstance(each, Numbers)]
    if len(numbers) == len(found):
        values, figures = (
            tuple(each.values[0] for each in numbers),
            tuple(each.figures[0] for each in numbers),
        )
        missing = next((each.missing for each in numbers if each.missing and each.values[0] != 0), "")
        sizes = tuple(size for each in numbers for size in each.sizes)
        misfit = next((each.misfit for each in numbers if each.misfit), "")
        sizes = sizes if len(sizes) == len(values) else ()
        return Numbers(values, figures, as_read, missing, misfit, sizes=sizes, polar=numbers[0].polar)
    trees = [_tree(each) for each in found]
    return Formulas(tuple(trees), as_read)


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
        case Formulas(trees):
            return trees[0]
        case Numbers(values):
            return Number(Fraction(values[0]))
        case _:
            raise AssertionError("blank and unclear components were turned away before")
