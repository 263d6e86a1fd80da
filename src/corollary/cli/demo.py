"""`corollary demo`: the whole way, end to end, in a fresh folder."""

from __future__ import annotations

import shlex
import shutil
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

from corollary.cli.ending import FAILS, HOLDS, answer, refuse
from corollary.cli.terminal import bar, console
from corollary.course.demo.players import PLAYERS
from corollary.course.demo.stage import Demonstration, NotFresh, Played, perform
from corollary.extras import installing
from corollary.grading.solutions import Solutions
from corollary.problem.bank import chapter_bank
from corollary.problem.problem_set import find_set

SET = "momentum_1"


def run(folder: Path, as_json: bool) -> int:
    start = time.perf_counter()
    bank = chapter_bank()
    problem_set = find_set(bank, SET)
    with bar("demonstration", 4 * len(PLAYERS) + 1) as progress:
        try:
            performed = perform(folder, problem_set, Solutions(bank), _aloud(progress))
        except NotFresh as error:
            refuse(str(error))
    fair = all(each.fair for each in performed.played)
    seconds = time.perf_counter() - start
    if as_json:
        course = str(performed.course.folder)
        students = {each.player.student.id: _record(each) for each in performed.played}
        answer({"course": course, "fair": fair, "seconds": round(seconds, 1), "students": students})
    else:
        _show(performed, folder, seconds)
    return HOLDS if fair else FAILS


def _record(played: Played) -> dict[str, Any]:
    return {
        "plays": played.player.plays,
        "deserved": played.deserved,
        "points": played.got,
        "out_of": played.out_of,
        "fair": played.fair,
    }


def _aloud(progress: Callable[[str], None]) -> Callable[[str], None]:
    """Progress as a bar on a terminal, as lines elsewhere: the demonstration is watched."""
    if sys.stderr.isatty():
        return progress

    def say(step: str) -> None:
        print(f"  {step}", file=sys.stderr, flush=True)

    return say


def _show(performed: Demonstration, folder: Path, seconds: float) -> None:
    from rich.table import Table

    from corollary.render.report_page import terminal

    out = console()
    out.print(terminal(performed.outcome.report))
    table = Table(title="What each student did, deserves, and got", title_justify="left", title_style="bold")
    for heading in ("student", "hands in", "deserves", "got", "of", ""):
        numbers = heading in {"deserves", "got", "of"}
        table.add_column(heading, justify="right" if numbers else "left")
    for each in performed.played:
        table.add_row(
            each.player.student.id,
            each.player.plays,
            f"{each.deserved:g}",
            f"{each.got:g}",
            f"{each.out_of:g}",
            "fair" if each.fair else "NOT FAIR",
        )
    out.print(table)
    for each in performed.played:
        for difference in each.differences:
            out.print(f"{each.player.student.id}: {difference}", markup=False)
    student = "finn"
    name = performed.outcome.page.stem
    there = performed.outcome.in_gradebook
    for what, where in (
        ("notebook a student gets", folder / "release" / student / name / f"{name}.ipynb"),
        ("feedback a student gets", folder / "feedback" / student / name / f"{name}.html"),
        ("report for the instructor", folder / "reports" / f"{name}.html"),
        *([("nbgrader gradebook", folder / "gradebook.db")] if there else []),
    ):
        out.print(f"{what:26} {where}", soft_wrap=True, highlight=False)
    out.print(f"isolation: {', '.join(performed.outcome.report.isolation)}", highlight=False, soft_wrap=True)
    out.print(
        f"done in {seconds:.0f} s; "
        + (
            f"for formgrader: {_activation()}cd {folder} && jupyter lab, then Nbgrader > Formgrader in its menu"
            if there
            else f"nbgrader is not installed, so there is no gradebook: {installing('nbgrader')}"
        ),
        highlight=False,
        soft_wrap=True,
    )


def _activation() -> str:
    """What a terminal needs first, where the programs beside this Python are not on its PATH: `source .venv/bin/activate && `."""
    activate, jupyter = Path(sys.prefix) / "bin" / "activate", shutil.which("jupyter")
    if not activate.exists() or (jupyter and Path(jupyter).parent == Path(sys.executable).parent):
        return ""
    here = Path.cwd()
    shortest = activate.relative_to(here) if activate.is_relative_to(here) else activate
    return f"source {shlex.quote(str(shortest))} && "
