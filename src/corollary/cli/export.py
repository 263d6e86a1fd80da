"""`corollary export`: a set or its marks in another form."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Unpack

from corollary.atomic import write_files
from corollary.cli import export_questions
from corollary.cli.ending import HOLDS, MOST_LISTED, answer, counted, refuse, say
from corollary.cli.export_options import (
    USUAL_FOLDER,
    ExportOptions,
    refuse_options_of_marks,
    refuse_what_is_for_others,
)
from corollary.cli.terminal import bar
from corollary.course.export import (
    Template,
    chapters_sheet,
    feedback_files,
    form_owners,
    marks_file,
    marks_table,
    owners,
    print_files,
    sheet_files,
    sheets_for,
    sheets_of_course,
)
from corollary.grading.solutions import Solutions
from corollary.messages import few
from corollary.notebook.worksheet import SheetPlan
from corollary.problem.bank import Bank
from corollary.problem.problem_set import ProblemSet, bank_of_set, find_set
from corollary.problem.roster import read_roster
from corollary.records.files import Course, open_course, students
from corollary.records.lms_file import FilledIn
from corollary.records.lms_names import LEFT_OUT, is_left_out
from corollary.records.marks_table import MarksTable, Notation
from corollary.records.origin import set_of
from corollary.records.outside_changes import read_outside
from corollary.render.exports import Target, target
from corollary.render.paper.sheet import PaperSheet, with_printable_names


@dataclass(frozen=True, slots=True)
class Made:
    """Files by name, and what scripts are told beside their places."""

    files: Mapping[str, bytes]
    about: Mapping[str, object] = field(default_factory=dict[str, object])


def run(**given: Unpack[ExportOptions]) -> int:
    if given["person"] is not None or given["archive"]:
        from corollary.cli.export_course import run as export_course  # here, since it reads every file

        return export_course(given)
    if not given["to"]:
        refuse("say what to write with --to TARGET, or take a whole course with --person or --archive")
    if given["keep_until"] is not None:
        refuse("--keep-until is for --archive; leave it out")
    chosen, names = target(given["to"]), list(dict.fromkeys(given["sets"]))
    refuse_what_is_for_others(chosen, given)
    if chosen.site:
        from corollary.cli.export_site import run as export_site  # here, since it brings the scenes

        return export_site(names, given)
    if not names:
        refuse("say which set: corollary export SET --to " + given["to"])
    if chosen.items is not None:
        return export_questions.run(chosen, names, given)
    course = None if given["course"] is None else open_course(given["course"])
    found = [_found(course, name, given["bank"]) for name in names]
    problem_sets = [problem_set for _, problem_set in found]
    if chosen.marks is not None:
        made = _marks(chosen, course, problem_sets, given)
    else:
        refuse_options_of_marks(given, template=chosen.feedback is not None)
        if len(names) > 1:
            refuse(f"{given['to']} is of one set; export each by itself")
        made = _of_one_set(chosen, course, *found[0], given)
    folder = given["output"] or USUAL_FOLDER
    personal = course is not None  # names, addresses and marks are for whoever exports them
    written = write_files(folder, made.files, mode=0o600 if personal else 0o644)
    if given["as_json"]:
        codes = [each.name for each in problem_sets]
        about: dict[str, object] = {"set": codes[0]} if len(codes) == 1 else {"sets": codes}
        answer({**about, **made.about, "to": given["to"], "files": [str(path) for path in written]})
    else:
        count = len(written)
        titles = ", ".join(each.title for each in problem_sets)
        print(f"{titles}: {count} file{'s' * (count != 1)} in {folder}/")
    return HOLDS


def _found(course: Course | None, name: str, bank: Path | None) -> tuple[Bank, ProblemSet]:
    if course is not None:
        return set_of(course, name, bank)
    place = bank_of_set(bank, name)
    return place, find_set(place, name)


def _marks(
    chosen: Target, course: Course | None, problem_sets: Sequence[ProblemSet], given: ExportOptions
) -> Made:
    to, template = given["to"], given["template"]
    if course is None:
        refuse(f"{to} holds marks; say of which course with --course")
    if given["headings"] and template is None:
        refuse("--column names a column of a template; give the file with --template")
    every = chosen.every_column and len(problem_sets) == 1 and template is None
    decimals = given["decimals"]
    notation = Notation(2 if decimals is None else decimals, given["out_of"], given["blank"] or "")
    table = marks_table(course, problem_sets, given["columns"] or ("every" if every else "sets"), notation)
    if to == "canvas-grades" and template is not None:
        for title in (each.title for each in table.columns if is_left_out(each.title)):
            say(
                f"{LEFT_OUT}: {title}; give the assignment another title in Canvas, and name its column with --column"
            )
    filled = marks_file(chosen, table, None if template is None else Template(template, given["headings"]))
    _say_of_marks(table, filled)
    _say_of_outside(course, problem_sets)
    word = "" if to == "csv" else f"-{to}"
    name = f"{'-'.join(each.name for each in problem_sets)}{word}.{chosen.ending}"
    about = {
        "strangers": filled.strangers,
        "absent": filled.absent,
        "waiting": table.waiting,
        "again": table.again,
    }
    return Made({name: filled.content}, about)


def _of_one_set(
    chosen: Target, course: Course | None, bank: Bank, problem_set: ProblemSet, given: ExportOptions
) -> Made:
    """Feedback, paper, or sheets."""
    to = given["to"]
    if chosen.feedback is not None:
        if course is None:
            refuse(f"{to} holds feedback; say of which course with --course")
        pages = feedback_files(course, problem_set, given["ids"] or given["template"], given["practice"])
        if pages.without:
            say(
                f"{few(pages.without)}: no file, since their number in {pages.lms.capitalize()} is unknown; give it with --ids"
            )
        _say_of_outside(course, [problem_set])
        archive = chosen.feedback(pages.files)
        name = f"{problem_set.name}-feedback-{pages.lms}.{chosen.ending}"
        return Made({name: archive}, {"without": pages.without})
    solutions = Solutions(bank)
    if chosen.paper is not None:
        if given["forms"] is None:
            sheets = [PaperSheet(each) for each in _plans(course, problem_set, solutions, given)]
        else:
            dealt = sheets_for(problem_set, solutions, form_owners(given["forms"]))
            sheets = [PaperSheet(each, each.student.id) for each in dealt]
        sheets, nameless = with_printable_names(sheets)
        if nameless:
            say(
                f"no font on this machine has all letters of {few([each.name_with_id for each in nameless], MOST_LISTED)}: "
                "the id stands on the sheet in the place of the name; install a font that has them (Noto Sans CJK has Chinese, "
                "Japanese and Korean), and export again"
            )
        run_of = chosen.paper(
            problem_set, sheets, solutions, given["large_print"], given["formula_sheet"], given["solution"]
        )
        with bar("sheets and keys", len(sheets)) as done:
            return Made(print_files(run_of, done))
    if chosen.worksheet is None and chosen.problem_set is None:
        refuse(f"{to} is for single exercises; write it with: corollary show CODE --format {to}")
    worksheets = [each.worksheet() for each in _plans(course, problem_set, solutions, given)]
    return Made(sheet_files(chosen, problem_set, worksheets, solutions if given["solution"] else None))


def _say_of_marks(table: MarksTable, made: FilledIn) -> None:
    """What whoever imports the file should know."""
    for note in made.notes:
        say(note)
    if table.is_blank:
        say("every mark is blank, because nothing was handed in when the set was graded")
    for who, what in (
        (made.strangers, "in the file but not in the course, so unchanged"),
        (made.absent, "in the course but not in the file"),
        (
            table.out_of_another,
            "with a sheet out of other points than the column (--out-of N makes all marks out of N)",
        ),
        (
            table.again,
            "with a new answer to what a person had marked; the marks of the earlier answers count until the new ones are marked",
        ),
        (table.waiting, "with parts that wait for marking; their points are not in the marks yet"),
    ):
        if who:
            say(f"{counted(len(who), 'student')} {what}: {few(who)}")


def _say_of_outside(course: Course, problem_sets: Sequence[ProblemSet]) -> None:
    """Scores changed in the gradebook that nobody has agreed to: what is written has the marks of before."""
    for each in problem_sets:
        if waiting := read_outside(course, each.name):
            people = few(sorted({place.student for place in waiting}))
            say(
                f"{counted(len(waiting), 'score')} of {each.name} changed in the gradebook, not counted yet ({people}); "
                f"corollary grade {each.name} shows them and asks"
            )


def _plans(
    course: Course | None, problem_set: ProblemSet, solutions: Solutions, given: ExportOptions
) -> list[SheetPlan]:
    """The course's own sheets, else new ones for a roster or for so many variants, else one with the chapter's numbers."""
    if course is not None:
        sheets = sheets_of_course(course, problem_set)
        if not sheets:
            refuse(
                f"{problem_set.name} was never generated in {course.folder}; run corollary generate {problem_set.name} first"
            )
        if without := len(students(course)) - len(sheets):
            say(
                f"{without} of the roster have no sheet yet and get no file; generate {problem_set.name} again"
            )
        return sheets
    if given["roster"] is not None:
        return sheets_for(problem_set, solutions, read_roster(given["roster"]).students)
    if given["variants"] is not None:
        return sheets_for(problem_set, solutions, tuple(owners(given["variants"])))
    return [chapters_sheet(problem_set)]
