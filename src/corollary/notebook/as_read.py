"""How an answer is read, told to the student before it is marked: whether it can be read, never whether it is right."""

from __future__ import annotations

import inspect
import math
import re
from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from types import FunctionType
from typing import Literal

from corollary.answers.direction import axes_of, direction_of
from corollary.answers.quantity import Reading, describe, read_quantities, read_quantity
from corollary.formula.errors import ParseError, sentence
from corollary.formula.numerals import decimal_text
from corollary.units.unit import Unit

FUNCTIONS = "sqrt|sin|cos|tan|exp|ln|abs|pi"
Shape = Literal["number", "formula", "letter", "function", "figure", "lines"]


@dataclass(frozen=True, slots=True)
class Asked:
    """What kind of thing answers a question.

    `unit` is None where any unit will do; `components` name the members of a list, in order; `words` are the letters of a
    choice, or the names of a function's arguments; `letters` what a formula may be written in, each with its unit (none
    where a formula will not do);
    `directed` tells that an answer may name its own axes.
    """

    shape: Shape
    unit: Unit | None
    components: tuple[str, ...] = ()
    words: tuple[str, ...] = ()
    letters: tuple[tuple[str, Unit], ...] = ()
    directed: bool = False


@dataclass(frozen=True, slots=True)
class Heard:
    """What is said back; `ok` when it can be marked as it stands."""

    ok: bool
    text: str


def heard(asked: Asked, sent: tuple) -> Heard:
    """What an encoded answer is read as; `sent` is a tagged tuple such as ("real", 8.6) or ("items", [...], [2])."""
    if sent[0] == "nothing":
        return Heard(False, "no answer yet")
    if sent[0] == "refused":
        return Heard(False, f"cannot be read: it {sent[1]}")
    match asked.shape:
        case "number":
            number = in_own_axes(asked, sent, heard_numbers)
            unread = "cannot be read" in number.text and _like_formula(asked, sent)
            return (
                Heard(True, "no number with a unit; will be looked at as a formula when it is marked")
                if unread
                else number
            )
        case "letter":
            return _letter(asked, sent)
        case "lines":
            return _lines(sent)
        case "formula" | "function" | "figure":
            return Heard(True, "will be looked at when it is marked")


def heard_function(asked: Asked, function: object) -> Heard:
    """Whether a function can be called as the question says; it is not called here."""
    wanted = f"({', '.join(asked.words)})"
    if function is None:
        return Heard(False, "no function yet; write the function above and run its cell")
    if not isinstance(function, FunctionType):
        return Heard(
            False,
            f"is of the type {type(function).__name__}, not a function; keep the line that begins with def",
        )
    taken = tuple(inspect.signature(function).parameters)
    if taken != asked.words:
        return Heard(False, f"takes ({', '.join(taken)}), but it will be called with {wanted}")
    if _empty(function):
        return Heard(False, f"{function.__name__}{wanted} is still empty")
    return Heard(True, f"{function.__name__}{wanted} is there")


def _empty(function: FunctionType) -> bool:
    """Whether the body is still the dots it was handed out with: then it compiles to what dots compile to."""
    words = "    'words'\n" if function.__doc__ else ""
    space: dict[str, FunctionType] = {}
    exec(f"def stub({', '.join(inspect.signature(function).parameters)}):\n{words}    ...", space)
    stub, code, first = space["stub"].__code__, function.__code__, int(bool(words))
    return (code.co_code, code.co_names, code.co_consts[first:]) == (
        stub.co_code,
        stub.co_names,
        stub.co_consts[first:],
    )


def in_own_axes(asked: Asked, sent: tuple, read: Callable[[Asked, tuple], Heard]) -> Heard:
    """An answer that may say, in its text, which way its axes or it itself point; `read` reads what is beside that."""
    if sent[0] != "text":
        return read(asked, sent)
    axes = axes_of(sent[1], asked.components) if asked.directed else None
    if axes is None or not axes.words:
        return _with_direction(asked, sent[1], read)
    found = _with_direction(asked, axes.text, read)
    return (
        Heard(True, f"{found.text} with {'your ' if axes.words[0].lower() in 'xyz' else ''}{axes.words}")
        if found.ok
        else found
    )


def _with_direction(asked: Asked, text: str, read: Callable[[Asked, tuple], Heard]) -> Heard:
    way = None if asked.components else direction_of(text, asked.directed)
    found = read(asked, ("text", way.text if way else text))
    if way is None or not found.ok:
        return found
    if way.sign is None:
        unclear = (
            f"; it is not clear which sign \u201c{way.words}\u201d gives: write the number with its sign"
        )
        return Heard(False, found.text + unclear)
    return Heard(True, f"{found.text}, {way.words}")


def _like_formula(asked: Asked, sent: tuple) -> bool:
    """Whether every text is made of the problem's letters, numbers and functions: a rough look, for it promises nothing."""
    texts = [item[1] for item in (sent[1] if sent[0] == "items" else [sent]) if item[0] == "text"]
    letters = "|".join(sorted((re.escape(letter) for letter, _ in asked.letters), key=len, reverse=True))
    return bool(texts and letters) and all(
        re.search(letters, text) and not re.sub(rf"{FUNCTIONS}|{letters}|[0-9.,\s+*/^()-]", "", text)
        for text in (axes_of(text, asked.components).text for text in texts)
    )


def heard_numbers(asked: Asked, sent: tuple) -> Heard:
    """A number, or one for each component."""
    if asked.components:
        return _components(asked, sent)
    reading = _reading(asked.unit, sent)
    return reading if isinstance(reading, Heard) else _said((reading,))


def _components(asked: Asked, sent: tuple) -> Heard:
    names, count = f"[{', '.join(asked.components)}]", len(asked.components)
    if sent[0] == "text":
        found = read_quantities(sent[1], asked.unit, count, asked.components)
        return (
            Heard(False, f"cannot be read: {sentence(found)}")
            if isinstance(found, ParseError)
            else _said(found)
        )
    if sent[0] != "items" or len(sent[1]) != count:
        have = f"a list of {len(sent[1])}" if sent[0] == "items" else "one number"
        return Heard(False, f"is {have}; a list of {count} is expected, {names}")
    if all(item[0] == "nothing" for item in sent[1]):
        return Heard(False, "no answer yet")
    readings = []
    for component, item in zip(asked.components, sent[1], strict=True):
        reading = _reading(asked.unit, item)
        if isinstance(reading, Heard):
            return Heard(False, f"{component} {reading.text}")
        readings.append(reading)
    return _said(tuple(readings))


def _reading(unit: Unit | None, sent: tuple) -> Reading | Heard:
    """One number as the marker reads it: a bare Python number stands in the unit asked for."""
    match sent:
        case ("items", [one], _):
            return _reading(unit, one)
        case ("items", items, _):
            return Heard(False, f"is a list of {len(items)}; one number is expected")
        case ("nothing",):
            return Heard(False, "has no answer yet")
        case ("refused", why, *_):
            return Heard(False, f"cannot be read: it {why}")
        case ("real", float(value)) if not math.isfinite(value):
            return Heard(False, f"is {value}, which is not a number")
        case ("real", float(value)):
            text = decimal_text(value, 0)
        case ("exact", above, below):
            text = decimal_text(Fraction(int(above, 16), int(below, 16)), 0)
        case ("complex", *_):
            return Heard(False, "is a complex number; a real one is expected")
        case ("measured", value, its_unit):
            return _read(f"{value!r} {its_unit}", unit)
        case ("text", text):
            return _read(text, unit)
        case _:
            return Heard(False, "cannot be read")
    return _read(f"{text} {unit.text}" if unit is not None and unit.text != "1" else text, unit)


def _read(text: str, unit: Unit | None) -> Reading | Heard:
    found = read_quantity(text, unit)
    return Heard(False, f"cannot be read: {sentence(found)}") if isinstance(found, ParseError) else found


def _said(readings: tuple[Reading, ...]) -> Heard:
    """The readings on one line, with the figures they were written with when all agree."""
    for reading in readings:
        if reading.fit != "fits":
            return Heard(False, describe(reading))
    shown = ", ".join(reading.shown for reading in readings)
    figures = {reading.figures for reading in readings}
    count = figures.pop() if len(figures) == 1 else 0
    note = f" ({count} figure{'s' if count > 1 else ''})" if count else ""
    return Heard(True, f"read as ({shown}){note}" if len(readings) > 1 else f"read as {shown}{note}")


def _letter(asked: Asked, sent: tuple) -> Heard:
    known = ", ".join(asked.words)
    if sent[0] == "text" and (letter := sent[1].strip(" .()").lower()) in asked.words:
        return Heard(True, f"read as ({letter})")
    return Heard(False, f"is not one of the letters {known}")


def _lines(sent: tuple) -> Heard:
    texts = [sent] if sent[0] == "text" else sent[1] if sent[0] == "items" else []
    if not texts or any(item[0] not in ("text", "nothing") for item in texts):
        return Heard(False, "is not a list of texts; write one equation a line, each in quotes")
    count = sum(len(item[1].strip().splitlines()) for item in texts if item[0] == "text")
    return Heard(count > 0, f"read as {count} line{'s' if count != 1 else ''}" if count else "no answer yet")
