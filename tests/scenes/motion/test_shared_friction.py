"""Several surfaces that hold the same: bodies stay as long as all together can hold them, and then all give way."""

import math
from collections.abc import Sequence

import pytest

from corollary.scenes.forces.contact import Contact
from corollary.scenes.forces.friction import Friction
from corollary.scenes.forces.function import ForceFunction
from corollary.scenes.forces.rod import Rod, String
from corollary.scenes.forces.wall import HardWall
from corollary.scenes.forces.weight import Weight
from corollary.scenes.plan import play
from corollary.scenes.run import Observable, components
from corollary.scenes.scene import Body, Force, Scene

G, END, ALONG = 9.8, 4.0, (0.6, 0.8)


def speeds(bodies: Sequence[Body], forces: Sequence[Force], until: float = END) -> tuple[float, ...]:
    """The velocities at the end, each known to 1e-9 by the scene's own word."""
    measured = play(Scene(tuple(bodies), tuple(forces), until=until), {Observable.VELOCITIES}).measured
    assert max(components(measured["velocities"].error)) < 1e-8
    return components(measured["velocities"].value)


def pulled(rate: float, mass: float, holds: float, brakes: float) -> float:
    """The speed at the end of what a force rate * t tears off when it is `holds` (N), and `brakes` (N) slow from then on."""
    begins = holds / rate
    return max((0.5 * rate * (END**2 - begins**2) - brakes * (END - begins)) / mass, 0.0)


def body(mass: float, x: float, axes: int) -> Body:
    return Body(mass, (x,) if axes == 1 else tuple(c * x for c in ALONG), (0.0,) * axes)


def pull(rate: float, axes: int, i: int = 0) -> ForceFunction:
    return ForceFunction(i, lambda t, x, v: (rate * t,) if axes == 1 else tuple(c * rate * t for c in ALONG))


def along(speed: float, axes: int) -> tuple[float, ...]:
    return (speed,) if axes == 1 else tuple(c * speed for c in ALONG)


@pytest.mark.parametrize("axes", [1, 2])
@pytest.mark.parametrize(
    "tables",
    [
        ((0.3, 0.35), (0.1, 0.45)),
        ((0.2, 0.3), (0.2, 0.7)),
        ((0.0, 0.1), (0.2, 0.7)),
        ((0.3, 0.3), (0.4, 0.4)),
    ],
)
def test_a_body_on_two_tables(axes, tables):
    frictions = [Friction(0, mu, static=static) for mu, static in tables]
    holds, brakes = (sum(each) * 2.0 * G for each in ((s for _, s in tables), (mu for mu, _ in tables)))
    true = along(pulled(8.0, 2.0, holds, brakes), axes)
    assert speeds([body(2.0, 0.0, axes)], [*frictions, pull(8.0, axes)]) == pytest.approx(true, abs=1e-9)


def test_two_tables_hold_what_neither_could_alone():
    push = ForceFunction(0, lambda t, x, v: (15.0,))
    tables = [Friction(0, 0.3, static=0.35), Friction(0, 0.1, static=0.45)]
    assert speeds([body(2.0, 0.0, 1)], [*tables, push]) == pytest.approx((0.0,), abs=1e-9)


@pytest.mark.parametrize(("link", "axes"), [(String, 1), (String, 2), (Rod, 2)])
@pytest.mark.parametrize("statics", [(0.5, 0.6), (0.3, 0.4)])
def test_two_tied_blocks(link, axes, statics):
    blocks = [body(1.0, 1.0, axes), body(2.0, 0.0, axes)]
    forces = [link((0, 1)), Friction(0, 0.3, static=statics[0]), Friction(1, 0.4, static=statics[1])]
    true = pulled(5.0, 3.0, (statics[0] + 2.0 * statics[1]) * G, 1.1 * G)
    found = speeds(blocks, [*forces, pull(5.0, axes)])
    assert found == pytest.approx(along(true, axes) * 2, abs=1e-9)


@pytest.mark.parametrize("rate", [3.0, 5.0, 11.0])
def test_three_blocks_on_strings(rate):
    blocks = [body(1.0, 2.0, 1), body(2.0, 1.0, 1), body(0.5, 0.0, 1)]
    forces = [String((0, 1)), String((1, 2)), *(Friction(i, 0.3) for i in range(3)), pull(rate, 1)]
    true = pulled(rate, 3.5, 0.3 * 3.5 * G, 0.3 * 3.5 * G)
    assert speeds(blocks, forces) == pytest.approx((true,) * 3, abs=1e-9)


@pytest.mark.parametrize("static", [0.3, 0.5])
def test_blocks_tied_on_a_floor_that_presses_them(static):
    blocks = [Body(1.0, (1.0, 0.0), (0.0, 0.0)), Body(2.0, (0.0, 0.0), (0.0, 0.0))]
    floor = HardWall((0.0, 1.0), restitution=0.0, mu=0.3, static=static)
    push = ForceFunction(0, lambda t, x, v: (5.0 * t, 0.0))
    true = pulled(5.0, 3.0, static * 3.0 * G, 0.9 * G)
    assert speeds(blocks, [String((0, 1)), floor, Weight(G), push]) == pytest.approx(
        (true, 0.0, true, 0.0), abs=1e-9
    )


@pytest.mark.parametrize("press", [0.0, 3.0])
@pytest.mark.parametrize("statics", [(0.5, 0.3), (0.4, 0.2)])
def test_a_body_on_a_table_and_at_a_rough_wall(press, statics):
    wall = HardWall((0.0, 1.0), restitution=0.0, mu=0.2, static=statics[1])
    push = ForceFunction(0, lambda t, x, v: (8.0 * t, -press))
    true = pulled(8.0, 2.0, statics[0] * 2.0 * G + statics[1] * press, 0.4 * 2.0 * G + 0.2 * press)
    found = speeds([Body(2.0, (0.0, 0.0), (0.0, 0.0))], [Friction(0, 0.4, static=statics[0]), wall, push])
    assert found == pytest.approx((true, 0.0), abs=1e-9)


def test_belts_that_pull_three_ways_leave_a_body_where_their_pulls_cancel():
    belts = [Friction(0, 0.3, belt=way) for way in ((1.0, 0.0), (0.0, 1.0), (-1.0, 0.0))]
    found = speeds([Body(1.0, (0.0, 0.0), (0.0, 0.0))], belts, until=20.0)
    assert found == pytest.approx((0.0, 1.0 / math.sqrt(3.0)), abs=1e-9)  # Fermat's point of the three


@pytest.mark.parametrize("eta", [0.0, 5.0])
def test_a_dashpot_that_sets_in_at_the_start_breaks_loose_what_rests(eta):
    """At the very touch nothing pushes yet; what is pushed a moment later begins to slip that way, as if there had been a gap."""
    found = [
        speeds(
            [Body(1.0, (0.0,), (1.0,), 0.1), Body(1.0, (0.2 + gap,), (0.0,), 0.1)],
            [Contact(1e4, 1.0, eta), Friction(1, 0.2)],
            until=0.01,
        )
        for gap in (0.0, 1e-11)
    ]
    assert found[0] == pytest.approx(found[1], abs=1e-8)
    assert math.fsum(found[0]) < 0.981
