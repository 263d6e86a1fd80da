"""What the modules of a room hand to each other can be put in a set, and nobody changes it on the way."""

from __future__ import annotations

import dataclasses
import pkgutil
from importlib import import_module

import pytest

CHANGED: dict[str, set[str]] = {"answers": set(), "formula": {"Line"}, "grading": {"Noise", "Solutions"}}


@pytest.mark.parametrize("room", CHANGED)
def test_records_are_frozen(room: str):
    package = f"corollary.{room}"
    found = {
        each
        for module in pkgutil.walk_packages(import_module(package).__path__, f"{package}.")
        for each in vars(import_module(module.name)).values()
        if isinstance(each, type) and dataclasses.is_dataclass(each) and each.__module__ == module.name
    }
    assert found
    assert {each.__name__ for each in found if not each.__dataclass_params__.frozen} == CHANGED[room]
