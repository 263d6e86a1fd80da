"""What the fields of bodies and forces must be: finite numbers, tuples, bodies that are counted; each refused by its name."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import fields, is_dataclass
from functools import lru_cache
from numbers import Integral, Real
from reprlib import Repr
from typing import Any

from corollary.scenes.run import BadSetting, GuardFailed

HOUSE = __name__.rpartition(".")[0] + "."
"""Modules of this package: what is defined elsewhere is somebody's own."""
Rule = tuple[Callable[[Any], bool], str]
"""Whether a value is right, and what it must be, in words that follow the name and the value."""


class _Short(Repr):
    """Python's short representation, which leaves what a person writes as it is and cuts what nobody would read."""

    def __init__(self) -> None:
        super().__init__()
        self.maxtuple = self.maxlist = self.maxdict = 12
        self.maxstring = self.maxother = 120

    def repr_int(self, x: int, level: int) -> str:
        """A whole number of more digits than a double tells is said by their number."""
        if abs(x) < 10**20:
            return repr(x)
        return f"(a whole number of {math.floor(math.log10(abs(x))) + 1} digits)"


short_text = _Short().repr
"""How a refused value is named: as Python writes it, and no longer than a sentence bears."""


def finite(number: object) -> bool:
    """Whether it is a real number that a double holds; True and False are none."""
    if isinstance(number, bool):
        return False
    try:
        return math.isfinite(number) and (type(number) is float or isinstance(number, Real))  # pyright: ignore[reportArgumentType]
    except (OverflowError, TypeError, ValueError):
        return False


def whole(number: object) -> bool:
    """Whether it is a whole number, as those are that bodies are counted with; True and False are none."""
    return not isinstance(number, bool) and (type(number) is int or isinstance(number, Integral))


def _row_of(of: Callable[[object], bool]) -> Callable[[Any], bool]:
    return lambda value: isinstance(value, tuple) and all(map(of, value))  # pyright: ignore[reportUnknownArgumentType]


def _ends(value: Any) -> bool:
    return _row_of(whole)(value) and len(value) == 2 and value[0] != value[1]


WEIGHS: Rule = (
    lambda value: finite(value) or (isinstance(value, Real) and value == math.inf),
    "it must be a number, or math.inf for what nothing moves",
)
"""Mass or moment of inertia."""
FUNCTION: Rule = callable, "it must be a function"
PAIRS: Rule = (
    _row_of(_ends),
    "it must be a tuple of pairs of different bodies, which are counted from 0: ((0, 1),), with its comma",
)
RULES: dict[str, Rule] = {
    "float": (finite, "it must be a finite number"),
    "int": (whole, "bodies are counted from 0, in whole numbers"),
    "str": (lambda value: isinstance(value, str), "it must be a text"),
    "tuple[float, ...]": (
        _row_of(finite),
        "it must be a tuple of finite numbers: (1.0, 2.0), or (1.0,) with its comma on a line",
    ),
    "tuple[int, int]": (
        _ends,
        "it must be a tuple of two different bodies, which are counted from 0, in whole numbers",
    ),
    "tuple[int, ...]": (
        _row_of(whole),
        "it must be a tuple of bodies, which are counted from 0, in whole numbers: (0,), with its comma",
    ),
    "tuple[tuple[int, int], ...]": PAIRS,
    "Field": FUNCTION,
    "Potential": FUNCTION,
}
"""By the type that a field is said to have."""


def _rules(kind: type[Any]) -> tuple[tuple[str, bool, Rule], ...]:
    """The fields of a class of this package, whether they may be left out, and what each must be."""
    found: list[tuple[str, bool, Rule]] = []
    for each in fields(kind):
        annotation, _, left_out = str(each.type).partition(" | ")
        rule = WEIGHS if each.name in ("mass", "inertia") else RULES.get(annotation)
        if rule is not None:
            found.append((each.name, left_out == "None", rule))
    return tuple(found)


@lru_cache
def _known(kind: type) -> tuple[tuple[str, bool, Rule], ...]:
    """The rules of the class of this package that it is, or comes from; none for what is somebody's own throughout."""
    known = next((k for k in kind.__mro__ if k.__module__.startswith(HOUSE) and is_dataclass(k)), None)
    return _rules(known) if known else ()


def refuse_unsound(scene: str, thing: object) -> None:
    """Raises BadSetting where a field of a body, or of a force of this package, is not what it must be."""
    for name, left_out, (right, rule) in _known(type(thing)):
        value = getattr(thing, name)
        if not (value is None and left_out) and not right(value):
            raise BadSetting(f"{scene}: {type(thing).__name__} with {name} = {short_text(value)}: {rule}.")


def refuse_below_zero(
    scene: str, thing: object, least: tuple[str, ...] = (), above: tuple[str, ...] = ()
) -> None:
    """Raises BadSetting where a field that must be at `least` zero is less, or one that must be `above` zero is not."""
    for name in (*least, *above):
        value = getattr(thing, name)
        if value < 0.0 or (name in above and not value):
            rule = "more than 0" if name in above else "at least 0"
            raise BadSetting(f"{scene}: {type(thing).__name__} with {name} = {value:g}: it must be {rule}.")


def refuse_components(scene: str, axes: int, thing: object, name: str) -> None:
    """Raises BadSetting where a row of a force has another number of components than the places of the bodies."""
    row = getattr(thing, name)
    if len(row) != axes:
        raise BadSetting(
            f"{scene}: {type(thing).__name__} with {name} = {row} has {len(row)} components, but places and velocities have {axes}."
        )


def size_of(newtons: Any, axes: int, whose: str, time: float) -> float:
    """The size of a force (N) given by its components. Raises GuardFailed where these are not so many real numbers."""
    try:
        size = math.hypot(*newtons) if len(newtons) == axes else None
    except (TypeError, OverflowError):
        size = None
    if size is not None:
        return size
    raise GuardFailed(
        f"{whose} gives {short_text(newtons)} at {time:.6g} s; it must give a tuple of {axes} real number{'s' * (axes > 1)}."
    )


def refuse_tolerance(name: str, tolerance: float, least: float = 1e-15, most: float = 0.1) -> None:
    """Raises BadSetting for a tolerance that no scene can hold."""
    if not (finite(tolerance) and least <= tolerance <= most):
        raise BadSetting(
            f"{name}: a tolerance of {short_text(tolerance)} cannot be held; ask for a tolerance between {least:g} and {most:g}."
        )
