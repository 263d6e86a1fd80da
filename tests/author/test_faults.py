"""What an author gets wrong is said in a sentence, at the line of the word: no KeyError, no AttributeError."""

from __future__ import annotations

import json

import pytest
from tests import forked

from corollary.derive.load import NotDerivable
from corollary.derive.solve import solve
from corollary.problem.bank import Bank, find
from corollary.verify.verify import verify

PROBLEM = """\
---
code: F1.1
title: A stone
given:
  h: {is: height, value: 5, from: 1, to: 9, step: 1, unit: m}
  g: {is: gravity, value: 9.81, unit: m/s^2}
require: [h > 0, g > 0]
---
{{h}} {{g}}

## Speed {#a .value unit="m/s"}
How fast?

## Show it {#b .proof}
Show $v^2 = 2 g h$.

## Which {#c .choice}
- (a) up
- (b) down
"""
SOLUTION = """\
from corollary.author import *
from corollary.laws import law, wrong


def derive(h, g):
    v, t = unknowns("v t")
    return derivation(
        step(v, "Energy.", law("Energy", "v^2 = 2*g*h"), answers="a", where=v >= 0,
             mistakes=[mistake("Half.", wrong("v^2 = g*h"))]),
        proof("b", "Energy.", law("Energy", "v^2/2 = g*h"), target=law("Speed", "v^2 = 2*g*h"), lines=["v^2/2 = g*h"]),
        choice("c", "Down.", a=False, b=True),
        printed("c", "b", "(1)"),
    )
"""


@pytest.fixture
def bank(tmp_path):
    def changed(old="", new=""):
        assert old in SOLUTION
        for name, text in (
            ("problems/stone.md", PROBLEM),
            ("solutions/stone.py", SOLUTION.replace(old, new)),
        ):
            (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
            (tmp_path / name).write_text(text, encoding="utf-8")
        return Bank(tmp_path)

    return changed


@pytest.mark.parametrize(
    ("old", "new", "line", "words"),
    [
        ('"v^2/2 = g*h"), target', '"v^2/2 = g*q", q=t), target', 10, "part b: t in Energy is neither given nor found"),
        ('law("Energy", "v^2 = 2*g*h"), answers', "v**2 - 2*g*h, answers", 8, "is not a law; state one, such as law("),
        ('answers="a", where', 'answers="a", check=v > 0, where', 8, "check is a text for the reader, not v > 0"),
        ('wrong("v^2 = g*h")', 'wrong("v^2 = g*h"), where=True', 9, "the mistake 'Half.': 2 answers"),
        ('wrong("v^2 = g*h")', "", 9, "the mistake 'Half.': it names no law"),
        ('printed("c", "b"', 'printed("c", "d"', 12, "printed: part c has the options a, b; 'd' is none of them"),
    ],
)  # fmt: skip
def test_a_fault_is_a_sentence(bank, old, new, line, words):
    here = bank(old, new)
    with pytest.raises(NotDerivable) as raised:
        solve(here, find(here, "F1.1"))
    assert words in str(raised.value)
    assert raised.value.line == line


def test_a_mistake_chooses_its_root(bank):
    """The mistake of the other sign is a root like any."""
    here = bank('wrong("v^2 = g*h")', 'wrong("v^2 = g*h"), where=v <= 0')
    (find_v,) = solve(here, find(here, "F1.1")).unknowns
    assert str(find_v.mistakes[0].rule.trees[0]).startswith("Negative")


@pytest.mark.parametrize(("printed", "complaints"), [("b", 0), ("(B)", 0), ("a", 1)])
def test_a_printed_choice_is_compared(bank, printed, complaints):
    here = bank('printed("c", "b"', f'printed("c", "{printed}"')
    found = [each for each in verify(here, find(here, "F1.1"), count=3).complaints if "prints (a)" in each]
    assert len(found) == complaints


def test_a_negative_answer_is_no_option():
    for words in (["-56.0 J", "--unit", "J"], ["--unit", "J", "-56.0 J"]):
        run = forked.run([forked.COMMAND, "read", *words], capture_output=True, text=True)
        assert (run.returncode, run.stdout.splitlines()[0]) == (0, "read as -56.0 J"), run.stderr


def test_a_case_names_the_givens_it_left_out(bank, tmp_path):
    here = bank()
    tmp_path.joinpath("cases.json").write_text(
        '[{"given": {"h": 2}, "answers": {"a": 6.26}}]', encoding="utf-8"
    )
    words = ["judge", "F1.1", "--bank", str(here.folder), "--cases", str(tmp_path / "cases.json"), "--json"]
    run = forked.run([forked.COMMAND, *words], capture_output=True, text=True)
    (record,) = json.loads(run.stdout)
    assert record["defaulted"] == ["g"]
    assert record["parts"]["a"]["verdict"] == "right"
