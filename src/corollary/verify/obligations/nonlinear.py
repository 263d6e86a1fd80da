"""Proofs by z3: a claim's negation has no solution in real numbers of the box. Without the extra `proofs` nothing is proven here."""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction
from functools import reduce
from importlib import import_module
from importlib.util import find_spec
from typing import Any

from corollary.formula.ast import Expr, Name, Relation, names, opposite
from corollary.formula.errors import Undefined
from corollary.polynomials.polynomial import RationalFunction, TooLarge
from corollary.verify.obligations.algebra import Algebra
from corollary.verify.obligations.box import Box
from corollary.verify.obligations.obligation import Clause, Equations

STEPS = 4_000_000  # of z3's own count, about 2 s; what is proven of the chapter takes 120 000 at most
LONGEST_STEP = 60_000  # ms: for a step that does not count; a loaded machine must not decide what is proven
LONGEST = (
    400  # terms of a polynomial: nonlinear arithmetic is doubly exponential, and larger ones only time out
)


def installed() -> bool:
    """Whether z3 is there."""
    return find_spec("z3") is not None


class Query:
    """One question to z3: whether real numbers fulfil all that is said of them."""

    def __init__(self, algebra: Algebra, steps: int = STEPS) -> None:
        # only here: it takes a quarter of a second to load; it has no types
        self.z3: Any = import_module("z3")
        self.algebra = algebra
        self.context = algebra.translation.context
        self.alone: Any = self.z3.Context()  # else what was asked before changes how many steps it takes
        self.solver: Any = self.z3.SolverFor("QF_NRA", ctx=self.alone)
        self.solver.set("rlimit", steps)
        self.solver.set("timeout", LONGEST_STEP)
        self.letters: dict[str, Any] = {name: self.z3.Real(name, self.alone) for name in self.context.names()}

    def polynomial(self, polynomial: Any) -> Any:
        """Raises TooLarge."""
        if len(polynomial) > LONGEST:
            raise TooLarge
        letters = [self.letters[name] for name in self.context.names()]
        total = self.z3.RealVal(0, self.alone)
        for exponents, coefficient in polynomial.to_dict().items():
            factors = [letter for letter, n in zip(letters, exponents, strict=True) for _ in range(int(n))]
            total = total + reduce(lambda a, b: a * b, factors, self.z3.RealVal(int(coefficient), self.alone))
        return total

    def bounded(self) -> None:
        """What is known of the letters of the translation so far."""
        translation = self.algebra.translation
        for name, (low, high) in translation.known.items():
            if name in self.letters:
                letter = self.letters[name]
                if low is not None:
                    self.solver.add(letter > 0 if low == 0 and high is None else letter >= self.number(low))
                if high is not None:
                    self.solver.add(letter < 0 if high == 0 and low is None else letter <= self.number(high))
        for meaning, letter in translation.meanings.items():
            if meaning[0] == "root" and meaning[1] % 2 == 0:
                self.solver.add(self.letters[str(letter.top)] >= 0)
        for each in translation.relations:
            self.solver.add(self.polynomial(each) == 0)
        for each in translation.divisors:
            self.solver.add(self.polynomial(each) != 0)

    def number(self, value: Fraction) -> Any:
        return self.z3.RealVal(f"{value.numerator}/{value.denominator}", self.alone)

    def compared(self, gap: RationalFunction, sign: str) -> Any:
        """The quotient compared with zero, its bottom not zero."""
        top = self.polynomial(gap.top)
        below = self.algebra.sign(gap.bottom)
        signed = top * (below or self.polynomial(gap.bottom))
        if sign in ("=", "!="):
            return top == 0 if sign == "=" else top != 0
        return {"<": signed < 0, "<=": signed <= 0, ">": signed > 0, ">=": signed >= 0}[sign]

    def impossible(self) -> bool | None:
        """True: nothing fulfils it. False: something does. None: not decided."""
        found = self.solver.check()
        return True if found == self.z3.unsat else False if found == self.z3.sat else None

    def nearest(self, box: Box, letters: Sequence[str]) -> dict[str, int]:
        """The grid point next to the numbers that were found."""
        model, found = self.solver.model(), dict[str, int]()
        for name in letters:
            axis = box.axes[name]
            size = math.pi**axis.power
            wanted = float(axis.doubles[0]) * size
            if name in self.letters:
                value = model.eval(self.letters[name], model_completion=True)
                value = value.approx(12) if self.z3.is_algebraic_value(value) else value
                wanted = float(value.as_fraction())
            found[name] = int(abs(axis.doubles * size - wanted).argmin())
        return found


def no_exception(box: Box, need: Clause, steps: int = STEPS) -> bool | dict[str, int]:
    """True: one of the relations holds for all real numbers of the box that keep the conditions. Else False, or the grid point next to
    numbers for which none does."""
    letters, conditions = box.tied(need)
    try:
        algebra = Algebra(box, [*need, *conditions])
        gaps = [algebra.gap(each) for each in need]
        query = Query(algebra, steps)
        for each in conditions:
            query.solver.add(query.compared(algebra.gap(each), each.sign))
        query.bounded()
        for gap, each in zip(gaps, need, strict=True):
            query.solver.add(query.compared(gap, opposite(each).sign))
        impossible = query.impossible()
        return query.nearest(box, letters) if impossible is False else bool(impossible)
    except (TooLarge, Undefined, KeyError):
        return False


def only_root(box: Box, equations: Equations) -> bool:
    """Whether no other real numbers than those meant (and those rejected) fulfil equations and conditions, anywhere in the box."""
    every = [*equations.laws, *equations.where]
    roots = [equations.meant, *equations.rejected]
    _, conditions = box.tied(every)
    trees: list[Expr] = [tree for root in roots for tree in root.values()]
    free = names(*every, *trees) - box.axes.keys() - {"pi"}
    if free - set(equations.unknowns) or any(root.keys() < free for root in roots):
        return False
    try:
        algebra = Algebra(box, [*every, *conditions], [*trees, *map(Name, equations.unknowns)])
        query = Query(algebra)
        for each in (*every, *conditions):
            query.solver.add(query.compared(algebra.gap(each), each.sign))
        for root in roots:
            apart = [
                query.compared(algebra.gap(Relation("!=", Name(name), tree)), "!=")
                for name, tree in root.items()
                if name in free
            ]
            query.solver.add(query.z3.Or(*apart, query.alone))
        query.bounded()
        return query.impossible() is True
    except (TooLarge, Undefined, KeyError):
        return False
