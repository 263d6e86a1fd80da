"""The bends of a law: signs, factors, exponents, sines, terms and prefixes that an author may get wrong."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from fractions import Fraction

from corollary.formula.ast import (
    Call,
    Expr,
    Name,
    Negative,
    Number,
    Power,
    Product,
    Quotient,
    Relation,
    Sum,
    children,
    rebuilt,
)
from corollary.formula.operators import OPERATORS, as_stated
from corollary.formula.text import text
from corollary.laws.law import Law

FACTORS: tuple[tuple[str, Expr], ...] = (
    ("factor 2", Number(Fraction(2))),
    ("factor 1/2", Quotient(Number(Fraction(1)), Number(Fraction(2)))),
    ("factor 3", Number(Fraction(3))),
    ("factor 4", Number(Fraction(4))),
    ("factor pi", Name("pi")),
    ("prefix 10^3", Number(Fraction(1000))),
    ("prefix 10^-3", Quotient(Number(Fraction(1)), Number(Fraction(1000)))),
)
ONE, NOTHING = Number(Fraction(1)), Number(Fraction(0))
OTHER = {"sin": "cos", "cos": "sin"}


@dataclass(frozen=True, slots=True)
class Bend:
    """One law otherwise: the kind of slip, and the law with it."""

    kind: str
    law: Law

    @property
    def text(self) -> str:
        return text(as_stated(self.law.textbook))


def bends(law: Law) -> Iterator[Bend]:
    """Every bend of a law, each once."""
    whole = law.textbook
    seen = {whole, Relation("=", whole.right, whole.left)}
    for kind, bent in _of_sides(whole):
        if bent not in seen:
            seen.add(bent)
            yield Bend(kind, replace(law, textbook=bent))


def _of_sides(whole: Relation) -> Iterator[tuple[str, Relation]]:
    """Of the right side, and of the left where it is more than one letter: a factor there is its inverse on the right."""
    left, right = whole.left, whole.right
    if right != NOTHING:
        for kind, bent in _of(right, top=True):
            yield kind, Relation("=", left, bent)
        if isinstance(right, Sum) and left != NOTHING:
            for kind, bent in _of_term(right):
                yield kind, Relation("=", left, bent)
    if not isinstance(left, Name):
        single = not isinstance(left, Sum)
        for kind, bent in _of(left, top=not single):
            yield kind, Relation("=", bent, right)


def _of(tree: Expr, *, top: bool) -> Iterator[tuple[str, Expr]]:
    """A formula with one slip in it; signs and factors of the whole only at the `top`, of terms everywhere."""
    if top and not isinstance(tree, Sum):
        yield from _of_term(tree)
    match tree:
        case Sum(terms):
            for place, term in enumerate(terms):
                before, after = terms[:place], terms[place + 1 :]
                for kind, bent in _of_term(term):
                    yield kind, Sum((*before, bent, *after))
                rest = (*before, *after)
                yield "term dropped", rest[0] if len(rest) == 1 else Sum(rest)
        case Power(base, Number(value)):
            for step in (1, -1):
                yield "exponent", _power(base, value + step)
        case Call(function, arguments) if function in OTHER:
            yield "sine for cosine", Call(OTHER[function], arguments)
        case _:
            pass
    if isinstance(tree, Call) and tree.function in OPERATORS:
        return  # what stands in a derivative is no factor
    below = children(tree)
    for place, part in enumerate(below):
        if isinstance(tree, Power) and place == 1:
            continue
        bent_parts = _of(part, top=False)
        if isinstance(part, Name) and isinstance(tree, Product | Quotient):
            bent_parts = iter([("exponent", _power(part, Fraction(2))), ("exponent", ONE)])
        for kind, bent in bent_parts:
            yield kind, rebuilt(tree, (*below[:place], bent, *below[place + 1 :]))


def _of_term(term: Expr) -> Iterator[tuple[str, Expr]]:
    if term == NOTHING:
        return
    inner = term.term if isinstance(term, Negative) else term
    yield "sign", inner if isinstance(term, Negative) else Negative(inner)
    for kind, factor in FACTORS:
        product = Product((factor, *(inner.factors if isinstance(inner, Product) else (inner,))))
        yield kind, Negative(product) if isinstance(term, Negative) else product


def _power(base: Expr, exponent: Fraction) -> Expr:
    return ONE if exponent == 0 else base if exponent == 1 else Power(base, Number(exponent))
