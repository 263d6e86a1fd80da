"""A swarm of pairs is each pair."""

import numpy as np
import pytest

from corollary.scenes.forces.contact import Contact
from corollary.scenes.integrate.many_contacts import Pairs, collide_many
from corollary.scenes.integrate.single_contact import follow
from corollary.scenes.models.pair import Pair, after_parting, meet


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
    assert not found.soft.any()
    assert found.errors.max() < 1e-7
    for i in range(60):
        m = 2.0 * pairs.mass[i]
        alone = Pair(
            m,
            m,
            tuple(pairs.apart[i]),
            tuple(pairs.relative[i]),
            0.04,
            Contact(pairs.k[i], 1.5, pairs.eta[i]),
        )
        met = meet(alone)
        assert (met is None) == found.missed[i]
        if met is not None:
            exact = after_parting(alone, met, follow(alone, met, 1e-13))
            assert (
                np.hypot(*(found.relative[i] - exact)) <= found.errors[i] * abs(pairs.relative[i, 0]) + 1e-12
            )


@pytest.mark.parametrize(("eta", "seed"), [(0.0, 1), (1.0, 2), (3.0, 3)])
def test_the_error_stated_is_never_less_than_the_true_one_and_seldom_a_hundred_times_more(eta, seed):
    pairs = swarm(1500, eta, seed)
    found, finest = collide_many(pairs), collide_many(pairs, 36)
    together = ~(found.missed | found.alone | finest.alone)
    assert together.sum() > 1200
    speed = np.hypot(*pairs.relative.T)
    true = (np.hypot(*(found.relative - finest.relative).T) / speed)[together]
    stated, rest = found.errors[together], finest.errors[together]
    assert np.all(true <= stated + rest)
    seen = true > 1e-12
    assert np.median(stated[seen] / true[seen]) < 100.0


def test_a_course_of_ten_thousand_is_known_to_seven_digits():
    found = collide_many(swarm(10_000, 2.0, seed=5))
    assert found.alone.mean() < 2e-3
    assert found.errors.max() < 1e-7


def test_more_steps_less_error_at_high_order():
    pairs = swarm(40, 0.1, seed=3)
    rough, fine, exact = collide_many(pairs, 10), collide_many(pairs, 14), collide_many(pairs, 36)
    together = ~(rough.missed | rough.alone | fine.alone)
    off = [np.hypot(*(each.relative - exact.relative)[together].T) for each in (rough, fine)]
    assert 6.0 < np.log(np.median(off[0]) / np.median(off[1])) / np.log(1.4) < 12.0


def test_spheres_so_soft_that_they_pass_through_each_other_have_no_answer():
    pairs = swarm(20, 0.0, seed=3)
    apart = np.array([[0.08, 0.0]] + [[0.08, 0.01]] * 19)
    found = collide_many(Pairs(pairs.mass, pairs.reach, np.full(20, 1e-3), pairs.eta, apart, pairs.relative))
    assert found.soft.tolist() == [True] + [False] * 19
    assert np.isnan(found.relative[0]).all()
    assert np.isinf(found.errors[0])
    # Offset, they swing round each other's centres, which hardly turns them at all.
    assert np.isfinite(found.relative[1:]).all()
