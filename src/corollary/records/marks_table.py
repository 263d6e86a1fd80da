"""Marks as a table: a row for each student, a column for each set or each part, blank where there is no mark."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass
from decimal import ROUND_HALF_UP, Decimal
from types import MappingProxyType

from corollary.problem.problem_set import ProblemSet
from corollary.problem.roster import Student
from corollary.records.report_model import Report


@dataclass(frozen=True, slots=True)
class Mark:
    points: float
    out_of: float


@dataclass(frozen=True, slots=True)
class Column:
    """Marks by student: one without a mark has a blank, which is no zero. `also` are other titles by which the column may be
    known elsewhere; of those `waiting` a person still has something to mark, which is not in the marks; of those marked `again`
    a mark counts that a person gave for an earlier answer."""

    title: str
    also: tuple[str, ...]
    out_of: float
    marks: Mapping[str, Mark]
    excused: frozenset[str] = frozenset()
    waiting: tuple[str, ...] = ()
    again: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class Notation:
    """How a mark is written: with at most so many `decimals`, in points, or scaled to be out of `out_of`; `blank` stands where
    there is none, and `point` is the decimal one."""

    decimals: int = 2
    out_of: float | None = None
    blank: str = ""
    point: str = "."

    def written(self, mark: Mark) -> str:
        """Half a unit is rounded up, as people do; zeros behind the last figure that is needed are left out."""
        points = mark.points
        if self.out_of is not None:
            points = points * self.out_of / mark.out_of if mark.out_of else 0.0
        # By the decimal that is meant and not by the double: a sum of marks that is 2.675 is stored as 2.67499….
        exact = Decimal(f"{points:.9g}").quantize(Decimal(1).scaleb(-self.decimals), ROUND_HALF_UP) + 0
        text = f"{exact:f}"
        return (text.rstrip("0").rstrip(".") if "." in text else text).replace(".", self.point)


@dataclass(frozen=True, slots=True)
class MarksTable:
    students: tuple[Student, ...]
    columns: tuple[Column, ...]
    notation: Notation = Notation()

    def cell(self, student: Student, column: Column) -> str:
        """The mark as it is written, or what stands where there is none."""
        mark = column.marks.get(student.id)
        return self.notation.blank if mark is None else self.notation.written(mark)

    def out_of(self, column: Column) -> str:
        """What the column is out of."""
        return self.notation.written(Mark(column.out_of, column.out_of))

    @property
    def is_blank(self) -> bool:
        """Whether nobody has a mark; what a sheet is out of is none."""
        return not any(column.marks for column in self.columns if column.title != "out_of")

    @property
    def waiting(self) -> tuple[str, ...]:
        """Whose marks are without parts that wait for a person."""
        return tuple(dict.fromkeys(student for column in self.columns for student in column.waiting))

    @property
    def again(self) -> tuple[str, ...]:
        """Whose marks count what a person gave for an earlier answer, until the new one is marked."""
        return tuple(dict.fromkeys(student for column in self.columns for student in column.again))

    @property
    def out_of_another(self) -> tuple[str, ...]:
        """Whose sheet is out of other points than its column, which says nothing of that: the set was corrected in between."""
        if self.notation.out_of is not None or any(column.title == "out_of" for column in self.columns):
            return ()
        found = (
            student
            for column in self.columns
            for student, mark in column.marks.items()
            if abs(mark.out_of - column.out_of) > 1e-9
        )
        return tuple(dict.fromkeys(found))


def set_column(problem_set: ProblemSet, report: Report, excused: Collection[str] = ()) -> Column:
    """The marks in the set, after lateness."""
    marks = {
        one.student: Mark(one.points, one.out_of) for one in report.handed_in if one.student not in excused
    }
    rows = [row for row in report.rows if row.student in marks]
    waiting = tuple(dict.fromkeys(row.student for row in rows if row.waits and not row.again))
    again = tuple(dict.fromkeys(row.student for row in rows if row.again))
    out_of = problem_set.out_of
    return Column(problem_set.title, (problem_set.name,), out_of, marks, frozenset(excused), waiting, again)


def part_columns(
    problem_set: ProblemSet, report: Report, excused: Collection[str] = (), *, late: bool = True
) -> list[Column]:
    """A column for each part, those of today first, then those that are gone and that somebody has marks for. After lateness,
    so that a student's parts add up to the mark in the set; before it when not `late`."""
    shares = {one.student: one.late_share if late else 1.0 for one in report.handed_in}
    found: list[Column] = []
    for (code, part), out_of in _parts(problem_set, report).items():
        its = [row for row in report.rows if (row.problem, row.part) == (code, part)]
        its = [row for row in its if row.student in shares and row.student not in excused]
        marks = {
            row.student: Mark(row.points * shares[row.student], row.out_of)
            for row in its
            if row.again or not row.waits
        }
        waiting = tuple(row.student for row in its if row.student not in marks)
        again = tuple(row.student for row in its if row.again)
        title, named = (f"{name} {code} {part}" for name in (problem_set.title, problem_set.name))
        found.append(
            Column(title, (named, f"{code} {part}"), out_of, marks, frozenset(excused), waiting, again)
        )
    return found


def every_column(
    problem_set: ProblemSet,
    report: Report,
    students: Sequence[Student],
    excused: Collection[str] = (),
    sheets: Mapping[str, float] = MappingProxyType({}),
) -> Iterable[Column]:
    """Each part before lateness, the total after it, and what that is out of for each student; `sheets` is what a student's own
    sheet is out of, for those who have handed nothing in."""
    for each in part_columns(problem_set, report, excused, late=False):
        yield Column(each.also[-1], (), each.out_of, each.marks, each.excused, each.waiting, each.again)
    total = set_column(problem_set, report, excused)
    yield Column("total", (), total.out_of, total.marks, total.excused, total.waiting, total.again)
    own = {**sheets, **{one.student: one.out_of for one in report.handed_in}}
    out_of = {each.id: own.get(each.id, problem_set.out_of) for each in students}
    yield Column("out_of", (), total.out_of, {who: Mark(most, most) for who, most in out_of.items()})


def _parts(problem_set: ProblemSet, report: Report) -> dict[tuple[str, str], float]:
    """What each part is out of."""
    parts = {
        (problem.code, part.id): part.points * problem_set.weight(problem)
        for problem in problem_set.problems
        for part in problem.parts
    }
    for row in report.rows:
        parts.setdefault((row.problem, row.part), row.out_of)
    return parts
