"""Far from the origin a scene comes out as it does near it: what knows no origin is followed from one among its bodies."""

from __future__ import annotations

import math
from dataclasses import replace
from fractions import Fraction

import pytest

from corollary.scenes.forces.contact import Contact
from corollary.scenes.forces.friction import Friction
from corollary.scenes.forces.function import ForceFunction
from corollary.scenes.forces.spring import Spring
from corollary.scenes.forces.wall import HardWall
from corollary.scenes.forces.weight import Weight
from corollary.scenes.plan import play
from corollary.scenes.run import Observable as O
from corollary.scenes.run import Run, components
from corollary.scenes.scene import Body, Force, Scene

FAR = 2.0**20
ON_A_LINE = (
    Scene(
        (Body(0.2, (0.09375,), (1.0,), 0.09375), Body(0.7, (0.4375,), (-1.0,), 0.078125)),
        (Contact(1823.0, 1.5, 48.0), Friction(0, 0.2), Spring((0, 1), 9.5, 0.5)),
        until=0.19,
    ),
    Scene(  # still closed at the end: it had taken ten seconds at 1e4 m, and was refused at 1e5 m
        (Body(0.2, (0.125,), (2.0,), 0.0625), Body(0.05, (0.5,), (0.4,), 0.125)),
        (Contact(1065.0, 1.0, 14.0),),
        until=0.28,
    ),
)


def moved(scene: Scene, by: tuple[float, ...]) -> Scene:
    """All of it elsewhere; what its places are there doubles are to hold."""
    places = [tuple(x + o for x, o in zip(b.place, by, strict=True)) for b in scene.bodies]
    back = [tuple(x - o for x, o in zip(place, by, strict=True)) for place in places]
    assert back == [b.place for b in scene.bodies]

    def there(force: Force) -> Force:
        if not isinstance(force, HardWall):
            return force
        far = sum(Fraction(n) * Fraction(o) for n, o in zip(force.normal, by, strict=True))
        return replace(force, offset=float(Fraction(force.offset) + far))

    bodies = (replace(b, place=place) for b, place in zip(scene.bodies, places, strict=True))
    return replace(scene, bodies=tuple(bodies), forces=tuple(map(there, scene.forces)))


def velocities_agree(near: Run, far: Run) -> None:
    """Within what both state."""
    one, other = near.measured["velocities"], far.measured["velocities"]
    each = (components(values) for values in (one.value, other.value, one.error, other.error))
    assert all(abs(a - b) <= e + f for a, b, e, f in zip(*each, strict=True))


@pytest.mark.parametrize("scene", ON_A_LINE)
@pytest.mark.parametrize("tolerance", [1e-8, 1e-10, 1e-12])
def test_contacts_far_away_are_as_sure_as_near_ones(scene, tolerance):
    near, far = (play(s, {O.VELOCITIES}, tolerance) for s in (scene, moved(scene, (FAR,))))
    velocities_agree(near, far)
    errors = zip(far.errors["velocities"], near.errors["velocities"], strict=True)
    assert all(one <= 2.0 * other for one, other in errors)


def test_rounding_of_places_that_stay_large_is_in_the_error():
    """A nail at the origin keeps places large: doubles there are what they are."""
    nail = Body(math.inf, (0.0, 50.0), (0.0, 0.0))
    bodies = [Body(0.1, place, (v, 0.0), 0.02) for place, v in (((0.0, 0.0), 1.0), ((0.0625, 0.0179), 0.0))]
    near = play(Scene((*bodies, nail), (Contact(2e4),)), {O.VELOCITIES})
    away = (replace(b, place=(b.place[0] + 1e5, b.place[1])) for b in bodies)
    far = play(Scene((*away, nail), (Contact(2e4),)), {O.VELOCITIES})
    velocities_agree(near, far)
    assert max(far.errors["velocities"]) > 2.0 * max(near.errors["velocities"])


@pytest.mark.parametrize("by", [(FAR, 0.0), (0.0, -FAR), (FAR, FAR)])
def test_places_are_told_from_the_origin_of_the_scene(by):
    bodies = (
        Body(0.3, (0.125, 0.25), (1.0, 0.0), 0.0625),
        Body(0.5, (0.75, 0.3125), (-1.0, 0.5), 0.0625),
    )
    wall = HardWall((0.0, 1.0), -0.25, 0.5, 0.1)
    scene = Scene(bodies, (Contact(1e4), Spring((0, 1), 10.0, 0.5), Weight(9.8), wall), until=0.5)
    what = {O.VELOCITIES, O.TRAJECTORY}
    near = play(scene, what, times=(0.1, 0.5))
    far = play(moved(scene, by), what, times=(0.1, 0.5))
    for a, b, error in zip(
        far.observed["velocities"], near.observed["velocities"], near.errors["velocities"], strict=True
    ):
        assert abs(a - b) <= 2.0 * error < 1e-8
    for i, (x, error) in enumerate(zip(far.observed["trajectory"], far.errors["trajectory"], strict=True)):
        expected = near.observed["trajectory"][i] + by[i % 2]
        assert abs(x - expected) <= error + near.errors["trajectory"][i]
        assert error <= near.errors["trajectory"][i] + 2.0 * math.ulp(x)


def test_what_knows_an_origin_stays_where_it_is():
    """A force of places, and distances from the origin: one that pulls a body to a place a long way off."""
    scene = Scene(
        (Body(1.0, (FAR + 1.0,), (0.0,), 0.25), Body(1.0, (FAR + 3.0,), (0.0,), 0.25)),
        (ForceFunction(0, lambda t, x, v: (FAR - x[0],)), Contact(1e3)),
        until=5.0,
    )
    found = play(scene, {O.VELOCITIES, O.TURNING_POINTS}, 1e-8, (5.0,))
    assert found.observed["velocities"][0] == pytest.approx(-math.sin(5.0), abs=1e-6)
    assert found.observed["turning_points"] == pytest.approx((FAR - 1.0, FAR + 1.0), abs=1e-6)


def test_velocities_are_the_same_whatever_else_is_asked():
    far = moved(ON_A_LINE[0], (FAR,))
    alone = play(far, {O.VELOCITIES})
    beside = play(far, {O.VELOCITIES, O.TURNING_POINTS, O.ENERGY})
    assert beside.measured["velocities"] == alone.measured["velocities"]
    assert list(beside.measured) == ["velocities", "turning_points", "energy"]
