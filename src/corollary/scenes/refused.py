"""What a scene refuses before anything of it is followed: bodies and forces that are none, or that do not fit together."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import fields, is_dataclass
from functools import lru_cache
from itertools import combinations
from typing import Any, Protocol, cast

from corollary.scenes.body import Body
from corollary.scenes.run import BadSetting, GuardFailed, NoForce
from corollary.scenes.sound import HOUSE, PAIRS, finite, refuse_unsound, short_text, size_of, whole

WRITTEN_WRONG = (
    AssertionError,
    AttributeError,
    LookupError,
    NameError,
    RuntimeError,
    StopIteration,
    TypeError,
)
"""What a Python function raises that was written wrong, wherever it is asked."""
OWN_FAILS = (*WRITTEN_WRONG, ArithmeticError, ValueError)
"""What a Python function of somebody's own may raise where it is wrong."""

LARGEST_RADIUS = 1e150


class Parts(Protocol):
    """A scene, of which this module knows no more than its fields: scenes ask for it."""

    @property
    def name(self) -> str: ...
    @property
    def axes(self) -> int: ...
    @property
    def bodies(self) -> tuple[Body, ...]: ...
    @property
    def forces(self) -> tuple[Any, ...]: ...
    @property
    def until(self) -> float | None: ...
    @property
    def passes(self) -> tuple[tuple[int, int], ...]: ...


def refuse_parts(scene: Parts, force: type) -> None:
    """Raises BadSetting for bodies that cannot be, for what is no `force`, and for a time that does not come."""
    name = scene.name
    for what, given, kind in (("bodies", scene.bodies, Body), ("forces", scene.forces, force)):
        if type(given) is not tuple or not all(kind in type(each).__mro__ for each in given):
            raise BadSetting(
                f"{name}: {what} must be a tuple, everything in it a {kind.__name__}: (one,) with its comma, or (one, another)."
            )
    for i, body in enumerate(scene.bodies):
        refuse_unsound(name, body)
        _refuse_body(name, body, body.name or f"body {i}")
    for each in scene.forces:
        _refuse_values(name, each)
    are_pairs, rule = PAIRS
    if scene.passes != () and not are_pairs(scene.passes):
        raise BadSetting(f"{name}: passes = {short_text(scene.passes)}: {rule}.")
    if scene.until is not None and not (finite(scene.until) and scene.until > 0.0):
        raise BadSetting(f"{name}: until = {short_text(scene.until)} s must be more than zero, and finite.")


def _refuse_body(scene: str, body: Body, called: str) -> None:
    """Raises BadSetting for numbers that no body has."""
    if not body.mass > 0.0:
        raise BadSetting(f"{scene}: a body needs a mass above zero, but {called} has {body.mass:g} kg.")
    if body.radius < 0.0:
        raise BadSetting(
            f"{scene}: a body needs a radius of zero or more, but {called} has {body.radius:g} m."
        )
    if body.radius > LARGEST_RADIUS:
        raise BadSetting(
            f"{scene}: {called} has a radius of {body.radius:g} m, whose square no double holds; choose another unit, or a smaller one."
        )
    if body.inertia is not None and not body.inertia > 0.0:
        raise BadSetting(f"{scene}: an inertia must be above zero, but {called} has {body.inertia:g} kg m^2.")
    if body.spin and len(body.place) == 1:
        raise BadSetting(
            f"{scene}: {called} has a spin, but on a line (places of one component) nothing turns; "
            "leave it out, or give places and velocities two components."
        )
    if body.spin and not body.radius and body.inertia is None:
        raise BadSetting(f"{scene}: {called} has a spin, but it is a point: give it a radius or an inertia.")


def refuse_misfits(scene: Parts, start: Sequence[float]) -> None:
    """Raises BadSetting where forces do not fit the bodies; `start` is the state at the start."""
    name, count = scene.name, len(scene.bodies)
    for force in scene.forces:
        if any(not whole(i) or not 0 <= i < count for i in force.bodies):
            raise BadSetting(
                f"{name}: {force} names a body that is not there; they are counted from 0, in whole numbers."
            )
        force.fits(scene)
        if is_own(force):
            refuse_own(scene, force, start)
    if any(not 0 <= i < count for pair in scene.passes for i in pair):
        raise BadSetting(f"{name}: passes = {scene.passes} names a body that is not there.")
    _refuse_burnt(scene)
    _refuse_walls_that_meet(scene)


@lru_cache
def _own(kind: type) -> bool:
    return not kind.__module__.startswith(HOUSE)


def is_own(force: object) -> bool:
    """Whether it is of a class that somebody else wrote."""
    return _own(type(force))


def _refuse_values(scene: str, force: object) -> None:
    refuse_unsound(scene, force)
    for each in fields(force) if is_own(force) and is_dataclass(force) else ():
        value: object = getattr(force, each.name)
        numbers = cast("tuple[object, ...]", value) if isinstance(value, tuple) else (value,)
        if any(isinstance(x, float) and math.isnan(x) for x in numbers):
            raise BadSetting(
                f"{scene}: {type(force).__name__} with {each.name} = {short_text(value)}: that is no number."
            )
    try:
        hash(force)
    except TypeError:
        raise BadSetting(
            f"{scene}: {type(force).__name__} cannot be hashed: write @dataclass(frozen=True), and tuples instead of lists in it."
        ) from None


def refuse_own(scene: Parts, force: Any, start: Sequence[float]) -> None:
    """Raises BadSetting where a force of somebody's own is none at the start."""
    masses = [body.mass for body in scene.bodies]
    whose = f"{scene.name}: {type(force).__name__}"
    try:
        for i, newtons in force.act_at(scene, 0.0, start, masses, start):
            if not whole(i) or not 0 <= i < len(masses):
                raise BadSetting(f"{whose} acts on body {short_text(i)}, which is not there.")
            if not math.isfinite(size_of(newtons, scene.axes, whose, 0.0)):
                raise BadSetting(
                    f"{whose} gives {short_text(newtons)} at the start; it must be finite there."
                )
        stored = force.potential(scene, start)
    except BadSetting:
        raise
    except (GuardFailed, NoForce) as error:
        raise BadSetting(str(error)) from error.__cause__  # what the function itself raised, if it did
    except OWN_FAILS as error:
        raise BadSetting(
            f"{whose} fails at the start ({type(error).__name__}: {error}); mend it, or start elsewhere."
        ) from error
    if not finite(stored):
        raise BadSetting(
            f"{whose} has the potential {short_text(stored)} at the start; it must be a finite number."
        )


def failing(whose: str, time: float, error: Exception) -> str:
    """The sentence about a function of somebody's own that raised something on the way."""
    return f"{whose} fails at {time:.6g} s ({type(error).__name__}: {error}); mend it, or watch for a shorter time."


def _refuse_burnt(scene: Parts) -> None:
    rates: dict[int, float] = {}
    for force in scene.forces:
        for i, rate in force.mass_rates:
            rates[i] = rates.get(i, 0.0) + rate
    for i, rate in rates.items():
        mass = scene.bodies[i].mass
        if scene.until is not None and mass + rate * scene.until <= 0.0:
            raise BadSetting(
                f"{scene.name}: body {i} burns {-rate:g} kg/s of its {mass:g} kg, so that nothing is left at until = {scene.until:g} s; "
                "watch for a shorter time."
            )


def _refuse_walls_that_meet(scene: Parts) -> None:
    """Raises BadSetting where two bodies that nothing moves would run into each other before the end."""
    walls = [(i, body) for i, body in enumerate(scene.bodies) if math.isinf(body.mass)]
    passing = {(min(pair), max(pair)) for pair in scene.passes}
    for (i, a), (j, b) in combinations(walls, 2):
        reach = (a.radius + b.radius) * (1.0 - 1e-9)
        if scene.until is None or not reach or (i, j) in passing or not math.dist(a.place, b.place) > reach:
            continue
        apart = [y - x for x, y in zip(a.place, b.place, strict=True)]
        relative = [v - u for u, v in zip(a.velocity, b.velocity, strict=True)]
        square, nearing = (
            sum(v * v for v in relative),
            -sum(x * v for x, v in zip(apart, relative, strict=True)),
        )
        nearest = min(nearing / square, scene.until) if square else 0.0
        if (
            nearing > 0.0
            and math.hypot(*(x + v * nearest for x, v in zip(apart, relative, strict=True))) < reach
        ):
            raise BadSetting(
                f"{scene.name}: {a.name or f'body {i}'} and {b.name or f'body {j}'}, which nothing moves, run into each other before "
                f"until = {scene.until:g} s; watch for a shorter time, give them other velocities, or name them in passes=…."
            )
