"""One broken problem is its own complaint: a bank's other problems are listed, verified and practised on all the same."""

from __future__ import annotations

import json
import re
import signal
from concurrent.futures import ThreadPoolExecutor

import pytest
from tests import forked

from corollary.cli.export_site import exercise_files
from corollary.cli.practise import answered
from corollary.derive import load, simulation, time_limit
from corollary.grading.solutions import Solutions
from corollary.practice.practice import practice
from corollary.problem.bank import open_bank
from corollary.problem.diagnostic import Malformed

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
SCENE = """\
def scene(m, v, answer):
    BEFORE
"""
SOLUTIONS = {
    "syntax": (SOLUTION.replace("return", "retrun"), "syntax.py:6: is not Python"),
    "importing": ("import nothing_there\n" + SOLUTION, "importing.py:1: cannot be loaded"),
    "raising": (SOLUTION.replace("BEFORE", "1/0"), "raising.py:5: derive fails: ZeroDivisionError"),
    "recursive": (SOLUTION.replace("BEFORE", "f = lambda: f(); f()"), "recursive.py:5: derive fails: RecursionError"),
    "exiting": ("import sys; sys.exit(3)\n" + SOLUTION, "exiting.py:1: cannot be loaded: SystemExit"),
    "leaving": (SOLUTION.replace("BEFORE", "__import__('os')._exit(3)"), "leaving.py:5: derive fails: SystemExit: it would end the program (status 3)"),
    "killed": ("import os, signal\nos.kill(os.getpid(), signal.SIGKILL)\n" + SOLUTION, "killed.py:1: ends the verifying process"),
    "strange": (SOLUTION.replace("BEFORE", "class Odd(BaseException): pass\n    raise Odd"), "strange.py:6: derive fails: Odd"),
    "not_utf": (SOLUTION.replace("Def.", "Größe").encode("latin-1"), "not_utf.py:6: is not Python"),
    "stranger": (SOLUTION.replace("step(p,", "step('p',"), "stranger.py:6: part a: it cannot be solved"),
    "keyboard": (SOLUTION.replace("BEFORE", "raise KeyboardInterrupt"), "keyboard.py:5: derive fails: KeyboardInterrupt"),
    "at_once": ("raise KeyboardInterrupt\n" + SOLUTION, "at_once.py:1: cannot be loaded: KeyboardInterrupt"),
    "wordless": (SOLUTION.replace("BEFORE", "class Odd(BaseException):\n        __str__ = None\n    raise Odd"), "wordless.py:7: derive fails: Odd"),
    "scene_interrupted": (SOLUTION + SCENE.replace("BEFORE", "raise KeyboardInterrupt"), "scene_interrupted.py:8: scene fails: KeyboardInterrupt"),
    "scene_leaving": (SOLUTION + SCENE.replace("BEFORE", "raise SystemExit(4)"), "scene_leaving.py:8: scene fails: SystemExit: 4"),
    "missing": (None, "solutions/t/missing.md: is missing"),
}  # fmt: skip
STATEMENTS = {
    "yaml": PROBLEM.replace("title: A", "title: [A"),
    "latin": PROBLEM.replace("A cart", "Größe").encode("latin-1"),
    "empty": "",
    "heading": PROBLEM.replace(".value", ".vector"),
}


def run(*words):
    return forked.run([forked.COMMAND, *words], capture_output=True, text=True, timeout=300)


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
        f"{name}.md" for name in (*STATEMENTS, "gone") if name != "heading"
    }
    heading = by_code[f"S{list(STATEMENTS).index('heading')}"]
    assert heading["complaints"] == [
        'heading.md:11: part a is .vector; name its components: components="x y"'
    ]


SAID = {f"B{place}": said for place, (_, said) in enumerate(SOLUTIONS.values())}
KILLED = f"B{list(SOLUTIONS).index('killed')}"  # a signal ends the process that loads it


def test_the_others_are_practised(bank):
    found = practice(open_bank(bank), left_out={KILLED})
    assert {"G0", "G1"} < {each.code for each in found.problems}
    assert {each.path.name for each in found.broken} == {f"{name}.md" for name in (*STATEMENTS, "gone")}
    for problem in found.problems:
        asked = {"ask": "exercise", "code": problem.code, "turn": 1}
        if problem.code.startswith("G"):
            assert "A cart" in json.loads(answered(found, asked))["html"]
        elif "scene" in SAID[problem.code]:
            assert "A cart" in json.loads(answered(found, asked))["html"]
            assert json.loads(answered(found, asked | {"ask": "motion"})) == {"html": ""}
        else:
            with pytest.raises(ValueError, match=re.escape(SAID[problem.code])):
                answered(found, asked)


def test_the_others_are_on_the_site(bank):
    found = practice(open_bank(bank), left_out={KILLED})
    files, refused = exercise_files(found, 2)
    with_scene = {code for code, said in SAID.items() if "scene" in said}
    assert set(files) == {f"exercises/{code}.js" for code in ("G0", "G1", *with_scene)}
    assert set(refused) == SAID.keys() - with_scene - {KILLED}
    for code, why in refused.items():
        assert why.startswith(SAID[code])


def test_nothing_is_practised_where_nothing_can_be_read(tmp_path):
    (tmp_path / "problems").mkdir()
    (tmp_path / "problems" / "empty.md").write_text("")
    with pytest.raises(Malformed, match=r"empty\.md:1: begins without front matter"):
        practice(open_bank(tmp_path))


@pytest.mark.parametrize("place", ["derive", "scene"])
@pytest.mark.parametrize("in_a_thread", [False, True])
def test_a_loop_without_end_costs_its_own_problem(tmp_path, monkeypatch, place, in_a_thread):
    """The page is served by threads, in which no signal is heard."""
    for module in (load, simulation):
        monkeypatch.setattr(module, "AUTHOR_S", 0.2)
    monkeypatch.setattr(time_limit, "TICK", 0.1)
    loop, fine = ("while True: pass", "pass")[:: 1 if place == "derive" else -1]
    for folder, name, text in (
        ("problems", "endless.md", PROBLEM.replace("CODE", "E1")),
        ("solutions", "endless.py", SOLUTION.replace("BEFORE", loop) + SCENE.replace("BEFORE", fine)),
        ("problems", "good.md", PROBLEM.replace("CODE", "G1")),
        ("solutions", "good.py", SOLUTION.replace("BEFORE", "pass")),
    ):
        (tmp_path / folder).mkdir(exist_ok=True)
        (tmp_path / folder / name).write_text(text)
    found = practice(open_bank(tmp_path))

    def answer(code):
        ask = "motion" if place == "scene" else "exercise"
        try:
            return answered(found, {"ask": ask, "code": code, "turn": 0})
        except ValueError as error:
            return str(error)

    with ThreadPoolExecutor(1) as pool:
        said = pool.submit(answer, "E1").result() if in_a_thread else answer("E1")
    if place == "derive":
        assert re.match(r"endless\.py:5: derive fails: TooLong: .*; correct the loop that does not end", said)
    else:
        assert json.loads(said) == {"html": ""}
        assert found.endless == {"E1"}
    assert "html" in json.loads(answer("G1"))


def test_a_person_interrupts_what_an_author_wrote(tmp_path):
    """The code catches ctrl-C and raises something else; the person is heard all the same."""
    code = "try:\n        os.kill(os.getpid(), signal.SIGINT)\n        for _ in range(10**7): pass\n    except BaseException:\n        1/0"
    for folder, name, text in (
        ("problems", "caught.md", PROBLEM.replace("CODE", "C1")),
        ("solutions", "caught.py", "import os, signal\n" + SOLUTION.replace("BEFORE", code)),
    ):
        (tmp_path / folder).mkdir()
        (tmp_path / folder / name).write_text(text)
    bank = open_bank(tmp_path)
    before = signal.signal(signal.SIGINT, signal.default_int_handler)  # a shell's background job ignores it
    try:
        with pytest.raises(KeyboardInterrupt):
            Solutions(bank).of(bank["C1"])
    finally:
        signal.signal(signal.SIGINT, before)


@pytest.mark.parametrize("command", ["key", "show"])
def test_one_of_them_is_shown_and_the_broken_one_is_a_sentence(bank, command):
    assert run(command, "G0", "--bank", str(bank)).returncode == 0
    for code in ("B2", "B5") if command == "key" else ():
        broken = run(command, code, "--bank", str(bank))
        assert broken.returncode == 2
        assert broken.stderr.startswith("corollary: ")
        assert ": derive fails: " in broken.stderr
        assert "Traceback" not in broken.stderr
