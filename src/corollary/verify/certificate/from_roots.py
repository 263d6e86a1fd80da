"""What follows from the squares of roots (and from sines and cosines on the unit circle): a combination worked out here, checked by Coq."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from corollary.formula.ast import Relation, names
from corollary.polynomials.rational_function import RationalFunction
from corollary.verify.certificate.coq import polynomial


def combined(top: Any, equations: Sequence[tuple[int, Relation, RationalFunction]]) -> str:
    """Tactics that show a polynomial to be zero by the equations R0, R1, … of roots, each with its place, itself and left side less
    right side; "" where it is no combination of them.

    Each root is divided out in turn, the last one made first: the others may stand in it.
    """
    letters = top.context().names()
    factor, rest = top.context().constant(1), top
    terms = list[tuple[Any, int, Any]]()
    for place, known, gap in reversed(equations):
        letter = min(names(known.left))
        at = letters.index(letter)
        square = _coefficient(gap.top, at, 2)
        while (degree := int(rest.degrees()[at])) >= 2:
            by = _coefficient(rest, at, degree) * top.context().gen(at) ** (degree - 2)
            rest = square * rest - by * gap.top
            factor, terms = square * factor, [(square * each, i, other) for each, i, other in terms]
            terms.append((by, place, gap.top))
    if not terms or not rest.is_zero():
        return ""
    total = " + ".join(f"{polynomial(by)} * {polynomial(other)}" for by, _, other in terms)
    rewritten = ", ".join(f"?R'{place}" for place in dict.fromkeys(place for _, place, _ in terms))
    return (
        f"apply (Rmult_eq_reg_l {polynomial(factor)}); "
        f"[ replace ({polynomial(factor)} * {polynomial(top)}) with ({total}) by ring; rewrite {rewritten}; ring | nonzero ]"
    )


def zero(name: str, gap: RationalFunction, left: str, right: str) -> str:
    """That the numerator of left side less right side is zero, since the sides are equal."""
    top, bottom = polynomial(gap.top), polynomial(gap.bottom)
    return (
        f"assert ({name} : {top} = 0).\n"
        f"  {{ replace {top} with (({left} - {right}) * {bottom}) by (field; nonzero). replace ({left} - {right}) with 0 by lra. ring. }}"
    )


def _coefficient(found: Any, at: int, degree: int) -> Any:
    """Of a polynomial of python-flint the coefficient of a letter's power, as a polynomial in the other letters."""
    terms = {
        tuple(0 if place == at else power for place, power in enumerate(powers)): coefficient
        for powers, coefficient in found.to_dict().items()
        if int(powers[at]) == degree
    }
    return found.context().from_dict(terms)
