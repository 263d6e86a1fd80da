"""Statistics of a set: shares and correlations with their intervals, and effects of the numbers drawn."""

from __future__ import annotations

import csv
import io
import json
import math

import numpy as np
import pytest

from corollary.problem.csv_table import table_text
from corollary.records.marks import Row
from corollary.records.report_model import report
from corollary.records.statistics import (
    NoFit,
    answers_to_parts,
    correlation,
    feature_effects,
    logistic_fit,
    set_statistics,
    share,
    statistics_record,
    statistics_rows,
)


def rows(right: np.ndarray) -> list[Row]:
    """One point a part; `right` has a row a student and a column a part."""
    return [
        Row(
            f"s{student}",
            "P",
            "abcdef"[part],
            "right" if one else "mistaken",
            float(one),
            1.0,
            "" if one else "Too =fast",
        )
        for (student, part), one in np.ndenumerate(right)
    ]


def klass(students: int, effect: float) -> tuple[list[Row], dict[tuple[str, str, str], dict[str, float]]]:
    """Six parts; the first is harder by `effect` logits for each standard deviation of a feature."""
    random = np.random.default_rng(7)
    ability, drawn = random.normal(size=(students, 1)), random.normal(size=students)
    logits = ability + np.linspace(-1, 1, 6)
    logits[:, 0] += effect * drawn
    right = random.random((students, 6)) < 1 / (1 + np.exp(-logits))
    features = {
        (f"s{student}", "P", part): {"size": float(drawn[student]), "same": 3.0}
        for student in range(students)
        for part in "abcdef"
    }
    return rows(right), features


def test_a_share_has_wilsons_interval():
    """Newcombe 1998, table I: 81 of 263, 15 of 148, 0 of 20, 1 of 29."""
    published = {
        (81, 263): (0.2553, 0.3662),
        (15, 148): (0.0624, 0.1605),
        (0, 20): (0, 0.1611),
        (1, 29): (0.0061, 0.1718),
    }
    for (count, of), interval in published.items():
        found = share(count, of)
        assert (found.low, found.high) == pytest.approx(interval, abs=5e-5)
    with pytest.raises(ValueError, match="no answers"):
        share(0, 0)


def test_a_correlation_has_an_interval_where_there_is_something_to_tell():
    random = np.random.default_rng(3)
    first = random.normal(size=4000)
    found = correlation(first, 0.6 * first + 0.8 * random.normal(size=4000))
    assert found is not None
    assert found.low < 0.6 < found.high
    fisher = 2 * 1.96 / math.sqrt(4000) * (1 - 0.36)  # of normal pairs
    assert found.high - found.low == pytest.approx(fisher, rel=0.08)
    assert correlation(np.ones(50), first[:50]) is None
    assert correlation(first[:5], first[1:6]) is None


def test_firths_fit_of_one_proportion_is_known_and_is_finite_where_all_are_right():
    """With a column of ones alone the penalised estimate is the logit of (right + 1/2)/(n + 1)."""
    right = np.array([1.0] * 7 + [0.0] * 3)
    fit = logistic_fit(np.ones((10, 1)), right)
    assert fit.coefficients[0] == pytest.approx(math.log(7.5 / 3.5))
    assert logistic_fit(np.ones((10, 1)), np.ones(10)).coefficients[0] == pytest.approx(math.log(10.5 / 0.5))
    with pytest.raises(NoFit):
        logistic_fit(np.ones((10, 2)), right)


def test_what_waits_and_what_earns_nothing_is_not_counted():
    some = [
        Row("a", "P", "a", "right", 1, 1),
        Row("a", "P", "b", "unmarked", 0, 1),
        Row("a", "P", "c", "wrong", 0, 0),
    ]
    (only,) = answers_to_parts(some)
    assert (only.part, only.students, only.right.tolist()) == ("a", ("a",), [1.0])
    assert np.isnan(only.rest).all()


def test_an_unfair_feature_is_found_and_a_fair_one_is_not():
    unfair, features = klass(400, 0.8)
    surest, *others = feature_effects(answers_to_parts(unfair), features)
    assert (surest.part, surest.feature) == ("a", "size")
    assert surest.effect.low < 0.8 < surest.effect.high
    assert surest.adjusted < 0.001
    assert all(each.adjusted > 0.05 for each in others)
    assert {each.feature for each in (surest, *others)} == {"size"}, (
        "what is the same for everybody says nothing"
    )
    fair, features = klass(400, 0.0)
    assert all(each.adjusted > 0.05 for each in feature_effects(answers_to_parts(fair), features))


def test_a_small_class_is_told_what_it_cannot_find():
    few, features = klass(40, 0.0)
    for each in feature_effects(answers_to_parts(few), features):
        assert each.power < 0.6
        assert each.least > 0.7
    too_few, features = klass(15, 0.0)
    assert feature_effects(answers_to_parts(too_few), features) == []


def test_all_of_it_is_serialized_and_a_table():
    marked, features = klass(60, 0.5)
    found = set_statistics(report((), marked), features)
    document = json.loads(json.dumps(statistics_record(found)))
    assert [each["part"] for each in document["parts"]] == list("abcdef")
    assert set(document) == {"parts", "misconceptions", "effects", "unlisted", "rubric"}
    table = list(csv.DictReader(io.StringIO(table_text(statistics_rows(found)))))
    kinds = [each["statistic"] for each in table]
    assert {kind: kinds.count(kind) for kind in kinds} == {
        "difficulty": 6,
        "discrimination": 6,
        "mistaken": 6,
        "effect": 6,
    }
    for each in table:
        assert float(each["low"]) <= float(each["estimate"]) <= float(each["high"])
    held = next(each for each in table if each["statistic"] == "mistaken")
    assert float(held["estimate"]) == pytest.approx(len(held["students"].split()) / 60)
