"""How hard each part was and how well it tells students apart, with intervals; and what share holds which misconception."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from corollary.records.estimate import Estimate, correlation, share
from corollary.records.record import UNMARKED, Row
from corollary.records.report_model import Met

Place = tuple[str, str]
FULL = 1e-9  # of the points: what may be missing from all of them


@dataclass(frozen=True, slots=True)
class AnswersToPart:
    """What became of one part that is marked: in the same order the students, whether each has all points (0 or 1), and what
    share of the points of the other parts each has (NaN for who has no other)."""

    problem: str
    part: str
    students: tuple[str, ...]
    right: NDArray[np.float64]
    rest: NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class PartStatistics:
    """`difficulty` is the share of students with all points (easy is near 1), `discrimination` the correlation of that with the
    share of the points of all other parts; None where it says nothing: too few answers, or all of one kind."""

    problem: str
    part: str
    answers: int
    difficulty: Estimate
    discrimination: Estimate | None


@dataclass(frozen=True, slots=True)
class MisconceptionShare:
    """What share of the answers to a part shows a misconception or slip, and whose they are."""

    verdict: str
    text: str
    problem: str
    part: str
    share: Estimate
    students: tuple[str, ...]


def answers_to_parts(rows: Sequence[Row]) -> list[AnswersToPart]:
    """By part, in the order of their first row; what waits for a person, and what earns nothing anyway, is left out."""
    counted = [row for row in rows if row.verdict != UNMARKED and row.out_of > 0]
    points: dict[str, tuple[float, float]] = {}
    for row in counted:
        earned, out_of = points.get(row.student, (0.0, 0.0))
        points[row.student] = earned + row.points, out_of + row.out_of
    by_part: dict[Place, list[Row]] = {}
    for row in counted:
        by_part.setdefault((row.problem, row.part), []).append(row)
    return [
        AnswersToPart(
            *place,
            tuple(row.student for row in its),
            np.array([float(row.points >= row.out_of * (1 - FULL)) for row in its]),
            np.array([_rest(row, *points[row.student]) for row in its]),
        )
        for place, its in by_part.items()
    ]


def _rest(row: Row, earned: float, out_of: float) -> float:
    others = out_of - row.out_of
    return (earned - row.points) / others if others > FULL else float("nan")


def part_statistics(answers: Sequence[AnswersToPart]) -> list[PartStatistics]:
    found: list[PartStatistics] = []
    for each in answers:
        known = np.isfinite(each.rest)
        found.append(
            PartStatistics(
                each.problem,
                each.part,
                len(each.right),
                share(int(each.right.sum()), len(each.right)),
                correlation(each.right[known], each.rest[known]),
            )
        )
    return found


def misconception_shares(met: Sequence[Met], answers: Sequence[AnswersToPart]) -> list[MisconceptionShare]:
    """As many as were met, in their order; the share is of all answers to that part."""
    of: Mapping[Place, int] = {(each.problem, each.part): len(each.right) for each in answers}
    return [
        MisconceptionShare(
            one.verdict, one.text, one.problem, one.part, share(len(one.students), count), one.students
        )
        for one in met
        if (count := max(of.get((one.problem, one.part), 0), len(one.students)))
    ]
