"""A course whose set `kicks` has one problem, in a bank that may be edited after it was handed out."""

from __future__ import annotations

import shutil
from dataclasses import dataclass
from pathlib import Path

import pytest

from corollary.course.generate import Generated, generate
from corollary.grading.solutions import Solutions
from corollary.problem.bank import Bank, chapter_bank
from corollary.problem.problem_set import ProblemSet, find_set
from corollary.problem.roster import Student

SET = "---\ntitle: Kicks\nproblems:\n  - X12.5\n---\nKick it.\n"


@dataclass(frozen=True, slots=True)
class Kicks:
    """The bank as it is at the moment, and what is generated from it."""

    bank: Bank
    folder: Path

    @property
    def file(self) -> Path:
        return self.bank.problems / "impulse" / "kicking_a_ball.md"

    @property
    def set_file(self) -> Path:
        return self.bank.sets / "kicks.md"

    @property
    def problem_set(self) -> ProblemSet:
        return find_set(self.bank, "kicks")

    def edit(self, *pairs: tuple[str, str], file: Path | None = None) -> None:
        """Replaces each text in the problem's file by another one; it must be there."""
        text = (file or self.file).read_text()
        for old, new in pairs:
            assert old in text, old
            text = text.replace(old, new)
        (file or self.file).write_text(text)

    def edit_solution(self, *pairs: tuple[str, str]) -> None:
        self.edit(*pairs, file=self.bank.folder / "solutions" / "impulse" / "kicking_a_ball.md")

    def generate(self, *students: str, folder: Path | None = None) -> Generated:
        roster = [Student(each) for each in students or ("ada", "ben", "cyd")]
        return generate(folder or self.folder, self.problem_set, roster, Solutions(self.bank))


@pytest.fixture
def kicks(tmp_path: Path) -> Kicks:
    bank = tmp_path / "bank"
    for step, name in (("problems", "kicking_a_ball.md"), ("solutions", "kicking_a_ball.md")):
        (bank / step / "impulse").mkdir(parents=True)
        shutil.copy(chapter_bank().folder / step / "impulse" / name, bank / step / "impulse")
    (bank / "problems" / "sets").mkdir()
    (bank / "problems" / "sets" / "kicks.md").write_text(SET)
    return Kicks(Bank(bank), tmp_path / "course")
