"""Formulas as trees that keep the form in which they were written."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction


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
    """The same node above other parts, as many as `parts` gives."""
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


def mapped(tree: Expr, change: Callable[[Expr], Expr]) -> Expr:
    """Each node changed, from the leaves up."""
    return change(rebuilt(tree, tuple(mapped(part, change) for part in children(tree))))


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


def names(tree: Expr) -> frozenset[str]:
    """Every letter the formula uses."""
    return frozenset(node.name for node in walk(tree) if isinstance(node, Name))


def folded(tree: Expr, meaning: Mapping[str, Expr]) -> Expr:
    """The same formula with a letter in place of every part that is its meaning, word for word: the opposite of `substitute`."""
    name = next((name for name, part in meaning.items() if part == tree), None)
    if name is not None:
        return Name(name)
    return rebuilt(tree, tuple(folded(part, meaning) for part in children(tree)))


def substitute(tree: Expr, meaning: Mapping[str, Expr]) -> Expr:
    """The same formula with letters replaced; nothing is simplified."""
    if isinstance(tree, Name):
        return meaning.get(tree.name, tree)
    return rebuilt(tree, tuple(substitute(part, meaning) for part in children(tree)))


def opposite(relation: Relation) -> Relation:
    """What holds where the relation does not, and both sides have a value."""
    return Relation(OPPOSITE[relation.sign], relation.left, relation.right)
