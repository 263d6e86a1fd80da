"""What marks depend on, and what of it can change without a notebook being run again."""

from __future__ import annotations

import pytest

from corollary.grading.submission import CREDIT, LATE_SHARE, WEIGHTS, judged_by
from corollary.records.causes import DEADLINE, TIME, needs_no_run
from corollary.records.record import HandedIn, Record

TODAYS = {CREDIT: "1", WEIGHTS: "1", judged_by("X12.5"): "1"}


def record(depends: dict[str, str]) -> Record:
    return Record(0.0, 1.0, {}, "", HandedIn("ada", "Ada", 0.0, 1.0), (), depends=depends)


@pytest.mark.parametrize("name", [CREDIT, WEIGHTS])
def test_points_are_given_again_only_where_the_record_says_what_they_go_by(name: str):
    assert needs_no_run(record(TODAYS), [name])
    assert not needs_no_run(record({CREDIT: "1", WEIGHTS: "1"}), [name])


@pytest.mark.parametrize("name", [DEADLINE, TIME, LATE_SHARE])
def test_lateness_is_given_again_from_every_record(name: str):
    assert needs_no_run(record({}), [name])


def test_a_law_that_changes_is_no_matter_of_points():
    assert not needs_no_run(record(TODAYS), [CREDIT, "the solution of X12.5"])
