"""Answers laid out for a person to mark, and the marks that the person gives."""

# pyright: reportUnknownArgumentType=false, reportUnknownMemberType=false, reportUnknownVariableType=false

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence

import nbformat
from msgspec import UNSET
from nbformat import NotebookNode
from nbformat.v4 import new_notebook

from corollary.grading.part_grades import NearMiss
from corollary.messages import did_you_mean
from corollary.nbgrader.gradebook import gradebook, has_gradebook, has_seen
from corollary.nbgrader.marked_notebook import answer_cells, verbatim
from corollary.nbgrader.written_marks import stale_pages, synchronized
from corollary.problem.problem_set import ProblemSet
from corollary.problem.roster import Student
from corollary.records.files import Course, ids_of, one_writer, students
from corollary.records.manual_marks import ManualMark, ManualMarks, Place, read_manual, write_manual
from corollary.records.marks import Record, Row, check_graded, read_marks, write_page
from corollary.records.near_miss_groups import AnswerGroup, PartToMark, WrittenCell, near_misses
from corollary.render.wording import points


def give(course: Course, given: Mapping[Place, ManualMark]) -> ManualMarks:
    """Everything that persons gave, these marks last. Whoever calls it is the only writer and has synchronized the course."""
    journal = read_manual(course)
    if has_gradebook(course):
        from corollary.nbgrader.manual_grades import fill, submitted_notebooks, weigh_lateness
        from corollary.records.marks import stored_record

        with gradebook(course) as book:
            for notebook, (name, student) in submitted_notebooks(book, {place.set_name for place in given}):
                marks = {p.part: m for p, m in given.items() if (p.set_name, p.student) == (name, student)}
                record = stored_record(course, name, student)
                if marks and record is not None:
                    fill(notebook, marks, record)
                    weigh_lateness(notebook, record.late_share)
            has_seen(book, journal.count + len(given))
            book.db.commit()
    write_manual(course, given)
    return journal.and_then(given)


class NotMarkable(ValueError):
    """A mark that cannot be given; one sentence says why, and what to do."""


def to_mark(course: Course, problem_set: ProblemSet, *, everything: bool = False) -> list[PartToMark]:
    """The parts with answers that wait for a person or are near misses, or `everything`, in the order of the set. Raises NotACourse and
    NothingGraded."""
    check_graded(course, problem_set.name)
    with one_writer(course):
        manual = synchronized(course)
    roster = [student.id for student in students(course)]
    records = read_marks(course, problem_set, roster, manual)
    notebooks = {student: _notebook(course, problem_set, student) for student in records}
    found: list[PartToMark] = []
    for key, (code, part, title) in _asked(problem_set, records.values()).items():
        whose = [
            student
            for student, record in records.items()
            if key in record.parts and (everything or _waits(record, key) or _near_miss(record, key))
        ]
        if whose:
            groups = tuple(_groups(key, whose, records, notebooks))
            entry = records[whose[0]].parts[key]
            rubric = next((r for s in whose if (r := records[s].parts[key].rubric) is not UNSET), ())
            found.append(PartToMark(key, code, part, title, entry.out_of, tuple(rubric), groups))
    return found


def give_marks(
    course: Course,
    problem_set: ProblemSet,
    marks: Mapping[tuple[str, str], ManualMark],
    where: Mapping[tuple[str, str], str] | None = None,
) -> None:
    """Gives marks by student and part: into the gradebook, the journal and the feedback pages, before it returns.

    Raises NotMarkable for a part or a student that is not marked yet, and for points that cannot be; it opens with `where` the
    mark was written, where that is known.
    """
    with one_writer(course):
        manual = synchronized(course)
        whose = sorted({student for student, _ in marks})
        records = read_marks(course, problem_set, whose, manual)
        roster, given = students(course), dict[Place, ManualMark]()
        for (student, part), mark in marks.items():
            try:
                checked = _checked(records.get(student), student, part, mark, roster)
            except NotMarkable as error:
                place = (where or {}).get((student, part))
                raise NotMarkable(f"{place}: {error}" if place else str(error)) from None
            given[Place(problem_set.name, student, part)] = checked
        now = give(course, given)
        for student, page in stale_pages(course, problem_set.name, now, whose).items():
            write_page(course, problem_set.name, student, page)


def part_named(problem_set: ProblemSet, name: str, record: Record | None = None) -> str:
    """The part's name in the notebook, from that or from `X12.5 d`. `record` is the student's: it has parts that were handed out
    and are in the problem no longer. Raises NotMarkable."""
    keys = _asked(problem_set, [] if record is None else [record])
    wanted = "".join(name.split()).lower()
    for key, (code, part, _) in keys.items():
        if wanted in {key.lower(), f"{code}{part}".lower(), f"{code}.{part}".lower()}:
            return key
    raise NotMarkable(f"{problem_set.name} has no part {name}; it has {', '.join(keys)}")


def _asked(problem_set: ProblemSet, records: Iterable[Record]) -> dict[str, tuple[str, str, str]]:
    """Code, part and title by the part's name in the notebook: the set's, then those handed out that it has no longer."""
    found = {
        problem.answer_name(part): (problem.code, part.id, part.title)
        for problem in problem_set.problems
        for part in problem.parts
    }
    for record in records:
        for key, row in zip(record.parts, record.rows, strict=True):
            found.setdefault(key, (row.problem, row.part, ""))
    return found


def _checked(
    record: Record | None, student: str, part: str, mark: ManualMark, roster: Sequence[Student]
) -> ManualMark:
    """The mark with what it was given for. Raises NotMarkable."""
    if record is None:
        ids = [each.id for each in roster]
        meant = [] if student in ids else ids_of(student, roster)
        hint = f" (did you mean {' or '.join(meant)}?)" if meant else did_you_mean(student, ids)
        near = "" if student in ids else hint
        raise NotMarkable(f"no submission of {student} is graded{near}; grade first, or correct the name")
    if part not in record.parts:
        raise NotMarkable(f"{student} was not asked {part}; it is one of {', '.join(record.parts)}")
    most = record.parts[part].out_of
    if mark.score is not None and not 0 <= mark.score <= most:
        raise NotMarkable(f"{part} earns from 0 to {points(most)} points, not {mark.score:g}")
    before = record.parts[part].manual
    extra = None if before is UNSET else before.extra_credit
    out_of = 0.0 if mark.score is None else most
    return ManualMark(mark.score, extra, mark.comment, record.answers.get(part, ""), mark.by, out_of=out_of)


def _waits(record: Record, key: str) -> bool:
    rows = zip(record.parts, record.rows, strict=True)
    return any(row.waits for name, row in rows if name == key)


def _near_miss(record: Record, key: str) -> NearMiss | None:
    return _row(record, key).near_miss


def _groups(
    key: str, whose: Sequence[str], records: Mapping[str, Record], notebooks: Mapping[str, NotebookNode]
) -> Iterator[AnswerGroup]:
    """Near misses of one kind and text first, then what is equal but for blanks and capitals. Answers with pictures are nobody
    else's, nor are those already marked otherwise, by a person or, for other numbers, by the program."""
    near = near_misses(row for each in whose if (row := _row(records[each], key)).near_miss)
    for group in near:
        first = group.students[0]
        late = sum(records[student].late > 0 for student in group.students)
        cells = tuple(_cells(notebooks[first], key))
        row = _row(records[first], key)
        yield AnswerGroup(group.students, cells, late, _why(row), None, row.again, group)
    whose = [each for each in whose if not any(each in group.students for group in near)]
    by_answer: dict[object, list[tuple[str, tuple[WrittenCell, ...]]]] = {}
    for student in whose:
        cells = tuple(_cells(notebooks[student], key))
        manual = records[student].parts[key].manual
        row = _row(records[student], key)
        marked = (
            (row.verdict, row.points) if manual is UNSET else (manual.score, manual.comment, manual.first)
        )
        same = tuple(" ".join(cell.source.split()).lower() for cell in cells)
        alone = student if any(cell.pictures for cell in cells) or not cells else ""
        by_answer.setdefault((same, marked, alone), []).append((student, cells))
    for equal in sorted(by_answer.values(), key=len, reverse=True):
        first, cells = equal[0]
        record, names = records[first], tuple(student for student, _ in equal)
        manual = record.parts[key].manual
        row = _row(record, key)
        late = sum(records[student].late > 0 for student in names)
        yield AnswerGroup(names, cells, late, _why(row), None if manual is UNSET else manual, row.again)


def _row(record: Record, key: str) -> Row:
    return dict(zip(record.parts, record.rows, strict=True))[key]


def _why(row: Row) -> str:
    """What there is to know of an answer; of one that the program marked, how."""
    if row.again and not row.by_hand:
        return f"{row.why[0].upper()}{row.why[1:]}. {_by_program(row)}"
    if row.waits or row.by_hand:
        return row.why
    return f"{_by_program(row)} {row.error or row.why}".strip()


def _by_program(row: Row) -> str:
    return f"Marked by the program: {row.verdict}, {points(row.points)} {'point' if row.points == 1 else 'points'}."


def _cells(nb: NotebookNode, key: str) -> Iterable[WrittenCell]:
    for cell in answer_cells(nb, key):
        drawn = list((cell.get("attachments") or {}).values())
        drawn += [output.get("data", {}) for output in cell.get("outputs", ())]
        pictures = [
            f"data:{mime};base64,{''.join(str(content).split())}"
            for kinds in drawn
            for mime, content in kinds.items()
            if mime in {"image/png", "image/jpeg"}
        ]
        yield WrittenCell(str(cell.source), verbatim(cell), cell.cell_type == "code", tuple(pictures))


def _notebook(course: Course, problem_set: ProblemSet, student: str) -> NotebookNode:
    """The marked notebook, made harmless when it was written; an empty one where it is missing or broken."""
    try:
        return nbformat.read(course.notebook("autograded", student, problem_set.name), as_version=4)
    except (OSError, ValueError, AttributeError, KeyError):
        return new_notebook()
