"""References of the families with contacts, in 64 binary digits, by a method that shares nothing with those it judges.

Extrapolated midpoint steps in plain time that shrink geometrically toward every opening and closing, where a force is not smooth; all
draws at once. Run as a script it writes `references.json`; a test finds it again, and the published velocities of the equal cradle.
"""

from __future__ import annotations

import json
import sys
from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

if __name__ == "__main__":
    sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

from trade.study import contacts

COLUMNS = (2, 4, 6, 8, 10, 12)
TINY, FIRST = 1e-15, 1e-11
POINTS, MOST_STEPS = 8, 1_500
L = np.longdouble
Array = Any


def extrapolated(slope: Callable[[Array], Array], state: Array, h: Array) -> Array:
    """One step of order 12, of its own length for each draw."""
    table: list[list[Array]] = []
    for k, n in enumerate(COLUMNS):
        step = h / n
        old, here = state, state + step * slope(state)
        for _ in range(n - 1):
            old, here = here, old + 2 * step * slope(here)
        made = [(old + here + step * slope(here)) / 2]
        for j in range(1, k + 1):
            ratio = (L(n) / COLUMNS[k - j]) ** 2 - 1
            made.append(made[-1] + (made[-1] - table[-1][j - 1]) / ratio)
        table.append(made)
    return table[-1][-1]


def follow(
    slope: Callable[[Array, Array], Array],
    overlaps: Callable[[Array], tuple[Array, Array]],
    state: Array,
    times: Array | None,
) -> tuple[Array, Array, Array]:
    """From the first touch until nothing touches and nothing will: when that is, the states at `times`, the last states.

    `overlaps(state)` gives the overlaps and how fast they grow, each row a pair of bodies; lengths and times are of the order of one.
    """
    deep, _ = overlaps(state)
    touching, draws = np.ones(deep.shape, bool), state.shape[1]
    time, h, open_ = np.zeros(draws, L), np.full(draws, L(FIRST)), np.ones(draws, bool)
    seen = [] if times is None else [np.zeros_like(state) for _ in times]
    ahead = np.zeros(draws, int)
    for _ in range(MOST_STEPS):
        if not open_.any():
            return time, np.array(seen), state
        if times is not None:
            left = np.where(
                ahead < len(times), times[np.minimum(ahead, len(times) - 1), np.arange(draws)], L(np.inf)
            )
            lands = left <= time + h
            h = np.where(lands, left - time, h)
        h = np.where(open_, h, L(0))
        state, time = extrapolated(partial(_held, slope, touching), state, h), time + h
        if times is not None:
            for i in np.flatnonzero(lands & open_):
                seen[ahead[i]][:, i] = state[:, i]
            time, ahead = np.where(lands & open_, left, time), ahead + (lands & open_)
        d, u = overlaps(state)
        touching = np.where(touching, ~((d < TINY) & (u < 0)), (d > -TINY) & (u > 0))
        coming = (touching & (d > TINY)) | (~touching & (u > TINY))
        open_ = coming.any(axis=0) | (False if times is None else ahead < len(times))
        with np.errstate(divide="ignore", invalid="ignore"):
            near = np.abs(d / u) / 5
        begins = touching & (u > 0) & (d < FIRST)
        matters = (np.abs(d) > TINY) & (u != 0) & (touching | (u > 0))
        near = np.where(np.isfinite(near), near, L(1))
        limits = np.where(begins, np.maximum(L(FIRST), near), np.where(matters, near, L(1)))
        h = np.minimum(limits.min(axis=0), L("0.05"))
    raise RuntimeError(f"A draw does not end: {time}, {h}, {d}, {u}, {touching}")


def _held(slope: Callable[[Array, Array], Array], touching: Array, state: Array) -> Array:
    """The right side within a step: which pairs touch is that of its start."""
    return slope(state, touching)


def hertz(deep: Array, on: Array) -> Array:
    pressed = np.where(on, np.maximum(deep, 0), 0)
    return pressed * np.sqrt(pressed)


def rows(all_masses: Sequence[Sequence[float]]) -> list[dict[str, object]]:
    """Masses in units of 0.1 kg, lengths and times such that stiffness and speed are one."""
    masses = np.array([[L(str(m)) * 10 for m in masses] for masses in all_masses]).T
    long = (L("0.1") / L(contacts.STIFFNESS)) ** L("0.4")

    def slope(y: Array, touching: Array) -> Array:
        f = hertz(y[:2] - y[1:3], touching)
        return np.concatenate([y[3:], np.stack([-f[0], f[0] - f[1], f[1]]) / masses])

    def overlaps(y: Array) -> tuple[Array, Array]:
        return y[:2] - y[1:3], y[3:5] - y[4:6]

    start = np.zeros((6, len(all_masses)), L)
    start[3] = 1
    lasts, _, _ = follow(slope, overlaps, start, None)
    until = np.array([L(f"{float(t):.6g}") for t in lasts * long * L("1.1")])
    times = np.array([until * i / POINTS for i in range(1, POINTS + 1)])
    _, seen, last = follow(slope, overlaps, start, times / long)
    return [
        written(until[i], times[:, i], seen[:, :3, i] * long, last[3:, i]) for i in range(len(all_masses))
    ]


def spheres(all_drawn: Sequence[dict[str, float]]) -> list[dict[str, object]]:
    """B seen from A, in units of the depth of a head-on contact; before and after the contact both fly straight."""
    ma, mb, aside, eta = (
        np.array([L(str(d[name])) for d in all_drawn]) for name in ("ma", "mb", "aside", "eta")
    )
    reach, mass = L(str(contacts.SIZE)), ma * mb / (ma + mb)
    long = (mass / (2 * L(contacts.STIFFNESS))) ** L("0.4")
    r, drag = reach / long, eta * long / mass

    def slope(y: Array, touching: Array) -> Array:
        distance = np.hypot(y[0], y[1])
        push = hertz(r - distance, touching[0]) / distance
        return np.concatenate([y[2:], push * y[:2] - np.where(touching[0], drag, 0) * y[2:]])

    def overlaps(y: Array) -> tuple[Array, Array]:
        distance = np.hypot(y[0], y[1])
        return (r - distance)[None], (-(y[0] * y[2] + y[1] * y[3]) / distance)[None]

    far = np.sqrt((1 - aside) * (1 + aside)) * r
    start = np.stack([far, aside * r, -np.ones_like(r), np.zeros_like(r)])
    meet = 2 * reach - far * long
    lasts, _, _ = follow(slope, overlaps, start, None)
    until = np.array([L(f"{float(t):.6g}") for t in meet + L("1.5") * lasts * long])
    times = np.array([meet + (until - meet) * i / POINTS for i in range(1, POINTS + 1)])
    _, seen, last = follow(slope, overlaps, start, (times - meet) / long)
    a, b = mb / (ma + mb), ma / (ma + mb)
    found = []
    for i in range(len(all_drawn)):
        apart = seen[:, :2, i] * long[i]
        centre = np.stack(
            [b[i] * times[:, i] + a[i] * 2 * reach, np.full(POINTS, a[i] * aside[i] * reach)], axis=1
        )
        places = np.concatenate([centre - a[i] * apart, centre + b[i] * apart], axis=1)
        w = last[2:, i]
        velocities = [b[i] - a[i] * w[0], -a[i] * w[1], b[i] + b[i] * w[0], b[i] * w[1]]
        found.append(written(until[i], times[:, i], places, velocities))
    return found


def written(until: Array, times: Array, places: Array, velocities: Array) -> dict[str, object]:
    digits = lambda x: np.format_float_scientific(x, precision=17, trim="-")  # noqa: E731
    return {
        "until": digits(until),
        "times": [digits(t) for t in times],
        "places": [[digits(x) for x in row] for row in places],
        "velocities": [digits(v) for v in velocities],
    }


def main(count: int = 20) -> None:
    draws = range(count)
    found = {
        "row": rows([contacts.masses_of(i) for i in draws]),
        "spheres": spheres([contacts.spheres_of(i) for i in draws]),
    }
    contacts.REFERENCES.write_text(json.dumps(found, indent=0) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
