"""Whether the report's intervals hold what they say, and how often the regression finds an unfair feature.

`python benchmarks/item_statistics.py [--courses 400] [--markdown FILE]`

Students with an ability (normal, sd 1) answer twelve parts; how hard the first is depends on a feature of the numbers drawn, by so
many logits a standard deviation. The truth is known: shares and correlations from a course of half a million. Rows go through the
functions that the report calls. For comparison the usual table: Pearson's chi-square of right and wrong over 50 variants.
"""

# pyright: reportUnknownArgumentType=false, reportUnknownMemberType=false, reportUnknownVariableType=false

from __future__ import annotations

import argparse
from collections.abc import Iterator
from pathlib import Path

import numpy as np
from scipy.stats import chi2

from corollary.records.marks import Row
from corollary.records.statistics import AnswersToPart, answers_to_parts, feature_effects, part_statistics

PARTS, VARIANTS = 12, 50
EASY, APART = np.linspace(-1.5, 2.0, PARTS), np.linspace(0.7, 1.5, PARTS)
EASY[0] = 0.7  # two thirds right, as in the plan for such a study
EFFECTS, CLASSES = (0.0, 0.3, 0.5), (60, 120, 200, 400)
MANY = 500_000


def main() -> None:
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("--courses", type=int, default=400, help="simulated courses of each kind")
    parser.add_argument("--markdown", type=Path)
    asked = parser.parse_args()
    text = "\n".join(_table(asked.courses))
    print(text)
    if asked.markdown:
        asked.markdown.write_text(text + "\n", encoding="utf-8")


def _table(courses: int) -> Iterator[str]:
    yield f"# What the statistics of a set are worth\n\n`python benchmarks/item_statistics.py --courses {courses}`\n"
    yield (
        f"{courses} simulated courses of each kind, {PARTS} parts, one of them with an effect of the numbers drawn. Intervals are"
        " of 95 %; the feature is asked for at 5 %.\n"
    )
    yield "| students | effect (logits a s.d.) | difficulty held | discrimination held | effect held | found | power stated | chi-square of 50 variants finds |"
    yield "|---|---|---|---|---|---|---|---|"
    for effect in EFFECTS:
        right, _ = _answers(np.random.default_rng(1), MANY, effect)
        shares = right.mean(axis=0)
        rests = [(right.sum(axis=1) - right[:, part]) / (PARTS - 1) for part in range(PARTS)]
        apart = [np.corrcoef(right[:, part], rests[part])[0, 1] for part in range(PARTS)]
        for students in CLASSES:
            held = np.array([_course(seed, students, effect, shares, apart) for seed in range(courses)])
            cells = (f"{100 * share:.1f} %" for share in np.nanmean(held, axis=0))
            yield f"| {students} | {effect:g} | {' | '.join(cells)} |"


def _answers(random: np.random.Generator, students: int, effect: float) -> tuple[np.ndarray, np.ndarray]:
    """Right or wrong of each student in each part, and the variant of the first that each drew."""
    ability, variant = random.normal(size=(students, 1)), random.integers(VARIANTS, size=students)
    logits = EASY + APART * ability
    logits[:, 0] += effect * _feature(variant)
    return (random.random((students, PARTS)) < 1 / (1 + np.exp(-logits))).astype(float), variant


def _feature(variant: np.ndarray) -> np.ndarray:
    spread = np.arange(VARIANTS) - (VARIANTS - 1) / 2
    return spread[variant] / spread.std()


def _course(
    seed: int, students: int, effect: float, shares: np.ndarray, apart: list[float]
) -> tuple[float, ...]:
    """The share of intervals of difficulty, of discrimination and of the effect that hold the truth; whether the effect was found,
    the power stated, and whether the table of variants found it."""
    right, variant = _answers(np.random.default_rng([seed, students]), students, effect)
    rows = [
        Row(
            f"s{student}",
            "P",
            str(part),
            "right" if right[student, part] else "wrong",
            float(right[student, part]),
            1.0,
        )
        for student in range(students)
        for part in range(PARTS)
    ]
    answers = answers_to_parts(rows)
    found = part_statistics(answers)
    easy = [
        each.difficulty.low <= truth <= each.difficulty.high
        for each, truth in zip(found, shares, strict=True)
    ]
    apart_held = [
        each.discrimination.low <= truth <= each.discrimination.high
        for each, truth in zip(found, apart, strict=True)
        if each.discrimination is not None
    ]
    return (
        float(np.mean(easy)),
        float(np.mean(apart_held)),
        *_effect(answers[0], variant, effect),
        _chi(right, variant),
    )


def _effect(first: AnswersToPart, variant: np.ndarray, effect: float) -> tuple[float, float, float]:
    values = _feature(variant)
    of = {
        (student, "P", "0"): {"feature": float(value)}
        for student, value in zip(first.students, values, strict=True)
    }
    found = feature_effects([first], of)
    if not found:
        return np.nan, 0.0, np.nan
    truth = effect * float(values.std())  # a class draws its own spread
    return (
        float(found[0].effect.low <= truth <= found[0].effect.high),
        float(found[0].p < 0.05),
        found[0].power,
    )


def _chi(right: np.ndarray, variant: np.ndarray) -> float:
    drawn = np.unique(variant)
    counts = np.array(
        [[np.sum((variant == each) & (right[:, 0] == kind)) for kind in (0, 1)] for each in drawn]
    )
    expected = counts.sum(axis=1, keepdims=True) * counts.sum(axis=0) / counts.sum()
    deviation = float(np.sum((counts - expected) ** 2 / expected))
    return float(deviation > float(chi2.ppf(0.95, len(drawn) - 1)))


if __name__ == "__main__":
    main()
