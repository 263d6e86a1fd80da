"""A small library of common misconceptions: each takes the law as it is right, and states the mistake that bends it.

Each takes the name of the law whose place it takes (`instead`), as `mistake` does, and `where`, which root is meant.
The mistake has a name, so that it is recognized in other problems.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import TYPE_CHECKING, TypeAlias

from corollary.derive.stated_words import line_of_word
from corollary.derive.statements import Exchange, Mistake
from corollary.formula.ast import (
    ONE,
    TWO,
    ZERO,
    Expr,
    Name,
    Negative,
    Number,
    Power,
    Product,
    Quotient,
    Relation,
    Sum,
    cofunction,
    mapped,
    names,
    substitute,
)
from corollary.formula.plain_text import text
from corollary.formula.syntax import author_formula
from corollary.laws.law import wrong

if TYPE_CHECKING:
    from sympy.logic.boolalg import Boolean

Where: TypeAlias = "Boolean | bool | None"
ZERO_CELSIUS = Fraction("273.15")  # K


def sine_for_cosine(right: str, *, instead: str = "", where: Where = None) -> Mistake[Exchange]:
    """Sine and cosine interchanged, wherever the law has them: `sine_for_cosine("F_x = F*cos(theta)")`."""
    return _bent(
        right,
        lambda tree: mapped(tree, cofunction),
        "Sine and cosine have changed places: look which side of the triangle lies at the angle.",
        "sine and cosine interchanged",
        instead,
        where,
    )


def diameter_for_radius(right: str, r: str, *, instead: str = "", where: Where = None) -> Mistake[Exchange]:
    """The diameter in the place of the radius: `diameter_for_radius("A = pi*r^2", "r")`."""
    sentence = "You took the diameter where the radius belongs."
    return _replaced(
        right, r, lambda name: Product((TWO, name)), sentence, "diameter for radius", instead, where
    )


def radius_for_diameter(right: str, d: str, *, instead: str = "", where: Where = None) -> Mistake[Exchange]:
    """The radius in the place of the diameter."""
    sentence = "You took the radius where the diameter belongs."
    return _replaced(
        right, d, lambda name: Quotient(name, TWO), sentence, "radius for diameter", instead, where
    )


def celsius_for_kelvin(right: str, T: str, *, instead: str = "", where: Where = None) -> Mistake[Exchange]:
    """Degrees Celsius in a law that needs the absolute temperature: `celsius_for_kelvin("p*V = n*R*T", "T")`."""
    sentence = "You took the temperature in °C; the law needs the absolute temperature, in K."
    return _replaced(
        right,
        T,
        lambda name: Sum((name, Number(-ZERO_CELSIUS))),
        sentence,
        "celsius for kelvin",
        instead,
        where,
    )


def left_out(
    right: str, letter: str, what: str, *, instead: str = "", where: Where = None
) -> Mistake[Exchange]:
    """A term that was forgotten, as if its letter were 0: `left_out("F - m*g = m*a", "g", "the weight")`."""
    return _replaced(
        right, letter, lambda _: ZERO, f"You left {what} out.", f"{what} left out", instead, where
    )


def sign_reversed(
    right: str, letter: str, what: str, *, instead: str = "", where: Where = None
) -> Mistake[Exchange]:
    """The other direction: `sign_reversed("dp = m*v2 - m*v1", "v1", "the velocity before")`."""
    sentence = f"Look at the sign of {what}."
    return _replaced(right, letter, Negative, sentence, f"sign of {what}", instead, where)


def not_squared(right: str, letter: str, *, instead: str = "", where: Where = None) -> Mistake[Exchange]:
    """A square forgotten, wherever the letter has one: `not_squared("K = m*v^2/2", "v")`."""

    def without_square(tree: Expr) -> Expr:
        match tree:
            case Power(Name(name) as base, Number(value)) if name == letter and value == 2:
                return base
            case _:
                return tree

    return _bent(
        right,
        lambda tree: mapped(tree, without_square),
        f"You forgot to square {letter}.",
        "square forgotten",
        instead,
        where,
    )


def squared(right: str, letter: str, *, instead: str = "", where: Where = None) -> Mistake[Exchange]:
    """A letter squared that is not: `squared("p = m*v", "v")`."""
    sentence = f"{letter} is not squared here."
    return _replaced(
        right, letter, lambda name: Power(name, TWO), sentence, "squared too often", instead, where
    )


def half_forgotten(right: str, *, instead: str = "", where: Where = None) -> Mistake[Exchange]:
    """The factor ½ forgotten: `half_forgotten("K = m*v^2/2")` doubles the right side."""
    return _right_side(
        right,
        lambda side: Product((TWO, side)),
        "You forgot the factor one half.",
        "factor 1/2 left out",
        instead,
        where,
    )


def upside_down(right: str, *, instead: str = "", where: Where = None) -> Mistake[Exchange]:
    """The fraction the wrong way round: `upside_down("t = d/v")` states t = v/d."""
    return _right_side(
        right,
        lambda side: Quotient(ONE, side),
        "Your fraction is upside down; compare the units of both sides.",
        "fraction upside down",
        instead,
        where,
    )


def swapped(
    right: str, one: str, other: str, what: str, *, instead: str = "", where: Where = None
) -> Mistake[Exchange]:
    """Two letters interchanged: `swapped("m_A*v_A = m_B*v_B", "m_A", "m_B", "the masses")`."""
    return _bent(
        right,
        lambda tree: substitute(tree, {one: Name(other), other: Name(one)}),
        f"{what[:1].upper()}{what[1:]} have changed places.",
        f"{what} interchanged",
        instead,
        where,
        one,
        other,
    )


def _replaced(
    right: str, letter: str, by: Callable[[Name], Expr], sentence: str, name: str, instead: str, where: Where
) -> Mistake[Exchange]:
    return _bent(
        right,
        lambda tree: substitute(tree, {letter: by(Name(letter))}),
        sentence,
        name,
        instead,
        where,
        letter,
    )


def _right_side(
    right: str, change: Callable[[Expr], Expr], sentence: str, name: str, instead: str, where: Where
) -> Mistake[Exchange]:
    def bent(tree: Expr) -> Expr:
        assert isinstance(tree, Relation)
        return Relation(tree.sign, tree.left, change(tree.right))

    return _bent(right, bent, sentence, name, instead, where)


def _bent(
    right: str,
    change: Callable[[Expr], Expr],
    sentence: str,
    name: str,
    instead: str,
    where: Where,
    *letters: str,
) -> Mistake[Exchange]:
    """Raises ValueError where the law is none, or does not have what the misconception changes; TypeError where it is no text."""
    if not isinstance(right, str):  # pyright: ignore[reportUnnecessaryIsInstance]
        raise TypeError(
            'a misconception takes the law as it is right as a text, such as "K = m*v^2/2", not law(…)'
        )
    tree = author_formula(right, operators=True)
    if not isinstance(tree, Relation):
        raise ValueError(f"{right!r} is not a law; write an equation, such as K = m*v^2/2")
    if strange := [letter for letter in letters if letter not in names(tree)]:
        raise ValueError(f"{strange[0]} does not occur in {right!r}")
    changed = change(tree)
    if changed == tree:
        raise ValueError(f"{right!r} stays as it is: there is nothing in it to be mistaken so")
    return Mistake(
        sentence,
        Exchange((wrong(text(changed)),), (instead,) if instead else (), where),
        line_of_word(),
        name,
    )
