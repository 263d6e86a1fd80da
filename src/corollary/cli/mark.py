"""`corollary mark`: marking by hand, all answers to one part together; on a local page, in the terminal, by a script."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from pathlib import Path
from threading import Thread
from typing import Any

import msgspec

from corollary.cli.ending import HOLDS, MOST_LISTED, answer, counted, refuse
from corollary.cli.local_page import OnePageServer, serve
from corollary.course.up_to_date import up_to_date
from corollary.grading.near_misses import accepted_text
from corollary.messages import few, visible
from corollary.nbgrader.gradebook import has_gradebook, need_nbgrader
from corollary.nbgrader.hand_marking import (
    ChangedMeanwhile,
    NotMarkable,
    as_it_stands,
    give_marks,
    marks_of,
    part_named,
    to_mark,
)
from corollary.problem.bank import Bank
from corollary.problem.csv_table import read_table
from corollary.problem.problem_set import ProblemSet
from corollary.records.files import Course, ids_in, open_course, students
from corollary.records.manual_marks import COMMAND, FILE, ManualMark, RubricItem, login_name
from corollary.records.marks import stored_record
from corollary.records.near_miss_groups import AnswerGroup, PartToMark, near_misses_record
from corollary.records.origin import set_of
from corollary.records.rubrics import score_of
from corollary.render.marks_by_hand_tables import named, score
from corollary.render.wording import points, points_earned

Give = Callable[[str, AnswerGroup, ManualMark], None]
HELP = "points, or r and the rubric's numbers (r13), then a comment if you like; empty: leave it; q: end"


def mark_in_terminal(parts: Sequence[PartToMark], give: Give, names: Mapping[str, str]) -> None:
    """Asks for each answer and gives at once what is answered; the end of input ends it, with a sentence. `names` by id; none where
    the marking is anonymous."""
    if not parts:
        print("no answer waits for marking")
    given: list[str] = []

    def give_and_count(part: str, group: AnswerGroup, mark: ManualMark) -> None:
        give(part, group, mark)
        given.extend(group.students)

    try:
        _ask_all(parts, give_and_count, names)
    except EOFError:
        print(
            f"\nthe input ended: {counted(len(given), 'mark')} given and saved; the other answers still wait"
        )


def _ask_all(parts: Sequence[PartToMark], give: Give, names: Mapping[str, str]) -> None:
    for part in parts:
        print(f"\n{part.problem} {part.part} {part.title} ({points_earned(part.out_of)})")
        for number, item in enumerate(part.rubric, 1):
            print(f"  {number} {visible(item)}")
        for place, group in enumerate(part.groups, 1):
            if not _ask(part, group, f"answer {place} of {len(part.groups)}", give, names):
                return


def read_mark(line: str, part: PartToMark) -> ManualMark | str:
    """What was typed: `1.5 Well argued`, `r12`. A sentence for what is none of it."""
    first, _, comment = line.strip().partition(" ")
    items: tuple[RubricItem, ...] | None = None
    if first.startswith("r") and first[1:].isdigit():
        chosen = {int(each) for each in first[1:]}
        if wrong := [each for each in chosen if not 1 <= each <= len(part.rubric)]:
            return f"the rubric has no item {wrong[0]}"
        items = tuple(part.items[each - 1] for each in sorted(chosen))
        score = score_of(items, part.out_of)
    else:
        try:
            score = float(first.replace(",", "."))
        except ValueError:
            return HELP
    if not 0 <= score <= part.out_of:
        return f"from 0 to {points(part.out_of)} points"
    comment = comment.strip() or None
    return ManualMark(round(score, 2), None, comment, by=login_name(), rubric=items, source=COMMAND)


def _ask(part: PartToMark, group: AnswerGroup, heading: str, give: Give, names: Mapping[str, str]) -> bool:
    """Whether to go on. Raises EOFError."""
    count = f", given by {len(group.students)} students" if len(group.students) > 1 else ""
    late = f", {group.late} late" if group.late else ""
    print(f"\n--- {heading}{count}{late}")
    if names:
        print(visible(few([named(each, names) for each in group.students], MOST_LISTED)))
    if group.outside is not None:
        before, after = (score(each) for each in (group.outside.before, group.outside.after))
        print(f"changed in the gradebook from {before} to {after}; it does not count until you give points")
    if group.request is not None:
        print(f"request for regrading:\n{visible(group.request.text)}")
    if group.near_miss is not None:
        print(f"near miss of reading ({group.near_miss.kind}): it earned nothing; read otherwise it is right")
        for each in group.near_miss.answers:
            print(visible(f"  {each.typed} as {each.read}"))
    for cell in group.cells:
        print(visible(cell.verbatim))
        if cell.pictures:
            print(f"[{len(cell.pictures)} pictures; corollary mark without --terminal shows them]")
    while True:
        line = input(f"points of {points(part.out_of)}> ")
        if line.strip() == "q":
            return False
        if not line.strip():
            return True
        mark = read_mark(line, part)
        if isinstance(mark, ManualMark):
            try:
                give(part.key, group, mark)
            except ChangedMeanwhile as changed:
                print(changed)
            return True
        print(mark)


Marks = dict[tuple[str, str], tuple[ManualMark, str]]  # and where each is written
COLUMNS = ("student", "part", "points", "comment")


def run(
    name: str,
    course: Path,
    bank: Path | None,
    as_json: bool,
    everything: bool,
    anonymous: bool,
    terminal: bool,
    given: list[str],
    stands: list[str],
    file: Path | None,
    accepted: list[str],
    no_browser: bool,
    port: int = 0,
    section: str | None = None,
    group: str | None = None,
) -> int:
    opened = open_course(course)
    only = ids_in(opened, section, group)
    place, problem_set = set_of(opened, name, bank)
    written = (
        (_accepted(opened, problem_set, accepted) if accepted else {})
        | (_from_file(opened, problem_set, file) if file else {})
        | _from_words(opened, problem_set, given)
        | _standing(opened, problem_set, stands)
    )
    marks = {key: mark for key, (mark, _) in written.items()}
    people = {} if anonymous else {each.id: each.name for each in students(opened)}
    if marks:
        try:
            give_marks(opened, problem_set, marks, {key: where for key, (_, where) in written.items()})
        except NotMarkable as error:
            raise NotMarkable(f"{error}; no mark was given") from None
    elif terminal:
        parts = to_mark(opened, problem_set, everything=everything, only=only)
        mark_in_terminal(
            parts, lambda part, group, mark: _give(opened, problem_set, part, group, mark), people
        )
    elif not as_json:
        _serve(opened, problem_set, place, everything, anonymous, only, no_browser, port)
    if marks or terminal or not as_json:
        up_to_date(opened, problem_set)  # the report's page, once for all marks
    if as_json:
        left = to_mark(opened, problem_set, everything=everything, only=only)
        parts = [_record(each, people) for each in left]
        answer({"set": problem_set.name, "given": len(marks), "parts": parts})
    elif marks:
        withdrawn = sum(not mark.is_given for mark in marks.values())
        for count, what in ((len(marks) - withdrawn, "given"), (withdrawn, "taken back")):
            if count:
                print(f"{counted(count, 'mark')} {what} in {problem_set.name}")
    return HOLDS


def _serve(
    course: Course,
    problem_set: ProblemSet,
    bank: Bank,
    everything: bool,
    anonymous: bool,
    only: Collection[str] | None,
    no_browser: bool,
    port: int,
) -> None:
    from corollary.cli.mark_page import MarkPage  # brings the derivations

    pages = MarkPage(course, problem_set, bank, everything, anonymous, only)
    pages.page()  # what is wrong with the course is said before anything is opened
    if has_gradebook(course):  # nbgrader takes seconds to load, and the first mark is not to wait for it
        Thread(target=need_nbgrader, daemon=True).start()
    serve(
        OnePageServer(pages.page, pages.receive, port),
        "ctrl-C ends it, and what you gave is saved",
        no_browser,
    )


def _give(course: Course, problem_set: ProblemSet, part: str, group: AnswerGroup, mark: ManualMark) -> None:
    """For each student of the group; raises ChangedMeanwhile where that is not what was shown."""
    marks = {(student, part): one for student, one in marks_of(group, mark)}
    seen = {(student, part): token for student, token in zip(group.students, group.seen, strict=True)}
    give_marks(course, problem_set, marks, seen=seen)


def _accepted(course: Course, problem_set: ProblemSet, wanted: list[str]) -> Marks:
    """All points for every answer of these groups of near misses."""
    groups = {each.id: each for each in up_to_date(course, problem_set).near_misses}
    found: Marks = {}
    for one in wanted:
        if one not in groups:
            have = f"; its groups are {', '.join(groups)}" if groups else "; it has none"
            refuse(f"--accept {one}: {problem_set.name} has no near misses of this name{have}")
        group, where = groups[one], f"--accept {one}"
        for each in group.answers:
            record = stored_record(course, problem_set.name, each.student)
            key = part_named(problem_set, f"{group.problem} {group.part}", record)
            mark = ManualMark(each.points, None, accepted_text(each.read), by=login_name(), source=COMMAND)
            found[each.student, key] = mark, where
    return found


def _from_words(course: Course, problem_set: ProblemSet, given: list[str]) -> Marks:
    """`ada/X12.5 d=1.5`, as often as you like."""
    found: Marks = {}
    ids = _ids(course)
    for words in given:
        place, _, number = words.rpartition("=")
        where = f"--set {words}"
        key = _place_in(course, problem_set, place, ids, where, "POINTS, for instance ada/X12.5d=1.5")
        found[key] = ManualMark(_points(number, where), by=login_name(), source=COMMAND), where
    return found


def _standing(course: Course, problem_set: ProblemSet, given: list[str]) -> Marks:
    """`ada/X12.5a=why`: a request for regrading is answered, and the mark is as it was."""
    found: Marks = {}
    ids = _ids(course)
    for words in given:
        place, equals, reason = words.partition("=")
        where = f"--stands {words}"
        example = "REASON, for instance ada/X12.5a='the floor takes momentum, too'"
        key = _place_in(course, problem_set, place if equals else "", ids, where, example)
        mark = ManualMark(None, None, reason.strip() or None, by=login_name(), source=COMMAND)
        found[key] = as_it_stands(course, problem_set, *key, mark), where
    return found


def _from_file(course: Course, problem_set: ProblemSet, file: Path) -> Marks:
    found: Marks = {}
    table = read_table(file, COLUMNS)
    head = [cell.lower() for cell in table.first]
    if missing := set(COLUMNS[:3]) - set(head):
        refuse(
            f"{file}: the columns {', '.join(sorted(missing))} are missing; it needs student, part, points, and may have comment"
        )
    ids = _ids(course)
    for line, row in table.rows[1:]:
        where = f"{file}:{line}"
        if any(row[len(head) :]) or len(row) <= head.index("points"):
            refuse(
                f"{where}: has {len(row)} cells under {len(head)} headings; write points with a comma in quotation marks, or with a point"
            )
        cells = dict(zip(head, row, strict=False))
        student = ids.get(cells["student"], cells["student"])
        key = _place(course, problem_set, student, cells["part"], where)
        comment = cells.get("comment") or None
        found[key] = (
            ManualMark(_points(cells["points"], where), None, comment, by=login_name(), source=FILE),
            where,
        )
    return found


def _place_in(
    course: Course, problem_set: ProblemSet, words: str, ids: Mapping[str, str], where: str, example: str
) -> tuple[str, str]:
    """The place that `ada/X12.5 d` names; empty `words` name none. Raises NotMarkable."""
    student, slash, part = words.rpartition("/")
    if not slash:
        refuse(f"{where}: write it as STUDENT/PART={example}")
    return _place(course, problem_set, ids.get(student, student), part, where)


def _place(course: Course, problem_set: ProblemSet, student: str, part: str, where: str) -> tuple[str, str]:
    """The student and the part by the names that marks go by. Raises NotMarkable, which opens with `where`."""
    try:
        return student, part_named(problem_set, part)
    except NotMarkable:  # it may be one that was handed out and taken out of the problem since
        record = stored_record(course, problem_set.name, student)
    try:
        return student, part_named(problem_set, part, record)
    except NotMarkable as error:
        raise NotMarkable(f"{where}: {error}; no mark was given") from None


def _ids(course: Course) -> dict[str, str]:
    """The students' own ids, by whatever else the roster knows them by; an id of one's own comes before another's address."""
    everybody = students(course)
    others = {
        other: each.id for each in reversed(everybody) for other in (each.email, *dict(each.ids).values())
    }
    return others | {each.id: each.id for each in everybody}


def _points(text: str, where: str) -> float | None:
    """A number with a point or a comma; nothing takes the mark back."""
    if not text.strip():
        return None
    try:
        return float(text.strip().replace(",", "."))
    except ValueError:
        refuse(f"{where}: {text} is not a number of points")


def _record(part: PartToMark, names: Mapping[str, str]) -> dict[str, Any]:
    groups = [
        {
            "students": list(group.students),
            "names": {each: names[each] for each in group.students if each in names},
            "answer": [cell.verbatim for cell in group.cells],
            "late": group.late,
            "why": group.why,
            "given": None if group.given is None else msgspec.to_builtins(group.given),
            "again": group.again,
            "points": group.points,
            "outside": None if group.outside is None else msgspec.to_builtins(group.outside),
            "request": None if group.request is None else msgspec.to_builtins(group.request),
            "near_miss": None if group.near_miss is None else near_misses_record(group.near_miss),
        }
        for group in part.groups
    ]
    return {
        "key": part.key,
        "problem": part.problem,
        "part": part.part,
        "title": part.title,
        "out_of": part.out_of,
        "rubric": list(part.rubric),
        "items": [{"id": one.id, "text": one.text, "points": one.share * part.out_of} for one in part.items],
        "groups": groups,
    }
