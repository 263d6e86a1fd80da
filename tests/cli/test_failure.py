"""What a command answers in one sentence, instead of a traceback."""

from __future__ import annotations

from importlib import import_module

import pytest

from corollary.cli.failure import RAISED, expected


@pytest.mark.parametrize("module", RAISED)
def test_every_exception_is_defined_where_it_is_looked_for(module: str):
    found = import_module(module)
    for name in RAISED[module]:
        raised = getattr(found, name)
        assert issubclass(raised, Exception)
        assert raised.__module__ == module
        assert raised in expected()
