"""Enumeration of small grids by code of its own: random claims and laws, and what is true of them at every point."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from itertools import product
from pathlib import Path
from random import Random
from typing import Any

from flint import arb, ctx, fmpq

from corollary.formula.ast import Relation as AST
from corollary.formula.ast import opposite, substitute
from corollary.formula.syntax import author_formula
from corollary.problem.reader import read_problem
from corollary.verify.obligations.box import Box
from corollary.verify.obligations.obligation import Equations, Obligation, Settled
from corollary.verify.obligations.settle import Settling

BITS = 320
Tree = tuple[Any, ...]
"""("n", Fraction), ("x", letter), or (operator, tree, …)."""
Number = Fraction | arb
SIGNS = ("<", "<=", ">", ">=", "=", "!=")
FACTORS = (2, 3, -1, Fraction(1, 2), Fraction(-2, 3))


class NoValue(ArithmeticError):
    """A formula without a value at a point."""


def written(tree: Tree) -> str:
    """The formula as an author types it."""
    kind, *below = tree
    match kind:
        case "n":
            (value,) = below
            return (
                f"({value.numerator}/{value.denominator})"
                if value.denominator > 1
                else f"({value.numerator})"
            )
        case "x":
            return below[0]
        case "+" | "-" | "*" | "/" | "^":
            return f"({f' {kind} '.join(map(written, below))})"
        case _:
            return f"{kind}({', '.join(map(written, below))})"


def value(tree: Tree, at: dict[str, Any]) -> Number:
    """A fraction where all of it is rational, else a ball. Raises NoValue."""
    kind, *below = tree
    if kind == "n":
        return below[0]
    if kind == "x":
        return at[below[0]]
    of = [value(each, at) for each in below]
    if all(isinstance(each, Fraction) for each in of) and (exact := _rational(kind, of)) is not None:
        return exact
    return _ball(kind, [_as_ball(each) for each in of], of)


def _rational(kind: str, of: list[Any]) -> Fraction | None:
    match kind, of:
        case "+", [a, b]:
            return a + b
        case "-", [a, b]:
            return a - b
        case "*", [a, b]:
            return a * b
        case "/", [a, b]:
            if b == 0:
                raise NoValue
            return a / b
        case "^", [a, b] if b.denominator == 1:
            if a == 0 and b < 0:
                raise NoValue
            return a**b.numerator
        case "abs", [a]:
            return abs(a)
        case "sqrt", [a]:
            if a < 0:
                raise NoValue
            top, bottom = (_square_root(each) for each in (a.numerator, a.denominator))
            return Fraction(top, bottom) if top is not None and bottom is not None else None
        case (("sin" | "tan" | "asin" | "atan"), [Fraction(numerator=0)]):
            return Fraction(0)
        case (("cos" | "exp"), [Fraction(numerator=0)]):
            return Fraction(1)
        case "ln", [Fraction(numerator=1, denominator=1)]:
            return Fraction(0)
        case _:
            return None


def _square_root(whole: int) -> int | None:
    root = int(fmpq(whole).numerator.isqrt())
    return root if root * root == whole else None


def _ball(kind: str, of: list[arb], exact: list[Any]) -> arb:
    a, b = of[0], of[-1]
    match kind:
        case "+":
            return a + b
        case "-":
            return a - b
        case "*":
            return a * b
        case "/":
            if exact[1] == 0:
                raise NoValue
            return a / b
        case "^":
            if isinstance(exact[1], Fraction) and exact[1].denominator == 1:
                return a ** arb(exact[1].numerator)
            if a < 0:
                raise NoValue
            return a**b
        case "abs":
            return abs(a)
        case "sqrt":
            if a < 0:
                raise NoValue
            return a.sqrt()
        case "ln":
            if a <= 0:
                raise NoValue
            return a.log()
        case "asin":
            if abs(a) > 1:
                raise NoValue
            return a.asin()
        case _:
            return getattr(a, kind)()


def _as_ball(number: Number) -> arb:
    return arb(fmpq(number.numerator, number.denominator)) if isinstance(number, Fraction) else number


def compared(sign: str, left: Tree, right: Tree, at: dict[str, Any]) -> bool | None:
    """Whether a relation holds at a point; what has no value does not. None where balls do not tell."""
    try:
        gap = value(("-", left, right), at)
    except NoValue:
        return False
    if isinstance(gap, Fraction) or gap.is_zero():
        return {"<": gap < 0, "<=": gap <= 0, ">": gap > 0, ">=": gap >= 0, "=": gap == 0, "!=": gap != 0}[
            sign
        ]
    if not gap.is_finite() or gap.contains(0):
        return None
    return (gap < 0) == (sign in ("<", "<=")) if sign not in ("=", "!=") else sign == "!="


@dataclass(frozen=True)
class Relation:
    sign: str
    left: Tree
    right: Tree

    @property
    def text(self) -> str:
        return f"{written(self.left)} {self.sign} {written(self.right)}"

    def at(self, point: dict[str, Any]) -> bool | None:
        return compared(self.sign, self.left, self.right, point)

    def has_value(self, point: dict[str, Any]) -> bool:
        try:
            value(("-", self.left, self.right), point)
        except NoValue:
            return False
        return True


@dataclass(frozen=True)
class Grid:
    """Givens with few values each, and the conditions among them."""

    axes: dict[str, tuple[Fraction, ...]]
    lines: tuple[str, ...]
    conditions: tuple[Relation, ...]

    def points(self, doubtful: bool = False) -> Iterator[dict[str, Fraction]]:
        """All that certainly keep the conditions; or those, too, for which balls do not decide that."""
        for values in product(*self.axes.values()):
            point = dict(zip(self.axes, values, strict=True))
            kept = [each.at(point) for each in self.conditions]
            if all(each or (doubtful and each is None) for each in kept):
                yield point

    def problem(self, folder: Path):
        """The problem that deals these numbers."""
        where = "".join(f'  - "{each.text}"\n' for each in self.conditions)
        text = "---\ncode: X1.1\ntitle: A box\ngiven:\n" + "\n".join(self.lines) + "\n"
        text += (
            f"where:\n{where}" if where else ""
        ) + '---\nA box.\n\n## Number {#a .value unit="1"}\nHow much?\n'
        (folder / "x.md").write_text(text, encoding="utf-8")
        return read_problem(folder / "x.md")


def grid(rng: Random) -> Grid:
    """Two givens or three, of integers, halves or a list; some with zero or negative numbers among them."""
    axes, lines = dict[str, tuple[Fraction, ...]](), list[str]()
    for name in "abc"[: rng.choice((1, 2, 2, 3))]:
        if rng.random() < 0.25:
            values = tuple(sorted(map(Fraction, rng.sample(range(-3, 9), rng.choice((2, 3, 4))))))
            grid_text = f"in: [{', '.join(map(str, values))}]"
        else:
            step = Fraction(rng.choice((1, 1, 2, 3)), rng.choice((1, 2)))
            start = Fraction(rng.choice((1, 1, 1, 2, 0, -2)))
            values = tuple(start + step * place for place in range(rng.choice((2, 4, 5))))
            grid_text = f"from: {float(values[0]):g}, to: {float(values[-1]):g}, step: {float(step):g}"
        axes[name] = values
        lines.append(f"  {name}: {{is: number {name}, value: {float(values[0]):g}, {grid_text}, unit: 1}}")
    letters = list(axes)
    conditions = [
        relation(rng, letters, 1, ("<", "<=", ">", ">=", "!=")) for _ in range(rng.choice((0, 0, 0, 1, 1, 2)))
    ]
    return Grid(axes, tuple(lines), tuple(each for each in conditions if "'x'" in repr(each)))


def relation(rng: Random, letters: list[str], depth: int, signs: tuple[str, ...] = SIGNS) -> Relation:
    """A random claim; one in three is nearly true of all numbers, where it is that provers differ."""
    left = tree(rng, letters, depth)
    kind = rng.random()
    if kind < 0.2:  # a factor that cancels
        factor = tree(rng, letters, 1)
        return Relation(
            rng.choice((">", ">=", "!=", "=")),
            ("/", ("*", left, factor), factor),
            left if kind < 0.1 else ("n", Fraction(0)),
        )
    if kind < 0.35:  # what is never negative, where it has a value
        square = ("^", left, ("n", Fraction(2))) if rng.random() < 0.6 else ("abs", left)
        return Relation(rng.choice((">=", ">")), square, ("n", Fraction(rng.choice((0, 0, -1)))))
    right = ("n", Fraction(rng.randint(-2, 6))) if rng.random() < 0.6 else tree(rng, letters, depth - 1)
    return Relation(rng.choice(signs), left, right)


def tree(rng: Random, letters: list[str], depth: int) -> Tree:
    if depth <= 0 or rng.random() < 0.15:
        return (
            ("x", rng.choice(letters))
            if rng.random() < 0.8
            else ("n", Fraction(rng.choice((1, 2, 3, *FACTORS))))
        )
    below = tree(rng, letters, depth - 1)
    match rng.choice("++--***//^^sfg"):
        case "^":
            power = Fraction(rng.choice((2, 2, 3, -1, -2)))
            return (
                ("^", below, ("n", power)) if rng.random() < 0.9 else ("^", below, ("x", rng.choice(letters)))
            )
        case "s":
            return ("sqrt", below)
        case "f":
            return (rng.choice(("sin", "cos", "abs", "exp", "atan")), below)
        case "g":
            return (rng.choice(("ln", "tan", "asin", "sqrt")), below)
        case sign:
            return (sign, below, tree(rng, letters, depth - 1))


def claim_judged(rng: Random, folder: Path) -> tuple[str, str]:
    """A random clause on a random grid, settled: the outcome with its prover, and how enumeration contradicts it ("" where it does not)."""
    ctx.prec = BITS
    box = grid(rng)
    letters = list(box.axes)
    clause = [relation(rng, letters, rng.choice((1, 2, 2, 3))) for _ in range(rng.choice((1, 1, 1, 2)))]
    redrawn, partial = rng.random() < 0.15, rng.random() < 0.15
    needs = tuple(parsed(each) for each in clause)
    settling = Settling(Box(box.problem(folder)))
    points = list(box.points())
    about = f"{' or '.join(each.text for each in clause)} on {box}"
    if partial:  # what must hold wherever it has a value
        found = settling.prove(needs, partial=True)
        if isinstance(found, str) and found:
            false = [
                at for at in points if all(each.at(at) is False and each.has_value(at) for each in clause)
            ]
            return f"partial: {found}", f"{found} proves {about}, false at {false[0]}" if false else ""
        return "partial: not proven", ""
    settled = settling.settle(
        Obligation("not zero" if redrawn else "claimed", "it", 1, (needs,), redrawn=redrawn)
    )
    return f"{settled.outcome}: {settled.by.split(' (')[0]}", _fault(settled, box, clause, about)


def _fault(settled: Settled, box: Grid, clause: list[Relation], about: str) -> str:
    points, possible = list(box.points()), list(box.points(doubtful=True))
    if settled.outcome == "proven":
        if not possible:
            return f"{about}: proven of no numbers"
        false = [at for at in points if all(each.at(at) is False for each in clause)]
        return f"{settled.by} proves {about}, which is false at {false[0]}" if false else ""
    if settled.outcome == "counter-example":
        shown = {name: Fraction(text.replace("−", "-")) for name, text in settled.numbers.items()}
        here = [at for at in possible if shown.items() <= at.items()]
        if not shown or not any(not any(each.at(at) for each in clause) for at in here):
            return f"{about} is not a counter-example at {shown}"
    return ""


def root_judged(rng: Random, folder: Path) -> tuple[str, str]:
    """Random laws with a known root, settled, and how solving them at every point of the grid contradicts that."""
    ctx.prec = BITS
    box = grid(rng)
    laws = _linear_laws(rng, box) if rng.random() < 0.5 else _polynomial_law(rng, box)
    equations = Equations(
        tuple(map(parsed, laws.relations)),
        tuple(laws.meant),
        {name: author_formula(written(each)) for name, each in laws.meant.items()},
        (),
        tuple(map(parsed, laws.where)),
        tuple({name: author_formula(written(each))} for name, each in laws.others),
    )
    solution_of = {**equations.meant}
    needs = tuple((_put(parsed(each), solution_of),) for each in laws.where)
    partial = tuple(
        (
            AST("=", author_formula(written(each)), equations.meant[name]),
            *(opposite(_put(parsed(one), {name: author_formula(written(each))})) for one in laws.where),
            *(() if laws.where else (AST("!=", *2 * (author_formula(written(each)),)),)),
        )
        for name, each in laws.others
    )
    owed = Obligation("one root", "it", 1, needs, equations, partial)
    settled = Settling(Box(box.problem(folder))).settle(owed)
    points, possible = list(box.points()), list(box.points(doubtful=True))
    about = f"{[each.text for each in laws.relations]} with {laws.meant} on {box}"
    outcome = f"{settled.outcome}: {settled.by.split('; ')[-1]}"
    if settled.outcome == "proven":
        several = [at for at in points if laws.several(at)]
        fault = f"{settled.by} proves one root of {about}, of several at {several[0]}" if several else ""
        return outcome, fault or ("" if possible else f"{about}: proven of no numbers")
    if settled.outcome == "counter-example":
        shown = {name: Fraction(text.replace("−", "-")) for name, text in settled.numbers.items()}
        if not any(laws.several(at) or laws.broken(at) for at in possible if shown.items() <= at.items()):
            return outcome, f"{about} has one root at {shown}"
    return outcome, ""


@dataclass(frozen=True)
class Laws:
    """Equations whose roots are known otherwise: of a linear system by elimination at each point, of a product by its factors."""

    relations: tuple[Relation, ...]
    meant: dict[str, Tree]
    where: tuple[Relation, ...]
    others: tuple[tuple[str, Tree], ...]
    coefficients: tuple[tuple[Tree, ...], ...]

    def several(self, at: dict[str, Fraction]) -> bool:
        """Whether it is certain that more than one root fulfils the laws and the conditions."""
        try:
            rows = [[value(each, at) for each in row] for row in self.coefficients]
            meant = {name: value(each, at) for name, each in self.meant.items()}
        except NoValue:
            return False
        if self.others:  # leading coefficient times distances
            ((leading,),) = rows
            if leading == 0:
                return self._admits(at, [{name: away} for name in meant for away in AWAY])
            return any(
                compared("!=", each, self.meant[name], at) and self._keeps(at, {name: value(each, at)})
                for name, each in self.others
            )
        if any(not isinstance(each, Fraction) for row in rows for each in row):
            return False
        direction = _null_direction(rows)
        if direction is None:
            return False
        if len(meant) == 1:  # any number
            return self._admits(at, [{name: away} for name in meant for away in AWAY])
        if any(not isinstance(each, Fraction) for each in meant.values()):
            return False
        return self._admits(
            at,
            [
                {name: each + away * by for (name, each), by in zip(meant.items(), direction, strict=True)}
                for away in AWAY
            ],
        )

    def _admits(self, at: dict[str, Fraction], roots: list[dict[str, Number]]) -> bool:
        return any(
            all(each.at({**at, **root}) is not False for each in self.relations) and self._keeps(at, root)
            for root in roots
        )

    def _keeps(self, at: dict[str, Fraction], root: dict[str, Number]) -> bool:
        return all(each.at({**at, **root}) for each in self.where)

    def broken(self, at: dict[str, Fraction]) -> bool:
        """Whether the root that is meant does not keep its conditions."""
        try:
            meant = {name: value(each, at) for name, each in self.meant.items()}
        except NoValue:
            return True
        return any(each.at({**at, **meant}) is False for each in self.where)


AWAY = tuple(Fraction(sign * each, 7) for each in (1, 7, 100) for sign in (1, -1))


def _linear_laws(rng: Random, box: Grid) -> Laws:
    """One law or two, whose root is put in: coefficients that may vanish together somewhere."""
    letters, unknowns = list(box.axes), ("x", "y")[: rng.choice((1, 1, 2))]
    meant = {name: tree(rng, letters, 1) for name in unknowns}
    rows = tuple(
        tuple(_polynomial(rng, letters) for _ in unknowns)
        for _ in range(len(unknowns) + (rng.random() < 0.2))
    )
    relations = list[Relation]()
    for row in rows:
        left, right = (
            _total([("*", factor, of(name)) for factor, name in zip(row, unknowns, strict=True)])
            for of in (lambda name: ("x", name), meant.__getitem__)
        )
        if rng.random() < 0.2:
            divisor = tree(rng, letters, 1)
            left, right = ("/", left, divisor), ("/", right, divisor)
        relations.append(Relation("=", left, right))
    return Laws(tuple(relations), meant, (), (), rows)


def _polynomial_law(rng: Random, box: Grid) -> Laws:
    """A coefficient times the distances from two roots, of which a condition may name one."""
    letters = list(box.axes)
    roots = [tree(rng, letters, 1), tree(rng, letters, 1)]
    leading = _polynomial(rng, letters)
    distances = ("*", ("-", ("x", "x"), roots[0]), ("-", ("x", "x"), roots[1]))
    law = Relation("=", ("*", leading, distances), ("n", Fraction(0)))
    where = (
        (Relation(rng.choice((">", ">=", "<")), ("x", "x"), tree(rng, letters, 0)),)
        if rng.random() < 0.8
        else ()
    )
    return Laws((law,), {"x": roots[0]}, where, (("x", roots[1]),), ((leading,),))


def _polynomial(rng: Random, letters: list[str]) -> Tree:
    one = ("x", rng.choice(letters)) if rng.random() < 0.8 else ("n", Fraction(rng.randint(1, 3)))
    other = ("x", rng.choice(letters)) if rng.random() < 0.7 else ("n", Fraction(rng.randint(-2, 4)))
    return (rng.choice("+-*"), one, other) if rng.random() < 0.8 else one


def _total(terms: list[Tree]) -> Tree:
    return terms[0] if len(terms) == 1 else ("+", terms[0], _total(terms[1:]))


def _null_direction(rows: list[list[Any]]) -> tuple[Fraction, ...] | None:
    """Of one column or two, a direction along which all rows vanish."""
    if len(rows[0]) == 1:
        return (Fraction(1),) if not any(row[0] for row in rows) else None
    first = next((row for row in rows if any(row)), None)
    if first is None:
        return Fraction(1), Fraction(0)
    along = (-first[1], first[0])
    return along if not any(row[0] * along[0] + row[1] * along[1] for row in rows) else None


def parsed(each: Relation) -> AST:
    return AST(each.sign, author_formula(written(each.left)), author_formula(written(each.right)))


def _put(each: AST, meaning: dict[str, Any]) -> AST:
    return AST(each.sign, substitute(each.left, meaning), substitute(each.right, meaning))
