"""A term as data: one JSON document, a table of totals, and a table of addresses for a mail merge."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import asdict
from typing import Any

from corollary.records.misconception_history import Followed, MisconceptionTerm
from corollary.records.misconception_names import Misconception
from corollary.records.term import CourseTerm, StudentTerm
from corollary.records.term_totals import MARKED, MISSING, OPEN, SetResult

ABOUT = ("id", "first_name", "last_name", "email", "section", "group")


def term_record(
    term: CourseTerm, followed: Sequence[Followed], lines: Sequence[MisconceptionTerm]
) -> dict[str, Any]:
    """The term as plain data: shares from 0 to 1, a `total` that is not final is null and has `low` and `high`."""
    own: dict[str, list[Followed]] = {}
    for each in followed:
        own.setdefault(each.student, []).append(each)
    return {
        "sets": [
            {
                "name": each.name,
                "title": each.title,
                "weight": each.weight,
                "due": None if each.due is None else each.due.isoformat(),
                "graded": each.is_graded,
            }
            for each in term.sets
        ],
        "rules": asdict(term.rules),
        "students": {
            line.student.id: _student_record(term, line, own.get(line.student.id, ()))
            for line in term.students
        },
        "missing": {line.student.id: list(line.missing) for line in term.students if line.missing},
        "behind": {line.student.id: list(line.behind) for line in term.students if line.behind},
        "misconceptions": [
            {
                **_named(each.misconception),
                "counts": dict(each.counts),
                "repeated": list(each.repeated),
                "once": list(each.once),
                "lost": list(each.lost),
            }
            for each in lines
        ],
        "notes": list(term.notes),
    }


def _student_record(term: CourseTerm, line: StudentTerm, followed: Sequence[Followed]) -> dict[str, Any]:
    return {
        **{name: getattr(line.student, name) for name in ABOUT[1:]},
        "name": line.student.name,
        "total": line.total.value,
        "low": line.total.low,
        "high": line.total.high,
        "waiting": line.waiting,
        "missing": list(line.missing),
        "behind": list(line.behind),
        "sets": {
            name: asdict(each) | {"dropped": place in line.total.dropped}
            for place, (name, each) in enumerate(zip(term.names, line.results, strict=True))
        },
        "misconceptions": [
            {
                **_named(each.misconception),
                "status": each.status,
                "met": {name: list(parts) for name, parts in each.met.items()},
                "passed": list(each.passed),
            }
            for each in followed
        ],
    }


def _named(what: Misconception) -> dict[str, Any]:
    kind = "slip" if what.is_slip else "misconception"
    return {"name": what.name, "kind": kind, "problem": what.problem or None}


def totals_rows(term: CourseTerm) -> Iterator[Sequence[str]]:
    """A row a student: per cent by set (a word where there is no mark, a range where it is not final), and the total, blank while it
    is not final."""
    yield (*ABOUT, *term.names, "total", "total_low", "total_high", "waiting", "missing", "dropped", "behind")
    for line in term.students:
        total = line.total
        ends = ("" if each is None else _percent(each) for each in (total.value, total.low, total.high))
        dropped = (name for place, name in enumerate(term.names) if place in total.dropped)
        yield (
            *_about(line),
            *map(_cell, line.results),
            *ends,
            str(line.waiting),
            " ".join(line.missing),
            " ".join(dropped),
            "; ".join(line.behind),
        )


def mail_rows(term: CourseTerm) -> Iterator[Sequence[str]]:
    """Those who miss a set or fall behind, for a mail merge: names and address, what is missing, and why they fall behind."""
    yield (*ABOUT, "name", "missing", "missing_titles", "total", "behind")
    titles = {each.name: each.title for each in term.sets}
    for line in term.students:
        if line.missing or line.behind:
            total = "" if line.total.value is None else _percent(line.total.value)
            yield (
                *_about(line),
                line.student.name,
                ", ".join(line.missing),
                ", ".join(titles[name] for name in line.missing),
                total,
                "; ".join(line.behind),
            )


def history_rows(term: CourseTerm, followed: Sequence[Followed]) -> Iterator[Sequence[str]]:
    """A row for each misconception of each student, with the parts in which it was met in each set."""
    yield ("id", "name", "section", "group", "misconception", "problem", "kind", "status", *term.names)
    people = {line.student.id: line.student for line in term.students}
    for each in followed:
        student, what = people[each.student], _named(each.misconception)
        cells = (
            ", ".join(each.met[name]) if name in each.met else "right" if name in each.passed else ""
            for name in term.names
        )
        about = (student.id, student.name, student.section, student.group)
        yield (*about, what["name"], what["problem"] or "", what["kind"], each.status, *cells)


def _about(line: StudentTerm) -> list[str]:
    return [str(getattr(line.student, name)) for name in ABOUT]


def _cell(result: SetResult) -> str:
    if result.state == MARKED:
        return _percent(result.low)
    if result.state == OPEN:
        return ""
    if result.high > result.low:
        return f"{_percent(result.low)}–{_percent(result.high)}"
    return "0" if result.state == MISSING else result.state


def _percent(share: float) -> str:
    return f"{100 * share:.6g}"
