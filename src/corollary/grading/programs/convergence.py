"""The judgement of a stepped program: near enough for its step, and nearer with half of it."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

from corollary.derive.statements import Fault, Remark
from corollary.grading.programs.bound import OWN_STEPS, Bound
from corollary.grading.programs.called import Called, Inputs, pairs

SAME = 1e-13  # relative: two runs that differ by less did not use the step
FIRST = 2.7  # halving the step divides the error by 2 (first order) or 4 (second): told apart half-way, at the root of 8
STALLED = 1.4  # and 2 from 1 at the root of 2
SMALL = 0.02  # of what is allowed: errors too small to say anything of a method


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


GROWN = (
    "What comes back has grown beyond all numbers. A force with the wrong sign drives everything on ever faster: check it; "
    "or the step is far too large."
)
OWN = "Halving `dt` changes nothing, so your function has steps of its own, and they may be too large."
LATER = (
    "With the longer step your function is right, with half of that step it is not: the error does not shrink as it should. "
    "Does it stop after a fixed number of steps, or at a fixed time?"
)


def judged(family: Family, called: Sequence[Called]) -> Fault | Remark | None:
    """The first call that is too far away decides; when none is, what halving the step showed."""
    both, standards = pairs(called), []
    for pair in both:
        for call in pair:
            if sentence := family.misfit(call):
                return Fault(sentence)
            if not all(map(math.isfinite, call.returned)):
                return Fault(GROWN, known=True)
        own, standard = same(*pair), family.standard(pair[0].inputs)
        for later, call in enumerate(pair):
            if standard.far(call, own):
                said = family.wrong(call)
                if said.known or not (own or later):
                    return said
                return Fault(f"{OWN if own else LATER} {said.sentence}")
        standards.append(standard)
    return remark(both, standards)


def same(coarse: Called, fine: Called) -> bool:
    """Whether half the step changed nothing."""
    return math.dist(coarse.returned, fine.returned) <= SAME * math.hypot(*coarse.returned)


def remark(both: Sequence[tuple[Called, Called]], standards: Sequence[Standard]) -> Remark | None:
    """What the errors of all pairs together say of a right program; nothing of one that converges as well as the book's."""
    if all(same(*pair) for pair in both):
        return Remark(FORMULA)
    # With a bound of first order, where in a step the contact ends decides the error: halving the step says nothing there.
    places = [i for i, standard in enumerate(standards) if standard.bounds[0].order == 2]
    coarse, fine = _sums([both[i] for i in places], [standards[i] for i in places])
    if fine <= SMALL * len(places) or coarse > FIRST * fine:
        return None
    return Remark(FIRST_ORDER if coarse > STALLED * fine else STAYS)


FORMULA = "Right. Halving `dt` changes nothing: your function does not step with it (it is a formula, or a solver with steps of its own)."
STAYS = (
    "Right, within the tolerance; but halving `dt` does not bring the result nearer, as it should. Is it read before the contact "
    "has ended, or stepped a fixed number of times?"
)
FIRST_ORDER = (
    "Right. Halving `dt` halves the error: a method of first order. Euler–Cromer's error falls to a quarter where no energy is lost; "
    "is the velocity read half a step late, or the position stepped with the old one?"
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
