"""One submission from its bytes: run when it is of its set, and left alone when it belongs to another."""

from __future__ import annotations

from pathlib import Path

import pytest

from corollary.grading.solutions import Solutions
from corollary.grading.submission import GradingContext, Submission, mark_submission
from corollary.notebook.notebook import filled_in
from corollary.problem.bank import chapter_bank, find
from corollary.problem.late_penalty import IN_TIME
from corollary.problem.problem_set import ProblemSet, read_set
from corollary.problem.roster import Student
from corollary.problem.variant import chapter
from corollary.sandbox.isolation import UNKNOWN
from corollary.sandbox.job import ExecutionResult

ADA = Student("ada")


class Asked:
    """Stands for a runner: it says that it was asked, and runs nothing."""

    def __init__(self):
        self.times = 0

    def execute(self, job: object) -> ExecutionResult:
        self.times += 1
        return ExecutionResult(
            (), {}, {}, (), UNKNOWN, "There is no room left on the disk.", machine_failed=True
        )


def of(folder: Path, name: str, code: str) -> tuple[ProblemSet, Submission, GradingContext]:
    """A set of one problem, and its untouched notebook as Ada hands it in."""
    bank = chapter_bank()
    path = folder / f"{name}.md"
    path.write_text(f"---\ntitle: {name}\nproblems: [{code}]\n---\n")
    problem_set = read_set(bank, path)
    context = GradingContext(problem_set, Solutions(bank), b"secret", Asked)
    empty = Submission(ADA, b"", (chapter(find(bank, code)),), IN_TIME, "")
    content = filled_in(context.worksheet(empty), {}).encode()
    return problem_set, Submission(ADA, content, empty.variants, IN_TIME, ""), context


@pytest.mark.parametrize("own", [True, False])
def test_only_a_notebook_of_the_set_is_run(tmp_path, own):
    _, mine, context = of(tmp_path, "mine", "X12.5")
    _, other, _ = of(tmp_path, "other", "X12.7")
    runner = Asked()
    handed_in = mine if own else Submission(ADA, other.content, mine.variants, IN_TIME, "")
    found = mark_submission(context, runner, handed_in)
    assert runner.times == own
    assert found.marked.machine_failed == own
    if not own:
        assert "belongs to other, not to mine" in found.marked.trouble
    assert [grade.variant.problem.code for grade in found.marked.grades] == ["X12.5"]
