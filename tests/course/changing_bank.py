"""A bank with one problem that is easily rewritten, and a class that has its sheets."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from functools import partial
from pathlib import Path

from corollary.course.demo.players import right_sources
from corollary.course.generate import Generated, generate
from corollary.course.grade import Outcome, grade_set
from corollary.grading.solutions import Solutions
from corollary.notebook.notebook import filled_in
from corollary.notebook.worksheet import worksheet
from corollary.problem.bank import Bank
from corollary.problem.problem_set import ProblemSet, find_set
from corollary.problem.roster import Student
from corollary.records.files import Course
from corollary.records.regrading import Change
from corollary.sandbox.runner import Runner

# By id: title, unit, and the law that gives the answer.
PARTS = {
    "a": ("Momentum", "kg*m/s", "m*v"),
    "b": ("Energy", "J", "m*v^2/2"),
    "c": ("Force", "N", "m*v/dt"),
    "d": ("Distance", "m", "v*dt"),
}
LETTERS = "m v dt"


@dataclass(frozen=True, slots=True)
class Text:
    """What is in the problem's file. A given: the printed value, from, to, step, unit; `ids` are those of parts called otherwise."""

    givens: dict[str, str] = field(
        default_factory=lambda: {
            "m": "value: 0.43, from: 0.3, to: 0.6, step: 0.01, unit: kg",
            "v": "value: 20, from: 8, to: 35, step: 0.5, unit: m/s",
            "dt": "value: 0.1, from: 0.02, to: 0.15, step: 0.01, unit: s",
        }
    )
    parts: tuple[str, ...] = ("a", "b", "c")
    conditions: tuple[str, ...] = ("m > 0",)
    words: str = "A ball of {{m}} moves at {{v}} for {{dt}}."
    points: float = 1
    code: str = "X1.1"
    ids: dict[str, str] = field(default_factory=dict[str, str])

    @property
    def problem(self) -> str:
        rows = "".join(f"  {symbol}: {{is: the {symbol}, {row}}}\n" for symbol, row in self.givens.items())
        conditions = "".join(f"  - {each}\n" for each in self.conditions)
        parts = "".join(
            f'\n## {PARTS[part][0]} {{#{self.ids.get(part, part)} .value unit="{PARTS[part][1]}" points={self.points}}}\nHow much?\n'
            for part in self.parts
        )
        return f"---\ncode: {self.code}\ntitle: A ball\ngiven:\n{rows}require:\n{conditions}---\n{self.words}\n{parts}"

    @property
    def solution(self) -> str:
        letters = LETTERS.split()
        steps = "".join(
            f'        step(Q{part}, "It is so.", law("{PARTS[part][0]}", "Q = {PARTS[part][2]}", '
            f'Q=Q{part}, {", ".join(f"{each}={each}" for each in letters if each in PARTS[part][2])}), answers="{self.ids.get(part, part)}"),\n'
            for part in self.parts
        )
        names = " ".join(f"Q{part}" for part in self.parts)
        return (
            "from corollary.author import derivation, step, unknowns\nfrom corollary.laws import law\n\n\n"
            f"def derive({', '.join(letters)}):\n    {names.replace(' ', ', ')}{',' if len(self.parts) == 1 else ''} = "
            f'unknowns("{names}")\n    return derivation(\n{steps}    )\n'
        )


@dataclass(frozen=True, slots=True)
class ChangingBank:
    folder: Path

    @property
    def bank(self) -> Bank:
        return Bank(self.folder / "bank")

    @property
    def course(self) -> Path:
        return self.folder / "course"

    @property
    def problem_set(self) -> ProblemSet:
        return find_set(self.bank, "week")

    def write(self, text: Text, *more: Text) -> None:
        """The problem's files; the set is made of it and of `more`."""
        for step in ("problems", "solutions"):
            (self.folder / "bank" / step / "topic").mkdir(parents=True, exist_ok=True)
        for place, each in enumerate((text, *more)):
            (self.bank.folder / "problems" / "topic" / f"ball{place}.md").write_text(each.problem)
            (self.bank.folder / "solutions" / "topic" / f"ball{place}.py").write_text(each.solution)
        codes = "".join(f"  - {each.code}\n" for each in (text, *more))
        self.bank.sets.mkdir(exist_ok=True)
        (self.bank.sets / "week.md").write_text(f"---\ntitle: A week\nproblems:\n{codes}---\nBalls.\n")

    def generate(self, *students: str) -> Generated:
        return generate(
            self.course, self.problem_set, [Student(each) for each in students], Solutions(self.bank)
        )

    def hand_in(self, made: Generated, student: str, **wrong: str) -> None:
        """All right, but for these variables."""
        solutions = Solutions(self.bank)
        sheet = worksheet(self.problem_set, Student(student), made.assigned[student].variants)
        keys = {each.problem.code: solutions.key(each.variant) for each in sheet.exercises}
        sources = right_sources(sheet, keys) | {
            f"{name}_answer": f"{name} = {text}" for name, text in wrong.items()
        }
        path = made.course.notebook("submitted", student, "week")
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(filled_in(sheet, sources))

    def grade(
        self,
        course: Course,
        *,
        regrade: bool = False,
        ask: Callable[[tuple[Change, ...]], bool] = lambda changed: True,
    ) -> Outcome:
        return grade_set(
            course,
            self.problem_set,
            Solutions(self.bank),
            partial(Runner, require=0),
            jobs=1,
            regrade=regrade,
            ask=ask,
        )


__all__ = ["PARTS", "ChangingBank", "Text", "replace"]
