"""Assumptions while a derivation is solved: closed forms so far, signs, and what the conditions say of letters."""

# pyright: reportUnknownArgumentType=false, reportUnknownLambdaType=false, reportUnknownMemberType=false, reportUnknownVariableType=false

from __future__ import annotations

from collections.abc import Collection, Hashable, Mapping
from copy import copy
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import lru_cache, reduce
from typing import Any, cast

import sympy
from sympy.core.function import AppliedUndef

from corollary.derive.given_signs import symbol_of
from corollary.derive.solution import ClosedForms, SolvedFunction, SupposedValue
from corollary.derive.statements import Each
from corollary.formula.ast import Expr, Number, Relation, names
from corollary.formula.ast import substitute as put_in
from corollary.formula.authored import as_expression
from corollary.formula.ball import RationalPi, Undefined, evaluate, holds
from corollary.formula.errors import ParseError
from corollary.formula.from_sympy import NoTree, tree
from corollary.formula.syntax import author_formula
from corollary.laws.law import substitute
from corollary.problem.problem import Problem
from corollary.problem.sampling import sample
from corollary.problem.variant import Variant, chapter, written_apart
from corollary.units.dimensional_analysis import Dimension, dimension_of


def logarithms_together(expr: sympy.Expr) -> sympy.Expr:
    """The same where every logarithm in it is real: those added with the same factor are one, of a product or quotient.

    `ln(2^x)` is x ln 2, and `-ln(A/B)` is ln(B/A).
    """
    if not expr.args or not expr.has(sympy.log):
        return expr
    inner: Any = expr.func(*(logarithms_together(cast(sympy.Expr, each)) for each in expr.args))
    match inner:
        case sympy.log(args=(sympy.Pow(base=base, exp=exp),)) if base.is_positive:
            return exp * sympy.log(base)
        case sympy.Add():
            return _added(inner)
        case sympy.Mul() if inner.could_extract_minus_sign():
            return _turned(inner)
        case _:
            return inner


def _added(total: sympy.Add) -> sympy.Expr:
    """Terms with one logarithm each, grouped by what stands beside it but for a rational number."""
    groups: dict[Any, list[tuple[Any, Any]]] = {}
    rest: list[Any] = []
    for term in total.args:
        factors: tuple[Any, ...] = sympy.Mul.make_args(term)
        logs = [each for each in factors if isinstance(each, sympy.log)]
        if len(logs) == 1:
            number, beside = sympy.Mul(*(each for each in factors if each is not logs[0])).as_coeff_Mul()
            if number.is_Rational:
                groups.setdefault(beside, []).append((number, logs[0].args[0]))
                continue
        rest.append(term)
    if all(len(group) == 1 for group in groups.values()):
        return total
    return sympy.Add(*rest, *(beside * _one(group) for beside, group in groups.items()))


def _one(group: list[tuple[Any, Any]]) -> sympy.Expr:
    """The sum of numbers times logarithms as one logarithm; a number before it where all have it."""
    common = reduce(sympy.gcd, (abs(number) for number, _argument in group))
    product = sympy.Mul(*(argument ** (number / common) for number, argument in group))
    return _turned(common * sympy.log(product))


def _turned(product: Any) -> Any:
    """A minus before the logarithm of a quotient, put into it."""
    logs = [each for each in sympy.Mul.make_args(product) if isinstance(each, sympy.log)]
    if len(logs) != 1 or not product.could_extract_minus_sign():
        return product
    argument: Any = logs[0].args[0]
    if sympy.fraction(argument)[1].is_number:
        return product
    return -product.xreplace({logs[0]: sympy.log(1 / argument)})


DIGITS, BITS = 30, 128
ENOUGH = 100  # bits: 30 digits; a ball that knows fewer is left to sympy, which adds precision until it knows
POINTS = 6  # the chapter's numbers and five more: a condition that holds at all is taken to tell roots apart everywhere
NEARLY_WHOLE = 1e-9  # of the end of a range
MANY = 200  # draws, to find points in a case that holds for few
Root = Mapping[sympy.Symbol, sympy.Expr]


@dataclass(frozen=True, slots=True)
class Point:
    """A value for every letter, for sympy and, many times faster, for our own evaluation."""

    values: dict[sympy.Symbol, sympy.Expr]
    balls: dict[str, Any]
    written: Mapping[str, str]
    """The givens as a student reads them."""


def point(variant: Variant, symbols: list[sympy.Symbol]) -> Point:
    """The point of a variant."""
    givens = variant.exact
    exact = {symbol: in_sympy(givens[symbol.name]) for symbol in symbols}
    return Point(exact, dict(givens), written_apart(variant))


def in_sympy(value: RationalPi) -> sympy.Expr:
    """The exact number."""
    return sympy.Rational(value.ratio.numerator, value.ratio.denominator) * sympy.pi**value.pi


def at(expression: object, where: Point) -> Any:
    """The expression's value at a point, to 30 digits; complex, infinite or undecided as sympy has it where we have none."""
    formula = _tree(sympy.sympify(expression))
    if formula is not None:
        ball = _ball(formula, where, BITS)
        if ball is not None and ball.is_finite() and ball.rel_accuracy_bits() > ENOUGH:
            return sympy.Float(ball.str(DIGITS, radius=False), DIGITS)
    return substitute(sympy.sympify(expression), where.values).evalf(DIGITS)


def with_values(where: Point, root: Root, numbers: Mapping[sympy.Symbol, Any]) -> Point:
    """The point with the letters of a root, too; `numbers` are their values to 30 digits."""
    balls = dict(where.balls)
    for symbol, value in root.items():
        formula = _tree(value)
        if formula is not None and (ball := _ball(formula, where, 2 * BITS)) is not None:
            balls[symbol.name] = ball
    return replace(where, values={**where.values, **numbers}, balls=balls)


@dataclass(frozen=True, slots=True)
class FoundFunction:
    """A function found: its formula in its own letter, in givens and in unknowns.

    `form` is the kind of equation it solves ("": none), `place` somewhere it is taken, which measures what its letter does.
    """

    applied: sympy.Expr
    formula: sympy.Expr
    form: str
    place: sympy.Expr

    @property
    def name(self) -> str:
        return str(self.applied.func)

    @property
    def letter(self) -> sympy.Symbol:
        """What it depends on."""
        return cast(sympy.Symbol, self.applied.args[0])

    def put_into(self, expression: Any) -> Any:
        """The formula in place of the function, wherever it is taken."""
        if not expression.has(self.applied.func):
            return expression
        return expression.replace(
            lambda each: isinstance(each, AppliedUndef) and each.func == self.applied.func,
            lambda each: substitute(self.formula, {self.letter: each.args[0]}),
        )


class Known:
    """The givens, and each unknown as soon as it is found."""

    def __init__(self, problem: Problem, ways: tuple[tuple[Relation, ...], ...] = ()):
        """Raises ValueError where no number drawn satisfies the relations of one of these ways, where there are any."""
        givens = [symbol_of(problem, each.symbol) for each in problem.letters]
        self.formulas: dict[sympy.Symbol, sympy.Expr] = {symbol: symbol for symbol in givens}
        self.variables = {each.symbol for each in problem.variables}
        self.aside: dict[sympy.Symbol, sympy.Expr] = {}  # unknowns that laws needed and nobody asks for
        self.measured: set[sympy.Symbol] = set()
        self.functions: list[FoundFunction] = []
        self.solved: dict[Hashable, Any] = {}  # differential equations, by all that decides their solution
        self.dimensions: dict[str, Dimension] = {each.symbol: each.unit.dimension for each in problem.letters}
        drawn = MANY if ways else POINTS - 1
        variants = [chapter(problem), *sample(problem, drawn, salt="roots")]
        fitting = [
            each
            for each in variants
            if not ways or any(all(holds(one, each.exact) for one in way) for way in ways)
        ]
        if not fitting:
            raise ValueError(
                f"it holds for none of {len(variants)} draws; correct its condition, or the ranges"
            )
        self._points = [point(variant, givens) for variant in fitting[:POINTS]]

    def copied(self) -> Known:
        """The same, so that what is found from here on does not change this."""
        found = copy(self)
        found.formulas, found.aside, found.measured = (
            dict(self.formulas),
            dict(self.aside),
            set(self.measured),
        )
        found.functions, found.dimensions = list(self.functions), dict(self.dimensions)
        found._points = [
            replace(each, values=dict(each.values), balls=dict(each.balls)) for each in self._points
        ]
        return found

    def numbered(self, each: Each) -> Known:
        """The same with the letter of a range, which is the first, the last and a middle number at the points. Raises ValueError."""
        found = self.copied()
        found.formulas[each.letter] = each.letter
        found.dimensions[each.letter.name] = Dimension()
        points: list[Point] = []
        for one in self.points:
            low, high = (at(end, one) for end in (each.low, each.high))
            if not all(
                end.is_number and end.is_real and abs(end - round(end)) < NEARLY_WHOLE for end in (low, high)
            ):
                raise ValueError(
                    f"{each.letter} goes from {each.low} to {each.high}; both ends are whole numbers, such as floor({each.high})"
                )
            first, last = (int(sympy.floor(end + sympy.Rational(1, 2))) for end in (low, high))
            for number in sorted({first, (first + last) // 2, last} if first <= last else ()):
                whole = sympy.Integer(number)
                points.append(
                    replace(
                        one,
                        values={**one.values, each.letter: whole},
                        balls={**one.balls, each.letter.name: RationalPi(Fraction(number))},
                        written={**one.written, each.letter.name: str(number)},
                    )
                )
        if not points:
            raise ValueError(
                f"there is no {each.letter} from {each.low} to {each.high} for any of the numbers tried"
            )
        found._points, found.solved = points, {}
        return found

    @property
    def letters(self) -> set[sympy.Symbol]:
        return set(self.formulas) | self.measured

    @property
    def givens(self) -> set[sympy.Symbol]:
        """The letters that stand for themselves."""
        return {symbol for symbol, formula in self.formulas.items() if formula == symbol}

    @property
    def names(self) -> set[str]:
        """All letters that have a value, those that nobody asks for too."""
        return {symbol.name for symbol in (*self.letters, *self.aside)}

    @property
    def points(self) -> list[Point]:
        """The sample points, with the values of what has been found."""
        for each in self._points:
            for symbol, value in self.formulas.items():
                if symbol not in each.values:
                    each.values[symbol] = at(value, each)
                    formula = _tree(value)
                    if formula is not None and (ball := _ball(formula, each, 2 * BITS)) is not None:
                        each.balls[symbol.name] = ball
        return self._points

    def refuse_variables(self, letters: Collection[str], remedy: str, but: Collection[str] = ()) -> None:
        """Raises ValueError where letters stand for what depends on a variable that a part is not a formula of."""
        formulas = [formula for symbol, formula in self.formulas.items() if symbol.name in letters]
        depends = {each.name for formula in formulas for each in self.with_functions(formula).free_symbols}
        for name in sorted((depends | {*letters}) & self.variables - {*but}):
            raise ValueError(f"it depends on {name}, which is a variable{remedy.format(variable=name)}")

    @property
    def some_function(self) -> str:
        """The name of a function for an example."""
        return next((each.name for each in self.functions), "x")

    def found(self, unknowns: tuple[sympy.Symbol, ...], root: Root) -> None:
        """Closes the unknowns in the givens."""
        for symbol in unknowns:
            self.formulas[symbol] = simplest(self.in_givens(root[symbol]))

    def solved_function(self, each: FoundFunction) -> SolvedFunction:
        """The function in our own terms; its dimension is that of its formula. Raises ValueError where that has none."""
        letter, place = each.letter.name, tree(each.place)
        if letter not in self.dimensions and names(place) <= self.dimensions.keys() | {"pi"}:
            (self.dimensions[letter],) = self.dimensions_of((place,), None)
        formula = tree(each.formula)
        if names(formula) <= self.dimensions.keys() | {"pi"}:
            (self.dimensions[each.name],) = self.dimensions_of((formula,), None)
        measured = {name: self.dimensions[name] for name in (letter, each.name) if name in self.dimensions}
        return SolvedFunction(each.name, letter, formula, each.form, measured)

    def suppose(self, value: SupposedValue) -> None:
        """Adds a value that no given has."""
        symbol = sympy.Symbol(value.stated.name, positive=True)
        self.formulas[symbol], self.solved = symbol, {}
        self.dimensions[symbol.name] = value.dimension
        for each in self._points:
            each.values[symbol] = sympy.Rational(value.ratio.numerator, value.ratio.denominator)
            each.balls[symbol.name] = RationalPi(value.ratio)

    def in_givens(self, expression: Any) -> Any:
        """An expression or relation with all that has been found put in."""
        return substitute(self.with_functions(expression), self.formulas)

    def with_functions(self, expression: Any) -> Any:
        """The same with the formulas of functions found in their places, not yet derived or integrated."""
        for each in self.functions:
            expression = each.put_into(expression)
        return expression

    def with_asides(self, expression: Any) -> Any:
        """The same with the unknowns put in, too, that laws needed and nobody asks for."""
        return substitute(self.in_givens(expression), self.aside)

    def in_givens_alone(self, stated: Any) -> Any:
        """The same of an expression or a condition that an author states. Raises ValueError where it has another letter, or one that is
        measured."""
        found = self.with_asides(sympy.sympify(stated))
        if strange := found.free_symbols - self.givens:
            names = ", ".join(sorted(map(str, strange)))
            raise ValueError(f"{names} is neither given nor derived before")
        return found

    def as_written(self, condition: Any) -> tuple[tuple[Relation, ...], ...]:
        """A relation that is true of all numbers, with its sides in givens, as clauses; none of a condition that joins several."""
        if not isinstance(condition, sympy.core.relational.Relational):
            return ()
        stated = cast("Any", condition)
        left, right = (tree(self.with_asides(side)) for side in (stated.lhs, stated.rhs))
        return ((Relation(str(stated.rel_op).replace("==", "="), left, right),),)

    def relation_in_givens(self, text: str) -> Relation:
        """A relation as it is written, of which nothing is simplified, with all that has been found put in. Raises ValueError."""
        stated = author_formula(text)
        found = {symbol.name: tree(formula) for symbol, formula in (self.formulas | self.aside).items()}
        if not isinstance(stated, Relation):
            raise ValueError(f"{text} is not a comparison; write a relation with <, <=, >, >= or !=")
        if strange := names(stated) - found.keys() - {"pi"}:
            raise ValueError(f"{', '.join(sorted(strange))} is neither given nor derived before")
        return Relation(stated.sign, put_in(stated.left, found), put_in(stated.right, found))

    def tree_in_givens(self, expression: object) -> Expr:
        return tree(self.in_givens(as_expression(expression)))

    def formulas_of(self, unknowns: tuple[sympy.Symbol, ...]) -> tuple[Expr, ...] | None:
        """The closed forms; None where they rest on what was measured."""
        if any(self.formulas[symbol].free_symbols & self.measured for symbol in unknowns):
            return None
        return tuple(tree(self.formulas[symbol]) for symbol in unknowns)

    def dimensions_of(self, trees: tuple[Expr, ...], expected: Dimension | None) -> tuple[Dimension, ...]:
        """The dimension of each component; one that is 0 has what is asked for, or what the others have.

        Raises ValueError where a formula adds what cannot be added.
        """
        found: list[Dimension | None] = []
        for formula in trees:
            dimension = dimension_of(formula, self.dimensions)
            if isinstance(dimension, ParseError):
                raise ValueError(f"the dimensions do not fit: {dimension.why}")
            found.append(None if isinstance(formula, Number) and formula.value == 0 else dimension)
        zero = (
            expected
            if expected is not None
            else next((each for each in found if each is not None), Dimension())
        )
        return tuple(zero if each is None else each for each in found)


def forms(unknowns: tuple[sympy.Symbol, ...], root: Root) -> ClosedForms:
    """The root of some laws as formulas."""
    return ClosedForms(tuple(tree(simplest(root[symbol])) for symbol in unknowns))


@lru_cache(maxsize=4096)
def simplest(expr: sympy.Expr) -> sympy.Expr:
    """The shortest of a few equal forms; a form already short is left alone."""
    forms = [expr]
    if sympy.count_ops(expr) > 2:
        forms.append(sympy.factor(expr))
        together = sympy.together(expr)
        if (
            sympy.together(together) != together
        ):  # else factoring, which begins with that, gives the same again
            forms.append(sympy.factor(together))
        forms.append(sympy.simplify(expr))
    if expr.has(sympy.log):
        forms = [logarithms_together(form) for form in forms]
    return min(forms, key=lambda form: (sympy.count_ops(form), len(str(form))))  # pyright: ignore[reportReturnType]


@lru_cache(maxsize=1024)
def vanishes(residual: sympy.Expr) -> bool:
    """Whether an expression is zero whatever its letters are, as far as algebra sees it."""
    if (multiplied_out := sympy.simplify(sympy.expand(residual))) == 0:
        return True
    as_it_is = sympy.simplify(residual)
    return 0 in (as_it_is, _with_reduced_radicands(as_it_is), _with_reduced_radicands(multiplied_out))


def _with_reduced_radicands(expression: sympy.Expr) -> sympy.Basic:
    """The expression with what stands below each root as one fraction in lowest terms: so one root written twice cancels."""
    return expression.replace(
        lambda part: part.is_Pow and part.exp.is_Rational and not part.exp.is_Integer,
        lambda root: sympy.cancel(root.base) ** root.exp,
    )


def _ball(formula: Expr, where: Point, bits: int) -> Any:
    """The value as a ball; None where it has no real value, or a letter has none."""
    try:
        return evaluate(formula, where.balls, bits)
    except (Undefined, KeyError):
        return None


@lru_cache(maxsize=4096)
def _tree(expression: sympy.Expr) -> Expr | None:
    try:
        return tree(expression)
    except NoTree:
        return None
