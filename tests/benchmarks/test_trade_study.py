"""The work-precision study: its references are found again, a trial of it runs whole, and what it counts is counted right."""

from __future__ import annotations

import json
import math
import runpy
from pathlib import Path

import numpy as np
import pytest
from trade.study import composed, contacts, reference_runs, solvers, summary
from trade.study.measured import FAMILIES, Timed, from_rows

from corollary.trade.raced_scene import CRADLE_3_HERTZ, SPHERES_DAMPED

pytestmark = pytest.mark.whole

COMMAND = Path(__file__).parents[2] / "benchmarks" / "trade" / "__main__.py"


def test_references_of_contacts_are_those_of_other_programs():
    """The equal cradle and the chapter's damped spheres, which extrapolation in 34 digits and Taylor series in 50 gave."""
    (row,) = reference_runs.rows([(0.1, 0.1, 0.1)])
    (pair,) = reference_runs.spheres([{"ma": 0.1, "mb": 0.1, "aside": 0.45, "eta": 1.0}])
    for found, known in ((row, CRADLE_3_HERTZ), (pair, SPHERES_DAMPED)):
        assert np.allclose([float(v) for v in found["velocities"]], known.numbers, rtol=0.0, atol=5e-16)


def test_what_is_written_is_found_again():
    (again,) = reference_runs.spheres([contacts.spheres_of(3)])
    assert contacts.known("spheres", 3) == again


@pytest.mark.parametrize("family", FAMILIES)
def test_a_solver_of_scipy_comes_to_the_reference(family):
    problem = FAMILIES[family](1)
    found = solvers.through_events(problem, problem.right_side, "LSODA", 1e-10)
    assert np.max(np.abs(found.velocities - problem.truth.velocities)) < 1e-5 * problem.fast
    assert np.max(np.abs(found.places - problem.truth.places)) < 1e-5 * problem.long


@pytest.mark.whole
def test_a_trial_of_the_whole_study(tmp_path, capsys):
    main = runpy.run_path(str(COMMAND))["main"]
    assert main(["--quick", "--family", "spheres", "--family", "wall", "--output", str(tmp_path)]) == 0
    assert "What became of the runs" in capsys.readouterr().out
    document = json.loads((tmp_path / "runs.json").read_text(encoding="utf-8"))
    runs = from_rows(document["runs"])
    assert document["draws"] == 1
    ours = [run for run in runs if run.method.startswith("ours")]
    assert {run.outcome for run in ours} == {"found"}
    assert not any(summary.silently_wrong(run) for run in ours)
    assert all((tmp_path / f"{name}.svg").stat().st_size < 300_000 for name in ("work", "stated", "book"))


def run(setting: float, end: float, evaluations: int, outcome: str = "found") -> Timed:
    return Timed("row", 0, "a", setting, end, math.nan, math.nan, False, evaluations, 1e-3, outcome)


def test_the_cost_of_an_error_lies_between_two_runs_and_no_lucky_hit_counts():
    runs = [run(1e-2, 1e-2, 100), run(1e-4, 1e-9, 200), run(1e-6, 1e-4, 400), run(1e-8, 1e-8, 800)]
    assert summary.cost(runs, 1e-6, summary.evaluations_of) == pytest.approx(400.0 * 2.0**0.5)
    assert summary.cost(runs, 1e-8, summary.evaluations_of) == pytest.approx(800.0)
    assert math.isnan(summary.cost(runs, 1e-10, summary.evaluations_of))
    assert math.isnan(summary.cost([*runs, run(1e-10, math.nan, 0, "failed")], 1e-6, summary.evaluations_of))


def test_a_wrong_number_without_a_word_is_counted():
    found = summary.failures([run(1e-6, 0.4, 300), run(1e-6, 1e-7, 300), run(1e-8, math.nan, 0, "too dear")])[
        "a"
    ]
    assert (found["runs"], found["silently wrong"], found["found"], found["too dear"]) == (3, 1, 1, 1)


def test_an_oscillator_meets_its_wall_four_times():
    problem = composed.wall(2)
    assert float(np.max(problem.truth.places)) <= float(problem.p[1]) + 1e-14
