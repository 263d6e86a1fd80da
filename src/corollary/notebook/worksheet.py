"""A worksheet: what one student gets, before any file format; it holds questions and numbers, and no truth."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace

from corollary.answers.answer_type import AnswerType
from corollary.answers.question import Question
from corollary.answers.questions import checked, question_in
from corollary.answers.registry import answer_type
from corollary.problem.figure import drawn
from corollary.problem.part import Option, Part
from corollary.problem.problem import Problem
from corollary.problem.problem_set import ProblemSet
from corollary.problem.roster import Student
from corollary.problem.statement import filled
from corollary.problem.translation import in_language
from corollary.problem.variant import Variant


@dataclass(frozen=True, slots=True)
class Prompt:
    """One part asked; `name` is the variable that takes the answer, `key` names the part in the whole set (X12_5_a).

    `question` is the part as readers of answers see it.
    """

    problem: Problem
    part: Part
    question: Question
    text: str
    options: tuple[Option, ...]
    out_of: float

    @property
    def name(self) -> str:
        return self.problem.variable(self.part)

    @property
    def key(self) -> str:
        return self.problem.answer_name(self.part)

    @property
    def answer_types(self) -> tuple[AnswerType, ...]:
        """One; or two, for a function and a figure drawn with it."""
        return tuple(map(answer_type, self.part.answer_types))


@dataclass(frozen=True, slots=True)
class Exercise:
    """A problem with one student's numbers; `figure` is SVG text with the numbers in it, or empty."""

    variant: Variant
    statement: str
    figure: str
    figure_alt: str
    prompts: tuple[Prompt, ...]

    @property
    def problem(self) -> Problem:
        return self.variant.problem


@dataclass(frozen=True, slots=True)
class Worksheet:
    problem_set: ProblemSet
    student: Student
    exercises: tuple[Exercise, ...]

    @property
    def prompts(self) -> tuple[Prompt, ...]:
        return tuple(prompt for exercise in self.exercises for prompt in exercise.prompts)


@dataclass(frozen=True, slots=True)
class SheetPlan:
    """A worksheet yet to be made: whose it is, and its numbers in the order of the set's problems."""

    problem_set: ProblemSet
    student: Student
    variants: tuple[Variant, ...]

    def worksheet(self) -> Worksheet:
        """Raises Malformed, as `exercise`."""
        return worksheet(self.problem_set, self.student, self.variants)


def exercise(variant: Variant, weight: float = 1.0) -> Exercise:
    """What a student reads of one variant. Raises Malformed when a part's heading does not fit its answer type."""
    problem = checked(in_language(variant.problem))
    variant = replace(variant, problem=problem)
    prompts = tuple(
        Prompt(
            problem,
            part,
            question,
            _text(part, question, variant),
            _options(part, variant),
            part.points * weight,
        )
        for part in problem.parts
        for question in [question_in(variant, part)]
    )
    figure = drawn(variant)
    return Exercise(variant, filled(problem.statement, variant), figure.svg, figure.alt, prompts)


def _options(part: Part, variant: Variant) -> tuple[Option, ...]:
    """The options as they are listed below the question; none where the heading names them."""
    if not answer_type(part.answer_type).shows_letters:
        return ()
    return tuple(Option(option.letter, filled(option.text, variant)) for option in part.options)


def _text(part: Part, question: Question, variant: Variant) -> str:
    """The question with its numbers, and what its answer type adds."""
    more = answer_type(part.answer_type).instructions(question)
    return "\n\n".join(filter(None, (filled(part.text, variant), more)))


def worksheet(problem_set: ProblemSet, student: Student, variants: Iterable[Variant]) -> Worksheet:
    """One student's worksheet; the variants in the order of the set's problems."""
    return Worksheet(
        problem_set,
        student,
        tuple(exercise(variant, problem_set.weight(variant.problem)) for variant in variants),
    )
