"""Statistics of a graded set through the command: beside the report, in its document, and as a table."""

from __future__ import annotations

import csv

import pytest

pytest.importorskip("nbgrader")

from corollary.records.files import Course

from .conftest import run

pytestmark = pytest.mark.whole


def test_the_report_has_statistics_where_they_are_asked_for(marked_course: Course) -> None:
    report = ("corollary", "report", "words", "--course", ".")
    done = run(marked_course, *report, "--statistics", "--csv", "words.csv", "--json")
    assert done.status == 0, done.errors
    plain = run(marked_course, *report, "--json").document
    assert {name: told for name, told in done.document.items() if name != "statistics"} == plain
    parts = done.document["statistics"]["parts"]
    counted = {(each["problem"], each["part"]) for each in plain["parts"] if each["share"] is not None}
    assert {(each["problem"], each["part"]) for each in parts} == counted
    with (marked_course.folder / "words.csv").open(encoding="utf-8") as file:
        table = [row for row in csv.DictReader(file) if row["statistic"] == "difficulty"]
    assert [float(row["estimate"]) for row in table] == pytest.approx(
        [each["difficulty"]["value"] for each in parts], rel=1e-5
    )
    on_terminal = run(marked_course, *report, "--statistics").out
    assert "tells students apart" in on_terminal
