"""A graded set in numbers with intervals: parts, misconceptions, and whether the numbers drawn made a difference."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import asdict, dataclass

from corollary.records.estimate import Estimate
from corollary.records.fairness import FeatureEffect, PartFeatures, feature_effects
from corollary.records.part_statistics import (
    MisconceptionShare,
    PartStatistics,
    answers_to_parts,
    misconception_shares,
    part_statistics,
)
from corollary.records.report_model import Report

COLUMNS = (
    "statistic",
    "problem",
    "part",
    "of",
    "answers",
    "estimate",
    "low",
    "high",
    "p",
    "p_adjusted",
    "power",
    "least_effect",
    "students",
)


@dataclass(frozen=True, slots=True)
class SetStatistics:
    """All intervals are of 95 %. Effects are sorted, the surest first."""

    parts: tuple[PartStatistics, ...]
    misconceptions: tuple[MisconceptionShare, ...]
    effects: tuple[FeatureEffect, ...]


def set_statistics(report: Report, features: PartFeatures) -> SetStatistics:
    """Of the marks in `report`."""
    answers = answers_to_parts(report.rows)
    return SetStatistics(
        tuple(part_statistics(answers)),
        tuple(misconception_shares(report.met, answers)),
        tuple(feature_effects(answers, features)),
    )


def statistics_record(found: SetStatistics) -> dict[str, object]:
    """As plain data for one JSON document."""
    return {
        "parts": [asdict(each) for each in found.parts],
        "misconceptions": [asdict(each) for each in found.misconceptions],
        "effects": [asdict(each) for each in found.effects],
    }


def statistics_rows(found: SetStatistics) -> Iterator[Sequence[str]]:
    """A table with one estimate a row, headed by COLUMNS; what a row has nothing of is blank, students stand with spaces between."""
    yield COLUMNS
    for each in found.parts:
        place = (each.problem, each.part, "", str(each.answers))
        yield ("difficulty", *place, *_numbers(each.difficulty), *[""] * 5)
        if each.discrimination is not None:
            yield ("discrimination", *place, *_numbers(each.discrimination), *[""] * 5)
    for one in found.misconceptions:
        place = (one.verdict, one.problem, one.part, one.text, "")
        yield (*place, *_numbers(one.share), *[""] * 4, " ".join(one.students))
    for effect in found.effects:
        place = ("effect", effect.problem, effect.part, effect.feature, str(effect.answers))
        known = (effect.p, effect.adjusted, effect.power, effect.least)
        yield (*place, *_numbers(effect.effect), *(f"{number:.6g}" for number in known), "")


def _numbers(estimate: Estimate) -> tuple[str, str, str]:
    return f"{estimate.value:.6g}", f"{estimate.low:.6g}", f"{estimate.high:.6g}"
