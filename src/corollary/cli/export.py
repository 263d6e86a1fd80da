"""`corollary export`: a set or its marks in another form."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict
from pathlib import Path

from corollary.cli.console import console
from corollary.cli.ending import HOLDS, answer, counted, refuse, say
from corollary.cli.progress import bar
from corollary.course.export import (
    chapters_sheet,
    owners,
    sheet_files,
    sheets_for,
    sheets_of_course,
    write_files,
)
from corollary.course.feedback import feedback_files
from corollary.course.item_export import Exported, export_items
from corollary.course.marks_export import By, Template, marks_file, marks_table
from corollary.course.paper import form_owners, print_files
from corollary.grading.solutions import Solutions
from corollary.messages import few
from corollary.notebook.worksheet import Worksheet
from corollary.problem.problem_set import ProblemSet, bank_of_set, find_set
from corollary.problem.roster import read_roster
from corollary.records.files import Course, open_course, students
from corollary.records.lms_file import FilledIn
from corollary.records.marks_table import MarksTable, Notation
from corollary.records.origin import set_of
from corollary.render.exports import Target, target
from corollary.render.paper.sheet import PaperSheet


def run(
    sets: Sequence[str],
    to: str,
    course: Path | None,
    roster: Path | None,
    bank: Path | None,
    variants: int | None,
    solution: bool,
    columns: By | None,
    decimals: int | None,
    out_of: float | None,
    blank: str | None,
    template: Path | None,
    headings: Sequence[str],
    output: Path,
    as_json: bool,
    ids: Path | None = None,
    forms: int | None = None,
    formula_sheet: bool = False,
    large_print: bool = False,
    apart: bool = False,
    left_out: Sequence[str] = (),
    pyodide: Path | None = None,
) -> int:
    chosen, sets = target(to), list(dict.fromkeys(sets))
    if chosen.site:
        if course is not None or roster is not None or forms is not None:
            refuse(f"{to} is for everybody; say how many variants of each problem with --variants")
        from corollary.cli.export_site import run as export_site  # here, since it brings the scenes

        return export_site(sets, bank, left_out, pyodide, variants, as_json)
    if left_out or pyodide:
        refuse(f"--except and --pyodide are for a site; leave them out for {to}")
    if chosen.items is not None:
        if given := _of_marks(columns, decimals, out_of, blank, headings, template):
            refuse(f"{given} is for marks, and {to} holds none; leave it out")
        if course is not None or roster is not None or forms is not None:
            refuse(f"{to} is a pool for everybody; say how many variants of each problem with --variants")
        return _questions(chosen, to, sets, bank, variants, apart, output, as_json)
    if apart:
        refuse(f"--apart is for questions of an LMS; leave it out for {to}")
    if sum(each is not None for each in (course, roster, variants, forms)) > 1:
        refuse("--course, --roster, --variants and --forms each choose the numbers; give one of them")
    for option, given in (
        ("--forms", forms),
        ("--formula-sheet", formula_sheet),
        ("--large-print", large_print),
    ):
        if given and chosen.paper is None:
            refuse(f"{option} is for paper; leave it out, or export --to pdf")
    opened = None if course is None else open_course(course)
    found = [
        set_of(opened, name, bank) if opened else (there := bank_of_set(bank, name), find_set(there, name))
        for name in sets
    ]
    problem_sets = [problem_set for _, problem_set in found]
    names = [each.name for each in problem_sets]
    about: dict[str, object] = {"set": names[0]} if len(names) == 1 else {"sets": names}
    if chosen.marks is not None:
        if opened is None:
            refuse(f"{to} holds marks; say of which course with --course")
        if headings and template is None:
            refuse("--column names a column of a template; give the file with --template")
        every = chosen.every_column and len(sets) == 1 and template is None
        notation = Notation(2 if decimals is None else decimals, out_of, blank or "")
        table = marks_table(opened, problem_sets, columns or ("every" if every else "sets"), notation)
        made = marks_file(chosen, table, None if template is None else Template(template, headings))
        _say_of_marks(table, made)
        word = "" if to == "csv" else f"-{to}"
        files = {f"{'-'.join(names)}{word}.{chosen.ending}": made.content}
        about |= {
            "strangers": made.strangers,
            "absent": made.absent,
            "waiting": table.waiting,
            "again": table.again,
        }
    elif given := _of_marks(
        columns, decimals, out_of, blank, headings, template if chosen.feedback is None else None
    ):
        refuse(f"{given} is for marks, and {to} holds none; leave it out")
    elif len(sets) > 1:
        refuse(f"{to} is of one set; export each by itself")
    elif chosen.feedback is not None:
        if opened is None:
            refuse(f"{to} holds feedback; say of which course with --course")
        pages = feedback_files(opened, problem_sets[0], ids or template)
        if pages.without:
            say(
                f"{few(pages.without)}: {pages.lms.capitalize()} has no number of theirs that is known, so nothing goes back"
            )
        files = {f"{names[0]}-feedback-{pages.lms}.{chosen.ending}": chosen.feedback(pages.files)}
        about |= {"without": pages.without}
    elif chosen.paper is not None:
        (place, problem_set), *_ = found
        solutions = Solutions(place)
        if forms is None:
            sheets = [PaperSheet(each) for each in _sheets(opened, roster, variants, problem_set, solutions)]
        else:
            dealt = sheets_for(problem_set, solutions, form_owners(forms))
            sheets = [PaperSheet(each, each.student.id) for each in dealt]
        run_of = chosen.paper(problem_set, sheets, solutions, large_print, formula_sheet, solution)
        with bar("sheets and keys", len(sheets)) as done:
            files = print_files(run_of, done)
    elif chosen.worksheet is None and chosen.problem_set is None:
        refuse(f"{to} is for single exercises; write it with: corollary show CODE --format {to}")
    else:
        (place, problem_set), *_ = found
        solutions = Solutions(place)
        sheets = _sheets(opened, roster, variants, problem_set, solutions)
        files = sheet_files(chosen, problem_set, sheets, solutions if solution else None)
    written = write_files(output, files)
    if as_json:
        answer({**about, "to": to, "files": [str(path) for path in written]})
    else:
        count = len(written)
        titles = ", ".join(each.title for each in problem_sets)
        print(f"{titles}: {count} file{'s' * (count != 1)} in {output}/")
    return HOLDS


def _questions(
    chosen: Target,
    to: str,
    names: Sequence[str],
    bank: Path | None,
    variants: int | None,
    apart: bool,
    output: Path,
    as_json: bool,
) -> int:
    """Questions of an LMS, and a table of what became of each part."""
    records: list[dict[str, object]] = []
    for name in names:
        made = export_items(chosen, bank, name, variants, apart)
        written = write_files(output, made.files)
        records.append(
            {
                "set": name,
                "to": to,
                "files": [str(path) for path in written],
                "variants": made.variants,
                "parts": [asdict(each) for each in made.parts],
                "lost": made.lost,
            }
        )
        if not as_json:
            _show_parts(made)
            print(f"{made.title}: {', '.join(str(path) for path in written)}")
            if variants is not None and (
                few_of := [code for code, n in made.variants.items() if n < variants]
            ):
                say(f"no {variants} variants are there of {few(few_of)}: as many as there are")
    if as_json:
        answer(records[0] if len(records) == 1 else records)
    return HOLDS


def _show_parts(made: Exported) -> None:
    from rich.table import Table

    table = Table("part", "carried as", "not carried")
    for each in made.parts:
        table.add_row(f"{each.code} ({each.part})", each.how or "refused", each.lost)
    console().print(table)
    refused = sum(not each.how for each in made.parts)
    print(f"{len(made.parts) - refused} parts carried, {refused} refused. Of none is carried:")
    for each in made.lost:
        print(f"- {each}")


def _of_marks(*values: object) -> str:
    """The first option given of those that only marks have; "" for none."""
    options = ("--columns", "--round", "--out-of", "--blank", "--column", "--template")
    given = (option for option, value in zip(options, values, strict=True) if value not in (None, [], ()))
    return next(given, "")


def _say_of_marks(table: MarksTable, made: FilledIn) -> None:
    """What whoever imports the file should know."""
    for note in made.notes:
        say(note)
    if table.is_blank:
        say("nobody has marks yet, for nothing was handed in when it was graded: every mark is blank")
    for who, what in (
        (made.strangers, "in the file and not in the course, left as they are"),
        (made.absent, "of the course, not in the file"),
        (
            table.out_of_another,
            "with a sheet out of other points than the column (--out-of N makes all marks out of N)",
        ),
        (
            table.again,
            "with a new answer to what a person had marked; the marks of the earlier answers count until the new ones are marked",
        ),
        (table.waiting, "with parts that wait for a person; those points are not in the marks yet"),
    ):
        if who:
            say(f"{counted(len(who), 'student')} {what}: {few(who)}")


def _sheets(
    course: Course | None,
    roster: Path | None,
    variants: int | None,
    problem_set: ProblemSet,
    solutions: Solutions,
) -> list[Worksheet]:
    """The course's own sheets, else new ones for a roster or for so many variants, else one with the chapter's numbers."""
    if course is not None:
        sheets = sheets_of_course(course, problem_set)
        if not sheets:
            refuse(
                f"{problem_set.name} was never generated in {course.folder}; run corollary generate {problem_set.name} first"
            )
        if without := len(students(course)) - len(sheets):
            say(
                f"{without} of the roster have no numbers yet and get no file; generate {problem_set.name} again"
            )
        return sheets
    if roster is not None:
        return sheets_for(problem_set, solutions, read_roster(roster).students)
    if variants is not None:
        return sheets_for(problem_set, solutions, tuple(owners(variants)))
    return [chapters_sheet(problem_set)]
