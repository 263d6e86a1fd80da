"""A small set with every kind of part, and one student's sheet of it."""

from __future__ import annotations

from textwrap import dedent

import pytest

from corollary.notebook.worksheet import Worksheet, worksheet
from corollary.problem.bank import Bank
from corollary.problem.problem_set import ProblemSet, read_set
from corollary.problem.roster import Student
from corollary.problem.variant import at

KICK = """\
    ---
    code: X12.5
    title: Kicking a ball
    source: Exercise 12.5
    given:
      m:  {is: mass of the ball, value: 0.43, from: 0.30, to: 0.60, step: 0.01, unit: kg}
      v:  {is: speed after the kick, value: 20, from: 8, to: 35, step: 0.5, unit: m/s}
      dt: {is: time of contact, value: 0.10, from: 0.02, to: 0.15, step: 0.01, unit: s}
    figure: |
      <svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 40 20"><text x="1" y="9">m = {{m}}</text></svg>
    alt: A ball of mass {{m}} [at rest].
    ---
    A ball of mass {{m}} lies still; your foot touches it for {{dt}} and it leaves at {{v}}.

    ## Momentum {#a .value unit="kg m/s" points=1}
    By how much does it change?

    ## Bounce {#b .vector unit="m/s" components="x y" points=2}
    Its velocity afterwards?

    ## Formula {#c .expression unit="N" points=1}
    The mean force.

    ## Kept {#d .choice points=1}
    What is kept?
    - (a) its mass, {{m}}
    - (b) its momentum

    ## Words {#e .explain points=3}
    Why?

    ## Program {#f .code .plot unit="N" points=4 function="force(t, dt, J)"}
    The force during the kick.

    ## Picture {#g .plot points=2}
    Momentum against time.

    ## Proof {#h .proof points=2}
    Impulse is change of momentum.

    ## Example {#i .example components="m1 v1" points=1}
    A mass and a velocity.
    """

DROP = """\
    ---
    code: E12.3.1s
    title: Ball and floor
    source: Example 12.3.1
    given:
      v0: {is: speed at contact, value: 2.8, from: 1, to: 8, step: 0.1, unit: m/s}
    ---
    A ball meets the floor at {{v0}}.

    ## Angle {#a .value unit="deg" points=1}
    At which angle does it leave?
    """

SET = """\
    ---
    title: Momentum, first week
    due: 2026-12-04T23:59+00:00
    problems:
      - X12.5
      - {code: E12.3.1s, weight: 2}
    ---
    Your numbers are your own.
    """


@pytest.fixture(scope="session")
def problem_set(tmp_path_factory: pytest.TempPathFactory) -> ProblemSet:
    bank = tmp_path_factory.mktemp("bank")
    files = {
        "problems/impulse/kick.md": KICK,
        "problems/impulse/drop.md": DROP,
        "problems/sets/week_1.md": SET,
    }
    for name, text in files.items():
        (bank / name).parent.mkdir(parents=True, exist_ok=True)
        (bank / name).write_text(dedent(text), encoding="utf-8")
    return read_set(Bank(bank), bank / "problems/sets/week_1.md")


@pytest.fixture(scope="session")
def ada(problem_set: ProblemSet) -> Worksheet:
    return worksheet(
        problem_set, Student("ada", "Ada", "Lovelace"), [at(problem, 57) for problem in problem_set.problems]
    )
