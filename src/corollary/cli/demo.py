"""`corollary demo`: the whole way, end to end, in a fresh folder."""

from __future__ import annotations

import sys
import time
from pathlib import Path

from corollary.cli.failure import FAILS, HOLDS, answer, refuse
from corollary.cli.progress import bar
from corollary.course.demo.players import PLAYERS
from corollary.course.demo.stage import Demonstration, NotFresh, perform
from corollary.grading.solutions import Solutions
from corollary.problem.bank import chapter_bank
from corollary.problem.problem_set import find_set

SET = "momentum_1"


def run(folder: Path, json: bool) -> int:
    start = time.perf_counter()
    bank = chapter_bank()
    problem_set = find_set(bank, SET)
    with bar("demonstration", len(problem_set.problems) + 3 * len(PLAYERS) + 1) as tell:
        try:
            shown = perform(folder, problem_set, Solutions(bank), _aloud(tell))
        except NotFresh as error:
            refuse(str(error))
    fair = all(each.fair for each in shown.played)
    seconds = time.perf_counter() - start
    if json:
        answer({
            "course": str(shown.course.folder), "fair": fair, "seconds": round(seconds, 1),
            "students": {
                each.player.student.id: {"plays": each.player.plays, "deserved": each.deserved, "points": each.got, "out_of": each.out_of, "fair": each.fair}
                for each in shown.played
            },
        })  # fmt: skip
    else:
        _show(shown, folder, seconds)
    return HOLDS if fair else FAILS


def _aloud(tell):
    """Progress as a bar on a terminal, as lines elsewhere: the demonstration is watched."""
    if sys.stderr.isatty():
        return tell

    def say(step: str) -> None:
        print(f"  {step}", file=sys.stderr, flush=True)

    return say


def _show(shown: Demonstration, folder: Path, seconds: float) -> None:
    from rich.console import Console
    from rich.table import Table

    from corollary.render.report_table import terminal

    console = Console()
    console.print(terminal(shown.outcome.report))
    table = Table(title="What each student did, deserves, and got")
    for heading, justify in (
        ("student", "left"),
        ("hands in", "left"),
        ("deserves", "right"),
        ("got", "right"),
        ("of", "right"),
        ("", "left"),
    ):
        table.add_column(heading, justify=justify)  # type: ignore[arg-type]
    for each in shown.played:
        table.add_row(
            each.player.student.id,
            each.player.plays,
            f"{each.deserved:g}",
            f"{each.got:g}",
            f"{each.out_of:g}",
            "fair" if each.fair else "NOT FAIR",
        )
    console.print(table)
    for each in shown.played:
        for difference in each.differences:
            console.print(f"{each.player.student.id}: {difference}", markup=False)
    student = "finn"
    name = shown.outcome.page.stem
    for what, where in (
        ("notebook a student gets", folder / "release" / student / name / f"{name}.ipynb"),
        ("feedback a student gets", folder / "feedback" / student / name / f"{name}.feedback.html"),
        ("report for the instructor", folder / "reports" / f"{name}.html"),
        ("nbgrader gradebook", folder / "gradebook.db"),
    ):
        console.print(f"{what:26} {where}", soft_wrap=True, highlight=False)
    console.print(f"isolation: {', '.join(shown.outcome.report.isolation)}", highlight=False, soft_wrap=True)
    console.print(
        f"done in {seconds:.0f} s; try: cd {folder} && nbgrader formgrader", highlight=False, soft_wrap=True
    )
