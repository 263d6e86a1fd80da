"""Plots: the same bytes from the same data, nothing fetched, numbers where they belong."""

from __future__ import annotations

from xml.etree.ElementTree import fromstring

from corollary.figure.plots import Curve, lines


def curves() -> str:
    drawn = [Curve("euler_cromer", (1, 10), (1, 0.1)), Curve("verlet", (1, 10), (1, 0.01))]
    return lines(drawn, x_label="evaluations", y_label="error", alt="trade", log_x=True, log_y=True)


def test_the_same_data_give_the_same_bytes_and_fetch_nothing():
    drawn = curves()
    assert drawn == curves()
    root = fromstring(drawn)
    assert root.get("role") == "img"
    assert root.get("aria-label")
    assert "http" not in drawn
    assert "<script" not in drawn


def words(svg: str) -> list[str]:
    return ["".join(text.itertext()) for text in fromstring(svg).iter("text")]


def test_curves_are_named_as_they_are_called():
    assert {"euler_cromer", "verlet", "evaluations", "error"} <= set(words(curves()))
