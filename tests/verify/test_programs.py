"""A solution's own program and figure are run and judged: an example that fails, and a judge that lets anything pass, are found."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import pytest

from corollary.derive.load import NotDerivable
from corollary.derive.solve import solve
from corollary.grading.key import make_key
from corollary.problem.bank import Bank, find
from corollary.problem.variant import chapter
from corollary.sandbox.runner import Runner
from corollary.sandbox.zygote import CannotStart
from corollary.verify.checked import Tally
from corollary.verify.program_checks import check_programs, unstarted

PROBLEM = """\
---
code: X1.1
title: A cart
given:
  m: {is: mass, value: 0.5, from: 0.2, to: 0.9, step: 0.1, unit: kg}
---
A cart.

## Momentum {#a .code .plot function="momentum(v)"}
Program it, and draw it.
"""
SOLUTION = '''\
"""A cart."""
from corollary.author import *
from corollary.author import Fault


def right(given, called):
    for each in called:
        if abs(each.returned[0] - each.inputs["v"] * 2) > 1e-9:
            return Fault("No.")


def drawn(given, axes):
    return None if any(line.x for each in axes for line in each.lines) else Fault("There is no line.")


def derive():
    return derivation(
        code("a", "Twice the speed.", **dict(dict(inputs=lambda given, draw: [{{"v": draw(1, 2)}}, {{"v": 3.0}}]), judge={judge}), example="""{program}"""),
        plot("a", "A line.", judge={look}, example="""{figure}"""),
    )
'''
JUDGE = """\
import sys


def divides(given, called):
    print("a judge may print")
    return 1 / 0


def leaves(given, called):
    sys.exit(3)


def turns(given, called):
    while True:
        pass
"""
PROGRAM = "def momentum(v):\n    return 2 * v\n"
FIGURE = "v = np.linspace(0, 1, 9)\nplt.plot(v, {m} * v)"


@pytest.fixture(scope="module")
def runner() -> Iterator[Runner]:
    with unstarted() as one:
        yield one


@pytest.fixture
def checked(tmp_path, runner) -> Callable[..., Tally]:
    def check(
        *, program: str = PROGRAM, figure: str = FIGURE, judge: str = "right", look: str = "drawn"
    ) -> Tally:
        for folder, name, text in (
            ("problems", "cart.md", PROBLEM),
            ("solutions", "cart.py", SOLUTION.format(judge=judge, look=look, program=program, figure=figure)),
            ("solutions", "cart/judge_cart.py", JUDGE),
            ("solutions", "cart/judge_late.py", "import nowhere\n\n\ndef judge(given, called): ...\n"),
            ("solutions", "cart/judge_typo.py", "def judge(given, called):\n    return (\n"),
        ):
            path = tmp_path / folder / "carts" / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
        bank, tally = Bank(tmp_path), Tally()
        problem = find(bank, "X1.1")
        check_programs(bank, make_key(solve(bank, problem), chapter(problem)), tally, runner)
        return tally

    return check


def test_a_good_example_is_right_and_wrong_once_bent(checked):
    tally = checked()
    assert tally.counts == {"programs run": 4}
    assert not tally.complaints


@pytest.mark.parametrize(
    ("change", "said"),
    [
        (
            {"program": "def momentum(v):\n    return 3 * v"},
            "the example's code should be right and is wrong (No.)",
        ),
        (
            {"program": "def momentum(v):\n    return v / 0"},
            "the example's code should be right and is unread (Calling momentum",
        ),
        (
            {"figure": "plt.plot([], [])"},
            "the example's plot should be right and is wrong (There is no line.)",
        ),
        ({"figure": "v = 1"}, "the example's plot should be right and is unread (No figure was drawn.)"),
        (
            {"judge": "lambda given, called: None"},
            "the example with its numbers bent should be wrong and is right",
        ),
        ({"look": "lambda given, axes: None"}, "a figure with nothing in it should be wrong and is right"),
    ],
)
def test_what_is_amiss_is_said_with_file_and_line(checked, change, said):
    first, *_ = checked(**change).complaints
    assert first.startswith("cart.py:18: part a: ")
    assert said in first


@pytest.mark.parametrize(
    ("change", "said"),
    [
        (
            {"judge": "lambda given, called: 1 / 0"},
            "cart.py:18: the judge fails: ZeroDivisionError: division by zero (part a)",
        ),
        (
            {"judge": "lambda given, called: True"},
            "cart.py:18: the judge fails: TypeError: a judge answers None, or a Fault, a Remark or a Doubt, and not True",
        ),
        (
            {"look": "lambda given, axes: given['w']"},
            "cart.py:21: the judge of figures fails: KeyError: 'w' (part a)",
        ),
        (
            {"judge": 'module("cart/judge_cart.py").divides'},
            "judge_cart.py:6: the judge fails: ZeroDivisionError: division by zero (part a)",
        ),
        (
            {"judge": 'module("cart/judge_cart.py").leaves'},
            "judge_cart.py:10: the judge fails: SystemExit: 3 (part a)",
        ),
        (
            {"judge": 'right, inputs=module("cart/judge_cart.py").divides'},
            "judge_cart.py:6: the inputs fail: ZeroDivisionError: division by zero (part a)",
        ),
        (
            {"judge": 'module("cart/judge_late.py").judge'},
            "judge_late.py:1: the judge fails: ModuleNotFoundError: No module named 'nowhere'",
        ),
    ],
)
def test_a_judge_that_fails_is_named_with_file_and_line(checked, change, said):
    complaints = checked(**change).complaints
    assert any(each.startswith(said) for each in complaints), complaints


def test_a_judge_that_does_not_end_is_said(checked, monkeypatch):
    monkeypatch.setattr("corollary.grading.judge.LONGEST", 0.3)
    complaints = checked(judge='module("cart/judge_cart.py").turns').complaints
    assert complaints == ["cart.py:18: the judge fails: it took longer than 0.3 s (part a)"]


@pytest.mark.parametrize(
    ("judge", "said"),
    [
        ('module("cart/judge_tram.py").judge', "cart.py:18: derive fails: FileNotFoundError: there is no file judge_tram.py"),
        ('module("cart/judge_cart.py").divide', "cart.py:18: derive fails: AttributeError: judge_cart.py has no divide (did you mean divides?)"),
        ('module("cart/judge_typo.py").judge', "judge_typo.py:2: is not Python: "),
    ],
)  # fmt: skip
def test_a_judge_that_is_not_there_is_said_before_anything_runs(checked, judge, said):
    with pytest.raises(NotDerivable) as error:
        checked(judge=judge)
    assert str(error.value).startswith(said)


def test_a_machine_that_runs_nothing_is_a_complaint(checked, runner, monkeypatch):
    def refuse(self, job):
        raise CannotStart("no room")

    monkeypatch.setattr(Runner, "execute", refuse)
    assert checked().complaints == ["cart.py: its programs could not be run: no room"]
