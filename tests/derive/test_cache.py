"""What is kept between commands is what would be solved, or it is not used."""

from __future__ import annotations

import json
import os
import stat
import subprocess
import sys
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context
from pathlib import Path

import pytest

from corollary.derive import cache, solve
from corollary.derive.cache import solution_of
from corollary.derive.load import NotDerivable
from corollary.derive.serialize import NotSerializable, from_data, to_data
from corollary.formula.syntax import author_formula
from corollary.problem.bank import Bank, chapter_bank, find
from corollary.problem.reader import read_problem

BODY = """
    return derivation(step(p, "Momentum is mass times velocity.", momentum(p, m, v), answers="a",
                           mistakes=[mistake("Half of it.", momentum(p, m, v/2))]))
"""
TIMES = BODY.replace("momentum(p, m, v)", "momentum(p, m, 2*v)")
EXPLAINED = '## Momentum {#a .value unit="kg*m/s" points=1}\n\n## Why {#b .explain points=1}\n\n## Program {#c .code unit="1" function="f(x)" points=1}\n'
PROGRAMS = """
    return derivation(step(p, "Momentum.", momentum(p, m, v), answers="a"), explain("b", "Says why.", answer="Because."),
                      code("c", "Twice.", inputs=lambda given, draw: [{"x": 1.0}],
                           judge=lambda given, inputs, returned: None, example="def f(x): return 2*x"))
"""


@pytest.fixture
def folder(tmp_path, monkeypatch) -> Path:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    return tmp_path / "cache" / "corollary"


@pytest.fixture
def solvings(monkeypatch) -> list[str]:
    """The problems that were solved, in order."""
    made: list[str] = []
    real = solve.solve

    def counted(bank, problem):
        made.append(problem.code)
        return real(bank, problem)

    monkeypatch.setattr(solve, "solve", counted)
    return made


def problem_of(bank: Bank):
    return read_problem(bank.problems / "carts" / "cart.md")


def test_solved_once_and_then_the_same(make, folder, solvings):
    bank = make(BODY)
    first, second = (solution_of(bank, problem_of(bank)) for _ in range(2))
    assert solvings == ["X1.1"]
    assert first == second == solve.solve(bank, problem_of(bank))
    (place,) = folder.iterdir()
    assert stat.S_IMODE(place.stat().st_mode) == 0o600  # it holds answers
    assert stat.S_IMODE(folder.stat().st_mode) == 0o700


def test_each_change_is_seen(make, folder, solvings, monkeypatch):
    """The solution, the problem, and our own programs; and what is stale is written over."""
    bank = make(BODY)
    solution_of(bank, problem_of(bank))
    doubled = solution_of(make(TIMES), problem_of(bank))
    assert doubled.unknowns[0].in_givens == (author_formula("2*m*v"),)
    front = (bank.problems / "carts" / "cart.md").read_text()
    (bank.problems / "carts" / "cart.md").write_text(front.replace("  - m > 0\n", ""))
    assert solution_of(bank, problem_of(bank)).problem.conditions != doubled.problem.conditions
    monkeypatch.setattr(cache, "_programs", lambda: b"another version")
    solution_of(bank, problem_of(bank))
    assert len(solvings) == 4
    assert len(list(folder.iterdir())) == 1


@pytest.mark.parametrize(
    "harm",
    [
        lambda text: b"", lambda text: text[:-7], lambda text: text[:200] + b"x" + text[201:], lambda text: b"\0" * 4000,
        lambda text: text.replace(b"Product", b"Sum"), lambda text: text[: text.index(b"\n") + 1], lambda text: b"[" * 100_000,
    ],
)  # fmt: skip
def test_what_is_damaged_is_solved_anew(make, folder, solvings, harm):
    bank = make(BODY)
    whole = solution_of(bank, problem_of(bank))
    (place,) = folder.iterdir()
    good = place.read_bytes()
    place.write_bytes(harm(good))
    assert solution_of(bank, problem_of(bank)) == whole
    assert solution_of(bank, problem_of(bank)) == whole
    assert len(solvings) == 2
    assert place.read_bytes() == good


def test_a_forged_noun_is_no_program(make, folder, solvings):
    """Whoever can write there could write formulas; but nothing that is read is ever run."""
    for data in (
        {"system": ["true"]},
        {"Find": []},
        {"Code": ["a"]},
        {"a": 1, "b": 2},
        {"fraction": "1/0"},
        {"table": [[[], {"table": 3}]]},
    ):
        with pytest.raises((ValueError, TypeError, KeyError, ArithmeticError)):
            from_data(data)
    for value in (len, {1: print}, object(), ("a", [test_each_change_is_seen])):
        with pytest.raises(NotSerializable):
            to_data(value)


def test_programs_come_from_the_file(make, folder, solvings):
    bank = make(PROGRAMS, asks=EXPLAINED)
    first, second = (solution_of(bank, problem_of(bank)) for _ in range(2))
    assert solvings == ["X1.1"]
    assert first.unknowns == second.unknowns
    assert [type(entry).__name__ for entry in second.entries] == ["Explain", "Code"]
    assert second.entries[1].inputs({}, None) == [{"x": 1.0}]


def test_where_nothing_can_be_kept_it_is_solved(make, tmp_path, monkeypatch, solvings):
    bank = make(BODY)
    (tmp_path / "file").write_text("no folder")
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "file"))
    assert solution_of(bank, problem_of(bank)) == solution_of(bank, problem_of(bank))
    assert len(solvings) == 2


def test_a_file_of_someone_else_is_not_believed(make, folder, solvings, monkeypatch):
    bank = make(BODY)
    solution_of(bank, problem_of(bank))
    monkeypatch.setattr(os, "getuid", lambda: 12345)
    solution_of(bank, problem_of(bank))
    assert len(solvings) == 2


def test_no_derivation_is_no_less_refused(make, folder):
    bank = make(BODY)
    (bank.folder / "solutions" / "carts" / "cart.py").unlink()
    with pytest.raises(NotDerivable, match="is missing"):
        solution_of(bank, problem_of(bank))
    with pytest.raises(NotDerivable, match="needs an entry"):
        solution_of(make("return derivation(step(p, 'For no part.', momentum(p, m, v)))"), problem_of(bank))
    assert not folder.exists()


def test_many_at_once(make, folder):
    """Several processes that solve and read the same file all find the whole of it, and leave one file and nothing aside."""
    bank = make(BODY)
    with ProcessPoolExecutor(4, mp_context=get_context("fork")) as pool:
        found = list(pool.map(_texts, [bank] * 8))
    assert len(set(found)) == 1
    assert len(list(folder.iterdir())) == 1


def _texts(bank: Bank) -> str:
    return json.dumps(to_data([solution_of(bank, problem_of(bank)).unknowns for _ in range(3)]))


@pytest.mark.parametrize("code", ["X12.2", "X12.13", "X12.11", "E12.3.1"])
def test_the_chapter_comes_back_whole(folder, solvings, code):
    """With choices, an example, a proof, routes, mistakes, refused roots, and what is neglected."""
    bank = chapter_bank()
    problem = find(bank, code)
    assert solution_of(bank, problem) == solution_of(bank, problem) == solve.solve(bank, problem)
    assert solvings == [code, code]


def test_what_is_kept_is_used_without_the_algebra(folder):
    """Half a second of every command."""
    loaded = [
        subprocess.run([sys.executable, "-c", KEY], capture_output=True, text=True, check=True).stdout
        for _ in range(2)
    ]
    assert ["sympy" in each.splitlines()[-1].split() for each in loaded] == [True, False]
    assert loaded[0].splitlines()[:-1] == loaded[1].splitlines()[:-1]


KEY = """
import sys
from corollary.cli.main import main
sys.argv = ["corollary", "key", "X12.11"]
try:
    main()
except SystemExit as end:
    assert not end.code, end.code
print(*sys.modules)
"""
