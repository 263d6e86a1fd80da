"""Which way surfaces in a plane begin to slip when what holds bodies together leaves the ways of each to all others.

Friction under known pressing forces takes as much energy as it can: of all accelerations the bodies have the one that makes Gauss's
constraint plus what friction takes least (J. J. Moreau, in Nonsmooth Mechanics and Applications, 1988), a convex problem with one answer.
"""

# pyright: reportUnknownArgumentType=false, reportUnknownMemberType=false, reportUnknownVariableType=false

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import product

import numpy as np

from corollary.scenes.motion.complementarity import settled
from corollary.scenes.motion.multipliers import Array, Item, Status, answer
from corollary.scenes.run import GuardFailed

# Friction is rounded off for accelerations below such parts of the largest, smaller and smaller ones; what is not well above the last sticks.
FIRST, LAST, LESS, ABOVE = 1.0, 1e-13, 0.1, 30.0
NEWTON = 60
# So often the ways of slips are turned one after the other.
TURNS = 50


Found = tuple[Sequence[Item], tuple[Status, ...]]


def beginning(items: Sequence[Item], loose: Sequence[bool], inverse: Array, where: str) -> Found:
    """The statuses of items, and these with the ways in which they begin to slip; `loose` are rubs that do not slip, or are just to begin.

    Raises GuardFailed where nothing is consistent.
    """
    try:
        return _turning(items, loose, inverse, where)
    except GuardFailed:
        if (found := _least_of_all(items, loose, inverse, where)) is not None:
            return found
    # What holds a body may pull it another way than what acts on it alone.
    return _turning(_redirected(items, inverse), loose, inverse, where)


def _turning(items: Sequence[Item], loose: Sequence[bool], inverse: Array, where: str) -> Found:
    """What is settled when slips begin the way the bodies take."""
    statuses = settled(items, inverse, where)
    for _ in range(TURNS):
        again = _turned(items, statuses, loose, inverse)
        if again is None:
            return items, statuses
        items, statuses = again, settled(again, inverse, where)
    raise GuardFailed(f"{where}: no direction in which {items[-1].name} begins to slip was found.")


def _redirected(items: Sequence[Item], inverse: Array) -> list[Item]:
    """The same, but slips of two components that may begin do so the way the bodies would go if nothing rubbed."""
    alone = answer(items, ["off" if item.rub else item.may[0] for item in items], inverse)
    found: list[Item] = []
    for item, way in zip(items, alone.left, strict=True):
        size = float(np.linalg.norm(way))
        if item.rub and len(way) == 2 and item.may[0] == "stick" and size:
            off: tuple[Status, ...] = ("off",) if "off" in item.may else ()
            item = replace(item, may=("stick", tuple((way / size).tolist()), *off))
        found.append(item)
    return found


def _turned(
    items: Sequence[Item], statuses: Sequence[Status], loose: Sequence[bool], inverse: Array
) -> list[Item] | None:
    """Where a slip of two components begins from rest: the direction the body really takes, until it no longer changes."""
    found, changed, again = answer(items, statuses, inverse), False, list(items)
    for j, (item, status) in enumerate(zip(items, statuses, strict=True)):
        if isinstance(status, tuple) and len(status) == 2 and loose[j]:
            way = found.left[j]
            size = float(np.linalg.norm(way))
            # Where friction all but balances the pull, what is left points nowhere.
            brakes = item.kinetic * item.given * item.yields(inverse)
            pulls = size > 1e-6 * max(float(np.linalg.norm(item.bias)), brakes)
            if pulls and float(np.abs(way / size - np.array(status)).max()) > 1e-9:
                new: Status = tuple((way / size).tolist())
                may = tuple(new if isinstance(each, tuple) else each for each in item.may)
                again[j], changed = replace(item, may=may), True
    return again if changed else None


def _least_of_all(items: Sequence[Item], loose: Sequence[bool], inverse: Array, where: str) -> Found | None:
    """The same by what takes least, for all ways at once; None where friction hangs on what presses, or nothing is found."""
    if any(item.pressed >= 0 for item in items):
        return None
    for held in product(*(item.may for item in items if not item.rub)):
        rigid = [item for item in items if not item.rub]
        on = [item for item, status in zip(rigid, held, strict=True) if status == "on"]
        rubs = [(item, free) for item, free in zip(items, loose, strict=True) if item.rub]
        ways = iter(_ways(on, rubs, inverse))
        states = iter(held)
        decided = [replace(item, may=(next(ways) if item.rub else next(states),)) for item in items]
        try:
            return decided, settled(decided, inverse, where)
        except GuardFailed:
            continue
    return None


def _ways(on: Sequence[Item], rubs: Sequence[tuple[Item, bool]], inverse: Array) -> list[Status]:
    """What each rub does: what slips can hold no more than kinetic friction, and slips on though static friction could hold it."""
    slips = [not free or "stick" not in item.may for item, free in rubs]
    while True:
        most = [
            item.given * (item.kinetic if s else item.static)
            for (item, _), s in zip(rubs, slips, strict=True)
        ]
        found = _least(on, rubs, most, inverse)
        now = [s or way != "stick" for s, way in zip(slips, found, strict=True)]
        if now == slips:
            return found
        slips = now


def _least(
    on: Sequence[Item], rubs: Sequence[tuple[Item, bool]], most: Sequence[float], inverse: Array
) -> list[Status]:
    """The statuses of all rubs if each can hold so much."""
    root = np.sqrt(inverse)
    pulls = np.zeros(len(inverse))
    parts: list[tuple[int, float, Array, Array]] = []
    for n, ((item, free), force) in enumerate(zip(rubs, most, strict=True)):
        rows = item.rows * root
        if free:
            parts.append((n, force, item.bias, rows))
        elif isinstance(item.may[0], tuple):
            pulls = pulls + force * (np.asarray(item.may[0]) @ rows)
    start, free_ways = np.zeros(len(inverse)), np.eye(len(inverse))
    if on:
        held = np.vstack([item.rows * root for item in on])
        start = -np.linalg.lstsq(held, np.concatenate([item.bias for item in on]), rcond=1e-12)[0]
        _, sizes, ways = np.linalg.svd(held)
        free_ways = ways[int((sizes > 1e-12 * sizes.max()).sum()) :].T
    fast = max((float(np.abs(bias).max()) for _, _, bias, _ in parts), default=0.0)
    fast = max([fast, *(force * float(np.square(rows).sum()) for _, force, _, rows in parts), 1e-300])
    y, small = np.zeros(free_ways.shape[1]), FIRST * fast

    def energy(y: Array) -> float:
        x = start + free_ways @ y
        took = sum(
            force * np.sqrt(np.square(bias + rows @ x).sum() + small**2) for _, force, bias, rows in parts
        )
        return float(0.5 * x @ x + pulls @ x + took)

    while True:
        for _ in range(NEWTON):
            x = start + free_ways @ y
            slope, bend = x + pulls, np.eye(len(x))
            for _, force, bias, rows in parts:
                w = bias + rows @ x
                size = float(np.sqrt(w @ w + small**2))
                slope = slope + force * (rows.T @ w) / size
                bend = bend + force * rows.T @ (np.eye(len(w)) - np.outer(w, w) / size**2) @ rows / size
            step = np.linalg.solve(free_ways.T @ bend @ free_ways, free_ways.T @ slope)
            part, now = 1.0, energy(y)
            while part > 1e-6 and energy(y - part * step) > now:
                part *= 0.5
            y = y - part * step
            if float(np.abs(step).max(initial=0.0)) <= 1e-3 * small / max(float(root.max()), 1e-300):
                break
        if small <= LAST * fast:
            break
        small = max(LESS * small, LAST * fast)
    x = start + free_ways @ y
    found: list[Status] = [item.may[0] for item, _ in rubs]
    for n, _, bias, rows in parts:
        w = bias + rows @ x
        size = float(np.linalg.norm(w))
        found[n] = tuple((w / size).tolist()) if size > ABOVE * small else "stick"
    return found
