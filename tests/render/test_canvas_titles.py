"""Titles of sets that Canvas's import of marks leaves out: said by `generate` and `export`."""

from __future__ import annotations

import pytest

from corollary.records.lms_names import is_left_out


@pytest.mark.parametrize(
    ("title", "left_out"),
    [
        ("Final points", True),
        ("Current Grade", True),
        ("Final week: 20 points", True),
        ("Grade override", True),
        ("Unposted Final Score", True),
        ("Final week", False),
        ("Momentum: points and vectors", False),
        ("Finality and scoreless games", False),
    ],
)
def test_a_title_like_one_of_canvass_own_columns(title: str, left_out: bool) -> None:
    assert is_left_out(title) == left_out
