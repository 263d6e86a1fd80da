"""How far honest rounding moves an answer: in every arithmetic the same, from every thread, and nothing is left of a solution."""

from __future__ import annotations

import gc
import math
import weakref
from concurrent.futures import ThreadPoolExecutor
from random import Random

import pytest

from corollary.grading.assign import admitted
from corollary.grading.key import make_key
from corollary.problem.sampling import sample
from corollary.problem.variant import chapter

from .small import solved


def three_figures(x: float) -> float:
    """The last figure off by up to half a unit, either way."""
    return x + 0.5 * 10.0 ** (math.floor(math.log10(abs(x))) - 2) * random.uniform(-1, 1)


random = Random(7)


def test_the_noise_of_two_steps_is_that_of_a_thousand_students(tmp_path):
    """E = m*v^2/2 by way of p = m*v: both are written down rounded."""
    solution = solved(
        tmp_path,
        "m: {is: mass, value: 2.3, unit: kg}\nv: {is: speed, value: 7.7, unit: m/s}",
        "a kg*m/s\nb J",
        """
        p, E = unknown("p"), unknown("E")
        return derivation(
            step(p, "Momentum.", law("Momentum", "p = m*v", p=p, m=m, v=v), answers="a"),
            step(E, "Energy.", law("Kinetic energy", "E = p^2/(2*m)", E=E, p=p, m=m), answers="b"),
        )
        """,
        "m, v",
    )
    key = make_key(solution, chapter(solution.problem))
    m, v = 2.3, 7.7
    energy = m * v**2 / 2
    off = max(abs(three_figures(three_figures(m * v) ** 2 / (2 * m)) - energy) for _ in range(1000))
    # Thirty-two replays reach less far than a thousand; the margin of a quarter makes up for it.
    assert 0.8 * off < key["b"].noise * energy < 1.25 * off


def test_where_doubles_are_too_coarse_the_noise_is_worked_out_in_balls(tmp_path):
    """A runner's gamma - 1 is 2e-16, of which doubles know nothing: the speed rounded moves it by twice as much as itself."""
    solution = solved(
        tmp_path,
        "v: {is: speed, value: 3.1, unit: m/s}\nc: {is: speed of light, value: 299792458, unit: m/s}",
        "a m/s\nb 1",
        """
        u, K = unknown("u"), unknown("K")
        return derivation(
            step(u, "Twice as fast.", law("Double", "u = 2*v", u=u, v=v), answers="a"),
            step(K, "Relativity.", law("Gamma", "K = 1/sqrt(1 - (u/c)^2) - 1", K=K, u=u, c=c), answers="b"),
        )
        """,
        "v, c",
    )
    key = make_key(solution, chapter(solution.problem))
    assert key["b"].value == pytest.approx((6.2 / 299792458) ** 2 / 2, rel=1e-9)
    # 6.20 is 0.08 % off at most, its square 0.16 %, and the answer itself as much as 0.3 %.
    assert 0.001 < key["b"].noise < 1.25 * 0.005


def test_many_threads_find_the_same_tolerances(solution):
    of = solution("X12.10")
    variants = list(sample(of.problem, 12))
    alone = [make_key(of, each).truths for each in variants]
    with ThreadPoolExecutor(6) as pool:
        assert [key.truths for key in pool.map(lambda each: make_key(of, each), variants * 3)] == alone * 3


def test_nothing_is_left_of_a_solution_that_is_gone(tmp_path):
    solution = solved(
        tmp_path,
        "m: {is: mass, value: 2, unit: kg}\na: {is: acceleration, value: 3, unit: m/s^2}",
        "a N",
        """
        F = unknown("F")
        newton = law("Newton's second law", "F = m*a", F=F, m=m, a=a)
        halved = mistake("Halved.", law("Half", "F = m*a/2", F=F, m=m, a=a))
        return derivation(step(F, "Newton.", newton, answers="a", mistakes=[halved]))
        """,
        "m, a",
    )
    key, why = admitted(solution, chapter(solution.problem))
    assert key is not None, why
    left = weakref.ref(solution)
    del solution, key
    gc.collect()
    assert left() is None
