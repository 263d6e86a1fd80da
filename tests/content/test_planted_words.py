"""Faults planted in the words of real problems: each is found, and no problem as it stands has a complaint."""

from __future__ import annotations

from collections import Counter

import pytest
from tests.content.planted_words import FOLDERS, NOT_FOUND, WORDS, PlantedWords, complaints_of

from corollary.problem.reader import read_problem
from corollary.verify.checked import Tally
from corollary.verify.words.check_words import check_words


@pytest.mark.parametrize("planted", [pytest.param(each, id=each.name) for each in WORDS])
def test_each_is_found(tmp_path, planted: PlantedWords):
    found = complaints_of(tmp_path, planted.file, planted.old, planted.new)
    assert any(planted.finds in each for each in found), found


@pytest.mark.parametrize("planted", [pytest.param(each, id=each.name) for each in NOT_FOUND])
def test_the_limit_is_as_the_manual_says(tmp_path, planted: PlantedWords):
    """Other numbers and other words are not told from those that are meant."""
    assert not complaints_of(tmp_path, planted.file, planted.old, planted.new)


def test_there_are_enough_of_each_kind():
    kinds = Counter(each.kind for each in WORDS)
    assert kinds.total() >= 60
    assert min(kinds.values()) >= 5
    assert len({each.name for each in WORDS}) == len(WORDS)


@pytest.mark.parametrize("folder", FOLDERS, ids=lambda folder: folder.parent.name)
def test_no_problem_as_it_stands_has_a_complaint(folder):
    paths = [
        path for path in sorted(folder.glob("*/*.md")) if path.parent.name != "sets" and "." not in path.stem
    ]
    tally = Tally()
    for path in paths:
        check_words(read_problem(path), tally)
    assert len(paths) >= 10
    assert not tally.complaints
