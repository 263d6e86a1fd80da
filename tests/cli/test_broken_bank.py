"""One broken problem is its own complaint: a bank's other problems are listed, verified and practised on all the same."""

from __future__ import annotations

import json
import subprocess
import sys

import pytest

PROGRAM = "import sys; from corollary.cli.main import main; sys.argv[0] = 'corollary'; main()"
PROBLEM = """\
---
code: CODE
title: A cart
given:
  m: {is: mass, value: 0.5, from: 0.1, to: 0.9, step: 0.1, unit: kg}
  v: {is: speed, value: 3, from: 1, to: 5, step: 1, unit: m/s}
require: [m > 0, v > 0]
---
A cart of {{m}} at {{v}}.

## Momentum {#a .value unit="kg*m/s" points=1}
How large?
"""
SOLUTION = """\
from corollary.author import *
from corollary.laws import law, wrong
def derive(m, v):
    p, = unknowns("p")
    BEFORE
    return derivation(step(p, "Def.", law("Momentum", "p = m*v"), answers="a", mistakes=[mistake("Half.", wrong("p = m*v/2"))]))
"""
SOLUTIONS = {
    "syntax": (SOLUTION.replace("return", "retrun"), "syntax.py:6: is not Python"),
    "importing": ("import nothing_there\n" + SOLUTION, "importing.py:1: cannot be loaded"),
    "raising": (SOLUTION.replace("BEFORE", "1/0"), "raising.py:5: derive fails: ZeroDivisionError"),
    "recursive": (SOLUTION.replace("BEFORE", "f = lambda: f(); f()"), "recursive.py:5: derive fails: RecursionError"),
    "exiting": ("import sys; sys.exit(3)\n" + SOLUTION, "exiting.py:1: cannot be loaded: SystemExit"),
    "leaving": (SOLUTION.replace("BEFORE", "__import__('os')._exit(3)"), "leaving.py:5: derive fails: SystemExit: it would end the program (status 3)"),
    "killed": ("import os, signal\nos.kill(os.getpid(), signal.SIGKILL)\n" + SOLUTION, "killed.py:1: ends the process that verifies it"),
    "strange": (SOLUTION.replace("BEFORE", "class Odd(BaseException): pass\n    raise Odd"), "strange.py:6: derive fails: Odd"),
    "not_utf": (SOLUTION.replace("Def.", "Größe").encode("latin-1"), "not_utf.py:6: is not Python"),
    "stranger": (SOLUTION.replace("step(p,", "step('p',"), "stranger.py:6: part a: it cannot be solved"),
    "missing": (None, "missing.py: is missing"),
}  # fmt: skip
STATEMENTS = {
    "yaml": PROBLEM.replace("title: A", "title: [A"),
    "latin": PROBLEM.replace("A cart", "Größe").encode("latin-1"),
    "empty": "",
}


def run(*words):
    return subprocess.run(
        [sys.executable, "-c", PROGRAM, *words], capture_output=True, text=True, timeout=300
    )


@pytest.fixture(scope="module")
def bank(tmp_path_factory):
    folder = tmp_path_factory.mktemp("bank")
    problems, solutions = folder / "problems" / "t", folder / "solutions" / "t"
    problems.mkdir(parents=True)
    solutions.mkdir(parents=True)

    def put(name, statement, solution):
        for path, text in ((problems / f"{name}.md", statement), (solutions / f"{name}.py", solution)):
            if text is not None:
                path.write_bytes(text if isinstance(text, bytes) else text.encode())

    good = SOLUTION.replace("BEFORE", "pass")
    for place, name in enumerate(("first", "last")):
        put(name, PROBLEM.replace("CODE", f"G{place}"), good)
    for place, (name, (solution, _)) in enumerate(SOLUTIONS.items()):
        text = solution.replace("BEFORE", "pass") if isinstance(solution, str) else solution
        put(
            name,
            PROBLEM.replace("CODE", f"B{place}"),
            text and (text.replace(b"BEFORE", b"pass") if isinstance(text, bytes) else text),
        )
    for place, (name, statement) in enumerate(STATEMENTS.items()):
        put(name, statement.replace("CODE", f"S{place}") if isinstance(statement, str) else statement, good)
    (problems / "gone.md").symlink_to(folder / "nowhere")
    return folder


def test_the_others_are_listed(bank):
    listed = run("list", "--bank", str(bank), "--json")
    assert listed.returncode == 1
    assert {each["code"] for each in json.loads(listed.stdout)} == {
        "G0",
        "G1",
        *(f"B{place}" for place in range(len(SOLUTIONS))),
    }
    for name in (*STATEMENTS, "gone"):
        assert f"{name}.md:" in listed.stderr
    assert "Traceback" not in listed.stderr


def test_the_others_are_verified(bank):
    verified = run("verify", "--bank", str(bank), "--variants", "3", "--json")
    assert verified.returncode == 1, verified.stderr
    found = json.loads(verified.stdout)
    by_code = {each["code"]: each for each in found["problems"]}
    assert by_code["G0"]["ok"]
    assert by_code["G1"]["ok"]
    for place, (_, said) in enumerate(SOLUTIONS.values()):
        complaint = by_code[f"B{place}"]["complaints"][0]
        assert complaint.startswith(said)
    assert {each.partition(":")[0] for each in found["malformed"]} == {
        f"{name}.md" for name in (*STATEMENTS, "gone")
    }


@pytest.mark.parametrize("command", ["key", "show"])
def test_one_of_them_is_shown_and_the_broken_one_is_a_sentence(bank, command):
    assert run(command, "G0", "--bank", str(bank)).returncode == 0
    for code in ("B2", "B5") if command == "key" else ():
        broken = run(command, code, "--bank", str(bank))
        assert broken.returncode == 2
        assert broken.stderr.startswith("corollary: ")
        assert ": derive fails: " in broken.stderr
        assert "Traceback" not in broken.stderr
