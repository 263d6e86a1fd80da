"""Operators of laws alone: derivatives, integrals, the value of a function somewhere, products of vectors.

Each is a `Call` of one of the names below. `read_operators` makes them of what an author types; nothing else reads them, so that
no student's formula has one, and whoever evaluates formulas never meets one.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Mapping
from fractions import Fraction

from corollary.formula.ast import (
    ZERO,
    Call,
    Expr,
    Name,
    Negative,
    Number,
    Product,
    Quotient,
    Relation,
    Sum,
    calls,
    children,
    map_children,
    names,
    walk,
)
from corollary.formula.functions import FUNCTIONS

DERIVATIVE, INTEGRAL, VALUE, INFINITY = "derivative", "integral", "value", "infinity"
"""derivative(f, t, n): the n-th; integral(f, t, from, to); value(f, at); infinity(), a limit of an integral."""
INFINITE = frozenset({"oo", "inf", "infinity"})
"""How authors type infinity, `∞` besides."""
DOT, CROSS, NORM = "dot", "cross", "norm"
OPERATORS = frozenset({DERIVATIVE, INTEGRAL, VALUE, INFINITY, DOT, CROSS, NORM})
VECTOR_OPERATORS = frozenset({DOT, CROSS, NORM})
ARITY = {DOT: 2, CROSS: 2, NORM: 1}

ABOVE = re.compile(r"d(?P<order>[2-9]?)(?P<letter>[A-Za-z]\w*)")
BELOW = re.compile(r"d(?P<letter>[A-Za-z]\w*?)(?P<order>[2-9]?)")


def has_operators(tree: Expr, among: Collection[str] = OPERATORS) -> bool:
    """Whether a formula holds what only laws may say."""
    return any(call.function in among for call in calls(tree))


def read_operators(tree: Expr, letters: Collection[str], functions: Collection[str]) -> Expr:
    """The law with its operators: `dv/dt`, `d(m*v)/dt`, `d2x/dt2`, `int(F, t, 0, T)`, `v(0)`, `dot(F, s)`, `cross(r, F)`.

    `letters` are those that mean something, `functions` those of them that depend on another. `dp/dt` stays a quotient where dp or
    dt is a letter of its own. Raises ValueError for what is none of these.
    """

    def within(part: Expr) -> Expr:
        return read_operators(part, letters, functions)

    match tree:
        case Quotient(top, Name(below)) if (by := _by(below, letters)) is not None:
            return _derivative(tree, top, by, letters, functions)
        case Call("int", arguments):
            return _integral(tuple(map(within, arguments)), letters)
        case Call("d", _):
            raise ValueError("d(…) stands above a letter of the problem with a d before it, as in d(m*v)/dt")
        case Call(function, arguments) if function in ARITY:
            if len(arguments) != ARITY[function]:
                raise ValueError(f"{function} takes {ARITY[function]} vectors, not {len(arguments)}")
            return Call(function, tuple(map(within, arguments)))
        case Call(function, (argument,)) if function in functions:
            return Call(VALUE, (Name(function), within(argument)))
        case Call(function, _) if function in letters:
            raise ValueError(
                f"{function}(…): {function} is not a function; write * for a product, "
                f'or say what it depends on: {function} = function("{function}", t)'
            )
        case Call(function, _) if function not in FUNCTIONS:
            raise ValueError(f"{function}(…) is not a function here; write * for every product")
        case _:
            return map_children(tree, within)


def as_stated(tree: Expr) -> Expr:
    """The law as an author types it, to be written: the inverse of `read_operators`."""
    match tree:
        case Call("derivative", (of, Name(by), Number(order))):
            often = "" if order == 1 else str(order)
            top = Name(f"d{often}{of.name}") if isinstance(of, Name) else Call("d", (as_stated(of),))
            return Quotient(top, Name(f"d{by}{often}"))
        case Call("integral", arguments):
            return Call("int", tuple(map(as_stated, arguments)))
        case Call("infinity", _):
            return Name("oo")
        case Call("value", (Name(function), at)):
            return Call(function, (as_stated(at),))
        case _:
            return map_children(tree, as_stated)


def bound_letters(tree: Expr) -> frozenset[str]:
    """The letters over which something is integrated."""
    return names(*(call.arguments[1] for call in calls(tree) if call.function == INTEGRAL))


def measured(tree: Expr) -> Expr:
    """A formula that measures the same, without derivatives, integrals and values."""
    match tree:
        case Call("derivative", (of, by, Number(order))):
            below: Expr = by if order == 1 else Product((by,) * int(order))
            return Quotient(measured(of), below)
        case Call("integral", (of, by, low, high)):
            end = low if high == ZERO or has_operators(high, {INFINITY}) else high
            return Product(
                (measured(of), by if end == ZERO or has_operators(end, {INFINITY}) else measured(end))
            )
        case Call("value", (function, _at)):
            return function
        case _:
            return map_children(tree, measured)


def _by(below: str, letters: Collection[str]) -> tuple[str, int] | None:
    """`dt` and `dt2` below a line: the letter and how often; None for a letter of its own, or of nothing known."""
    found = BELOW.fullmatch(below)
    if below in letters or found is None or found["letter"] not in letters:
        return None
    return found["letter"], int(found["order"] or 1)


def _derivative(
    whole: Quotient, top: Expr, by: tuple[str, int], letters: Collection[str], functions: Collection[str]
) -> Expr:
    """The factor above the line that is derived, and the others before it: `m*dv/dt` is m times dv/dt."""
    name, order = by
    twice = order if order > 1 else ""
    factors = list(top.factors) if isinstance(top, Product) else [top]
    for place, factor in enumerate(factors):
        of = _derived(factor, order, letters)
        if of is None:
            continue
        if of == Name(""):
            raise ValueError(
                f"as often above the line as below it: write d{twice}x/d{name}{twice}, with x for what is derived"
            )
        found = Call(
            DERIVATIVE, (read_operators(of, letters, functions), Name(name), Number(Fraction(order)))
        )
        others = [read_operators(each, letters, functions) for each in factors[:place] + factors[place + 1 :]]
        return Product((*others, found)) if others else found
    return map_children(whole, lambda part: read_operators(part, letters, functions))


def _derived(factor: Expr, order: int, letters: Collection[str]) -> Expr | None:
    """What `dv`, `d2x` or `d(m*v)` derives; None for another factor, Name("") where the orders differ."""
    match factor:
        case Call("d", (of,)) if order == 1:
            return of
        case Name(name) if (
            name not in letters and (found := ABOVE.fullmatch(name)) and found["letter"] in letters
        ):
            return Name(found["letter"]) if int(found["order"] or 1) == order else Name("")
        case _:
            return None


def _integral(arguments: tuple[Expr, ...], letters: Collection[str]) -> Expr:
    if len(arguments) != 4 or not isinstance(arguments[1], Name):
        raise ValueError(
            "an integral is int(what, letter, from, to), as in int(F, t, 0, T) or int(P, t, 0, oo)"
        )
    of, by, *limits = arguments
    return Call(INTEGRAL, (of, by, *(_limit(each, letters) for each in limits)))


def _limit(limit: Expr, letters: Collection[str]) -> Expr:
    """A limit of an integral, which may be infinite."""
    match limit:
        case Name(name) if name in INFINITE and name not in letters:
            return Call(INFINITY, ())
        case Negative(term):
            return Negative(_limit(term, letters))
        case _:
            return limit


def scalar_part(tree: Expr, index: int, vectors: Mapping[str, int]) -> Expr:
    """One component of a formula, products of vectors written out; component i of r in them is the letter `r[i]`."""
    match tree:
        case Call("dot", (one, other)):
            return _sum_of(one, other, range(_length(one, vectors)), vectors)
        case Call("norm", (one,)):
            return Call("sqrt", (_sum_of(one, one, range(_length(one, vectors)), vectors),))
        case Call("cross", (one, other)):
            length = {_length(one, vectors), _length(other, vectors)}
            if length not in ({2}, {3}):
                raise ValueError("cross takes two vectors with three components each, or with two each")
            j, k = ((1, 2), (2, 0), (0, 1))[index if length == {3} else 2]
            first = Product((_component(one, j, vectors), _component(other, k, vectors)))
            second = Product((_component(one, k, vectors), _component(other, j, vectors)))
            return Sum((first, Negative(second)))
        case _:
            return map_children(tree, lambda part: scalar_part(part, index, vectors))


def is_vector(tree: Expr, vectors: Mapping[str, int]) -> bool:
    """Whether a formula has components; a product of two vectors in a plane has not, nor has a length."""
    match tree:
        case Name(name):
            return name in vectors
        case Call("dot" | "norm", _):
            return False
        case Call("cross", (one, _)):
            return _length(one, vectors) == 3
        case Relation(_, left, right):
            return is_vector(left, vectors) or is_vector(right, vectors)
        case _:
            return any(is_vector(part, vectors) for part in children(tree))


def _length(tree: Expr, vectors: Mapping[str, int]) -> int:
    """How many components a vector in a product has. Raises ValueError where it is none."""
    if not is_vector(tree, vectors):
        raise ValueError(
            "dot, cross and norm take vectors; give their letters components, as in r = vector('r', 'x y z')"
        )
    return next(vectors[node.name] for node in walk(tree) if isinstance(node, Name) and node.name in vectors)


def _component(tree: Expr, index: int, vectors: Mapping[str, int]) -> Expr:
    match tree:
        case Name(name) if name in vectors:
            return Name(f"{name}[{index}]")
        case Call(function, _) if function in VECTOR_OPERATORS:
            return scalar_part(tree, index, vectors)
        case _:
            return map_children(tree, lambda part: _component(part, index, vectors))


def _sum_of(one: Expr, other: Expr, indices: range, vectors: Mapping[str, int]) -> Expr:
    return Sum(tuple(Product((_component(one, i, vectors), _component(other, i, vectors))) for i in indices))
