"""How a formula is read, told to the student before it is marked: as which products, of which letters, with which units."""

from __future__ import annotations

from corollary.formula.errors import ParseError, sentence
from corollary.formula.syntax import parse
from corollary.formula.text import text
from corollary.notebook.as_read import Asked, Heard, heard, heard_numbers, in_own_axes
from corollary.units.dimensions import dimension_of
from corollary.units.unit import called


def heard_either(asked: Asked, sent: tuple) -> Heard:
    """What an encoded answer is read as: a formula where that is asked for, else a number, or the formula for it."""
    if asked.shape == "formula":
        return heard_formula(asked, sent)
    if not asked.letters or sent[0] not in ("text", "items"):
        return heard(asked, sent)
    number = in_own_axes(asked, sent, heard_numbers)
    formula = number if number.ok else in_own_axes(asked, sent, heard_formula)
    return formula if formula.ok else number


def heard_formula(asked: Asked, sent: tuple) -> Heard:
    """What an encoded formula, or a list of them, is read as."""
    if not asked.components:
        return _formula(asked, sent)
    count = len(asked.components)
    if sent[0] != "items" or len(sent[1]) != count:
        return Heard(False, f"a list of {count} formulas is expected, [{', '.join(asked.components)}]")
    if all(item[0] == "nothing" for item in sent[1]):
        return Heard(False, "no answer yet")
    shown = []
    for component, item in zip(asked.components, sent[1], strict=True):
        one = _formula(asked, item)
        if not one.ok:
            return Heard(False, f"{component}: {one.text}")
        shown.append(one.text.removeprefix("read as "))
    return Heard(True, f"read as [{', '.join(shown)}]")


def _formula(asked: Asked, sent: tuple) -> Heard:
    match sent:
        case ("nothing",) | ("text", ""):
            return Heard(False, "no answer yet")
        case ("text", written):
            return _read(asked, written)
        case ("real", _) | ("exact", _, _):
            return Heard(False, 'is a number; write the formula itself as text, in quotes: "2*a/(b + c)"')
        case ("refused", why, *_):
            return Heard(False, f"cannot be read: it {why}")
        case _:
            return Heard(False, 'is not a formula; write it as text, in quotes: "2*a/(b + c)"')


def _read(asked: Asked, written: str) -> Heard:
    tree = parse(written, [letter for letter, _ in asked.letters])
    if isinstance(tree, ParseError):
        return Heard(False, f"cannot be read: {sentence(tree)}")
    shown = f"read as {text(tree)}"
    found = dimension_of(tree, {letter: unit.dimension for letter, unit in asked.letters})
    if isinstance(found, ParseError):
        return Heard(False, f"{shown}, but {found.why}")
    if asked.unit is not None and found != asked.unit.dimension:
        return Heard(False, f"{shown}, which is {called(found)}; {called(asked.unit.dimension)} is expected")
    return Heard(True, shown)
