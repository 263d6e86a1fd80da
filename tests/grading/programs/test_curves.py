"""Curves held against those asked for, along their whole length."""

from __future__ import annotations

import numpy as np
import pytest

from corollary.grading.programs.curves import DrawnCurve, Graph, covers


@pytest.mark.parametrize(
    ("first", "last", "fits"), [(0.0, 3.0, True), (0.5, 3.0, False), (0.0, 2.5, False), (-1.0, 4.0, True)]
)
def test_a_curve_must_be_there_from_its_beginning_to_its_end(first, last, fits):
    graph = Graph("a line", lambda x: x, (0.0, 3.0), (1.0, 1.0))
    x = np.linspace(first, last, 400)
    assert graph.fits(DrawnCurve(x, x, joined=True)) == fits
    asked = np.linspace(0.0, 3.0, 400)
    assert covers((x, x), (asked, asked)) == fits
