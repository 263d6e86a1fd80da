"""Roots: laws solved for unknowns, and the root that is meant; three real roots of a cubic in cosines."""

# pyright: reportMissingTypeArgument=false, reportUnknownArgumentType=false, reportUnknownMemberType=false, reportUnknownParameterType=false, reportUnknownVariableType=false

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import sympy

from corollary.derive.assumptions import FoundFunction, Known, Point, Root, at, with_values
from corollary.derive.function_values import Pair, eliminated, functions_in
from corollary.derive.statements import Exchange, Mistake, Rejected, Sentence
from corollary.formula.ast import Name, Relation
from corollary.formula.from_sympy import NoTree, as_typed, relation, tree
from corollary.formula.latex import latex
from corollary.laws.law import Law, substitute, symbols
from corollary.messages import N_


def real_roots(equation: sympy.Expr, unknown: sympy.Symbol, points: Sequence[Point]) -> list[Root]:
    """The roots of `equation` = 0 in the unknown (Viète, 1615); none where it is no cubic, or at some point not all are real and apart."""
    if degree_in(equation, unknown) != 3:
        return []
    a, b, c, d = sympy.Poly(_top(equation), unknown).all_coeffs()
    middle = -b / (3 * a)
    slope = sympy.factor((3 * a * c - b**2) / (3 * a**2))
    start = sympy.factor((2 * b**3 - 9 * a * b * c + 27 * a**2 * d) / (27 * a**3))
    size = 2 * sympy.sqrt(-slope / 3)
    cosine = sympy.simplify(-4 * start / size**3)
    for point in points:
        value = at(cosine, point)
        if not (value.is_real and value.is_finite and abs(value) < 1):
            return []
    third = sympy.acos(cosine) / 3
    return [{unknown: middle + size * sympy.cos(third - 2 * sympy.pi * turn / 3)} for turn in range(3)]


def degree_in(equation: sympy.Expr, unknown: sympy.Symbol) -> int:
    """The degree of `equation` = 0 without its denominators; 0 where it is no polynomial in the unknown."""
    top = _top(equation)
    return int(sympy.Poly(top, unknown).degree()) if top.is_polynomial(unknown) else 0


def _top(equation: sympy.Expr) -> Any:
    return sympy.fraction(sympy.together(equation))[0]


EDGE = sympy.Float("1e-20")  # nearer than this, algebra decides whether two values are the same
SAME = sympy.Float("1e-25")  # relative: two values of 30 digits are the same


class NoRoot(ValueError):
    """The laws do not fix the unknowns; one sentence says how, and `line` is that of the mistake or route at fault (or 0)."""

    def __init__(self, sentence: str, line: int = 0):
        self.line = line
        super().__init__(sentence)


@dataclass(frozen=True, slots=True)
class Picked:
    """The root that is meant, and what is on record about the others; those rejected in words, and all that are not."""

    root: Root
    refused: tuple[Sentence, ...]
    worded: tuple[Root, ...] = ()
    others: tuple[Root, ...] = ()


def roots(
    laws: Sequence[Law], unknowns: Sequence[sympy.Symbol], known: Known
) -> tuple[list[Root], tuple[FoundFunction, ...]]:
    """Every root of the laws in the unknowns, and the functions found on the way.

    Raises NoRoot when a letter is strange, none exists, or one stays free.
    """
    letters = known.letters | {each.args[0] for each in functions_in(laws).values()}
    for stated in laws:
        if strange := symbols(stated) - letters - set(unknowns):
            raise NoRoot(f"{stated.name}: {_list(strange)} is neither given nor found before")
    pairs, functions = eliminated(laws, unknowns, known)
    return _roots(pairs, unknowns, known), functions


def _roots(pairs: Sequence[Pair], unknowns: Sequence[sympy.Symbol], known: Known) -> list[Root]:
    equations = [left - right for left, right in pairs]
    live = [equation for equation in equations if sympy.expand(equation) != 0]
    try:
        found = stated_outright(pairs, unknowns) or [
            dict(root) for root in _solved(tuple(live), tuple(unknowns))
        ]
    except NotImplementedError:
        raise NoRoot(
            f"these laws cannot be solved for {_list(unknowns)} in a formula; find one letter after the other"
        ) from None
    if not found and len(live) == len(unknowns) == 1 and (degree := degree_in(live[0], unknowns[0])) > 4:
        raise NoRoot(
            f"{unknowns[0]} is a root of degree {degree}, for which there is no formula; "
            "give another letter as a given and find this one's partner from it, or measure it with simulated(…)"
        )
    if not found:
        raise NoRoot(
            f"{_count(len(live), 'law')} for {_count(len(unknowns), 'unknown')}: no {_list(unknowns)} satisfies them all"
        )
    for root in found:
        free = [
            unknown
            for unknown in unknowns
            if unknown not in root or root[unknown].free_symbols & set(unknowns)
        ]
        if free:
            raise NoRoot(
                f"{_count(len(live), 'law')} for {_count(len(unknowns), 'unknown')}: {_list(free)} stays free"
            )
    if len(live) == len(unknowns) == 1 and any(root[unknowns[0]].has(sympy.I) for root in found):
        return real_roots(live[0], unknowns[0], known.points) or found
    return found


@lru_cache(maxsize=1024)
def _solved(
    equations: tuple[sympy.Expr, ...], unknowns: tuple[sympy.Symbol, ...]
) -> tuple[tuple[tuple[sympy.Symbol, sympy.Expr], ...], ...]:
    """Solved once while a command runs: `verify` solves and puts back, and an author's next edition has most steps unchanged."""
    return tuple(tuple(root.items()) for root in sympy.solve(list(equations), list(unknowns), dict=True))


def stated_outright(pairs: Sequence[Pair], unknowns: Sequence[sympy.Symbol]) -> list[Root]:
    """The root when each law says just what one unknown is: `x = …`, one law for each, in known letters only."""
    root: dict[sympy.Symbol, sympy.Expr] = {}
    for left, right in pairs:
        if left not in unknowns or left in root or right.free_symbols & set(unknowns):
            return []
        root[left] = right  # type: ignore[index]
    return [root] if len(root) == len(unknowns) else []


def pick(
    found: Sequence[Root], points: Sequence[Point], where: sympy.Basic | bool, rejected: Sequence[Rejected]
) -> Picked:
    """The one root that is real and fulfils `where` at every sample point. Raises NoRoot when none or several do."""
    left: list[Root] = []
    worded: list[Root] = []
    refused: list[Sentence] = []
    why: list[str] = []  # the same, in the letters that the author types
    for root in found:
        reason = next((entry.reason for entry in rejected if _is(root, entry.root, points)), None)
        if reason is not None:
            refused.append(Sentence(reason))
            why.append(f"{_equations(root)} is rejected")
            worded.append(root)
        elif not all(_real(root, point) for point in points):
            if (formula := _formula(root)) is not None:
                refused.append(
                    Sentence(N_("{root} is not real for every value of the givens"), (("root", formula),))
                )
            why.append(
                f"{_equations(root)} is not real for every value of the givens (narrow their ranges, or bound them with where:)"
            )
        else:
            left.append(root)
    for entry in rejected:
        if not any(_is(root, entry.root, points) for root in found):
            raise NoRoot(f"the root to reject ({entry.reason}) is not a root of the laws")
    found_fit = [
        [where] * len(points) if isinstance(where, bool) else [_holds(where, root, point) for point in points]
        for root in left
    ]
    fitting = [root for root, fits in zip(left, found_fit, strict=True) if all(fits)]
    for root, fits in zip(left, found_fit, strict=True):
        if root in fitting:
            continue
        fits_at = [point for point, fit in zip(points, fits, strict=True) if fit]
        if fits_at and not any(_is(root, other, fits_at) for other in fitting):
            raise NoRoot(
                f"where: {_named(where)} holds for {_equations(root)} at some values of the givens and fails at others; "
                "use a condition that selects one root for all of them (a mistake may have its own where)"
            )
        if (formula := _formula(root)) is not None:
            holes = (("root", formula), ("condition", f"${_condition(where)}$"))
            refused.append(Sentence(N_("{root} contradicts {condition}"), holes))
        why.append(f"{_equations(root)} contradicts {_named(where)}")
    if not fitting:
        raise NoRoot(f"no root is left: {'; '.join(why)}")
    if len(fitting) > 1:
        raise NoRoot(
            f"{len(fitting)} answers ({'; '.join(_equations(root) for root in fitting)}): say which, with where or reject"
        )
    if any(value.has(sympy.I) for value in fitting[0].values()):
        raise NoRoot(
            f"{_equations(fitting[0])} is real, but its formula has complex numbers on its way: state the root in another form "
            "(in cosines) as a law of the step, and the equation itself in confirm(…)"
        )
    others = [root for root in found if root is not fitting[0] and not any(root is each for each in worded)]
    return Picked(fitting[0], tuple(refused), tuple(worded), tuple(others))


def _is(root: Root, other: Root, points: Sequence[Point]) -> bool:
    """Whether a root is the one named, by algebra or at all points: simplification does not see every identity."""
    return all(
        symbol in root
        and (
            sympy.simplify(root[symbol] - value) == 0
            or all(_near(root[symbol], value, at_) for at_ in points)
        )
        for symbol, value in other.items()
    )


def _near(one: sympy.Expr, other: sympy.Expr, point: Point) -> bool:
    values = at(one, point), at(other, point)
    if not all(each.is_number and each.is_finite for each in values):
        return False
    return bool(abs(values[0] - values[1]) <= SAME * abs(values[0]))


def _real(root: Root, point: Point) -> bool:
    for value in root.values():
        if value.is_real:
            continue
        number = at(value, point)
        if number.is_finite is False or not _decided(
            abs(sympy.im(number)) < 1e-20, f"whether {value} is real"
        ):
            return False
    return True


def _holds(where: sympy.Basic, root: Root, point: Point) -> bool:
    # of a real root by a way through complex numbers rounding leaves an imaginary part
    numbers = {symbol: sympy.re(at(value, point)) for symbol, value in root.items()}
    there = with_values(point, root, numbers)
    truths = {
        relational: truth
        for relational in where.atoms(sympy.core.relational.Relational)
        if (truth := _truth(relational, root, there)) is not None
    }
    rest = where.xreplace(truths)
    return _decided(substitute(substitute(rest, numbers), point.values), f"where: {where}")


def _truth(relational: Any, root: Root, there: Point) -> sympy.Basic | None:
    """The truth of a relation of numbers; None where a side is none."""
    left, right = (at(side, there) for side in relational.args)
    if not (left.is_number and right.is_number and left.is_real and right.is_real):
        return None
    if abs(left - right) > EDGE * max(1, abs(left), abs(right)):
        return relational.func(left, right)
    # at the end of an arc cosine's range 30 digits alone may fall on either side of it
    gap = substitute(substitute(relational.lhs - relational.rhs, dict(root)), there.values)
    if sympy.simplify(gap) != 0:
        return None
    return sympy.true if isinstance(relational, sympy.Eq | sympy.Le | sympy.Ge) else sympy.false


def _decided(fits: sympy.Basic | bool, what: str) -> bool:
    """A truth that numbers have decided. Raises NoRoot when a letter without a value is left in it."""
    if fits not in (sympy.true, sympy.false):
        letters = _list(fits.free_symbols) if isinstance(fits, sympy.Basic) else ""
        raise NoRoot(f"{what} cannot be decided: {letters or fits} has no value here")
    return bool(fits)


def _formula(root: Root) -> str | None:
    """A root as a formula of the worked solution; None for one that has none, such as the complex roots of a cubic."""
    try:
        return ", ".join(
            f"${latex(Relation('=', Name(str(symbol)), tree(value)))}$" for symbol, value in root.items()
        )
    except NoTree:
        if any(value.has(sympy.I) for value in root.values()):
            return None
        raise


def _condition(where: sympy.Basic | bool) -> str:
    if isinstance(where, sympy.And):
        return r" \;\land\; ".join(map(_condition, where.args))
    try:
        return latex(relation(where))  # type: ignore[arg-type]
    except NoTree:
        return rf"\text{{{where}}}"


def _named(where: sympy.Basic | bool) -> str:
    """A condition in the letters that authors type."""
    if isinstance(where, bool) or where in (sympy.true, sympy.false):
        return "a condition that holds for no numbers"
    return as_typed(where)


def _equations(root: Root) -> str:
    return ", ".join(f"{symbol} = {as_typed(value)}" for symbol, value in root.items())


def _list(things: Sequence | set | frozenset) -> str:
    return ", ".join(sorted(map(str, things)))


def _count(number: int, what: str) -> str:
    return f"{number} {what}{'' if number == 1 else 's'}"


def exchanged(laws: tuple[Law, ...], mistake: Mistake[Exchange]) -> tuple[Law, ...]:
    """The laws of the step with one exchanged, or several. Raises NoRoot when it is not clear which."""
    wrong, instead = mistake.rule.laws, mistake.rule.instead
    if not wrong:
        raise NoRoot("it names no law; say which law was used wrongly")
    if not instead and len(laws) == 1:
        return wrong
    names = [stated.name for stated in laws]
    if not instead and not wrong[0].name:  # `wrong("K = m*v^2")` is about the law of K
        left = wrong[0].textbook.left
        places = [place for place, stated in enumerate(laws) if stated.textbook.left == left]
    else:
        wanted = instead or (wrong[0].name,)
        places = [place for place, name in enumerate(names) if name in wanted]
    if len(places) != max(1, len(instead)):
        raise NoRoot(
            f"say which law it takes the place of, instead of one of {', '.join(names)}, or a list of them"
        )
    others = [stated for place, stated in enumerate(laws) if place not in places]
    return (*others[: places[0]], *wrong, *others[places[0] :])
