"""A share of the derivations that the benchmark judges: none without a law is accepted, errors are found at their lines."""

from __future__ import annotations

import proofs
import pytest


@pytest.mark.whole
def test_derivations_of_many_students():
    tally = proofs.measure(1, share=3)
    assert set(tally.counts) == {"as written", "varied", "error planted", "without a law"}
    assert all(each.total() >= 20 for each in tally.counts.values())
    for sort in ("as written", "varied"):
        assert tally.counts[sort]["refused"] == 0
        assert tally.counts[sort]["accepted"] >= 0.9 * tally.counts[sort].total()
    assert tally.counts["error planted"]["at its line"] == tally.counts["error planted"].total()
    assert tally.counts["without a law"]["accepted"] == 0
