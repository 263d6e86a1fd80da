"""Colours: words written on them can be read, and contrast is WCAG's."""

from __future__ import annotations

import pytest

from corollary.figure.colour import BLACK, CYCLE, contrast, ink


def test_black_on_white_is_21():
    assert contrast(BLACK, "#FFFFFF") == pytest.approx(21)
    assert contrast("#777777", "#FFFFFF") == pytest.approx(
        4.48, abs=0.01
    )  # the grey WCAG's own example just fails with


@pytest.mark.parametrize("colour", CYCLE)
def test_numbers_in_bars_reach_double_a(colour):
    assert contrast(ink(colour), colour) >= 4.5
