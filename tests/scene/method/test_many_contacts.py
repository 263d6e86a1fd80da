"""A swarm of pairs is each pair."""

import numpy as np
import pytest

from corollary.scene.force.contact import Contact
from corollary.scene.method.many_contacts import Pairs, collide_many
from corollary.scene.method.single_contact import follow
from corollary.scene.model.pair import Pair, after_parting, meet


def swarm(n, eta, seed):
    rng = np.random.default_rng(seed)
    return Pairs(
        mass=rng.uniform(0.02, 0.1, n),
        reach=np.full(n, 0.04),
        k=10.0 ** rng.uniform(3.7, 4.7, n),
        eta=rng.uniform(0.0, eta, n),
        apart=np.stack([np.full(n, 0.08), rng.uniform(-0.045, 0.045, n)], axis=1),
        relative=np.stack([-rng.uniform(0.2, 2.0, n), np.zeros(n)], axis=1),
    )


@pytest.mark.parametrize("eta", [0.0, 1.0, 9.0])
def test_each_pair_is_what_it_is_alone_within_the_error_it_claims(eta):
    pairs = swarm(60, eta, seed=7)
    found = collide_many(pairs)
    assert found.missed.any()
    assert found.errors.max() < 1e-5
    for i in range(60):
        m = 2.0 * pairs.mass[i]
        alone = Pair(m, m, tuple(pairs.apart[i]), tuple(pairs.relative[i]), 0.04, Contact(pairs.k[i], 1.5, pairs.eta[i]))
        met = meet(alone)
        assert (met is None) == found.missed[i]
        if met is not None:
            exact = after_parting(alone, met, follow(alone, met, 1e-13))
            assert np.hypot(*(found.relative[i] - exact)) <= 2.0 * found.errors[i] * abs(pairs.relative[i, 0]) + 1e-12


def test_more_steps_less_error_at_high_order():
    pairs = swarm(40, 0.5, seed=3)
    rough, fine = collide_many(pairs, 6), collide_many(pairs, 12)
    together = ~(rough.missed | rough.alone | fine.alone)
    gain = np.log2(np.median(rough.errors[together]) / np.median(fine.errors[together]))
    assert 4.5 < gain < 10.0
