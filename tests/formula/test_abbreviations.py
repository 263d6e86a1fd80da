"""Rows of functions that stand for others."""

from __future__ import annotations

from dataclasses import FrozenInstanceError

import pytest

from corollary.formula.abbreviations import Abbreviation


def test_a_row_that_all_readers_share_stays_as_it_was_made():
    row = Abbreviation(1, lambda arguments: arguments[0])
    with pytest.raises(FrozenInstanceError):
        row.arity = 2
    assert row.arity == 1
