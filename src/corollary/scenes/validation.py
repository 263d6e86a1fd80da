"""Validation of a scene as it is made: fields, bodies, forces that fit, and kinds of scenes that are not followed."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import fields, is_dataclass
from functools import lru_cache
from itertools import combinations, pairwise
from numbers import Integral, Real
from reprlib import Repr
from typing import Any, Protocol, cast

from corollary.scenes.body import Body, Constraint, Rub
from corollary.scenes.run import BadSetting, GuardFailed, NoForce

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
    _refuse_driven(scene)


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
                f"{scene}: {type(force).__name__} with {each.name} = {short_text(value)}: that is not a number."
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
            f"{whose} fails at the start ({type(error).__name__}: {error}); correct it, or change the initial state."
        ) from error
    if not finite(stored):
        raise BadSetting(
            f"{whose} has the potential {short_text(stored)} at the start; it must be a finite number."
        )


def failing(whose: str, time: float, error: Exception) -> str:
    """The sentence about a function of somebody's own that raised something on the way."""
    return f"{whose} fails at {time:.6g} s ({type(error).__name__}: {error}); correct it, or end the run earlier (until=…)."


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


def _refuse_driven(scene: Parts) -> None:
    """Raises BadSetting where bodies that nothing moves would not keep their distance: what becomes of them when they meet is open."""
    walls = [(body.name or f"body {i}", body) for i, body in enumerate(scene.bodies) if math.isinf(body.mass)]
    for (called, a), (other, b) in pairwise(walls):
        if a.velocity != b.velocity:
            raise BadSetting(
                f"{scene.name}: {called} and {other} have no end of mass and different velocities: such bodies are not followed; give them one "
                "velocity, or one of them a mass."
            )


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
                f"{scene.name}: {type(force).__name__} fails at the start ({type(error).__name__}: {error}); correct it."
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
