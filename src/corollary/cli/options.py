"""The options and arguments that the commands take, each described once."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

from typer import Argument, Option

Bank = Annotated[
    list[Path] | None,
    Option(
        help="A folder with problems/ and solutions/, or an installed bank; may be repeated. When left out, "
        "COROLLARY_BANK, or the chapter's bank."
    ),
]
GeneratedBank = Annotated[
    list[Path] | None,
    Option(
        "--bank",
        help="A folder with problems/ and solutions/, or an installed bank; the bank the set was dealt from when left out.",
    ),
]
AsJson = Annotated[bool, Option("--json", help="One JSON document on standard output.")]
Code = Annotated[str, Argument(help="A code (X12.5), a name (kicking_a_ball), or a path to a .md file.")]
Codes = Annotated[
    list[str] | None, Argument(metavar="[CODE]...", help="Problems to verify; all when left out.")
]
Givens = Annotated[
    list[str] | None, Option("--set", help='A given: m=0.43 (SI) or v="72 km/h"; may be repeated.')
]
Settings = Annotated[
    list[str] | None,
    Option("--set", help="A setting in SI: q=1.5, or masses=0.1,0.2,0.1; may be repeated."),
]
GivenCases = Annotated[Path | None, Option(help="A JSON list of givens in SI; the answer is a list.")]
AnswerCases = Annotated[Path, Option(help='A JSON list of {"given": {…}, "answers": {…}}.')]
TextCases = Annotated[Path | None, Option(help='A JSON list of {"text": …, "field": …}.')]
Reveal = Annotated[bool, Option("--reveal", help="Feedback may give the right values.")]

Student = Annotated[
    str | None, Option(help="The numbers this student would get (with --course: those dealt there).")
]
StudentsCourse = Annotated[Path | None, Option(help="Take the student's numbers from this course.")]
VariantIndex = Annotated[int | None, Option(help="The variant with this index in the grid.")]
Solution = Annotated[bool, Option("--solution", help="Add the worked solution.")]
Format = Annotated[str, Option("--format", help="text, md, html or ipynb.")]
File = Annotated[Path | None, Option("--output", "-o", help="Write to this file.")]

Typed = Annotated[str | None, Argument(help="An answer as typed: 8,6 Ns")]
Unit = Annotated[str | None, Option(help="The unit asked for.")]
Equals = Annotated[str | None, Option(help="A formula to compare with.")]
Names = Annotated[str | None, Option(help="The letters of the formula: m,v,M")]
Domain = Annotated[list[str] | None, Option(help="Where a letter lives: v=-10..10; may be repeated.")]

Scene = Annotated[str, Argument(help="cradle, ball_on_floor, …")]
Scenes = Annotated[
    list[str] | None,
    Argument(metavar="[SCENE]...", help='cradle, spheres, "cradle N=3 q=1.5" …; all when left out.'),
]
Tolerance = Annotated[float, Option(help="Relative to the scene's natural scale.")]
TradeFolder = Annotated[
    Path | None,
    Option(
        "--output",
        "-o",
        help="Where table and pictures go; trade/ when left out (nowhere with --json).",
    ),
]
Quick = Annotated[bool, Option("--quick", help="Without the longest runs, each timed once.")]
Walked = Annotated[int, Option(min=1, help="How many variants to walk for each problem.")]
Extremes = Annotated[
    bool, Option("--extremes", help="Instead: closed forms and scenes at the ends of the range.")
]

SetName = Annotated[
    str, Argument(metavar="SET", help="A problem set of the bank, or a path to its .md file.")
]
Course = Annotated[Path, Option(help="The course folder.")]
Roster = Annotated[Path, Option(help="A CSV file with the column id.")]
Regrade = Annotated[bool, Option("--regrade", help="Mark again what is marked, and show first who changes.")]
DryRun = Annotated[bool, Option("--dry-run", help="Mark, show who changes, and write nothing.")]
Isolation = Annotated[int, Option(min=0, max=3, help="Refuse to run notebooks below this isolation level.")]
Jobs = Annotated[
    int | None,
    Option(min=1, help="How many to mark side by side; as many as there are cores when left out."),
]
Executor = Annotated[str, Option(metavar="tcp://HOST:PORT", help="Mark on this Dask cluster instead.")]
Page = Annotated[Path | None, Option("--output", "-o", help="Write the page here too.")]
DemoFolder = Annotated[Path, Argument(help="A fresh folder for the course.")]

To = Annotated[str, Option("--to", metavar="TARGET", help="md, html, ipynb or text: sheets; csv: marks.")]
SheetsCourse = Annotated[
    Path | None, Option("--course", help="The sheets, or the marks, of this course's students.")
]
SheetsRoster = Annotated[
    Path | None, Option("--roster", help="Without a course: a sheet for everybody in this CSV file.")
]
SheetVariants = Annotated[
    int | None, Option("--variants", min=1, help="Without either: so many sheets with distinct numbers.")
]
Folder = Annotated[Path, Option("--output", "-o", help="The folder for the files.")]
