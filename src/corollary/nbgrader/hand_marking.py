"""Answers laid out for a person to mark, and the marks that the person gives."""

# pyright: reportUnknownArgumentType=false, reportUnknownMemberType=false, reportUnknownVariableType=false

from __future__ import annotations

import hashlib
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from datetime import UTC, datetime
from typing import Any

import msgspec
from msgspec import UNSET
from msgspec.structs import replace
from nbformat import NotebookNode, from_dict

from corollary.grading.near_misses import accepted_text
from corollary.messages import did_you_mean
from corollary.nbgrader.gradebook import gradebook, has_gradebook, has_seen
from corollary.nbgrader.marked_notebook import answer_cells, verbatim
from corollary.nbgrader.written_marks import is_as_seen, note, stale_pages, state, synchronized
from corollary.problem.problem_set import ProblemSet
from corollary.problem.roster import Student
from corollary.records.files import Course, ids_of, one_writer, students
from corollary.records.manual_marks import (
    NOTHING,
    ManualMark,
    ManualMarks,
    Place,
    RequestDecision,
    RubricItem,
    read_manual,
    write_manual,
)
from corollary.records.marks import Record, Row, check_graded, read_marks, write_page
from corollary.records.near_miss_groups import (
    AnswerGroup,
    NearMisses,
    PartToMark,
    WrittenCell,
    near_misses,
)
from corollary.records.outside_changes import OutsideChange, read_outside, settle_outside
from corollary.records.regrade_requests import RegradeRequest, decide, gather_requests, open_requests
from corollary.records.rubrics import (
    RubricMove,
    checked_rubric,
    following,
    from_solution,
    read_rubrics,
    write_rubric,
)
from corollary.render.wording import points


@dataclass(frozen=True, slots=True)
class MarkingState:
    """What is to be marked in a set: the parts, who has something that a person marks, and who of them has nothing left."""

    parts: tuple[PartToMark, ...]
    students: tuple[str, ...]
    done: tuple[str, ...]


def give(course: Course, given: Mapping[Place, ManualMark]) -> ManualMarks:
    """Everything that persons gave, these marks last. Whoever calls it is the only writer and has synchronized the course."""
    journal = read_manual(course)
    before = state(course, journal.count)
    if has_gradebook(course):
        from corollary.nbgrader.manual_grades import fill, notebooks_of, weigh_lateness
        from corollary.records.marks import stored_record

        with gradebook(course) as book:
            for notebook, (name, student) in notebooks_of(book, {(p.set_name, p.student) for p in given}):
                marks = {p.part: m for p, m in given.items() if (p.set_name, p.student) == (name, student)}
                record = stored_record(course, name, student)
                if marks and record is not None:
                    fill(notebook, marks, record)
                    weigh_lateness(notebook, record.late_share)
            has_seen(book, journal.count + len(given))
            book.db.commit()
    write_manual(course, given)
    settle_outside(course, given)
    after = state(course, journal.count + len(given))
    # One transaction since what was read, and it is this one: nothing in the gradebook has to be read again.
    if before and after and is_as_seen(course, before) and after.counter == before.counter + 1:
        note(course, after)
    return journal.and_then(given)


class NotMarkable(ValueError):
    """A mark that cannot be given; one sentence says why, and what to do."""


@dataclass(frozen=True, slots=True)
class StandingMark:
    """What stands for one student instead of what the marker saw; `mark` is None where the program gave the points."""

    student: str
    mark: ManualMark | None
    points: float
    out_of: float
    seen: str


class ChangedMeanwhile(ValueError):
    """Marks or answers are others than the marker saw; nothing was written."""

    def __init__(self, part: str, standing: Sequence[StandingMark]) -> None:
        self.part, self.standing = part, tuple(standing)
        first = self.standing[0]
        who = f" by {first.mark.by}" if first.mark is not None and first.mark.by else ""
        super().__init__(
            f"the mark of {first.student} in {part} was changed meanwhile{who}: it is {points(first.points)} of "
            f"{points(first.out_of)} now; look at it and give yours again"
        )


def to_mark(
    course: Course,
    problem_set: ProblemSet,
    *,
    everything: bool = False,
    only: Collection[str] | None = None,
) -> list[PartToMark]:
    """The parts with answers that wait for a person, are near misses, were changed in the gradebook or have a request, or
    `everything`, in the order of the set; with `only`, of these students. Raises NotACourse and NothingGraded."""
    return list(marking_state(course, problem_set, everything=everything, only=only).parts)


def marking_state(
    course: Course,
    problem_set: ProblemSet,
    *,
    everything: bool = False,
    only: Collection[str] | None = None,
) -> MarkingState:
    """The same, with the students' progress."""
    check_graded(course, problem_set.name)
    with one_writer(course):
        manual = synchronized(course)
        gather_requests(course, problem_set)
    roster = [student.id for student in students(course) if only is None or student.id in only]
    records = read_marks(course, problem_set, roster, manual)
    outside = {
        (place.student, place.part): each for place, each in read_outside(course, problem_set.name).items()
    }
    requests = open_requests(course, problem_set.name)
    rubrics = read_rubrics(course, problem_set.name)
    notebooks = _Notebooks(course, problem_set.name)
    found: list[PartToMark] = []
    for key, (code, part, title) in _asked(problem_set, records.values()).items():
        whose = [
            student
            for student, record in records.items()
            if key in record.parts
            and (
                everything
                or (row := record.row(key)).waits
                or row.near_miss
                or (student, key) in outside
                or (student, key) in requests
            )
        ]
        if whose:
            groups = tuple(_groups(key, whose, records, notebooks, outside, requests))
            entry = records[whose[0]].parts[key]
            rubric = next((r for s in whose if (r := records[s].parts[key].rubric) is not UNSET), ())
            items = rubrics.get(key) or from_solution(tuple(rubric))
            found.append(PartToMark(key, code, part, title, entry.out_of, items, groups))
    by_person = [
        student for student, record in records.items() if any(row.waits or row.by_hand for row in record.rows)
    ]
    done = [student for student in by_person if not any(row.waits for row in records[student].rows)]
    return MarkingState(tuple(found), tuple(by_person), tuple(done))


def give_marks(
    course: Course,
    problem_set: ProblemSet,
    marks: Mapping[tuple[str, str], ManualMark],
    where: Mapping[tuple[str, str], str] | None = None,
    seen: Mapping[tuple[str, str], str] | None = None,
) -> dict[tuple[str, str], str]:
    """Gives marks by student and part: into the gradebook, the journal and the feedback pages, before it returns. Answers what
    each looks like from now on, as `seen` takes it.

    Raises NotMarkable for a part or a student that is not marked yet, and for points that cannot be; it opens with `where` the
    mark was written, where that is known. `seen` names what the marker saw: ChangedMeanwhile is raised where that is another now.
    """
    name = problem_set.name
    with one_writer(course):
        manual = synchronized(course)
        whose = sorted({student for student, _ in marks})
        records = read_marks(course, problem_set, whose, manual)
        roster, given = students(course), dict[Place, ManualMark]()
        waiting, requests = read_outside(course, name), open_requests(course, name)
        standing: list[StandingMark] = []
        for (student, part), mark in marks.items():
            try:
                checked = _checked(records.get(student), student, part, mark, roster)
            except NotMarkable as error:
                place = (where or {}).get((student, part))
                raise NotMarkable(f"{place}: {error}" if place else str(error)) from None
            now = seen_now(records[student], part, waiting.get(Place(name, student, part)))
            if seen is not None and seen.get((student, part), now) != now:
                standing.append(
                    _standing(records[student], part, waiting.get(Place(name, student, part)), now)
                )
            if (request := requests.get((student, part))) is not None:
                checked = _decided(checked, records[student], part, request)
            given[Place(name, student, part)] = checked
        if standing:
            raise ChangedMeanwhile(next(part for _, part in marks), standing)
        now = give(course, given)
        at = datetime.now(UTC).isoformat(timespec="seconds")
        for student, part in marks.keys() & requests.keys():
            decide(course, name, student, part, at)
        for student, page in stale_pages(course, name, now, whose).items():
            write_page(course, name, student, page)
        after = read_marks(course, problem_set, whose, now)
        return {(student, part): seen_now(after[student], part, None) for student, part in marks}


def as_it_stands(
    course: Course, problem_set: ProblemSet, student: str, part: str, mark: ManualMark
) -> ManualMark:
    """The mark with the score that a person gave before: the answer to a request that changes nothing. Raises NotMarkable."""
    request = open_requests(course, problem_set.name).get((student, part))
    if request is None:
        raise NotMarkable(f"{student} has no open request for regrading of {part}")
    if not mark.comment:
        raise NotMarkable(f"say why the mark of {student} in {part} stands")
    with one_writer(course):
        manual = synchronized(course)
    record = read_marks(course, problem_set, [student], manual).get(student)
    entry = None if record is None else record.parts.get(part)
    before = NOTHING if entry is None or entry.manual is UNSET else entry.manual
    return replace(mark, score=before.score, rubric=before.rubric)


def seen_in(course: Course, problem_set: ProblemSet, part: str, whose: Sequence[str]) -> dict[str, str]:
    """What each of these students' answers to a part looks like now."""
    with one_writer(course):
        manual = synchronized(course)
        records = read_marks(course, problem_set, whose, manual)
        waiting = read_outside(course, problem_set.name)
    return {
        student: seen_now(record, part, waiting.get(Place(problem_set.name, student, part)))
        for student, record in records.items()
        if part in record.parts
    }


def _standing(record: Record, part: str, outside: OutsideChange | None, seen: str) -> StandingMark:
    entry = record.parts[part]
    if outside is not None:
        points_now = entry.points if outside.after is None else outside.after
        return StandingMark(record.handed_in.student, outside.mark, points_now, entry.out_of, seen)
    mark = None if entry.manual is UNSET else entry.manual
    return StandingMark(record.handed_in.student, mark, entry.points, entry.out_of, seen)


def seen_now(record: Record, part: str, outside: OutsideChange | None) -> str:
    """A name of all that a marker sees of one answer: the mark, the answer, what it is out of, a change in the gradebook."""
    entry = record.parts[part]
    manual = NOTHING if entry.manual is UNSET else entry.manual
    facts = (
        manual.score,
        manual.extra_credit,
        manual.comment,
        manual.rubric and [(item.id, item.share) for item in manual.rubric],
        entry.points,
        entry.out_of,
        record.answers.get(part, ""),
        outside and (outside.after, outside.mark.comment),
    )
    return hashlib.sha256(repr(facts).encode()).hexdigest()[:16]


def change_rubric(
    course: Course, problem_set: ProblemSet, part: str, items: Sequence[RubricItem], *, preview: bool
) -> list[RubricMove]:
    """Changes the items of a part's rubric, and the marks that were given by them; says whose marks move. A preview writes nothing.
    Raises UnusableRubric."""
    items, name = checked_rubric(items), problem_set.name
    with one_writer(course):
        manual = synchronized(course)
        before = {
            place: mark
            for place, mark in manual.by_place.items()
            if (place.set_name, place.part) == (name, part)
        }
        changed = {
            place: now for place, mark in before.items() if (now := following(mark, items)) is not mark
        }
        moves = [
            RubricMove(place.student, before[place].score, now.score)
            for place, now in changed.items()
            if before[place].score != now.score
        ]
        if not preview:
            write_rubric(course, name, part, items)
            if changed:
                now = give(course, changed)
                whose = [place.student for place in changed]
                for student, page in stale_pages(course, name, now, whose).items():
                    write_page(course, name, student, page)
    return moves


def take_outside(course: Course, set_name: str) -> ManualMarks:
    """Agrees to the scores that were changed in the gradebook. Whoever calls it is the only writer."""
    waiting = read_outside(course, set_name)
    return give(course, {place: each.mark for place, each in waiting.items()})


def _decided(mark: ManualMark, record: Record, part: str, request: RegradeRequest) -> ManualMark:
    """The mark as the answer to a request."""
    before = record.parts[part].points
    after = before if mark.score is None else mark.score + (mark.extra_credit or 0.0)
    return replace(mark, request=RequestDecision(request.text, abs(after - before) >= 0.005))


def marks_of(group: AnswerGroup, mark: ManualMark) -> Iterator[tuple[str, ManualMark]]:
    """The mark for each student of the group; whose near miss is accepted without a word is told how it was taken."""
    near = {each.student: each for each in group.near_miss.answers} if group.near_miss else {}
    for student in group.students:
        accepted = student in near and mark.score == near[student].points and not mark.comment
        comment = accepted_text(near[student].read) if accepted else mark.comment
        yield student, replace(mark, comment=comment)


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
    before = NOTHING if (manual := record.parts[part].manual) is UNSET else manual
    out_of = 0.0 if mark.score is None else most
    answer = record.answers.get(part, "")
    return replace(
        mark, extra_credit=before.extra_credit, answer=answer, out_of=out_of, request=before.request
    )


def _groups(
    key: str,
    whose: Sequence[str],
    records: Mapping[str, Record],
    notebooks: _Notebooks,
    outside: Mapping[tuple[str, str], OutsideChange],
    requests: Mapping[tuple[str, str], RegradeRequest],
) -> Iterator[AnswerGroup]:
    """What somebody asks about or changed in the gradebook first, each alone; then near misses of one kind and text, then what is
    equal but for blanks and capitals. Answers with pictures are nobody else's, nor are those already marked otherwise, by a person
    or, for other numbers, by the program."""

    def group(
        names: Sequence[str], cells: tuple[WrittenCell, ...], near: NearMisses | None = None
    ) -> AnswerGroup:
        first = names[0]
        row = records[first].row(key)
        manual = records[first].parts[key].manual
        late = sum(records[student].late > 0 for student in names)
        given = None if manual is UNSET or near is not None else manual
        alone = (first, key)
        points = None if row.waits and not row.by_hand else row.points
        asked, changed = requests.get(alone), outside.get(alone)
        seen = tuple(seen_now(records[each], key, outside.get((each, key))) for each in names)
        return AnswerGroup(
            tuple(names), cells, late, _why(row), given, row.again, near, changed, asked, points, seen
        )

    single = [each for each in whose if (each, key) in requests or (each, key) in outside]
    for student in single:
        yield group([student], tuple(_cells(notebooks.of(student), key)))
    whose = [each for each in whose if each not in set(single)]
    near = near_misses(row for each in whose if (row := records[each].row(key)).near_miss)
    for one in near:
        yield group(one.students, tuple(_cells(notebooks.of(one.students[0]), key)), one)
    in_near = {student for one in near for student in one.students}
    by_answer: dict[object, list[tuple[str, tuple[WrittenCell, ...]]]] = {}
    for student in whose:
        if student in in_near:
            continue
        cells = tuple(_cells(notebooks.of(student), key))
        manual = records[student].parts[key].manual
        row = records[student].row(key)
        marked = (
            (row.verdict, row.points)
            if manual is UNSET
            else (manual.score, manual.comment, manual.first, manual.rubric)
        )
        same = tuple(" ".join(cell.source.split()).lower() for cell in cells)
        alone = student if any(cell.pictures for cell in cells) or not cells else ""
        by_answer.setdefault((same, marked, alone), []).append((student, cells))
    for equal in sorted(by_answer.values(), key=len, reverse=True):
        yield group([student for student, _ in equal], equal[0][1])


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
            f"data:{mime};base64,{''.join((content if isinstance(content, str) else ''.join(content)).split())}"
            for kinds in drawn
            for mime, content in kinds.items()
            if mime in {"image/png", "image/jpeg"}
        ]
        yield WrittenCell(str(cell.source), verbatim(cell), cell.cell_type == "code", tuple(pictures))


@dataclass(slots=True)
class _Notebooks:
    """The marked notebooks of a set, made harmless when they were written, with the cells in which students wrote; each is read
    once, and one that is missing or broken has no cells."""

    course: Course
    set_name: str
    read: dict[str, NotebookNode] = field(default_factory=dict[str, NotebookNode])

    def of(self, student: str) -> NotebookNode:
        if student not in self.read:
            self.read[student] = NotebookNode(cells=list(self._cells(student)))
        return self.read[student]

    def _cells(self, student: str) -> Iterator[NotebookNode]:
        # Without nbformat's check against its schema, which takes six times as long as all the rest of the page.
        try:
            path = self.course.notebook("autograded", student, self.set_name)
            cells: list[Any] = msgspec.json.decode(path.read_bytes())["cells"]
            for cell in cells:
                if cell["metadata"].get("nbgrader", {}).get("solution"):
                    source = cell["source"]
                    whole = source if isinstance(source, str) else "".join(source)
                    yield from_dict({**cell, "source": whole})  # pyright: ignore[reportReturnType]
        except (OSError, ValueError, AttributeError, KeyError, TypeError):
            return
