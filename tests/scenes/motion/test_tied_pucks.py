"""Pucks that rods hold together on a rough table: each holds what it can, in whatever direction, and they begin to slip as friction takes most."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import solve_ivp
from scipy.optimize import brentq
from tests.shares import share

from corollary.scenes.forces.friction import Friction
from corollary.scenes.forces.function import ForceFunction
from corollary.scenes.forces.rod import Rod, String
from corollary.scenes.forces.wall import HardWall
from corollary.scenes.forces.weight import Weight
from corollary.scenes.motion.shares import evenly
from corollary.scenes.plan import play
from corollary.scenes.run import BadSetting, components
from corollary.scenes.run import Observable as O
from corollary.scenes.scene import Body, Scene

G = 9.8


@pytest.mark.parametrize("degrees", share([55.0, -70.0, 60.0, 120.0], 2))
@pytest.mark.parametrize("tolerance", [1e-6, 1e-10])
def test_a_puck_pulled_ever_harder_swings_about_the_one_it_is_tied_to(degrees, tolerance):
    """At rest until the pull across the rod is all that its friction holds; along the rod the other one holds the rest."""
    angle, limit, until = math.radians(degrees), 0.2 * G, 1.2 / abs(math.sin(math.radians(degrees)))
    starts = limit / abs(2.0 * math.sin(angle))

    def swings(t, y):
        return [y[1], 2.0 * t * math.sin(angle - y[0]) - math.copysign(limit, angle)]

    turned, rate = solve_ivp(swings, (starts, until), (0.0, 0.0), "DOP853", rtol=1e-12, atol=1e-14).y[:, -1]
    pull = ForceFunction(1, lambda t, x, v: (2.0 * t * math.cos(angle), 2.0 * t * math.sin(angle)))
    pucks = Body(1.0, (0.0, 0.0), (0.0, 0.0)), Body(1.0, (1.0, 0.0), (0.0, 0.0))
    forces = Rod((0, 1)), Friction(0, 0.2), Friction(1, 0.2), pull
    found = play(Scene(pucks, forces, until=until), {O.VELOCITIES}, tolerance)
    truth = (0.0, 0.0, -rate * math.sin(turned), rate * math.cos(turned))
    for value, error, true in zip(
        found.observed["velocities"], found.errors["velocities"], truth, strict=True
    ):
        assert abs(value - true) <= error
        assert error < 1e-5
    assert found.warnings == ()


def pucks_on_a_bar(masses, places, frictions, pulled, share, until):
    """A bar that is pulled across at one puck by `share` of what it holds; it gives way by turning about one of the others, or as a whole."""
    limits = [G * m * mu for m, mu in zip(masses, frictions, strict=True)]
    turning = [
        sum(f * abs(x - c) for f, x in zip(limits, places, strict=True)) / abs(places[pulled] - c)
        for c in places
        if c != places[pulled]
    ]
    most = min(sum(limits), *turning)
    pull = ForceFunction(pulled, lambda t, x, v: (0.0, share * most * t / until))
    bodies = tuple(Body(m, (x, 0.0), (0.0, 0.0)) for m, x in zip(masses, places, strict=True))
    rods = Rod((0, 1)), Rod((1, 2)), Rod((0, 2))
    return Scene(bodies, (*rods, *(Friction(i, mu) for i, mu in enumerate(frictions)), pull), until=until)


@pytest.mark.parametrize(
    ("masses", "places", "frictions", "pulled"),
    share(
        [
            ((1.0, 1.0, 1.0), (0.0, 1.0, 2.0), (0.2, 0.2, 0.2), 2),
            ((1.0, 1.5, 0.7), (0.0, 0.6, 1.4), (0.2, 0.3, 0.25), 0),
        ],
        1,
    ),
)
def test_a_stiff_bar_on_a_table_holds_as_much_as_limit_analysis_says(masses, places, frictions, pulled):
    held = play(pucks_on_a_bar(masses, places, frictions, pulled, 0.999, 1.0), {O.VELOCITIES})
    assert max(map(abs, held.observed["velocities"])) <= max(held.errors["velocities"]) < 1e-9
    assert held.outcome == "sticks"
    moved = play(pucks_on_a_bar(masses, places, frictions, pulled, 1.1, 1.0), {O.VELOCITIES})
    assert max(map(abs, moved.observed["velocities"])) > 1e-3


def test_a_stiff_triangle_slides_to_rest():
    """One puck rests before the others, while the triangle turns about it: friction rounded off at 1e-5 m/s says when all do."""
    high = math.sqrt(3.0) / 2.0
    places, masses, frictions = ((0.0, 0.0), (1.0, 0.0), (0.5, high)), (2.0, 1.0, 1.0), (0.3, 0.1, 0.2)
    middle = np.array(masses) @ np.array(places) / sum(masses)
    arms = np.array(places) - middle
    inertia = float(np.array(masses) @ np.square(arms).sum(axis=1))
    drive, spin, until = (0.3, 0.3), 1.5, 0.6

    def velocities(y):
        c, s = math.cos(y[2]), math.sin(y[2])
        turned = arms @ np.array([[c, s], [-s, c]])
        return turned, np.array(y[3:5]) + y[5] * np.column_stack([-turned[:, 1], turned[:, 0]])

    def rates(t, y):
        turned, v = velocities(y)
        brakes = -G * np.array(masses) * np.array(frictions) / np.sqrt(np.square(v).sum(axis=1) + 1e-10)
        forces = brakes[:, None] * v
        torque = float((turned[:, 0] * forces[:, 1] - turned[:, 1] * forces[:, 0]).sum())
        return [*y[3:], *(forces.sum(axis=0) / sum(masses)), torque / inertia]

    start = [*middle, 0.0, *drive, spin]
    reference = velocities(solve_ivp(rates, (0.0, until), start, "Radau", rtol=1e-9, atol=1e-12).y[:, -1])[1]
    begun = velocities(start)[1]
    bodies = tuple(Body(m, p, tuple(v)) for m, p, v in zip(masses, places, begun.tolist(), strict=True))
    forces = Rod((0, 1)), Rod((1, 2)), Rod((0, 2)), *(Friction(i, mu) for i, mu in enumerate(frictions))
    found = play(Scene(bodies, forces, until=until), {O.VELOCITIES})
    assert np.allclose(found.observed["velocities"], reference.ravel(), atol=2e-4)
    assert play(Scene(bodies, forces, until=1.0), {O.VELOCITIES}).outcome == "sticks"


@settings(max_examples=30, deadline=None)
@given(st.integers(2, 4), st.integers(1, 3), st.integers(0, 10**6))
def test_no_other_share_lets_the_most_exhausted_hold_longer(holders, ways, seed):
    draw = np.random.default_rng(seed)
    forces, most = draw.normal(size=2 * holders), draw.uniform(0.3, 3.0, size=holders)
    free = np.linalg.qr(draw.normal(size=(2 * holders, ways)))[0]
    shared = evenly(forces, free, [((2 * i, 2 * i + 1), float(most[i])) for i in range(holders)])

    def exhausted(z):
        return max(math.hypot(z[2 * i], z[2 * i + 1]) / most[i] for i in range(holders))

    others = [shared + free @ draw.normal(size=ways) * 10.0**-n for n in range(1, 9) for _ in range(20)]
    assert exhausted(shared) <= min(map(exhausted, others)) * (1.0 + 1e-12)
    assert np.abs((shared - forces) - free @ (free.T @ (shared - forces))).max() < 1e-9


def test_three_in_line_swing_as_a_bar():
    """A rod from end to end along two others: a pendulum of moment of inertia m (1 + 4) and weight at 3/2."""

    def swings(t, y):
        return [y[1], -G * 3.0 / 5.0 * math.cos(y[0])]

    angle, rate = solve_ivp(swings, (0.0, 0.5), (0.0, 0.0), "DOP853", rtol=1e-12, atol=1e-14).y[:, -1]
    nail = Body(math.inf, (0.0, 0.0), (0.0, 0.0))
    bar = Body(1.0, (1.0, 0.0), (0.0, 0.0)), Body(1.0, (2.0, 0.0), (0.0, 0.0))
    forces = Rod((0, 1)), Rod((1, 2)), Rod((0, 2)), Weight(G)
    found = play(Scene((nail, *bar), forces, until=0.5), {O.VELOCITIES})
    truth = (0.0, 0.0, -rate * math.sin(angle), rate * math.cos(angle))
    truth = (*truth, 2.0 * truth[2], 2.0 * truth[3])
    for value, error, true in zip(
        found.observed["velocities"], found.errors["velocities"], truth, strict=True
    ):
        assert abs(value - true) <= error < 1e-8


@pytest.mark.parametrize(
    ("bodies", "rods"),
    [
        (((0.0, 0.0), (2.0, 0.0), (1.0, 0.0)), ((0, 2), (1, 2))),
        (((0.0, 0.0), (3.0, 0.0), (1.0, 0.0), (2.0, 0.0)), ((0, 2), (2, 3), (1, 3))),
    ],
)
def test_rods_that_lock_are_refused_at_the_start(bodies, rods):
    nails = tuple(Body(math.inf, place, (0.0, 0.0)) for place in bodies[:2])
    loose = tuple(Body(1.0, place, (0.0, 0.0)) for place in bodies[2:])
    with pytest.raises(BadSetting, match="hold each other only by how they would bend"):
        play(Scene((*nails, *loose), (*map(Rod, rods), Weight(G)), until=0.5), {O.VELOCITIES})


def test_a_braced_square_and_a_flat_parallelogram_are_not_refused():
    corners = (0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)
    square = tuple(Body(1.0, place, (0.3, 0.0)) for place in corners)
    rods = tuple(Rod(ends) for ends in ((0, 1), (1, 2), (2, 3), (0, 3), (0, 2), (1, 3)))
    found = play(Scene(square, (*rods, Weight(G)), until=0.5), {O.VELOCITIES})
    assert np.allclose(found.observed["velocities"], (0.3, -0.5 * G) * 4, atol=1e-9)
    nails = Body(math.inf, (0.0, 0.0), (0.0, 0.0)), Body(math.inf, (2.0, 0.0), (0.0, 0.0))
    bobs = Body(1.0, (1.0, 0.0), (0.0, 0.0)), Body(1.0, (3.0, 0.0), (0.0, 0.0))
    play(
        Scene((*nails, *bobs), (Rod((0, 2)), Rod((1, 3)), Rod((2, 3)), Weight(G)), until=0.3), {O.VELOCITIES}
    )


@pytest.mark.parametrize("heavy", [1.0, 1e3, 1e6])
def test_a_grain_sets_off_when_its_own_friction_gives_way(heavy):
    """Whatever rests elsewhere: pulled by 2 mu m g t it slips from half a second on."""
    for grain in (1.0, 1e-4):
        pull = ForceFunction(0, lambda t, x, v, grain=grain: (0.4 * G * grain * t,))
        bodies = Body(grain, (0.0,), (0.0,)), Body(heavy, (5.0,), (0.0,))
        scene = Scene(bodies, (Friction(0, 0.2), pull, Friction(1, 0.3)), until=1.0)
        found = play(scene, {O.VELOCITIES})
        assert abs(found.observed["velocities"][0] - 0.05 * G) <= found.errors["velocities"][0] < 1e-9


@pytest.mark.parametrize("heavy", [1.0, 1e4, 1e6])
def test_what_lets_go_does_so_by_its_own_force(heavy):
    """A body pressed on a wall ever less beside a heavy one, and a bob lifted off its string under a heavy trolley."""
    presses = (
        ForceFunction(0, lambda t, x, v: (8.0 * t - 4.0,)),
        ForceFunction(1, lambda t, x, v: (-G * heavy,)),
    )
    pair = Body(1.0, (0.0,), (0.0,)), Body(heavy, (0.0,), (0.0,))
    found = play(Scene(pair, (HardWall((1.0,)), *presses), until=1.0), {O.VELOCITIES})
    assert abs(found.observed["velocities"][0] - 1.0) <= found.errors["velocities"][0] < 1e-9
    trolley, bob = Body(heavy, (0.0, 0.0), (0.0, 0.0)), Body(1.0, (0.0, -1.0), (0.0, 0.0))
    lifted = ForceFunction(1, lambda t, x, v: (0.0, 2.0 * G * t))
    floor = HardWall((0.0, 1.0), restitution=0.0, only=(0,))
    scene = Scene((trolley, bob), (String((0, 1)), Weight(G), floor, lifted), until=1.0)
    found = play(scene, {O.VELOCITIES})
    assert abs(found.observed["velocities"][3] - 0.25 * G) <= found.errors["velocities"][3] < 1e-9


def test_a_block_in_a_rough_corner_is_simply_held():
    """Pressed to the wall by 10 N and lifted by 15 t N it stays as long as the wall's friction holds it: 9.8 + 4 N."""
    walls = HardWall((0.0, 1.0), restitution=0.0, mu=0.4), HardWall((-1.0, 0.0), restitution=0.0, mu=0.4)
    for until in (0.3, 0.85):
        forces = Weight(G), *walls, ForceFunction(0, lambda t, x, v: (10.0, 15.0 * t))
        found = play(Scene((Body(1.0, (0.0, 0.0), (0.0, 0.0)),), forces, until=until), {O.VELOCITIES})
        assert found.warnings == ()
        assert found.outcome == "sticks"
        assert max(map(abs, found.observed["velocities"])) <= max(found.errors["velocities"]) < 1e-9


@pytest.mark.parametrize("angle", share([0.2, 1.2, 0.3, 0.5, 0.9, 1.4], 2))
def test_a_block_held_on_an_incline_sticks(angle):
    incline = HardWall((math.sin(angle), math.cos(angle)), restitution=0.0, mu=2.0 * math.tan(angle))
    scene = Scene((Body(2.0, (0.0, 0.0), (0.0, 0.0)),), (Weight(G), incline), until=1.0)
    assert play(scene, {O.VELOCITIES}).outcome == "sticks"


def slides_on(start, rates, until):
    """What a motion from a state (time, places and velocities) comes to: the velocities."""
    return solve_ivp(rates, (start[0], until), start[1], "DOP853", rtol=1e-13, atol=1e-16).y[4:, -1]


@pytest.mark.parametrize("tolerance", share([1e-10, 1e-8, 1e-12], 1))
def test_pucks_that_give_way_together_begin_to_slip_where_they_go(tolerance):
    """Static friction twice the kinetic: the rod's pull jumps as both give way, and neither goes where it was held. From Gauss's principle."""
    kinetic, static, until, along = 2.0, 4.0, 1.3, np.array([0.6, 0.8])

    def push(t):
        return np.array([3.0 + 4.0 * t, 2.0])

    def margin(t):
        part = push(t) @ along
        return static + math.sqrt(static**2 - (push(t) - part * along) @ (push(t) - part * along)) - part

    def left(force):
        return force * (1.0 - kinetic / np.linalg.norm(force))

    breaks = brentq(margin, 0.0, 0.87, xtol=1e-16)
    pull = brentq(
        lambda s: (left(-s * along) - left(push(breaks) + s * along)) @ along, -20.0, -kinetic - 1e-9
    )
    begins = np.concatenate([left(push(breaks) + pull * along), left(-pull * along)])

    def rates(t, y):
        apart, relative = y[2:4] - y[:2], y[6:] - y[4:6]
        u, turns = apart / np.linalg.norm(apart), relative @ relative
        forces = [f - kinetic * v / np.linalg.norm(v) for f, v in ((push(t), y[4:6]), (np.zeros(2), y[6:]))]
        tie = ((forces[1] - forces[0]) @ u + turns) / 2.0
        return np.concatenate([y[4:], forces[0] + tie * u, forces[1] - tie * u])

    short = 1e-7
    truth = slides_on((breaks + short, np.concatenate([[0.0, 0.0, 0.6, 0.8], begins * short])), rates, until)
    forces = (
        Rod((0, 1)),
        Friction(0, 0.2, 10.0, 0.4),
        Friction(1, 0.2, 10.0, 0.4),
        ForceFunction(0, lambda t, x, v: tuple(push(t).tolist())),
    )
    scene = Scene((Body(1.0, (0.0, 0.0), (0.0, 0.0)), Body(1.0, (0.6, 0.8), (0.0, 0.0))), forces, until=until)
    found = play(scene, {O.VELOCITIES}, tolerance)
    for value, error, true in zip(
        found.observed["velocities"], found.errors["velocities"], truth, strict=True
    ):
        assert abs(value - true) <= error + 2e-12  # the reference begins a little after the break
        assert error < 1e-9


@pytest.mark.parametrize("begun", [0.0, 0.11])
@pytest.mark.parametrize(("aside", "axes", "until"), [(0.0, 1, 1.0), (0.0, 2, 1.0), (3.0, 2, 0.7)])
def test_a_string_that_is_just_taut_helps_before_anything_gives_way(begun, aside, axes, until):
    """A push toward the other puck, and then away: what both hold on the string is overcome at 0.9 s (0.765 s with a push aside), whenever it begins."""
    rest = (0.0,) * (axes - 1)
    push = ForceFunction(1, lambda t, x, v: (-1.0 + 10.0 * (t + begun), *([aside] * len(rest))))
    forces = String((0, 1)), Friction(0, 0.2, 10.0, 0.4), Friction(1, 0.2, 10.0, 0.4), push
    bodies = (
        Body(1.0, (0.0, *rest), (0.0,) * axes),
        Body(1.0, (1.0, *rest), (0.0,) * axes),
    )
    found = play(Scene(bodies, forces, until=until - begun), {O.VELOCITIES})
    gained = (5.0 * (1.0**2 - 0.9**2) - (1.0 + 4.0) * 0.1) / 2.0 if until == 1.0 else 0.0
    for i, value in enumerate(found.observed["velocities"]):
        assert abs(value - (gained if i % axes == 0 else 0.0)) <= max(found.errors["velocities"]) < 1e-9


@pytest.mark.parametrize("degrees", [0.0, 25.0])
@pytest.mark.parametrize("mass", [0.5, 3.0])
def test_a_puck_that_stops_on_its_belt_pulls_to_the_very_end(mass, degrees):
    """Slowed down by the one behind it, until that rests on its belt and the string goes slack: in a plane as on a line, where a stop is exact."""
    way, forward = (math.cos(math.radians(degrees)), math.sin(math.radians(degrees))), -1.0

    def ended(axes):
        def turned(x):
            return (x * way[0], x * way[1]) if axes == 2 else (x,)

        bodies = Body(1.0, turned(0.0), turned(forward)), Body(mass, turned(1.0), turned(forward))
        forces = String((0, 1)), Friction(0, 0.05), Friction(1, 0.3, belt=turned(-0.3))
        return play(Scene(bodies, forces, until=0.6), {O.VELOCITIES})

    line, plane = ended(1), ended(2)
    assert abs(line.observed["velocities"][0] + 0.3) > 0.02  # it has gone on alone
    for i in range(2):
        along = sum(v * w for v, w in zip(plane.observed["velocities"][2 * i : 2 * i + 2], way, strict=True))
        off = abs(along - line.observed["velocities"][i])
        assert off <= line.errors["velocities"][i] + 2.0 * max(plane.errors["velocities"]) < 1e-9


@pytest.mark.parametrize("tolerance", share([1e-11, 1e-8, 1e-12], 1))
@pytest.mark.parametrize(
    ("belt", "masses", "mu", "angle"),
    [
        (-0.9918127932298721, (2.8816473710991755, 0.6225785362151051), (0.2, 0.2), 1.6500487691948182),
        (1.0, (1.8158882561289962, 1.3107053290221844), (0.2, 0.1), 3.395507361141855),
    ],
)
def test_pucks_on_a_rod_that_creep_off_a_belt_state_what_their_direction_costs(
    belt, masses, mu, angle, tolerance
):
    """Each is pushed along the rod as hard as friction holds at half a second: from then on by (sum of mu m) g (t - 1/2)^2/(2 (1/2) M)."""
    begun, until, way = 0.5, 0.6, (math.cos(angle), math.sin(angle))
    holds = [m * f * G for m, f in zip(masses, mu, strict=True)]
    drawn = tuple(belt * w for w in way)
    pucks = tuple(
        Body(m, tuple(far * w for w in way), drawn) for m, far in zip(masses, (0.0, 0.5), strict=True)
    )
    forces = [
        ForceFunction(i, lambda t, x, v, h=h: tuple(h * t / begun * w for w in way))
        for i, h in enumerate(holds)
    ]
    forces += [Rod((0, 1)), *(Friction(i, f, G, belt=drawn) for i, f in enumerate(mu))]
    found = play(Scene(pucks, tuple(forces), until=until), {O.VELOCITIES}, tolerance)
    speed = belt + sum(holds) * (until - begun) ** 2 / (2.0 * begun * sum(masses))
    true = [speed * w for w in way] * 2
    errors = components(found.errors["velocities"])
    assert all(abs(a - b) <= e for a, b, e in zip(found.observed["velocities"], true, errors, strict=True))
    assert max(errors) < 1e-9
