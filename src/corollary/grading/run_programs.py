"""Programs handed in as text, without a notebook: run in isolation, and called."""

from __future__ import annotations

from collections.abc import Mapping

from corollary.answers.registry import answer_type
from corollary.formula.value import Text, Value
from corollary.grading.key import Key
from corollary.grading.program_run import ProgramRun
from corollary.grading.programs.judge_programs import asks
from corollary.sandbox.job import Cell, Job
from corollary.sandbox.runner import Runner

USUAL = "import numpy as np\nimport matplotlib.pyplot as plt"


def run_programs(key: Key, answers: Mapping[str, Value]) -> dict[str, ProgramRun]:
    """What the source texts among the answers do when run; starts nothing when there are none."""
    problem = key.variant.problem
    sources = {
        part.id: given.text
        for part in problem.parts
        if answer_type(part.answer_type).found_in in ("function", "figure")
        and isinstance(given := answers.get(part.id), Text)
    }
    if not sources:
        return {}
    with Runner() as runner:
        return {part: ran(runner, key, part, source) for part, source in sources.items()}


def ran(runner: Runner, key: Key, part: str, source: str) -> ProgramRun:
    """What one part's program does when run and called."""
    problem = key.variant.problem
    cells = (Cell("usual", USUAL), Cell(part, source))
    calls = tuple(asks(key.solution, key.variant, problem.part(part), b"", ""))
    executed = runner.execute(Job(cells, (), calls, pictures=False))
    return ProgramRun(executed.calls, executed.figures, True)
