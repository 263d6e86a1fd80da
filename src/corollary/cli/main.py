"""The command `corollary`: every command by name, its options, and its exit status."""

from __future__ import annotations

import importlib
import os
import sys
from pathlib import Path
from typing import Annotated

import typer
import typer.exceptions

from corollary import __version__
from corollary.cli.failure import FAILS, REFUSED, expected, say

app = typer.Typer(
    name="corollary", no_args_is_help=True, add_completion=False, pretty_exceptions_enable=False, rich_markup_mode=None,
    help="Physics exercises whose answers are derived from the laws: numbers for each student, marks for what they hand in.",
    context_settings={"help_option_names": ["-h", "--help"]},
)  # fmt: skip

Bank = Annotated[
    Path | None,
    typer.Option(help="A folder with problems/ and solutions/; the chapter's bank when left out."),
]
DealtBank = Annotated[
    Path | None,
    typer.Option(
        "--bank",
        help="A folder with problems/ and solutions/; the bank the set was dealt from when left out.",
    ),
]
Json = Annotated[bool, typer.Option("--json", help="One JSON document on standard output.")]
Code = Annotated[
    str, typer.Argument(help="A code (X12.5), a name (kicking_a_ball), or a path to a .md file.")
]
Sets = Annotated[
    list[str] | None, typer.Option("--set", help='A given: m=0.43 (SI) or v="72 km/h"; may be repeated.')
]
Settings = Annotated[
    list[str] | None,
    typer.Option("--set", help="A setting in SI: q=1.5, or masses=0.1,0.2,0.1; may be repeated."),
]
Course = Annotated[Path, typer.Option(help="The course folder.")]
SetName = Annotated[
    str, typer.Argument(metavar="SET", help="A problem set of the bank, or a path to its .md file.")
]


@app.command("list")
def list_(bank: Bank = None, json: Json = False) -> None:
    """Every problem: code, title, givens, parts, number of distinct variants."""
    _run("listing", bank=bank, json=json)


@app.command()
def show(
    code: Code, bank: Bank = None,
    student: Annotated[str | None, typer.Option(help="The numbers this student would get (with --course: those dealt there).")] = None,
    course: Annotated[Path | None, typer.Option(help="Take the student's numbers from this course.")] = None,
    variant: Annotated[int | None, typer.Option(help="The variant with this index in the grid.")] = None,
    solution: Annotated[bool, typer.Option("--solution", help="Add the worked solution.")] = False,
    format: Annotated[str, typer.Option(help="text, md, html or ipynb.")] = "text",
    output: Annotated[Path | None, typer.Option("--output", "-o", help="Write to this file.")] = None,
) -> None:  # fmt: skip
    """One problem as a student sees it."""
    _run(
        "show",
        code=code,
        bank=bank,
        student=student,
        course=course,
        variant=variant,
        solution=solution,
        format=format,
        output=output,
    )


@app.command()
def key(
    code: Code, bank: Bank = None, set: Sets = None,
    cases: Annotated[Path | None, typer.Option(help="A JSON list of givens in SI; the answer is a list.")] = None, json: Json = False,
) -> None:  # fmt: skip
    """The answer key for given numbers, every digit certified."""
    _run("key", code=code, bank=bank, sets=set or [], cases=cases, json=json)


@app.command()
def judge(
    code: Code, cases: Annotated[Path, typer.Option(help="A JSON list of {\"given\": {…}, \"answers\": {…}}.")],
    bank: Bank = None, reveal: Annotated[bool, typer.Option("--reveal", help="Feedback may give the right values.")] = False, json: Json = False,
) -> None:  # fmt: skip
    """Marks plain answers, no notebook needed."""
    _run("judge", code=code, bank=bank, cases=cases, reveal=reveal, json=json)


@app.command()
def read(
    text: Annotated[str | None, typer.Argument(help="An answer as typed: 8,6 Ns")] = None,
    unit: Annotated[str | None, typer.Option(help="The unit asked for.")] = None,
    equals: Annotated[str | None, typer.Option(help="A formula to compare with.")] = None,
    names: Annotated[str | None, typer.Option(help="The letters of the formula: m,v,M")] = None,
    domain: Annotated[list[str] | None, typer.Option(help="Where a letter lives: v=-10..10; may be repeated.")] = None,
    cases: Annotated[Path | None, typer.Option(help="A JSON list of {\"text\": …, \"field\": …}.")] = None, json: Json = False,
) -> None:  # fmt: skip
    """How an answer is read, and what would be decided."""
    _run(
        "read", text=text, unit=unit, equals=equals, names=names, domain=domain or [], cases=cases, json=json
    )


@app.command()
def scene(
    name: Annotated[str, typer.Argument(help="cradle, ball_on_floor, …")],
    set: Settings = None, tolerance: Annotated[float, typer.Option(help="Relative to the scene's natural scale.")] = 1e-12, json: Json = False,
) -> None:  # fmt: skip
    """Runs a ready-made scene with the least model that answers, and says which and why."""
    _run("scene", name=name, sets=set or [], tolerance=tolerance, json=json)


@app.command()
def verify(
    codes: Annotated[list[str] | None, typer.Argument(metavar="[CODE]...", help="Problems to verify; all when left out.")] = None,
    bank: Bank = None, variants: Annotated[int, typer.Option(min=1, help="How many variants to walk for each problem.")] = 100, json: Json = False,
    extremes: Annotated[bool, typer.Option("--extremes", help="Instead: closed forms and scenes at the ends of the range.")] = False,
) -> None:  # fmt: skip
    """Proves problems and solutions right, or says what is wrong."""
    _run("verify", codes=codes or [], bank=bank, variants=variants, json=json, extremes=extremes)


@app.command()
def trade(
    scenes: Annotated[list[str] | None, typer.Argument(metavar="[SCENE]...", help="cradle, spheres, \"cradle N=3 q=1.5\" …; all when left out.")] = None,
    output: Annotated[Path | None, typer.Option("--output", "-o", help="Where table and pictures go; trade/ when left out (nowhere with --json).")] = None,
    json: Json = False, quick: Annotated[bool, typer.Option("--quick", help="Without the longest runs, each timed once.")] = False,
) -> None:  # fmt: skip
    """Measures speed against accuracy; writes the table and the picture."""
    _run("trade", scenes=scenes or [], output=output, json=json, quick=quick)


@app.command()
def generate(
    set: SetName, roster: Annotated[Path, typer.Option(help="A CSV file with the column id.")], course: Course,
    bank: Bank = None, json: Json = False,
) -> None:  # fmt: skip
    """A problem set, different for each student, as an nbgrader course."""
    _run("generate", name=set, roster=roster, course=course, bank=bank, json=json)


@app.command()
def grade(
    set: SetName, course: Course, bank: DealtBank = None, json: Json = False,
    regrade: Annotated[bool, typer.Option("--regrade", help="Mark again what is marked, and show first who changes.")] = False,
    dry_run: Annotated[bool, typer.Option("--dry-run", help="Mark, show who changes, and write nothing.")] = False,
    require_isolation: Annotated[int, typer.Option(min=0, max=3, help="Refuse to run notebooks below this isolation level.")] = 1,
    jobs: Annotated[int | None, typer.Option(min=1, help="How many to mark side by side; as many as there are cores when left out.")] = None,
    executor: Annotated[str, typer.Option(metavar="tcp://HOST:PORT", help="Mark on this Dask cluster instead.")] = "",
) -> None:  # fmt: skip
    """Marks what was handed in: gradebook, feedback, report."""
    _run(
        "grade",
        name=set,
        course=course,
        bank=bank,
        json=json,
        regrade=regrade,
        dry_run=dry_run,
        require=require_isolation,
        jobs=jobs,
        executor=executor,
    )


@app.command()
def report(
    set: SetName, course: Course, bank: DealtBank = None, json: Json = False,
    output: Annotated[Path | None, typer.Option("--output", "-o", help="Write the page here too.")] = None,
) -> None:  # fmt: skip
    """What an instructor reads: marks, each part, misconceptions met, what waits for a person."""
    _run("report", name=set, course=course, bank=bank, json=json, output=output)


@app.command()
def demo(
    folder: Annotated[Path, typer.Argument(help="A fresh folder for the course.")] = Path("demo"),
    json: Json = False,
) -> None:
    """The whole way, end to end, in a fresh folder."""
    _run("demo", folder=folder, json=json)


@app.callback(invoke_without_command=True)
def version(
    version: Annotated[
        bool, typer.Option("--version", help="Show the version and leave.", is_eager=True)
    ] = False,
) -> None:
    if version:
        print(__version__)
        raise typer.Exit


def _run(module: str, **options: object) -> None:
    """The command of that module, imported only now; statuses 0, 1 and 2, one sentence on a failing, no traceback."""
    try:
        status = importlib.import_module(f"corollary.cli.{module}").run(**options)
        sys.stdout.flush()
    except KeyboardInterrupt:
        say("stopped")
        status = FAILS
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        status = FAILS
    except Exception as error:
        if not isinstance(error, expected()):
            status = _unforeseen(error)
        else:
            say(f"corollary: {error}")
            status = REFUSED
    if status:
        raise typer.Exit(status)


def main() -> None:
    """The entry point; a request that cannot be understood is answered in one sentence."""
    try:
        status = app(standalone_mode=False)
    except typer.exceptions.TyperException as error:
        status, said = REFUSED, error.format_message()
        if said.startswith("Usage:"):  # nothing was asked for
            say(said)
        else:
            say(f"corollary: {said[0].lower()}{said[1:].rstrip('.')}; `{_asked()} --help` says how")
    sys.exit(status or 0)


def _asked() -> str:
    """The command that was meant, as far as it is one."""
    known = {command.name or getattr(command.callback, "__name__", "") for command in app.registered_commands}
    return " ".join(["corollary", *(name for name in sys.argv[1:2] if name in known)])


def _unforeseen(error: Exception) -> int:
    """A fault of ours, or of the machine: said in a sentence, with the whole story only when asked for."""
    if os.environ.get("COROLLARY_DEBUG"):
        raise error
    if isinstance(error, OSError):
        say(f"corollary: {error.strerror or error}{f': {error.filename}' if error.filename else ''}")
        return REFUSED
    say(
        f"corollary: this should not have happened: {type(error).__name__}: {error} (COROLLARY_DEBUG=1 shows where; please report it)"
    )
    return FAILS
