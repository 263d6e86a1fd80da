"""`corollary verify --watch`: complaints as they are found, and no algebra twice for what has not changed."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest
import sympy
from click.testing import CliRunner

from corollary.cli.commands import app
from corollary.cli.local_page import edition
from corollary.cli.verify import verified
from corollary.problem.bank import Bank


@pytest.fixture
def bank(tmp_path) -> Bank:
    done = CliRunner().invoke(app, ["new", "Q1", "ride", "--bank", str(tmp_path / "mine")])
    assert done.exit_code == 0, done.output
    return Bank(tmp_path / "mine")


@pytest.fixture
def problem(bank) -> Path:
    return bank.problems / "exercises" / "ride.md"


def change(path: Path, old: str, new: str) -> None:
    text = path.read_text(encoding="utf-8")
    assert old in text
    path.write_text(text.replace(old, new, 1), encoding="utf-8")


@pytest.fixture
def said(bank, problem, capsys):
    def run() -> list[str]:
        verified(bank, problem, 10, edition(bank, problem))
        return capsys.readouterr().out.splitlines()

    return run


def test_what_is_quick_is_said_first_with_what_still_runs(said):
    lines = [line for line in said() if line.startswith("Q1: ")]
    assert ["still running" in line for line in lines] == [True] * 6 + [False]
    assert lines[0].startswith("Q1: no complaint, ")
    assert lines[0].endswith(
        "so far; still running: laws put back, obligations, variants, scenes, bent laws, programs"
    )
    assert lines[-1].endswith("all hold")


@pytest.mark.parametrize(
    ("file", "old", "new", "first"),
    [
        ("md", "code: Q1", "cod: Q1", "ride.md:2: the front matter has no `code`"),
        (
            "solution",
            "v = d/t",
            "v = d*t",
            "solutions/exercises/ride.md:3: part a: the answer is not in s, it is a rate",
        ),
        (
            "solution",
            "- law: Speed,",
            "- low: Speed,",
            "solutions/exercises/ride.md:7: an item that begins with 'low' has no place here",
        ),
        ("md", "floor at", "flour at", "ride.md:16: "),
    ],
)
def test_a_complaint_comes_before_the_slow_stages(said, bank, problem, file, old, new, first):
    change(problem if file == "md" else bank.solution_beside(problem), old, new)
    lines = said()
    assert lines[0].startswith(first), lines
    assert "all hold" not in lines[-1]


@pytest.fixture
def solved(monkeypatch) -> list[tuple]:
    """What sympy is asked to solve."""
    asked: list[tuple] = []
    solve = sympy.solve

    def counted(*words, **options):
        asked.append(words)
        return solve(*words, **options)

    monkeypatch.setattr(sympy, "solve", counted)
    return asked


def test_what_has_not_changed_is_not_solved_again(said, bank, problem, solved):
    solution = bank.solution_beside(problem)
    change(solution, "v = d/t", "3*v*t = 3*d")  # as no other test of this process has solved
    assert "all hold" in said()[-1]
    first = len(solved)
    assert first
    change(problem, "You ride a bike", "You push a cart")
    change(solution, "Twice the speed takes half the time.", "Half the speed takes twice the time.")
    assert "all hold" in said()[-1]
    assert len(solved) == first, "words are no algebra"
    change(solution, "`t = v/d`", "`5*t*d = 5*v`")
    assert "all hold" in said()[-1]
    assert len(solved) == first + 1, "one mistake, one law"


def test_a_wrong_law_is_not_hidden_by_what_was_solved_before(said, bank, problem):
    assert "all hold" in said()[-1]
    change(
        bank.solution_beside(problem), "u = d/(t + d/w)", "u = 2*d/(t + d/w)"
    )  # the mistake is now the truth
    assert any("cannot be told from the truth" in line for line in said())


def test_the_next_edition_ends_this_one(bank, problem, capsys):
    before = edition(bank, problem)
    change(problem, "You ride a bike", "You push a cart")
    verified(bank, problem, 10, before)
    assert capsys.readouterr().out == "Q1: saved again\n"


@pytest.mark.parametrize("words", [(), ("Q1", "Q2"), ("Q1", "--json"), ("Q1", "--extremes")])
def test_one_problem_for_a_person(bank, words):
    done = CliRunner().invoke(app, ["verify", "--watch", *words, "--bank", str(bank.folder)])
    assert (done.exit_code, done.stdout) == (2, "")
    assert "--watch follows one problem" in done.stderr


@pytest.mark.skipif(os.name == "nt", reason="Windows has no SIGINT for a child alone")
def test_it_follows_what_is_saved_until_stopped(bank, problem):
    command = [str(Path(sys.executable).with_name("corollary")), "verify", "--watch", "Q1"]
    running = subprocess.Popen(
        [*command, "--bank", str(bank.folder), "--variants", "3"],
        stdout=subprocess.PIPE,
        text=True,
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.default_int_handler),
    )  # tests that run in the background of a shell ignore SIGINT, and what they start inherits it
    assert running.stdout is not None
    try:
        until(running.stdout, "all hold")
        change(problem, "code: Q1", "cod: Q1")
        until(running.stdout, "ride.md:2: the front matter has no `code`")
        change(problem, "cod: Q1", "code: Q1")
        until(running.stdout, "all hold")
        running.send_signal(signal.SIGINT)
        assert running.wait() == 0
    finally:
        running.kill()
        running.wait()
        running.stdout.close()


def until(lines, words: str) -> None:
    """Reads on to a line with these words; the process ending first is a failure."""
    for line in lines:
        if words in line:
            return
    raise AssertionError(f"never said: {words}")
