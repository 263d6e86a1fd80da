"""Rows over the generalized velocity of a scene, and the spins in its state: all velocities come first, then all spins, if any."""

from __future__ import annotations

from collections.abc import Sequence

from corollary.scenes.constraint import State
from corollary.scenes.scene import Scene


def spin(scene: Scene, state: State, i: int) -> float:
    """The spin (rad/s) of a body; zero where nothing spins."""
    return state[2 * scene.axes * len(scene.bodies) + i] if scene.spins else 0.0


def unit_row(scene: Scene, i: int, direction: Sequence[float], spin: float = 0.0) -> list[float]:
    """A row over the generalized velocity: the velocity of one body along a direction, and its spin times an arm (m)."""
    count = len(scene.bodies)
    row = [0.0] * (count * (scene.axes + scene.spins))
    row[scene.axes * i : scene.axes * (i + 1)] = direction
    if scene.spins:
        row[scene.axes * count + i] = spin
    return row


def velocity_row(scene: Scene, i: int, axis: int) -> list[float]:
    """The row of one component of the velocity of a body."""
    return unit_row(scene, i, [float(axis == j) for j in range(scene.axes)])
