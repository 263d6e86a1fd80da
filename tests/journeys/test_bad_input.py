"""Bad input at the front door: exit status 2, one sentence that says what and where, nothing half-written, no traceback."""

from __future__ import annotations

import json
import os
import re
import shutil
import sqlite3
import subprocess
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import pytest
from tests import forked

COMMANDS = (
    "list",
    "show",
    "key",
    "judge",
    "read",
    "scene",
    "verify",
    "generate",
    "grade",
    "report",
    "export",
    "demo",
)
PROBLEM = """\
---
code: X1.1
title: A cart
given:
  m: {is: mass, value: 0.5, from: 0.1, to: 0.9, step: 0.1, unit: kg}
  v: {is: speed, value: 3, from: 1, to: 5, step: 1, unit: m/s}
require:
  - m > 0
---
A cart of {{m}} rolls at {{v}}.

## Momentum {#a .value unit="kg*m/s" points=1}
How large is its momentum?
"""
SOLUTION = '''\
"""A cart."""
from corollary.author import *
from corollary.laws import *


def derive(m, v):
    p, q = unknowns("p q")
    return derivation(step(p, "Mass times velocity.", momentum(p, m, v), answers="a"))
'''
FAULTY = {  # file: (problem, solution)
    "malformed": (PROBLEM.replace("value: 0.5", "value: heavy").replace("X1.1", "X2.1"), SOLUTION),
    "tabbed": (PROBLEM.replace("  v:", "\tv:").replace("X1.1", "X2.2"), SOLUTION),
    "holed": (PROBLEM.replace("{{v}}", "{{w}}").replace("X1.1", "X2.3"), SOLUTION),
    "no_python": (PROBLEM.replace("X1.1", "X3.1"), SOLUTION.replace("derive(m, v):", "derive(m, v:")),
    "raising": (PROBLEM.replace("X1.1", "X3.2"), SOLUTION.replace("unknowns(", "1 / 0 + unknowns(")),
    "too_few": (
        PROBLEM.replace("X1.1", "X3.3"),
        SOLUTION.replace("momentum(p, m, v)", "momentum(p, q, v), also=[q]"),
    ),
    "too_many": (
        PROBLEM.replace("X1.1", "X3.4"),
        SOLUTION.replace("momentum(p, m, v)", "momentum(p, m, v), momentum(p, m, 2*v)"),
    ),
    "two_roots": (
        PROBLEM.replace("X1.1", "X3.5"),
        SOLUTION.replace("momentum(p, m, v)", 'law("R", "a^2 = b^2", a=p, b=m*v)'),
    ),
    "partless": (PROBLEM.replace("X1.1", "X3.6"), SOLUTION.replace(', answers="a"', "")),
    "unsolved": (PROBLEM.replace("X1.1", "X3.7"), None),
}


@dataclass(frozen=True, slots=True)
class Said:
    status: int
    out: str
    err: str


Run = Callable[..., Said]


@pytest.fixture(scope="session")
def run(tmp_path_factory) -> Run:
    """The front door in a fresh child for each call; only libraries of others are loaded beforehand, to save the time."""
    place = tmp_path_factory.mktemp("said")

    def call(*argv: object, cwd: Path = place) -> Said:
        done = forked.run([forked.COMMAND, *argv], cwd=cwd)
        return Said(done.returncode, done.stdout, done.stderr)

    return call


@pytest.fixture(scope="session")
def bank(tmp_path_factory) -> Path:
    """A bank with one good problem, a set of it, and one of every fault."""
    folder = tmp_path_factory.mktemp("bank")
    for name, (problem, solution) in {"cart": (PROBLEM, SOLUTION), **FAULTY}.items():
        for below, text, ending in (("problems", problem, "md"), ("solutions", solution, "py")):
            path = folder / below / "carts" / f"{name}.{ending}"
            path.parent.mkdir(parents=True, exist_ok=True)
            if text is not None:
                path.write_text(text, encoding="utf-8")
    sets = folder / "problems" / "sets"
    sets.mkdir()
    for name, code in {
        "week_1": "X1.1",
        "week_2": "X1.1",
        **{f"with_{fault}": fault for fault in FAULTY},
    }.items():
        (sets / f"{name}.md").write_text(
            f"---\ntitle: A week\nproblems:\n  - {code}\n---\n", encoding="utf-8"
        )
    return folder


@pytest.fixture
def roster(tmp_path) -> Path:
    path = tmp_path / "roster.csv"
    path.write_text("id\nada\n", encoding="utf-8")
    return path


def refused(said: Said, *words: str) -> None:
    """Status 2, nothing on standard output, and one line that holds the words."""
    assert said.status == 2, said
    assert said.out == ""
    assert re.fullmatch(r"corollary: [^\n]+\n", said.err), said.err
    assert "Traceback" not in said.err
    assert "should not have happened" not in said.err
    for word in words:
        assert word in said.err


def picture(folder: Path) -> dict[str, bytes | None]:
    """Everything below a folder, byte for byte."""
    return {
        str(path.relative_to(folder)): path.read_bytes() if path.is_file() else None
        for path in folder.rglob("*")
    }


FAULTS = [
    ("malformed", "malformed.md:5: `value: heavy` of m is not a number; write it as"),
    ("tabbed", "tabbed.md:6: front matter is not YAML"),
    ("holed", "holed.md:10: {{w}} is not among the givens (m, v)"),
    ("no_python", "no_python.py:6: is not Python"),
    ("raising", "raising.py:7: derive fails: ZeroDivisionError"),
    ("too_few", "too_few.py:8: part a: 1 law for 2 unknowns"),
    ("too_many", "too_many.py:8: part a: 2 laws for 1 unknown: no p satisfies them all"),
    ("two_roots", "say which, with where or reject"),
    ("partless", "partless.py:6: answers no part a; each part of partless.md needs an entry"),
    ("unsolved", "unsolved.md: is missing; unsolved.md needs a solution there"),
]


@pytest.mark.parametrize(("name", "words"), FAULTS)
def test_a_fault_of_the_author_is_named_with_its_line(run, bank, name, words):
    refused(run("key", name, "--bank", bank, "--json"), words)


@pytest.mark.parametrize(("name", "words"), [FAULTS[0], FAULTS[3], FAULTS[5]])
def test_a_set_with_such_a_problem_is_not_begun(run, bank, roster, tmp_path, name, words):
    before = picture(tmp_path)
    refused(
        run(
            "generate",
            f"with_{name}",
            "--roster",
            roster,
            "--course",
            tmp_path / "course",
            "--bank",
            bank,
            "--json",
        ),
        words,
    )
    assert picture(tmp_path) == before


def test_verify_says_all_of_it_and_goes_on(run, bank):
    said = run("verify", "--bank", bank, "--variants", "3", "--json")
    document = json.loads(said.out)
    assert said.status == 1
    assert document["ok"] is False
    assert len(document["malformed"]) == 3
    assert {problem["code"]: problem["ok"] for problem in document["problems"]} == {
        "X1.1": True, **{f"X3.{number}": False for number in range(1, 8)}
    }  # fmt: skip
    assert said.err == ""


@pytest.mark.parametrize(
    ("argv", "words"),
    [
        (["key", "X9.9"], ["no problem is called X9.9", "corollary list"]),
        (["show", "nothing.md"], ["there is no file nothing.md"]),
        (["verify", "X9.9", "--json"], ["no problem is called X9.9"]),
        (["key", "X1.1", "--set", "M=1", "--json"], ["M is not among the givens of X1.1", "m [kg]"]),
        (["key", "X1.1", "--set", "m=0", "--json"], ["X1.1 needs m > 0, but m = 0"]),
        (["key", "X1.1", "--set", "m=-2 kg"], ["needs m > 0"]),
        (["key", "X1.1", "--set", "m"], ["write it as name=value"]),
        (["key", "X1.1", "--set", "m=heavy"], ["m=heavy"]),
        (["key", "X1.1", "--set", "m=3 s"], ["m=3 s"]),
        (["key", "X1.1", "--set", "m=nan"], ["m=nan"]),
        (["key", "X1.1", "--set", "m=1e--5"], ["m=1e--5"]),
        (["show", "X1.1", "--variant", "45"], ["variants 0 to 44; 45 is not among them"]),
        (["show", "X1.1", "--variant", "1", "--student", "ada"], ["give one of them"]),
        (["show", "X1.1", "--format", "docx"], ["--format docx is not known; choose one of"]),
        (["show", "X1.1", "-o", "nowhere/cart.txt"], ["No such file or directory", "nowhere/cart.txt"]),
        (["show", "X1.1", "--student", "ada", "--course", "nowhere"], ["is not a course of Corollary"]),
        (
            ["judge", "X1.1", "--cases", "nowhere.json", "--json"],
            ["nowhere.json cannot be read: No such file"],
        ),
        (["judge", "X1.1", "--cases", ".", "--json"], ["cannot be read: Is a directory"]),
        (["judge", "X1.1", "--cases", "words.json", "--json"], ["words.json is not JSON"]),
        (["judge", "X1.1", "--cases", "nested.json", "--json"], ["nested.json is not JSON"]),
        (["judge", "X1.1", "--cases", "latin.json", "--json"], ["latin.json is not JSON"]),
        (["judge", "X1.1", "--cases", "object.json", "--json"], ["object.json must hold a JSON list"]),
        (["key", "X1.1", "--cases", "object.json", "--json"], ["object.json must hold a JSON list"]),
        (["read", "--cases", "object.json", "--json"], ["object.json must hold a JSON list"]),
        (["read", "--json"], ["give an answer to read, or --cases FILE"]),
        (["scene", "pool", "--json"], ["There is no scene 'pool'; choose one of absorbed_drop"]),
        (["scene", "cradle", "--set", "M=1", "--json"], ["'M' is not among its settings"]),
        (["scene", "cradle", "--set", "m=-1", "--json"], ["must be more than 0"]),
        (["scene", "cradle", "--set", "m=heavy", "--json"], ["write it as name=number"]),
        (["scene", "cradle", "--set", "q=1_5", "--json"], ["q=1_5", "write it as name=number"]),
        (["scene", "cradle", "--set", "q=\uff11", "--json"], ["write it as name=number"]),
        (["scene", "cradle", "--tolerance", "nan", "--json"], ["cannot be held"]),
        (
            ["grade", "week_1", "--course", "nowhere", "--json"],
            ["is not a course of Corollary", "corollary generate"],
        ),
        (["report", "week_1", "--course", "nowhere", "--json"], ["is not a course of Corollary"]),
        (["grade", "week_1", "--course", "words.json", "--json"], ["words.json"]),
        (["demo", "."], ["is not empty; name a fresh folder"]),
    ],
    ids=" ".join,
)
def test_a_request_that_is_wrong(run, bank, tmp_path, argv, words):
    for name, content in {
        "words.json": b"m = 1",
        "nested.json": b"[" * 100_000,
        "latin.json": b'["\xe9"]',
        "object.json": b'{"m": 1}',
    }.items():
        (tmp_path / name).write_bytes(content)
    before = picture(tmp_path)
    refused(
        run(*argv, *(["--bank", bank] if argv[0] not in {"read", "scene", "demo"} else []), cwd=tmp_path),
        *words,
    )
    assert picture(tmp_path) == before


@pytest.mark.parametrize(
    "argv",
    [["list"], ["key", "X1.1"], ["verify"], ["generate", "week_1", "--roster", "r", "--course", "c"]],
    ids=" ".join,
)
def test_a_bank_that_is_none(run, tmp_path, argv):
    refused(
        run(*argv, "--bank", tmp_path, "--json", cwd=tmp_path),
        f"{tmp_path} is not a bank: it has no folder problems/",
    )


def test_one_bad_case_does_not_spoil_the_others(run, bank, tmp_path):
    cases = [
        {"m": 2},
        {"m": 0},
        {"M": 1},
        {"m": "heavy"},
        {"m": [1]},
        {"m": None},
        7,
        {"m": 1e150},
        {"m": True},
    ]
    (tmp_path / "cases.json").write_text(json.dumps(cases), encoding="utf-8")
    said = run("key", "X1.1", "--bank", bank, "--cases", tmp_path / "cases.json", "--json")
    assert said.status == 0
    answers = json.loads(said.out)
    assert ["error" in answer for answer in answers] == [
        False,
        True,
        True,
        True,
        True,
        True,
        True,
        False,
        True,
    ]
    assert all("\n" not in answer["error"] for answer in answers if "error" in answer)
    assert answers[0]["parts"]["a"]["value"] == 6.0
    assert answers[7]["parts"]["a"]["value"] == 3e150


def test_one_bad_answer_does_not_spoil_the_others(run, bank, tmp_path):
    answers = ["1.5 kg m/s", "", None, "one", [1, 2], {"a": 1}, True, 1.5, "1.5 kg", "9" * 5000, [[[]]]]
    cases = [{"answers": {"a": each}} for each in answers] + [
        {"answers": {"z": 1}},
        {"answers": 3},
        {"given": {"m": 0}, "answers": {}},
        [],
    ]
    (tmp_path / "cases.json").write_text(json.dumps(cases), encoding="utf-8")
    said = run("judge", "X1.1", "--bank", bank, "--cases", tmp_path / "cases.json", "--json")
    assert said.status == 0, said.err
    found = json.loads(said.out)
    verdicts = [each["parts"]["a"]["verdict"] for each in found[: len(answers)]]
    assert [verdicts[0], verdicts[7]] == ["right", "right"]
    assert not {verdict for place, verdict in enumerate(verdicts) if place not in {0, 7}} & {
        "right",
        "follows",
        "unmarked",
    }
    assert all("error" in each for each in found[len(answers) :])


@pytest.mark.parametrize(
    ("content", "words"),
    [
        ("first_name\nAda\n", "roster.csv:1: has no column `id`; its columns are first_name"),
        ("id\nada\nbob\nada\n", "roster.csv:4: id ada stands on line 2 already"),
        ("id\n../ada\n", "roster.csv:2: id '../ada' cannot name a folder"),
        ("", "roster.csv:1: lists no students"),
        (None, "roster.csv:1: cannot be read: No such file"),
    ],
)
def test_a_roster_that_will_not_do(run, bank, roster, tmp_path, content, words):
    roster.unlink()
    if content is not None:
        roster.write_text(content, encoding="utf-8")
    before = picture(tmp_path)
    refused(
        run(
            "generate",
            "week_1",
            "--roster",
            roster,
            "--course",
            tmp_path / "course",
            "--bank",
            bank,
            "--json",
        ),
        words,
    )
    assert picture(tmp_path) == before


def test_a_set_that_is_not_there(run, bank, roster, tmp_path):
    before = picture(tmp_path)
    said = run(
        "generate", "week_9", "--roster", roster, "--course", tmp_path / "course", "--bank", bank, "--json"
    )
    refused(said, "there is no problem set week_9 (did you mean", f"the bank {bank} has: week_1")
    assert picture(tmp_path) == before


def test_a_course_where_a_file_stands(run, bank, roster, tmp_path):
    (tmp_path / "course").write_text("mine", encoding="utf-8")
    refused(
        run("generate", "week_1", "--roster", roster, "--course", tmp_path / "course", "--bank", bank),
        "is a file; name a folder",
    )
    assert (tmp_path / "course").read_text() == "mine"


def test_a_course_of_somebody_else(run, bank, roster, tmp_path):
    course = tmp_path / "course"
    course.mkdir()
    (course / "nbgrader_config.py").write_text("c = get_config()\n", encoding="utf-8")
    before = picture(course)
    refused(
        run("generate", "week_1", "--roster", roster, "--course", course, "--bank", bank, "--json"),
        "was not written by corollary",
    )
    assert picture(course) == before


@pytest.fixture(scope="module")
def course(run, bank, tmp_path_factory) -> Path:
    """A course with one set generated and one sheet handed in."""
    place = tmp_path_factory.mktemp("term")
    (place / "roster.csv").write_text("id\nada\n", encoding="utf-8")
    said = run(
        "generate",
        "week_1",
        "--roster",
        place / "roster.csv",
        "--course",
        place / "course",
        "--bank",
        bank,
        "--json",
    )
    assert said.status == 0, said
    handed_in = place / "course" / "submitted" / "ada" / "week_1"
    handed_in.mkdir(parents=True)
    shutil.copy(json.loads(said.out)["students"]["ada"]["sheet"], handed_in / "week_1.ipynb")
    return place / "course"


def test_a_set_never_generated(run, bank, course):
    before = picture(course)
    refused(
        run("grade", "week_2", "--course", course, "--bank", bank, "--json"),
        "week_2 was never generated in",
        "corollary generate week_2",
    )
    refused(
        run("report", "week_2", "--course", course, "--bank", bank, "--json"),
        "no submission of week_2 is graded",
        "corollary grade week_2",
    )
    assert picture(course) == before


def test_nothing_to_report_yet(run, bank, course):
    refused(
        run("report", "week_1", "--course", course, "--bank", bank),
        "no submission of week_1 is graded",
        "corollary grade week_1",
    )


def test_a_gradebook_that_is_locked(run, bank, course):
    """Nothing is marked, nothing changes; when the lock is gone the same command does it."""
    before = picture(course)
    lock = sqlite3.connect(course / "gradebook.db")
    try:
        lock.execute(
            "BEGIN EXCLUSIVE"
        )  # and no look into the file from here until it is over: that would lift the lock
        said = run("grade", "week_1", "--course", course, "--bank", bank, "--json")
        refused(said, "gradebook.db is locked by another program; close", "and grade again")
        after = picture(course)
        assert {
            name for name in after if "graded" in name or "feedback" in name or "reports" in name
        } <= before.keys()
        assert all(after[name] == content for name, content in before.items())
    finally:
        lock.close()
    said = run("grade", "week_1", "--course", course, "--bank", bank, "--json")
    assert said.status == 0, said
    assert json.loads(said.out)["graded"] == 1


def test_a_damaged_key_of_the_course(run, bank, course, tmp_path):
    copy = tmp_path / "copy"
    shutil.copytree(course, copy)
    (copy / ".corollary" / "key").write_bytes(b"short")
    refused(
        run("grade", "week_1", "--course", copy, "--bank", bank, "--json"),
        ".corollary/key is damaged: 5 bytes, not 32",
    )


@pytest.mark.parametrize("command", COMMANDS)
def test_help(run, command):
    said = run(command, "--help")
    assert (said.status, said.err) == (0, "")
    assert said.out.startswith(f"Usage: corollary {command}")


@pytest.mark.parametrize(
    "line",
    [
        "key",
        "grade week_1",
        "nonsense",
        "verify --variants 0",
        "verify --variants many",
        "key X1.1 --unknown",
    ],
)
def test_a_command_line_that_is_wrong(run, line):
    said = run(*line.split())
    assert said.status == 2
    assert said.out == ""
    assert said.err.startswith("corollary: ")
    assert said.err.count("\n") == 1
    assert "Traceback" not in said.err


@pytest.mark.parametrize(
    ("argv", "words"),
    [
        (["key", "X9.9", "--json"], "no problem is called X9.9"),
        (["list", "--bank", "nowhere"], "nowhere is not a bank"),
    ],
)
def test_through_the_installed_command(argv, words, tmp_path):
    """The same without anything loaded beforehand."""
    plain = {name: value for name, value in os.environ.items() if not name.startswith("COROLLARY")}
    done = subprocess.run(
        [forked.COMMAND, *argv],
        capture_output=True,
        text=True,
        cwd=tmp_path,
        timeout=60,
        env=plain,
        check=False,
    )
    refused(Said(done.returncode, done.stdout, done.stderr), words)
