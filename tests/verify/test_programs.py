"""A solution's own program and figure are run and judged: an example that fails, and a judge that lets anything pass, are found."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import pytest

from corollary.derive.solve import solve
from corollary.grading.key import make_key
from corollary.problem.bank import Bank, find
from corollary.problem.variant import chapter
from corollary.sandbox.runner import Runner
from corollary.sandbox.zygote import CannotStart
from corollary.verify.checked import Tally
from corollary.verify.programs import check_programs, unstarted

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
        code("a", "Twice the speed.", inputs=lambda given, draw: [{{"v": draw(1, 2)}}, {{"v": 3.0}}], judge={judge}, example="""{program}"""),
        plot("a", "A line.", judge={look}, example="""{figure}"""),
    )
'''
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
        ):
            (tmp_path / folder / "carts").mkdir(parents=True)
            (tmp_path / folder / "carts" / name).write_text(text, encoding="utf-8")
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


def test_a_machine_that_runs_nothing_is_a_complaint(checked, runner, monkeypatch):
    def refuse(self, job):
        raise CannotStart("no room")

    monkeypatch.setattr(Runner, "execute", refuse)
    assert checked().complaints == ["cart.py: its programs could not be run: no room"]
