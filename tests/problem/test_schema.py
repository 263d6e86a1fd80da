"""The JSON schema of the front matter says what the reader says, of right files and of wrong ones."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest
import yaml
from click.testing import CliRunner
from jsonschema import Draft202012Validator

from corollary.cli.commands import app
from corollary.problem.bank import chapter_bank, files
from corollary.problem.diagnostic import Malformed
from corollary.problem.reader import read_problem
from corollary.problem.schema import schema

GOOD = """\
code: Q1
title: A cart
difficulty: 2
tags: [motion, two steps]
author: Ada Lovelace
licence: CC-BY-4.0
version: 1.2
given:
  m: {is: mass, value: 1/3, from: 1/3, to: 4/3, step: 1/3, unit: kg}
  v: {is: speed, value: -2.5e1, unit: m/s}
require: m > 0
where:
  - abs(v) > 1 m/s
figure: <svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 4 4"/>
alt: A cart of {{m}}.
"""
BODY = '\nA cart of {{m}}.\n\n## Momentum {#a .value unit="kg*m/s"}\nHow large?\n'
validator = Draft202012Validator(schema())


def takes(front: str) -> bool:
    return validator.is_valid(yaml.safe_load(front))


def complaints(front: str, folder: Path) -> list[str]:
    path = folder / "cart.md"
    path.write_text(f"---\n{front}---{BODY}", encoding="utf-8")
    try:
        read_problem(path)
    except Malformed as error:
        return [complaint.sentence for complaint in error.complaints]
    return []


def test_the_schema_is_one():
    Draft202012Validator.check_schema(schema())
    done = CliRunner().invoke(app, ["schema"])
    assert json.loads(done.stdout) == schema()


@pytest.mark.parametrize("path", files(chapter_bank()), ids=lambda path: path.stem)
def test_every_problem_of_the_chapter_is_taken(path):
    front = path.read_text(encoding="utf-8").split("\n---", 1)[0].removeprefix("---\n")
    assert list(validator.iter_errors(yaml.safe_load(front))) == []


def test_what_can_be_said_is_read(tmp_path):
    assert takes(GOOD)
    assert complaints(GOOD, tmp_path) == []
    read = read_problem(tmp_path / "cart.md").description
    assert (read.difficulty, read.tags) == (2, ("motion", "two steps"))
    assert (read.author, read.licence, read.version) == ("Ada Lovelace", "CC-BY-4.0", "1.2")


ROWS = GOOD.replace(", value: -2.5e1", "") + "rows:\n  - {body: a cart, v: 3}\n  - {body: a ball, v: -1/2}\n"


@pytest.mark.parametrize(
    ("old", "new", "good"),
    [
        ("rows:\n  - ", "rows:\n  - ", True),
        ("rows:\n  -", "rows:\n  carts:\n  -", True),
        ("  - {body: a cart, v: 3}\n", "", False),
        ("{body: a cart, v: 3}", "[a cart, 3]", False),
        ("{body: a cart, v: 3}", "{}", False),
        ("body: a cart", "body: [a cart]", False),
        ("body:", "lambda:", False),
        ("rows:", "row:", False),
    ],
)
def test_rows_are_taken_and_refused_as_the_reader_does(tmp_path, old, new, good):
    assert old in ROWS
    front = ROWS.replace(old, new)
    assert takes(front) == good
    assert (complaints(front, tmp_path) == []) == good


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("code: Q1\n", ""),
        ("code: Q1", "code: Q 1"),
        ("code: Q1", "code: [Q1]"),
        ("title: A cart\n", ""),
        ("title: A cart", "title: ''"),
        ("title:", "titel:"),
        ("difficulty: 2", "difficulty: 6"),
        ("difficulty: 2", "difficulty: 2.5"),
        ("difficulty: 2", "difficulty: easy"),
        ("tags: [motion, two steps]", "tags: {motion: 1}"),
        ("tags: [motion, two steps]", "tags: [[motion]]"),
        ("author: Ada Lovelace", "author: [Ada]"),
        ("is: mass, ", ""),
        ("value: 1/3, ", ""),
        ("value: 1/3", "value: a third"),
        ("value: 1/3", "value: 1/0"),
        ("step: 1/3, ", ""),
        ("unit: kg", "units: kg"),
        ("  m: {", "  2m: {"),
        ("  v: {", "  sin: {"),
        ("  v: {", "  lambda: {"),
        ("m > 0", "positive"),
        ("m > 0", "{m: 1}"),
        ("alt: A cart of {{m}}.\n", ""),
    ],
)
def test_what_the_reader_refuses_the_schema_refuses(tmp_path, old, new):
    assert old in GOOD
    wrong = GOOD.replace(old, new, 1)
    assert complaints(wrong, tmp_path)
    assert not takes(wrong)


def test_both_know_the_same_names(tmp_path):
    """The reader lists what it knows when something is strange: that list is the schema's."""
    (front,) = complaints(GOOD + "strange: 1\n", tmp_path)
    assert set(re.findall(r"\w+", front.partition("known are ")[2])) == schema()["properties"].keys()
    (row,) = complaints(GOOD.replace("{is: mass", "{odd: 1, is: mass"), tmp_path)
    given = schema()["properties"]["given"]["additionalProperties"]["properties"]
    assert set(re.findall(r"\w+", row.partition("known are ")[2])) == given.keys()
