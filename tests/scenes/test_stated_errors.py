"""Motions whose stated errors once were too small: where a drag turns, where a contact is young, where a force has two maxima."""

import math

import mpmath as mp
import numpy as np
import pytest
from scipy.integrate import solve_ivp

from corollary.derive.ready_scenes import run
from corollary.scenes.forces.bonds import Spring
from corollary.scenes.forces.contact import Contact
from corollary.scenes.forces.fields import Weight
from corollary.scenes.forces.flows import Drag
from corollary.scenes.plan import play
from corollary.scenes.run import Observable as O
from corollary.scenes.scene import Body, Scene

G = 9.8


def thrown_up(m, c, v, until):
    """Speed and height of a stone thrown up against quadratic drag, after its highest point: tangent and hyperbolic tangent."""
    vt = math.sqrt(m * G / c)
    fall = until - vt / G * math.atan(v / vt)
    top = vt * vt / (2.0 * G) * math.log1p((v / vt) ** 2)
    return -vt * math.tanh(G * fall / vt), top - vt * vt / G * math.log(math.cosh(G * fall / vt))


@pytest.mark.parametrize(
    ("m", "c", "v", "until"),
    [
        (1.5480590454304788, 0.48208262863026446, 5.751906264420681, 0.7879728538566795),
        (1.3671272214182628, 0.4837854071468006, 3.9689467564226026, 1.3633677203268038),
        (0.9675683362480886, 0.1390100599015407, 11.61201815431267, 2.3373263175714687),
    ],
)
@pytest.mark.parametrize("angle", [None, 0.5 * math.pi, 0.5 * math.pi - 1e-9])
def test_quadratic_drag_where_a_stone_turns(m, c, v, until, angle):
    speed, height = thrown_up(m, c, v, until)
    place, start = (
        ((0.0,), (v,)) if angle is None else ((0.0, 0.0), (v * math.cos(angle), v * math.sin(angle)))
    )
    scene = Scene((Body(m, place, start),), (Weight(G), Drag(0, quadratic=c)), until=until)
    found = play(scene, {O.VELOCITIES, O.TRAJECTORY}, times=(until,))
    for name, truth in (("velocities", speed), ("trajectory", height)):
        value, error = found.observed[name][-1], found.errors[name][-1]
        assert abs(value - truth) <= error <= 1e-8


def test_in_a_steady_wind_drag_fades_without_an_end_of_turns():
    until, c, b, wind = 400.0, 0.3, 0.5, 4.0
    drag = Drag(0, linear=b, quadratic=c, wind=(wind,))
    found = play(
        Scene((Body(1.0, (0.0,), (-3.0,)),), (drag,), until=until),
        {O.VELOCITIES, O.TRAJECTORY},
        times=(until,),
    )
    # u' = -(b + c u) u, u against the wind: the way is the integral of du/(b + c u).
    lag = math.log1p(c / b * (wind + 3.0)) / c
    assert abs(found.observed["velocities"][0] - wind) <= found.errors["velocities"][0] <= 1e-8
    assert (
        abs(found.observed["trajectory"][0] - (wind * until - lag)) <= found.errors["trajectory"][0] <= 1e-6
    )
    assert found.evaluations < 20_000


def test_a_bounce_turns_a_drag_as_well():
    from corollary.scenes.forces.contact import HardWall

    # Without weight: v' = -(c/m) v^2, so the way between walls is m/c ln(v0/v).
    m, c, v, until = 0.5, 0.2, 3.0, 1.0
    wall = 0.9
    before = m / c * math.expm1(c / m * wall) / v
    hit = v * math.exp(-c / m * wall)
    left = until - before
    after = hit / (1.0 + c / m * hit * left)
    scene = Scene((Body(m, (0.0,), (v,)),), (Drag(0, quadratic=c), HardWall((-1.0,), -wall)), until=until)
    found = play(scene, {O.VELOCITIES, O.TRAJECTORY}, times=(until,))
    assert abs(found.observed["velocities"][0] + after) <= found.errors["velocities"][0] <= 1e-8
    back = wall - m / c * math.log1p(c / m * hit * left)
    assert abs(found.observed["trajectory"][0] - back) <= found.errors["trajectory"][0] <= 1e-8


@pytest.mark.parametrize("until", [5.2, 5.6, 6.0, 6.178673980274595, 6.4, 6.8])
def test_what_has_faded_away_still_bounds_the_step(until):
    """A strongly damped swing: once the fast part is too small to be seen in the slopes, steps that are too long would let it grow."""
    m, k, damping, x0, v0 = (
        0.006414270458234613,
        0.015517120571662761,
        0.05529683595782639,
        0.118266366835141,
        0.46660908251863126,
    )
    half = damping / (2.0 * m)
    root = math.sqrt(half * half - k / m)
    slow, fast = -k / m / (half + root), -half - root
    a, b = (v0 - fast * x0) / (slow - fast), (slow * x0 - v0) / (slow - fast)
    truth = a * slow * math.exp(slow * until) + b * fast * math.exp(fast * until)
    bodies = (Body(math.inf, (0.0,), (0.0,)), Body(m, (3.0 + x0,), (v0,)))
    found = play(Scene(bodies, (Spring((0, 1), k, 3.0, damping),), until=until), {O.VELOCITIES})
    assert abs(found.observed["velocities"][1] - truth) <= found.errors["velocities"][1] <= 1e-9


def test_young_contacts_do_not_share_the_error_of_their_first_step():
    masses, v = (0.25793190475695393, 0.7442497016098485, 0.9041289369399508), 2.701994747316124
    bodies = tuple(
        Body(m, (x,), (v * (x == 0.0),), 0.05) for m, x in zip(masses, (0.0, 1.0, 2.0), strict=True)
    )
    contacts = (
        Contact(137678.08976956995, 1.5, chosen=((0, 1),)),
        Contact(625100.0343507349, 1.0, chosen=((1, 2),)),
    )
    a, b, c = masses
    u = 2.0 * a / (a + b) * v
    truth = (a - b) / (a + b) * v, (b - c) / (b + c) * u, 2.0 * b / (b + c) * u
    found = play(Scene(bodies, contacts), {O.VELOCITIES}).measured["velocities"]
    for value, error, true in zip(found.value, found.error, truth, strict=True):
        assert abs(value - true) <= error <= 1e-8


def test_discs_that_graze_with_a_third_far_off():
    ma, mb, far, b, v = (
        0.7509328056347105,
        0.8385904351960018,
        1.6757038699622016,
        0.09982981756529931,
        2.751867866016127,
    )
    alone = {
        "mA": ma,
        "mB": mb,
        "R": 0.05,
        "k": 20224.775122783594,
        "eta": 0.0,
        "dx": far,
        "dy": b,
        "vA": (v, 0.0),
    }
    truth = (*run("spheres", alone).observed["velocities"], 0.0, -1.0)  # a quadrature, in ball arithmetic
    bodies = (
        Body(ma, (0.0, 0.0), (v, 0.0), 0.05),
        Body(mb, (far, b), (0.0, 0.0), 0.05),
        Body(1.0, (0.0, -500.0), (0.0, -1.0), 0.05),
    )
    found = play(Scene(bodies, (Contact(20224.775122783594, 1.5),)), {O.VELOCITIES}).measured["velocities"]
    for value, error, true in zip(found.value, found.error, truth, strict=True):
        assert abs(value - true) <= error <= 1e-8


def damped_peak(given):
    """The largest force of two damped spheres: the relative motion in the plane by DOP853, sampled densely."""
    reach, k, q, eta = 2.0 * given["R"], given["k"], given["q"], given["eta"]
    mu, v, b = given["mA"] * given["mB"] / (given["mA"] + given["mB"]), given["vA"][0], given["dy"]
    r0 = np.array([math.sqrt((reach - b) * (reach + b)), b])

    def force(y):
        r = np.hypot(y[0], y[1])
        return k * np.maximum(reach - r, 0.0) ** q * y[:2] / r - eta * y[2:]

    def parts(_, y):
        return math.hypot(y[0], y[1]) - reach

    parts.terminal, parts.direction = True, 1.0
    start = np.array([*r0, -v, 0.0])
    found = solve_ivp(
        lambda _, y: np.concatenate([y[2:], force(y) / mu]),
        (0.0, 10.0 * reach / v),
        start,
        method="DOP853",
        rtol=1e-12,
        atol=1e-15,
        max_step=1e-5 * reach / v * 100.0,
        events=parts,
        dense_output=True,
    )
    states = found.sol(np.linspace(0.0, float(found.t[-1]), 20_001))
    return float(np.hypot(*force(states)).max())


@pytest.mark.parametrize("eta", [0.0001795425661067084, 0.0001, 0.00019])
def test_the_force_of_a_damped_graze_falls_rises_and_falls_again(eta):
    given = {
        "mA": 0.25248642803116483, "mB": 0.14948184952565444, "R": 0.02, "q": 2.0, "k": 20000.0, "eta": eta, "dx": 0.1,
        "dy": 0.03998924220622724, "vA": (1.2554226926754175, 0.0),
    }  # fmt: skip
    peak = damped_peak(given)
    assert peak >= eta * given["vA"][0]
    assert run("spheres", given, 1e-9).observed["peak_force"] == pytest.approx(peak, rel=1e-7)


@pytest.mark.parametrize(
    ("masses", "q", "gaps", "what"),
    [
        ((50.14842915010929, 13.158625363211009, 0.017346232807232218), 2.0, 0.0, "duration"),
        ((22.405077998574715, 23.165296837618484, 0.1926924869373283), 2.0, 1e-4, "peak_force"),
    ],
)
def test_two_runs_of_a_cradle_do_not_share_the_error_of_their_first_steps(masses, q, gaps, what):
    given = {"N": 3.0, "masses": masses, "q": q, "gaps": gaps}
    rough, fine = run("cradle", given, 1e-9), run("cradle", given, 1e-14)
    assert abs(rough.observed[what] - fine.observed[what]) <= rough.errors[what]


def test_a_slow_last_touch_makes_a_duration_less_certain():
    given = {
        "N": 3,
        "masses": (0.0002923488420979912, 591.5734096822753, 914.8576428608326),
        "v0": 697.0495490589537,
        "k": 6.812913443538882e-20,
        "q": 1.5,
    }
    rough, fine = run("cradle", given, 1e-9), run("cradle", given, 1e-13)
    assert abs(rough.observed["duration"] - fine.observed["duration"]) <= rough.errors["duration"]


def test_a_later_touch_too_slow_to_be_told_is_said():
    given = {
        "N": 5,
        "masses": (1.0,) * 5,
        "q": 2.0,
        "k": 731660.9188937795,
        "v0": 0.0017268303712799846,
        "gaps": (
            2.1539976344640412e-06,
            6.483732241073087e-07,
            0.00020498348495758594,
            0.0005211181488516456,
        ),
    }
    rough, fine = run("cradle", given, 1e-9), run("cradle", given, 1e-13)
    assert fine.observed["duration"] > 1e9 > rough.observed["duration"]
    assert "a later touch, as slow, would not be in the duration" in rough.warnings[0]
    assert not run("cradle", {"N": 5, "q": 1.5, "gaps": 1e-3}, 1e-12).warnings


@pytest.mark.parametrize("tolerance", [0.1, 5e-3])
def test_the_coarsest_steps_know_their_error(tolerance):
    given = {
        "mA": 1.4095543413783778, "mB": 0.10060003102652171, "R": 0.8030527527071682, "k": 1.0731680854575874, "q": 1.0,
        "eta": 0.0003505627230657331, "dx": -2.7660071756595843, "dy": -3.1411586020973083,
        "vA": (-0.07996376579672897, -0.05256582726862815), "vB": (1.2204099251423487, 0.7365245246803834),
    }  # fmt: skip
    rough, fine = run("spheres", given, tolerance), run("spheres", given, 1e-13)
    for name, value in fine.observed.items():
        off = np.abs(np.subtract(rough.observed[name], value))
        assert (off <= np.array(rough.errors[name]) + np.array(fine.errors[name])).all(), name


def test_spheres_pressed_to_their_centres_are_thrown_apart():
    """The turning, which grows as the cube of the distance, had been left out of what ends a contact: they stuck."""
    given = {
        "q": 5.0, "mA": 0.16814111059631254, "mB": 0.0333081192464744, "k": 21455.019257595857, "eta": 0.2351539176682696,
        "dy": 0.0008465616201400114, "vA": (4.910982992628579, 0.0),
    }  # fmt: skip
    found = run("spheres", given)
    assert found.outcome == "released"
    truth = (
        4.79912438267,
        -1.01881307392e-05,
        0.564668054905,
        5.14302114961e-05,
    )  # DOP853 in x and y, and about the centre
    assert found.observed["velocities"] == pytest.approx(truth, abs=1e-11)


@pytest.mark.parametrize("q", [1.1, 1.3, 1.4, 1.6, 2.4, 2.45, 3.7922656266993995])
def test_bounds_hold_for_an_exponent_that_no_double_is(q):
    """Head-on the duration is a Beta function; with weight a quadrature of another kind."""
    with mp.workdps(50):
        k, p = 0.05 * (q + 1.0) / 2.0 / 1e-3 ** (q + 1.0), 1 / (mp.mpf(q) + 1)
        mass, v = 1 / (1 / mp.mpf(0.1) + 1 / mp.mpf(0.1)), mp.mpf(1.0)
        top = ((mp.mpf(q) + 1) * mass * v**2 / (2 * mp.mpf(k))) ** p
        lasts = 2 * mp.sqrt(mp.pi) * mp.gamma(1 + p) / mp.gamma(p + mp.mpf(0.5)) * top / v
        found = run("spheres", {"eta": 0.0, "dy": 0.0, "q": q, "k": k})
        assert found.measured["duration"].error_is == "bound"
        assert abs(mp.mpf(found.observed["duration"]) - lasts) <= found.errors["duration"]


def test_a_bound_of_a_bounce_with_weight_holds_for_an_exponent_that_no_double_is():
    given = {
        "m": 999.6880709477533, "k": 5576815.621512633, "q": 1.2, "R": 0.04745852318631154, "y0": 0.06196264462544787,
        "v0": 0.0, "g": 275.5742806045637, "eta": 0.0,
    }  # fmt: skip
    found = run("ball_on_floor", given)
    with mp.workdps(40):  # two quadratures of 25 digits
        off = abs(mp.mpf(found.observed["duration"]) - mp.mpf("0.08249095354158299388697"))
        assert off <= found.errors["duration"]
