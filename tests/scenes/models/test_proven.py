"""Enclosed motions: they hold closed forms and references found another way, to the last place, and say where they cannot."""

import json
import math
from fractions import Fraction
from pathlib import Path

import mpmath as mp
import pytest
from flint import arb

from corollary.formula.ball import precision_of
from corollary.scenes.catalogue import run
from corollary.scenes.forces.contact import Contact
from corollary.scenes.models import certain
from corollary.scenes.models.pair import Pair, touch, turned_and_lasted
from corollary.scenes.models.proven import collisions, follow
from corollary.scenes.models.proven.laws import PairLaw, RowLaw
from corollary.scenes.models.proven.step import State, disc, enclosed_step
from corollary.scenes.models.two_bodies import damped, undamped
from corollary.scenes.run import BadSetting, components

REFERENCES = json.loads((Path(__file__).parent.parent / "references.json").read_text(encoding="utf-8"))
NARROW = 1e-12


def agree(found, exact, widest=NARROW):
    """Both balls hold the same number, and neither says nothing."""
    assert found.overlaps(exact)
    assert found.rad() < widest
    assert exact.rad() < widest


@pytest.mark.parametrize("eta", [0.0, 0.1, 0.5, 1.2])
def test_a_spring_with_a_dashpot_is_what_its_closed_form_says(eta):
    with precision_of(80):
        law = PairLaw(arb(1), arb(1), arb(1), arb(eta), None, arb(0))
        seen = follow.pair(law, State((arb(1), arb(0)), (arb(0), arb(0))))
        exact = damped(arb(1), arb(1), arb(eta), arb(1), 1)
        agree(-seen.state.speeds[0], exact.restitution)
        agree(seen.overlaps[0], exact.overlap)
        agree(seen.force_square.sqrt(), exact.force)
        assert seen.ended is not None
        agree(seen.ended, exact.duration)


@pytest.mark.parametrize("q", [1.0, 1.3, 1.5, 3.0])
def test_two_bodies_are_what_beta_functions_say(q):
    with precision_of(80):
        law = RowLaw((arb(1), arb(1)), arb(1), arb(q))
        seen = follow.row(law, State((arb(1), arb(0)), (arb(0),)))
        exact = undamped(arb(0.5), arb(1), arb(q), arb(1))
        agree(seen.state.speeds[1], arb(1))
        agree(seen.overlaps[0], exact.overlap)
        assert seen.began == 0
        assert seen.ended is not None
        agree(seen.ended, exact.duration)


@pytest.mark.whole
@pytest.mark.parametrize("across", [0.0, 0.018, 0.0399])
def test_two_spheres_are_what_two_integrals_say(across):
    pair = Pair(0.1, 0.2, (0.08, across), ((0.0, 0.0), (-1.0, 0.0)), 0.04, Contact(2e4, 1.5))
    with precision_of(144):
        met = touch(pair)
        assert met is not None
        top, turned, lasted = turned_and_lasted(pair, met.inward, met.spin)
        mass = 1 / (1 / arb(0.1) + 1 / arb(0.2))
        d, v = arb(float(top)), arb(float(met.inward))
        law = PairLaw(arb(1), 2e4 * d ** arb(2.5) / (mass * v * v), arb(1.5), arb(0), arb(0.04) / d, arb(0))
        seen = follow.pair(law, State((met.inward / v, met.spin / (d * v)), (arb(0), arb(0))))
        assert seen.ended is not None
        agree(seen.overlaps[0], top / d)
        agree(seen.state.places[1], turned, 1e-13)
        agree(seen.ended, lasted * v / d, 1e-13)


@pytest.mark.whole
@pytest.mark.parametrize("q", ["1.5", "3"])
def test_a_row_of_three_is_what_30_digits_say(q):
    found = run("cradle", {"N": 3.0, "q": float(q), "m": 1.0, "k": 1.0}, proven=True)
    assert found.error_is == "bound"
    for value, error, text in zip(
        components(found.observed["velocities"]),
        components(found.errors["velocities"]),
        REFERENCES[f"3 {q}"],
        strict=True,
    ):
        off = abs(Fraction(value) - Fraction(text))
        assert off <= Fraction(error) + Fraction(1, 10**19)
        assert error < 1e-16


@pytest.mark.whole
@pytest.mark.parametrize(
    ("scene", "settings"),
    [
        ("cradle", {"N": 3.0, "q": 1.5, "masses": (0.1, 2.0, 0.3), "gaps": 1e-4}),
        ("spheres", {"eta": 0.1, "dy": 0.0399999}),
        ("spheres", {"dx": 0.03, "dy": 0.02, "vA": (0.3, 0.0)}),
        ("ball_on_floor", {"eta": 3.0}),
    ],
)
def test_estimates_hold_what_is_proven(scene, settings):
    estimated, proven = run(scene, settings, 1e-9), run(scene, settings, proven=True)
    assert estimated.error_is == "estimate"
    assert proven.error_is == "bound"
    assert set(proven.observed) == set(estimated.observed)
    for name, each in proven.measured.items():
        for x, y, estimate, bound in zip(
            components(each.value),
            components(estimated.observed[name]),
            components(estimated.errors[name]),
            components(each.error),
            strict=True,
        ):
            assert abs(x - y) <= estimate + bound
            assert bound <= 2e-16 * max(abs(x), 0.3 * each.size)


def test_spheres_that_begin_squeezed_gain_what_the_contact_had_stored():
    """Proven, too: an elastic contact gives back what it took, and here it took less."""
    ma, mb, k, q, reach = 0.1, 0.1, 2e4, 1.5, 0.04
    for va in ((-0.3254744980301535, 0.0), (0.0, 0.0)):
        given = {"eta": 0.0, "q": q, "k": k, "vA": va, "dx": 0.0371, "dy": 0.0046}
        usual, sure = (run("spheres", given, proven=proven) for proven in (False, True))
        assert sure.observed.keys() == usual.observed.keys()
        stored = k * (reach - math.hypot(0.0371, 0.0046)) ** (q + 1.0) / (q + 1.0)
        had, now = 0.5 * ma * va[0] ** 2, components(sure.observed["velocities"])
        has = 0.5 * ma * math.hypot(*now[:2]) ** 2 + 0.5 * mb * math.hypot(*now[2:]) ** 2
        assert has == pytest.approx(had + stored, rel=1e-13)
        if had:
            assert sure.observed["energy_ratio"] == pytest.approx(has / had, rel=1e-13)
        assert sure.model == "integration"


@pytest.mark.parametrize("along", [(1.0, 0.0), (0.6, -0.8)])
def test_head_on_a_damped_spring_is_what_its_closed_form_says(along):
    """Nothing goes across: no digits are looked for in what is zero, and the energy is that of both velocities."""
    given = {"dx": 0.08 * along[0], "dy": 0.08 * along[1], "vA": along, "q": 1.0, "mB": 0.3}
    sure = run("spheres", given, proven=True)
    with precision_of(80):
        mass = arb(0.1) * arb(0.3) / (arb(0.1) + arb(0.3))
        exact = damped(mass, arb(2e4), arb(1), arb(1), 1)
        lost = float((1 - exact.restitution**2) * mass / arb(0.1))
    assert sure.warnings == ()
    assert sure.error_is == "bound"
    assert sure.observed["energy_ratio"] == pytest.approx(1.0 - lost, rel=1e-14)
    assert sure.errors["energy_ratio"] < 1e-16
    if not along[1]:
        assert sure.observed["velocities"][1::2] == (0.0, 0.0)
        assert sure.errors["velocities"][1::2] == (0.0, 0.0)


def test_what_is_a_bound_already_stays_as_it_is():
    assert run("ball_on_floor", {}, proven=True).observed == run("ball_on_floor", {}).observed


@pytest.mark.parametrize(
    ("scene", "settings", "says"),
    [
        ("pendulum_block", {}, "no bound can be proven"),
        ("cradle", {"N": 9.0, "q": 1.5}, "6 at most"),
        ("cradle", {"N": 3.0, "q": 1.5, "masses": (0.1, 0.001, 0.1)}, "to and fro"),
        ("spheres", {"eta": 20.0}, "never ends"),
    ],
)
def test_what_cannot_be_proven_is_refused_in_a_sentence(scene, settings, says):
    with pytest.raises(BadSetting, match=says):
        run(scene, settings, proven=True)


def test_a_step_holds_the_motion_and_a_disc_never_reaches_the_end_of_the_contact():
    with precision_of(80):
        law = RowLaw((arb(1), arb(1)), arb(1), arb(1))
        start = State((arb(1), arb(0)), (arb(0.25),))
        within = disc(law, start, [True], arb(10))
        assert within.radius < 0.25 + 1e-9  # the overlap goes by one in a unit of time
        step = enclosed_step(law, start, [True], within, within.radius / 4, [arb(1)])
        assert step is not None
        omega, time = arb(2).sqrt(), step.length
        exact = 0.25 * (omega * time).cos() + (omega * time).sin() / omega
        agree(step.at(time).places[0], exact)
        assert step.during().places[0].contains(exact)


def test_a_force_that_is_not_told_is_in_the_bound():
    """A contact just begun, its force only bounded: the step must hold the motion with the force and the one without."""
    with precision_of(80):
        law = RowLaw((arb(1), arb(1)), arb(1), arb(1))
        start = State((arb(1), arb(0)), (arb(0),))
        within = disc(law, start, [False], arb(1))
        time = arb(1e-6)
        step = enclosed_step(law, start, [False], within, time, [time])
        assert step is not None
        end, omega = step.at(time), arb(2).sqrt()
        assert end.places[0].contains((omega * time).sin() / omega)
        assert end.places[0].contains(time)
        assert end.speeds[1].contains((1 - (omega * time).cos()) / 2)
        assert end.speeds[1].rad() < 1e-10


def test_a_largest_value_is_found_between_and_at_the_ends():
    with precision_of(80):
        agree(follow.maximum(lambda t: (t.sin(), t.cos()), arb(3), arb(0)), arb(1))
        agree(follow.maximum(lambda t: (t.exp(), t.exp()), arb(1), arb(0)), arb(1).exp())
        agree(follow.maximum(lambda t: (t.sin(), t.cos()), arb(1), arb(2)), arb(2))
        two = follow.maximum(lambda t: (t * (1 - t) ** 2, (1 - t) * (1 - 3 * t)), arb(1.3), arb(0))
        agree(two, arb(4) / 27)
        assert math.isfinite(float(two))


@pytest.mark.parametrize("q", [1.0, 1.25, 1.5, 3.0, 4.7])
@pytest.mark.parametrize("gap", [0.0, 1e-3])
def test_two_balls_that_are_followed_agree_with_a_beta_function(q, gap):
    masses, v, k = (0.013, 2.9), 3.7, 4.1e6
    found = certain.found(lambda: collisions.row(masses, (v, 0.0), (gap,), k, q), collisions.PRECISIONS)
    with mp.workdps(40):
        a, b, u, power = mp.mpf(masses[0]), mp.mpf(masses[1]), mp.mpf(v), mp.mpf(q) + 1
        top = (a * b / (a + b) * u**2 * power / (2 * mp.mpf(k))) ** (1 / power)
        true = {
            "velocities": ((a - b) / (a + b) * u, 2 * a / (a + b) * u),
            "largest_overlap": (top,),
            "peak_force": (mp.mpf(k) * top ** mp.mpf(q),),
            "duration": (2 * top / u * mp.beta(1 / power, mp.mpf("0.5")) / power,),
        }
        for name, exact in true.items():
            values, errors = (components(x[name]) for x in (found.observed, found.errors))
            for value, error, x in zip(values, errors, exact, strict=True):
                assert abs(mp.mpf(value) - x) <= error <= 2.3e-16 * abs(value)
