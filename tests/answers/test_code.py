"""Functions a student writes, previewed in the notebook: missing, none, with other arguments, still empty, or there."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from corollary.answers.questions import question_of
from corollary.answers.registry import answer_type
from corollary.problem.reader import read_problem

PROBLEM = read_problem(Path(__file__).with_name("two_letters.md"))
PART = replace(PROBLEM.part("a"), answer_types=("code",), signature="fall(h, g)")


def empty(h, g): ...


def empty_with_words(h, g):
    """How long it falls."""


def written(h, g):
    return (2 * h / g) ** 0.5


def written_with_words(h, g):
    """How long it falls."""
    return (2 * h / g) ** 0.5


def returning(h, g):
    return 1


def with_more(h, g, steps=100):
    return steps


@pytest.mark.parametrize(
    ("function", "ok", "words"),
    [
        (None, False, "no function yet"),
        (3.0, False, "is of the type float, not a function"),
        (lambda h: h, False, "takes (h), but it will be called with (h, g)"),
        (empty, False, "fall(h, g) is still empty"),
        (empty_with_words, False, "fall(h, g) is still empty"),
        (written, True, "fall(h, g) is there"),
        (written_with_words, True, "fall(h, g) is there"),
        (returning, True, "fall(h, g) is there"),
        (with_more, True, "fall(h, g) is there"),
        (max, True, "fall(h, g) is there"),
    ],
)
def test_what_is_said_of_a_function(function, ok, words):
    found = answer_type("code").preview_function(function, question_of(PROBLEM, PART))
    assert found.ok == ok
    assert words in found.text
