"""Statistics of a graded set: parts, misconceptions, fairness of the numbers drawn, and intervals that hold for small classes."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass, replace
from statistics import NormalDist
from typing import Final

import numpy as np
from numpy.typing import NDArray

from corollary.records.marks import UNMARKED, Row
from corollary.records.report_model import Met, Report, is_unfinished
from corollary.records.rubrics import RubricCount
from corollary.records.unlisted import SharedRule, shared_rules_record

Numbers = NDArray[np.float64]

BOTH_SIDES: Final = NormalDist().inv_cdf(0.975)
LEAST_PAIRS: Final = 8  # of fewer pairs the interval of a correlation is a guess


@dataclass(frozen=True, slots=True)
class Estimate:
    """A value, and between what the truth is believed to be, at 95 %."""

    value: float
    low: float
    high: float


def share(count: int, of: int) -> Estimate:
    """`count` of `of` answers as a share, with the interval of Wilson 1927 (doi:10.1080/01621459.1927.10502953), which holds for
    few answers too. Raises ValueError where there are none."""
    if of <= 0:
        raise ValueError("a share of no answers is not defined")
    found, z2 = count / of, BOTH_SIDES**2
    middle = (found + z2 / (2 * of)) / (1 + z2 / of)
    reach = BOTH_SIDES / (1 + z2 / of) * math.sqrt(found * (1 - found) / of + z2 / (4 * of * of))
    return Estimate(found, max(0.0, min(found, middle - reach)), min(1.0, max(found, middle + reach)))


def correlation(first: Numbers, second: Numbers) -> Estimate | None:
    """Pearson's correlation of two arrays of one length; None for fewer than eight pairs, and where one of them is constant.

    The interval is made on Fisher's scale, artanh(r), with the standard error that the data themselves have (the influence of
    each pair, Devlin, Gnanadesikan and Kettenring 1975, doi:10.1093/biomet/62.3.531): neither needs to be normal, and one may be
    of zeros and ones.
    """
    if len(first) < LEAST_PAIRS or not np.ptp(first) or not np.ptp(second):
        return None
    x, y = _standardized(first), _standardized(second)
    r = float(np.mean(x * y))
    if 1 - abs(r) < 1e-12:
        return Estimate(r, r, r)
    influence = x * y - r * (x * x + y * y) / 2
    spread = float(influence.std(ddof=1)) / math.sqrt(len(x) - 3) / (1 - r * r)
    reach = BOTH_SIDES * spread
    return Estimate(r, math.tanh(math.atanh(r) - reach), math.tanh(math.atanh(r) + reach))


def _standardized(values: Numbers) -> Numbers:
    return (values - values.mean()) / values.std()


MOST_STEPS, LONGEST_STEP, SETTLED = 60, 2.0, 1e-8


@dataclass(frozen=True, slots=True)
class LogisticFit:
    """One coefficient a column, in logits for each unit of the column, and their standard errors."""

    coefficients: Numbers
    errors: Numbers


class NoFit(ArithmeticError):
    """The columns depend on each other, or the steps do not settle."""


def logistic_fit(columns: Numbers, right: Numbers) -> LogisticFit:
    """`columns` has a row for each answer (shape n × k, a column of ones among them), `right` is 0 or 1 for each.

    The estimate is Firth's (1993, doi:10.1093/biomet/80.1.27), as in Heinze and Schemper 2002 (doi:10.1002/sim.1047): the score
    is moved by half the leverages, which takes away the first order of the bias. Raises NoFit.
    """
    found = np.zeros(columns.shape[1])
    for _ in range(MOST_STEPS):
        chance, weighted, inverse = _information(columns, found)
        leverage = np.einsum("ij,jk,ik->i", weighted, inverse, columns)
        step = inverse @ (columns.T @ (right - chance + leverage * (0.5 - chance)))
        longest = float(np.abs(step).max())
        found = found + step * min(1.0, LONGEST_STEP / longest if longest else 1.0)
        if longest < SETTLED:
            return LogisticFit(found, np.sqrt(np.diag(inverse)))
    raise NoFit(f"the fit has not settled in {MOST_STEPS} steps")


def _information(columns: Numbers, at: Numbers) -> tuple[Numbers, Numbers, Numbers]:
    """The chance of each to be right, the columns by their weights, and the inverse of the information. Raises NoFit."""
    chance = 1 / (1 + np.exp(-np.clip(columns @ at, -35, 35)))
    weighted = columns * (chance * (1 - chance))[:, None]
    try:
        inverse = np.linalg.inv(weighted.T @ columns).astype(np.float64)
    except np.linalg.LinAlgError as error:
        raise NoFit("the columns depend on each other") from error
    if not np.all(np.isfinite(inverse)) or np.any(np.diag(inverse) <= 0):
        raise NoFit("the columns depend on each other")
    return chance, weighted, inverse


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
    unfinished = {place for place, its in _by_part(rows).items() if is_unfinished(its)}
    counted = [
        row
        for row in rows
        if row.verdict != UNMARKED and row.out_of > 0 and (row.problem, row.part) not in unfinished
    ]
    points: dict[str, tuple[float, float]] = {}
    for row in counted:
        earned, out_of = points.get(row.student, (0.0, 0.0))
        points[row.student] = earned + row.points, out_of + row.out_of
    return [
        AnswersToPart(
            *place,
            tuple(row.student for row in its),
            np.array([float(row.points >= row.out_of * (1 - FULL)) for row in its]),
            np.array([_rest(row, *points[row.student]) for row in its]),
        )
        for place, its in _by_part(counted).items()
    ]


def _by_part(rows: Iterable[Row]) -> dict[Place, list[Row]]:
    found: dict[Place, list[Row]] = {}
    for row in rows:
        found.setdefault((row.problem, row.part), []).append(row)
    return found


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


LEAST_ANSWERS, LEAST_OF_EACH = 20, 5  # with fewer, or fewer right or wrong ones, any effect would pass unseen
HALF_A_LOGIT = 0.5
POWER = 0.8

PartFeatures = Mapping[tuple[str, str, str], Mapping[str, float]]
"""Of each student, problem and part, what is known of the numbers, by the name of the feature."""


@dataclass(frozen=True, slots=True)
class FeatureEffect:
    """How far a feature of the numbers drawn moves the odds of being right, in logits for each standard deviation of it, at equal
    points in the other parts. `adjusted` is `p` after Holm's correction for all effects that were looked for. `power` is the chance
    that half a logit would be found (at 5 %, before the correction), `least` the effect that is found four times in five."""

    problem: str
    part: str
    feature: str
    answers: int
    effect: Estimate
    p: float
    adjusted: float
    power: float
    least: float


def feature_effects(answers: Sequence[AnswersToPart], features: PartFeatures) -> list[FeatureEffect]:
    """Feature by feature, the surest first; none where it is the same for everybody, where there are fewer than twenty answers, or
    fewer than five of one kind."""
    found: list[FeatureEffect] = []
    for each in answers:
        known = [features.get((student, each.problem, each.part)) for student in each.students]
        for name in dict.fromkeys(name for one in known if one is not None for name in one):
            values = [np.nan if one is None else one.get(name, np.nan) for one in known]
            effect = _effect(each, name, np.array(values))
            if effect is not None:
                found.append(effect)
    found.sort(key=lambda effect: effect.p)
    return _holm(found)


def _effect(answers: AnswersToPart, name: str, values: np.ndarray) -> FeatureEffect | None:
    known = np.isfinite(values)
    right, values, rest = answers.right[known], values[known], answers.rest[known]
    kinds = min(right.sum(), len(right) - right.sum())
    if len(right) < LEAST_ANSWERS or kinds < LEAST_OF_EACH or values.std() <= 1e-9 * np.abs(values).max():
        return None
    columns = [np.ones(len(right)), (values - values.mean()) / values.std()]
    if np.all(np.isfinite(rest)) and rest.std() > 0:
        columns.append((rest - rest.mean()) / rest.std())
    try:
        fit = logistic_fit(np.column_stack(columns), right)
    except NoFit:  # the feature is the ability in disguise, and nothing can be said of it
        return None
    size, error = float(fit.coefficients[1]), float(fit.errors[1])
    normal = NormalDist()
    reach = BOTH_SIDES * error
    p = 2 * normal.cdf(-abs(size) / error)
    power = normal.cdf(HALF_A_LOGIT / error - BOTH_SIDES) + normal.cdf(-HALF_A_LOGIT / error - BOTH_SIDES)
    least = (BOTH_SIDES + normal.inv_cdf(POWER)) * error
    effect = Estimate(size, size - reach, size + reach)
    return FeatureEffect(answers.problem, answers.part, name, len(right), effect, p, p, power, least)


def _holm(effects: Sequence[FeatureEffect]) -> list[FeatureEffect]:
    """Holm 1979: the smallest of m counts m times, the next m - 1 times, and none less than one before it."""
    found: list[FeatureEffect] = []
    highest = 0.0
    for place, each in enumerate(effects):
        highest = max(highest, min(1.0, each.p * (len(effects) - place)))
        found.append(replace(each, adjusted=highest))
    return found


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
    rubric: tuple[RubricCount, ...] = ()


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
        report.rubric,
    )


def statistics_record(found: SetStatistics) -> dict[str, object]:
    """As plain data for one JSON document."""
    return {
        "parts": [asdict(each) for each in found.parts],
        "misconceptions": [asdict(each) for each in found.misconceptions],
        "effects": [asdict(each) for each in found.effects],
        "unlisted": [shared_rules_record(each) for each in found.unlisted],
        "rubric": [
            {**asdict(one), "share": asdict(share(len(one.students), one.of))} for one in found.rubric
        ],
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
    for item in found.rubric:
        place = ("rubric", item.problem, item.part, item.text, str(item.of))
        yield (*place, *_numbers(share(len(item.students), item.of)), *[""] * 4, " ".join(item.students))
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
