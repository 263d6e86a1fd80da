"""Solutions in text: they state what the Python words state, name the line of what is wrong, and run nothing."""

from __future__ import annotations

import re
import sys
from contextlib import suppress
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from corollary.derive.load import NotDerivable, load
from corollary.derive.markdown_items import sections
from corollary.derive.solve import solve
from corollary.problem.bank import Bank, find

PROBLEM = """\
---
code: T1.1
title: A sledge
given:
  m: {is: mass, value: 2, from: 1, to: 9, step: 1, unit: kg}
  F: {is: force, value: 5, from: 1, to: 30, step: 1, unit: N}
  mu: {is: coefficient of friction, value: 0.1, from: 0.05, to: 0.5, step: 0.05, unit: 1}
  s: {is: way, value: 3, from: 1, to: 9, step: 1, unit: m}
  g: {is: gravity, value: 9.81, unit: m/s^2}
require: [m > 0, F > 0, mu > 0, s > 0, g > 0]
---
{{m}} {{F}} {{mu}} {{s}} {{g}}

## Friction {#a .value unit="N"}
How large?

## Speed {#b .value unit="m/s"}
How fast?

## Which {#c .choice}
- (a) up
- (b) down

## Show it {#d .proof}
Show $v^2 = 2 a s$.

## Why {#e .explain points=2}
Why?

## Numbers {#f .example components="p q" unit="N"}
Two forces.
"""
PYTHON = '''\
"""A sledge."""
from sympy import And
from corollary.author import *
from corollary.laws import law, momentum, wrong
from corollary.misconceptions import half_forgotten


def derive(m, F, mu, s, g):
    N, f, a, v, J, p, q = unknowns("N f a v J p q", N="normal force")
    return derivation(
        step(N, "The floor carries the weight.", law("Balance", "N = m*g")),
        cases(
            case("it stays at rest", F <= mu*m*g,
                 step(f, "It balances.", law("Balance", "f = F"), answers="a"),
                 step(a, "At rest.", law("Rest", "a = 0"))),
            case("it slides", F > mu*m*g,
                 step(f, "Friction.", law("Friction", "f = k*N", k=mu, holds="it slides"), answers="a",
                      mistakes=[mistake("The weight.", wrong("f = W", W=m*g))]),
                 step(a, "Newton.", law("Newton's second law", "F - f = m*a"))),
        ),
        step(v, "Without time.", law("Way", "v^2 = 2*a*s"), answers="b", where=v >= 0, scale=g*s,
             mistakes=[half_forgotten("v^2/2 = a*s", where=v >= 0),
                       mistake("No factor.", wrong("v^2 = a*s"), where=And(v >= 0, v < 100), name="no two")],
             routes=[route("By energy.", law("Energy", "m*v^2/2 = (F - f)*s"))],
             check="A heavy one is slow."),
        step(J, "Momentum.", momentum(J, m, v)),
        choice("c", "Down it goes.", a=False, b=True, mistakes={"a": "Up?"}),
        proof("d", "From the start.", law("Mean", "s = v*t/2", t=v/a), target=law("Speed", "v^2 = 2*a*s"),
              lines=["s = v*v/(2*a)"], given=[law("Rest", "J = m*v")],
              mistakes=[mistake("Not half.", wrong("s = v*t", t=v/a), name="not half")]),
        explain("e", "names the floor", "names the weight", answer="Because the floor carries it."),
        example("f", (p, q), "They cancel.", law("Sum", "p + q = 0"), apart=[((0, 0), "no forces")], scale=F),
        limit(v, s, 0, 0),
        at(mu=F/(m*g), a=0),
        always("friction does not pull", f > 0),
        confirm("Work is energy.", law("Energy", "(F - f)*s = m*v^2/2")),
        printed("a", "2 N", "(1.2)", erratum="misprinted"),
    )
'''
TEXT = """\
A sledge.

## N: normal force

The floor carries
the weight.

- law: Balance, `N = m*g`

## Case: it stays at rest, if `F <= mu*m*g`

### (a) f

It balances.

- law: Balance, `f = F`

### a

At rest.

- law: Rest, `a = 0`

## Case: it slides, if `F > mu*m*g`

### (a) f

Friction.

- law: Friction, `f = k*N` with `k = mu`
  - holds: it slides
- mistake: The weight. `f = W` with `W = m*g`

### a

Newton.

- law: Newton's second law, `F - f = m*a`

## (b) v

Without time.

- law: Way, `v^2 = 2*a*s`
- where: `v >= 0`
- scale: `g*s`
- mistake: `half_forgotten("v^2/2 = a*s")` where `v >= 0`
- mistake: No factor. `v^2 = a*s` where `v >= 0 and v < 100` named "no two"
- route: By energy.
  - law: Energy, `m*v^2/2 = (F - f)*s`
- check: A heavy one is slow.

## J

Momentum.

- law: `momentum(J, m, v)`

## (c)

Down it goes.

- (a) is wrong: Up?
- (b) is right

## (d)

From the start.

- proof: Speed, `v^2 = 2*a*s`
- law: Mean, `s = v*t/2` with `t = v/a`
- given: Rest, `J = m*v`
- line: `s = v*v/(2*a)`
- mistake: Not half. `s = v*t` with `t = v/a`
  - named: not half

## (e)

Because the floor carries it.

- rubric: names the floor
- rubric: names the weight

## (f) p, q

They cancel.

- example: 1 free
- law: Sum, `p + q = 0`
- apart: `0, 0` no forces
- scale: `F`

## Checks

- limit: `v -> 0` as `s -> 0`
- at: `mu = F/(m*g), a = 0`
- always: friction does not pull `f > 0`
- confirm: Work is energy.
  - law: Energy, `(F - f)*s = m*v^2/2`
- printed: (a) `2 N` in (1.2)
  - erratum: misprinted
"""


def bank(folder: Path, suffix: str, solution: str, problem: str = PROBLEM) -> Bank:
    for name, text in (("problems/sledge.md", problem), (f"solutions/sledge{suffix}", solution)):
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text, encoding="utf-8")
    return Bank(folder)


def stated(place: Bank) -> str:
    loaded = load(place, find(place, "T1.1"))
    return re.sub(r"line=\d+", "", repr((loaded.branches, loaded.meanings)))


def test_a_text_states_what_the_python_words_state(tmp_path: Path):
    text = stated(bank(tmp_path / "text", ".md", TEXT))
    python = stated(bank(tmp_path / "python", ".py", PYTHON))
    assert text == python


def test_statements_have_the_lines_of_the_text(tmp_path: Path):
    place = bank(tmp_path, ".md", TEXT)
    loaded = load(place, find(place, "T1.1"))
    lines = TEXT.splitlines()
    step = next(each for each in loaded.branches[0].derivation.entries if each.statement.part == "b")
    assert lines[step.statement.line - 1] == "## (b) v"
    assert "No factor." in lines[step.mistakes[1].line - 1]


SOLVED = PROBLEM[: PROBLEM.index("\n## Which")]
SHORT = """\
## N

The floor carries the weight.

- law: Balance, `N = m*g`

## (a) f

Friction.

- law: Friction, `f = mu*N`
- mistake: The weight alone. `f = m*g`

## (b) v

Work.

- law: Energy, `m*v^2/2 = f*s`
- where: `v >= 0`
"""


@pytest.mark.parametrize(
    ("old", "new", "line", "words"),
    [
        ("- law: Friction, `f = mu*N`", "- law: Friction `f = mu*Q`", 11, "what does Q mean"),
        ("- law: Friction, `f = mu*N`", "- law: `f = mu*N`", 11, "name the law before its formula: Momentum, `f = mu*N`"),
        ("- law: Friction, `f = mu*N`", "- law: Friction, f = mu*N", 11, "one law between backticks"),
        ("- law: Friction, `f = mu*N`", "- laws: Friction, `f = mu*N`", 11, "did you mean law?"),
        ("- law: Friction, `f = mu*N`", "- law: `frction(f, mu, N)`", 11, "there is no law and no misconception frction"),
        ("- law: Friction, `f = mu*N`\n", "", 7, "state the laws from which it follows"),
        ("`f = m*g`", "", 12, "say which law the mistake puts in the place"),
        ("The weight alone. `f", "`f", 12, "say what the student reads"),
        ("`f = m*g`", "`f = m*g` is wrong", 12, "'is' stands behind a formula"),
        ("`f = m*g`", "`f = m*g` wehre `f > 0`", 12, "did you mean where?"),
        ("`f = m*g`", "`f = m*g", 12, "a backtick is missing"),
        ("where: `v >= 0`", "where: `v + 1`", 19, "compares nothing"),
        ("where: `v >= 0`", "where: v >= 0", 19, "a formula between backticks"),
        ("where: `v >= 0`", "where: `v >= oo*0`", 19, "not a number"),
        ("## (b) v", "##(b) v", 14, "a heading with a blank behind its signs, such as ## (b) v"),
        ("- law: Friction, `f = mu*N`", "law: Friction, `f = mu*N`", 11, "begin an item of a list with a dash and a blank: - law: Friction"),
        ("- law: Friction, `f = mu*N`", "1. law: Friction, `f = mu*N`", 11, "with a dash and a blank: - law: Friction"),
        ("- law: Friction, `f = mu*N`", "-law: Friction, `f = mu*N`", 11, "with a dash and a blank: - law: Friction"),
        ("## N", "---\ncode: T1\n---\n\n## N", 1, "a solution has no front matter"),
        ("- mistake: The weight", "\nA word more.\n\n- mistake: The weight", 13, "words for the reader stand above the list"),
        ("where: `v >= 0`", "where: `v >= 0`\n- check:", 20, "nothing stands behind check:"),
        ("## (b) v", "# (b) v", 14, "a step has a heading of level two: ## (b) v"),
        ("## (b) v", "## (b): v", 14, "a heading is a part in brackets and the unknowns"),
        ("## (b) v", "## Case: it slides", 14, "a heading is a part in brackets and the unknowns"),
        ("## (b) v", "## Check", 14, "a heading is a part in brackets and the unknowns"),
        ("`f = m*g`", "`f = m*g`\n  - lwa: Weight, `f = g`", 13, "'lwa' has no place below 'mistake' (did you mean law?)"),
        ("where: `v >= 0`", "where: `v >= 0`\n  - check: fast", 20, "'check' has no place below 'where'; move it to the left"),
        ("## (b) v", "## (b) m", 14, "m is a given"),
        ("## (b) v", "## (b) the speed", 14, "a heading is a part in brackets and the unknowns"),
        ("## (b) v", "## (b) exp", 14, "exp is a function in formulas"),
        ("## (b) v", "## (b)", 18, "'law' has no place here"),
        ("\nWork.", "\nWork.\n\n- (a) is right", 18, "'(a)' has no place here"),
    ],
)  # fmt: skip
def test_what_is_wrong_is_said_with_its_line(tmp_path: Path, old: str, new: str, line: int, words: str):
    assert old in SHORT
    place = bank(tmp_path, ".md", SHORT.replace(old, new), SOLVED)
    with pytest.raises(NotDerivable) as fault:
        load(place, find(place, "T1.1"))
    assert (fault.value.path.name, fault.value.line) == ("sledge.md", line), fault.value
    assert words in fault.value.sentence


def test_a_text_is_solved(tmp_path: Path):
    place = bank(tmp_path, ".md", SHORT, SOLVED)
    found = solve(place, find(place, "T1.1"))
    assert [each.part for each in found.unknowns] == ["", "a", "b"]


@pytest.mark.parametrize(
    "call",
    [
        "__import__('os').system('touch ran')",
        'import_module("antigravity")',
        "load(plug_ins, N)",
        "plug_ins(N)",
        "momentum.__globals__(N, m, s)",
        "().__class__(N)",
        "(lambda: N)()",
        "momentum(*N)",
        "momentum(**N)",
        "momentum(p := N, m, s)",
        "law(N, m)",
        "Fraction(1, 2)",
        "eval('1')",
        "momentum([N for N in (m, s)], m, s)",
        'momentum(f"{m}", m, s)',
    ],
)
def test_nothing_but_laws_and_misconceptions_is_called(
    tmp_path: Path, call: str, monkeypatch: pytest.MonkeyPatch
):
    monkeypatch.chdir(tmp_path)
    place = bank(tmp_path, ".md", SHORT.replace("Balance, `N = m*g`", f"`{call}`"), SOLVED)
    with pytest.raises(NotDerivable) as fault:
        load(place, find(place, "T1.1"))
    assert fault.value.line == 5
    assert not (tmp_path / "ran").exists()
    assert "antigravity" not in sys.modules


def test_programs_beside_a_text_run_only_when_they_are_asked_for(tmp_path: Path):
    place = bank(tmp_path, ".md", SHORT, SOLVED)
    program = tmp_path / "solutions" / "sledge.py"
    program.write_text("raise SystemExit('it ran')\n\n\ndef scene(m, F, mu, s, g, answer):\n    return []\n")
    assert solve(place, find(place, "T1.1")).unknowns
    program.write_text("def derive(m):\n    return ()\n")
    with pytest.raises(NotDerivable, match=r"sledge.py:1: states a solution that stands in sledge.md, too"):
        load(place, find(place, "T1.1"))


@given(st.text(alphabet="#-()`:ab *\n$\"=<\\_{}.'", max_size=200))
def test_any_text_is_read_or_refused_with_a_line(text: str):
    for section in sections(text):
        assert 1 <= section.line <= text.count("\n") + 1
        assert all(1 <= item.line <= text.count("\n") + 1 for item in section.items)


@given(st.lists(st.sampled_from([*SHORT.splitlines(), "- where: `v >`", "### x", "- law: `x", "## Case: a, if `m >`", "  - with: `a`"]), max_size=12))  # fmt: skip
def test_lines_in_any_order_raise_nothing_but_a_sentence(
    tmp_path_factory: pytest.TempPathFactory, lines: list[str]
):
    place = bank(tmp_path_factory.mktemp("any"), ".md", "\n".join(lines), SOLVED)
    with suppress(NotDerivable):
        load(place, find(place, "T1.1"))


def test_a_byte_that_is_no_utf8_is_named_with_its_line(tmp_path: Path):
    place = bank(tmp_path, ".md", SHORT, SOLVED)
    path = find(place, "T1.1").path
    solution = place.solution_beside(path)
    solution.write_bytes(SHORT.encode().replace(b"Friction.", b"Reibungskr\xe4fte."))
    with pytest.raises(NotDerivable) as fault:
        load(place, find(place, "T1.1"))
    assert (fault.value.line, fault.value.sentence[:26]) == (9, "is not in UTF-8 (byte 0xe4")
