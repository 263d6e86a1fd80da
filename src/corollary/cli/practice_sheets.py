"""Practice sheets written into a folder: one folder a student, and a table of what each practises."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from corollary.atomic import write_whole
from corollary.cli.ending import counted, say
from corollary.cli.open_sets import not_to_be_practised
from corollary.cli.terminal import bar
from corollary.course.practice_sheets import PracticeMaker, misconceptions_to_practise, practice_sheets
from corollary.problem.csv_table import table_text
from corollary.records.files import Course
from corollary.records.misconception_history import Followed
from corollary.records.misconception_names import MisconceptionNames
from corollary.records.term import CourseTerm
from corollary.render.practice_sheet import PracticeLine, practice_files

COLUMNS = ("id", "name", "email", "misconception", "exercise", "number", "part")


def write_practice_sheets(
    folder: Path,
    course: Course,
    term: CourseTerm,
    followed: Sequence[Followed],
    names: MisconceptionNames,
) -> None:
    """For the instructor to give back with the feedback; the folder is readable by nobody else."""
    banks = {str(each.bank.place): each.bank for each in term.sets if each.bank is not None}
    still_open = set[str]().union(*(not_to_be_practised(bank, [], course) for bank in banks.values()))
    wanted = misconceptions_to_practise(term, followed, names)
    people = {line.student.id: line.student for line in term.students}
    rows, count = list[Sequence[str]]([COLUMNS]), 0
    folder.mkdir(mode=0o700, parents=True, exist_ok=True)
    with bar("practice sheets", len(wanted)) as done:
        for student, exercises in practice_sheets(PracticeMaker(course, term, names, still_open), wanted):
            who = people[student]
            lines = [PracticeLine(each.sentence, each.met, each.variant, each.turn) for each in exercises]
            for name, content in practice_files(who, lines, term.rules.practice_site).items():
                write_whole(folder / student / name, content, mode=0o600)
            for each in exercises:
                problem = each.variant.problem
                what = (each.misconception.name, problem.code, str(each.turn), problem.parts[-1].id)
                rows.append((student, who.name, who.email, *what))
            count += 1
            done(student)
    write_whole(folder / "practice.csv", table_text(rows), mode=0o600)
    say(f"{counted(count, 'practice sheet')} in {folder}/; practice.csv says what each practises")
