"""What a reader gives, held against what is written in the file: formulas as functions, numbers letter by letter."""

from __future__ import annotations

import pytest

from corollary.answers.equality import Equal, compare
from corollary.formula.syntax import author_formula


@pytest.fixture
def same():
    def hold(published: str, expected: str) -> bool:
        if published == expected:
            return True
        return isinstance(compare(author_formula(published), author_formula(expected), {}), Equal)

    return hold
