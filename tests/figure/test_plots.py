"""Plots: the same bytes from the same data, nothing fetched, numbers where they belong."""

from __future__ import annotations

import math
from xml.etree.ElementTree import fromstring

import pytest
from hypothesis import given
from hypothesis import strategies as st

from corollary.figure.colour import BLUE, GREEN, VERMILLION
from corollary.figure.plots import Curve, Layer, histogram, interval_counts, lines, stacked_bars


def bars() -> str:
    layers = [Layer("right", (3, 1), GREEN), Layer("wrong", (1, 2), VERMILLION), Layer("never", (0, 0), BLUE)]
    return stacked_bars(["X12.5 a", "costs $5 and $6"], layers, x_label="students", alt="how it went")


def totals() -> str:
    return histogram(
        [1, 2, 2, 9.5], low=0, high=10, bins=5, x_label="points", y_label="students", alt="totals"
    )


def curves() -> str:
    drawn = [Curve("euler_cromer", (1, 10), (1, 0.1)), Curve("verlet", (1, 10), (1, 0.01))]
    return lines(drawn, x_label="evaluations", y_label="error", alt="trade", log_x=True, log_y=True)


@pytest.mark.parametrize("plot", [bars, totals, curves])
def test_the_same_data_give_the_same_bytes_and_fetch_nothing(plot):
    drawn = plot()
    assert drawn == plot()
    root = fromstring(drawn)
    assert root.get("role") == "img"
    assert root.get("aria-label")
    assert "http" not in drawn
    assert "<script" not in drawn


def words(svg: str) -> list[str]:
    return ["".join(text.itertext()) for text in fromstring(svg).iter("text")]


def test_bars_carry_labels_numbers_and_a_legend_of_what_occurs():
    said = words(bars())
    assert {"X12.5 a", "costs $5 and $6", "students", "right", "wrong"} <= set(said)
    assert "never" not in said
    assert said.count("3") >= 1


def test_curves_are_named_as_they_are_called():
    assert {"euler_cromer", "verlet", "evaluations", "error"} <= set(words(curves()))


def test_bars_of_nothing_are_still_drawn():
    assert "students" in words(
        stacked_bars(["a"], [Layer("right", (0,), GREEN)], x_label="students", alt="nothing")
    )


def test_intervals_are_closed_on_the_left_and_the_last_on_both_sides():
    assert interval_counts([0, 2, 4, 10], 0, 10, 5) == [1, 1, 1, 0, 1]


@given(st.lists(st.floats(allow_nan=True, allow_infinity=True)), st.integers(1, 30))
def test_every_finite_value_is_counted_once(values, bins):
    assert sum(interval_counts(values, -1, 3, bins)) == sum(map(math.isfinite, values))
