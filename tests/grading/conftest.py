"""Keys of the chapter's problems, and of a small bank that asks in every way."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from textwrap import dedent
from typing import Any

import pytest

from corollary.answers.verdict import Verdict
from corollary.derive.solution import Solution
from corollary.grading.from_json import from_json
from corollary.grading.judge import judge
from corollary.grading.key import Key, make_key
from corollary.grading.solutions import Solutions
from corollary.problem.bank import home
from corollary.problem.variant import chosen

PROBLEM = """
    ---
    code: T1
    title: A thrown stone
    given:
      m:     {is: mass of the stone,        value: 500, from: 200, to: 900, step: 50, unit: g}
      v:     {is: its speed,                value: 36,  from: 18,  to: 72,  step: 9,  unit: km/h}
      theta: {is: angle above the ground,   value: 30,  from: 20,  to: 70,  step: 5,  unit: deg}
      g:     {is: acceleration of gravity,  value: 9.81, unit: m/s^2}
    require:
      - m > 0
    ---
    A stone of mass {{m}} is thrown at {{v}}, {{theta}} above the ground; $g$ = {{g}}.

    ## Momentum {#a .vector unit="kg*m/s" components="x y" points=2}
    Its momentum?

    ## Height {#b .value unit="m" points=2}
    How high does it rise?

    ## Kinetic energy {#c .expression unit="J" points=1}
    Its kinetic energy, as a formula?

    ## Sign {#d .choice points=1}
    Where does the force on it point?

    - (a) upwards
    - (b) downwards
    - (c) along its velocity

    ## Proof {#e .proof components="p K" points=2}
    Show that $K = p^2/(2m)$.

    ## Words {#f .explain points=1}
    Why does it come down?

    ## Twins {#h .example unit="m/s" components="A B" points=1}
    Two velocities of equal stones that together have the momentum of this one.

    ## Force {#i .value unit="N" points=1}
    Its weight?
"""
SOLUTION = '''
    """A thrown stone: momentum along two axes, energy upwards."""

    import sympy

    from corollary.author import choice, derivation, example, explain, mistake, proof, step, unknown, unknowns, vector
    from corollary.laws import conservation_of_momentum, law, momentum


    def derive(m, v, theta, g):
        p, w = vector("p_t"), vector("w", "A B")
        h, K, W, size, energy = unknown("h"), unknown("K_0"), unknown("W"), *unknowns("p K")
        flat, up = v * sympy.cos(theta), v * sympy.sin(theta)
        mass = law("Momentum", "p = m*v", p=size, m=m, v=v)
        moving = law("Kinetic energy", "K = m*v^2/2", K=energy, m=m, v=v)
        return derivation(
            step(p, "Momentum is mass times velocity.", momentum(p, m, (flat, up)), answers="a",
                 mistakes=[mistake("The angle is measured from the ground.", momentum(p, m, (up, flat)))]),
            step(h, "Only its upward velocity lifts it.", law("Energy", "m*g*h = p_y^2/(2*m)", m=m, g=g, h=h, p_y=p[1]),
                 answers="b", mistakes=[mistake("You used the whole speed.", law("Energy", "g*h = v^2/2", g=g, h=h, v=v))]),
            step(K, "By its definition.", law("Kinetic energy", "K = m*v^2/2", K=K, m=m, v=v), answers="c",
                 mistakes=[mistake("You forgot the square.", law("Energy", "K = m*v*c/2", K=K, m=m, v=v, c=up))]),
            choice("d", "Gravity points down.", a=False, b=True, c=False, mistakes={"c": "A velocity needs no force."}),
            step(size, "Its length.", mass), step(energy, "As before.", moving),
            proof("e", "Put the momentum into the energy.", mass, moving,
                  target=law("Claim", "K = p^2/(2*m)", K=energy, p=size, m=m), lines=["p = m*v", "K = m*v^2/2", "K = p^2/(2*m)"],
                  mistakes=[mistake("Momentum is not energy.", law("Wrong", "K = p*v", K=energy, p=size, v=v))]),
            explain("f", "Names gravity.", "Says that nothing else pulls.", answer="Gravity pulls it down."),
            example("h", w, "One equation, two unknowns.",
                    conservation_of_momentum(before=[(m, v)], after=[(m, w[0]), (m, w[1])]),
                    apart=[((v, 0), "that is the stone itself")], free=1, scale=v),
            step(W, "By its definition.", law("Weight", "W = m*g", W=W, m=m, g=g), answers="i"),
        )
'''
_PLACES: dict[str, Solutions] = {}


@pytest.fixture(scope="session")
def small_bank(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("bank")
    for place, text in (("problems/all/stone.md", PROBLEM), ("solutions/all/stone.py", SOLUTION)):
        path = folder / place
        path.parent.mkdir(parents=True)
        path.write_text(dedent(text).lstrip(), encoding="utf-8")
    return folder


@pytest.fixture(scope="session")
def solution(small_bank: Path) -> Callable[[str], Solution]:
    """A solved problem by its code; T1 is of the small bank."""

    def solved(code: str) -> Solution:
        place, problem = home(small_bank if code == "T1" else None, code)
        return _PLACES.setdefault(str(place), Solutions(place)).of(problem)

    return solved


@pytest.fixture(scope="session")
def key(solution: Callable[[str], Solution]) -> Callable[..., Key]:
    """The key for the chapter's numbers, some of them replaced (in the givens' own units)."""

    def of(code: str, **given: str) -> Key:
        solved = solution(code)
        return make_key(
            solved, chosen(solved.problem, {name: Fraction(value) for name, value in given.items()})
        )

    return of


@pytest.fixture(scope="session")
def verdicts(key: Callable[..., Key]) -> Callable[..., dict[str, Verdict]]:
    """The verdicts on the parts answered, for the chapter's numbers."""
    keys: dict[str, Key] = {}

    def of(code: str, **answers: Any) -> dict[str, Verdict]:
        if code not in keys:
            keys[code] = key(code)
        judged = judge(keys[code], {part: from_json(answer) for part, answer in answers.items()})
        return {part: judged[part][0][0] for part in answers}

    return of
