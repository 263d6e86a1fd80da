"""A print run: the sheets of a set, each with its marking scheme, and all sheets in one file for the printer."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from corollary.grading.solutions import Solutions
from corollary.messages import catalogue
from corollary.problem.problem_set import ProblemSet
from corollary.render.paper.document import pdf, typesetter
from corollary.render.paper.formula_sheet import typst_formulas
from corollary.render.paper.key_sheet import typst_key
from corollary.render.paper.sheet import PaperSheet, typst_sheet

_ = catalogue(__name__)


@dataclass(frozen=True, slots=True)
class PrintRun:
    """What is printed, and how: in large print, with a formula sheet, with worked solutions in the marking schemes."""

    problem_set: ProblemSet
    sheets: Sequence[PaperSheet]
    solutions: Solutions
    large: bool = False
    formulas: bool = False
    worked: bool = False

    def prepare(self) -> None:
        """Everything that all sheets share is found before there are processes that would each do it. Raises CannotTypeset
        without the extra `pdf`, and NotDerivable."""
        for module in ("typst", "segno"):
            typesetter(module)
        for problem in self.problem_set.problems:
            self.solutions.of(problem)
        self.formula_sheet()

    def formula_sheet(self) -> str:
        """The same for everybody: the laws of the whole set. In Typst's markup."""
        if not self.formulas:
            return ""
        return typst_formulas([self.solutions.of(problem) for problem in self.problem_set.problems])

    def printed(self, sheet: PaperSheet) -> dict[str, bytes]:
        """The files of one sheet by name: the sheet and, in another folder, its marking scheme. Raises CannotTypeset."""
        exercises = sheet.worksheet.exercises
        keys = {each.problem.code: self.solutions.key(each.variant) for each in exercises}
        worked = (
            {code: self.solutions.worked_solution_of(key) for code, key in keys.items()}
            if self.worked
            else {}
        )
        key = typst_key(sheet, keys, worked)
        name, of_key = self.name(sheet), _("Marking scheme: {title}", title=sheet.title)
        return {
            f"{name}.pdf": pdf([self.pages(sheet)], sheet.title, large=self.large),
            f"keys/{name}-key.pdf": pdf([key], of_key, large=self.large),
        }

    def pages(self, sheet: PaperSheet) -> str:
        """One sheet in Typst's markup. Raises CannotTypeset."""
        return typst_sheet(sheet, self.formula_sheet())

    def name(self, sheet: PaperSheet) -> str:
        """What the files of a sheet are called; ids are names of folders, on every disk."""
        return f"{self.problem_set.name}-{sheet.mark}" if sheet.mark else self.problem_set.name

    def together(self) -> dict[str, bytes]:
        """All sheets in one file, each beginning on the front of a leaf; none where there is one only. Raises CannotTypeset."""
        if len(self.sheets) < 2:
            return {}
        pages = [self.pages(sheet).replace("#sheet(", "#sheet(front: true, ", 1) for sheet in self.sheets]
        return {f"{self.problem_set.name}.pdf": pdf(pages, self.problem_set.title, large=self.large)}
