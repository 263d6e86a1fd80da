"""One parameter of a problem: its symbol, meaning, unit, the chapter's value, and the grid it may be drawn from."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache

from corollary.units.unit import Unit


@dataclass(frozen=True, slots=True)
class Grid:
    """The exact values first, first + step, …; `count` of them, in the given's own unit. Or the `values` of a list, as they
    stand in it: `first` is then the smallest, and `step` 0."""

    first: Fraction
    step: Fraction
    count: int
    values: tuple[Fraction, ...] = ()

    @classmethod
    def listing(cls, values: tuple[Fraction, ...]) -> Grid:
        """The grid that has these values and no others."""
        return cls(min(values), Fraction(0), len(values), values)

    def __getitem__(self, index: int) -> Fraction:
        return self.values[index] if self.values else self.first + self.step * index

    def place(self, value: Fraction) -> int | None:
        """Where a value stands; None when it lies beside the grid."""
        if self.values:
            return self.values.index(value) if value in self.values else None
        steps = (value - self.first) / self.step if self.step else Fraction(0)
        inside = steps.denominator == 1 and 0 <= steps < self.count
        return int(steps) if inside and self[int(steps)] == value else None

    @property
    def last(self) -> Fraction:
        """The largest value."""
        return max(self.values) if self.values else self[self.count - 1]


@dataclass(frozen=True, slots=True)
class Given:
    """`source` says where the value of a constant of nature is from. `words` are what a given that is no number stands for:
    its values are their places, 0, 1, … `table` names the table whose rows are drawn whole, where the given is a column of one;
    `as_written` has then how many decimals each of its values is written with."""

    symbol: str
    meaning: str
    unit: Unit
    value: Fraction
    grid: Grid
    line: int
    places: int
    source: str = ""
    words: tuple[str, ...] = ()
    table: str = ""
    as_written: tuple[tuple[Fraction, int], ...] = ()

    def decimals_of(self, value: Fraction) -> int:
        """How many decimals a value is written with: those of its grid, or of its row."""
        return next((places for each, places in self.as_written if each == value), self.places)

    @property
    def sign(self) -> int:
        """1 when every drawable value is positive, -1 when every one is negative, else 0."""
        low, high = sorted((self.grid.first, self.grid.last))
        return 1 if low > 0 and self.value > 0 else -1 if high < 0 and self.value < 0 else 0


def decimal_places(*numbers: Fraction) -> int:
    """How many decimals write every one of the numbers exactly (at most 12: beyond, the number is no decimal)."""
    return max((_places(number.denominator) for number in numbers), default=0)


@lru_cache(maxsize=4096)
def _places(denominator: int) -> int:
    return next((n for n in range(13) if 10**n % denominator == 0), 12)
