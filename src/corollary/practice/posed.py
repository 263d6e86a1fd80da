"""An exercise posed for practice: one problem with numbers of its own, answered part by part as often as one likes."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property

from corollary.answers.preview import Preview
from corollary.answers.questions import question_in
from corollary.answers.registry import answer_type
from corollary.grading.from_json import from_json
from corollary.grading.judge import judge
from corollary.grading.key import Key
from corollary.grading.part_grades import PartGrade
from corollary.grading.points import grade
from corollary.grading.run_programs import run_programs
from corollary.grading.solutions import worked_steps_of
from corollary.notebook.worksheet import Exercise, exercise
from corollary.practice.hints import Hints, hints, hints_by_known
from corollary.problem.part import Part

Answer = str | list[str]


@dataclass(frozen=True)
class Posed:
    """A problem with the numbers of `key`, as a student practises it. An answer is a text, or one for each component."""

    key: Key

    @cached_property
    def exercise(self) -> Exercise:
        """What is asked. Raises Malformed when a part's heading does not fit its answer type."""
        return exercise(self.key.variant)

    def part(self, name: str) -> Part:
        """Raises LookupError for a part that the problem does not have."""
        found = next((each for each in self.exercise.problem.parts if each.id == name), None)
        if found is None:
            raise LookupError(f"{self.exercise.problem.code} has no part {name}")
        return found

    def preview(self, name: str, answer: Answer) -> Preview:
        """How an answer is read, never whether it is right; nothing is run."""
        part = self.part(name)
        its_type = answer_type(part.answer_type)
        return its_type.preview(from_json(answer), question_in(self.exercise.variant, part))

    def judged(self, name: str, answers: Mapping[str, Answer], wrong_before: int = 0) -> PartGrade:
        """What one part earns after so many wrong answers to it, with the others' answers to carry on from; only its own program
        is run, in isolation."""
        self.part(name)
        values = {part: from_json(answer) for part, answer in answers.items()}
        programs = run_programs(self.key, {part: value for part, value in values.items() if part == name})
        return grade(self.key, judge(self.key, values, programs), wrong_before=wrong_before)[name]

    def hints(self, name: str, right: frozenset[str]) -> tuple[str, ...]:
        """What may be told of a part, one after the other, to whom the parts in `right` are known."""
        return hints(self.key, self.part(name), right)

    def hints_by_known(self, name: str) -> Hints:
        """The same for every choice of known parts."""
        return hints_by_known(self.key, self.part(name))

    @cached_property
    def worked_steps(self) -> tuple[str, ...]:
        """The worked solution as Markdown, step by step."""
        return tuple(worked_steps_of(self.key))
