"""The words a solution is written in."""

# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any

import sympy
from sympy.logic.boolalg import Boolean

from corollary.derive.beside import LazyModule, program_text
from corollary.derive.derivation import (
    Branch,
    Case,
    Cases,
    StatedEntry,
    branches,
    one_by_one,
    one_for_each_part,
)
from corollary.derive.function_values import value_of
from corollary.derive.simulation import NONE, Seen, Simulation
from corollary.derive.stated_words import along as along
from corollary.derive.stated_words import always as always
from corollary.derive.stated_words import at as at
from corollary.derive.stated_words import force as force
from corollary.derive.stated_words import forces as forces
from corollary.derive.stated_words import frame_of_word, line_of_word
from corollary.derive.stated_words import function as function
from corollary.derive.stated_words import limit as limit
from corollary.derive.stated_words import unknown as unknown
from corollary.derive.stated_words import unknowns as unknowns
from corollary.derive.stated_words import variable as variable
from corollary.derive.stated_words import vector as vector
from corollary.derive.statements import (
    Choice,
    Code,
    Confirm,
    Doubt,
    Each,
    Example,
    Exchange,
    Explain,
    Fault,
    Mistake,
    Neglected,
    Optimum,
    Plot,
    Printed,
    Proof,
    Rejected,
    Remark,
    Route,
    Simulated,
    Statement,
    Step,
    Supposed,
)
from corollary.formula.authored import as_condition, as_expression
from corollary.laws.law import Law, known_by_name, law, only_laws, sides
from corollary.scenes.scene import Scene

Unknowns = sympy.Symbol | tuple[sympy.Symbol, ...]
HALF_PI = sympy.pi / 2
oo = sympy.oo


def derivation(*entries: StatedEntry | Cases) -> tuple[Branch, ...]:
    """The whole solution, in the order in which things are found."""
    return branches(list(one_by_one(entries)))


def cases(*stated: Case) -> Cases:
    """Regimes of which exactly one holds for the numbers drawn, such as rest and sliding."""
    return Cases(stated, line_of_word())


def case(text: str, condition: Boolean, *entries: StatedEntry) -> Case:
    """One regime: what the student reads of it, when it holds, and the steps that are taken then."""
    found = tuple(each for each in one_by_one(entries) if not isinstance(each, Cases))
    return Case(text, as_condition(condition), found, line_of_word())


def step(
    unknowns: Unknowns,
    because: str,
    *laws: Law,
    answers: str | Mapping[str, Unknowns] = "",
    also: Sequence[sympy.Symbol] = (),
    where: Boolean | bool = True,
    reject: Sequence[Rejected] = (),
    mistakes: Sequence[Mistake[Exchange]] = (),
    routes: Sequence[Route[Law]] = (),
    check: str = "",
    scale: sympy.Expr | None = None,
    each: Each | None = None,
) -> Step | tuple[Step, ...]:
    """Finds something because of laws; `answers` names the part it answers, or the unknowns that answer each of several parts,
    `{"a": F, "b": (v_x, v_y)}`; `where` says which root is meant, `each` for which whole numbers a list has an entry."""
    several = {name: _tuple(found) for name, found in answers.items()} if isinstance(answers, Mapping) else {}
    part = answers if isinstance(answers, str) else ""
    stated = Step(
        Statement(part, because, line_of_word(), check),
        _tuple(unknowns),
        only_laws(laws),
        tuple(also),
        as_condition(where),
        tuple(reject),
        tuple(mistakes),
        tuple(routes),
        None if scale is None else as_expression(scale),
        each,
    )
    return one_for_each_part(stated, several) if several else stated


def each(letter: sympy.Symbol, low: object, high: object) -> Each:
    """Each whole number of a range: `each(m, 1, floor(d/lam))` with `m = variable("m")`."""
    return Each(letter, as_expression(low), as_expression(high))


def mistake(
    text: str,
    *laws: Law,
    instead: str | Sequence[str] = (),
    where: Boolean | bool | None = None,
    each: Each | None = None,
    name: str = "",
) -> Mistake[Exchange]:
    """What a student is told who put these laws in the place of one of the step, or of those named; `where` says which root.
    `name` is that of the misconception, the same wherever it is listed."""
    named = (instead,) if isinstance(instead, str) else instead
    which = None if where is None else as_condition(where)
    rule = Exchange(only_laws(laws), tuple(filter(None, named)), which, each)
    return Mistake(text, rule, line_of_word(), name)


def route(because: str, *laws: Law) -> Route[Law]:
    """Another way to the same unknown."""
    return Route(because, only_laws(laws), line_of_word())


def confirm(because: str, *laws: Law) -> Confirm:
    """Laws that must hold for what was found without them, such as an energy balance: `verify` puts the answers in."""
    return Confirm(Statement("", because, line_of_word()), only_laws(laws))


def reject(reason: str, **roots: object) -> Rejected:
    """A root that is on record as refused: `reject("no collision took place", v_A=vA)`."""
    return Rejected(
        reason, {sympy.Symbol(name, real=True): as_expression(root) for name, root in roots.items()}
    )


def optimum(
    unknowns: Unknowns,
    because: str,
    *,
    of: sympy.Expr | str,
    over: sympy.Symbol,
    between: tuple[object, object],
    largest: bool = True,
    answers: str = "",
    mistakes: Sequence[Mistake[Exchange]] = (),
    check: str = "",
) -> Optimum:
    """The value of `over`, between the bounds (included), at which `of` is largest (or smallest); formulas may be texts."""
    low, high = map(_expression, between)
    words = Statement(answers, because, line_of_word(), check)
    return Optimum(words, _tuple(unknowns), _expression(of), over, (low, high), largest, tuple(mistakes))


def _expression(stated: object) -> sympy.Expr:
    """A formula, or the text of one in the letters of the problem."""
    if not isinstance(stated, str):
        return as_expression(stated)
    ((_left, right),) = sides(law("optimum", f"optimum = {stated}", optimum=sympy.Symbol("optimum")))
    return right


def simulated(
    unknowns: Unknowns,
    because: str,
    *,
    scene: str,
    settings: Mapping[str, object],
    observe: str,
    answers: str = "",
    mistakes: Sequence[Mistake[Exchange]] = (),
    check: str = "",
) -> Simulated:
    """Unknowns that are measured in a run of a ready-made scene."""
    formulas = {name: as_expression(value) for name, value in settings.items()}
    words = Statement(answers, because, line_of_word(), check)
    return Simulated(words, _tuple(unknowns), scene, formulas, observe, tuple(mistakes))


def choice(
    part: str, because: str, *, mistakes: Mapping[str, str] | None = None, **options: Boolean | bool
) -> Choice[Boolean | bool]:
    """Each option with the condition under which it is the right one; exactly one may hold."""
    held = {letter: as_condition(condition) for letter, condition in options.items()}
    return Choice(Statement(part, because, line_of_word()), held, mistakes or {})


def example(
    part: str,
    unknowns: Unknowns,
    because: str,
    *laws: Law,
    apart: Sequence[tuple[tuple[object, ...], str]] = (),
    free: int = 1,
    scale: object = 1,
) -> Example[sympy.Symbol, sympy.Expr, Law]:
    """Any numbers that satisfy the laws and are none of the `apart` ones; `free` unknowns must stay free, which is checked."""
    away = tuple((tuple(map(as_expression, values)), why) for values, why in apart)
    words = Statement(part, because, line_of_word())
    return Example(words, _tuple(unknowns), only_laws(laws), away, free, as_expression(scale))


def code(
    part: str,
    because: str,
    *,
    inputs: Callable[..., Sequence[Mapping[str, Any]]],
    judge: Callable[..., Fault | Remark | None],
    example: str,
) -> Code:
    """A code part: `inputs(given, draw)` lists keyword arguments, `judge(given, called)` says what is wrong with the calls, or None."""
    return Code(Statement(part, because, line_of_word()), inputs, judge, example)


def plot(
    part: str,
    because: str,
    *,
    judge: Callable[..., Fault | Doubt | None],
    example: str,
    with_calls: bool = False,
) -> Plot:
    """A plot part: `judge(given, axes)` says what is missing, or None; with calls `judge(given, axes, called)`."""
    return Plot(Statement(part, because, line_of_word()), judge, example, with_calls)


def file(name: str) -> str:
    """The text of a program beside the solution, `example=file("newtons_cradle/cradle.py")`, without the imports it opens with:
    every notebook has made them (numpy as np, matplotlib.pyplot as plt).
    """
    return program_text(_folder() / name)


def module(name: str) -> LazyModule:
    """A Python file beside the solution, `row = module("newtons_cradle/judge_cradle.py")`: `row.judge_cradle` is its function, which
    loads the file when it is first called, so that what a judge imports takes no time before.
    """
    return LazyModule(_folder() / name, _folder())


def _folder() -> Path:
    return Path(frame_of_word().f_code.co_filename).parent


def proof(
    part: str,
    because: str,
    *laws: Law,
    target: Law,
    lines: Sequence[str],
    mistakes: Sequence[Mistake[Exchange]] = (),
    given: Sequence[Law] = (),
    rates: Mapping[sympy.Symbol, Any] | None = None,
) -> Proof[Law]:
    """A "show that": the laws it may start from, the equation to arrive at, and one good proof, line by line.

    `given` is what the question states besides, each with a letter alone on its left (`m_B = m_A`): nobody has to write it.
    `rates` are the derivatives by time of the letters that change (`{mu: R, y: v0}`), by which `d(mu*v)/dt` is read; where they are
    stated, every other given is constant.
    """
    wrong = tuple(Mistake(each.text, each.rule.laws, each.line, each.name) for each in mistakes)
    (target,) = only_laws((target,))
    return Proof(
        Statement(part, because, line_of_word()),
        only_laws(laws),
        target,
        tuple(lines),
        wrong,
        only_laws(given),
        tuple((letter.name, as_expression(rate)) for letter, rate in (rates or {}).items()),
    )


def neglected(
    part: str,
    what: str,
    bound: sympy.Symbol,
    because: str,
    *laws: Law,
    also: Sequence[sympy.Symbol] = (),
    supposing: Sequence[Supposed] = (),
    asked: bool = False,
) -> Neglected[Step, Supposed]:
    """What the answer of a part leaves out: `bound` is the most by which it can change the answer, found from laws like any unknown."""
    words = Statement(part, because, line_of_word())
    found = Step(words, (bound,), only_laws(laws), tuple(also), True, (), (), (), None)
    return Neglected(what, found, tuple(supposing), asked)


def supposed(name: str, text: str, why: str) -> tuple[sympy.Symbol, Supposed]:
    """A positive value that is not given, for what is neglected: `tau, touch = supposed("tau", "1 ms", "hard things touch no longer")`."""
    symbol = sympy.Symbol(name, positive=True)
    known_by_name(name, symbol)
    return symbol, Supposed(name, text, why)


def explain(part: str, *rubric: str, answer: str) -> Explain:
    """A part for a person to mark: what earns credit, and what a full answer says."""
    return Explain(Statement(part, "", line_of_word()), rubric, answer)


def printed(part: str, text: str, where: str, *, erratum: str = "") -> Printed:
    """What the chapter prints: values (several parted by semicolons), a formula, an option's letter, an order of magnitude
    (`"~10^3 N"`). `erratum` puts what is known to be wrong on record."""
    return Printed(Statement(part, "", line_of_word()), text, where, erratum)


def simulate(
    scene: str | Scene,
    settings: Mapping[str, object] = NONE,
    *,
    neglected: float = 0.0,
    animated: bool = False,
    **expect: Seen,
) -> Simulation:
    """In a solution's scene function: run this ready-made scene, or a composed one, and find these values (SI).

    One that is `animated` is the motion of the exercise itself, seen as the exercise sees it: whoever has solved it can play it.
    """
    return Simulation(scene, settings, expect, neglected, line_of_word(), animated)


def _tuple(unknowns: Unknowns) -> tuple[sympy.Symbol, ...]:
    """The unknowns; for a function, v(t), the one that stands for it at any time."""
    every = unknowns if isinstance(unknowns, tuple) else (unknowns,)
    return tuple(value_of(each) or each for each in every)
