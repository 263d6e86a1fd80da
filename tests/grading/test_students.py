"""A few of the benchmark's simulated students: honest work is not rejected, listed mistakes are not accepted."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

sys.path.append(str(Path(__file__).parents[2] / "benchmarks"))
students = pytest.importorskip("students")


@pytest.mark.parametrize("code", ["X12.5", "X12.7", "X12.8", "X12.10", "P12.14"])
def test_honest_three_figure_work_is_right_and_listed_mistakes_are_not(solution, code):
    record = students.simulate(solution(code), 12).record()
    assert record["honest"]["3 figures each step"]["rejected_percent"] == 0
    assert record["honest"]["4 figures each step"]["rejected_percent"] == 0
    assert record["honest"]["4 figures each operation"]["rejected_percent"] == 0
    assert record["mistakes"]["accepted_percent"] == 0
    assert record["mistakes"]["named_percent"] > 95
    assert record["redrawn_percent"] < 80


def test_answers_that_are_just_anything_are_mostly_wrong(solution):
    found = students.wild([solution(code) for code in ("X12.5", "X12.8", "X12.10")], 600)
    for record in found.values():
        assert (
            record["wrong"] > 94
        )  # some twenty known slips and mistakes, each half a per cent wide on either side
        assert record["right"] < 1
