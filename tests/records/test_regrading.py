"""Who changes, by how much, and where; rounding is no change."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

from corollary.answers.verdict import Right, Verdict, Wrong
from corollary.grading.part_grades import Grade, Marked, PartGrade
from corollary.problem.bank import chapter_bank, find
from corollary.problem.roster import Student
from corollary.problem.variant import chapter
from corollary.records.marks import Record, record_of
from corollary.records.regrading import Change, change, largest_first

KICK = chapter(find(chapter_bank(), "X12.5"))


def marked(name: str, *points: float, late_share: float = 1.0) -> Marked:
    parts = []
    for part, earned in zip(KICK.problem.parts, points, strict=False):
        verdict: Verdict = Right() if earned else Wrong()
        parts.append(PartGrade(part, verdict, earned, 1.0, "", ""))
    return Marked(Student(name), (Grade(KICK, tuple(parts)),), (), (), "", "", 0.0, late_share)


def changes(old: Mapping[str, Record], new: Sequence[Marked]) -> tuple[Change, ...]:
    """Of those who had marks already."""
    known = [each for each in new if each.student.id in old]
    found = [change(each.student.id, old[each.student.id], record_of(each, "")) for each in known]
    return largest_first(each for each in found if each is not None)


def test_the_largest_change_comes_first_and_who_keeps_their_marks_is_not_named() -> None:
    old = {name: record_of(marked(name, 1, 0, 0), "") for name in ("ada", "ben", "chen")}
    found = changes(
        old,
        [marked("ada", 1, 1, 0), marked("ben", 1, 0, 0), marked("chen", 0, 1, 1), marked("dora", 1, 1, 1)],
    )
    assert [(each.student, each.before, each.after, each.by) for each in found] == [
        ("ada", 1, 2, 1),
        ("chen", 1, 2, 1),
    ]
    assert [
        (part.part, part.verdict_before, part.verdict, part.before, part.after) for part in found[0].parts
    ] == [("X12_5_b", "wrong", "right", 0, 1)]
    assert [part.part for part in found[1].parts] == ["X12_5_a", "X12_5_b", "X12_5_c"]


def test_lateness_alone_is_a_change_and_a_breath_is_none() -> None:
    old = {"ada": record_of(marked("ada", 1, 1, 1), "")}
    (found,) = changes(old, [marked("ada", 1, 1, 1, late_share=0.5)])
    assert (found.by, found.parts) == (-1.5, ())
    assert changes(old, [replace(marked("ada", 1, 1, 1.000001))]) == ()
