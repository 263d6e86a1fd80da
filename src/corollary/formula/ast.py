"""Formulas as trees that keep the form in which they were written."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import overload


@dataclass(frozen=True, slots=True)
class Number:
    """An exact number; `figures` is how many significant figures it was written with (0: exact)."""

    value: Fraction
    figures: int = 0


@dataclass(frozen=True, slots=True)
class Name:
    """A letter of a formula: a given, a find, a constant such as `pi`."""

    name: str


@dataclass(frozen=True, slots=True)
class Negative:
    term: Expr


@dataclass(frozen=True, slots=True)
class Sum:
    """Terms added; a subtraction is a `Negative` term."""

    terms: tuple[Expr, ...]


@dataclass(frozen=True, slots=True)
class Product:
    factors: tuple[Expr, ...]


@dataclass(frozen=True, slots=True)
class Quotient:
    top: Expr
    bottom: Expr


@dataclass(frozen=True, slots=True)
class Power:
    base: Expr
    exponent: Expr


@dataclass(frozen=True, slots=True)
class Call:
    """A function of the fixed list: sqrt, abs, sin, cos, tan, asin, acos, atan, atan2, exp, ln, log10, gamma, min, max…"""

    function: str
    arguments: tuple[Expr, ...]


@dataclass(frozen=True, slots=True)
class Relation:
    """Two formulas compared; `sign` is one of = != < <= > >=."""

    sign: str
    left: Expr
    right: Expr


ZERO, ONE, TWO = (Number(Fraction(each)) for each in range(3))
OPPOSITE = {"<": ">=", "<=": ">", ">": "<=", ">=": "<", "=": "!=", "!=": "="}
Expr = Number | Name | Negative | Sum | Product | Quotient | Power | Call | Relation


def children(tree: Expr) -> tuple[Expr, ...]:
    """The trees directly below this one, in reading order."""
    match tree:
        case Number() | Name():
            return ()
        case Negative(term):
            return (term,)
        case Sum(terms):
            return terms
        case Product(factors):
            return factors
        case Quotient(top, bottom):
            return (top, bottom)
        case Power(base, exponent):
            return (base, exponent)
        case Call(_, arguments):
            return arguments
        case Relation(_, left, right):
            return (left, right)


def rebuilt(tree: Expr, below: tuple[Expr, ...]) -> Expr:
    """The same node above other parts, as many as `children` gives."""
    match tree:
        case Number() | Name():
            return tree
        case Negative():
            return Negative(*below)
        case Sum():
            return Sum(below)
        case Product():
            return Product(below)
        case Quotient():
            return Quotient(*below)
        case Power():
            return Power(*below)
        case Call(function, _):
            return Call(function, below)
        case Relation(sign, _, _):
            return Relation(sign, *below)


def map_children(tree: Expr, change: Callable[[Expr], Expr]) -> Expr:
    """The same node with each part directly below it changed."""
    return rebuilt(tree, tuple(map(change, children(tree))))


def replace_child(tree: Expr, place: int, other: Expr) -> Expr:
    """The same node with another part at one place below it."""
    below = children(tree)
    return rebuilt(tree, (*below[:place], other, *below[place + 1 :]))


def mapped(tree: Expr, change: Callable[[Expr], Expr]) -> Expr:
    """Each node changed, from the leaves up."""
    return change(map_children(tree, lambda part: mapped(part, change)))


def cofunction(tree: Expr) -> Expr:
    """The cosine for a sine, and the other way round; anything else as it is."""
    match tree:
        case Call("sin" | "cos" as function, arguments):
            return Call("cos" if function == "sin" else "sin", arguments)
        case _:
            return tree


def walk(tree: Expr) -> Iterator[Expr]:
    """The tree and all below it, parents first."""
    left = [tree]
    while left:
        yield (part := left.pop())
        left += children(part)[::-1]


def names(*trees: Expr) -> frozenset[str]:
    """Every letter that the formulas use."""
    return frozenset(node.name for tree in trees for node in walk(tree) if isinstance(node, Name))


def calls(tree: Expr) -> Iterator[Call]:
    """Every function in the formula with its arguments."""
    return (node for node in walk(tree) if isinstance(node, Call))


def unsigned(tree: Expr) -> Expr:
    """The formula without the minus before it."""
    return tree.term if isinstance(tree, Negative) else tree


def negated(tree: Expr) -> Expr:
    """The formula with a minus before it, or without the one it has."""
    return tree.term if isinstance(tree, Negative) else Negative(tree)


def difference(relation: Relation) -> Expr:
    """Left side less right side."""
    return Sum((relation.left, Negative(relation.right)))


def folded(tree: Expr, meaning: Mapping[str, Expr]) -> Expr:
    """The same formula with a letter in place of every part that is its meaning, word for word: the opposite of `substitute`."""
    name = next((name for name, part in meaning.items() if part == tree), None)
    if name is not None:
        return Name(name)
    return map_children(tree, lambda part: folded(part, meaning))


@overload
def substitute(tree: Relation, meaning: Mapping[str, Expr]) -> Relation: ...
@overload
def substitute(tree: Expr, meaning: Mapping[str, Expr]) -> Expr: ...
def substitute(tree: Expr, meaning: Mapping[str, Expr]) -> Expr:
    """The same formula with letters replaced; nothing is simplified."""
    if isinstance(tree, Name):
        return meaning.get(tree.name, tree)
    return map_children(tree, lambda part: substitute(part, meaning))


def opposite(relation: Relation) -> Relation:
    """What holds where the relation does not, and both sides have a value."""
    return Relation(OPPOSITE[relation.sign], relation.left, relation.right)
