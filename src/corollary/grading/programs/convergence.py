"""Stepped programs judged by convergence: called with a step and with half of it, near enough for the step, and nearer with half."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from corollary.derive.statements import Fault, Remark
from corollary.messages import N_, catalogue

_ = catalogue(__name__)

Given = Mapping[str, float]
Draw = Callable[[float, float], float]
Inputs = Mapping[str, Any]

STEPS = 100  # in a contact: with so many the book's method errs by 1.2e-4 of the first speed (measured, no damping)
SAFETY = 8.0  # right programs by other methods (Heun, midpoint, position first) err by up to 4.1 times as much (tests)
SMOOTH = 3.0  # the same where no contact begins or ends: there the book's method errs most
# steps in a contact; no whole numbers, so that contacts end anywhere in a step
COARSE = (23.4, 28.7, 33.1, 39.8, 47.3)
LEAST = 2e-4  # nothing nearer is asked for: solve_ivp with max_step=dt and its usual rtol errs by up to 7e-5
# a program that is wrong is named by the usual one it ends so near to, whatever methods the two use
NAMED = 0.02
# without dt: solve_ivp's usual rtol = 1e-3 errs by up to 0.005 here, forward Euler by 0.02 and more
OWN_STEPS = 0.01
SAME = 1e-13  # relative: two runs that differ by less did not use the step
FIRST = 2.7  # halving the step divides the error by 2 (first order) or 4 (second): told apart half-way, at the root of 8
STALLED = 1.4  # and 2 from 1 at the root of 2
SMALL = 0.02  # of what is allowed: errors too small to say anything of a method


@dataclass(frozen=True, slots=True)
class Called:
    """One call: the keyword arguments, and the numbers that came back."""

    inputs: Inputs
    returned: tuple[float, ...]


def halved(cases: Sequence[Inputs]) -> list[Inputs]:
    """Each case with its step `dt`, and then with half of it."""
    return [inputs for case in cases for inputs in (case, {**case, "dt": case["dt"] / 2})]


def pairs(called: Sequence[Called]) -> list[tuple[Called, Called]]:
    """The calls that `halved` made, two and two."""
    return list(zip(called[::2], called[1::2], strict=True))


def miscounted(called: Called, count: int, what: str) -> str:
    """What to say when not so many numbers came back; "" when they did."""
    many = len(called.returned)
    if many == count:
        return ""
    return _.plural(
        "It returns one number; return {what}.", "It returns {count} numbers; return {what}.", many, what=what
    )


@dataclass(frozen=True, slots=True)
class Bound:
    """The error may be `constant` / steps^`order`, steps in a contact; relative to the scale of what is observed."""

    order: int
    constant: float

    def allowed(self, steps: float) -> float:
        return max(LEAST, self.constant / steps**self.order)


def measured(
    order: int, errors: Callable[[float], Sequence[float]], safety: float = SAFETY
) -> tuple[Bound, ...]:
    """The bound of each observed thing: `errors(steps)` are those of the book's method with so many steps in a contact.

    The order is 2 where forces depend on places only and what is observed is read when they have ceased to act; 1 with
    damping, where a force jumps, and for places on the way (observed orders: `corollary trade`).
    """
    found = [(steps, errors(steps)) for steps in COARSE]
    return tuple(
        Bound(order, safety * max(each[i] * steps**order for steps, each in found))
        for i in range(len(found[0][1]))
    )


@dataclass(frozen=True, slots=True)
class Standard:
    """What a case is held against. `errors` are the distances of what was returned from the truth, each relative to its natural
    scale; `bounds` say how large each may be; `contact` is the time (s) that steps are counted in."""

    errors: Callable[[Sequence[float]], tuple[float, ...]]
    bounds: tuple[Bound, ...]
    contact: float

    def far(self, call: Called, own: bool) -> bool:
        """Whether anything is further from the truth than allowed; a program with steps of its own has one bound for all."""
        errors = zip(self.errors(call.returned), self.allowed(call), strict=True)
        return any(not error <= (OWN_STEPS if own else allowed) for error, allowed in errors)

    def allowed(self, call: Called) -> tuple[float, ...]:
        return tuple(bound.allowed(self.contact / call.inputs["dt"]) for bound in self.bounds)


@dataclass(frozen=True, slots=True)
class Family:
    """How the calls of one function are judged: `misfit` is a sentence when the numbers cannot be compared, `wrong` says of a
    program that is too far away what it did."""

    misfit: Callable[[Called], str]
    standard: Callable[[Inputs], Standard]
    wrong: Callable[[Called], Fault]


GROWN = N_(
    "The returned values have become infinite. Check the sign of the force, and whether the step "
    "is far too large."
)
OWN = N_("Halving `dt` changes nothing, so your function uses its own step, which may be too large.")
LATER = N_(
    "Your function is right with the longer step, but not with half of it: its error does not "
    "shrink. Does it stop after a fixed number of steps, or at a fixed time?"
)


def judged(family: Family, called: Sequence[Called]) -> Fault | Remark | None:
    """The first call that is too far away decides; when none is, what halving the step showed."""
    both, standards = pairs(called), list[Standard]()
    for pair in both:
        for call in pair:
            if sentence := family.misfit(call):
                return Fault(sentence)
            if not all(map(math.isfinite, call.returned)):
                return Fault(_(GROWN), known=True)
        own, standard = same(*pair), family.standard(pair[0].inputs)
        for later, call in enumerate(pair):
            if standard.far(call, own):
                fault = family.wrong(call)
                if fault.known or not (own or later):
                    return fault
                return Fault(f"{_(OWN if own else LATER)} {fault.sentence}")
        standards.append(standard)
    return remark(both, standards)


def same(coarse: Called, fine: Called) -> bool:
    """Whether half the step changed nothing."""
    return math.dist(coarse.returned, fine.returned) <= SAME * math.hypot(*coarse.returned)


def remark(both: Sequence[tuple[Called, Called]], standards: Sequence[Standard]) -> Remark | None:
    """What the errors of all pairs together say of a right program; nothing of one that converges as well as the book's."""
    if all(same(*pair) for pair in both):
        return Remark(_(FORMULA))
    # With a bound of first order, where in a step the contact ends decides the error: halving the step says nothing there.
    places = [i for i, standard in enumerate(standards) if standard.bounds[0].order == 2]
    coarse, fine = _sums([both[i] for i in places], [standards[i] for i in places])
    if fine <= SMALL * len(places) or coarse > FIRST * fine:
        return None
    return Remark(_(FIRST_ORDER if coarse > STALLED * fine else STAYS))


FORMULA = N_(
    "Right. Halving `dt` changes nothing: your function does not use it as its step (it is a formula, or a solver with its own steps)."
)
STAYS = N_(
    "Right within the tolerance, but halving `dt` does not reduce the error. Do you read the "
    "result before the contact has ended, or take a fixed number of steps?"
)
FIRST_ORDER = N_(
    "Right. Halving `dt` halves the error, so your method is of first order. Without energy loss,"
    " Euler–Cromer's error falls to a quarter: do you read the velocity half a step late, or "
    "update the position with the old velocity?"
)


def _sums(both: Sequence[tuple[Called, Called]], standards: Sequence[Standard]) -> tuple[float, float]:
    """Errors with the longer step and with half of it, in parts of what the longer one allows, so that no case drowns the others."""
    coarse = fine = 0.0
    for (long, short), standard in zip(both, standards, strict=True):
        allowed = standard.allowed(long)[0]
        coarse, fine = (
            coarse + standard.errors(long.returned)[0] / allowed,
            fine + standard.errors(short.returned)[0] / allowed,
        )
    return coarse, fine
