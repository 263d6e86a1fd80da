"""An author's own scenes: the least model is chosen, and the models agree where they overlap."""

import math

import pytest
from tests.ready_scene_files import names_in

from corollary.derive.ready_scenes import run
from corollary.scenes.forces.bonds import Spring
from corollary.scenes.forces.contact import Contact, Friction, HardWall
from corollary.scenes.forces.fields import InverseSquare, Weight
from corollary.scenes.forces.flows import Absorption, Thrust
from corollary.scenes.measure import measured
from corollary.scenes.plan import plan, play
from corollary.scenes.run import MEANING, BadSetting, Observable
from corollary.scenes.scene import Body, Scene

Well = names_in("atom")["Well"]

V = {Observable.VELOCITIES}
HARD = Contact(1e4, 1.5)


def row(*masses, contact=HARD, speed=1.0):
    bodies = tuple(Body(m, (0.1 * i,), (speed if i == 0 else 0.0,), 0.05) for i, m in enumerate(masses))
    return Scene(bodies, (contact,))


def test_the_least_model_is_chosen():
    assert plan(row(1.0, 2.0), V).model == "conservation"
    assert plan(row(1.0, 2.0), V | {Observable.DURATION}).model == "quadrature"
    assert plan(row(1.0, 1.0, 1.0), V).model == "integration"
    assert plan(row(1.0, 2.0, contact=Contact(1e4, 1.5, 1.0)), V).model == "integration"
    in_a_plane = Scene(
        (Body(1.0, (0.0, 0.0), (1.0, 0.0), 0.1), Body(1.0, (1.0, 0.1), (0.0, 0.0), 0.1)), (HARD,)
    )
    assert plan(in_a_plane, V).model == "quadrature"
    damped = Scene(in_a_plane.bodies, (Contact(1e4, 1.5, 1.0),))
    assert plan(damped, V).why.startswith("damping")
    assert plan(in_a_plane, {Observable.ENERGY, Observable.MOMENTUM}).model == "conservation"
    three = Scene((*in_a_plane.bodies, Body(1.0, (2.0, 0.1), (0.0, 0.0), 0.1)), (HARD,))
    assert plan(three, {Observable.MOMENTUM, Observable.ENERGY_RATIO}).model == "conservation"
    assert plan(three, V).model == "integration"


def test_a_row_is_the_cradle():
    found = play(
        row(0.1, 0.1, 0.1), V | {Observable.DURATION, Observable.PEAK_FORCE, Observable.LARGEST_OVERLAP}
    )
    cradle = run("cradle", {"q": 1.5, "m": 0.1, "k": 1e4, "v0": 1.0})
    for name, value in found.observed.items():
        assert value == pytest.approx(cradle.observed[name], rel=1e-9)


PAIR = (Body(0.1, (0.0, 0.0), (1.0, 0.0), 0.02), Body(0.3, (0.08, 0.018), (0.0, 0.1), 0.03))
ALL_OF_A_PAIR = V | {
    Observable.DURATION,
    Observable.PEAK_FORCE,
    Observable.LARGEST_OVERLAP,
    Observable.ENERGY_RATIO,
    Observable.IMPULSE,
    Observable.MOMENTUM,
    Observable.ENERGY,
}
SUN = Body(math.inf, (0.0, 0.0), (0.0, 0.0))
ORBIT = {Observable.PERIOD, Observable.TURNING_POINTS}
WELL = Well(100.0, 1.0, 0.4)


def atom(place, velocity, until=4.0):
    return Scene((Body(2.0, place, velocity),), (WELL,), until=until)


def planet(velocity, strength=1.0, until=40.0):
    return Scene((Body(1.0, (1.0, 0.0), velocity), SUN), (InverseSquare((0, 1), strength),), until=until)


CLOSED = [
    (Scene(PAIR, (Contact(2e4, 1.5),)), ALL_OF_A_PAIR, "quadrature"),
    (Scene(PAIR, (Contact(2e4, 1.0),)), ALL_OF_A_PAIR, "quadrature"),
    (Scene(PAIR, (Contact(2e4, 1.5, 1.0),)), ALL_OF_A_PAIR, "integration"),
    (
        Scene((PAIR[0], Body(0.3, (0.08, 0.06), (0.0, 0.0), 0.03)), (Contact(2e4, 1.5),)),
        ALL_OF_A_PAIR,
        "conservation",
    ),
    (
        Scene((PAIR[0], Body(0.3, (0.049, 0.0), (0.0, 0.0), 0.03)), (Contact(2e4, 1.5),)),
        ALL_OF_A_PAIR,
        "integration",
    ),
    (row(1.0, 2.0, contact=Contact(1e6)), ALL_OF_A_PAIR, "quadrature"),
    (row(1.0, 2.0, contact=Contact(1e5, 1.0, 50.0)), ALL_OF_A_PAIR, "piecewise exact"),
    (row(1.0, 2.0, contact=Contact(1e6, 1.5, 2.0)), ALL_OF_A_PAIR, "integration"),
    (
        Scene(PAIR, (Contact(2e4, 1.5),)),
        {Observable.ENERGY, Observable.MOMENTUM, Observable.ENERGY_RATIO},
        "conservation",
    ),
    (atom((1.1, 0.2), (1.0, 1.0)), {Observable.ENERGY}, "conservation"),
    (planet((0.3, 0.9)), {Observable.ENERGY}, "conservation"),
]


@pytest.mark.parametrize(("scene", "wanted", "model"), CLOSED)
def test_the_least_model_and_steps_in_time_agree_within_what_both_state(scene, wanted, model):
    planned, stepped = plan(scene, wanted, 1e-10), measured(scene, wanted, 1e-10, "")
    assert planned.model == model
    found = planned.play()
    assert found.outcome == stepped.outcome
    assert found.observed.keys() == found.errors.keys() == {o.value for o in wanted}
    for name, value in found.observed.items():
        seen, exact = (x if isinstance(x, tuple) else (x,) for x in (stepped.observed[name], value))
        size = max(map(abs, exact)) or 1.0
        assert len(seen) == len(exact), name
        bound = found.relative_error(name) + stepped.relative_error(name) + 1e-13
        assert max(abs(a - b) for a, b in zip(seen, exact, strict=True)) <= bound * size, name


def test_a_wall_that_moves_does_work():
    bodies = (Body(math.inf, (0.0, 0.0), (1.0, 0.0), 0.1), Body(1.0, (0.5, 0.0), (-1.0, 0.0), 0.1))
    found = play(Scene(bodies, (Contact(1e4, 1.5),)), {Observable.ENERGY_RATIO})
    assert found.model == "integration"
    assert found.observed["energy_ratio"] == pytest.approx(9.0, rel=1e-7)


def test_a_trajectory_is_the_places_at_the_times_asked_for():
    """A spring and a body: x = cos wt, at any time, not only where a step ends."""
    bodies = (Body(2.0, (1.0,), (0.0,)), Body(math.inf, (0.0,), (0.0,)))
    scene = Scene(bodies, (Spring((0, 1), 18.0),), until=3.0)
    times = (0.0, 0.1234, 1.0, 2.71828, 3.0)
    found = play(scene, {Observable.TRAJECTORY}, times=times)
    assert found.observed["trajectory"][::2] == pytest.approx([math.cos(3.0 * t) for t in times], abs=1e-8)
    assert found.observed["trajectory"][1::2] == (0.0,) * 5
    off = max(
        abs(x - math.cos(3.0 * t)) for x, t in zip(found.observed["trajectory"][::2], times, strict=True)
    )
    assert off <= found.relative_error("trajectory") < 1e-8
    even = play(scene, {Observable.TRAJECTORY}).observed["trajectory"]
    assert len(even) == 2 * 101
    assert even[2 * 37] == pytest.approx(math.cos(3.0 * 3.0 * 37 / 100), abs=1e-8)


def test_after_the_last_opening_a_trajectory_goes_on_straight():
    scene = Scene(PAIR, (Contact(2e4, 1.5),))
    found = play(scene, V | {Observable.TRAJECTORY}, times=(0.0, 0.02, 5.0, 6.0)).observed
    rows = [found["trajectory"][4 * i : 4 * i + 4] for i in range(4)]
    assert rows[0] == (0.0, 0.0, 0.08, 0.018)
    assert rows[1] == pytest.approx((0.02, 0.0, 0.08, 0.02), abs=1e-12)
    assert [b - a for a, b in zip(rows[2], rows[3], strict=True)] == pytest.approx(
        found["velocities"], abs=1e-9
    )
    exact = play(scene, V).observed["velocities"]
    assert found["velocities"] == pytest.approx(exact, abs=1e-8)


def test_a_trajectory_needs_times_that_the_scene_has():
    with pytest.raises(BadSetting, match="at which times"):
        plan(Scene(PAIR, (HARD,)), {Observable.TRAJECTORY})
    with pytest.raises(BadSetting, match="lie between 0 and 4 s"):
        plan(atom((1.0, 0.0), (0.0, 3.0)), {Observable.TRAJECTORY}, times=(5.0,))
    bounce = Scene(
        (Body(1.0, (2.0, 0.0), (0.0, 1.0)),), (HardWall((1.0, 0.0), 0.0, 0.0), Weight(0.0)), until=4.0
    )
    assert play(bounce, {Observable.TRAJECTORY}, times=(4.0,)).observed["trajectory"] == pytest.approx(
        (2.0, 4.0)
    )


def test_impulse_momentum_and_energy_are_what_their_sentences_say():
    drop = Scene((Body(2.0, (0.0, 10.0), (3.0, 0.0)),), (Weight(9.8),), until=1.0)
    found = play(drop, {Observable.IMPULSE, Observable.MOMENTUM, Observable.ENERGY}).observed
    assert found["impulse"] == pytest.approx((0.0, -19.6), abs=1e-9)
    assert found["momentum"] == pytest.approx((6.0, -19.6), abs=1e-9)
    assert found["energy"] == pytest.approx(9.0 + 2.0 * 9.8 * 10.0, rel=1e-9)
    rubbed = Scene((Body(2.0, (0.0,), (3.0,)),), (Friction(0, 0.5),), until=0.1)
    assert play(rubbed, {Observable.ENERGY}).observed["energy"] == pytest.approx(
        0.5 * 2.0 * (3.0 - 0.49) ** 2, rel=1e-9
    )
    floor = Scene((Body(math.inf, (0.0,), (0.0,)), Body(1.0, (0.5,), (-2.0,), 0.1)), (HARD,))
    assert play(floor, {Observable.IMPULSE}).observed["impulse"] == pytest.approx((4.0,))
    with pytest.raises(BadSetting, match="mass changes"):
        play(
            Scene((Body(2.0, (0.0,), (6.0,)),), (Absorption(0, (-3.0,), 0.4),), until=1.0),
            {Observable.IMPULSE},
        )


def test_steps_in_time_agree_with_the_regularised_contact():
    bodies = (Body(0.1, (0.0, 0.0), (1.0, 0.0), 0.02), Body(0.1, (0.08, 0.018), (0.0, 0.0), 0.02))
    wanted = V | {
        Observable.DURATION,
        Observable.PEAK_FORCE,
        Observable.LARGEST_OVERLAP,
        Observable.ENERGY_RATIO,
    }
    for eta in (0.0, 1.0):
        found, exact = play(Scene(bodies, (Contact(2e4, 1.5, eta),)), wanted), run("spheres", {"eta": eta})
        for name, value in found.observed.items():
            assert value == pytest.approx(exact.observed[name], rel=1e-8, abs=1e-8), name
        assert found.error < 1e-8


def test_three_spheres_in_a_plane_keep_momentum_and_energy():
    bodies = (
        Body(0.1, (0.0, 0.0), (1.0, 0.0), 0.02),
        Body(0.1, (0.08, 0.018), (0.0, 0.0), 0.02),
        Body(0.2, (0.12, 0.03), (0.0, 0.0), 0.02),
    )
    found = play(Scene(bodies, (Contact(2e4, 1.5),)), V | {Observable.ENERGY_RATIO})
    v = found.observed["velocities"]
    assert v[0] + v[2] + 2 * v[4] == pytest.approx(1.0, abs=1e-12)
    assert v[1] + v[3] + 2 * v[5] == pytest.approx(0.0, abs=1e-12)
    assert found.observed["energy_ratio"] == pytest.approx(1.0, abs=1e-8)
    assert found.outcome == "released"


def test_no_touch_is_lost_however_long_the_flight():
    bodies = (Body(0.1, (0.0, 0.0), (1.0, 0.0), 0.02), Body(0.1, (8.0, 0.0399), (0.0, 0.0), 0.02))
    found = play(Scene(bodies, (Contact(2e4, 1.5),)), V)
    exact = run("spheres", {"eta": 0.0, "dx": 8.0, "dy": 0.0399})
    assert found.observed["velocities"] == pytest.approx(exact.observed["velocities"], abs=1e-7)
    assert found.outcome == "released"


def test_an_orbit_in_the_well_agrees_with_its_integrals():
    found = play(
        Scene((Body(2.0, (1.0, 0.0), (0.0, 3.0)),), (Well(100.0, 1.0, 0.4),), until=4.0),
        {Observable.PERIOD, Observable.TURNING_POINTS},
    )
    exact = run("atom", {}).observed
    assert found.observed["period"] == pytest.approx(exact["period"], rel=1e-8)
    assert found.observed["turning_points"] == pytest.approx(exact["turning_points"], rel=1e-8)


def test_an_atom_leaves_the_well_and_bounces_off_the_core():
    settings = {"r0": (2.0, 0.3), "v0": (-5.0, 0.0)}
    found = play(Scene((Body(2.0, (2.0, 0.3), (-5.0, 0.0)),), (Well(100.0, 1.0, 0.4),), until=2.0), V)
    assert found.observed["velocities"] == pytest.approx(
        run("atom", settings).observed["velocities"], abs=1e-8
    )


def test_a_bouncing_ball_collapses_and_is_called_so():
    found = play(Scene((Body(1.0, (2.0,), (0.0,)),), (Weight(9.8), HardWall((1.0,), 0.0, 0.5)), until=4.0), V)
    assert found.outcome == "sticks"
    assert found.observed["velocities"] == (0.0,)
    twice = play(Scene((Body(1.0, (2.0,), (0.0,)),), (Weight(9.8), HardWall((1.0,), 0.0, 0.5)), until=1.2), V)
    # Down in t, up and down in t, since it leaves with half the speed: at 1.2 s it is on its second flight.
    t = math.sqrt(2 * 2.0 / 9.8)
    assert twice.observed["velocities"][0] == pytest.approx(0.5 * 9.8 * t - 9.8 * (1.2 - t), rel=1e-10)


def test_forces_of_the_chapter_in_closed_cases():
    def end(*forces, bodies, until):
        return play(Scene(bodies, forces, until=until), V).observed["velocities"]

    one = (Body(1000.0, (0.0,), (0.0,)),)
    assert end(Thrust(0, (-2500.0,), 10.0), bodies=one, until=60.0) == pytest.approx(
        (2500 * math.log(2.5),), rel=1e-10
    )
    drop = (Body(2.0, (0.0,), (6.0,)),)
    assert end(Absorption(0, (-3.0,), 0.4), bodies=drop, until=1.0) == pytest.approx(
        ((12 - 1.2) / 2.4,), rel=1e-10
    )
    assert end(Friction(0, 0.5), bodies=drop, until=1.0) == pytest.approx((6 - 4.9,), rel=1e-12)
    assert end(Friction(0, 0.5), bodies=drop, until=9.0) == (0.0,)
    two = (Body(1.0, (0.0,), (1.0,)), Body(3.0, (1.0,), (0.0,)))
    swing = end(Spring((0, 1), 7.0, 1.0), bodies=two, until=2.0)
    w = math.sqrt(7.0 / 0.75)
    assert swing[0] - swing[1] == pytest.approx(math.cos(2 * w), rel=1e-8)
    ions = (Body(0.1, (0.0,), (1.0,)), Body(0.15, (0.08,), (0.0,)))
    apart = end(InverseSquare((0, 1), -0.0012), bodies=ions, until=5.0)
    escaped = 1.0 + 2 * 0.0012 / (0.06 * 0.08)  # the square of the relative speed far away
    assert apart[1] - apart[0] == pytest.approx(math.sqrt(escaped), rel=2e-2)


def test_what_does_not_fit_together_is_refused():
    body = Body(1.0, (0.0,), (1.0,))
    with pytest.raises(BadSetting, match="one component each, or two"):
        Scene((body, Body(1.0, (0.0, 0.0), (1.0, 0.0))), ())
    with pytest.raises(BadSetting, match="names a body that is not there"):
        Scene((body,), (Friction(1, 0.5),))
    with pytest.raises(BadSetting, match="until"):
        play(Scene((body,), (Weight(9.8),)), V)
    with pytest.raises(BadSetting, match="nothing is to be observed"):
        plan(row(1.0, 1.0), set())


def test_every_observable_is_defined():
    assert set(MEANING) == set(Observable)


def test_one_more_observable_leaves_the_others_with_their_cheap_model():
    scene = Scene(PAIR, (Contact(2e4, 1.5),))
    planned = plan(scene, V | {Observable.MOMENTUM, Observable.TRAJECTORY}, times=(0.02,))
    assert planned.model == "integration"
    assert planned.models == {
        "velocities": "quadrature",
        "momentum": "conservation",
        "trajectory": "integration",
    }
    found = planned.play()
    assert {name: each.model for name, each in found.measured.items()} == planned.models
    alone = play(scene, V)
    assert found.observed["velocities"] == alone.observed["velocities"]
    assert found.errors["velocities"] == alone.errors["velocities"]
    swing = Scene(
        (Body(2.0, (1.0,), (0.0,)), Body(math.inf, (0.0,), (0.0,))), (Spring((0, 1), 18.0),), until=3.0
    )
    assert plan(swing, V | {Observable.ENERGY}).models == {
        "velocities": "integration",
        "energy": "conservation",
    }


def test_a_nail_at_the_origin_does_not_feel_the_well():
    """A spring of no length beside the well: the two are one stiffer well, with its bottom nearer."""
    nail, atom = Body(math.inf, (0.0,), (0.0,)), Body(2.0, (1.0,), (0.5,))
    both = Scene((atom, nail), (Well(100.0, 1.0, 0.5), Spring((0, 1), 25.0)), until=1.5)
    found = play(both, V | {Observable.ENERGY})
    w, bottom = math.sqrt(125.0 / 2.0), 100.0 / 125.0
    at = (1.0 - bottom) * -w * math.sin(1.5 * w) + 0.5 * math.cos(1.5 * w)
    (value, still), (error, _) = found.observed["velocities"], found.errors["velocities"]
    assert abs(value - at) <= error < 1e-8
    assert still == 0.0
    assert found.observed["energy"] == pytest.approx(0.25 + 12.5, rel=1e-14)
