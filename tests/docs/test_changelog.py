"""The changelog's shape: released versions, by area, one line a change."""

from __future__ import annotations

import re
from datetime import date
from itertools import pairwise
from pathlib import Path

import pytest

LINES = (Path(__file__).parents[2] / "docs/changelog.md").read_text(encoding="utf-8").splitlines()
RELEASE = re.compile(r"## \[(?P<version>\d+\.\d+\.\d+)\] - (?P<date>\d{4}-\d{2}-\d{2})")
MOST_WORDS = 35  # in one line
MOST_LINES = 130  # in one release: more is a history, and no changelog


def releases() -> list[list[str]]:
    """The lines of each release, its heading first."""
    at = [number for number, line in enumerate(LINES) if line.startswith("## ")]
    return [LINES[start:end] for start, end in pairwise([*at, len(LINES)])]


def test_releases_are_dated_and_the_newest_comes_first():
    headings = [lines[0] for lines in releases()]
    if headings[0] == "## [Unreleased]":
        headings = headings[1:]
    found = [RELEASE.fullmatch(each) for each in headings]
    assert found
    assert None not in found, headings
    versions = [tuple(map(int, each["version"].split("."))) for each in found if each]
    assert versions == sorted(set(versions), reverse=True)
    dates = [date.fromisoformat(each["date"]) for each in found if each]
    assert dates == sorted(dates, reverse=True)


@pytest.mark.parametrize("lines", releases(), ids=lambda lines: lines[0])
def test_a_release_is_a_page_of_areas_with_a_line_for_each_change(lines: list[str]):
    assert len(lines) <= MOST_LINES
    area, entries = "", dict[str, list[str]]()
    for line in lines[1:]:
        if line.startswith("### "):
            area = line
            assert area not in entries, f"{area} stands twice"
            entries[area] = []
        elif line.startswith("- "):
            assert area, f"in no area: {line}"
            entries[area].append(line)
        else:
            assert not line.startswith((" ", "\t")), f"a change takes one line: {line}"
    assert all(entries.values()), "an area without a change"
    long = [each for several in entries.values() for each in several if len(each.split()) > MOST_WORDS]
    assert not long
    every = [each for several in entries.values() for each in several]
    assert len(every) == len(set(every))
