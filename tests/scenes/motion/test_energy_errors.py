"""Energies found by following: near rest, after bounces without end, and with a potential that is another function's."""

import math
from fractions import Fraction

import mpmath
import pytest

from corollary.scenes.forces.contact import Contact, Friction, HardWall
from corollary.scenes.forces.fields import ForceFunction, Weight
from corollary.scenes.forces.flows import Drag, Thrust
from corollary.scenes.plan import plan, play
from corollary.scenes.run import GuardFailed
from corollary.scenes.run import Observable as O
from corollary.scenes.scene import Body, Scene

pytestmark = pytest.mark.whole

TOLERANCES = (1e-2, 1e-6, 1e-10, 1e-13)


def energy_of(scene, tolerance=1e-10):
    run = play(scene, {O.ENERGY}, tolerance)
    return run.measured["energy"], run.warnings


@pytest.mark.parametrize("tolerance", TOLERANCES)
@pytest.mark.parametrize("dust", [False, True])
def test_what_lies_still_has_an_energy_that_is_not_known_better_than_its_place(tolerance, dust):
    """On a slope that holds it, at the origin: its energy is zero, and nothing hangs on the data."""
    slope = HardWall((math.sin(0.3), math.cos(0.3)), restitution=0.0, mu=0.9)
    bodies = [Body(2.0, (0.0, 0.0), (0.0, 0.0))]
    bodies += [Body(1e-3, (0.0, 0.0), (0.0, 0.0))] if dust else []
    found, warnings = energy_of(Scene(tuple(bodies), (Weight(), slope), until=1.3), tolerance)
    assert abs(found.value) <= found.error <= 1.0 * tolerance + 1e-12
    assert not warnings


def test_a_ball_whose_bounces_are_lost_in_the_size_of_the_scene_may_still_have_energy():
    """A nail a thousand kilometres away makes bounces small; the ball has the energy of the fall, a fourth of it after each bounce."""
    ball, floor = Body(1.0, (1.0,), (0.0,)), HardWall((1.0,), 0.0, restitution=0.5, only=(0,))
    scene = Scene((ball, Body(math.inf, (1e6,), (0.0,))), (Weight(9.8), floor), until=1.34)
    fall, bounces = math.sqrt(2.0 / 9.8), 0
    landed = fall
    while landed < 1.34:
        bounces += 1
        landed += 2.0 * fall * 0.5**bounces
    truth = 9.8 * 0.25**bounces
    found, _ = energy_of(scene, 1e-6)
    assert truth == pytest.approx(2.39e-3, rel=1e-2)
    assert abs(found.value - truth) <= found.error
    ratio = play(
        Scene((Body(1.0, (1.0,), (-0.5,)), scene.bodies[1]), scene.forces, until=1.34), {O.ENERGY_RATIO}, 1e-6
    ).measured["energy_ratio"]
    assert ratio.value == 0.0 < ratio.error


def test_what_is_left_of_an_energy_is_known_as_a_part_of_what_came_in():
    """Two damped balls that stick with no momentum but for rounding."""
    heavy, light = Body(3.0, (0.2,), (-1.0 / 3.0,), 0.05), Body(1.0, (0.1,), (1.0,), 0.05)
    run = play(Scene((light, heavy), (Contact(1e4, 1.5, 50.0),)), {O.ENERGY}, 1e-6)
    truth = float((Fraction(1) + 3 * Fraction(heavy.velocity[0])) ** 2 / 8)
    assert run.outcome == "sticks"
    assert abs(run.observed["energy"] - truth) <= run.errors["energy"] < 1e-6


K, M = 5.0, 0.5


def swing(share=1.0, *others, until=1.0):
    """A swing by a function of one's own, whose potential is so many times that of the function."""
    pull = ForceFunction(0, lambda t, x, v: (-K * x[0],), energy=lambda x: share * K * x[0] ** 2 / 2.0)
    return Scene((Body(M, (0.3,), (0.1,)),), (pull, *others), until=until)


def damped(drag, until):
    """Its energy with linear drag, in closed form."""
    with mpmath.workdps(30):
        k, m, c, t = (mpmath.mpf(x) for x in (K, M, drag, until))
        x0, v0, fades = mpmath.mpf(0.3), mpmath.mpf(0.1), c / (2 * m)
        w = mpmath.sqrt(k / m - fades**2)
        a, b = x0, (v0 + fades * x0) / w
        cos, sin = mpmath.cos(w * t), mpmath.sin(w * t)
        x = mpmath.exp(-fades * t) * (a * cos + b * sin)
        v = mpmath.exp(-fades * t) * (w * (b * cos - a * sin)) - fades * x
        return m * v**2 / 2 + k * x**2 / 2


@pytest.mark.parametrize("until", [1.0, 7.3])
@pytest.mark.parametrize("tolerance", TOLERANCES)
@pytest.mark.parametrize("drag", [1e-9, 0.2])
def test_the_energy_of_a_right_potential_beside_drag_is_told(drag, tolerance, until):
    found, _ = energy_of(swing(1.0, Drag(0, drag), until=until), tolerance)
    assert abs(found.value - damped(drag, until)) <= found.error <= 10.0 * tolerance + 1e-11


@pytest.mark.parametrize("share", [2.0, 0.5, -1.0, 1.01])
@pytest.mark.parametrize(
    "other",
    [
        Drag(0, 1e-12),
        Friction(0, 1e-9),
        Thrust(0, (-1.0,), 1e-6),
        ForceFunction(0, lambda t, x, v: (1e-9 * math.sin(t),)),
    ],
)
def test_a_potential_that_is_another_functions_is_refused_by_name_whatever_else_acts(share, other):
    with pytest.raises(
        GuardFailed, match="the energy of ForceFunction on body 0 is not that of its function"
    ):
        energy_of(swing(share, other))


@pytest.mark.parametrize("share", [2.0, 1.01])
def test_a_wrong_potential_is_found_out_where_nothing_else_acts(share):
    with pytest.raises(GuardFailed, match="energy changed"):
        energy_of(swing(share))


@pytest.mark.parametrize("others", [(), (Drag(0, 1e-12),)])
def test_a_potential_that_is_off_by_little_leaves_that_in_doubt(others):
    found, _ = energy_of(swing(1.0 + 1e-7, *others))
    assert abs(found.value - 0.2275) <= found.error < 1e-7


def test_a_force_that_turns_with_the_velocity_may_have_a_potential_beside():
    """A charge in a magnetic field and a bowl: the field does no work."""
    force = ForceFunction(
        0,
        lambda t, x, v: (3.0 * v[1] - 2.0 * x[0], -3.0 * v[0] - 2.0 * x[1]),
        energy=lambda x: x[0] ** 2 + x[1] ** 2,
    )
    body = Body(1.0, (1.0, 0.0), (0.0, 1.0))
    found, _ = energy_of(Scene((body,), (force,), until=10.0))
    assert abs(found.value - 1.5) <= found.error < 1e-10
    found, _ = energy_of(Scene((body,), (force, Drag(0, 1e-12)), until=10.0))
    assert abs(found.value - 1.5) <= found.error < 1e-8


def test_the_word_of_an_author_that_energy_is_kept_is_held_against_the_motion():
    assert plan(swing(), {O.ENERGY}).model == "integration"
    found, _ = energy_of(swing())
    assert abs(found.value - 0.2275) <= found.error < 1e-12
