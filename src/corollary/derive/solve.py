"""A derivation solved: each step's laws for its finds, with earlier finds left as letters, and closed in the givens."""

from __future__ import annotations

from typing import Any, assert_never

import sympy
from sympy.logic.boolalg import Boolean

from corollary.derive.errors import NotDerivable
from corollary.derive.load import Loaded, line_of, load, symbol_of
from corollary.derive.optimum import best
from corollary.derive.parts import answered, misfits, unsolved, words
from corollary.derive.point import Point, at, learn, point
from corollary.derive.roots import NoRoot, Root, exchanged, pick, roots, simplest
from corollary.derive.shown import shown, supposed_value
from corollary.derive.solution import (
    ChoiceTruth,
    ClosedForms,
    ExampleTruth,
    LeftOut,
    Measured,
    ProofTruth,
    RouteShown,
    Solution,
    SolvedUnknown,
    WrongRule,
)
from corollary.derive.statements import (
    Choice,
    Code,
    Example,
    Explain,
    Found,
    Mistake,
    Neglected,
    Optimum,
    Plot,
    Printed,
    Proof,
    Simulated,
    Step,
)
from corollary.formula.ast import Expr, Number
from corollary.formula.errors import ParseError
from corollary.formula.from_sympy import relation, tree
from corollary.laws.law import Law, sides
from corollary.laws.substitute import as_expression, put
from corollary.problem.bank import Bank
from corollary.problem.problem import Problem
from corollary.problem.sampling import sample
from corollary.problem.variant import chapter
from corollary.scenes.catalogue import SCENES
from corollary.units.dimensions import dimension_of
from corollary.units.unit import Dimension, called, show

POINTS = 6


def unproven(bank: Bank, problem: Problem) -> tuple[int, list[str]]:
    """The laws put back: how many equations vanish identically when every find is put in, and which do not. Raises NotDerivable."""
    solver = _Solver(problem, load(bank, problem))
    solver.solution()
    proven, left = 0, []
    for entry in solver.loaded.derivation.entries:
        found = entry.bound if isinstance(entry, Neglected) else entry
        if isinstance(found, Step):
            for stated in (*found.laws, *(law for way in found.routes for law in way.laws)):
                for one, other in sides(stated):
                    residual = put(put(one - other, solver.closed), solver.aside)
                    if sympy.simplify(sympy.expand(residual)) == 0:
                        proven += 1
                    elif not residual.free_symbols & solver.measured:
                        sentence = f"{stated.name} does not hold for the answers: {one} = {other}"
                        left.append(str(solver.failing(sentence, found.because)))
    return proven, left


def solve(bank: Bank, problem: Problem) -> Solution:
    """Everything that is true of a problem. Raises NotDerivable with file, line and what to do."""
    loaded = load(bank, problem)
    return _Solver(problem, loaded).solution()


class _Solver:
    """Walks the entries once; knows what has been found so far."""

    def __init__(self, problem: Problem, loaded: Loaded):
        self.problem, self.loaded = problem, loaded
        self.givens = [symbol_of(problem, given.symbol) for given in problem.givens]
        self.closed: dict[sympy.Symbol, sympy.Expr] = {symbol: symbol for symbol in self.givens}
        self.dimensions: dict[str, Dimension] = {
            given.symbol: given.unit.dimension for given in problem.givens
        }
        variants = [chapter(problem), *sample(problem, POINTS - 1, salt="roots")]
        self.points = [point(variant.exact, self.givens) for variant in variants]
        self.aside: dict[sympy.Symbol, sympy.Expr] = {}
        self.measured: set[sympy.Symbol] = set()

    def solution(self) -> Solution:
        for sentence, about in misfits(self.problem, self.loaded.derivation):
            raise self.failing(sentence, about)
        finds, choices, examples, proofs, later = [], {}, {}, {}, []
        for entry in self.loaded.derivation.entries:
            try:
                match entry:
                    case Step() | Optimum() | Simulated():
                        finds.append(self.find(entry))
                    case Choice():
                        choices[entry.part] = self.choice(entry)
                    case Example():
                        examples[entry.part] = self.example(entry)
                    case Proof():
                        proofs[entry.part] = self.proof(entry)
                    case Neglected():
                        later.append(entry)
                    case Code() | Plot() | Explain() | Printed():
                        continue
                    case _:
                        assert_never(entry)
            except ValueError as error:  # NoRoot and NoTree among them
                part = answered(entry)
                about = (
                    ", ".join(map(str, entry.finds))
                    if not part and isinstance(entry, Found)
                    else f"part {part}"
                )
                raise self.failing(f"{about}: {error}", words(entry)) from error
        left = tuple(
            map(self.left_out, later)
        )  # after all finds, so that none can lean on what is only supposed
        return Solution(
            self.problem, tuple(finds), choices, examples, proofs, unsolved(self.loaded.derivation), left
        )

    def left_out(self, entry: Neglected) -> LeftOut:
        try:
            values = tuple(map(supposed_value, entry.supposing))
            for supposition, value in zip(entry.supposing, values, strict=True):
                self.closed[supposition.symbol] = supposition.symbol
                self.dimensions[value.name] = value.dimension
                for each in self.points:
                    each.suppose(supposition.symbol, value.ratio)
            return LeftOut(entry.what, self.find(entry.bound), values, entry.asked)
        except ValueError as error:
            raise self.failing(
                f"what part {entry.bound.answers} neglects: {error}", entry.bound.because
            ) from error

    def failing(self, sentence: str, about: str = "") -> NotDerivable:
        return NotDerivable(self.loaded.path, self.line(about), sentence)

    def line(self, about: str) -> int:
        """The line of the solution that holds these words, or of derive."""
        return line_of(self.loaded.path, about) or self.loaded.line

    def find(self, entry: Step | Optimum | Simulated) -> SolvedUnknown:
        for symbol in entry.finds:
            if symbol.name in self.dimensions:
                raise NoRoot(f"{symbol} is given or found already; give the new find another letter")
        match entry:
            case Step():
                found = self.step(entry)
            case Optimum():
                found = self.optimum(entry)
            case Simulated():
                found = self.simulated(entry)
        self.dimensions |= dict(zip(found.names, found.dimensions, strict=True))
        return found

    def step(self, entry: Step) -> SolvedUnknown:
        picked = pick(self.roots(entry, entry.laws), self.numbers(), entry.where, entry.rejected)
        local = self.formulas(entry.finds, picked.root)
        routes = [
            self.formulas(
                entry.finds, pick(self.roots(entry, way.laws), self.numbers(), entry.where, ()).root
            )
            for way in entry.routes
        ]
        wrong = []
        for slip in entry.mistakes:
            wrong.append(self.wrong(entry, slip, exchanged(entry.laws, slip), entry.where))
        self.close(entry.finds, picked.root)
        self.aside |= {symbol: simplest(put(picked.root[symbol], self.closed)) for symbol in entry.also}
        return SolvedUnknown(
            names=tuple(symbol.name for symbol in entry.finds), answers=entry.answers, because=entry.because,
            laws=tuple(map(shown, entry.laws)), local=local, closed=self.closed_trees(entry.finds), routes=tuple(routes),
            routes_shown=tuple(RouteShown(way.because, tuple(map(shown, way.laws))) for way in entry.routes),
            mistakes=tuple(wrong), rejected=picked.refused, dimensions=self.checked(entry, local.trees),
            scale=None if entry.scale is None else tree(put(entry.scale, self.closed)), check=entry.check, note="",
        )  # fmt: skip

    def optimum(self, entry: Optimum) -> SolvedUnknown:
        goal = put(as_expression(entry.of), self.closed)
        value, note = best(goal, entry.over, entry.between, entry.largest, self.points)
        root = {entry.finds[0]: value}
        local = self.formulas(entry.finds, root)
        wrong = tuple(self.wrong(entry, slip, slip.laws, True) for slip in entry.mistakes)
        self.close(entry.finds, root)
        return SolvedUnknown(
            names=(entry.finds[0].name,), answers=entry.answers, because=entry.because, laws=(), local=local,
            closed=self.closed_trees(entry.finds), routes=(), routes_shown=(), mistakes=wrong, rejected=(),
            dimensions=self.checked(entry, local.trees), scale=None, check=entry.check, note=note,
        )  # fmt: skip

    def simulated(self, entry: Simulated) -> SolvedUnknown:
        if entry.scene not in SCENES:
            raise NoRoot(f"there is no scene {entry.scene}; there are {', '.join(SCENES)}")
        if strange := entry.settings.keys() - {setting.name for setting in SCENES[entry.scene].settings}:
            raise NoRoot(f"scene {entry.scene} has no setting {', '.join(sorted(strange))}")
        settings = {name: tree(value) for name, value in entry.settings.items()}
        part = self.problem.part(entry.answers)
        wrong = tuple(self.wrong(entry, slip, slip.laws, True) for slip in entry.mistakes)
        self.measured |= set(entry.finds)
        return SolvedUnknown(
            names=tuple(symbol.name for symbol in entry.finds), answers=entry.answers, because=entry.because, laws=(),
            local=Measured(entry.scene, settings, entry.observe), closed=None, routes=(), routes_shown=(), mistakes=wrong, rejected=(),
            dimensions=(part.unit.dimension,) * len(entry.finds), scale=None, check=entry.check, note="",
        )  # fmt: skip

    def wrong(
        self, entry: Step | Optimum | Simulated, slip: Mistake, laws: tuple[Law, ...], where: Boolean | bool
    ) -> WrongRule:
        """What the find becomes by a mistake; `where` chooses only among several roots, for a mistake need not respect it."""
        found = self.roots(entry, laws)
        root = found[0] if len(found) == 1 else pick(found, self.numbers(), where, ()).root
        return WrongRule(slip.text, self.formulas(entry.finds, root))

    def choice(self, entry: Choice) -> ChoiceTruth:
        letters = {option.letter for option in self.problem.part(entry.part).options}
        if letters != entry.options.keys():
            raise NoRoot(
                f"its options are {', '.join(sorted(letters))}; give each of them, and no other, its condition"
            )
        options = {}
        for letter, condition in entry.options.items():
            held = put(sympy.sympify(condition), self.closed)
            options[letter] = bool(held) if held in (sympy.true, sympy.false) else relation(held)
        return ChoiceTruth(options, entry.because, entry.mistakes)

    def example(self, entry: Example) -> ExampleTruth:
        """Counts how many unknowns the laws leave free, for an example must leave room for the student's own."""
        equations = [
            sympy.simplify(put(left - right, self.closed))
            for stated in entry.laws
            for left, right in sides(stated)
        ]
        independent = sympy.Matrix(equations).jacobian(list(entry.finds)).rank()
        if len(entry.finds) - independent != entry.free:
            raise NoRoot(
                f"{len(equations)} laws for {len(entry.finds)} unknowns leave {len(entry.finds) - independent} free, not {entry.free}"
            )
        apart = tuple(
            (tuple(tree(put(value, self.closed)) for value in values), why) for values, why in entry.apart
        )
        names = tuple(symbol.name for symbol in entry.finds)
        return ExampleTruth(
            names,
            tuple(map(shown, entry.laws)),
            apart,
            tree(put(entry.scale, self.closed)),
            entry.because,
            entry.free,
            self.instance(entry, equations),
        )

    def instance(self, entry: Example, equations: list[sympy.Expr]) -> tuple[Expr, ...] | None:
        """One good example: the first unknowns set to simple shares of the scale, the others solved for."""
        scale = put(entry.scale, self.closed)
        for share in (sympy.Rational(-1, 3), sympy.Rational(1, 2), sympy.Integer(2), sympy.Rational(1, 5)):
            fixed: dict[sympy.Symbol, Any] = dict.fromkeys(entry.finds[: entry.free], share * scale)
            others = list(entry.finds[entry.free :])
            for root in (
                sympy.solve([put(equation, fixed) for equation in equations], others, dict=True)
                if others
                else [{}]
            ):
                whole = fixed | root
                if all(
                    symbol in whole and not whole[symbol].free_symbols - set(self.closed)
                    for symbol in entry.finds
                ) and all(at(value, each).is_real for value in whole.values() for each in self.points):
                    return tuple(tree(simplest(whole[symbol])) for symbol in entry.finds)
        return None

    def proof(self, entry: Proof) -> ProofTruth:
        target = shown(entry.target).here[0]
        wrong = tuple((shown(stated).here[0], slip.text) for slip in entry.mistakes for stated in slip.laws)
        return ProofTruth(tuple(map(shown, entry.laws)), target, entry.lines, wrong, entry.because)

    def roots(self, entry: Step | Optimum | Simulated, laws: tuple[Law, ...]) -> list[Root]:
        also = entry.also if isinstance(entry, Step) else ()
        return roots(laws, [*entry.finds, *also], set(self.closed) | self.measured)

    def numbers(self) -> list[Point]:
        """The sample points, with the values of what has been found."""
        for each in self.points:
            for find, value in self.closed.items():
                if find not in each.values:
                    learn(each, find, value)
        return self.points

    def formulas(self, finds: tuple[sympy.Symbol, ...], root: Root) -> ClosedForms:
        return ClosedForms(tuple(tree(simplest(root[symbol])) for symbol in finds))

    def close(self, finds: tuple[sympy.Symbol, ...], root: Root) -> None:
        for symbol in finds:
            self.closed[symbol] = simplest(put(root[symbol], self.closed))

    def closed_trees(self, finds: tuple[sympy.Symbol, ...]) -> tuple[Expr, ...] | None:
        if any(self.closed[symbol].free_symbols & self.measured for symbol in finds):
            return None
        return tuple(tree(self.closed[symbol]) for symbol in finds)

    def checked(self, entry: Step | Optimum, trees: tuple[Expr, ...]) -> tuple[Dimension, ...]:
        """The dimension of each component; raises ValueError when it is not what the part asks for."""
        part = (
            self.problem.part(entry.answers)
            if entry.answers in {part.id for part in self.problem.parts}
            else None
        )
        found: list[Dimension | None] = []
        for formula in trees:
            dimension = dimension_of(formula, self.dimensions)
            if isinstance(dimension, ParseError):
                raise ValueError(f"the dimensions do not fit: {dimension.why}")
            found.append(None if isinstance(formula, Number) and formula.value == 0 else dimension)
        nought = (
            part.unit.dimension if part else next((each for each in found if each is not None), Dimension())
        )
        result = tuple(
            nought if each is None else each for each in found
        )  # a component that is 0 measures what the others do
        for dimension in result:
            if part and dimension != part.unit.dimension:
                raise ValueError(
                    f"the answer is not in {show(part.unit) or 'plain numbers'}, it is {called(dimension)}"
                )
        return result
