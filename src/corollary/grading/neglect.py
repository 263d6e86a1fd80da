"""Neglected effects in a variant's answers: the most that they can change each, against its tolerance."""

from __future__ import annotations

from dataclasses import dataclass

from corollary.derive.solution import SolvedNeglected
from corollary.formula.ball import RationalPi
from corollary.grading.key import Key, named
from corollary.grading.replay import compute


@dataclass(frozen=True, slots=True)
class Neglect:
    """`most` is the largest change of the answer (in SI), `share` the same relative to what its tolerance is relative to."""

    left: SolvedNeglected
    most: float
    share: float

    @property
    def part(self) -> str:
        return self.left.statement.part


def neglects(key: Key) -> tuple[Neglect, ...]:
    """In the solution's order. Raises Undefined where a bound has no value."""
    known = key.variant.exact | named(key.solution, list(key.values))
    found: list[Neglect] = []
    for left in key.solution.neglected:
        supposed = {value.stated.name: RationalPi(value.ratio) for value in left.supposing}
        (most,) = map(abs, compute(left.bound.local, known | supposed))
        scale = key.truths[left.statement.part].scale
        found.append(Neglect(left, most, most / scale if scale else float("inf")))
    return tuple(found)


def neglected_in(key: Key) -> dict[str, float]:
    """For each part, the most that all it neglects can change of its answer (in SI)."""
    sums = dict.fromkeys(key.truths, 0.0)
    for each in neglects(key):
        sums[each.part] += each.most
    return sums
