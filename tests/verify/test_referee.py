"""Every claim called proven against enumeration of its grid, and every counter-example against its numbers."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable
from pathlib import Path
from random import Random

import pytest

from .referee import claim_judged, root_judged

BATCHES, EACH = 10, 20  # benchmarks/referee.py has more


@pytest.mark.whole
@pytest.mark.parametrize("judged", [claim_judged, root_judged])
@pytest.mark.parametrize("batch", range(BATCHES))
def test_enumeration_contradicts_no_proof_and_no_counter_example(
    batch: int, judged: Callable[[Random, Path], tuple[str, str]], tmp_path: Path
):
    outcomes = Counter[str]()
    for seed in range(batch * EACH, (batch + 1) * EACH):
        outcome, fault = judged(Random(seed), tmp_path)
        outcomes[outcome.split(":")[0]] += 1
        assert not fault, f"seed {seed}: {fault}"
    assert {"proven", "counter-example"} <= outcomes.keys(), outcomes
