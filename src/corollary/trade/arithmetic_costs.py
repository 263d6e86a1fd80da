"""Closed forms in every arithmetic: how fast a value comes, and how many last places it is off."""

# pyright: reportUnknownArgumentType=false, reportUnknownMemberType=false, reportUnknownVariableType=false

from __future__ import annotations

import math
import statistics
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from itertools import islice
from typing import Any

import numpy as np

from corollary.formula.arithmetics import DOUBLES, Arithmetic, NotAvailable, arrays, ready
from corollary.formula.ast import Expr, names
from corollary.formula.ball import RationalPi, Undefined, certified
from corollary.grading.solutions import Solutions
from corollary.problem.bank import chapter_bank, load
from corollary.problem.sampling import sample
from corollary.trade.double_double import PI, DoubleDouble, root

PAIRS = Arithmetic("double-double", DoubleDouble.of, PI, lambda row: {"sqrt": root, "abs": abs}.get(row.name))
QUICK = ("X12.5", "X12.2", "X12.7", "X12.12")
VARIANTS = 64


@dataclass(frozen=True, slots=True)
class Formula:
    """A closed form of the bank, some variants' givens, and the nearest double to the true value at each of them."""

    label: str
    tree: Expr
    givens: tuple[dict[str, RationalPi], ...]
    true: tuple[float, ...]


@dataclass(frozen=True, slots=True)
class ArithmeticRace:
    """`values` evaluates a formula at all its givens; preparing them is not timed, since all ways begin with other numbers."""

    name: str
    prepare: Callable[[Formula], Any]
    values: Callable[[Formula, Any], list[float]]


def intervals() -> Arithmetic:
    """Pairs of doubles that hold the value between them; made when asked for, since mpmath takes a while to load."""
    import mpmath

    iv: Any = mpmath.iv
    iv.prec = 53
    return Arithmetic(
        "intervals",
        lambda value: iv.mpf(value.numerator) / iv.mpf(value.denominator),
        iv.pi,
        lambda row: getattr(iv, "fabs" if row.name == "abs" else row.name, None),
        lambda a, b: a**b,
    )


def measured(quick: bool = False) -> list[dict[str, Any]]:
    """One record for each arithmetic: formulas it can do, values in a second, median and worst error in ulp, and where."""
    formulas = list(_formulas(quick))
    return [_record(way, formulas) for way in _ways()]


def _formulas(quick: bool) -> Iterator[Formula]:
    """Every closed form of the bank; of four problems when it must be quick."""
    bank = chapter_bank()
    known = Solutions(bank)
    for problem in load(bank):
        if quick and problem.code not in QUICK:
            continue
        solution = known.of(problem)
        variants = list(islice(sample(solution.problem, VARIANTS), VARIANTS))
        for place in solution.unknowns:
            for name, tree in zip(place.names, place.in_givens or (), strict=False):
                if not names(tree) - {"pi"}:
                    continue
                met = []
                for variant in variants:
                    try:
                        met.append((variant.exact, certified(tree, variant.exact).value))
                    except Undefined:
                        continue
                if met:
                    yield Formula(
                        f"{problem.code}: {name}",
                        tree,
                        tuple(at for at, _ in met),
                        tuple(value for _, value in met),
                    )


def _ways() -> list[ArithmeticRace]:
    between = intervals()
    return [
        _one_by_one(DOUBLES, _double),
        ArithmeticRace(
            arrays().name,
            _arrays,
            lambda formula, at: np.broadcast_to(at[0](at[1]), len(formula.true)).tolist(),
        ),
        _one_by_one(PAIRS, _pair),
        _one_by_one(between, lambda given: between.number(given.ratio) * between.pi**given.pi),
        ArithmeticRace(
            "certified balls",
            lambda formula: None,
            lambda formula, _: [certified(formula.tree, at).value for at in formula.givens],
        ),
    ]


def _one_by_one(arithmetic: Arithmetic, number: Callable[[RationalPi], Any]) -> ArithmeticRace:
    def prepare(formula: Formula) -> Any:
        return ready(formula.tree, arithmetic), [
            {name: number(given) for name, given in at.items()} for at in formula.givens
        ]

    def values(formula: Formula, prepared: Any) -> list[float]:
        run, rows = prepared
        return [_middle(run(at)) for at in rows]

    return ArithmeticRace(arithmetic.name, prepare, values)


def _arrays(formula: Formula) -> Any:
    letters = formula.givens[0].keys()
    return ready(formula.tree, arrays()), {
        name: np.array([_double(at[name]) for at in formula.givens]) for name in letters
    }


def _double(given: RationalPi) -> float:
    return float(given.ratio) * math.pi**given.pi


def _pair(given: RationalPi) -> DoubleDouble:
    return DoubleDouble.of(given.ratio) * PI**given.pi


def _middle(value: Any) -> float:
    """An interval's middle; any other number as it is."""
    return (
        value
        if isinstance(value, float)
        else float(value.mid)
        if not isinstance(value, DoubleDouble)
        else float(value)
    )


def _record(way: ArithmeticRace, formulas: list[Formula]) -> dict[str, Any]:
    errors: list[float] = []
    worst, where, count, spent, done = 0.0, "", 0, 0.0, 0
    for formula in formulas:
        try:
            prepared = way.prepare(formula)
        except NotAvailable:
            continue
        way.values(formula, prepared)  # warm
        begin = time.thread_time()
        found = way.values(formula, prepared)
        spent += time.thread_time() - begin
        count, done = count + 1, done + len(found)
        for value, true in zip(found, formula.true, strict=True):
            if true == 0.0:
                continue
            off = abs(value - true) / math.ulp(true)
            errors.append(off)
            if off > worst:
                worst, where = off, formula.label
    return {
        "arithmetic": way.name,
        "formulas": count,
        "values": done,
        "values_per_second": done / max(spent, 1e-9),
        "median_ulp": statistics.median(errors),
        "worst_ulp": worst,
        "worst": where,
    }
