"""Records of marks: how each came about, so that it can be looked up, compared and never silently changed."""

from __future__ import annotations

from dataclasses import asdict
from typing import Any

from corollary.answers.verdict import Mistaken, Slip, Unmarked, word
from corollary.grading.from_json import finite
from corollary.grading.part_grades import Grade, Marked, PartGrade


def part_record(part: PartGrade) -> dict[str, Any]:
    """One part, as `judge --json` and `grade --json` show it."""
    entry: dict[str, Any] = {
        "verdict": word(part.verdict),
        "points": part.points,
        "out_of": part.out_of,
        "answer": part.answer,
        "feedback": part.feedback,
    }
    if part.basis:
        entry["basis"] = list(part.basis)
    match part.verdict:
        case Mistaken(mistake, _):
            entry["mistake"] = mistake
        case Slip(slip):
            entry["slip"] = slip
        case Unmarked(_, rubric):
            entry["rubric"] = list(rubric)
        case _:
            pass
    return entry


def grade_record(grade: Grade) -> dict[str, Any]:
    """One problem."""
    return {
        "code": grade.variant.problem.code,
        "given": {name: finite(value) for name, value in grade.variant.si.items()},
        "points": round(grade.points, 6),
        "out_of": grade.out_of,
        "parts": {part.part.id: part_record(part) for part in grade.parts},
    }


def marked_record(marked: Marked) -> dict[str, Any]:
    """One submission; the parts are named as in the notebook (X12_5_a)."""
    return {
        "points": round(marked.points, 6),
        "out_of": marked.out_of,
        "parts": {
            grade.variant.problem.answer_name(part.part): part_record(part)
            for grade in marked.grades
            for part in grade.parts
        },
        "variants": {grade.variant.problem.code: grade.variant.index for grade in marked.grades},
        "isolation": marked.isolation,
        "trouble": marked.trouble,
        "late": marked.late,
        "late_share": marked.late_share,
        "notes": list(marked.notes),
        "stopped": [asdict(each) for each in marked.stopped],
    }
