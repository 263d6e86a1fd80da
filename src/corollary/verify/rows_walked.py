"""Every row of a problem's tables dealt once, and rows that no student gets."""

from __future__ import annotations

from corollary.derive.solution import Solution
from corollary.grading.assign import admitted
from corollary.grading.key import Key
from corollary.problem.axes import GridAxis, tables
from corollary.problem.sampling import sample_of_row
from corollary.problem.variant import first_broken, row_in_words
from corollary.verify.checked import Tally

TRIED = 40  # draws of one row, of which one that may be assigned is enough


def keys_of_rows(solution: Solution, tally: Tally) -> list[Key]:
    """A key with each row of each table; a note for each row that is never dealt."""
    problem, found = solution.problem, list[Key]()
    for columns in tables(problem):
        for place in range(columns[0].grid.count):
            key, reason = _dealt(solution, columns, place)
            if key is not None:
                found.append(key)
                tally.count("rows walked")
                continue
            line = columns[0].line
            tally.note(
                f"{problem.path.name}:{line}: the row ({row_in_words(columns, place)}) of {columns[0].table} was not dealt in "
                f"{TRIED} draws ({reason}); leave it out, or widen the ranges of the other givens"
            )
    return found


def _dealt(solution: Solution, columns: GridAxis, place: int) -> tuple[Key | None, str]:
    reason = "no numbers keep the conditions"
    for variant in sample_of_row(solution.problem, columns, place, TRIED):
        if (broken := first_broken(variant)) is not None:
            reason = f"the condition {broken.text} does not hold"
            continue
        key, why = admitted(solution, variant)
        if key is not None:
            return key, ""
        reason = why
    return None, reason
