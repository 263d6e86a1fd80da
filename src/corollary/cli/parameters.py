"""Arguments and options that several commands share, and how further ones are made."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from corollary.cli.completion import (
    CODES,
    CODES_AND_SETS,
    FORMATS,
    SCENES,
    SETS,
    STUDENTS,
    TARGETS,
    TOPICS,
    Complete,
)

# click itself and not typer: to read the options typer loads pydantic, which takes 0.2 s, more than a key does.
PATH = click.Path(path_type=Path)
AT_LEAST_1 = click.IntRange(min=1)


class TargetOption(click.Option):
    """Its help lists what there is, other packages' targets too: looked up only when somebody asks for it. `exercises`: only
    what one exercise can be shown as."""

    def __init__(self, *words: Any, exercises: bool = False, **settings: Any) -> None:
        super().__init__(*words, **settings)
        self.exercises = exercises

    def get_help_record(self, ctx: click.Context) -> tuple[str, str] | None:
        from corollary.plug_ins import PlugInFault
        from corollary.render.exports import OURS, names, names_for_exercises

        try:
            have = ", ".join(names_for_exercises() if self.exercises else names())
        except PlugInFault as fault:
            have = f"{', '.join(OURS)}; but {fault}"
        sentence, self.help = self.help, f"{self.help} {have}."
        try:
            return super().get_help_record(ctx)
        finally:
            self.help = sentence


def flag(name: str, sentence: str) -> click.Option:
    return click.Option([name], is_flag=True, help=sentence)


def text(name: str, sentence: str, complete: Complete | None = None) -> click.Option:
    return click.Option([name], help=sentence, shell_complete=complete)


def path(*names: str, text: str, required: bool = False) -> click.Option:
    return click.Option(names, type=PATH, required=required, help=text)


def several(name: str, parameter: str, sentence: str, complete: Complete | None = None) -> click.Option:
    words = f"{sentence}; may be repeated."
    return click.Option([name, parameter], multiple=True, help=words, shell_complete=complete)


def all_when_left_out(parameter: str, metavar: str, sentence: str, complete: Complete) -> click.Argument:
    words = f"{sentence}; all when left out."
    return click.Argument([parameter], nargs=-1, metavar=metavar, help=words, shell_complete=complete)


CODE = click.Argument(
    ["code"], help="A code (X12.5), a name (kicking_a_ball), or a path to a .md file.", shell_complete=CODES
)
SET = click.Argument(
    ["name"], metavar="SET", help="A problem set of the bank, or a path to its .md file.", shell_complete=SETS
)
SET_IF_ANY = click.Argument(
    ["name"], metavar="[SET]", required=False, help="A problem set of the course.", shell_complete=SETS
)
JSON = click.Option(["--json", "as_json"], is_flag=True, help="One JSON document on standard output.")
COURSE = path("--course", text="The course folder; the one around the working folder when left out.")
OF_COURSE = path(
    "--course",
    text="Look for the problem first in the banks of this course's sets; for --student take the numbers dealt there.",
)
BANK = click.Option(
    ["--bank"],
    type=PATH,
    multiple=True,
    help="A folder with problems/ and solutions/, or an installed bank; may be repeated. When left out, "
    "COROLLARY_BANK, the course's bank, or the chapter's.",
)
LANGUAGE = text("--language", "The language of what students read, such as de; the course's when left out.")
BANK_AND_LANGUAGE = (BANK, LANGUAGE)
GENERATED_BANK = click.Option(
    ["--bank"],
    type=PATH,
    multiple=True,
    help="A folder with problems/ and solutions/, or an installed bank; the bank the set was dealt from when left out.",
)
FORMAT = TargetOption(
    ["--format", "fmt"], help="text when left out; one of:", shell_complete=FORMATS, exercises=True
)
WAYS = ["exchange", "folder", "zip", "mail", "moodle", "canvas"]
WAY_OUT = click.Option(["--to"], required=True, type=click.Choice(WAYS), help="The means of release.")
WHAT_CAME = click.Argument(
    ["files"], nargs=-1, type=PATH, metavar="FILE|FOLDER...", help="Files from the LMS."
)
VARIANTS = click.Option(
    ["--variants"], type=AT_LEAST_1, default=100, help="How many variants to check for each problem."
)
# Not the course's setting: its cluster marks, and may not have the bank that is written on.
VERIFYING_CLUSTER = click.Option(
    ["--executor", "cluster"], default="", metavar="tcp://HOST:PORT", help="Verify on this Dask cluster."
)
SOLUTION = flag("--solution", "Add the worked solution.")


ISOLATION = click.Option(
    ["--require-isolation", "require"],
    type=click.IntRange(0, 3),
    help="Refuse to run students' code below this isolation level; 1 when left out.",
)
# What a notebook is run with, and where.
RUNNING = (
    ISOLATION,
    click.Option(
        ["--jobs"],
        type=AT_LEAST_1,
        help="The number of parallel processes; the number of cores when left out.",
    ),
    click.Option(["--executor"], default="", metavar="tcp://HOST:PORT", help="Mark on this Dask cluster."),
)
# How a person marks.
IN_PART = (
    text("--section", "Only the students of this section, by the roster's column."),
    text("--group", "Only the students of this group, by the roster's column."),
)
MARKING = (
    click.Option(
        ["--all", "everything"], is_flag=True, help="Include answers that were marked automatically."
    ),
    flag("--anonymous", "Show no names and no ids."),
    flag("--terminal", "Mark in the terminal instead."),
    several("--set", "given", "Give a mark: ada/X12.11c=1.5"),
    several("--stands", "stands", "Answer a request for regrading, the mark stands: ada/X12.5a=REASON"),
    several("--accept", "accepted", "Give all points to a group of near misses, by its id in the report"),
    click.Option(
        ["--from", "file"], type=PATH, help="Give marks: a CSV file with student, part, points, comment."
    ),
)
# What of a ready-made scene is played.
PLAYED = (
    click.Argument(
        ["name"],
        required=False,
        help="cradle, ball_on_floor, …; a list of all when left out.",
        shell_complete=SCENES,
    ),
    several("--set", "settings", "A setting in SI: q=1.5, or masses=0.1,0.2,0.1"),
    click.Option(["--tolerance"], default=1e-12, help="Relative to the scene's natural scale."),
    click.Option(
        ["--settings", "explained"],
        is_flag=True,
        help="List the scene's settings instead, with units, defaults, and ranges.",
    ),
)
# A page on this machine.
PAGE = (
    flag("--no-browser", "Print the page's address, and do not open a browser."),
    click.Option(
        ["--port"], type=click.IntRange(0, 65535), default=0, help="The page's port; any when left out."
    ),
)
# How marks are written for elsewhere.
EXPORTED_MARKS = (
    click.Option(
        ["--columns"], type=click.Choice(["sets", "parts"]), help="Marks: a column for each of these."
    ),
    click.Option(
        ["--round", "decimals"],
        type=click.IntRange(0, 9),
        help="Marks: at most this many decimals; 2 when left out.",
    ),
    click.Option(
        ["--out-of"],
        type=click.FloatRange(min=0, min_open=True),
        help="Marks: scaled to this total.",
    ),
    text("--blank", "Marks: text for a missing mark; empty when left out."),
    path("--template", text="A file exported by the LMS: only the marks are filled in."),
    several("--column", "headings", "The template's column to fill in, where its title does not say which"),
)
# How sheets are printed, and marks written.
PRINTED_AND_MARKED = (
    LANGUAGE,
    click.Option(
        ["--forms"],
        type=click.IntRange(1, 700),
        help="pdf: this many forms (A, B, C, …) with distinct numbers, not tied to students.",
    ),
    flag("--formula-sheet", "pdf: end each sheet with the laws that the set uses."),
    flag("--large-print", "pdf: letters of 18 points."),
    *EXPORTED_MARKS,
)
# Whose deadline of one's own, for what, and until when.
EXTENDED = (
    click.Argument(["student"], required=False, help="The student's id.", shell_complete=STUDENTS),
    click.Argument(["name"], metavar="[SET]", required=False, help="The problem set.", shell_complete=SETS),
    click.Argument(
        ["date"], nargs=-1, metavar="[DATE]", help="2026-12-11 (the end of that day), or 2026-12-11 18:00."
    ),
)
# Whose data is taken out.
FORGOTTEN = click.Argument(
    ["student"], help="The student's id, email, or number in an LMS.", shell_complete=STUDENTS
)
# What a new problem is called, and what it begins as.
NEW = (
    click.Argument(["code"], help="The new problem's code: Q1"),
    click.Argument(["name"], help="The name of its files: sliding_box, or topic/sliding_box"),
    text("--like", "Copy this problem of the bank, or of the chapter.", CODES),
    flag("--translate", "Write a translation of the problem CODE instead, NAME being a language such as de."),
)
# Which problems are listed, and in which order.
LISTED = (
    several("--topic", "topic", "Only problems of this topic", TOPICS),
    several("--type", "kind", "Only problems with an answer of this type: value, choice, explain, …"),
    flag("--person", "Only problems with a part that a person must mark."),
    click.Option(
        ["--sort"],
        type=click.Choice(["code", "title", "topic", "parts", "variants"]),
        help="The column to sort by.",
    ),
)
# What of a whole course leaves it in one file.
WHOLE_COURSE = (
    text("--person", "All that the course holds of this student, as a zip file (-o FILE.zip).", STUDENTS),
    flag("--archive", "The course as a zip file (-o FILE.zip), without what can be made again."),
    click.Option(
        ["--keep-until"],
        type=click.DateTime(["%Y-%m-%d"]),
        help="--archive: the day until which it is to be stored; corollary doctor says when it has passed.",
    ),
)
# What of a set is exported, and as what.
EXPORTED = (
    click.Argument(
        ["sets"],
        nargs=-1,
        metavar="SET…",
        help="A problem set of the bank, or a path to its .md file; of marks several. As questions of an LMS a problem, too. "
        "For a site problems, sets and topics, all when none is named, and last its folder.",
        shell_complete=CODES_AND_SETS,
    ),
    TargetOption(
        ["--to"],
        metavar="TARGET",
        help="Sheets or marks, written as one of:",
        shell_complete=TARGETS,
    ),
)
# Whose answers are audited, by which laws, and where it is told.
AUDITED = (
    click.Argument(["files"], nargs=-1, required=True, metavar="FILE…", help="Records, or files of a bank."),
    path("--laws", text="The laws for exercises of a bank, by their id: a file of records without answers."),
    BANK,
    path("--report", text="Write a page for the bank's maintainer."),
    click.Option(
        ["--run", "running"], is_flag=True, help="Also run each server.py of PrairieLearn, isolated."
    ),
    click.Option(
        ["--seeds"],
        type=AT_LEAST_1,
        default=5,
        help="The number of seeds for each server.py; 5 when left out.",
    ),
    ISOLATION,
)
