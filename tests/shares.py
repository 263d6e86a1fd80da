"""Long lists of cases, of which `make test` tries the first and `make test-long` the others."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import pytest


def share(cases: Iterable[Any], first: int) -> list[Any]:
    """The cases for `parametrize`; those behind so many have the marker `whole`. A tuple is the values of several arguments."""
    return [
        case
        if place < first
        else pytest.param(*(case if isinstance(case, tuple) else (case,)), marks=pytest.mark.whole)
        for place, case in enumerate(cases)
    ]
