"""The words a solution is written in."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

import sympy
from sympy.logic.boolalg import Boolean

from corollary.derive.statements import (
    Choice,
    Code,
    Derivation,
    Entry,
    Example,
    Explain,
    Mistake,
    Neglected,
    Optimum,
    Plot,
    Printed,
    Proof,
    Rejected,
    Route,
    Simulated,
    Step,
    Supposed,
)
from corollary.laws.law import Law
from corollary.laws.substitute import as_expression

Finds = sympy.Symbol | tuple[sympy.Symbol, ...]
HALF_PI = sympy.pi / 2


def derivation(*entries: Entry) -> Derivation:
    """The whole solution, in the order in which things are found."""
    return Derivation(entries)


def unknowns(names: str) -> tuple[sympy.Symbol, ...]:
    """Real unknowns, by their letters: `dp, J = unknowns("dp J")`."""
    return tuple(sympy.Symbol(name, real=True) for name in names.split())


def unknown(name: str) -> sympy.Symbol:
    """One real unknown."""
    return sympy.Symbol(name, real=True)


def vector(name: str, components: str = "x y") -> tuple[sympy.Symbol, ...]:
    """The components of an unknown vector: `vector("J")` is (J_x, J_y)."""
    return unknowns(" ".join(f"{name}_{component}" for component in components.split()))


def step(
    finds: Finds, because: str, *laws: Law, answers: str = "", also: Sequence[sympy.Symbol] = (), where: Boolean | bool = True,
    reject: Sequence[Rejected] = (), mistakes: Sequence[Mistake] = (), routes: Sequence[Route] = (), check: str = "",
    scale: sympy.Expr | None = None,
) -> Step:  # fmt: skip
    """Finds something because of laws; `answers` names the part it answers, `where` says which root is meant."""
    return Step(
        _tuple(finds),
        because,
        laws,
        answers,
        tuple(also),
        where,
        tuple(reject),
        tuple(mistakes),
        tuple(routes),
        check,
        scale,
    )


def mistake(text: str, *laws: Law, instead: str = "") -> Mistake:
    """What a student is told who put these laws in the place of one law of the step."""
    return Mistake(text, laws, instead)


def route(because: str, *laws: Law) -> Route:
    """Another way to the same find."""
    return Route(because, laws)


def reject(reason: str, **roots: object) -> Rejected:
    """A root that is on record as refused: `reject("no collision took place", v_A=vA)`."""
    return Rejected(reason, {unknown(name): as_expression(root) for name, root in roots.items()})


def optimum(
    finds: Finds, because: str, *, of: sympy.Expr, over: sympy.Symbol, between: tuple, largest: bool = True, answers: str = "",
    mistakes: Sequence[Mistake] = (), check: str = "",
) -> Optimum:  # fmt: skip
    """The value of `over`, between the bounds (included), at which `of` is largest (or smallest)."""
    low, high = between
    return Optimum(
        _tuple(finds),
        because,
        of,
        over,
        (as_expression(low), as_expression(high)),
        largest,
        answers,
        tuple(mistakes),
        check,
    )


def simulated(
    finds: Finds, because: str, *, scene: str, settings: Mapping[str, object], observe: str, answers: str = "",
    mistakes: Sequence[Mistake] = (), check: str = "",
) -> Simulated:  # fmt: skip
    """Finds that are measured in a run of a ready-made scene."""
    formulas = {name: as_expression(value) for name, value in settings.items()}
    return Simulated(_tuple(finds), because, scene, formulas, observe, answers, tuple(mistakes), check)


def choice(
    part: str, because: str, *, mistakes: Mapping[str, str] | None = None, **options: Boolean | bool
) -> Choice:
    """Each option with the condition under which it is the right one; exactly one may hold."""
    return Choice(part, because, options, mistakes or {})


def example(
    part: str, finds: Finds, because: str, *laws: Law, apart: Sequence[tuple[tuple, str]] = (), free: int = 1, scale: object = 1,
) -> Example:  # fmt: skip
    """Any numbers that satisfy the laws and are none of the `apart` ones; `free` unknowns must stay free, which is checked."""
    away = tuple((tuple(as_expression(value) for value in values), why) for values, why in apart)
    return Example(part, _tuple(finds), because, laws, away, free, as_expression(scale))


def code(part: str, because: str, *, inputs: Callable, judge: Callable, example: str) -> Code:
    """A code part: `inputs(given, draw)` lists keyword arguments, `judge(given, called)` says what is wrong with the calls, or None."""
    return Code(part, because, inputs, judge, example)


def plot(part: str, because: str, *, judge: Callable, example: str) -> Plot:
    """A plot part: `judge(given, axes)` says what is missing, or None."""
    return Plot(part, because, judge, example)


def proof(
    part: str, because: str, *laws: Law, target: Law, lines: Sequence[str], mistakes: Sequence[Mistake] = ()
) -> Proof:
    """A "show that": the laws it may start from, the equation to arrive at, and one good proof, line by line."""
    return Proof(part, because, laws, target, tuple(lines), tuple(mistakes))


def neglected(
    part: str, what: str, bound: sympy.Symbol, because: str, *laws: Law, also: Sequence[sympy.Symbol] = (), supposing: Sequence[Supposed] = (),
    asked: bool = False,
) -> Neglected:  # fmt: skip
    """What the answer of a part leaves out: `bound` is the most by which it can change the answer, found from laws like any find."""
    return Neglected(what, step(bound, because, *laws, answers=part, also=also), tuple(supposing), asked)


def supposed(name: str, text: str, why: str) -> tuple[sympy.Symbol, Supposed]:
    """A positive value that is not given, for what is neglected: `tau, touch = supposed("tau", "1 ms", "hard things touch no longer")`."""
    symbol = sympy.Symbol(name, positive=True)
    return symbol, Supposed(symbol, text, why)


def explain(part: str, *rubric: str, answer: str) -> Explain:
    """A part for a person to mark: what earns credit, and what a full answer says."""
    return Explain(part, rubric, answer)


def printed(part: str, text: str, where: str) -> Printed:
    """What the chapter prints: `printed("a", "2.28 kg m/s", "(12.31)")`; several components are parted by semicolons."""
    return Printed(part, text, where)


def _tuple(finds: Finds) -> tuple[sympy.Symbol, ...]:
    return finds if isinstance(finds, tuple) else (finds,)
