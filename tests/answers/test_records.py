"""What was read of an answer cannot be changed by who holds it."""

from __future__ import annotations

from dataclasses import FrozenInstanceError

import pytest

from corollary.answers.answer import Blank
from corollary.answers.direction import Gain


@pytest.mark.parametrize(("read", "name"), [(Gain("3 J", -1, "lost"), "sign"), (Blank("—"), "as_read")])
def test_what_was_read_stays_as_it_is(read, name):
    before = getattr(read, name)
    with pytest.raises(FrozenInstanceError):
        setattr(read, name, "changed")
    assert getattr(read, name) == before
