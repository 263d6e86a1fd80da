"""The microseconds of one formula: read, given its dimension, worked out to the nearest double; of one unit, one quantity, one calculation.

python benchmarks/arithmetic.py
"""

from __future__ import annotations

import statistics
import time
from collections.abc import Callable
from fractions import Fraction

from corollary.answers.quantity import read_quantity
from corollary.formula.ball import RationalPi, certified
from corollary.formula.syntax import author_formula, parse
from corollary.units.dimensional_analysis import dimension_of
from corollary.units.unit import read_unit, unit

FORMULA = "2*m*v*sin(theta)/dt"
GIVENS = {"m": ("0.43", "kg"), "v": ("20", "m/s"), "theta": ("0.5", "rad"), "dt": ("0.1", "s")}
ROUNDS, TIMES = 20, 50


def microseconds(run: Callable[[], object]) -> float:
    """The median over several rounds, once warm."""
    run()
    spent: list[float] = []
    for _ in range(ROUNDS):
        start = time.perf_counter()
        for _ in range(TIMES):
            run()
        spent.append(1e6 * (time.perf_counter() - start) / TIMES)
    return statistics.median(spent)


def main() -> None:
    tree = author_formula(FORMULA)
    exact = {name: RationalPi(Fraction(value)) for name, (value, _) in GIVENS.items()}
    dimensions = {name: unit(text).dimension for name, (_, text) in GIVENS.items()}
    force = unit("N")
    measured: dict[str, Callable[[], object]] = {
        "the nearest double of a formula": lambda: certified(tree, exact),
        "a student's formula read": lambda: parse("2mv sin θ/Δt", GIVENS),
        "its dimension": lambda: dimension_of(tree, dimensions),
        "a unit read": lambda: read_unit("kg m/s^2"),
        "a quantity read": lambda: read_quantity("8,6 kg m/s²", force),
        "a calculation with units": lambda: read_quantity("80 kg * 16.7 m/s / 0.4 s", force),
        "a unit mistyped": lambda: read_unit("newtn"),
    }
    for what, run in measured.items():
        print(f"{what:<34}{microseconds(run):9.1f} µs")


if __name__ == "__main__":
    main()
