"""A graded set in numbers with intervals: parts, misconceptions, and whether the numbers drawn made a difference."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import asdict, dataclass

from corollary.records.estimate import Estimate, share
from corollary.records.fairness import FeatureEffect, PartFeatures, feature_effects
from corollary.records.part_statistics import (
    MisconceptionShare,
    PartStatistics,
    answers_to_parts,
    misconception_shares,
    part_statistics,
)
from corollary.records.report_model import Report
from corollary.records.unlisted import SharedRule, shared_rules_record

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
    """All intervals are of 95 %. Effects are sorted, the surest first; `unlisted` are offers to the author, by which nobody is marked."""

    parts: tuple[PartStatistics, ...]
    misconceptions: tuple[MisconceptionShare, ...]
    effects: tuple[FeatureEffect, ...]
    unlisted: tuple[SharedRule, ...] = ()


def set_statistics(
    report: Report, features: PartFeatures, unlisted: Sequence[SharedRule] = ()
) -> SetStatistics:
    """Of the marks in `report`."""
    answers = answers_to_parts(report.rows)
    return SetStatistics(
        tuple(part_statistics(answers)),
        tuple(misconception_shares(report.met, answers)),
        tuple(feature_effects(answers, features)),
        tuple(unlisted),
    )


def statistics_record(found: SetStatistics) -> dict[str, object]:
    """As plain data for one JSON document."""
    return {
        "parts": [asdict(each) for each in found.parts],
        "misconceptions": [asdict(each) for each in found.misconceptions],
        "effects": [asdict(each) for each in found.effects],
        "unlisted": [shared_rules_record(each) for each in found.unlisted],
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
    for offer in found.unlisted:
        rules = " or ".join(f"{rule.words}: {rule.formula}" for rule in offer.rules)
        place = ("unlisted", offer.problem, offer.part, rules, str(offer.wrong))
        sure = (f"{offer.p:.6g}", f"{offer.adjusted:.6g}", "", "")
        yield (*place, *_numbers(share(len(offer.students), offer.wrong)), *sure, " ".join(offer.students))


def _numbers(estimate: Estimate) -> tuple[str, str, str]:
    return f"{estimate.value:.6g}", f"{estimate.low:.6g}", f"{estimate.high:.6g}"
