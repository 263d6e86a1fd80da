"""As many numbers as a vector has components: a list, a dictionary, or one text; with a sign in words where one is."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction
from typing import cast

from corollary.answers.answer import Answer, Blank, Formulas, Letter, Numbers, Unclear
from corollary.answers.components import are_axes, labelled, place_named
from corollary.answers.direction import DIRECTED, LONGEST, axis_named, beside_axis, with_direction
from corollary.answers.formula import as_typed
from corollary.answers.left_side import gives, solvable, unknown_letter
from corollary.answers.numbers import PLACEHOLDERS, from_reading, scalar, turned_away, with_share
from corollary.answers.quantity import Reading, read_quantity
from corollary.answers.question import Question
from corollary.answers.sentence import by_names, sentence_in
from corollary.answers.vector_quantity import components_in, read_quantities
from corollary.formula.ast import Expr, Number
from corollary.formula.errors import ParseError, sentence
from corollary.formula.numerals import decimal_text
from corollary.formula.value import Exact, Items, Named, Nothing, Refused, Text, Value
from corollary.messages import catalogue, in_convention
from corollary.units.unit import ONE, Unit, show

_ = catalogue(__name__)

Read = Numbers | Formulas | Blank | Unclear
DECIMAL_COMMA = re.compile(r"[-+−–]?\s?\d+,\d+\s?[^\d\s,;][^\d,;]*")


def vector(value: Value, question: Question) -> Read:
    """As many numbers as there are components; texts and dictionaries may name theirs, and then stand in another order."""
    count, names = len(question.components), ", ".join(question.components)
    match value:
        case Nothing():
            return Blank()
        case Text(text) if text.strip() in PLACEHOLDERS:
            return Blank()
        case Text(text):
            return _in_one_text(text, question)
        case Named(keys, items):
            return _by_name(keys, items, question)
        case Items((Text(length), Text(angle))) if (
            are_axes(question.components) and count == 2 and _is_angle(angle, question.unit)
        ):
            return vector(Text(f"{length} at {angle}"), question)
        case Items(items, shape):
            return _of_list(items, shape, question)
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


def _of_list(items: tuple[Value, ...], shape: tuple[int, ...], question: Question) -> Read:
    count, names = len(question.components), ", ".join(question.components)
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
    return _each(_in_order(items, question.components), question)


def _by_name(keys: tuple[str, ...], items: tuple[Value, ...], question: Question) -> Read:
    places = [place_named(f"{key} = ", question.components) for key in keys]
    if set(places) != set(range(len(question.components))) or len(places) != len(question.components):
        names = ", ".join(question.components)
        return Unclear(
            _("the names are {names}, not {given}", names=names, given=", ".join(keys)), _("a dictionary")
        )
    return _each(tuple(items[places.index(place)] for place in range(len(items))), question)


def _each(items: Sequence[Value], question: Question) -> Read:
    """One value for each component, in their order; a text may give its sign in words."""

    def bare(value: Value) -> Answer:
        return scalar(value, question)

    pairs = zip(items, question.components, strict=True)
    return _together([cast("Read", with_direction(item, question, bare, name)) for item, name in pairs])


def _in_one_text(text: str, question: Question) -> Read:
    count = len(question.components)
    if (
        len(text) <= LONGEST
        and DECIMAL_COMMA.fullmatch(text.strip())
        and (one := _along_one_axis(text, question)) is not None
    ):
        return one  # `1,6 Ns upwards`
    if (multiple := _multiple(text, question)) is not None:
        return multiple
    found = read_quantities(text, question.unit, count, question.components, question)
    if not isinstance(found, ParseError):
        return _together([with_share(from_reading(each, question.unit), question.unit) for each in found])
    if chosen := _chosen(found, question):
        return Unclear(sentence(found), as_typed(text), chosen)
    pieces = components_in(text, count, question.components, question=question)
    if isinstance(pieces, list):
        each = _each([Text(piece) for piece in _by_direction(pieces, question.components)], question)
        if isinstance(each, (Numbers, Formulas)) or (isinstance(each, Unclear) and each.readings):
            return each
    elif (one := _along_one_axis(text, question)) is not None:
        return one
    if (
        not are_axes(question.components)
        and (ordered := _components_in_a_sentence(text, question)) is not None
    ):
        answer = _each([Text(each) for each in ordered], question)
        if isinstance(answer, Numbers):
            return answer
    return Unclear(sentence(found), as_typed(text))


def _components_in_a_sentence(text: str, question: Question) -> tuple[str, ...] | None:
    """The components of `the near one is at 0.76 m and the far one at 1.24 m`; None where a word may be the sign of one."""
    several = sentence_in(text, len(question.components), question)
    if several is None or (several.turned and question.unit.dimension in DIRECTED):
        return None
    return by_names(several, question.components)


def _chosen(doubt: ParseError, question: Question) -> tuple[Numbers, ...]:
    """What a text that is asked about could mean as a whole."""
    if doubt.status != "asked":
        return ()
    read = (
        read_quantities(choice, question.unit, len(question.components), question.components)
        for choice in doubt.choices
    )
    found = (
        _together([from_reading(each, question.unit) for each in one])
        for one in read
        if isinstance(one, tuple)
    )
    return tuple(each for each in found if isinstance(each, Numbers))


def _multiple(text: str, question: Question) -> Unclear | None:
    """`2p = (15, -20)`, `-p = …`, solved for its letter and asked about."""
    side, equals, right = text.partition("=")
    if not equals or "=" in right or len(text) > LONGEST:
        return None
    found = solvable(side, question)
    if found is None or found.function or found.factor == 1 or not unknown_letter(found.name, question):
        return None
    inside = _in_one_text(right.strip(), question)
    if not isinstance(inside, Numbers):
        return None
    values = tuple(float(found.factor) * value for value in inside.values)
    numbers = ", ".join(decimal_text(Fraction(f"{value / question.unit.si:.6g}"), 0) for value in values)
    choice = in_convention(f"({numbers}) {show(question.unit)}".strip())
    why = gives(side, inside.as_read, found, choice)
    return Unclear(why, as_typed(text), (replace(inside, values=values, polar=None),), benefit=True)


def _by_direction(pieces: list[str], components: tuple[str, ...]) -> list[str]:
    """`4 m/s down, 3 m/s to the right`, where every piece points along an axis of its own, in the order asked for."""
    axes = [axis_named(piece) for piece in pieces]
    if sorted(axes) != sorted(components):
        return pieces
    return [pieces[axes.index(name)] for name in components]


def _along_one_axis(text: str, question: Question) -> Read | None:
    """`160 N upwards`, where the components are axes: the other components are 0."""
    axis = axis_named(text) if are_axes(question.components) else ""
    if not axis and are_axes(question.components):
        text, axis = beside_axis(text)
    if axis not in question.components:
        return None
    items = [Text(text) if name == axis else Exact(Fraction(0)) for name in question.components]
    return _each(items, question)


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
    items = tuple(Text(labelled(item.text, names)) if isinstance(item, Text) else item for item in items)
    places = [
        place_named(item.text, names) if isinstance(item, Text) and "=" in item.text else None
        for item in items
    ]
    if None in places or len(set(places)) != len(items):
        return items
    return tuple(item for _, item in sorted(zip(places, items, strict=True), key=lambda pair: pair[0] or 0))


def _is_angle(text: str, unit: Unit) -> bool:
    """Whether a text is an angle where something else is asked for: then it is a direction."""
    found = read_quantity(text, None)
    return (
        unit.dimension != ONE
        and isinstance(found, Reading)
        and found.unit is not None
        and found.unit.text in ("deg", "rad")
    )


def _together(found: list[Read]) -> Read:
    for each in found:
        if isinstance(each, Unclear):
            return replace(each, readings=_combined(found), benefit=all(map(_is_sure, found)))
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
        zeros = tuple(zero for each in numbers for zero in each.zeros)
        sizes, zeros = (sizes, zeros) if len(sizes) == len(values) else ((), ())
        most = tuple(figure for each in numbers for figure in each.most or each.figures)
        return Numbers(
            values,
            figures,
            as_read,
            missing,
            misfit,
            tuple(place for place, each in enumerate(numbers) if each.in_words),
            most if most != figures else (),
            sizes,
            numbers[0].polar,
            zeros=zeros,
        )
    trees = [_tree(each) for each in found]
    return Formulas(tuple(trees), as_read)


def _combined(found: list[Read]) -> tuple[Numbers, ...]:
    """What the components could mean, every comma taken the same way; none when a component has no meaning at all."""
    choices = [
        tuple(one for one in each.readings if not isinstance(one, Letter))
        if isinstance(each, Unclear)
        else (each,)
        if isinstance(each, Numbers)
        else ()
        for each in found
    ]
    several = {len(each) for each in choices} - {1}
    if len(several) != 1 or not all(choices):
        return ()
    count = several.pop()
    together = (_together([each[place % len(each)] for each in choices]) for place in range(count))
    return tuple(each for each in together if isinstance(each, Numbers))


def _is_sure(each: Read) -> bool:
    return not isinstance(each, Unclear) or each.benefit


def _tree(each: Read) -> Expr:
    match each:
        case Formulas(trees):
            return trees[0]
        case Numbers(values):
            return Number(Fraction(values[0]))
        case _:
            raise AssertionError("blank and unclear components were turned away before")
