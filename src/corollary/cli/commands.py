"""The commands by name, with the arguments and options of each, and the command `corollary` that they belong to."""

from __future__ import annotations

from functools import partial
from pathlib import Path
from typing import Any

import click

from corollary.cli.completion import CODES_AND_SETS, SCENES, SETS, STUDENTS
from corollary.cli.ending import run
from corollary.cli.left_out import completed
from corollary.cli.parameters import (
    AT_LEAST_1,
    AUDITED,
    BANK,
    BANK_AND_LANGUAGE,
    CODE,
    COURSE,
    EXPORTED,
    EXTENDED,
    FORGOTTEN,
    FORMAT,
    GENERATED_BANK,
    IN_PART,
    JSON,
    LISTED,
    MARKING,
    NEW,
    OF_COURSE,
    PAGE,
    PATH,
    PLAYED,
    PRINTED_AND_MARKED,
    RUNNING,
    SET,
    SET_IF_ANY,
    SOLUTION,
    VARIANTS,
    VERIFYING_CLUSTER,
    WAY_OUT,
    WHAT_CAME,
    WHOLE_COURSE,
    all_when_left_out,
    flag,
    path,
    several,
    text,
)
from corollary.version import full_version


class Commands(click.Group):
    """The commands in the order in which a course needs them."""

    def list_commands(self, ctx: click.Context) -> list[str]:
        return list(self.commands)


app = Commands(
    "corollary",
    no_args_is_help=True,
    context_settings={"help_option_names": ["-h", "--help"]},
    help="Physics exercises whose answers are derived from the laws: numbers for each student, marks for what they hand in.",
)


def _show_version(context: click.Context, _: click.Parameter, wanted: bool) -> None:
    if wanted:
        click.echo(full_version())
        context.exit()


app.params.append(
    click.Option(
        ["--version"],
        is_flag=True,
        is_eager=True,
        expose_value=False,
        callback=_show_version,
        help="Show the version, with the commit where it is not a release's, and leave.",
    )
)


def command(
    name: str, sentence: str, *parameters: click.Parameter, module: str = "", settings: bool = True
) -> None:
    """One more command: `run` of its module in this folder gets the parameters by name, and gives the exit status.

    `settings`: what is left out is as the course has it.
    """
    of_course = partial(completed, course_needed=COURSE in parameters, any_bank=BANK in parameters)
    callback = partial(run, module or name, of_course if settings else dict[str, Any])
    app.add_command(click.Command(name, params=list(parameters), help=sentence, callback=callback))


command(
    "list",
    "List every problem: code, title, topic, givens, parts, answer types, number of distinct variants.",
    *LISTED,
    BANK,
    JSON,
    module="listing",
)
command(
    "show",
    "Show one problem as a student sees it.",
    CODE,
    *BANK_AND_LANGUAGE,
    text("--student", "The numbers this student would get (with --course: those dealt there).", STUDENTS),
    OF_COURSE,
    click.Option(["--variant"], type=int, help="The variant with this index in the grid."),
    SOLUTION,
    FORMAT,
    JSON,
    path("--output", "-o", text="Write to this file."),
)
command(
    "key",
    "Print the answer key for given numbers, every digit certified. Status 2: a given is unknown or physically impossible.",
    CODE,
    BANK,
    several("--set", "givens", 'A given: m=0.43 (SI) or v="72 km/h"'),
    text("--student", "The numbers this student would get (with --course: those dealt there).", STUDENTS),
    OF_COURSE,
    path("--cases", text="A JSON list of givens in SI; the answer is a list."),
    JSON,
)
command(
    "judge",
    "Mark plain answers, without a notebook.",
    CODE,
    path("--cases", text='A JSON list of {"given": {…}, "answers": {…}}.', required=True),
    BANK,
    path("--course", text="Look for the problem first in the banks of this course's sets."),
    flag("--reveal", "Feedback may give the right values."),
    JSON,
)
command(
    "read",
    "Show how an answer is read, and what would be decided.",
    click.Argument(["text"], required=False, help="An answer as typed: 8,6 Ns"),
    text("--unit", "The unit asked for."),
    text("--equals", "A formula to compare with."),
    text("--names", "The letters of the formula: m,v,M"),
    several("--domain", "domain", "Where a letter lives: v=-10..10"),
    path("--cases", text='A JSON list of {"text": …, "field": …}.'),
    flag("--explain", "Print the stages of the reading: what each took, what it left."),
    JSON,
)
command(
    "scene",
    "Run a ready-made scene with the simplest sufficient model, and say which and why. Status 1: the run cannot be continued; "
    "2: a setting is wrong.",
    *PLAYED,
    BANK,
    JSON,
)
command(
    "verify",
    "Prove problems and solutions right, or say what is wrong; for a set also compare the problems of a pool.",
    all_when_left_out("codes", "[CODE|SET]...", "Problems, or sets, to verify", CODES_AND_SETS),
    BANK,
    VARIANTS,
    JSON,
    flag("--extremes", "Compare closed forms at the ends of the range instead."),
    path("--report", text="Write the findings as a page: derivations, obligations, answers over the grid."),
    flag("--anew", "Also verify what held before and is unchanged."),
    flag("--verbose", "Show the notes, and not only their number."),
    VERIFYING_CLUSTER,
    flag("--watch", "Verify one problem again whenever it is saved, until ctrl-C."),
)
command(
    "audit",
    "Audit an answer key from elsewhere: agrees, last figure, wrong, not unique, impossible, ambiguous, cannot say.",
    *AUDITED,
    JSON,
)
command(
    "certify",
    "Write a proof script of the key, for all numbers, that an independent kernel (Coq) checks.",
    CODE,
    BANK,
    path("--output", "-o", text="The script's file; CODE.v in the working folder when left out."),
    flag("--check", "Check it with coqc, and add hash and version to the key's record."),
    JSON,
)
command(
    "new",
    "Create a problem and its solution that verify as written, ready to be changed.",
    *NEW,
    BANK,
    JSON,
)
command(
    "preview",
    "Open a local page to write a problem on: both texts beside twenty variants, verified as you type, saved on command.",
    CODE,
    *BANK_AND_LANGUAGE,
    *PAGE,
)
command(
    "practise",
    "Open a local page for practice: any exercise, new numbers each time, hints, and the worked solution step by step.",
    all_when_left_out("wanted", "[CODE|TOPIC|SET]...", "What to practise on", CODES_AND_SETS),
    *BANK_AND_LANGUAGE,
    several(
        "--except",
        "left_out",
        "Leave out the problems of this set, like those of sets that are not due yet",
        SETS,
    ),
    path(
        "--course",
        text="The course whose open sets are left out; the one around the working folder when not given.",
    ),
    *PAGE,
)
command("schema", "Print the JSON schema of a problem's front matter, for editors.")
command(
    "trade",
    "Measure speed against accuracy; write the table and the picture.",
    all_when_left_out("scenes", "[SCENE]...", 'cradle, spheres, "cradle N=3 q=1.5" …', SCENES),
    path(
        "--output", "-o", text="The folder for table and pictures; trade/ when left out (none with --json)."
    ),
    JSON,
    flag("--quick", "Skip the longest runs, and time each once."),
)
command(
    "generate",
    "Generate a problem set, different for each student, as an nbgrader course.",
    SET,
    path(
        "--roster",
        text="A CSV file: nbgrader's, Moodle's participants, Canvas's gradebook, or ids alone; the course's own when left out.",
    ),
    COURSE,
    *BANK_AND_LANGUAGE,
    JSON,
    text("--id-column", "The roster's column with the ids, by name or number."),
    flag("--not-renamed", "Treat parts that look renamed as removed and added."),
    flag("--renew", "Give students who have not handed in the corrected sheet."),
    flag("--yes", "Answer all questions with yes: students removed or renamed, sheets replaced."),
)
command(
    "release",
    "Give each student their own sheet: nbgrader's exchange, folders, archives, a mailing, Moodle, Canvas.",
    SET,
    WAY_OUT,
    COURSE,
    GENERATED_BANK,
    path("--output", "-o", text="The folder for the files; given_out/ in the course when left out."),
    path(
        "--ids",
        text="The students' numbers in Moodle or Canvas: a grading worksheet, or an archive of all submissions.",
    ),
    flag("--force", "Release to the exchange again."),
    JSON,
)
command(
    "collect",
    "Collect what was handed in: archives of Moodle and Canvas, folders, renamed notebooks.",
    SET,
    WHAT_CAME,
    COURSE,
    GENERATED_BANK,
    path("--times", text="Moodle's grading worksheet, for the times of submission."),
    flag("--dry-run", "Show what would be collected, and write nothing."),
    path("--copies", text="Write every notebook that was ever collected into this folder."),
    flag("--pack", "Pack the sheets in release/ of all who have handed in."),
    JSON,
)
command(
    "grade",
    "Mark what was handed in: gradebook, feedback, report.",
    SET,
    COURSE,
    GENERATED_BANK,
    JSON,
    flag("--regrade", "Mark again what is already marked; show first whose marks change."),
    flag("--dry-run", "Mark, show whose marks change, and write nothing."),
    flag("--yes", "Change marks that were already given without asking."),
    flag(
        "--strict",
        "Also end with status 1 if a student's file could not be opened, run, or matched to a student.",
    ),
    flag("--reveal", "From now on show right values in the feedback of a set with reveal: by hand."),
    *RUNNING,
)
command(
    "extend",
    "Extend the deadline of one student, or excuse them.",
    *EXTENDED,
    COURSE,
    GENERATED_BANK,
    flag("--excuse", "Excuse the student: reports and exports leave the marks blank."),
    flag("--remove", "Remove the extension or the excuse."),
    click.Option(
        ["--list", "listing"],
        is_flag=True,
        help="List extensions and excuses; of STUDENT, or of SET, when named.",
    ),
    JSON,
)
command(
    "forget",
    "Take one student's data out of the course: files, records, gradebook, archives, the exchange.",
    FORGOTTEN,
    COURSE,
    flag("--dry-run", "Show every place that holds something of the student, and change nothing."),
    flag("--yes", "Take it out without asking."),
    JSON,
)
command(
    "mark",
    "Mark by hand, all answers to one part together, on a local page.",
    SET,
    COURSE,
    GENERATED_BANK,
    *MARKING,
    *IN_PART,
    *PAGE,
    JSON,
)
command(
    "report",
    "Write the instructor's report: marks, each part, misconceptions, answers waiting for a person.",
    SET_IF_ANY,
    COURSE,
    GENERATED_BANK,
    JSON,
    path("--output", "-o", text="Write the page here too."),
    flag(
        "--statistics", "Add difficulty, discrimination, and the effect of the numbers drawn, with intervals."
    ),
    path("--csv", text="Write these statistics here as a table."),
    text("--student", "Show the whole history of one student's marks instead.", STUDENTS),
    *IN_PART,
)
command(
    "term",
    "Show the term as a whole: totals over sets, who misses what or falls behind, misconceptions from set to set.",
    COURSE,
    *IN_PART,
    JSON,
    path("--output", "-o", text="Write the page here."),
    path("--csv", text="Write the totals here as a table."),
    path("--missing", text="Write who misses a set or falls behind here, with addresses for a mail merge."),
    path("--misconceptions", text="Write each student's misconceptions by set here as a table."),
    path(
        "--practice-sheets",
        text="Write a sheet of fresh numbers into this folder for each who repeats a misconception.",
    ),
)
command(
    "export",
    "Export a set as files for other systems: each student's sheet, or all marks.",
    *EXPORTED,
    path("--course", text="Export the sheets, or the marks, of this course's students."),
    path("--roster", text="Without a course: a sheet for each student in this CSV file."),
    GENERATED_BANK,
    click.Option(
        ["--variants"],
        type=AT_LEAST_1,
        help="Without either: this many sheets with distinct numbers; for questions, this many of each problem.",
    ),
    flag("--apart", "Questions for an LMS: each part as a separate question, with its own numbers."),
    several("--except", "left_out", "site: leave out the problems of this set", SETS),
    path("--pyodide", text="site: the unpacked npm package pyodide; it is fetched when left out."),
    SOLUTION,
    *PRINTED_AND_MARKED,
    *WHOLE_COURSE,
    path("--ids", text="feedback-zip: the students' numbers in Moodle or Canvas, as for release."),
    path(
        "--practice",
        text="feedback-zip: add the practice sheets of this folder, as corollary term wrote them.",
    ),
    path(
        "--output",
        "-o",
        text="The folder for the files; export/ when left out. With --person or --archive: the file.",
    ),
    JSON,
)
command(
    "share",
    "Give a teaching team's group all rights in a course, and nobody else.",
    click.Option(["--group"], required=True, help="The team's group of accounts."),
    COURSE,
    JSON,
)
command(
    "doctor",
    "Check this machine and this course: versions, isolation, nbgrader, disk, time zone.",
    path("--course", text="A course to look at; the one around the working folder when left out."),
    flag("--attack", "Play hostile hand-ins in a throw-away course, and say what a student could do here."),
    JSON,
    settings=False,
)
command(
    "demo",
    "Run a whole course, end to end, in a fresh folder.",
    click.Argument(
        ["folder"], type=PATH, default=Path("demo"), required=False, help="A fresh folder for the course."
    ),
    JSON,
)
