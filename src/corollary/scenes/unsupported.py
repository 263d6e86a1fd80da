"""Kinds of scenes that are not followed, each refused by its name as the scene is made."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import combinations
from typing import Any

from corollary.scenes.constraint import Constraint, Rub
from corollary.scenes.refused import OWN_FAILS, Parts
from corollary.scenes.run import BadSetting

ALIGNED = 1e-9
"""A cosine so near to 0 or 1 is that of walls that are square or parallel to each other."""


def refuse_unsupported(scene: Parts, start: Sequence[float]) -> None:
    """Raises BadSetting for several frictions on what moves together, and for hits at one moment whose order would matter."""
    held, rubs = list[Constraint](), list[Rub]()
    for force in scene.forces:
        try:
            own = list(force.constraints(scene))
            rubs += force.rubs(scene, own)
        except OWN_FAILS as error:
            if isinstance(error, BadSetting):
                raise
            raise BadSetting(
                f"{scene.name}: {type(force).__name__} fails at the start ({type(error).__name__}: {error}); mend it."
            ) from error
        held += own
    for group in _tied(scene, held):
        _refuse_frictions(scene, [rub for rub in rubs if rub.body in group])
        stops = [c for c in held if not c.two_sided and not group.isdisjoint(c.bodies)]
        for one, other in combinations(stops, 2):
            _refuse_order(scene, start, one, other)


def _tied(scene: Parts, held: Sequence[Constraint]) -> list[set[int]]:
    """The bodies that forces can move, in groups that rods and strings tie together."""
    groups = [{i} for i, body in enumerate(scene.bodies) if not math.isinf(body.mass)]
    for constraint in held:
        met = [group for group in groups if not group.isdisjoint(constraint.bodies)]
        groups = [group for group in groups if group not in met] + ([set[int]().union(*met)] if met else [])
    return groups


def _refuse_frictions(scene: Parts, rubs: Sequence[Rub]) -> None:
    rubbed = sorted({rub.body for rub in rubs})
    if len(rubbed) > 1:
        raise BadSetting(
            f"{scene.name}: rods or strings tie bodies {', '.join(map(str, rubbed))}, and friction acts on each of them: only one body of those "
            "that are tied may rub. Leave out the friction of the others."
        )
    if len(rubs) > 1:
        raise BadSetting(
            f"{scene.name}: several frictions act on body {rubbed[0]}, and how they share what they hold is open: one surface may rub a body. "
            "Leave out the others, or name the body in only=… of one wall."
        )


def _refuse_order(scene: Parts, start: Sequence[float], one: Constraint, other: Constraint) -> None:
    """Raises BadSetting where two hits at one moment, of which one gives back speed, would leave bodies otherwise in another order."""
    if not (one.restitution or other.restitution) or _apart(start, one, other):
        return
    kind = "strings that jerk in turn" if len(one.bodies) == len(other.bodies) == 2 else "hits at one moment"
    raise BadSetting(
        f"{scene.name}: {kind} with restitution are not followed: {one.name} and {other.name} may be hit together, and which is first would "
        "decide. Give both restitution=0, or let walls be at right angles, for one body that nothing ties."
    )


def _apart(start: Sequence[float], one: Constraint, other: Constraint) -> bool:
    """Whether two walls stop one body square to each other, or so that it cannot meet both at once."""
    if one.bodies != other.bodies or len(one.bodies) > 1:
        return False
    rows: list[Any] = [one.row(0.0, start), other.row(0.0, start)]
    cosine = abs(sum(x * z for x, z in zip(*rows, strict=True)))
    return cosine <= ALIGNED or cosine >= 1.0 - ALIGNED
