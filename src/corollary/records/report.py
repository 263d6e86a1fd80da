"""What an instructor reads after grading: marks, how each part went, misconceptions met, and what waits for a person."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import asdict
from statistics import fmean
from typing import assert_never

from corollary.answers.verdict import Follows, Mistaken, Right, Slip, Unmarked, Unread, Verdict, Wrong, word
from corollary.grading.grade import Marked
from corollary.records.report_model import SHARING, HandedIn, Met, PartTally, Report, Row, Shared, Waiting
from corollary.render.report_table import terminal as terminal
from corollary.render.verdict_look import LOOKS


def summary(marked: Iterable[Marked], *, roster: Iterable[str] = ()) -> Report:
    """The report on marked submissions; `roster` holds the ids of all students of the course."""
    marked = list(marked)
    return report(
        [handed_in(one) for one in marked], [row for one in marked for row in rows(one)], roster=roster
    )


def report(
    handed: Sequence[HandedIn],
    rows: Sequence[Row],
    *,
    roster: Iterable[str] = (),
    shared: Sequence[Shared] = (),
) -> Report:
    """The report on plain rows, as they are kept beside a course; parts in the order of their first row."""
    by_part: dict[tuple[str, str], list[Row]] = {}
    by_slip: dict[tuple[str, str, str, str], dict[str, None]] = {}
    for row in rows:
        by_part.setdefault((row.problem, row.part), []).append(row)
        if row.said:
            by_slip.setdefault((row.verdict, row.said, row.problem, row.part), {})[row.student] = None
    met = [Met(*met, tuple(students)) for met, students in by_slip.items()]
    waiting = [
        Waiting(row.student, row.problem, row.part, row.why) for row in rows if row.verdict == "unmarked"
    ]
    came = {one.student for one in handed}
    return Report(
        tuple(handed),
        tuple(_tally(problem, part, its) for (problem, part), its in by_part.items()),
        tuple(sorted(met, key=lambda one: (-len(one.students), one.verdict, one.problem, one.part))),
        tuple(waiting),
        tuple(student for student in roster if student not in came),
        tuple(shared),
    )


def _tally(problem: str, part: str, rows: Sequence[Row]) -> PartTally:
    counts = Counter(row.verdict for row in rows)
    marked = [row.points / row.out_of for row in rows if row.verdict != "unmarked" and row.out_of > 0]
    return PartTally(problem, part, {word: counts[word] for word in LOOKS}, fmean(marked) if marked else None)


def handed_in(marked: Marked) -> HandedIn:
    student = marked.student
    return HandedIn(
        student.id,
        student.name,
        marked.points,
        marked.out_of,
        marked.late,
        marked.late_share,
        marked.trouble,
        marked.isolation,
        marked.notes,
    )


def rows(marked: Marked) -> list[Row]:
    """One row for each part of one submission."""
    student = marked.student.id
    return [
        Row(
            student,
            grade.variant.problem.code,
            part.part.id,
            word(part.verdict),
            part.points,
            part.out_of,
            *_said(part.verdict),
        )
        for grade in marked.grades
        for part in grade.parts
    ]


def _said(verdict: Verdict) -> tuple[str, str]:
    """The mistake or slip, and what else was said."""
    match verdict:
        case Right(note):
            return "", note
        case Follows(earlier):
            return "", f"from {', '.join(earlier)}"
        case Mistaken(mistake, earlier):
            return mistake, f"from {', '.join(earlier)}" if earlier else ""
        case Slip(slip):
            return slip, ""
        case Wrong(why) | Unread(why) | Unmarked(why):
            return "", why
        case _:
            assert_never(verdict)


def as_json(report: Report) -> dict[str, object]:
    """The report as plain data for one JSON document."""
    return {
        "handed_in": len(report.handed_in),
        "missing": list(report.missing),
        "mean": report.mean,
        "median": report.median,
        "out_of": report.out_of,
        "late": report.late,
        "students": {one.student: asdict(one) for one in report.handed_in},
        "parts": [{**asdict(part), "counts": dict(part.counts)} for part in report.parts],
        "misconceptions": [{**asdict(met), "count": len(met.students)} for met in report.met],
        "waiting": [asdict(one) for one in report.waiting],
        "failed": [{"student": one.student, "why": one.trouble} for one in report.failed],
        "noticed": [{"student": one.student, "notes": list(one.notes)} for one in report.noticed],
        "sharing": [asdict(one) for one in report.shared],
        "sharing_model": SHARING,
        "isolation": report.isolation,
    }
