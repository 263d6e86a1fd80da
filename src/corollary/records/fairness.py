"""Whether the numbers that a student drew made a part harder: a regression on what the derivation knows of these numbers."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from statistics import NormalDist

import numpy as np

from corollary.records.estimate import BOTH_SIDES, Estimate
from corollary.records.logistic import NoFit, logistic_fit
from corollary.records.part_statistics import AnswersToPart

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
