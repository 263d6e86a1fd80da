"""What the modules of this room hand to each other can be put in a set, and nobody changes it on the way."""

from __future__ import annotations

import dataclasses
import pkgutil
from importlib import import_module

import corollary.answers

CHANGED = set()


def test_records_are_frozen():
    found = {
        each
        for module in pkgutil.walk_packages(corollary.answers.__path__, "corollary.answers.")
        for each in vars(import_module(module.name)).values()
        if isinstance(each, type) and dataclasses.is_dataclass(each) and each.__module__ == module.name
    }
    assert found
    assert {each.__name__ for each in found if not each.__dataclass_params__.frozen} == CHANGED
