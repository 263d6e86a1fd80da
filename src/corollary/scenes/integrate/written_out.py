"""The law of motion of a short row and one step of a method as Python text, made for their number of variables and compiled once.

The same sums as those of the table and of Newton's second law, without a loop: a step costs a tenth of one that walks through the
table. The state of a row is (time, overlaps, velocities). Gaps and not positions are the unknowns: nothing cancels however hard the
bodies are. In the variable of a contact the time takes the place of that contact's overlap, which the variable shows.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

from corollary.scenes.integrate.runge_kutta import Coefficients, Slope, Tableau
from corollary.scenes.integrate.time_variable import TIME, TimeVariable
from corollary.scenes.row import RowOfBodies

StepFunction = Callable[
    [Slope, float, float, Sequence[float], Sequence[float]], tuple[Sequence[float], float, float]
]
"""(slope, x, h, y, first) to the state after the step and the sums of squares of both error estimates; `first` is the slope at (x, y)."""


@lru_cache(maxsize=32)
def step(table: Tableau, count: int) -> StepFunction:
    """The step of a table with two error estimates, for `count` variables."""
    return from_text(step_text(table, count), "step", {})


def from_text(text: str, name: str, known: dict[str, Any]) -> Any:
    """The function of this name that the text defines; the text is only ever our own."""
    space = dict(known)
    exec(compile(text, f"<{name} written out>", "exec"), space)
    return space[name]


def step_text(table: Tableau, count: int) -> str:
    """The step as Python: one line for every slope."""
    places = range(count)
    lines = [
        "def step(slope, x, h, y, first):",
        f"    {_names('y', places)} = y",
        f"    {_names('a', places)} = first",
    ]
    for stage, (node, row) in enumerate(zip(table.nodes, table.rows, strict=True)):
        if stage:
            state = "".join(f"y{i} + h * ({_sum(row, i)}), " for i in places)
            lines.append(f"    {_names(_letter(stage), places)} = slope(x + {node!r} * h, ({state}))")
    lines += [f"    z{i} = {_sum(table.result, i)}" for i in places]
    after = "".join(f"y{i} + h * z{i}, " for i in places)
    squares = [" + ".join(f"({_estimate(table, row, i)}) ** 2" for i in places) for row in table.estimates]
    return "\n".join([*lines, f"    return ({after}), {', '.join(squares)}"])


def _estimate(table: Tableau, row: Coefficients, place: int) -> str:
    """An error estimate; as its difference from the result where that has fewer terms."""
    weights = dict(zip(row.stages, row.weights, strict=True))
    apart = {
        s: b - weights.get(s, 0.0) for s, b in zip(table.result.stages, table.result.weights, strict=True)
    }
    apart = {s: weight for s, weight in apart.items() if abs(weight) > 1e-15}
    if len(apart) < len(row.stages) and weights.keys() <= set(table.result.stages):
        return f"z{place} - ({_sum(Coefficients(tuple(apart), tuple(apart.values())), place)})"
    return _sum(row, place)


def _letter(stage: int) -> str:
    return "abcdefgijklmnopqrstu"[stage]


def _names(letter: str, places: range) -> str:
    return "".join(f"{letter}{i}, " for i in places)


def _sum(row: Coefficients, place: int) -> str:
    return " + ".join(
        f"{weight!r} * {_letter(stage)}{place}" for stage, weight in zip(row.stages, row.weights, strict=True)
    )


@dataclass(frozen=True, slots=True)
class Form:
    """What the text of a law depends on; the numbers are filled in later."""

    exponents: tuple[float, ...]
    damped: bool
    heavy: bool
    variable: TimeVariable
    pushes: bool


def law_of_motion(line: RowOfBodies, touching: Sequence[bool], variable: TimeVariable = TIME) -> Slope:
    """The rate of change of (overlaps, velocities) on a variable; only contacts that touch push."""
    pushes = variable.contact is not None and touching[variable.contact]
    damped = any(c.eta > 0.0 for c in line.contacts)
    fill_in = _law(Form(tuple(c.q for c in line.contacts), damped, line.weight != 0.0, variable, pushes))
    return fill_in(
        [c.k if on else 0.0 for c, on in zip(line.contacts, touching, strict=True)],
        [c.eta if on else 0.0 for c, on in zip(line.contacts, touching, strict=True)],
        [1.0 / m for m in line.masses],
        [0.0 if math.isinf(m) else line.weight for m in line.masses],
    )


@lru_cache(maxsize=1024)
def _law(form: Form) -> Callable[..., Slope]:
    known: dict[str, Any] = {"sqrt": math.sqrt}
    return from_text(law_text(form), "fill_in", known)


def law_text(form: Form) -> str:
    """The law as Python: a function of stiffnesses, dashpots, inverse masses and weights that gives the slope."""
    contacts, bodies, variable = range(len(form.exponents)), range(len(form.exponents) + 1), form.variable
    lines = [
        f"    {_names(letter, many)} = {letter}"
        for letter, many in zip("keig", (contacts, contacts, bodies, bodies), strict=True)
    ]
    lines += ["    def slope(w, y):", f"        {_names('d', contacts)} {_names('v', bodies)} = y"]
    lines += [f"        r{j} = v{j} - v{j + 1}" for j in contacts]
    lines += [f"        f{j} = {_push(form, j)}" for j in contacts]
    rates = [f"r{j}" for j in contacts]
    for i in bodies:
        pushes = [f"- f{i}"] * (i in contacts) + [f"+ f{i - 1}"] * (i > 0)
        rates.append(f"({' '.join(pushes)}) * i{i}" + (f" - g{i}" if form.heavy else ""))
    if variable.contact is not None:
        lines.append(f"        s = {_stretch(variable)} / r{variable.contact}")
        rates = [f"s * ({rate})" for rate in rates]
        rates[variable.contact] = "s"
    return "\n".join(
        ["def fill_in(k, e, i, g):", *lines, f"        return ({', '.join(rates)})", "    return slope"]
    )


def _push(form: Form, j: int) -> str:
    if form.variable.contact == j:
        spring = (
            f"k{j} * {power_text('w', form.exponents[j] * form.variable.power)}" if form.pushes else "0.0"
        )
        return spring + (f" + e{j} * r{j}" if form.damped else "")
    spring = f"k{j} * {power_text(f'd{j}', form.exponents[j])}"
    return (
        f"{spring} + e{j} * r{j} if d{j} >= 0.0 else 0.0"
        if form.damped
        else f"{spring} if d{j} > 0.0 else 0.0"
    )


def _stretch(variable: TimeVariable) -> str:
    return f"{float(variable.power)} * {power_text('w', variable.power - 1.0)}"


def power_text(base: str, exponent: float) -> str:
    """A power in the fewest operations: products and a root where these do."""
    whole = math.floor(exponent + 1e-12)
    if whole <= 6 and abs(exponent - whole) < 1e-12:
        return " * ".join([base] * whole) or "1.0"
    if whole <= 4 and exponent - whole == 0.5:
        return " * ".join([base] * whole + [f"sqrt({base})"])
    return f"{base} ** {exponent!r}"
