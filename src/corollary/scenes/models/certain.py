"""Values worked out in ball arithmetic, with more and more digits until each is known to the last place of a double: proven bounds."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from contextlib import suppress
from dataclasses import dataclass, field
from fractions import Fraction
from typing import TYPE_CHECKING, TypeVar

from flint import acb, arb, ctx

from corollary.formula.ball import MOST_BITS, precision_of
from corollary.scenes.definition import SceneDefinition, Setting, Settings, numbers
from corollary.scenes.run import GuardFailed, Measurement, Model, Observed, Outcome, Run

if TYPE_CHECKING:
    from corollary.scenes.film import Film

Balls = arb | tuple[arb, ...]
ComplexBall = acb
T = TypeVar("T")

FIRST_BITS = 128
ENOUGH = 60  # bits: a double has 53
SPARE = 56  # bits that a quadrature need not find: those beyond a double, and some for what cancels later
# Where an integral needs more, its integrand spans so many powers of ten that no quadrature comes to an end.
MOST_BITS_OF_INTEGRALS, EVALUATIONS_A_BIT = 512, 48
# A component so much smaller than the longest one of its vector is a remainder: that of a head-on hit across its line.
REMAINDER = 400


class MoreDigits(ArithmeticError):
    """The working precision does not tell which of two cases holds."""


@dataclass(frozen=True, slots=True)
class Evaluated:
    """What closed forms give, in balls, and the model behind them; `by` names another model, and why, for some of the values."""

    outcome: Outcome
    values: Mapping[str, Balls]
    model: Model
    why: str
    by: Mapping[str, tuple[Model, str]] = field(default_factory=dict[str, tuple[Model, str]])
    warnings: tuple[str, ...] = ()


def found(compute: Callable[[], Evaluated]) -> Run:
    """The values as the doubles next to them, each with a proven bound. `compute` works at the precision that is set.

    Twice as many bits are tried each time. A value beyond the doubles is left out, and a warning says what it is. Raises GuardFailed
    when no precision decides what happens.
    """
    last = None
    for bits in _doubled():
        with precision_of(bits):
            try:
                last = compute()
            except MoreDigits:
                last = None
            if last is not None and all(_known(each, bits) for each in last.values.values()):
                break
    if last is None:
        raise GuardFailed(
            "These settings lie on the very edge between two outcomes; move one of them by a little."
        )
    measured: dict[str, Measurement] = {}
    warnings = list(last.warnings)
    for name, balls in last.values.items():
        model, why = last.by.get(name, (last.model, last.why))
        each = bounded(balls, model, why)
        if each is None:
            warnings.append(f"{name} is {_decimal(balls)}: beyond the numbers of a computer.")
        else:
            measured[name] = each
    return Run(measured, 0, last.outcome, tuple(warnings))


def by_formulas(
    meaning: str,
    settings: tuple[Setting, ...],
    evaluated: Callable[..., Evaluated],
    second_way: Callable[[Settings, float], Run | None] | None = None,
    film: Callable[[Settings], Film | None] | None = None,
) -> SceneDefinition:
    """A ready scene whose values are formulas: `evaluated` takes its settings (single numbers, exact balls) in their order.

    It may raise BadSetting.
    """

    def play(given: Settings, tolerance: float) -> Run:
        exact = balls(given, *(setting.name for setting in settings))
        return found(lambda: evaluated(*exact))

    return SceneDefinition(meaning, settings, play, second_way, film)


def _doubled() -> Iterator[int]:
    bits = FIRST_BITS
    while bits <= MOST_BITS:
        yield bits
        bits *= 2


def double_of(compute: Callable[[], arb]) -> float:
    """One number as the double next to it. Raises GuardFailed when no precision tells it, OverflowError when no double holds it."""

    def known() -> float:
        ball = compute()
        if not _known(ball, ctx.prec):
            raise MoreDigits
        return float(ball.mid())

    value = decided(known, "No precision tells this number; move one of the settings by a little.")
    if not math.isfinite(value):
        raise OverflowError
    return value


def decided(compute: Callable[[], T], refusal: str) -> T:
    """What `compute` gives at the first precision at which it does not raise MoreDigits. Raises GuardFailed when none is enough."""
    for bits in _doubled():
        with precision_of(bits), suppress(MoreDigits):
            return compute()
    raise GuardFailed(refusal)


def bounded(balls: Balls, model: Model, why: str) -> Measurement | None:
    """The doubles next to the balls' middles, and a bound on how far each is off; none where a double cannot hold one."""
    numbers = balls if isinstance(balls, tuple) else (balls,)
    near = tuple(float(each.mid()) + 0.0 for each in numbers)
    if not all(map(math.isfinite, near)):
        return None
    errors = tuple(_above(abs(ball - arb(x))) for ball, x in zip(numbers, near, strict=True))
    value: Observed = near if isinstance(balls, tuple) else near[0]
    error: Observed = errors if isinstance(balls, tuple) else errors[0]
    return Measurement(value, error, "bound", model, why, max(map(abs, (*near, *errors)), default=0.0))


def _above(distance: arb) -> float:
    if distance.is_zero():
        return 0.0
    return math.nextafter(float(distance.upper()), math.inf)


def _known(balls: Balls, bits: int) -> bool:
    numbers = balls if isinstance(balls, tuple) else (balls,)
    size = arb(0)
    for each in numbers:
        size = size.max(abs(each).mid())
    return all(
        each.is_finite()
        and (
            each.is_exact()
            or each.rel_accuracy_bits() >= ENOUGH
            or (bits >= 2 * REMAINDER and each.rad() < size * arb(2) ** -REMAINDER)
        )
        for each in numbers
    )


def _decimal(balls: Balls) -> str:
    numbers = balls if isinstance(balls, tuple) else (balls,)
    return ", ".join(each.str(6, radius=False) for each in numbers)


def balls(settings: Settings, *names: str) -> list[arb]:
    """Settings that are single numbers, exactly."""
    return list(map(arb, numbers(settings, *names)))


def sign(ball: arb) -> int:
    """-1, 0 or 1. Raises MoreDigits when the ball holds zero and more."""
    if ball > 0:
        return 1
    if ball < 0:
        return -1
    if ball.is_zero():
        return 0
    raise MoreDigits


def root(rising: Callable[[arb], arb], low: arb, high: arb) -> arb:
    """A ball about the one zero between `low` and `high` of a function that is below zero before it and above zero beyond it.

    Illinois's method, each side proven by its sign. Raises MoreDigits when the function does not change its sign there.
    """
    low, high = low.mid(), high.mid()
    below, above, side = rising(low), rising(high), 0
    if below.is_zero() or above.is_zero():
        return low if below.is_zero() else high
    if not (below < 0 < above):
        raise MoreDigits
    below, above = below.mid(), above.mid()
    fine = arb(2) ** (12 - ctx.prec)
    for _ in range(4 * ctx.prec):
        if high - low <= fine * abs(high):
            break
        middle = (low + (high - low) * below / (below - above)).mid()
        if not low < middle < high:
            middle = (0.5 * (low + high)).mid()
        here = rising(middle)
        if here > 0:
            high, above, below, side = middle, here.mid(), 0.5 * below if side > 0 else below, 1
        elif here < 0:
            low, below, above, side = middle, here.mid(), 0.5 * above if side < 0 else above, -1
        else:
            return _about(rising, middle, low, high)
    return low.union(high)


def _about(rising: Callable[[arb], arb], middle: arb, low: arb, high: arb) -> arb:
    """The zero is too near to `middle` for its sign there to be told: step away until it can be."""
    step = abs(middle) * arb(2) ** (4 - ctx.prec)
    for _ in range(ctx.prec // 4):
        left, right = (middle - step).mid(), (middle + step).mid()
        if not (low < left and right < high):
            break
        if rising(left) < 0 < rising(right):
            return left.union(right)
        step *= 16
    return low.union(high)


def integral(integrand: Callable[[acb, bool], acb], low: arb, high: arb) -> arb:
    """A rigorous quadrature. `integrand` takes whether it has to be analytic about the point, and is not finite where it is not."""
    with precision_of(min(ctx.prec, MOST_BITS_OF_INTEGRALS)):
        goal, least = arb(2) ** (SPARE - ctx.prec), arb(2) ** (-4 * MOST_BITS)
        most = EVALUATIONS_A_BIT * ctx.prec
        value = acb.integral(integrand, low, high, rel_tol=goal, abs_tol=least, eval_limit=most).real
        if value.is_finite() and value.rel_accuracy_bits() >= ENOUGH:
            return value
        if ctx.prec < MOST_BITS_OF_INTEGRALS:
            raise MoreDigits
    raise GuardFailed("An integral of the motion is too uneven for these settings; choose milder ones.")


def geometric(w: acb, n: Fraction, analytic: bool) -> acb:
    """(1 - w^n) / (1 - w): for a whole n a sum without a difference; else regular at 1, and at 0 no more than continuous."""
    if n.denominator == 1:
        total = acb(1)
        for _ in range(n.numerator - 1):
            total = total * w + 1
        return total
    power = arb(n.numerator) / n.denominator
    if not (1 - w).contains(0) and abs(1 - w) * power > 1:
        return (1 - _power(w, power, analytic)) / (1 - w)
    log = w.log(analytic=analytic)
    return power * _growth(power * log) / _growth(log)


def _growth(z: acb) -> acb:
    """(e^z - 1) / z about zero: its series, and a bound on what is left of it."""
    size, terms = abs(z).upper(), ctx.prec // 2
    if not size < 4.0:
        return acb("nan")
    total = acb(1)
    for k in range(terms, 1, -1):
        total = 1 + total * z / k
    left = (size**terms / arb(terms + 1).gamma()).upper()
    return total + acb(arb(0, left), arb(0, left))


def _power(w: acb, n: arb, analytic: bool) -> acb:
    if w.contains(0) and not analytic:
        reach = arb(0, (abs(w).upper() ** n).upper())
        return acb(reach, reach)
    return w.pow(acb(n), analytic=analytic)
