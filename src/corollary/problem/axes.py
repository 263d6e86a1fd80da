"""The axes of a problem's grid: a given drawn alone, or the columns of a table whose rows are drawn whole."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace
from fractions import Fraction
from itertools import product

from corollary.problem.given import Given, Grid
from corollary.problem.problem import Problem

GridAxis = tuple[Given, ...]


def axes(givens: Iterable[Given]) -> list[GridAxis]:
    """The givens, those together that are columns of one table, where the first of them stands."""
    found: dict[str, list[Given]] = {}
    for given in givens:
        found.setdefault(f"rows {given.table}" if given.table else given.symbol, []).append(given)
    return [tuple(axis) for axis in found.values()]


def place_on(axis: GridAxis, values: Mapping[str, Fraction]) -> int | None:
    """Where the values stand on an axis; None when they lie beside the grid, or in no row."""
    if len(axis) == 1:
        return axis[0].grid.place(values[axis[0].symbol])
    return row_of({given: values[given.symbol] for given in axis})


def row_of(values: Mapping[Given, Fraction]) -> int | None:
    """The first row of a table that has these values in its columns. Rows may have a word in common, which any of them has."""

    def same(given: Given, place: int, value: Fraction) -> bool:
        return given.grid[place] == value or _word(given, place) == _word(given, value) != ""

    count = next(iter(values)).grid.count
    exact = (at for at in range(count) if all(given.grid[at] == value for given, value in values.items()))
    alike = (at for at in range(count) if all(same(given, at, value) for given, value in values.items()))
    return next(exact, next(alike, None))


def _word(given: Given, place: Fraction | int) -> str:
    return given.words[int(place)] if given.words and 0 <= place < len(given.words) else ""


def tables(problem: Problem) -> list[GridAxis]:
    """The tables whose rows are drawn, each as its columns."""
    return [axis for axis in axes(problem.givens) if axis[0].table]


def row_by_row(problem: Problem) -> Iterator[Problem]:
    """The problem once for each row (of several tables: each set of rows), with the numbers of that row and no others."""
    every = tables(problem)
    for places in product(*(range(axis[0].grid.count) for axis in every)):
        fixed = {
            given.symbol: _fixed(given, place)
            for axis, place in zip(every, places, strict=True)
            for given in axis
        }
        yield replace(problem, givens=tuple(fixed.get(each.symbol, each) for each in problem.givens))


def _fixed(given: Given, place: int) -> Given:
    value = given.grid[place]
    return replace(given, value=value, grid=Grid(value, Fraction(0), 1), table="")
