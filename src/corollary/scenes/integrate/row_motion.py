"""Newton's second law for bodies in a row, on any clock, written out for their number.

The state is (time, overlaps, velocities). Gaps and not positions are the unknowns: nothing cancels however hard the bodies are.
On the clock of a contact the time takes the place of that contact's overlap, which the clock shows.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import lru_cache
from itertools import pairwise
from typing import Any

from corollary.scenes.integrate.time_variable import TIME, Clock
from corollary.scenes.integrate.written_out import Slope, from_text
from corollary.scenes.row import Row


def overlaps(line: Row, state: Sequence[float]) -> Sequence[float]:
    return state[1 : len(line.masses)]


def velocities(line: Row, state: Sequence[float]) -> Sequence[float]:
    return state[len(line.masses) :]


def closing_speeds(line: Row, state: Sequence[float]) -> list[float]:
    """How fast the overlap of each contact grows."""
    return [a - b for a, b in pairwise(state[len(line.masses) :])]


def closing_speed(line: Row, state: Sequence[float], contact: int) -> float:
    """How fast the overlap of a contact grows."""
    left = len(line.masses) + contact
    return state[left] - state[left + 1]


def on_clock(clock: Clock, state: Sequence[float]) -> list[float]:
    """What the clock does not show: (overlaps, velocities), the time in the place of the clock's own overlap."""
    y = list(state[1:])
    if clock.contact is not None:
        y[clock.contact] = state[0]
    return y


def in_time(clock: Clock, w: float, y: Sequence[float]) -> list[float]:
    """The state, when the clock shows w."""
    if clock.contact is None:
        return [w, *y]
    state = [y[clock.contact], *y]
    state[1 + clock.contact] = clock.overlap(w)
    return state


@dataclass(frozen=True, slots=True)
class Form:
    """What the text of a law depends on; the numbers are filled in later."""

    exponents: tuple[float, ...]
    damped: bool
    heavy: bool
    clock: Clock
    pushes: bool


def law_of_motion(line: Row, touching: Sequence[bool], clock: Clock = TIME) -> Slope:
    """The rate of change of (overlaps, velocities) on a clock; only contacts that touch push."""
    pushes = clock.contact is not None and touching[clock.contact]
    damped = any(c.eta > 0.0 for c in line.contacts)
    fill_in = _law(Form(tuple(c.q for c in line.contacts), damped, line.weight != 0.0, clock, pushes))
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
    contacts, bodies, clock = range(len(form.exponents)), range(len(form.exponents) + 1), form.clock
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
    if clock.contact is not None:
        lines.append(f"        s = {_stretch(clock)} / r{clock.contact}")
        rates = [f"s * ({rate})" for rate in rates]
        rates[clock.contact] = "s"
    return "\n".join(
        ["def fill_in(k, e, i, g):", *lines, f"        return ({', '.join(rates)})", "    return slope"]
    )


def _push(form: Form, j: int) -> str:
    if form.clock.contact == j:
        spring = f"k{j} * {power_text('w', form.exponents[j] * form.clock.power)}" if form.pushes else "0.0"
        return spring + (f" + e{j} * r{j}" if form.damped else "")
    spring = f"k{j} * {power_text(f'd{j}', form.exponents[j])}"
    return (
        f"{spring} + e{j} * r{j} if d{j} >= 0.0 else 0.0"
        if form.damped
        else f"{spring} if d{j} > 0.0 else 0.0"
    )


def _stretch(clock: Clock) -> str:
    return f"{float(clock.power)} * {power_text('w', clock.power - 1.0)}"


def power_text(base: str, exponent: float) -> str:
    """A power in the fewest operations: products and a root where these do."""
    whole = math.floor(exponent + 1e-12)
    if whole <= 6 and abs(exponent - whole) < 1e-12:
        return " * ".join([base] * whole) or "1.0"
    if whole <= 4 and exponent - whole == 0.5:
        return " * ".join([base] * whole + [f"sqrt({base})"])
    return f"{base} ** {exponent!r}"


def _names(letter: str, places: range) -> str:
    return "".join(f"{letter}{i}, " for i in places)
