"""Figures that stand in another cell than their own, in whole notebooks: they count when they are what is asked for."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path

import nbformat
import pytest

from corollary.answers.verdict import Right, Unmarked, Unread, Verdict, Wrong
from corollary.grading.marking import mark
from corollary.grading.solutions import Solutions
from corollary.notebook.notebook import filled_in
from corollary.notebook.worksheet import worksheet
from corollary.problem.bank import chapter_bank, find
from corollary.problem.late_penalty import IN_TIME
from corollary.problem.problem_set import read_set
from corollary.problem.roster import Student
from corollary.problem.variant import chapter
from corollary.sandbox.notebook_file import Notebook, notebook_of
from corollary.sandbox.runner import Runner

DRAW = """
import matplotlib.pyplot as plt
import numpy as np
k, b, d = {k}, {b}, {d}
U0 = k * d**2 / 2
x = np.linspace(b - d, b + 2 * d, 200)
plt.plot(x, np.where(x < b + d, k * (x - b) ** 2 / 2, U0))
plt.hlines([{eps} * U0, {epsx} * U0], b - d, b + 2 * d)
plt.xlabel("x [m]")
plt.ylabel("U [J]")
plt.show()
"""
OTHER = "import matplotlib.pyplot as plt\nplt.plot([1, 2], [3, 4])\nplt.show()"


@pytest.fixture(scope="module")
def marked(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Callable[..., Verdict]]:
    """The verdict on the potential of P12.15 a; sources by the name of their cell, and one for a cell of the student's own."""
    bank = chapter_bank()
    path: Path = tmp_path_factory.mktemp("set") / "atoms.md"
    path.write_text("---\ntitle: Atoms\nproblems:\n  - P12.15\n---\n")
    solutions, variant = Solutions(bank), chapter(find(bank, "P12.15"))
    sheet = worksheet(read_set(bank, path), Student("ada"), [variant])
    keys = {"P12.15": solutions.key(variant)}
    drawing = DRAW
    for name, value in variant.si.items():
        drawing = drawing.replace(f"{{{name}}}", repr(value))
    with Runner() as runner:

        def verdict(own: str = "", new: str = "") -> Verdict:
            sources = {"P12_15_a_plot": own.replace("DRAW", drawing)} if own else {}
            node = nbformat.reads(filled_in(sheet, sources), as_version=4)
            if new:
                node.cells.insert(2, nbformat.v4.new_code_cell(new.replace("DRAW", drawing)))
            book = notebook_of(nbformat.writes(node).encode())
            assert isinstance(book, Notebook)
            (grade,) = mark(sheet, keys, book, runner, b"secret", IN_TIME).grades
            return next(part.verdict for part in grade.parts if part.part.id == "a")

        yield verdict


@pytest.mark.whole
def test_a_figure_counts_wherever_it_was_drawn_when_it_is_the_one_asked_for(marked):
    assert isinstance(marked(own="DRAW"), Right)
    assert isinstance(marked(new="DRAW"), Right)
    assert isinstance(marked(own="DRAW", new=OTHER), Right)


@pytest.mark.whole
def test_else_a_person_looks(marked):
    assert isinstance(marked(new=OTHER), Unmarked)
    assert isinstance(marked(own=OTHER, new="DRAW"), Unmarked)


@pytest.mark.whole
def test_a_wrong_figure_is_wrong_and_none_is_none(marked):
    assert isinstance(marked(own=OTHER), Wrong)
    assert isinstance(marked(own=OTHER, new=OTHER), Wrong)
    assert isinstance(marked(), Unread)
