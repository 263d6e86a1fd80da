"""What is no scene, or against the physics, is refused in one sentence, and by no other exception."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import pairwise

import numpy as np
import pytest
from tests.ready_scene_files import names_in

from corollary.scenes.forces.bonds import Rod, Spring, String
from corollary.scenes.forces.contact import Contact, Friction, HardWall
from corollary.scenes.forces.fields import ForceFunction, InverseSquare, Weight
from corollary.scenes.forces.flows import Absorption, Drag, Thrust
from corollary.scenes.plan import followed, plan, play
from corollary.scenes.progress import reported_to
from corollary.scenes.run import BadSetting, GuardFailed
from corollary.scenes.run import Observable as O
from corollary.scenes.scene import Body, Force, Scene

Well = names_in("atom")["Well"]

V = {O.VELOCITIES}
nan, inf = math.nan, math.inf
ONE = Body(1.0, (0.0,), (1.0,))
FLAT = Body(1.0, (0.0, 0.0), (1.0, 0.0))
TWO = (ONE, Body(1.0, (1.0,), (0.0,)))


def alone(*forces, body=ONE, until=1.0):
    return Scene((body,), forces, until=until)


def push(function, energy=None, body=ONE):
    return alone(ForceFunction(0, function, energy), body=body)


@dataclass(frozen=True)
class Own(Force):
    """A force of somebody's own, of any kind."""

    gives: object = ()
    strength: float = 1.0

    def act(self, scene, state, masses, since):
        return self.gives


@dataclass
class Melting(Force):
    """It can be changed, and so not be hashed."""

    def act(self, scene, state, masses, since):
        return ()


class Rooted(Force):
    """It has no value beyond the origin."""

    def act(self, scene, state, masses, since):
        yield 0, (-math.sqrt(state[0]) - 1.0,)


class Burning(Force):
    """It burns what a body has."""

    def act(self, scene, state, masses, since):
        return ()

    @property
    def mass_rates(self):
        return ((0, -1.0), (0, -1.0))


def coming(speed, until, **of_the_wall):
    bodies = Body(inf, (1.0,), (speed,)), Body(1.0, (3.0,), (0.0,))
    return Scene(bodies, (HardWall((1.0,), **of_the_wall),), until=until)


ROUGH = HardWall((0.0, 1.0), restitution=0.0, mu=0.3)


def axle(height):
    """A disc on a fixed axle at that height."""
    return Body(inf, (0.0, height), (0.0, 0.0), 0.1, spin=3.0, inertia=0.1)


def askew(speed):
    """Two bodies 5 m apart; one goes along the line between them, the other across it."""
    return (
        Body(1.0, (0.0, 0.0), (0.6 * speed, 0.8 * speed)),
        Body(1.0, (3.0, 4.0), (-0.8, 0.6)),
    )


WRONG = [
    ("until", lambda: alone(until=inf)),
    ("until", lambda: alone(until=nan)),
    ("until", lambda: alone(until=0.0)),
    ("until", lambda: alone(until="1")),
    ("bodies must be a tuple", lambda: Scene([ONE], (), until=1.0)),
    ("bodies must be a tuple", lambda: Scene(ONE, (), until=1.0)),
    ("bodies must be a tuple", lambda: Scene((Weight(),), (), until=1.0)),
    ("forces must be a tuple", lambda: Scene((ONE,), [Weight()], until=1.0)),
    ("forces must be a tuple", lambda: Scene((ONE,), (Weight,), until=1.0)),
    ("one component each", lambda: Scene((), (), until=1.0)),
    ("one component each", lambda: alone(body=Body(1.0, (0.0,) * 3, (0.0,) * 3))),
    ("mass = nan", lambda: alone(body=Body(nan, (0.0,), (0.0,)))),
    ("mass = -inf", lambda: alone(body=Body(-inf, (0.0,), (0.0,)))),
    ("mass = '1'", lambda: alone(body=Body("1", (0.0,), (0.0,)))),
    ("mass = 1j", lambda: alone(body=Body(1j, (0.0,), (0.0,)))),
    ("mass above zero", lambda: alone(body=Body(0.0, (0.0,), (0.0,)))),
    ("place = .*tuple", lambda: alone(body=Body(1.0, [0.0], (0.0,)))),
    ("place = .*tuple", lambda: alone(body=Body(1.0, np.zeros(1), (0.0,)))),
    ("place = .*tuple", lambda: alone(body=Body(1.0, 0.0, (0.0,)))),
    ("place = .*finite", lambda: alone(body=Body(1.0, (inf,), (0.0,)))),
    ("velocity = .*finite", lambda: alone(body=Body(1.0, (0.0,), (nan,)))),
    ("velocity = .*finite", lambda: alone(body=Body(1.0, (0.0,), (10**400,)))),
    ("radius = nan", lambda: alone(body=Body(1.0, (0.0,), (0.0,), nan))),
    ("radius = inf", lambda: alone(body=Body(1.0, (0.0,), (0.0,), inf))),
    ("radius of zero", lambda: alone(body=Body(1.0, (0.0,), (0.0,), -1.0))),
    ("name = ", lambda: alone(body=Body(1.0, (0.0,), (0.0,), name=["A"]))),
    ("spin = nan", lambda: alone(body=Body(1.0, (0.0, 0.0), (0.0, 0.0), 0.1, spin=nan))),
    (r"mass = \(a whole number of 401 digits\)", lambda: alone(body=Body(10**400, (0.0,), (0.0,)))),
    (r"until = \(a whole number of 5001 digits\)", lambda: alone(until=10**5000)),
    ("inertia", lambda: alone(body=Body(1.0, (0.0, 0.0), (0.0, 0.0), 0.1, inertia=0.0))),
    ("inertia", lambda: alone(body=Body(1.0, (0.0, 0.0), (0.0, 0.0), 0.1, inertia=-1.0))),
    ("inertia = nan", lambda: alone(body=Body(1.0, (0.0, 0.0), (0.0, 0.0), 0.1, inertia=nan))),
    ("passes", lambda: Scene(TWO, (), until=1.0, passes=((0, 2),))),
    ("passes", lambda: Scene(TWO, (), until=1.0, passes=((0, 0),))),
    ("passes", lambda: Scene(TWO, (), until=1.0, passes=(0, 1))),
    ("passes", lambda: Scene(TWO, (), until=1.0, passes=[(0, 1)])),
    ("g = nan", lambda: alone(Weight(nan))),
    ("g = inf", lambda: alone(Weight(inf))),
    ("body = 0.0.*whole numbers", lambda: alone(Friction(0.0, 0.5))),
    ("body that is not there", lambda: alone(Friction(-1, 0.5))),
    ("mu = nan", lambda: alone(Friction(0, nan))),
    ("g = -9.8", lambda: alone(Friction(0, 0.5, -9.8))),
    ("belt = .* not followed", lambda: alone(Friction(0, 0.5, belt=(1.0,)))),
    ("belt = .*tuple", lambda: alone(Friction(0, 0.5, belt=[1.0]))),
    ("wind = .* has 1", lambda: alone(Drag(0, 1.0, wind=(1.0,)), body=FLAT)),
    ("linear = -1", lambda: alone(Drag(0, -1.0))),
    ("quadratic = -1", lambda: alone(Drag(0, 0.0, -1.0))),
    ("normal = .* has 2", lambda: alone(HardWall((0.0, 1.0)))),
    ("normal = .* has 1", lambda: alone(HardWall((1.0,)), body=FLAT)),
    ("normal = .*tuple", lambda: alone(HardWall([1.0]))),
    ("normal = .*tuple", lambda: alone(HardWall(1.0))),
    ("normal = .*finite", lambda: alone(HardWall((nan,)))),
    ("restitution", lambda: alone(HardWall((1.0,), restitution=1.5))),
    ("restitution = nan", lambda: alone(HardWall((1.0,), restitution=nan))),
    ("only = ", lambda: alone(HardWall((1.0,), only=(0.0,)))),
    ("only = ", lambda: alone(HardWall((1.0,), only=[0]))),
    ("relative = .* has 2", lambda: alone(Thrust(0, (1.0, 0.0), 0.1))),
    ("burn = 0", lambda: alone(Thrust(0, (1.0,), 0.0))),
    ("burn = -1", lambda: alone(Thrust(0, (1.0,), -1.0))),
    ("nothing is left", lambda: alone(Thrust(0, (1.0,), 1.0))),
    ("nothing is left", lambda: alone(Burning())),
    ("velocity = .* has 2", lambda: alone(Absorption(0, (1.0, 0.0), 0.1))),
    ("rate = -1", lambda: alone(Absorption(0, (1.0,), -1.0))),
    ("ends = ", lambda: Scene(TWO, (Spring((0, 0), 1.0),), until=1.0)),
    ("ends = ", lambda: Scene(TWO, (Spring((0, 1, 1), 1.0),), until=1.0)),
    ("ends = ", lambda: Scene(TWO, (Spring([0, 1], 1.0),), until=1.0)),
    ("ends = ", lambda: Scene(TWO, (Spring(0, 1.0),), until=1.0)),
    ("damping = -1", lambda: Scene(TWO, (Spring((0, 1), 1.0, damping=-1.0),), until=1.0)),
    ("length = -1", lambda: Scene(TWO, (Spring((0, 1), 1.0, -1.0),), until=1.0)),
    ("k = inf", lambda: Scene(TWO, (Spring((0, 1), inf),), until=1.0)),
    ("same place", lambda: Scene((ONE,) * 2, (InverseSquare((0, 1), 3.0),), until=1.0)),
    ("strength = nan", lambda: Scene(TWO, (InverseSquare((0, 1), nan),), until=1.0)),
    ("length above zero", lambda: Scene((ONE,) * 2, (Rod((0, 1)),), until=1.0)),
    ("length above zero", lambda: Scene(TWO, (String((0, 1), 0.0),), until=1.0)),
    ("restitution = 1.5", lambda: Scene(TWO, (String((0, 1), restitution=1.5),), until=1.0)),
    ("restitution = -0.5", lambda: Scene(TWO, (String((0, 1), restitution=-0.5),), until=1.0)),
    ("k = 0", lambda: Scene(TWO, (Contact(0.0),))),
    ("k = -1", lambda: Scene(TWO, (Contact(-1.0),))),
    ("q = 0", lambda: Scene(TWO, (Contact(1.0, 0.0),))),
    ("eta = -1", lambda: Scene(TWO, (Contact(1.0, 1.0, -1.0),))),
    ("friction between bodies", lambda: Scene(TWO, (Contact(1.0, mu=-1.0),))),
    ("chosen", lambda: Scene(TWO, (Contact(1.0, chosen=((0, 0),)),))),
    ("chosen", lambda: Scene(TWO, (Contact(1.0, chosen=(0, 1)),))),
    ("chosen", lambda: Scene(TWO, (Contact(1.0, chosen=[(0, 1)]),))),
    ("k = 0", lambda: alone(Well(0.0, 1.0, 0.5))),
    ("d = -0.5", lambda: alone(Well(1.0, 1.0, -0.5))),
    ("lower d", lambda: alone(Well(1.0, 0.5, 0.9))),
    ("lower d", lambda: alone(Well(1.0, 0.5, 0.5))),
    ("function = 3", lambda: push(3.0)),
    ("1 real number", lambda: push(lambda t, x, v: 1.0)),
    ("1 real number", lambda: push(lambda t, x, v: (1.0, 2.0))),
    ("2 real numbers", lambda: push(lambda t, x, v: (1.0,), body=FLAT)),
    ("1 real number", lambda: push(lambda t, x, v: (1j,))),
    ("1 real number", lambda: push(lambda t, x, v: None)),
    ("finite", lambda: push(lambda t, x, v: (nan,))),
    ("finite", lambda: push(lambda t, x, v: (inf,))),
    ("IndexError", lambda: push(lambda t, x, v: (x[1],))),
    ("ZeroDivisionError", lambda: push(lambda t, x, v: (1.0 / x[0],))),
    ("TypeError", lambda: push(lambda t, x: (0.0,))),
    ("potential", lambda: push(lambda t, x, v: (0.0,), lambda x: nan)),
    ("potential", lambda: push(lambda t, x, v: (0.0,), lambda x: (0.0,))),
    ("on a line .* nothing turns", lambda: alone(body=Body(1.0, (0.0,), (0.0,), 0.1, spin=2.0))),
    ("it is a point", lambda: alone(body=Body(1.0, (0.0, 0.0), (0.0, 0.0), spin=2.0))),
    ("mass = True", lambda: alone(body=Body(True, (0.0,), (0.0,)))),
    ("velocity = .*finite", lambda: alone(body=Body(1.0, (0.0,), (False,)))),
    ("g = True", lambda: alone(Weight(True))),
    ("body = False", lambda: alone(Drag(False, 1.0))),
    ("until", lambda: alone(until=True)),
    ("ball has -1 kg", lambda: alone(body=Body(-1.0, (0.0,), (0.0,), name="ball"))),
    ("body 0 has -1 kg", lambda: alone(body=Body(-1.0, (0.0,), (0.0,)))),
    ("body 0 flies, .* and a wall would not stop it", lambda: coming(-1.0, 1.1)),
    ("body 0 flies, .* and a wall would not stop it", lambda: coming(1.0, 1.1, only=(0,))),
    ("how hard body 0, .* is pressed", lambda: alone(ROUGH, body=axle(0.1))),
    ("how hard body 0, .* is pressed", lambda: alone(ROUGH, body=axle(-0.05))),
    ("cannot be hashed", lambda: alone(Own([(0, (1.0,))]))),
    ("cannot be hashed", lambda: alone(Melting())),
    ("strength = nan", lambda: alone(Own(strength=nan))),
    ("not there", lambda: alone(Own(((1, (1.0,)),)))),
    ("not there", lambda: alone(Own(((0.0, (1.0,)),)))),
    ("1 real number", lambda: alone(Own(((0, (1.0, 2.0)),)))),
    ("finite", lambda: alone(Own(((0, (nan,)),)))),
]


@pytest.mark.parametrize(("says", "made"), WRONG)
def test_what_is_no_scene_is_refused_as_it_is_made(says, made):
    with pytest.raises(BadSetting, match=says) as refused:
        made()
    assert "\n" not in str(refused.value)


SOUND = [
    alone(body=Body(Fraction(1, 2), (0,), (1,))),
    alone(body=Body(np.float64(2.0), (np.float32(0.0),), (np.int64(1),))),
    alone(Own(strength=inf)),
    alone(Drag(np.int64(0), 0.5, wind=(1.0,))),
    alone(Absorption(0, (0.0,), 0.0)),
    alone(Thrust(0, (1.0,), 0.999)),
    alone(
        HardWall((0.0, 1.0), restitution=0.0, mu=0.5),
        body=Body(1.0, (0.0, 1.0), (1.0, 0.0), 0.5, inertia=inf),
    ),
    Scene(TWO, (Spring((0, 1), -1.0, 0.5),), until=0.5),
    push(lambda t, x, v: np.array([-x[0]])),
    push(lambda t, x, v: (0,)),
    Scene(askew(0.0), (Rod((0, 1)),), until=1.0),
    coming(-1.0, 9.0, only=(1,)),
    coming(0.0, 9.0, offset=1.0),
    coming(0.0, 9.0, offset=2.0),
    alone(ROUGH, body=axle(0.11)),
    alone(ROUGH, body=axle(-0.11)),
    alone(body=Body(1.0, (0.0, 0.0), (1.0, 0.0), spin=2.0, inertia=0.1)),
]


@pytest.mark.parametrize("scene", SOUND)
def test_what_is_unusual_but_sound_is_played(scene):
    found = play(scene, V).observed["velocities"]
    assert isinstance(found, Sequence)
    assert all(map(math.isfinite, found))


@pytest.mark.parametrize("tolerance", [0.0, -1e-9, 1.0, 2.0, nan, inf, 1e-30, "1e-9", None])
def test_a_tolerance_that_cannot_be_held_is_refused(tolerance):
    for ask in (plan, play):
        with pytest.raises(BadSetting, match=r"ask for a tolerance between 1e-15 and 0\.1"):
            ask(alone(Weight()), V, tolerance)


@pytest.mark.parametrize(
    ("observe", "times", "says"),
    [
        ({"velocities"}, (), "a set of these"),
        (O.VELOCITIES, (), "a set of these"),
        (None, (), "a set of these"),
        (set(), (), "nothing is to be observed"),
        ({O.TRAJECTORY}, 0.5, "times"),
        ({O.TRAJECTORY}, ("0.5",), "times"),
        ({O.TRAJECTORY}, (nan,), "times of a trajectory lie between"),
        ({O.TRAJECTORY}, (2.0,), "times of a trajectory lie between"),
    ],
)
def test_what_is_no_question_is_refused(observe, times, says):
    with pytest.raises(BadSetting, match=says):
        play(alone(Weight()), observe, times=times)


def test_times_may_be_an_array():
    found = play(alone(Weight(2.0)), {O.TRAJECTORY}, times=np.array([0.0, 1.0]))
    assert found.observed["trajectory"] == pytest.approx((0.0, 0.0))


def late(gives):
    return push(lambda t, x, v: (0.0,) if t < 0.5 else gives)


LATE = [
    (push(lambda t, x, v: ((-x[0] - 1.0) ** 0.5,), body=Body(1.0, (-2.0,), (3.0,))), "real number"),
    (late((1.0, 2.0)), "real number"),
    (late(1.0), "real number"),
    (late((nan,)), "ForceFunction gives nan at 0.5"),
    (push(lambda t, x, v: (nan if 0.7 < t < 0.701 else 0.0,)), "ForceFunction gives nan at 0.7 s"),
    (push(lambda t, x, v: (1 / 0 if 0.7 < t < 0.701 else 0.0,)), r"ForceFunction fails at 0\.7 s \(ZeroDiv"),
    (push(lambda t, x, v: (1 / 0 if 0.7 < t < 0.8 else 0.0,)), r"ForceFunction fails at 0\.7 s \(ZeroDiv"),
    (push(lambda t, x, v: (math.exp(1e4) if 0.7 < t < 0.701 else 0.0,)), r"fails at 0\.7 s \(Overflow"),
    (push(lambda t, x, v: (-math.sqrt(x[0]) - 1.0,), body=Body(1.0, (0.1,), (0.0,))), "ValueError: math"),
    (alone(Rooted(), body=Body(1.0, (0.1,), (0.0,))), r"Rooted fails at 0\.39.*ValueError: math"),
    (push(lambda t, x, v: (0.0,) if t < 0.5 else (x[1],)), "IndexError"),
    (
        Scene(
            (Body(1.0, (0.5,), (-1.0,)),),
            (ForceFunction(0, lambda t, x, v: (0.0 if v[0] < 0.0 else nan,)), HardWall((1.0,))),
            until=1.0,
        ),
        "ForceFunction gives nan at 0.5 s",
    ),
]


@pytest.mark.parametrize(("scene", "says"), LATE)
def test_a_function_that_fails_on_the_way_is_refused_by_name(scene, says):
    for ask in (lambda: play(scene, V), lambda: followed(scene, {"velocities"}, 1e-10)):
        with pytest.raises(GuardFailed, match=says):
            ask()


def test_a_function_may_have_no_value_where_the_body_does_not_go():
    """Its start is looked at with the times of the whole way, where only the body in motion has a root."""
    scene = alone(
        ForceFunction(0, lambda t, x, v: (math.sqrt(x[0] - 2.0 * t),)), body=Body(1.0, (1.0,), (2.0,))
    )
    # y = x - 2 t starts at rest from one with the acceleration sqrt(y): its series.
    found = play(scene, {O.TRAJECTORY}, times=(0.01,))
    t = 0.01
    near = 1.0 + 2.0 * t + t**2 / 2.0 + t**4 / 48.0
    assert found.observed["trajectory"][0] == pytest.approx(near, abs=1e-13)


def test_a_function_may_have_no_value_behind_what_stops_the_body():
    """A step looks beyond the wall before it is known to be there."""
    nowhere = ForceFunction(0, lambda t, x, v: (nan if -0.2 < x[0] < -0.1 else 0.0,))
    scene = alone(nowhere, HardWall((1.0,)), body=Body(0.5, (1.0,), (-1.0,)), until=3.0)
    assert play(scene, V).observed["velocities"] == pytest.approx((1.0,), abs=1e-12)


FAR = [
    Scene((Body(1.0, (0.0,), (1e200,)), TWO[1]), (Spring((0, 1), 1.0),), until=1.0),
    Scene((Body(1.0, (1e200,), (0.0,)), TWO[1]), (Spring((0, 1), 1.0),), until=1.0),
    Scene((Body(1.0, (1e-200, 0.0), (0.0, 0.0)), FLAT), (InverseSquare((0, 1), 3.0),), until=1.0),
    Scene((Body(1e300, (0.0,), (1e10,)),), (Drag(0, 1.0),), until=1.0),
    Scene((Body(1.0, (0.0,), (1e200,)),), (Drag(0, 1.0),), until=1.0),
    Scene((Body(1.0, (0.0,), (1e200,), 0.1), Body(1.0, (1.0,), (0.0,), 0.1)), (Contact(1e4),)),
    Scene(
        (Body(1.0, (0.0, 0.0), (1e200, 0.0), 0.1), Body(1.0, (1.0, 0.0), (0.0, 0.0), 0.1)), (Contact(1e4),)
    ),
    alone(Weight(1e308), until=1e10),
    alone(HardWall((0.0, 1.0), restitution=0.0, mu=0.5), body=Body(1.0, (0.0, 0.0), (1.0, 0.0), 1e-200)),
]


@pytest.mark.parametrize("scene", FAR)
@pytest.mark.parametrize(
    "observe",
    [V, {O.ENERGY}, {O.MOMENTUM}, V | {O.ENERGY}, {O.ENERGY, O.MOMENTUM}, V | {O.ENERGY, O.TRAJECTORY}],
)
@pytest.mark.filterwarnings("ignore::RuntimeWarning")
def test_what_leaves_the_range_of_a_computer_is_refused_or_answered_in_finite_numbers(scene, observe):
    try:
        found = play(scene, observe, times=(1.0,) if O.TRAJECTORY in observe else ())
    except (BadSetting, GuardFailed):
        return
    for value in found.observed.values():
        assert all(map(math.isfinite, value if isinstance(value, tuple) else (value,)))


def test_a_value_beyond_doubles_leaves_the_others():
    heavy = Scene((Body(1e300, (0.0,), (1e10,)),), (Drag(0, 1.0),), until=1.0)
    found = play(heavy, V | {O.ENERGY})
    assert found.observed == play(heavy, V).observed
    assert found.warnings == ("energy is beyond the numbers of a computer.",)
    with pytest.raises(BadSetting, match="energy"):
        play(Scene(heavy.bodies, (Weight(1.0),), until=1.0), {O.ENERGY})
    fast = play(FAR[0], {O.MOMENTUM, O.ENERGY})
    assert fast.observed == {"momentum": (1e200,)}


def test_a_grazing_scene_tells_ever_more():
    graze = Scene(
        (Body(1.0, (0.0,), (5.0,)),), (Weight(10.0), HardWall((-1.0,), -1.25, restitution=0.5)), until=0.8
    )
    told = []
    with reported_to(told.append):
        found = play(graze, V)
    assert any("grazes" in warning for warning in found.warnings)
    assert all(a <= b for a, b in pairwise(told))
    assert told[-1] == pytest.approx(1.0)


def test_a_hit_exactly_at_the_end_has_not_happened():
    def end(until):
        floor = HardWall((1.0,), restitution=0.5)
        return play(Scene((Body(1.0, (4.9,), (0.0,)),), (Weight(9.8), floor), until=until), V).observed[
            "velocities"
        ]

    assert end(1.0) == pytest.approx((-9.8,))
    assert end(1.0 + 1e-9) == pytest.approx((4.9,))


@pytest.mark.parametrize(
    ("says", "bodies"),
    [
        ("part with 1 m/s", (ONE, Body(1.0, (1.0,), (2.0,)))),
        ("near each other with 0.6 m/s", askew(0.6)),
    ],
)
def test_ends_of_a_rod_that_part_are_refused(says, bodies):
    with pytest.raises(BadSetting, match=says):
        play(Scene(bodies, (Rod((0, 1)),), until=1.0), {O.VELOCITIES})


def test_what_rounding_leaves_along_a_rod_is_taken_out():
    """As a run ends: a body that hangs, with a rounding of what it swung with."""
    nail, hung = Body(inf, (0.0, 0.0), (0.0, 0.0)), Body(1.0, (0.0, -1.0), (0.0, -3.9e-16))
    found = play(Scene((nail, hung), (Rod((0, 1)), Weight(9.8)), until=1.0), {O.VELOCITIES})
    assert found.observed["velocities"] == pytest.approx((0.0,) * 4, abs=1e-15)


@pytest.mark.parametrize("mass", [1e-320, 1e-308])
def test_what_is_too_light_for_the_numbers_of_a_computer_is_refused(mass):
    with pytest.raises(BadSetting, match="too few digits"):
        play(Scene((Body(mass, (1.0,), (0.0,)),), (Weight(9.8),), until=1.0), {O.VELOCITIES})
    light = play(Scene((Body(1e-300, (1.0,), (0.0,)),), (Weight(9.8),), until=1.0), {O.VELOCITIES})
    assert light.observed["velocities"][0] == pytest.approx(-9.8, rel=1e-12)


def test_a_potential_that_is_not_that_of_its_function_is_asked_for():
    force = ForceFunction(0, lambda t, x, v: (-x[0],), energy=lambda x: 0.6 * x[0] ** 2)
    with pytest.raises(GuardFailed, match="is a potential not that of its function"):
        play(Scene((Body(1.0, (1.0,), (0.0,)),), (force,), until=3.0), {O.VELOCITIES})


@pytest.mark.parametrize("passes", [None, 0, [], "", ((0, 0),), [(0, 1)]])
def test_what_passes_is_a_tuple_of_pairs(passes):
    with pytest.raises(BadSetting, match="passes = "):
        Scene(TWO, (), until=1.0, passes=passes)


def test_a_radius_whose_square_no_double_holds_is_refused():
    with pytest.raises(BadSetting, match="whose square no double holds"):
        Scene(
            (Body(1.0, (0.0, 1.0), (1.0, 0.0), 1e308),),
            (Weight(9.8), HardWall((0.0, 1.0), restitution=0.0, mu=0.3)),
            until=1.0,
        )


@pytest.mark.parametrize(
    "error", [AssertionError("x"), RecursionError(), StopIteration(), NotImplementedError()]
)
@pytest.mark.parametrize("late", [-1.0, 0.5])
def test_whatever_a_function_raises_it_is_named(error, late):
    def pushes(t, x, v):
        if t > late:
            raise error
        return (1.0, 0.0)

    with pytest.raises((BadSetting, GuardFailed), match=f"fails at .*{type(error).__name__}"):
        play(Scene((FLAT,), (ForceFunction(0, pushes),), until=1.0), V)
