"""What marks depend on, and what of it can change without a notebook being run again."""

from __future__ import annotations

import pytest

from corollary.grading.submission import CREDIT, LATE_SHARE, WEIGHTS
from corollary.records.regrading import DEADLINE, TIME, needs_no_run


@pytest.mark.parametrize("name", [CREDIT, WEIGHTS, DEADLINE, TIME, LATE_SHARE])
def test_points_and_lateness_are_given_again_without_a_run(name: str):
    assert needs_no_run([name])


def test_a_law_that_changes_needs_the_notebook_run_again():
    assert not needs_no_run([CREDIT, "the solution of X12.5"])
