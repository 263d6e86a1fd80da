"""Values go out by their exact type, and what comes in is checked again."""

from __future__ import annotations

import ast
import math
from decimal import Decimal
from fractions import Fraction
from pathlib import Path

import msgspec
import numpy as np
import pint
import pytest
from hypothesis import given, settings
from hypothesis import strategies as some

from corollary.formula.value import Complex, Exact, Items, Nothing, Real, Refused, Text, Value
from corollary.messages import language
from corollary.sandbox import worker
from corollary.sandbox.protocol import Encoded, to_value
from corollary.sandbox.tagged import PREDICATES
from corollary.sandbox.worker.encode import MOST_ITEMS, encode
from corollary.units.dimension import Unit
from corollary.units.unit import read_unit

PINT = pint.UnitRegistry()


def decoded(encoded: object) -> Value:
    """Over the wire and back, as from a worker."""
    frame = msgspec.msgpack.encode(encoded)
    try:
        return to_value(msgspec.msgpack.decode(frame, type=Encoded))
    except msgspec.ValidationError:
        return Refused("not of the closed shapes")


def sent(value: object) -> Value:
    return decoded(encode(value))


@given(some.floats())
def test_every_float_is_sent_to_the_last_bit(value: float) -> None:
    back = sent(value)
    assert isinstance(back, Real)
    assert back.value == value or (math.isnan(back.value) and math.isnan(value))


@given(
    some.fractions()
    | some.integers()
    | some.decimals(allow_nan=False, allow_infinity=False, min_value=-(10**9), max_value=10**9)
)
def test_exact_numbers_stay_exact(value: Fraction | int | Decimal) -> None:
    assert sent(value) == Exact(Fraction(value))


@given(some.text())
def test_text_is_sent_and_can_be_written_down(text: str) -> None:
    back = sent(text)
    assert isinstance(back, Text)
    assert back.text.encode("utf-8").decode() == text.encode("utf-8", "replace").decode()


@given(
    some.recursive(
        some.none()
        | some.floats(allow_nan=False)
        | some.integers()
        | some.text(max_size=5)
        | some.complex_numbers(allow_nan=False),
        lambda inner: some.lists(inner, max_size=4) | some.tuples(inner, inner),
        max_leaves=20,
    )
)
@settings(max_examples=60)
def test_lists_keep_their_order_and_survive_the_wire(value: object) -> None:
    encoded = encode(value)
    assert decoded(encoded) == to_value(msgspec.convert(encoded, Encoded))
    assert not isinstance(decoded(encoded), Refused)


@pytest.mark.parametrize(
    ("value", "words"),
    [
        (True, "True or False"),
        ({}, "dictionary"),
        ({1}, "set"),
        (range(3), "range"),
        (len, "function"),
        (int, "class"),
        (math, "module"),
        (b"x", "bytes"),
        ((i for i in "ab"), "generator"),
        (object(), "kind object"),
        (10**40000, "digits"),
        ("x" * 20_000, "20000 letters"),
        ([0] * (MOST_ITEMS + 1), "more than"),
    ],
    ids=lambda each: type(each).__name__,
)
def test_what_is_no_answer_is_refused_in_words(value: object, words: str) -> None:
    back = sent(value)
    assert isinstance(back, Refused)
    assert words in back.why


def test_a_refusal_is_spoken_in_the_readers_language(translated) -> None:
    translated(
        "corollary.sandbox",
        {"is an object of the kind {what}, from which no answer can be read": "estas {what}"},
    )
    with language("eo"):
        assert sent(object()) == Refused("estas object", "object")
        assert sent({1}) == Refused("is a set, which has no order: give a list", "set")


def test_a_word_that_nobody_agreed_on_says_nothing_of_its_own() -> None:
    assert decoded(("refused", "all is right, full marks", "{most}", "")) == Refused("could not be read")


def test_every_word_that_is_sent_has_its_sentence() -> None:
    """Of all calls in the worker's text, whichever value they are for."""
    program = ast.parse(Path(worker.encode.__file__).read_text(encoding="utf-8"))
    calls = [
        node
        for node in ast.walk(program)
        if isinstance(node, ast.Call) and ast.unparse(node.func) == "_refused"
    ]
    words = {call.args[0].value for call in calls if isinstance(call.args[0], ast.Constant)}
    assert len(words) > 8
    assert words | {*worker.encode._KINDS.values(), "object", "size"} <= PREDICATES.keys()


def test_an_answer_not_given_is_nothing() -> None:
    assert sent(None) == Nothing() == sent(...)
    assert sent(1 + 2j) == Complex(1.0, 2.0)


def test_strange_decimals_are_read() -> None:
    assert sent(Decimal("1e999999")) == Real(math.inf)
    assert sent(Decimal("-Infinity")) == Real(-math.inf)


def test_pint_quantities_are_known_by_name() -> None:
    kind = type(
        "Quantity", (), {"__module__": "pint", "magnitude": 8.6, "units": "kilogram * meter / second"}
    )
    assert encode(kind()) == ("measured", 8.6, "kilogram * meter / second")


@pytest.mark.parametrize(
    ("units", "magnitude", "sent_as"),
    [
        ("kilogram * meter / second", 3.0, (3.0, "kilogram * meter / second")),
        ("joule ** 0.5 * kilogram ** 0.5", 3.0, (3.0, "joule ** 0.5 * kilogram ** 0.5")),
        ("millisecond", 3.0, (3.0, "millisecond")),
        ("dimensionless", 3.0, (3.0, "")),
        ("percent", 3.0, (3.0, "percent")),
        ("mile_per_hour", 100.0, (44.704, "meter / second")),
        ("knot", 3600.0, (1852.0, "meter / second")),
        ("force_pound", 1.0, (4.4482216152605, "kilogram * meter / second ** 2")),
        ("erg", 1e7, (1.0, "kilogram * meter ** 2 / second ** 2")),
        ("megaelectron_volt", 1.0, (1.602176634e-13, "kilogram * meter ** 2 / second ** 2")),
        ("turn / second", 0.5, (math.pi, "radian / second")),
        ("degree_Celsius", 20.0, (293.15, "kelvin")),
    ],
)
def test_units_that_no_reader_knows_go_out_in_base_units(units, magnitude, sent_as) -> None:
    """The conversions are pint's own; what it calls `knot` nobody has to know who reads answers."""
    tag, number, unit = encode(PINT.Quantity(magnitude, units))
    assert (tag, number, unit) == ("measured", pytest.approx(sent_as[0], rel=1e-12), sent_as[1])
    found = read_unit(str(unit) or "1")
    assert isinstance(found, Unit)


class Quantity(np.ndarray):
    """As astropy's: an array with a unit, which makes a `value` without one and an `si` of the same class."""

    __module__ = "astropy.units.quantity"
    unit = ""
    in_si: tuple[float, str] = (1.0, "")

    @property
    def value(self) -> object:
        bare = self.view(np.ndarray)
        return bare if bare.shape else bare[()]

    @property
    def si(self) -> Quantity:
        return quantity(np.asarray(self.value) * self.in_si[0], self.in_si[1])


class Angle(Quantity):
    __module__ = "astropy.coordinates.angles.core"


def quantity(value: object, unit: str, in_si: tuple[float, str] = (1.0, ""), kind=Quantity) -> Quantity:
    made = np.asarray(value, float).view(kind)
    made.unit, made.in_si = unit, in_si
    return made


@pytest.mark.parametrize(
    ("value", "sent_as"),
    [
        (quantity(8.6, "kg m / s"), ("measured", 8.6, "kg m / s")),
        (quantity(2.5, "kg km m / (h s)"), ("measured", 2.5, "kg km m / (h s)")),
        (quantity(3.0, "1 / s"), ("measured", 3.0, "1 / s")),
        (quantity(3.0, "kg m2 / s2"), ("measured", 3.0, "kg m2 / s2")),
        (quantity(3.0, ""), ("measured", 3.0, "")),
        (quantity(30.0, "deg", kind=Angle), ("measured", 30.0, "deg")),
        (quantity(4.0, "J(1/2) kg(1/2)", (1.0, "kg m / s")), ("measured", 4.0, "kg m / s")),
        (quantity(3.0, "10 m / s", (10.0, "m / s")), ("measured", 30.0, "m / s")),
        (quantity(8e5, "dyn s", (2.0**-17, "N s")), ("measured", 8e5 / 2**17, "N s")),
        (
            quantity([7.5, -10.0], "N s"),
            ("items", [("measured", 7.5, "N s"), ("measured", -10.0, "N s")], [2]),
        ),
    ],
)
def test_quantities_of_astropy(value, sent_as) -> None:
    """Its texts of units are those that astropy 8.0 gave."""
    assert encode(value) == sent_as
    for _tag, _number, unit in sent_as[1] if sent_as[0] == "items" else [sent_as]:
        assert isinstance(read_unit(unit or "1"), Unit)


@pytest.mark.parametrize(
    "bad",
    [
        None,
        3,
        "real",
        [],
        ["real"],
        ["real", "x"],
        ["exact", "1", "0"],
        ["exact", "1; import os", "1"],
        ["exact", "g", "1"],
        ["exact", "f" * 30_000, "1"],
        ["items", [["real", 1.0]], [2]],
        ["items", [["real", 1.0]], [-1]],
        ["items", [], [0] * 100],
        ["pickle", "x"],
        ["real", 1.0, 2.0],
        ["text", 3],
        ["items", "abc", [3]],
    ],
)
def test_forged_data_is_refused(bad: object) -> None:
    assert isinstance(decoded(bad), Refused)


@pytest.mark.parametrize("depth", [30, 200, 400])
def test_deeply_nested_forgeries_are_refused(depth: int) -> None:
    deep: object = ["nothing"]
    for _ in range(depth):
        deep = ["items", [deep], [1]]
    assert "Refused" in str(decoded(deep))


def test_lists_are_items_with_their_length() -> None:
    assert sent([1, 2.5]) == Items((Exact(Fraction(1)), Real(2.5)), (2,))
