"""What programs are called with."""

from __future__ import annotations

from corollary.derive.statements import Code
from corollary.grading.programs.judge import inputs_of
from corollary.grading.solutions import Solutions
from corollary.problem.bank import chapter_bank
from corollary.problem.variant import chapter


def test_programs_are_called_with_numbers_of_the_ranges_that_are_drawn_from():
    """Each student has others, the same each time."""
    solution = Solutions(chapter_bank()).of(chapter_bank()["P12.15"])
    part = solution.problem.part("j")
    code = next(each for each in solution.entries if isinstance(each, Code) and each.statement.part == "j")
    variant = chapter(solution.problem)
    drawn = [inputs_of(code, variant, part, b"key", student) for student in ("ada", "cy", "ada")]
    assert drawn[0] == drawn[2] != drawn[1]
    for case in (*drawn[0], *drawn[1]):
        assert 0.5 <= case["m"] <= 4
        assert 40 <= case["k"] <= 300
        assert 0.8 <= case["b"] <= 1.6
