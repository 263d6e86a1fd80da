"""The ends of the range: certified values against an independent evaluation, scenes against laws that hold there."""

from __future__ import annotations

import math

import pytest

from corollary.formula.ast import Call, Expr, Name, Negative, Number, Power, Product, Quotient, Sum
from corollary.formula.ball import Certified, RationalPi, Undefined, certified
from corollary.grading.solutions import Solutions
from corollary.problem.bank import chapter_bank, find
from corollary.problem.variant import chapter
from corollary.verify.extremes import Pushed, push, pushed, ulps

from .extreme_runs import Extreme, ExtremeRun, play
from .extreme_scenes import extremes
from .scene_laws import meets

CODES = ("X12.2", "X12.5", "X12.7", "X12.12", "E12.7.2", "E12.7.1", "E12.3.1")


@pytest.fixture(scope="module")
def solutions() -> dict[str, object]:
    bank = chapter_bank()
    known = Solutions(bank)
    return {code: known.of(find(bank, code)) for code in CODES}


def in_many_digits(tree: Expr, at: dict[str, RationalPi]):
    """The formula in 900 digits, by mpmath: enough for 1e150 to cancel to the last digit."""
    import mpmath as mp

    calls = {
        "sqrt": mp.sqrt,
        "abs": abs,
        "sin": mp.sin,
        "cos": mp.cos,
        "exp": mp.exp,
        "ln": mp.log,
        "max": max,
        "min": min,
    }
    match tree:
        case Number(value):
            return mp.mpf(value.numerator) / value.denominator
        case Name(name):
            known = at.get(name)
            return (
                mp.mpf(known.ratio.numerator) / known.ratio.denominator * mp.pi**known.pi if known else mp.pi
            )
        case Negative(term):
            return -in_many_digits(term, at)
        case Sum(terms):
            return mp.fsum(in_many_digits(term, at) for term in terms)
        case Product(factors):
            return mp.fprod(in_many_digits(factor, at) for factor in factors)
        case Quotient(top, bottom):
            return in_many_digits(top, at) / in_many_digits(bottom, at)
        case Power(base, exponent):
            return in_many_digits(base, at) ** in_many_digits(exponent, at)
        case Call(function, arguments):
            return calls[function](*[in_many_digits(each, at) for each in arguments])
    raise AssertionError(tree)


@pytest.mark.parametrize("code", CODES)
def test_certified_values_are_the_nearest_doubles(solutions, code):
    import mpmath as mp

    solution, met = solutions[code], 0
    with mp.workdps(900):
        for label, givens in pushed(chapter(solution.problem)):
            for place in solution.unknowns:
                for tree in place.in_givens or ():
                    try:
                        found = certified(tree, givens)
                    except Undefined:
                        continue
                    true = in_many_digits(tree, givens)
                    assert found.proven, (code, label)
                    if math.isinf(found.value):
                        assert abs(true) > mp.mpf(2) ** 1023
                    else:
                        # Half a last place, and the least bit more for what is exactly between two doubles.
                        half = mp.mpf(math.ulp(found.value)) * mp.mpf("0.5000001")
                        assert abs(mp.mpf(found.value) - true) <= half, (code, label)
                        met += 1
    assert met > 20


def test_a_push_counts_every_value(solutions):
    found = push(solutions["X12.5"])
    assert isinstance(found, Pushed)
    assert found.ok
    assert found.proven == 4 * 4 * sum(len(place.in_givens) for place in solutions["X12.5"].unknowns)
    # Products and quotients, one rounding a find: a few last places at most.
    assert 0.0 <= found.worst <= 4.0


def test_last_places_are_counted():
    assert ulps(1.0 + 3 * 2.0**-52, Certified(1.0, True, 64)) == 3.0
    assert ulps(1.0, Certified(1.0, True, 64)) == 0.0


TABLE = extremes()


@pytest.fixture(scope="module")
def played() -> dict[int, ExtremeRun]:
    return {id(extreme): play(extreme) for extreme in TABLE}


@pytest.mark.parametrize("extreme", TABLE, ids=[f"{each.scene}: {each.what}" for each in TABLE])
def test_a_scene_far_out_obeys_its_law_or_is_refused_in_a_sentence(played, extreme):
    met = played[id(extreme)]
    assert met.ok, met
    assert met.seconds < 30.0
    if met.outcome == "refused":
        assert met.why.endswith(".")


def test_few_extremes_are_refused(played):
    refused = {met.what for met in played.values() if met.outcome == "refused"}
    assert refused == {"middle ball 1e-9 times as heavy", "head-on and too soft"}


def test_the_table_holds_what_was_promised_of_it():
    """Each kind of end of the range, by the words of its row."""
    rows = "; ".join(f"{each.scene}: {each.what}" for each in TABLE)
    for promised in (
        "mass of A 1e-150", "mass of A 1e+150", "1e-9 times as heavy", "1e9 times as heavy", "stiffness 1e-12", "stiffness 1e+12",
        "exponent 1;", "exponent 10", "restitution 0", "restitution 1;", "inelastic collapse", "grazing", "missing", "head-on",
        "that just touch", "least denormal", "past sticking", "critical damping", "inside the rim", "over the rim", "onto the core",
        "from along the wall", "from square to the wall", "speed 1e-150", "speed 1e+150",
    ):  # fmt: skip
        assert promised in rows, promised


def test_a_law_that_does_not_hold_is_seen():
    wrong = Extreme("wrong", "spheres", {"eta": 0.0, "dy": 0.0}, meets("velocities", 0.1, 0.0, 0.9, 0.0))
    assert not play(wrong).ok
