"""A sheet: what one student gets, before any file format; it holds questions and numbers, and no truth."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from corollary.problem.part import Option, Part
from corollary.problem.problem import Problem
from corollary.problem.problem_set import ProblemSet
from corollary.problem.roster import Student
from corollary.problem.statement import filled
from corollary.problem.variant import Variant


@dataclass(frozen=True, slots=True)
class Prompt:
    """One part asked; `name` is the variable that takes the answer, `key` names the part in the whole set (X12_5_a)."""

    problem: Problem
    part: Part
    text: str
    options: tuple[Option, ...]
    out_of: float

    @property
    def name(self) -> str:
        return self.problem.answer_name(self.part)

    @property
    def key(self) -> str:
        return self.name


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


def exercise(variant: Variant, weight: float = 1.0) -> Exercise:
    """What a student reads of one variant."""
    problem = variant.problem
    prompts = tuple(
        Prompt(
            problem,
            part,
            filled(part.text, variant) + letters(problem, part),
            tuple(Option(option.letter, filled(option.text, variant)) for option in part.options),
            part.points * weight,
        )
        for part in problem.parts
    )
    figure, alt = filled(problem.figure, variant), filled(problem.figure_alt, variant)
    return Exercise(variant, filled(problem.statement, variant), figure, alt, prompts)


def letters(problem: Problem, part: Part) -> str:
    """For parts answered in formulas: how each letter is typed, and what it stands for. Empty for the others."""
    if part.kind not in ("expression", "proof"):
        return ""
    known = ", ".join(f"`{given.symbol}` ({given.meaning})" for given in problem.givens)
    more = (
        f"; and, as said above, {', '.join(f'`{name}`' for name in part.components)}"
        if part.kind == "proof"
        else ""
    )
    return f"\n\nLetters: {known}{more}. Write `*` for a product and `^` for a power."


def worksheet(problem_set: ProblemSet, student: Student, variants: Iterable[Variant]) -> Worksheet:
    """One student's sheet; the variants in the order of the set's problems."""
    return Worksheet(
        problem_set,
        student,
        tuple(exercise(variant, problem_set.weight(variant.problem)) for variant in variants),
    )
