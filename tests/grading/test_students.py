"""A few of the benchmark's simulated students: honest work is not rejected, listed mistakes are not accepted."""

from __future__ import annotations

import sys
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path
from types import ModuleType

import pytest

from corollary.grading.assign import admitted
from corollary.problem.sampling import sample


def by_path(path: Path) -> ModuleType:
    """A module that belongs to no package."""
    spec = spec_from_file_location(path.stem, path)
    assert spec is not None
    assert spec.loader is not None
    module = module_from_spec(spec)
    sys.modules[path.stem] = module  # dataclasses look their module up
    spec.loader.exec_module(module)
    return module


students = by_path(Path(__file__).parents[2] / "benchmarks" / "students.py")
pytestmark = pytest.mark.whole


@pytest.mark.parametrize("code", ["X12.5", "X12.7", "X12.8", "X12.10", "P12.14"])
def test_honest_three_figure_work_is_right_and_listed_mistakes_are_not(solution, code):
    record = students.simulate(solution(code), 12).record()
    assert record["honest"]["3 figures each step"]["rejected_percent"] == 0
    assert record["honest"]["4 figures each step"]["rejected_percent"] == 0
    assert record["honest"]["4 figures each operation"]["rejected_percent"] == 0
    assert record["mistakes"]["accepted_percent"] == 0
    assert record["mistakes"]["named_percent"] > 95
    assert record["redrawn_percent"] < 80


@pytest.mark.parametrize("code", ["S12.4n", "S12.5gen", "S12.5two"])
def test_numbers_are_drawn_of_which_no_rounding_takes_the_answer_away(solution, code):
    """Differences of nearly equal terms: rounding every product to three figures took more than 2 % away, and draws were refused."""
    record = students.simulate(solution(code), 60).record()
    for sort in students.SORTS:
        assert record["honest"][sort]["rejected_percent"] == 0, sort
    assert record["mistakes"]["accepted_percent"] == 0
    assert record["mistakes"]["named_percent"] == 100
    assert record["redrawn_percent"] < 5


@pytest.mark.parametrize(("code", "share"), [("X12.13", 0.2), ("P12.15", 0.1)])
def test_few_draws_are_refused_for_rounding(solution, code, share):
    """The chain's loss beside its work, the atom's distance beside its rest: nearly equal terms on a third of the draws, once."""
    found = solution(code)
    draws = list(sample(found.problem, 50, salt="refused"))
    assert sum(admitted(found, draw)[0] is None for draw in draws) <= share * len(draws)


def test_answers_that_are_just_anything_are_mostly_wrong(solution):
    found = students.wild([solution(code) for code in ("X12.5", "X12.8", "X12.10")], 600)
    for record in found.values():
        assert (
            record["wrong"] > 94
        )  # some twenty known slips and mistakes, each half a per cent wide on either side
        assert record["right"] < 1
