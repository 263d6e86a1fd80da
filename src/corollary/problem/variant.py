"""A problem with its numbers: exact rationals in the givens' own units, and where they came from."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property, lru_cache
from math import prod

from corollary.formula.ast import Name, names
from corollary.formula.errors import Undefined
from corollary.formula.numerals import decimal_text, figures_apart, power_of_ten
from corollary.formula.rational_pi import RationalPi
from corollary.problem.axes import axes, place_on, row_of
from corollary.problem.given import Given, decimal_places
from corollary.problem.problem import Condition, Problem
from corollary.units.unit import Unit, show

POWER_OF_TEN = re.compile(r"(?<![\w.])(?P<digits>\d+(?:\.\d+)?)e(?P<power>[+-]?\d+)")
MOST_FIGURES = 6  # of a number with very many decimals
SUPERSCRIPTS = str.maketrans("0123456789-", "⁰¹²³⁴⁵⁶⁷⁸⁹⁻")


class OutOfRange(ValueError):
    """A given's value contradicts the physics; one sentence says which and why."""


@dataclass(frozen=True)
class Variant:
    """`values` are in each given's own unit, by symbol; `index` is the place in the grid (None: chosen by hand)."""

    problem: Problem
    values: Mapping[str, Fraction]
    index: int | None

    @cached_property
    def exact(self) -> dict[str, RationalPi]:
        """The givens in SI, exactly, and a value within its domain for each variable; made once, so not to be changed."""
        numbers = {
            given.symbol: RationalPi(*given.unit.to_si(self.values[given.symbol]))
            for given in self.problem.givens
        }
        return numbers | {each.symbol: each.value(self.index) for each in self.problem.variables}

    @property
    def si(self) -> dict[str, float]:
        """The givens in SI, each the nearest double."""
        from corollary.formula.ball import certified  # a page that names the numbers needs no such arithmetic

        exact = self.exact
        return {given.symbol: certified(Name(given.symbol), exact).value for given in self.problem.givens}

    @property
    def letters_in_si(self) -> dict[str, float]:
        """The same with the variables."""
        return self.si | {each.symbol: float(self.exact[each.symbol]) for each in self.problem.variables}

    @property
    def label(self) -> str:
        """What identifies these numbers on paper: code and place in the grid."""
        return f"{self.problem.code}#{'own' if self.index is None else self.index}"


def size(problem: Problem) -> int:
    """How many points the grid has, before any condition."""
    return prod(axis[0].grid.count for axis in axes(problem.givens))


def at(problem: Problem, index: int) -> Variant:
    """The grid point with this index; the last given moves fastest. Raises OutOfRange beyond the grid."""
    if not 0 <= index < size(problem):
        raise OutOfRange(f"{problem.code} has variants 0 to {size(problem) - 1}; {index} is not among them")
    values, rest = dict[str, Fraction](), index
    for axis in reversed(axes(problem.givens)):
        rest, place = divmod(rest, axis[0].grid.count)
        values |= {given.symbol: given.grid[place] for given in axis}
    return Variant(problem, {given.symbol: values[given.symbol] for given in problem.givens}, index)


def chapter(problem: Problem) -> Variant:
    """The problem with the chapter's own numbers."""
    return Variant(problem, {given.symbol: given.value for given in problem.givens}, None)


def index_of(problem: Problem, values: Mapping[str, Fraction]) -> int | None:
    """The place in the grid of these numbers, in the givens' own units; None when they lie beside it."""
    index = 0
    for axis in axes(problem.givens):
        place = place_on(axis, values)
        if place is None:
            return None
        index = index * axis[0].grid.count + place
    return index


def chosen(problem: Problem, values: Mapping[str, Fraction]) -> Variant:
    """The chapter's numbers with some replaced (in the givens' own units); with them the row of a table that has them comes whole.

    Raises OutOfRange when a symbol is unknown or a value is against the physics.
    """
    for symbol in values:
        if symbol not in {given.symbol for given in problem.givens}:
            known = ", ".join(given.symbol for given in problem.givens)
            raise OutOfRange(f"{symbol} is not among the givens of {problem.code} ({known})")
    variant = Variant(problem, {**chapter(problem).values, **_rows_of(problem, values), **values}, None)
    if (broken := first_broken(variant, hard_only=True)) is not None:
        have = ", ".join(
            f"{name} = {value}"
            for name, value in written_apart(variant, sorted(names(broken.relation) - {"pi"})).items()
        )
        raise OutOfRange(f"{problem.code} needs {broken.text}, but {have}")
    return variant


def _rows_of(problem: Problem, values: Mapping[str, Fraction]) -> dict[str, Fraction]:
    """Of each table that some of the values are in, the row that has them all, else the one that has the words among them."""
    found: dict[str, Fraction] = {}
    for axis in axes(problem.givens):
        wanted = {given: values[given.symbol] for given in axis if given.table and given.symbol in values}
        words = {given: value for given, value in wanted.items() if given.words}
        place = next((at for each in (wanted, words) if each and (at := row_of(each)) is not None), None)
        if place is not None:
            found |= {given.symbol: given.grid[place] for given in axis}
    return found


def first_broken(variant: Variant, *, hard_only: bool = False) -> Condition | None:
    """The first condition these numbers break, or None."""
    from corollary.formula.ball import holds

    exact = variant.exact
    for condition in variant.problem.conditions:
        if hard_only and not condition.hard:
            continue
        try:
            if not holds(condition.relation, exact):
                return condition
        except Undefined:
            return condition
    return None


def written(variant: Variant, symbol: str, most: int = MOST_FIGURES) -> str:
    """A given as a student reads it: number and unit, with as many decimals as its grid has; or its word."""
    given = variant.problem.given(symbol)
    if given.words:
        return number(given, variant.values[symbol])
    return in_print(with_unit(number(given, variant.values[symbol], most), given.unit))


def written_apart(variant: Variant, symbols: Iterable[str] | None = None) -> dict[str, str]:
    """Givens as they are written, but with as many figures as it takes to see which differ; all but those that follow from others
    when none is named."""
    named = (
        [each.symbol for each in variant.problem.givens if not each.source] if symbols is None else symbols
    )
    givens = [variant.problem.given(symbol) for symbol in named]
    exact = variant.exact
    figures = figures_of([exact[each.symbol] for each in givens if not each.words])
    return {each.symbol: written(variant, each.symbol, figures) for each in givens}


def figures_of(values: Iterable[RationalPi]) -> int:
    """The figures of numbers with very many decimals, where one sentence holds these values."""
    return figures_apart([each.ratio * Fraction(math.pi) ** each.pi for each in values], MOST_FIGURES)


def in_print(text: str, in_formula: bool = False) -> str:
    """`6.4e23 kg` with the power of ten that a book prints: 6.4 · 10²³ kg; 1e15 is 10¹⁵. In TeX with `in_formula`."""

    def power(found: re.Match[str]) -> str:
        digits = found["power"].lstrip("+")
        ten = f"10^{{{digits}}}" if in_formula else "10" + digits.translate(SUPERSCRIPTS)
        times = r" \cdot " if in_formula else "\N{NO-BREAK SPACE}·\N{NO-BREAK SPACE}"
        return ten if found["digits"] == "1" else f"{found['digits']}{times}{ten}"

    return POWER_OF_TEN.sub(power, text)


def with_unit(number: str, unit: Unit) -> str:
    """A number with its unit behind it, which no line end parts."""
    symbol = show(unit)
    return number + ("" if symbol in {"", "%", "°"} else "\N{NO-BREAK SPACE}") + symbol


def number(given: Given, value: Fraction, most: int = MOST_FIGURES) -> str:
    """The bare number, with the decimals of the given's grid where they suffice; the word of a given that is none."""
    if given.words:
        return given.words[int(value)]
    return decimals(value, given.decimals_of(value), most)


def row_in_words(columns: Iterable[Given], place: int) -> str:
    """A row of a table for a message: `body: a hoop, k: 1`."""
    return ", ".join(f"{given.symbol}: {number(given, given.grid[place])}" for given in columns)


@lru_cache(maxsize=4096)
def decimals(value: Fraction, least: int, most: int = MOST_FIGURES) -> str:
    """An exact number with at least so many decimals, and as many as it takes; one with very many in `most` figures. On a sheet it is
    written many times, and the next student's is often the same."""
    places = max(least, decimal_places(value))
    if places > 9 or abs(value) >= 10**7 or 0 < abs(value) < Fraction(1, 10**4):
        counted = (
            least < 0 or abs(value) < 1
        )  # 1.20e-5 and 6.40e23 have three figures; large decimals are cut
        figures = least + power_of_ten(abs(value)) + 1 if counted and value else 1
        text = next(
            (
                text
                for n in range(min(max(figures, 1), most), most + 1)
                if Fraction(text := decimal_text(value, n)) == value
            ),
            decimal_text(value, most),
        )
        return text.replace("-", "−", 1) if value < 0 else text
    return f"{round(value * 10**places) / 10**places:.{places}f}".replace("-", "−")
