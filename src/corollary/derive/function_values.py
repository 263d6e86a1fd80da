"""Laws with derivatives and integrals made into equations between numbers: the functions in them are found, and put back."""

# pyright: reportMissingTypeArgument=false, reportUnknownArgumentType=false, reportUnknownLambdaType=false, reportUnknownMemberType=false, reportUnknownParameterType=false, reportUnknownVariableType=false, reportArgumentType=false, reportAttributeAccessIssue=false, reportAssignmentType=false, reportReturnType=false, reportGeneralTypeIssues=false, reportIndexIssue=false, reportCallIssue=false, reportOperatorIssue=false

from __future__ import annotations

from collections.abc import Callable, Hashable, Mapping, Sequence
from dataclasses import replace
from itertools import combinations
from typing import Any

import sympy
from sympy.core.function import AppliedUndef

from corollary.derive.assumptions import FoundFunction, Known, at
from corollary.derive.differential import Generally, NotSolved, generally, generic
from corollary.derive.improper import by_quadrature, improper, refuse_divergent
from corollary.derive.sampled import holds, numbered
from corollary.laws.law import Law, sides, substitute

Pair = tuple[sympy.Expr, sympy.Expr]
"""The two sides of an equation."""

QUADRATURE = 1e-9  # relative: an integral in formulas against one by quadrature


def is_differential(pairs: Sequence[Pair]) -> bool:
    """Whether equations hold functions, derivatives or integrals."""
    return any(side.has(AppliedUndef, sympy.Derivative, sympy.Integral) for pair in pairs for side in pair)


def eliminated(
    laws: Sequence[Law], unknowns: Sequence[sympy.Symbol], known: Known
) -> tuple[list[Pair], tuple[FoundFunction, ...]]:
    """Equations between numbers that are left when the functions in laws are found, and these. Raises ValueError where they cannot be."""
    pairs = [pair for law in laws for pair in sides(law)]
    named = {value_of(each.applied) for each in known.functions}
    if not is_differential(pairs) and not named & {*unknowns}:
        return pairs, ()
    return _Elimination(laws, pairs, unknowns, known).result()


def put_back(expression: sympy.Expr, functions: Sequence[FoundFunction]) -> sympy.Expr:
    """The expression with the functions put in, derived and integrated."""
    for each in functions:
        expression = each.put_into(expression)
    return generic(expression.doit())


class _Elimination:
    """Functions are found one after the other: stated outright, from a differential equation, or by algebra from one another."""

    def __init__(
        self, laws: Sequence[Law], pairs: Sequence[Pair], unknowns: Sequence[sympy.Symbol], known: Known
    ):
        self.known, self.unknowns = known, set(unknowns)
        self.in_order = tuple(unknowns)
        self.laws, self.own = laws, functions_in(laws)
        self.pairs = [(self._with_known(left), self._with_known(right)) for left, right in pairs]
        self.functions: list[FoundFunction] = []
        self.places = [place for pair in self.pairs for side in pair for place in self._places(side)]

    def result(self) -> tuple[list[Pair], tuple[FoundFunction, ...]]:
        waiting = {
            each.func: self.own[each.func]
            for pair in self.pairs
            for side in pair
            for each in _functions_of(side)
        }
        while waiting:
            one = self._outright(waiting) or self._solved(waiting)
            found = [one] if one else self._coupled(waiting)
            if not found and (one := self._by_algebra(waiting)):
                found = [one]
            if not found:
                names = ", ".join(sorted(f"{each}" for each in waiting.values()))
                raise ValueError(
                    f"these laws do not determine {names}; state one differential equation for each function"
                )
            for each in found:
                del waiting[each.applied.func]
                self.functions = [
                    replace(earlier, formula=put_back(earlier.formula, [each])) for earlier in self.functions
                ] + [each]
                self.pairs = [(each.put_into(left), each.put_into(right)) for left, right in self.pairs]
        self.pairs += self._asked_for()
        return self._left(), tuple(self.functions)

    def _asked_for(self) -> list[Pair]:
        """The functions that are themselves what the step finds: each unknown with the formula of the function of its name."""
        every = {value_of(each.applied): each for each in (*self.known.functions, *self.functions)}
        return [(each, every[each].formula) for each in self.in_order if each in every]

    def _with_known(self, side: sympy.Expr) -> sympy.Expr:
        """With the functions known already, and what was found in givens where that is derived or integrated."""
        side = self.known.with_functions(side)
        for node in side.atoms(sympy.Derivative, sympy.Integral):
            inside, over = node.args[0], node.args[1][0]
            if not inside.has(over):
                in_givens = self.known.in_givens(inside)
                if isinstance(node, sympy.Derivative) and not in_givens.has(over):
                    raise ValueError(
                        f"{inside} does not depend on {over}, so its derivative is zero; "
                        f'make it a function: {inside} = function("{inside}", {over})'
                    )
                side = side.xreplace({node: node.func(in_givens, *node.args[1:])})
        return side

    def _outright(self, waiting: Mapping[Any, sympy.Expr]) -> FoundFunction | None:
        """`x = A*cos(w*t)`, `v = dx/dt`: a function alone on one side, and not on the other."""
        for index, (left, right) in enumerate(self.pairs):
            for one, other in ((left, right), (right, left)):
                if (
                    one in waiting.values()
                    and other not in self.unknowns
                    and not any(each.func == one.func for each in _functions_of(other))
                ):
                    del self.pairs[index]
                    return FoundFunction(
                        one, other.doit() if not other.has(AppliedUndef) else other, "", self._place(one)
                    )
        return None

    def _solved(self, waiting: Mapping[Any, sympy.Expr]) -> FoundFunction | None:
        """A differential equation of one function, with its initial values."""
        for index, (left, right) in enumerate(self.pairs):
            residual = left - right
            free = {each.func for each in self._free(residual)} & waiting.keys()
            if len(free) != 1 or {each.func for each in _functions_of(residual)} - free:
                continue
            y = waiting[free.pop()]
            if not residual.has(sympy.Derivative):
                continue
            del self.pairs[index]
            return self._with_conditions([residual], [y])[0]
        return None

    def _coupled(self, waiting: Mapping[Any, sympy.Expr]) -> list[FoundFunction]:
        """Two differential equations of the same two functions, with their initial values."""
        residuals = {index: left - right for index, (left, right) in enumerate(self.pairs)}
        for one, other in combinations((k for k, each in residuals.items() if each.has(sympy.Derivative)), 2):
            both = residuals[one], residuals[other]
            free = {each.func for residual in both for each in self._free(residual)} & waiting.keys()
            there = {each.func for residual in both for each in _functions_of(residual)}
            if len(free) != 2 or there != free or any(not self._free(each) for each in both):
                continue
            functions = [waiting[each] for each in sorted(free, key=str)]
            if len({each.args[0] for each in functions}) == 1:
                self.pairs = [pair for k, pair in enumerate(self.pairs) if k not in (one, other)]
                return self._with_conditions(both, functions)
        return []

    def _with_conditions(
        self, residuals: Sequence[sympy.Expr], functions: Sequence[sympy.Expr]
    ) -> list[FoundFunction]:
        """One function or two, with what its differential equation and its initial values make of it. Raises ValueError."""
        x, names = functions[0].args[0], " and ".join(str(y.func) for y in functions)
        conditions = [pair for pair in self.pairs if self._is_condition(pair, functions)]
        conditions.sort(key=lambda pair: bool((pair[0] - pair[1]).free_symbols & self.unknowns))
        start = next(
            (place for pair in conditions for side in pair for place in self._places(side)), sympy.S.Zero
        )
        about = (
            tuple(residuals),
            tuple(functions),
            tuple(self.known.formulas.items()),
            tuple(self.known.functions),
        )
        solution: Generally = self._once(
            ("general", start, *about), self._general, residuals, functions, x, start
        )
        order = len(solution.values)
        if len(conditions) < order:
            raise ValueError(
                f"the differential equation for {names} is of order {order} and needs {order} "
                f"initial value{'s' * (order > 1)}, such as {functions[0].func}(0) = …; stated {'is' if len(conditions) == 1 else 'are'} {len(conditions)}"
            )
        used = conditions[:order]
        letters = frozenset(letters_in(self.laws, self.known))
        self.pairs = [pair for pair in self.pairs if not any(pair is each for each in used)]
        decides = "found", *about, start, tuple(used), tuple(self.places), letters
        return self._once(decides, self._with_values, residuals, functions, solution, used, start)

    def _once(self, decided_by: Hashable, make: Callable[..., Any], *of: Any) -> Any:
        """What is made of a differential equation, made before where all that decides it is the same: of the bends of a law `verify`
        tries, few change the equations that take long."""
        solved = self.known.solved
        if decided_by not in solved:
            solved[decided_by] = make(*of)
        return solved[decided_by]

    def _general(
        self,
        residuals: Sequence[sympy.Expr],
        functions: Sequence[sympy.Expr],
        x: sympy.Symbol,
        start: sympy.Expr,
    ) -> Generally:
        try:
            return generally(residuals, functions, x, start, self._sign)
        except NotSolved as error:
            names = " and ".join(str(y.func) for y in functions)
            raise ValueError(f"the differential equation for {names} cannot be solved: {error}") from None

    def _with_values(
        self,
        residuals: Sequence[sympy.Expr],
        functions: Sequence[sympy.Expr],
        solution: Generally,
        used: Sequence[Pair],
        start: sympy.Expr,
    ) -> list[FoundFunction]:
        """The functions of a general solution that begin as the conditions say."""
        x, names = functions[0].args[0], " and ".join(str(y.func) for y in functions)
        by_values = [
            FoundFunction(y, formula, solution.form, start)
            for y, formula in zip(functions, solution.formulas, strict=True)
        ]
        conditions = [left - right for left, right in used]
        equations = [
            self._once(("put back", each, tuple(by_values)), put_back, each, by_values) for each in conditions
        ]
        roots = sympy.solve(equations, list(solution.values), dict=True)
        if len(roots) != 1 or len(roots[0]) != len(solution.values):
            raise ValueError(f"the initial values of {names} do not fix all of the motion")
        found = [
            FoundFunction(y, solution.shortest(substitute(each, roots[0]), x), solution.form, self._place(y))
            for y, each in zip(functions, solution.formulas, strict=True)
        ]
        for equation in (*residuals, *conditions):
            if not self._holds(put_back(equation, found)):
                raise ValueError(
                    f"the solution found for {names} does not satisfy {equation} = 0; state the law in another form"
                )
        return found

    def _is_condition(self, pair: Pair, functions: Sequence[sympy.Expr]) -> bool:
        """Whether an equation is about these functions at places that are known, and about no other."""
        both = pair[0] - pair[1]
        found_here = _functions_of(both)
        places = [place for side in pair for place in self._places(side)]
        return (
            bool(places)
            and not self._free(both)
            and {each.func for each in found_here} <= {y.func for y in functions}
            and not any(
                place.free_symbols & (self.unknowns | {functions[0].args[0]} - self.known.letters)
                for place in places
            )
        )

    def _by_algebra(self, waiting: Mapping[Any, sympy.Expr]) -> FoundFunction | None:
        """A function that stands underived in an equation with others."""
        for index, (left, right) in enumerate(self.pairs):
            residual = left - right
            derived = {each.func for node in residual.atoms(sympy.Derivative) for each in _functions_of(node)}
            for each in sorted(self._free(residual), key=str):
                if each.func not in waiting or each.func in derived:
                    continue
                roots = sympy.solve(residual, each)
                if len(roots) == 1:
                    del self.pairs[index]
                    return FoundFunction(each, roots[0], "", self._place(each))
        return None

    def _left(self) -> list[Pair]:
        """The equations that found no function, between numbers."""
        left: list[Pair] = []
        letters = letters_in(self.laws, self.known)
        for pair in self.pairs:
            for side in pair:
                refuse_divergent(self.known.with_functions(side))
            sides = tuple(map(self._worked_out, pair))
            for before, after in zip(pair, sides, strict=True):
                if after.has(sympy.Integral, sympy.Derivative):
                    raise ValueError(f"{before} has no closed form")
                if before.has(sympy.Integral):
                    decides = before, after, tuple(self.known.formulas.items()), tuple(self.known.functions)
                    self._once(("quadrature", *decides), self._check_quadrature, before, after)
            if strange := (sides[0] - sides[1]).free_symbols & letters:
                if self._holds(sides[0] - sides[1]):
                    continue  # it only repeats what has been found
                name = next(iter(strange))
                raise ValueError(f"{name} is not a number here; say where, as in {self.functions[0].name}(0)")
            left.append((sides[0], sides[1]))
        if len(left) < len(self.unknowns) and (solved := [each for each in self.functions if each.form]):
            raise ValueError(
                f"too few laws; add the initial value of {solved[0].name}, such as {solved[0].name}(0) = …"
            )
        return left

    def _worked_out(self, side: sympy.Expr) -> sympy.Expr:
        """A side with its derivatives and integrals in formulas, where these have any."""
        integrals = side.atoms(sympy.Integral)
        outer = [
            each for each in integrals if not any(other != each and other.has(each) for other in integrals)
        ]
        done = {each: self._once(("integral", each), each.doit) for each in outer}
        formula = side.xreplace(done)
        return generic(formula if formula.has(sympy.Integral) else formula.doit())

    def _free(self, side: sympy.Expr) -> set[sympy.Expr]:
        """Functions at any time: not at a place, nor under an integral from one to another."""
        dull = {node: sympy.Dummy() for node in side.atoms(sympy.Integral, sympy.Subs)}
        return {each for each in _functions_of(side.xreplace(dull)) if each == self.own[each.func]}

    def _places(self, side: sympy.Expr) -> list[sympy.Expr]:
        """Where functions are evaluated, and between which limits integrated."""
        found_here = sorted(_functions_of(side), key=str)
        values = [each.args[0] for each in found_here if each != self.own[each.func]]
        points = [place for node in side.atoms(sympy.Subs) for place in node.point]
        limits = [
            limit
            for node in side.atoms(sympy.Integral)
            for limit in node.limits[0][1:]
            if limit.is_finite is not False
        ]
        return [*values, *points, *limits]

    def _place(self, y: sympy.Expr) -> sympy.Expr:
        """Somewhere a function is evaluated that is not zero, if it is anywhere."""
        return next((place for place in self.places if place != 0 and place.is_finite), y.args[0])

    def _sign(self, expression: sympy.Expr) -> int | None:
        """The same at all sample points, or None."""
        simple = sympy.factor(expression)
        if simple == 0 or simple.is_zero:
            return 0
        if simple.is_positive or simple.is_negative:
            return 1 if simple.is_positive else -1
        signs: set[int] = set()
        for point in self.known.points:
            number = at(self.known.in_givens(simple), point)
            if not number.is_real:
                return None
            signs.add(int(sympy.sign(number)))
        return signs.pop() if len(signs) == 1 else None

    def _holds(self, residual: sympy.Expr) -> bool:
        return holds(residual, self.known, letters_in(self.laws, self.known), self.places)

    def _check_quadrature(self, before: sympy.Expr, after: sympy.Expr) -> None:
        """An integral in formulas is what quadrature gives. Raises ValueError where it is not."""
        point = self.known.points[0]
        one, other = (
            substitute(numbered(self.known.in_givens(each), point), point.values) for each in (before, after)
        )
        one = one.xreplace({node: sympy.Float(by_quadrature(node)) for node in improper(one)})
        one, other = one.evalf(15), other.evalf(15)
        if not abs(one - other) <= QUADRATURE * abs(other):
            raise ValueError(f"{before} was found to be {after}, which it is not; state it in another form")


def value_of(meaning: object) -> sympy.Symbol | None:
    """The unknown that stands for a function at any time, U for U(t); None where the letter means something else."""
    return sympy.Symbol(str(meaning.func), real=True) if isinstance(meaning, AppliedUndef) else None


def functions_in(laws: Sequence[Law]) -> dict[Any, sympy.Expr]:
    """The functions that letters of laws mean, as they were named: v(t) by v."""
    meanings = (meaning for law in laws for meaning in law.letters.values())
    parts = (part for meaning in meanings for part in (meaning if isinstance(meaning, tuple) else (meaning,)))
    return {each.func: each for part in parts for each in _functions_of(part)}


def letters_in(laws: Sequence[Law], known: Known) -> set[sympy.Symbol]:
    """What the functions in laws depend on, where it is no given."""
    return {each.args[0] for each in functions_in(laws).values()} - known.letters


def _functions_of(side: sympy.Expr) -> set[sympy.Expr]:
    """Functions, wherever they are evaluated."""
    return side.atoms(AppliedUndef)
