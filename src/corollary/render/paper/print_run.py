"""A print run: the sheets of a set, each with its marking scheme, and all sheets in one file for the printer."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

from corollary.grading.solutions import Solutions
from corollary.messages import catalogue, spoken
from corollary.problem.problem_set import ProblemSet
from corollary.render.paper.document import pdf, typesetter
from corollary.render.paper.formula_sheet import typst_formulas
from corollary.render.paper.key_sheet import typst_key
from corollary.render.paper.sheet import PaperSheet, typst_sheet

_ = catalogue(__name__)


@dataclass(frozen=True, slots=True)
class Pages:
    """One sheet and its marking scheme in Typst's markup, not yet set."""

    sheet: str
    key: str


@dataclass(frozen=True, slots=True)
class PrintRun:
    """What is printed, and how: in large print, with a formula sheet, with worked solutions in the marking schemes."""

    problem_set: ProblemSet
    sheets: Sequence[PaperSheet]
    solutions: Solutions
    large: bool = False
    formulas: bool = False
    worked: bool = False
    _formula_sheets: dict[str, str] = field(default_factory=dict[str, str], init=False, repr=False)
    """By the language spoken."""

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
        if spoken() not in self._formula_sheets:
            used = [self.solutions.of(problem) for problem in self.problem_set.problems]
            self._formula_sheets[spoken()] = typst_formulas(used)
        return self._formula_sheets[spoken()]

    def pages(self, sheet: PaperSheet) -> Pages:
        """One sheet and its marking scheme. Raises CannotTypeset without the extra `pdf`."""
        exercises = sheet.worksheet.exercises
        keys = {each.problem.code: self.solutions.key(each.variant) for each in exercises}
        worked = (
            {code: self.solutions.worked_solution_of(key) for code, key in keys.items()}
            if self.worked
            else {}
        )
        return Pages(typst_sheet(sheet, self.formula_sheet()), typst_key(sheet, keys, worked))

    def printed(self, sheet: PaperSheet, pages: Pages) -> dict[str, bytes]:
        """The files of one sheet by name: the sheet and, in another folder, its marking scheme. Raises CannotTypeset."""
        name, of_key = self.name(sheet), _("Marking scheme: {title}", title=sheet.title)
        return {
            f"{name}.pdf": pdf([pages.sheet], sheet.title, large=self.large),
            f"keys/{name}-key.pdf": pdf([pages.key], of_key, large=self.large),
        }

    def name(self, sheet: PaperSheet) -> str:
        """What the files of a sheet are called; ids are names of folders, on every disk."""
        return f"{self.problem_set.name}-{sheet.mark}" if sheet.mark else self.problem_set.name

    def together(self, pages: Sequence[Pages]) -> dict[str, bytes]:
        """All sheets in one file, each beginning on the front of a leaf; none where there is one only. Raises CannotTypeset."""
        if len(pages) < 2:
            return {}
        fronts = [each.sheet.replace("#sheet(", "#sheet(front: true, ", 1) for each in pages]
        return {f"{self.problem_set.name}.pdf": pdf(fronts, self.problem_set.title, large=self.large)}
