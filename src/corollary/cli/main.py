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
from corollary.cli import options as option
from corollary.cli.failure import FAILS, REFUSED, expected, say

app = typer.Typer(
    name="corollary",
    no_args_is_help=True,
    add_completion=False,
    pretty_exceptions_enable=False,
    rich_markup_mode=None,
    help="Physics exercises whose answers are derived from the laws: numbers for each student, marks for what they hand in.",
    context_settings={"help_option_names": ["-h", "--help"]},
)


@app.command("list")
def list_(bank: option.Bank = None, as_json: option.AsJson = False) -> None:
    """Every problem: code, title, givens, parts, number of distinct variants."""
    _run("listing", bank=bank, as_json=as_json)


@app.command()
def show(
    code: option.Code,
    bank: option.Bank = None,
    student: option.Student = None,
    course: option.StudentsCourse = None,
    variant: option.VariantIndex = None,
    solution: option.Solution = False,
    fmt: option.Format = "text",
    output: option.File = None,
) -> None:
    """One problem as a student sees it."""
    choice = {"student": student, "course": course, "variant": variant}
    _run("show", code=code, bank=bank, **choice, solution=solution, fmt=fmt, output=output)


@app.command()
def key(
    code: option.Code,
    bank: option.Bank = None,
    givens: option.Givens = None,
    cases: option.GivenCases = None,
    as_json: option.AsJson = False,
) -> None:
    """The answer key for given numbers, every digit certified."""
    _run("key", code=code, bank=bank, givens=givens or [], cases=cases, as_json=as_json)


@app.command()
def judge(
    code: option.Code,
    cases: option.AnswerCases,
    bank: option.Bank = None,
    reveal: option.Reveal = False,
    as_json: option.AsJson = False,
) -> None:
    """Marks plain answers, no notebook needed."""
    _run("judge", code=code, bank=bank, cases=cases, reveal=reveal, as_json=as_json)


@app.command()
def read(
    text: option.Typed = None,
    unit: option.Unit = None,
    equals: option.Equals = None,
    names: option.Names = None,
    domain: option.Domain = None,
    cases: option.TextCases = None,
    as_json: option.AsJson = False,
) -> None:
    """How an answer is read, and what would be decided."""
    about = {"text": text, "unit": unit, "equals": equals, "names": names, "domain": domain or []}
    _run("read", **about, cases=cases, as_json=as_json)


@app.command()
def scene(
    name: option.Scene,
    settings: option.Settings = None,
    tolerance: option.Tolerance = 1e-12,
    as_json: option.AsJson = False,
) -> None:
    """Runs a ready-made scene with the least model that answers, and says which and why."""
    _run("scene", name=name, sets=settings or [], tolerance=tolerance, as_json=as_json)


@app.command()
def verify(
    codes: option.Codes = None,
    bank: option.Bank = None,
    variants: option.Walked = 100,
    as_json: option.AsJson = False,
    extremes: option.Extremes = False,
) -> None:
    """Proves problems and solutions right, or says what is wrong."""
    _run("verify", codes=codes or [], bank=bank, variants=variants, as_json=as_json, extremes=extremes)


@app.command()
def trade(
    scenes: option.Scenes = None,
    output: option.TradeFolder = None,
    as_json: option.AsJson = False,
    quick: option.Quick = False,
) -> None:
    """Measures speed against accuracy; writes the table and the picture."""
    _run("trade", scenes=scenes or [], output=output, as_json=as_json, quick=quick)


@app.command()
def generate(
    set_name: option.SetName,
    roster: option.Roster,
    course: option.Course,
    bank: option.Bank = None,
    as_json: option.AsJson = False,
) -> None:
    """A problem set, different for each student, as an nbgrader course."""
    _run("generate", name=set_name, roster=roster, course=course, bank=bank, as_json=as_json)


@app.command()
def grade(
    set_name: option.SetName,
    course: option.Course,
    bank: option.GeneratedBank = None,
    as_json: option.AsJson = False,
    regrade: option.Regrade = False,
    dry_run: option.DryRun = False,
    require_isolation: option.Isolation = 1,
    jobs: option.Jobs = None,
    executor: option.Executor = "",
) -> None:
    """Marks what was handed in: gradebook, feedback, report."""
    how = {"regrade": regrade, "dry_run": dry_run, "require": require_isolation}
    where = {"jobs": jobs, "executor": executor}
    _run("grade", name=set_name, course=course, bank=bank, as_json=as_json, **how, **where)


@app.command()
def report(
    set_name: option.SetName,
    course: option.Course,
    bank: option.GeneratedBank = None,
    as_json: option.AsJson = False,
    output: option.Page = None,
) -> None:
    """What an instructor reads: marks, each part, misconceptions met, what waits for a person."""
    _run("report", name=set_name, course=course, bank=bank, as_json=as_json, output=output)


@app.command()
def export(
    set_name: option.SetName,
    to: option.To,
    course: option.SheetsCourse = None,
    roster: option.SheetsRoster = None,
    bank: option.GeneratedBank = None,
    variants: option.SheetVariants = None,
    solution: option.Solution = False,
    output: option.Folder = Path("export"),
    as_json: option.AsJson = False,
) -> None:
    """A set as files for elsewhere: each student's sheet, or the marks of all."""
    whose = {"course": course, "roster": roster, "variants": variants}
    _run(
        "export", name=set_name, to=to, bank=bank, **whose, solution=solution, output=output, as_json=as_json
    )


@app.command()
def demo(folder: option.DemoFolder = Path("demo"), as_json: option.AsJson = False) -> None:
    """The whole way, end to end, in a fresh folder."""
    _run("demo", folder=folder, as_json=as_json)


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
    match options.get("bank"):
        case [*places]:  # several banks are one, parted as in PATH
            options["bank"] = Path(os.pathsep.join(map(str, places))) if places else None
        case _:
            pass
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
        status, message = REFUSED, error.format_message()
        if message.startswith("Usage:"):  # no command was named
            say(message)
        else:
            say(f"corollary: {message[0].lower()}{message[1:].rstrip('.')}; `{_named()} --help` says how")
    sys.exit(status or 0)


def _named() -> str:
    """The command that was meant, as far as it is one."""
    known = {command.name or getattr(command.callback, "__name__", "") for command in app.registered_commands}
    return " ".join(["corollary", *(name for name in sys.argv[1:2] if name in known)])


def _unforeseen(error: Exception) -> int:
    """A fault of ours, or of the machine: one sentence, and the traceback only when asked for."""
    if os.environ.get("COROLLARY_DEBUG"):
        raise error
    if isinstance(error, OSError):
        say(f"corollary: {error.strerror or error}{f': {error.filename}' if error.filename else ''}")
        return REFUSED
    say(
        f"corollary: this should not have happened: {type(error).__name__}: {error} (COROLLARY_DEBUG=1 shows where; please report it)"
    )
    return FAILS
