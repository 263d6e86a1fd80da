"""Faults planted in small problems that hold: each changes one line, and names the check that must find it."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

from corollary.problem.bank import Bank, find
from corollary.problem.diagnostic import Malformed
from corollary.verify.checked import Checked
from corollary.verify.verify import verify


@dataclass(frozen=True)
class Base:
    """A problem and its solution that verify as they stand."""

    problem: str
    solution: str


@dataclass(frozen=True)
class Planted:
    """`old` becomes `new`, once, in the problem or in the solution; then `check` finds it: the words of a complaint, or the kind
    of an obligation that is not proven for the whole grid (`redrawn`: that says for which numbers it is drawn again)."""

    name: str
    base: str
    old: str
    new: str
    check: str


KICK = Base(
    """\
---
code: X1.1
title: A kick
given:
  m: {is: mass, value: 0.5, from: 0.2, to: 0.9, step: 0.1, unit: kg}
  v: {is: speed before, value: 4, from: 2, to: 6, step: 0.5, unit: m/s}
  w: {is: speed after, value: 3, from: 1, to: 5, step: 0.5, unit: m/s}
  dt: {is: time, value: 0.1, from: 0.05, to: 0.2, step: 0.01, unit: s}
where:
  - abs(v - w) >= 0.5 m/s
---
A ball of mass {{m}} comes with {{v}} and is kicked back with {{w}}, within {{dt}}.

## Momentum {#a .value unit="kg*m/s"}
How large was it?

## Impulse {#b .value unit="N*s"}
How large is the impulse?

## Force {#c .value unit="N"}
How large is the mean force?

## Energy {#d .value unit="J"}
How much kinetic energy is added?
""",
    """\
from corollary.author import *
from corollary.laws import *

def derive(m, v, w, dt):
    p, J, F, E = unknowns("p J F E")
    return derivation(
        step(p, "Mass times velocity.", law("Momentum", "p = m*v"), answers="a",
             mistakes=[mistake("Half of it.", wrong("p = m*v/2"))]),
        step(J, "The ball turns round.", law("Impulse", "J = m*v + m*w"), answers="b",
             mistakes=[mistake("It turns round: both count.", wrong("J = m*v - m*w"))]),
        step(F, "Impulse over time.", law("Mean force", "F = J/dt"), answers="c",
             mistakes=[mistake("Times.", wrong("F = 2*J/dt"))]),
        step(E, "After less before.", law("Kinetic energy", "E = m*w^2/2 - m*v^2/2"), answers="d",
             mistakes=[mistake("Half of the change of speed.", wrong("E = m*(w - v)^2/2"))]),
        confirm("Work over the mean speed.", law("Work", "E = J*(w - v)/2")),
        limit(F, dt, oo, 0),
        printed("a", "2.0 kg m/s", "(1)"),
        printed("b", "3.5 N s", "(2)"),
        printed("c", "35 N", "(3)"),
    )
""",
)
COLLISION = Base(
    """\
---
code: X1.1
title: A collision
given:
  M: {is: mass of A, value: 0.5, from: 0.2, to: 0.9, step: 0.1, unit: kg}
  m: {is: mass of B, value: 0.3, from: 0.1, to: 0.8, step: 0.1, unit: kg}
  v: {is: speed of A, value: 4, from: 2, to: 6, step: 0.5, unit: m/s}
where:
  - M > m
---
A, of mass {{M}}, meets B, of mass {{m}}, with {{v}}; B is at rest, and the collision elastic.

## Velocity of B {#a .value unit="m/s"}
How fast is B afterwards?

## Velocity of A {#b .value unit="m/s"}
How fast is A afterwards, which is slower than B?

## Energy {#c .value unit="J"}
How much kinetic energy has B?
""",
    """\
from corollary.author import *
from corollary.laws import *

def derive(M, m, v):
    u_B, u_A, E = unknowns("u_B u_A E")
    momentum_kept = conservation_of_momentum(before=[(M, v), (m, 0)], after=[(M, u_A), (m, u_B)])
    energy = law("Energy", "M*v^2/2 = M*u_A^2/2 + m*u_B^2/2")
    return derivation(
        step(u_B, "Both are conserved.", momentum_kept, energy, also=[u_A], answers="a",
             where=u_B > 0),
        step(u_A, "By the relative velocity.", law("Elastic", "u_B - u_A = v"), answers="b"),
        step(E, "That of B.", law("Kinetic energy", "E = m*u_B^2/2"), answers="c",
             mistakes=[mistake("Without the half.", wrong("E = m*u_B^2"))]),
        confirm("Momentum.", law("Momentum", "M*v = M*u_A + m*u_B")),
        at(M=m, u_B=v),
        printed("a", "5.0 m/s", "(1)"),
        printed("b", "1.0 m/s", "(2)"),
        printed("c", "3.75 J", "(3)"),
    )
""",
)
FALL = Base(
    """\
---
code: X1.1
title: A throw
given:
  h: {is: height, value: 2, from: 1, to: 3, step: 0.1, unit: m}
  v: {is: speed, value: 16, from: 12, to: 20, step: 0.5, unit: m/s}
  theta: {is: angle, value: 50, from: 20, to: 70, step: 1, unit: deg}
  g: {is: gravity, value: 9.8, unit: m/s^2}
where:
  - v*v*sin(theta)*sin(theta) > 2*g*h
---
A ball is thrown with {{v}} at {{theta}}, with $g = {{g}}$, and passes a wall of height {{h}}.

## Speed {#a .value unit="m/s"}
How fast does it rise there?

## Range {#b .value unit="m"}
How far does it come on level ground?
""",
    """\
from corollary.author import *
from corollary.laws import *

def derive(h, v, theta, g):
    u, s = unknowns("u s")
    return derivation(
        step(u, "Energy, upwards.", law("Energy", "u^2 = v^2*sin(theta)^2 - 2*g*h"), where=u >= 0, answers="a",
             mistakes=[mistake("All of the speed.", wrong("u^2 = v^2 - 2*g*h"))]),
        step(s, "Time up and down, times the speed along.", law("Range", "s = v^2*sin(2*theta)/g"), answers="b",
             mistakes=[mistake("Only up.", wrong("s = v^2*sin(2*theta)/(2*g)"))]),
        confirm("Twice the sine times the cosine.", law("Range", "s = 2*v*sin(theta)*v*cos(theta)/g")),
        limit(s, theta, 0, 0),
        printed("a", "10.54 m/s", "(1)"),
        printed("b", "25.73 m", "(2)"),
    )
""",
)
BASES = {"kick": KICK, "collision": COLLISION, "fall": FALL}

MEETING = Base(
    """\
---
code: X1.1
title: Carts
given:
  M: {is: mass of A, value: 0.5, from: 0.2, to: 0.9, step: 0.1, unit: kg}
  m: {is: mass of B, value: 0.3, from: 0.1, to: 0.8, step: 0.1, unit: kg}
  v: {is: speed of A, value: 4, from: 2, to: 6, step: 0.1, unit: m/s}
  w: {is: speed of B afterwards, value: 3, from: 1, to: 4, step: 0.1, unit: m/s}
where:
  - w*(m + M) <= 2*M*v
  - w*(m + M) > M*v
---
A, of mass {{M}}, meets B, of mass {{m}}, with {{v}}; B, which was at rest, goes on with {{w}}.

## Velocity of A {#a .value unit="m/s"}
What is the velocity of A afterwards?

## Restitution {#b .value unit="1"}
Which share of the relative speed is left?
""",
    """\
from corollary.author import *
from corollary.laws import *

def derive(M, m, v, w):
    u, r = unknowns("u r")
    return derivation(
        step(u, "Momentum.", conservation_of_momentum(before=[(M, v), (m, 0)], after=[(M, u), (m, w)]),
             answers="a", scale=v),
        step(r, "By its definition.", law("Restitution", "r = (w - u)/v"), answers="b", scale=1),
        at(m=M, w=v, u=0),
        printed("a", "2.2 m/s", "(1)"),
        printed("b", "0.20", "(2)"),
    )
""",
)
SLOPE = Base(
    """\
---
code: X1.1
title: A block on a slope
given:
  mu: {is: friction, value: 0.3, from: 0.2, to: 0.8, step: 0.01, unit: 1}
  theta: {is: angle, value: 30, from: 5, to: 60, step: 1, unit: deg}
  L: {is: length, value: 2, from: 1, to: 3, step: 0.1, unit: m}
  g: {is: gravity, value: 9.8, unit: m/s^2}
where:
  - abs(tan(theta) - mu) > 0.05
---
A block on a slope of angle {{theta}} and length {{L}}; the friction is {{mu}}, and $g = {{g}}$.

## Acceleration {#a .value unit="m/s^2"}
What is it if it slides, positive down the slope?

## Does it slide? {#b .choice}
- (A) Yes.
- (B) No.
""",
    """\
from corollary.author import *
from corollary.laws import *
from sympy import tan

def derive(mu, theta, L, g):
    a, b = unknowns("a b")
    return derivation(
        step(a, "Newton's second law, as if it slid.", law("Newton's second law", "a = g*sin(theta) - mu*g*cos(theta)"), answers="a"),
        choice("b", "It slides where the slope is steeper than the friction holds.",
               a=tan(theta) > mu,
               b=tan(theta) <= mu),
        at(mu=tan(theta), a=0),
        printed("a", "2.35 m/s^2", "(1)"),
    )
""",
)
BASES |= {"meeting": MEETING, "slope": SLOPE}

PLANTED = (
    # wrong sign
    Planted("impulse with a minus", "kick", "J = m*v + m*w", "J = m*v - m*w", "printed"),
    Planted(
        "energy the other way round", "kick", "E = m*w^2/2 - m*v^2/2", "E = m*v^2/2 - m*w^2/2", "confirm"
    ),
    Planted("energies added", "kick", "E = m*w^2/2 - m*v^2/2", "E = m*w^2/2 + m*v^2/2", "confirm"),
    Planted("relative velocity with a plus", "collision", "u_B - u_A = v", "u_B + u_A = v", "confirm"),
    Planted("A is ahead of B", "collision", "u_B - u_A = v", "u_A - u_B = v", "confirm"),
    Planted("gravity lifts", "fall", "sin(theta)^2 - 2*g*h", "sin(theta)^2 + 2*g*h", "printed"),
    Planted("restitution with a plus", "meeting", "r = (w - u)/v", "r = (w + u)/v", "printed"),
    Planted("friction pushes", "slope", "a = g*sin(theta) - mu", "a = g*sin(theta) + mu", "special case"),
    # wrong factor
    Planted("momentum doubled", "kick", '"p = m*v")', '"p = 2*m*v")', "printed"),
    Planted("impulse halved", "kick", '"J = m*v + m*w")', '"J = (m*v + m*w)/2")', "printed"),
    Planted("energy without the half", "kick", "E = m*w^2/2 - m*v^2/2", "E = m*w^2 - m*v^2", "confirm"),
    Planted("half of the energy of B", "collision", '"E = m*u_B^2/2"', '"E = m*u_B^2/4"', "printed"),
    Planted("mass of A for that of B", "collision", '"E = m*u_B^2/2"', '"E = M*u_B^2/2"', "printed"),
    Planted(
        "range without the double angle",
        "fall",
        's = v^2*sin(2*theta)/g")',
        's = v^2*sin(theta)/g")',
        "confirm",
    ),
    Planted(
        "half of the range", "fall", 's = v^2*sin(2*theta)/g")', 's = v^2*sin(2*theta)/(2*g)")', "confirm"
    ),
    Planted("cosine for sine", "slope", "a = g*sin(theta)", "a = g*cos(theta)", "special case"),
    # wrong unit
    Planted("momentum in newtons", "kick", 'unit="kg*m/s"', 'unit="N"', "dimension"),
    Planted("force in joules", "kick", 'unit="N"}', 'unit="J"}', "dimension"),
    Planted("printed in grams", "kick", '"2.0 kg m/s"', '"2.0 g m/s"', "printed"),
    Planted("energy as momentum", "collision", '"E = m*u_B^2/2"', '"E = m*u_B/2"', "dimension"),
    Planted(
        "range without gravity", "fall", 's = v^2*sin(2*theta)/g")', 's = v^2*sin(2*theta)")', "dimension"
    ),
    Planted("condition without its unit", "kick", ">= 0.5 m/s", ">= 0.5", "condition"),
    # dropped term
    Planted("only what arrives", "kick", "J = m*v + m*w", "J = m*v", "printed"),
    Planted("only what leaves", "kick", "E = m*w^2/2 - m*v^2/2", "E = m*w^2/2", "confirm"),
    Planted("momentum of A forgotten", "collision", '"M*v = M*u_A + m*u_B"', '"M*v = m*u_B"', "confirm"),
    Planted("no friction", "slope", "a = g*sin(theta) - mu*g*cos(theta)", "a = g*sin(theta)", "special case"),
    Planted("B not counted", "meeting", "after=[(M, u), (m, w)]", "after=[(M, u)]", "special case"),
    # the second root
    Planted("no root chosen", "collision", "where=u_B > 0", "where=u_B >= 0", "one root"),
    Planted(
        "the root before the collision",
        "collision",
        "where=u_B > 0",
        "where=sympy.Eq(u_B, 0)",
        "special case",
    ),
    Planted("both roots of the speed", "fall", ", where=u >= 0", "", "one root"),
    Planted("the falling root", "fall", "where=u >= 0", "where=u <= 0", "printed"),
    # a missing condition
    Planted(
        "the wall may be too high",
        "fall",
        "  - v*v*sin(theta)*sin(theta) > 2*g*h",
        "  - h > 0",
        "value exists",
    ),
    Planted("the wall may just be too high", "fall", "> 2*g*h", "> 1.99*g*h", "value exists"),
    Planted("neither slides nor rests", "slope", "b=tan(theta) <= mu", "b=tan(theta) <= mu/2", "one case"),
    Planted("slides and rests", "slope", "b=tan(theta) <= mu", "b=tan(theta) <= 3*mu/2", "one case"),
    Planted(
        "divided by what may be zero",
        "meeting",
        '"r = (w - u)/v"',
        '"r = (w - u)/(v - w)"',
        "value exists",
    ),
    # something created in a small share of variants
    Planted("kinetic energy created", "meeting", "  - w*(m + M) <= 2*M*v\n", "", "not created"),
    Planted("a little kinetic energy created", "meeting", "<= 2*M*v", "<= 2.02*M*v", "not created"),
    Planted(
        "a body of negative mass", "meeting", "[(M, u), (m, w)]", "[(M - 2*m/5, u), (m, w)]", "not created"
    ),
    # a mistake that coincides, everywhere or for special numbers only
    Planted(
        "a mistake that is right", "kick", 'wrong("F = 2*J/dt")', 'wrong("F = J/dt")', "mistake is the truth"
    ),
    Planted(
        "a mistake right where v = 2 w", "kick", 'wrong("F = 2*J/dt")', 'wrong("F = 3*m*w/dt")', "redrawn"
    ),
    Planted(
        "a mistake right at 45 degrees",
        "fall",
        'wrong("s = v^2*sin(2*theta)/(2*g)")',
        'wrong("s = v^2/g")',
        "redrawn",
    ),
    Planted(
        "a mistake right where M = 2 m",
        "collision",
        'wrong("E = m*u_B^2")',
        'wrong("E = M*u_B^2/4")',
        "redrawn",
    ),
    Planted(
        "a mistake right within a per cent",
        "fall",
        'wrong("u^2 = v^2 - 2*g*h")',
        'wrong("u^2 = v^2*sin(theta)^2 - 2.01*g*h")',
        "redrawn",
    ),
)

WORDS = {
    "printed": (" prints ",),
    "confirm": ("does not hold for the answers: a sign or a term is wrong",),
    "special case": (" at ",),
    "dimension": ("the dimensions do not fit", "the answer is not in"),
    "condition": ("cannot be compared",),
    "one root": ("2 answers (",),
    "mistake is the truth": ("100 % of the draws may not be assigned",),
}
"""The sentence of each check that complains of its own."""


def verified(folder: Path, base: Base) -> Checked:
    """The problem written into the folder, and verified over ten variants. Raises Malformed."""
    for room in ("problems", "solutions"):
        (folder / room / "carts").mkdir(parents=True)
    (folder / "problems/carts/cart.md").write_text(base.problem, encoding="utf-8")
    (folder / "solutions/carts/cart.py").write_text('"""A cart."""\n\n' + base.solution, encoding="utf-8")
    bank = Bank(folder)
    return verify(bank, find(bank, "X1.1"), 10)


def evidence(folder: Path, planted: Planted) -> str:
    """What the check named says of the fault: its complaint, or the numbers for which its obligation fails; "" where it is not found."""
    base, check = BASES[planted.base], planted.check
    faulty = Base(*(text.replace(planted.old, planted.new) for text in (base.problem, base.solution)))
    try:
        checked = verified(folder, faulty)
    except Malformed as error:
        return _first(map(str, error.complaints), check)
    if check == "redrawn":
        failing = [each for each in checked.obligations if each.kind == "mistake apart" and each.numbers]
    else:
        if said := _first(checked.complaints, check):
            return said
        failing = [
            each
            for each in (() if checked.ok else checked.obligations)
            if each.kind == check and each.outcome == "counter-example" and each.numbers
        ]
    if not failing:
        return ""
    numbers = ", ".join(f"{letter} = {value}" for letter, value in failing[0].numbers.items())
    return f"{failing[0].claim}: not for {numbers}"


def _first(sentences: Iterable[str], check: str) -> str:
    return next((each for each in sentences if any(words in each for words in WORDS.get(check, ()))), "")
