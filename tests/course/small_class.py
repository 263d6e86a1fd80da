"""A class of four with one exercise each: right, wrong, blank, and no notebook at all; ready to be marked."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from pathlib import Path

from corollary.course.demo.players import right_sources
from corollary.grading.solutions import Solutions
from corollary.grading.submission import GradingContext, Submission
from corollary.notebook.notebook import filled_in
from corollary.notebook.worksheet import worksheet
from corollary.problem.bank import chapter_bank
from corollary.problem.late_penalty import IN_TIME
from corollary.problem.problem_set import find_set
from corollary.problem.roster import Student
from corollary.problem.variant import at
from corollary.sandbox.runner import Runner

SET = "---\ntitle: One exercise\nproblems:\n  - X12.5\n---\nOne exercise.\n"
POINTS = {"ada": 5.0, "ben": 4.0, "jon": 0.0, "nils": 0.0}


RUNNER = partial(Runner, require=1)


def order(folder: Path, runner: Callable[[], Runner] = RUNNER) -> GradingContext:
    """What a class's submissions are marked by."""
    file = folder / "small.md"
    file.write_text(SET)
    bank = chapter_bank()
    return GradingContext(
        find_set(bank, str(file)), Solutions(bank), b"the key of a course for the tests", runner
    )


def handed_in(by: GradingContext) -> list[Submission]:
    """Ada has all of it right, Ben one part wrong, Jon left it blank, and Nils sent something else."""
    papers = []
    for index, name in enumerate(POINTS):
        variants = (at(by.problem_set.problems[0], 100 + index),)
        paper = worksheet(by.problem_set, Student(name), variants)
        keys = {exercise.problem.code: by.solutions.key(exercise.variant) for exercise in paper.exercises}
        sources = {} if name == "jon" else right_sources(paper, keys)
        if name == "ben":
            sources |= {f"{prompt.key}_answer": f"{prompt.name} = 1e9" for prompt in paper.prompts[:1]}
        text = b'{"cells": [' if name == "nils" else filled_in(paper, sources).encode()
        papers.append(Submission(Student(name), text, variants, IN_TIME, name))
    return papers
