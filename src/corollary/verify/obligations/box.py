"""The numbers that a problem can deal, as a box: a grid for each given, a domain for each variable, and the conditions among them."""

# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false, reportUnknownArgumentType=false

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property

import numpy as np

from corollary.formula.ast import ZERO, Name, Relation, names
from corollary.formula.ball import holds
from corollary.formula.errors import Undefined
from corollary.formula.rational_pi import RationalPi
from corollary.problem.axes import axes
from corollary.problem.given import Given
from corollary.problem.interval_filter import GivenAtPoints, Interval, holding
from corollary.problem.problem import Problem
from corollary.problem.variable import Variable
from corollary.problem.variant import figures_of, number

PI = (Fraction(314159265358979, 10**14), Fraction(314159265358980, 10**14))
INTERVALS_OF_DOMAIN = 1024  # of one variable: halved ten times
MOST_VALUES = 1_000_000  # of one given: a grid that is finer is not walked


@dataclass(frozen=True)
class GridOfGiven:
    """A given with all its values, in SI and rising."""

    given: Given

    @cached_property
    def order(self) -> Sequence[int]:
        """The places of the grid, by rising value."""
        grid = self.given.grid
        if grid.values:
            return sorted(range(grid.count), key=lambda place: grid[place])
        return range(grid.count) if grid.step >= 0 else range(grid.count - 1, -1, -1)

    @cached_property
    def exact(self) -> list[RationalPi]:
        return [RationalPi(*self.given.unit.to_si(self.given.grid[place])) for place in self.order]

    @cached_property
    def doubles(self) -> np.ndarray:
        """Without the power of pi, which `power` is."""
        return np.array([float(each.ratio) for each in self.exact])

    @property
    def power(self) -> int:
        return next((each.pi for each in self.exact if each.ratio), 0)

    @property
    def count(self) -> int:
        return self.given.grid.count

    @property
    def bounds(self) -> tuple[Fraction, Fraction]:
        """Fractions between which all values lie."""
        low, high = self.exact[0], self.exact[-1]
        ends = [each.ratio * pi**each.pi for each in (low, high) for pi in PI]
        return min(ends), max(ends)


@dataclass(frozen=True)
class DomainOfVariable:
    """All real numbers from one end of a variable's domain to the other, in SI: so many intervals that lie side by side. A place is
    one of them, or, where points are tried, its middle, which belongs to the domain whatever the ends do."""

    given: Variable
    power: int = 0

    @property
    def count(self) -> int:
        return INTERVALS_OF_DOMAIN

    @cached_property
    def exact(self) -> Sequence[RationalPi]:
        low, high = self.bounds
        width = (high - low) / self.count
        return [RationalPi(low + width * (place + Fraction(1, 2))) for place in range(self.count)]

    @cached_property
    def doubles(self) -> np.ndarray:
        """The middles of the intervals."""
        return np.array([float(each.ratio) for each in self.exact])

    @cached_property
    def edges(self) -> np.ndarray:
        """The ends of the intervals, one more than these."""
        low, high = self.bounds
        width = (high - low) / self.count
        return np.array([float(low + width * place) for place in range(self.count + 1)])

    @cached_property
    def bounds(self) -> tuple[Fraction, Fraction]:
        """Fractions between which all values lie."""
        pairs = [self.given.unit.to_si(end) for end in (self.given.first, self.given.last)]
        ends = [ratio * pi**power for ratio, power in pairs for pi in PI]
        return min(ends), max(ends)

    @property
    def conditions(self) -> tuple[Relation, ...]:
        """What is true of the variable beside its bounds."""
        first = self.bounds[0]
        zero_left_out = self.given.above and first == 0
        return (Relation(">", Name(self.given.symbol), ZERO),) if zero_left_out else ()

    def written(self, place: int, figures: int) -> str:
        """A number within the interval, in the variable's own unit."""
        return f"{self.given.unit.from_si(float(self.exact[place].ratio)):.{figures}g}"


class Box:
    """All numbers of a problem, and the domains of its variables. Raises ValueError where a grid is too fine to be held."""

    def __init__(self, problem: Problem, extra: Iterable[Relation] = ()) -> None:
        if any(given.grid.count > MOST_VALUES for given in problem.givens):
            raise ValueError("the grid of a given is too fine")
        self.problem = problem
        domains = [DomainOfVariable(each) for each in problem.variables]
        self.axes: dict[str, GridOfGiven | DomainOfVariable] = {
            given.symbol: GridOfGiven(given) for given in problem.givens
        }
        self.axes |= {each.given.symbol: each for each in domains}
        self.domains = frozenset(each.given.symbol for each in domains)
        self.conditions = [*(each.relation for each in problem.conditions), *extra]
        self.conditions += [each for axis in domains for each in axis.conditions]
        self.above_zero = frozenset(each.given.symbol for each in domains if each.conditions)

    def tied(self, needs: Iterable[Relation]) -> tuple[list[str], list[Relation]]:
        """The givens in these relations, with those tied to them by conditions, and these conditions; the former first."""
        letters = list(
            dict.fromkeys(name for need in needs for name in sorted(names(need)) if name in self.axes)
        )
        found: list[Relation] = []
        left = list(self.conditions)
        while near := [each for each in left if names(each) & set(letters)]:
            found += near
            left = [each for each in left if each not in near]
            letters += sorted(
                {name for each in near for name in names(each)} & self.axes.keys() - set(letters)
            )
        return letters, found

    def random_points(self, random: np.random.Generator, count: int) -> dict[str, np.ndarray]:
        """So many points of the grid, as places of the axes; the columns of a table have one row in each."""
        found: dict[str, np.ndarray] = {}
        for axis in axes(self.problem.givens):
            drawn = random.integers(0, axis[0].grid.count, count)
            for given in axis:
                grid = self.axes[given.symbol]
                found[given.symbol] = (
                    np.argsort(grid.order)[drawn] if given.table and isinstance(grid, GridOfGiven) else drawn
                )
        return found | {name: random.integers(0, self.axes[name].count, count) for name in self.domains}

    def exact(self, places: Mapping[str, int]) -> dict[str, RationalPi]:
        """One point, exactly."""
        return {name: self.axes[name].exact[place] for name, place in places.items()}

    def points(self, places: Mapping[str, np.ndarray]) -> dict[str, GivenAtPoints]:
        """The givens at these places of their axes."""
        return {name: GivenAtPoints(self.axes[name].exact, at) for name, at in places.items()}

    def keeping(self, conditions: Iterable[Relation], places: Mapping[str, np.ndarray]) -> np.ndarray:
        """Which points keep all the conditions."""
        points = self.points(places)
        admissible = np.ones(len(next(iter(places.values()))), dtype=bool)
        for each in conditions:
            admissible &= holding(each, points) if names(each) & points.keys() else always_true(each)
        return admissible

    def intervals(self, low: Mapping[str, np.ndarray], high: Mapping[str, np.ndarray]) -> dict[str, Interval]:
        """The givens between two places of their axes each, as doubles with a bound."""
        from corollary.problem.interval_filter import INTERVALS, ULP

        found: dict[str, Interval] = {}
        for name in low:
            axis = self.axes[name]
            if isinstance(axis, DomainOfVariable):
                first, last = axis.edges[low[name]], axis.edges[high[name] + 1]
            else:
                first, last = axis.doubles[low[name]], axis.doubles[high[name]]
            middle = (first + last) / 2
            radius = (last - first) / 2 + (abs(first) + abs(last)) * ULP
            found[name] = (
                Interval(middle, radius) * INTERVALS.pi**axis.power
                if axis.power
                else Interval(middle, radius)
            )
        return found

    def written(self, places: Mapping[str, int]) -> dict[str, str]:
        """A point in the units of the givens."""
        figures = figures_of(self.axes[name].exact[place] for name, place in places.items())
        found: dict[str, str] = {}
        for name, place in places.items():
            axis = self.axes[name]
            found[name] = (
                axis.written(place, figures)
                if isinstance(axis, DomainOfVariable)
                else number(axis.given, axis.given.grid[axis.order[place]], figures)
            )
        return found


def always_true(relation: Relation) -> bool:
    """Of a relation among numbers alone."""
    try:
        return bool(holds(relation, {}))
    except Undefined:
        return False
