"""Pins of the packages against the oldest Python that is promised, Debian 12's."""

from __future__ import annotations

import re
from importlib.metadata import PackageNotFoundError, distribution
from pathlib import Path

from packaging.specifiers import SpecifierSet

PINS = Path(__file__).parents[2] / ".ci/constraints.txt"
OLDEST = "3.11.2"


def test_each_pin_that_is_installed_admits_the_oldest_python():
    pins = dict(re.findall(r"^([\w.-]+)==(\S+)", PINS.read_text(encoding="utf-8"), re.MULTILINE))
    looked_at, wrong = 0, list[str]()
    for name, version in pins.items():
        try:
            found = distribution(name)
        except PackageNotFoundError:
            continue  # of a group that this environment has not
        if found.version == version:
            looked_at += 1
            asked = found.metadata.get("Requires-Python", "")
            if OLDEST not in SpecifierSet(asked):
                wrong.append(f"{name}=={version} asks for Python {asked}")
    assert looked_at > 100
    assert not wrong
