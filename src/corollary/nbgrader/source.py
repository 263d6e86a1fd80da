"""The notebook that nbgrader knows a set by: with the chapter's own numbers."""

from __future__ import annotations

from typing import TYPE_CHECKING

from corollary.notebook.notebook import notebook
from corollary.notebook.worksheet import worksheet
from corollary.problem.problem_set import ProblemSet
from corollary.problem.roster import Student
from corollary.problem.variant import chapter

if TYPE_CHECKING:
    from nbformat import NotebookNode

NOBODY = Student("everybody", "Chapter's own", "numbers")


def source_notebook(problem_set: ProblemSet) -> NotebookNode:
    """The sheet that is nobody's, with a cell for every part."""
    return notebook(worksheet(problem_set, NOBODY, map(chapter, problem_set.problems)))
