"""Fixed-step methods as tables of coefficients, and the one loop that runs them and counts each force it asks for.

Euler-Cromer and RK4; more of them race each other in corollary/trade/methods.py.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from itertools import islice
from typing import assert_never

from corollary.scenes.integrate.runge_kutta import Coefficients, Tableau, step


@dataclass(frozen=True, slots=True)
class Splitting:
    """Kicks (v += kick dt a) and drifts (x += drift dt v) in turn, a kick first.

    A kick of zero costs nothing; `order` is the one for smooth forces that depend on places only.
    """

    order: int
    kicks: tuple[float, ...]
    drifts: tuple[float, ...]


EULER_CROMER = Splitting(1, (1.0,), (1.0,))

# The method of a usual mistake: the position is stepped with the old velocity; nobody should choose it.
EULER = Tableau(order=1, nodes=(0.0,), rows=(Coefficients((), ()),), result=Coefficients((0,), (1.0,)))

RK4 = Tableau(
    order=4,
    nodes=(0.0, 0.5, 0.5, 1.0),
    rows=(
        Coefficients((), ()),
        Coefficients((0,), (0.5,)),
        Coefficients((1,), (0.5,)),
        Coefficients((2,), (1.0,)),
    ),
    result=Coefficients((0, 1, 2, 3), (1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0)),
)

Method = Splitting | Tableau

Places = Sequence[float]
Acceleration = Callable[[Places, Places], Sequence[float]]


@dataclass(frozen=True, slots=True)
class Path:
    """Times, and places and velocities at each of them (one row a time); `evaluations` of the force were paid."""

    times: tuple[float, ...]
    places: tuple[tuple[float, ...], ...]
    velocities: tuple[tuple[float, ...], ...]
    evaluations: int


def march(method: Method, acceleration: Acceleration, x: Places, v: Places, dt: float, steps: int) -> Path:
    """Run a method for a number of steps of dt; `acceleration(x, v)` gives one number for each of x (m/s^2)."""
    spent = 0

    def counted(x: Places, v: Places) -> Sequence[float]:
        nonlocal spent
        spent += 1
        return acceleration(x, v)

    rows = [(tuple(x), tuple(v))]
    for places, velocities in islice(states(method, counted, list(x), list(v), dt), steps):
        rows.append((tuple(places), tuple(velocities)))
    return Path(
        tuple(i * dt for i in range(steps + 1)), tuple(x for x, _ in rows), tuple(v for _, v in rows), spent
    )


def states(
    method: Method, acceleration: Acceleration, x: list[float], v: list[float], dt: float
) -> Iterator[tuple[list[float], list[float]]]:
    """Places and velocities after one step, after two, and so on, for ever."""
    match method:
        case Splitting():
            yield from _split(method, acceleration, x, v, dt)
        case Tableau():
            yield from _staged(method, acceleration, x, v, dt)
        case _:
            assert_never(method)


def _split(
    method: Splitting, acceleration: Acceleration, x: list[float], v: list[float], dt: float
) -> Iterator[tuple[list[float], list[float]]]:
    """A force at a place already visited is not paid twice: the last kick of a step and the first of the next share it."""
    known: Sequence[float] | None = None
    while True:
        for kick, drift in zip(method.kicks, method.drifts, strict=True):
            if kick:
                a = known if known is not None else acceleration(x, v)
                v = [speed + kick * dt * gain for speed, gain in zip(v, a, strict=True)]
                known = a
            if drift:
                x = [place + drift * dt * speed for place, speed in zip(x, v, strict=True)]
                known = None
        yield x, v


def _staged(
    method: Tableau, acceleration: Acceleration, x: list[float], v: list[float], dt: float
) -> Iterator[tuple[list[float], list[float]]]:
    n = len(x)

    def slope(_: float, state: Sequence[float]) -> list[float]:
        return [*state[n:], *acceleration(state[:n], state[n:])]

    state = [*x, *v]
    while True:
        state, _ = step(method, slope, 0.0, state, dt, slope(0.0, state))
        yield state[:n], state[n:]
