"""What was read of an answer cannot be changed by who holds it."""

from __future__ import annotations

from dataclasses import FrozenInstanceError

import pytest

from corollary.answers.gain import Gain


def test_a_gain_stays_as_it_was_read():
    read = Gain("3 J", -1, "lost")
    with pytest.raises(FrozenInstanceError):
        read.sign = 1
    assert read.sign == -1
