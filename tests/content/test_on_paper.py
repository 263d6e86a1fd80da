"""Every exercise can be set on paper: the chapter's with their marking schemes, those of the example banks as sheets."""

from __future__ import annotations

from pathlib import Path

import pytest

from corollary.grading.solutions import Solutions
from corollary.notebook.worksheet import SheetPlan
from corollary.problem.bank import Bank, chapter_bank, open_bank
from corollary.problem.problem import Problem
from corollary.problem.problem_set import ProblemSet, Scheme
from corollary.problem.roster import Student
from corollary.problem.variant import chapter
from corollary.render.paper.print_run import PrintRun
from corollary.render.paper.sheet import PaperSheet, typst_sheet
from corollary.render.paper.typst import pdf

EXAMPLES = sorted((Path(__file__).parents[2] / "examples" / "banks").glob("*/src/*/problems"))


def run_of(problem: Problem, bank: Bank) -> PrintRun:
    alone = ProblemSet(problem.name, problem.title, "", (problem,), (1.0,), None, Scheme(), "no")
    sheet = PaperSheet(SheetPlan(alone, Student("ada"), (chapter(problem),)))
    return PrintRun(alone, [sheet], Solutions(bank), formulas=True, worked=True)


@pytest.mark.whole
def test_every_exercise_of_the_chapter_with_its_marking_scheme_and_worked_solution():
    bank = chapter_bank()
    for problem in bank:
        run = run_of(problem, bank)
        files = run.printed(run.sheets[0], run.pages(run.sheets[0]))
        assert all(each.startswith(b"%PDF-") for each in files.values()), problem.code
        assert len(files) == 2


@pytest.mark.whole
@pytest.mark.parametrize("place", EXAMPLES, ids=lambda place: place.parent.name)
def test_every_sheet_of_the_example_banks(place: Path):
    bank = open_bank(place.parent)
    sheets = [
        typst_sheet(run_of(problem, bank).sheets[0]).replace('"sheet-', f'"{problem.code}-', 1)
        for problem in bank
    ]
    assert len(sheets) >= 10
    assert pdf(sheets, place.parent.name, large=True).startswith(b"%PDF-")
