"""The instructor's report: sums that are sums, and the same report from marked work and from stored rows."""

from __future__ import annotations

import io
import json
import runpy
from dataclasses import replace
from pathlib import Path

import msgspec
import pytest
from hypothesis import given
from hypothesis import strategies as st
from rich.console import Console

from corollary.answers.verdict import Right
from corollary.grading.part_grades import Grade
from corollary.records.marks import HandedIn, Row, handed_in, rows
from corollary.records.report_model import report, report_record
from corollary.render.report_page import terminal
from corollary.render.wording import LOOKS

SAMPLE = runpy.run_path(str(Path(__file__).parents[1] / "sample.py"))
summary = SAMPLE["summary"]


@pytest.fixture
def works(tmp_path):
    of = SAMPLE["problem_set"](tmp_path)
    ada, bo, eve = (SAMPLE["marked"](of, name) for name in ("ada", "bo", "eve"))
    full = tuple(
        Grade(
            grade.variant, tuple(replace(part, verdict=Right(), points=part.out_of) for part in grade.parts)
        )
        for grade in bo.grades
    )
    return [ada, replace(bo, grades=full), replace(SAMPLE["late"](eve), trouble="killed for its memory")]


def test_totals_lateness_and_who_is_missing(works):
    found = summary(works, roster=["ada", "bo", "cy", "eve"])
    assert [(one.student, one.points) for one in found.handed_in] == [("ada", 4.5), ("bo", 12), ("eve", 2.25)]
    assert found.mean == pytest.approx((4.5 + 12 + 2.25) / 3)
    assert found.median == 4.5
    assert found.out_of == 12
    assert found.late == pytest.approx(1 / 3)
    assert found.missing == ("cy",)
    assert [(one.student, one.trouble) for one in found.failed] == [("eve", "killed for its memory")]
    assert found.isolation == {"namespaces and rlimits": 3}


def test_every_part_counts_its_verdicts(works):
    parts = {(part.problem, part.part): part for part in summary(works).parts}
    assert list(parts) == [("X12.5", part) for part in ("a", "b", "c", "c_2", "e")] + [
        ("P12.14", part) for part in "ab"
    ]
    assert parts["X12.5", "c"].counts == {**dict.fromkeys(LOOKS, 0), "by_hand": 0, "right": 1, "mistaken": 2}
    assert parts["X12.5", "c"].share == pytest.approx((1 + 0.25 + 0.25) / 3)
    assert parts["X12.5", "e"].counts["unmarked"] == 2
    assert parts["X12.5", "e"].share == 1  # what waits does not count as wrong


def test_misconceptions_are_gathered_with_their_students(works):
    met = summary(works).met
    assert [(one.verdict, one.problem, one.part, one.students) for one in met] == [
        ("mistaken", "X12.5", "c", ("ada", "eve")),
        ("slip", "P12.14", "a", ("ada", "eve")),
    ]
    assert met[0].text == "You forgot the $\\frac12$."


def test_what_waits_says_for_whom_and_why(works):
    assert [(one.student, one.problem, one.part, one.why) for one in summary(works).waiting] == [
        (student, "X12.5", "e", "a person reads this") for student in ("ada", "eve")
    ]


def test_stored_records_give_the_same_report(works):
    stored = msgspec.json.encode([(handed_in(work), rows(work)) for work in works])
    records = msgspec.json.decode(stored, type=list[tuple[HandedIn, tuple[Row, ...]]])
    assert report([one for one, _ in records], [row for _, its in records for row in its]) == summary(works)


def test_json_holds_everything_as_serialized(works):
    found = json.loads(json.dumps(report_record(summary(works, roster=["ada", "bo", "cy", "eve"]))))
    assert found["handed_in"] == 3
    assert found["missing"] == ["cy"]
    assert found["students"]["eve"]["points"] == 2.25
    assert found["misconceptions"][0]["count"] == 2
    assert found["parts"][2]["counts"]["mistaken"] == 2
    assert found["failed"] == [{"student": "eve", "why": "killed for its memory"}]


def said(of) -> str:
    console = Console(width=120, record=True, file=open("/dev/null", "w"))  # noqa: SIM115
    console.print(terminal(of))
    return console.export_text()


def test_the_terminal_says_the_same(works):
    more = [replace(works[0], student=replace(works[0].student, id=f"s{n:02}")) for n in range(20)]
    text = said(summary([*works, *more], roster=["cy"]))
    assert "23 handed in, 1 of them late" in text
    assert "You forgot the" in text
    assert "ada, eve, s00, s01 and 18 more" in text
    assert "killed for its memory" in text
    assert "Not handed in by 1: cy" in text
    assert "22: " in text  # wait for one reason, and share a line


def test_nothing_handed_in_is_said_and_not_divided_by():
    empty = summary([], roster=["ada"])
    assert (empty.mean, empty.median, empty.late, empty.out_of) == (None, None, 0.0, 0.0)
    assert "Nothing was handed in yet." in said(empty)
    assert report_record(empty)["mean"] is None


ANSWERS = st.tuples(
    st.sampled_from("abc"), st.sampled_from(list(LOOKS)), st.floats(0, 1), st.sampled_from([0.0, 1.0, 2.5])
)


@given(st.lists(ANSWERS, max_size=40))
def test_counts_add_up_and_shares_are_shares(drawn):
    some = [
        Row(f"s{n}", "X", part, verdict, share * worth, worth)
        for n, (part, verdict, share, worth) in enumerate(drawn)
    ]
    found = report([], some)
    assert sum(sum(part.counts.values()) for part in found.parts) == len(drawn)
    assert all(part.share is None or 0 <= part.share <= 1 for part in found.parts)
    assert len(found.waiting) == sum(row.verdict == "unmarked" for row in some)


def test_people_have_names_and_lists_end_at_ten():
    names = {f"s{number}": f"Person {number}" for number in range(65)}
    handed = [HandedIn(student, name, 0, 1, trouble="It is empty.") for student, name in names.items()]
    told = report(handed, [], names=names)
    out = Console(file=io.StringIO(), width=200)
    out.print(terminal(told))
    text = out.file.getvalue()
    assert "Person 9 (s9)" in text
    assert "Person 10 (s10)" not in text
    assert "and 55 more, in the report's page and with --json" in text


def test_a_part_of_which_every_answer_waits_has_no_share():
    """Blank answers are marked by themselves: the part is unfinished all the same, and its mean not 0 %."""
    blank, waits = (
        Row(student, "X1", "a", verdict, 0, 1) for student, verdict in (("ada", "unread"), ("bo", "unmarked"))
    )
    assert report([], [blank, waits]).parts[0].share is None
    assert report([], [blank]).parts[0].share == 0
    assert report([], [blank, waits, Row("cy", "X1", "a", "right", 1, 1)]).parts[0].share == 0.5
