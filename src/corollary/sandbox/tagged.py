"""Tagged data, as `worker/encode.py` gives it, made into plain values, and reasons why no answer can be read from one."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from math import prod
from typing import Any

from corollary.formula.value import (
    Complex,
    Exact,
    Items,
    Measured,
    Named,
    Nothing,
    Real,
    Refused,
    Text,
    Value,
)
from corollary.messages import N_, catalogue
from corollary.sandbox.worker.encode import DEEPEST, MOST_ITEMS

_ = catalogue(__name__)

# Predicates, as `is a set`; `{what}` is the worker's, a number or the name of a class.
PREDICATES = {
    "bool": N_("is True or False, not a number"),
    "dict": N_("is a dictionary whose keys are not names: give the number itself"),
    "set": N_("is a set, which has no order: give a list"),
    "generator": N_("is a generator: turn it into a list first"),
    "range": N_("is a range: turn it into a list first"),
    "map": N_("is a map: turn it into a list first"),
    "zip": N_("is a zip: turn it into a list first"),
    "function": N_("is a function: call it, and give what it returns"),
    "class": N_("is a class, not a value"),
    "module": N_("is a module, not a value"),
    "bytes": N_("is bytes: give a number or text"),
    "figure": N_("is a figure: the plot itself is looked at, no variable is needed"),
    "object": N_("is an object of the kind {what}, from which no answer can be read"),
    "raised": N_("could not be read: looking at it raised {what}"),
    "items": N_("has more than {most} items"),
    "depth": N_("is nested deeper than {deepest} lists"),
    "fraction": N_("is a fraction whose parts are not whole numbers"),
    "digits": N_("is a whole number of about {what} digits"),
    "letters": N_("is a text of {what} letters"),
    "numbers": N_("is an array of {what} numbers, more than {most}"),
    "no numbers": N_("is an array of {what}, not of numbers"),
    "sympy": N_("is a {what} of sympy, not an expression"),
    "size": N_("is too large to be read"),
    # What no honest worker sends.
    "nesting": N_("is nested too deeply"),
    "denominator": N_("is a fraction with denominator zero"),
    "shape": N_("is an array whose shape does not fit its numbers"),
    "names": N_("is a dictionary whose names do not fit its values"),
    "unknown": N_("could not be read"),
}


def refused(word: str, what: str = "", excerpt: str = "") -> Refused:
    """The value refused in a sentence; a word that nobody agreed on says no more than that it could not be read."""
    predicate = PREDICATES.get(word, PREDICATES["unknown"])
    return Refused(_(predicate, what=what, most=MOST_ITEMS, deepest=DEEPEST), excerpt)


DEEPEST_TAGGED = 20  # an honest worker refuses what is nested deeper than 12 lists


def value_of(tagged: Sequence[Any], depth: int = DEEPEST_TAGGED) -> Value:
    """The value itself; what contradicts itself (a zero denominator, a shape of other length) is refused."""
    if depth < 0:
        return refused("nesting")
    match tagged:
        case ["nothing"]:
            return Nothing()
        case ["real", value]:
            return Real(value)
        case ["exact", numerator, denominator]:
            below = int(denominator, 16)
            return Exact(Fraction(int(numerator, 16), below)) if below else refused("denominator")
        case ["complex", real, imaginary]:
            return Complex(real, imaginary)
        case ["text", text]:
            return Text(text)
        case ["measured", value, unit]:
            return Measured(value, unit)
        case ["items", items, shape]:
            if prod(shape) != len(items):
                return refused("shape")
            return Items(tuple(value_of(each, depth - 1) for each in items), tuple(shape))
        case ["named", names, items]:
            if len(names) != len(items):
                return refused("names")
            return Named(tuple(names), tuple(value_of(each, depth - 1) for each in items))
        case ["refused", word, what, excerpt]:
            return refused(word, what, excerpt)
        case _:
            return refused("unknown")
