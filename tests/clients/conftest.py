"""The chapter's problems as items, what can be typed into them, and what of an item decides marks."""

from __future__ import annotations

import hashlib
import json
from pathlib import Path

import pytest

from corollary.grading.solutions import Solutions
from corollary.problem.bank import chapter_bank, codes, home
from corollary.problem.problem_set import Scheme
from corollary.problem.variant import chapter
from corollary.render.lms_item import ChoiceAsked, LmsItem, NumbersAsked, answer_table, item

RECORDED = Path(__file__).parent / "recorded"


@pytest.fixture(scope="session")
def make_item():
    """An item with the chapter's numbers, by the problem's code or name."""
    solutions = Solutions(chapter_bank())

    def make(code: str) -> LmsItem:
        return item(solutions, chapter(home(None, code)[1]), 1, 1.0, Scheme())

    return make


@pytest.fixture(scope="session")
def chapter_items(make_item) -> list[LmsItem]:
    return [make_item(str(path)) for path in codes(chapter_bank())]


@pytest.fixture(scope="session")
def table():
    """The answer table of an item, made once."""
    made = {}

    def rows(of: LmsItem):
        code = of.exercise.problem.code
        if code not in made:
            made[code] = answer_table(of)
        return made[code]

    return rows


@pytest.fixture(scope="session")
def fingerprint():
    return what_decides


def what_decides(of: LmsItem) -> str:
    """A hash of all that decides marks; words may change."""
    decides = [
        (each.prompt.part.id, each.prompt.out_of, each.components,
         [(mark.share, [[f"{end:.5g}" for end in ends] for ends in mark.ranges()]) for mark in each.marks])
        if isinstance(each, NumbersAsked)
        else (each.prompt.part.id, each.prompt.out_of, [option.share for option in each.options])
        for each in of.parts
        if isinstance(each, NumbersAsked | ChoiceAsked)
    ]  # fmt: skip
    return hashlib.sha256(json.dumps(decides).encode()).hexdigest()[:16]


@pytest.fixture(scope="session")
def recorded():
    """What a client gave when it was last asked, by its name."""
    return lambda client: json.loads((RECORDED / f"{client}.json").read_text(encoding="utf-8"))


@pytest.fixture(scope="session")
def record():
    def write(client: str, found: dict) -> None:
        (RECORDED / f"{client}.json").write_text(json.dumps(found, indent=1) + "\n", encoding="utf-8")

    return write
