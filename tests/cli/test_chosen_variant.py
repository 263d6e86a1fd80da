"""The numbers that `show` and `key` are about: a student's are the same in both."""

from __future__ import annotations

import json

import pytest
from click.testing import CliRunner

from corollary.cli.commands import app


def ended(*words: str) -> tuple[int, str, str]:
    done = CliRunner(env={"COLUMNS": "160"}).invoke(app, list(words))
    return done.exit_code, done.stdout, done.stderr


def test_the_key_of_a_student_is_that_of_the_sheet_shown():
    status, out, _ = ended("key", "X12.5", "--student", "ada", "--json")
    assert status == 0
    record = json.loads(out)
    assert record["parts"]["a"]["value"] == pytest.approx(record["given"]["m"] * record["given"]["v"])
    _, sheet, _ = ended("show", "X12.5", "--student", "ada")
    assert f"mass {record['given']['m']:g}" in sheet.replace("\u00a0", " ")
    _, other, _ = ended("key", "X12.5", "--student", "ben", "--json")
    assert json.loads(other)["given"] != record["given"]


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (["--student", "ada", "--set", "m=1"], "--set and --student both choose the numbers"),
        (["--course", "x"], "x is not a course of Corollary"),
    ],
)
def test_numbers_chosen_twice_are_refused(words, sentence):
    status, out, err = ended("key", "X12.5", *words)
    assert status == 2
    assert out == ""
    assert sentence in err
