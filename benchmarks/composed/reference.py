"""References for composed scenes by a method of their own: extrapolated midpoint steps (Gragg, Bulirsch, Stoer) in 64 binary digits.

Nothing here is shared with what is judged: steps in coordinates chosen for the scene, each extrapolated from nine subdivisions
and taken shorter where the last two disagree; an event is located by taking the last step again, to a shorter time, until its function vanishes.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

L = np.longdouble
COUNTS = tuple(range(2, 20, 2))
CLOSE = 1e-17
Slope = Callable[[Any, Any, Any], Sequence[Any]]
Watched = Callable[[Any, Any, Any], Any]
Act = Callable[[Any, Any, Any], tuple[Any, Any]]


def numbers(*values: Any) -> Any:
    """A state."""
    return np.array([L(v) for v in values], dtype=L)


def stepped(f: Slope, t: Any, y: Any, h: Any, flags: Any) -> tuple[Any, Any]:
    """One step: the midpoint rule in each of `COUNTS` parts, extrapolated in the square of their length; and what the last part changed."""
    rows: list[Any] = []
    for i, n in enumerate(COUNTS):
        part = h / n
        before, now = y, y + part * numbers(*f(t, y, flags))
        for k in range(1, n):
            before, now = now, before + 2 * part * numbers(*f(t + k * part, now, flags))
        row = [now]
        for j in range(1, i + 1):
            ratio = (L(n) / COUNTS[i - j]) ** 2
            row.append(row[-1] + (row[-1] - rows[-1][j - 1]) / (ratio - 1))
        rows.append(row)
    return rows[-1][-1], np.abs(rows[-1][-1] - rows[-1][-2])


def follow(
    f: Slope,
    y: Sequence[Any],
    until: Any,
    events: Sequence[tuple[Watched, Act]] = (),
    flags: Any = None,
    h: float = 0.02,
) -> Any:
    """The state at `until`; where a watched value falls from above zero to it, its act gives the state and flags to go on with."""
    t, until, y = L(0), L(until), numbers(*y)
    span = L(h)
    while t < until:
        span = min(4 * span, L(h), until - t)
        new, changed = stepped(f, t, y, span, flags)
        # A step too coarse (a slip that all but stops), or one in which what stood at zero rose and fell.
        while span > 1e-9 and (
            not np.all(changed <= CLOSE * (1 + np.abs(new)))
            or any(watch(t, y, flags) <= 0 and watch(t + span, new, flags) < 0 for watch, _ in events)
        ):
            span /= 4
            new, changed = stepped(f, t, y, span, flags)
        first: tuple[Any, Any, Act] | None = None
        for watch, act in events:
            if watch(t, y, flags) > 0 and watch(t + span, new, flags) <= 0:
                low, high = L(0), span
                above, below = watch(t, y, flags), watch(t + span, new, flags)
                for _ in range(80):
                    middle = low + (high - low) * above / (above - below)
                    if not low < middle < high:
                        break
                    there = watch(t + middle, stepped(f, t, y, middle, flags)[0], flags)
                    if there > 0:
                        low, above, below = middle, there, below / 2
                    else:
                        high, below, above = middle, there, above / 2
                    if high - low < 1e-18 * max(t, span) or there == 0:
                        break
                if first is None or high < first[0]:
                    first = high, stepped(f, t, y, high, flags)[0], act
        if first is None:
            t, y = t + span, new
        else:
            t += first[0]
            y, flags = first[2](t, first[1], flags)
    return y


def sliding(
    masses: Sequence[float],
    kinetic: Sequence[float],
    static: Sequence[float],
    force: Callable[[Any, Any, Any], Sequence[Any]],
    x: Sequence[float],
    v: Sequence[float],
    until: float,
    belts: Sequence[float] | None = None,
    h: float = 0.01,
) -> tuple[Any, Any]:
    """Places and velocities of blocks on a line; `kinetic` and `static` are the largest forces of friction (N)."""
    n = len(masses)
    belts = belts or (0.0,) * n
    speed = [L(u) - b for u, b in zip(v, belts, strict=True)]

    def settled(t: Any, x: Any, v: Any, i: int) -> int:
        push = force(t, x, v)[i]
        return 0 if abs(push) <= static[i] else int(np.sign(push))

    slips = [
        int(np.sign(u)) if u else settled(L(0), numbers(*x), numbers(*v), i) for i, u in enumerate(speed)
    ]

    def f(t: Any, y: Any, flags: Any) -> Any:
        pushes = force(t, y[:n], y[n:])
        rates = [
            (pushes[i] - flags[i] * kinetic[i]) / masses[i] if flags[i] or not static[i] else L(0)
            for i in range(n)
        ]
        return [*y[n:], *rates]

    def stops(i: int) -> tuple[Watched, Act]:
        def act(t: Any, y: Any, flags: Any) -> tuple[Any, Any]:
            y = y.copy()
            y[n + i] = belts[i]
            new = settled(t, y[:n], y[n:], i)
            return y, (*flags[:i], new, *flags[i + 1 :])

        return (lambda t, y, flags: flags[i] * (y[n + i] - belts[i]) if flags[i] else L(1)), act

    def breaks(i: int) -> tuple[Watched, Act]:
        def act(t: Any, y: Any, flags: Any) -> tuple[Any, Any]:
            return y, (*flags[:i], int(np.sign(force(t, y[:n], y[n:])[i])), *flags[i + 1 :])

        return (lambda t, y, flags: static[i] - abs(force(t, y[:n], y[n:])[i]) if not flags[i] else L(1)), act

    rough = [i for i in range(n) if static[i]]
    events = [each(i) for i in rough for each in (stops, breaks)]
    flags = tuple(s if static[i] else 1 for i, s in enumerate(slips))
    y = follow(f, (*x, *v), until, events, flags, h)
    return y[:n], y[n:]
