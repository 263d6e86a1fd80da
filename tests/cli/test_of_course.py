"""A problem of a course is found in the bank that its set was dealt from, from whichever folder, and with no bank named."""

from __future__ import annotations

import json

import pytest
from click.testing import CliRunner

from corollary.cli.commands import app
from corollary.problem.bank import VARIABLE

PROBLEM = """\
---
code: X12.5
title: A sledge of another bank
given:
  m: {is: mass, value: 40, from: 20, to: 60, step: 5, unit: kg}
  v: {is: speed, value: 3, from: 1, to: 5, step: 1, unit: m/s}
require: [m > 0, v > 0]
---
A sledge of {{m}} at {{v}}.

## Momentum {#a .value unit="kg*m/s" points=1}
How large?
"""
SOLUTION = """\
from corollary.author import *
from corollary.laws import law, wrong
def derive(m, v):
    p, = unknowns("p")
    return derivation(step(p, "Def.", law("Momentum", "p = m*v"), answers="a", mistakes=[mistake("Half.", wrong("p = m*v/2"))]))
"""


@pytest.fixture
def course(tmp_path, monkeypatch):
    """A course whose set has a problem with a code of the chapter's own."""
    monkeypatch.delenv(VARIABLE, raising=False)
    bank = tmp_path / "bank"
    for name, text in {
        "problems/t/sledge.md": PROBLEM,
        "solutions/t/sledge.py": SOLUTION,
        "problems/sets/week1.md": "---\ntitle: Week 1\nproblems:\n  - X12.5\n---\n",
        "roster.csv": "id\nada\nben\n",
    }.items():
        place = bank / name
        place.parent.mkdir(parents=True, exist_ok=True)
        place.write_text(text, encoding="utf-8")
    (tmp_path / "elsewhere").mkdir()
    monkeypatch.chdir(bank)
    folder = tmp_path / "course"
    status, _, said = ended(
        "generate", "week1", "--bank", ".", "--roster", "roster.csv", "--course", str(folder), "--yes"
    )
    assert status == 0, said
    monkeypatch.chdir(tmp_path / "elsewhere")
    return folder


def ended(*words: str) -> tuple[int, str, str]:
    done = CliRunner(env={"COLUMNS": "160"}).invoke(app, list(words))
    return done.exit_code, done.stdout, done.stderr


@pytest.mark.parametrize("code", ["X12.5", "x12.5", "sledge"])
def test_key_show_and_judge_find_it(course, code, tmp_path):
    words = (code, "--course", str(course), "--student", "ada")
    status, out, said = ended("key", *words, "--json")
    assert status == 0, said
    key = json.loads(out)
    assert set(key["given"]) == {"m", "v"}
    status, out, said = ended("show", *words, "--json")
    assert status == 0, said
    assert json.loads(out)["title"] == "A sledge of another bank"
    assert json.loads(out)["given"] == key["given"]
    cases = tmp_path / "cases.json"
    cases.write_text(json.dumps([{"given": key["given"], "answers": {"a": key["parts"]["a"]["value"]}}]))
    status, out, said = ended("judge", code, "--course", str(course), "--cases", str(cases), "--json")
    assert status == 0, said
    assert json.loads(out)[0]["parts"]["a"]["verdict"] == "right"


def test_without_a_student_the_numbers_are_the_printed_ones_or_those_set(course):
    status, out, _ = ended("key", "X12.5", "--course", str(course), "--json")
    assert (status, json.loads(out)["given"]) == (0, {"m": 40.0, "v": 3.0})
    status, out, _ = ended("key", "X12.5", "--course", str(course), "--set", "m=20", "--json")
    assert (status, json.loads(out)["given"]) == (0, {"m": 20.0, "v": 3.0})


def test_what_no_set_has_is_the_chapters(course):
    status, out, said = ended("key", "X12.6", "--course", str(course), "--json")
    assert status == 0, said
    assert json.loads(out)["code"] == "X12.6"


def test_a_bank_that_is_named_counts_first(course):
    status, out, said = ended("show", "X12.5", "--course", str(course), "--bank", "chapter", "--json")
    assert status == 0, said
    assert json.loads(out)["title"] != "A sledge of another bank"


def test_a_bank_that_has_moved_is_not_in_the_way(course, tmp_path):
    (tmp_path / "bank").rename(tmp_path / "moved")
    status, out, said = ended("key", "X12.5", "--course", str(course), "--json")
    assert status == 0, said
    assert "w" in json.loads(out)["given"]
