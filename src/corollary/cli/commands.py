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
    FORMAT,
    GENERATED_BANK,
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
    SOLUTION,
    VARIANTS,
    VERIFYING_CLUSTER,
    WAY_OUT,
    WHAT_CAME,
    all_when_left_out,
    flag,
    path,
    several,
    text,
)
from corollary.version import __version__


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
click.version_option(__version__, message="%(version)s", help="Show the version and leave.")(app)


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
    "Every problem: code, title, topic, givens, parts, kinds of answer, number of distinct variants.",
    *LISTED,
    BANK,
    JSON,
    module="listing",
)
command(
    "show",
    "One problem as a student sees it.",
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
    "The answer key for given numbers, every digit certified. Status 2: a given is unknown or against the physics.",
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
    "Marks plain answers, no notebook needed.",
    CODE,
    path("--cases", text='A JSON list of {"given": {…}, "answers": {…}}.', required=True),
    BANK,
    OF_COURSE,
    flag("--reveal", "Feedback may give the right values."),
    JSON,
)
command(
    "read",
    "How an answer is read, and what would be decided.",
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
    "Runs a ready-made scene with the least model that answers, and says which and why. Status 1: the run cannot be followed; "
    "2: a setting is wrong.",
    *PLAYED,
    BANK,
    JSON,
)
command(
    "verify",
    "Proves problems and solutions right, or says what is wrong; of a set also what differs between the problems of a pool.",
    all_when_left_out("codes", "[CODE|SET]...", "Problems, or sets, to verify", CODES_AND_SETS),
    BANK,
    VARIANTS,
    JSON,
    flag("--extremes", "Instead: closed forms at the ends of the range."),
    path("--report", text="Write what was found as a page: derivations, obligations, answers over the grid."),
    flag("--anew", "Verify also what held before and has not changed since."),
    flag("--verbose", "Show notes, too, and not only how many there are."),
    VERIFYING_CLUSTER,
    flag("--watch", "Verify one problem again whenever it is saved, until ctrl-C."),
)
command(
    "audit",
    "Somebody else's answer key: agrees, last figure, wrong, not unique, impossible, ambiguous, cannot say.",
    *AUDITED,
    JSON,
)
command(
    "certify",
    "A proof script of the key, for all numbers, that an independent kernel (Coq) checks.",
    CODE,
    BANK,
    path("--output", "-o", text="Where the script goes; CODE.v in the working folder when left out."),
    flag("--check", "Let coqc check it, and put hash and version on the key's record."),
    JSON,
)
command(
    "new",
    "A problem and its solution that verify as written, to be bent into one's own.",
    *NEW,
    BANK,
    JSON,
)
command(
    "preview",
    "A local page that reloads: twenty variants, redrawn ones marked and why, key, mistakes and tolerance.",
    CODE,
    *BANK_AND_LANGUAGE,
    *PAGE,
)
command(
    "practise",
    "A local page to practise on: any exercise, other numbers each time, hints, and the worked solution step by step.",
    all_when_left_out("wanted", "[CODE|TOPIC|SET]...", "What to practise on", CODES_AND_SETS),
    *BANK_AND_LANGUAGE,
    several(
        "--except",
        "left_out",
        "Leave out the problems of this set, as those of sets that are not due yet",
        SETS,
    ),
    path(
        "--course", text="Whose open sets are left out, too; the one around the working folder when left out."
    ),
    *PAGE,
)
command("schema", "The JSON schema of a problem's front matter, for editors.")
command(
    "trade",
    "Measures speed against accuracy; writes the table and the picture.",
    all_when_left_out("scenes", "[SCENE]...", 'cradle, spheres, "cradle N=3 q=1.5" …', SCENES),
    path("--output", "-o", text="Where table and pictures go; trade/ when left out (nowhere with --json)."),
    JSON,
    flag("--quick", "Without the longest runs, each timed once."),
)
command(
    "generate",
    "A problem set, different for each student, as an nbgrader course.",
    SET,
    path(
        "--roster",
        text="A CSV file: nbgrader's, Moodle's participants, Canvas's gradebook, or ids alone.",
        required=True,
    ),
    COURSE,
    *BANK_AND_LANGUAGE,
    JSON,
    text("--id-column", "The roster's column with the ids, by name or number."),
    flag("--not-renamed", "What looks renamed is not: what is gone is gone, and what is new is new."),
    flag("--renew", "Give who has not handed in the sheet of today, where the set was corrected since."),
    flag("--yes", "Agree to what is asked: taken off the roster, called otherwise, given another sheet."),
)
command(
    "release",
    "Gives each student the own sheet: nbgrader's exchange, folders, archives, a mailing, Moodle, Canvas.",
    SET,
    WAY_OUT,
    COURSE,
    GENERATED_BANK,
    path("--output", "-o", text="The folder for the files; given_out/ in the course when left out."),
    path(
        "--ids", text="What Moodle or Canvas knows the students by: a grading worksheet, or all submissions."
    ),
    flag("--force", "Release to the exchange again."),
    JSON,
)
command(
    "collect",
    "Takes what came back: Moodle's and Canvas's archives of all submissions, folders, renamed notebooks.",
    SET,
    WHAT_CAME,
    COURSE,
    GENERATED_BANK,
    path("--times", text="Moodle's grading worksheet, which says when each was handed in."),
    flag("--dry-run", "Say what would be taken, and write nothing."),
    JSON,
)
command(
    "grade",
    "Marks what was handed in: gradebook, feedback, report.",
    SET,
    COURSE,
    GENERATED_BANK,
    JSON,
    flag("--regrade", "Mark again what is marked, and show first who changes."),
    flag("--dry-run", "Mark, show who changes, and write nothing."),
    flag("--yes", "Move marks that were given already without asking."),
    flag(
        "--strict", "Status 1, too, where students' files could not be opened, run, or matched to a student."
    ),
    flag("--reveal", "From now on feedback gives right values, in a set that says reveal: by hand."),
    *RUNNING,
)
command(
    "extend",
    "A deadline of one's own, or an excuse, for one student.",
    *EXTENDED,
    COURSE,
    flag("--excuse", "The student need not hand in: reports and exports leave the marks blank."),
    flag("--remove", "Take back the extension or the excuse."),
    click.Option(
        ["--list", "listing"], is_flag=True, help="Who has which; of STUDENT, or of SET, when named."
    ),
    JSON,
)
command(
    "mark",
    "Marking by hand, all answers to one part together: a page on this machine.",
    SET,
    COURSE,
    GENERATED_BANK,
    *MARKING,
    *PAGE,
    JSON,
)
command(
    "report",
    "What an instructor reads: marks, each part, misconceptions met, what waits for a person.",
    SET,
    COURSE,
    GENERATED_BANK,
    JSON,
    path("--output", "-o", text="Write the page here too."),
    flag("--statistics", "Also difficulty, discrimination, and what the numbers drawn did, with intervals."),
    path("--csv", text="Write these statistics here as a table."),
)
command(
    "export",
    "A set as files for elsewhere: each student's sheet, or the marks of all.",
    *EXPORTED,
    path("--course", text="The sheets, or the marks, of this course's students."),
    path("--roster", text="Without a course: a sheet for everybody in this CSV file."),
    GENERATED_BANK,
    click.Option(
        ["--variants"],
        type=AT_LEAST_1,
        help="Without either: so many sheets with distinct numbers; of questions, so many of each problem.",
    ),
    flag("--apart", "Questions of an LMS: each part one of its own, with numbers of its own."),
    several("--except", "left_out", "site: leave out the problems of this set", SETS),
    path("--pyodide", text="site: the unpacked npm package pyodide; it is fetched when left out."),
    SOLUTION,
    *PRINTED_AND_MARKED,
    path("--ids", text="feedback-zip: what Moodle or Canvas knows the students by, as for release."),
    path("--output", "-o", text="The folder for the files; export/ when left out."),
    JSON,
)
command(
    "doctor",
    "Whether this machine and this course are fit for work: versions, isolation, nbgrader, disk, time zone.",
    path("--course", text="A course to look at; the one around the working folder when left out."),
    JSON,
    settings=False,
)
command(
    "demo",
    "The whole way, end to end, in a fresh folder.",
    click.Argument(
        ["folder"], type=PATH, default=Path("demo"), required=False, help="A fresh folder for the course."
    ),
    JSON,
)
