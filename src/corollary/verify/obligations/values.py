"""Claims that what is asked exists, and is not zero where it is compared with nothing else."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from corollary.derive.solution import Solution
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
)
from corollary.formula.exact import constant
from corollary.verify.obligations.obligation import Obligation

ZERO, ONE, TWO = (Number(Fraction(each)) for each in (0, 1, 2))


def existing(solution: Solution) -> Iterator[Obligation]:
    """Every answer, and all on the way to it, has a value."""
    for find in solution.unknowns:
        claim = f"{', '.join(find.names)} has a value"
        if find.in_givens is None:
            yield Obligation("value exists", claim, find.statement.line, open="it comes from a simulation")
        else:
            needs = dict.fromkeys(need for tree in find.in_givens for need in needed(tree))
            yield Obligation(
                "value exists",
                claim,
                find.statement.line,
                tuple((need,) for need in needs),
                formulas=find.in_givens,
            )


def not_zero(solution: Solution) -> Iterator[Obligation]:
    """No answer is zero where nothing says how large an error would be large."""
    for find in solution.unknowns:
        if find.part and find.in_givens is not None:
            part = next(each for each in solution.problem.parts if each.id == find.part)
            zero = Number(Fraction(part.unit.offset))
            sizes: list[Expr] = [
                Sum((tree, Negative(zero))) if zero.value else tree for tree in find.in_givens
            ]
            sizes += [find.scale] if find.scale is not None else []
            need = (
                Relation("!=", sizes[0], ZERO)
                if len(sizes) == 1
                else Relation(">", Sum(tuple(Power(each, TWO) for each in sizes)), ZERO)
            )
            claim = f"part {find.part} is not zero" + (", or has a scale" if find.scale is not None else "")
            yield Obligation("not zero", claim, find.statement.line, ((need,),), redrawn=True)


def needed(tree: Expr) -> Iterator[Relation]:
    """What must hold so that a formula has a value: of its parts first."""
    for part in children(tree):
        yield from needed(part)
    match tree:
        case Quotient(_, bottom) if not constant(bottom):
            yield Relation("!=", bottom, ZERO)
        case Power(base, exponent):
            power = constant(exponent)
            if power is None:
                yield Relation(">", base, ZERO)
            elif power.denominator > 1 and not _positive(base):
                yield Relation(">" if power < 0 else ">=", base, ZERO)
            elif power < 0 and not constant(base):
                yield Relation("!=", base, ZERO)
        case Call("sqrt", (of,)) if not _positive(of):
            yield Relation(">=", of, ZERO)
        case Call("ln" | "log10" | "gamma", (of,)):
            yield Relation(">", of, ZERO)
        case Call("asin" | "acos", (of,)):
            yield Relation("<=", of, ONE)
            yield Relation(">=", of, Negative(ONE))
        case Call("tan", (of,)):
            yield Relation("!=", Call("cos", (of,)), ZERO)
        case Call("atan2", (y, x)):
            yield Relation(">", Sum((Power(y, TWO), Power(x, TWO))), ZERO)
        case Product() | Name() | _:
            pass


def _positive(tree: Expr) -> bool:
    """Of a formula without letters."""
    value = constant(tree)
    return value is not None and value > 0
