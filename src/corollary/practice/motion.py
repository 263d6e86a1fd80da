"""The motion of an exercise: what its solution simulates and wants shown, with the numbers posed."""

from __future__ import annotations

from corollary.derive.ready_scenes import film_of
from corollary.derive.simulation import Seen, simulations
from corollary.grading.key import Key
from corollary.grading.neglect import neglected_in
from corollary.problem.bank import Bank
from corollary.scenes.film import Film
from corollary.scenes.run import BadSetting, GuardFailed


def motion(bank: Bank, key: Key) -> Film | None:
    """The first simulation that the solution wants `animated`; none where there is none, or where these numbers let nothing move.

    Raises NotDerivable where the scene fails.
    """
    answers: dict[str, Seen] = {
        part: truth.values[0] if len(truth.values) == 1 else truth.values
        for part, truth in key.truths.items()
    }
    try:
        wanted = simulations(bank, key.variant, answers, neglected_in(key))
        first = next((each for each in wanted if each.animated), None)
        return film_of(first.scene, first.settings, first.bank) if first else None
    except (BadSetting, GuardFailed):
        return None
