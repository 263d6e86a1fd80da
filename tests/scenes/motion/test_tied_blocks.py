"""Blocks that rods hold together in a line stop together, and from then on all that is static holds: they set off when that is overcome."""

import math
import random
from itertools import pairwise

import pytest
from tests.shares import share

from corollary.scenes.forces.friction import Friction
from corollary.scenes.forces.function import ForceFunction
from corollary.scenes.forces.rod import Rod, String
from corollary.scenes.forces.spring import Spring
from corollary.scenes.forces.wall import HardWall
from corollary.scenes.forces.weight import Weight
from corollary.scenes.plan import play
from corollary.scenes.run import Observable as O
from corollary.scenes.scene import Body, Scene

G = 9.8


class Train:
    """Random blocks, what slows them as they slide and what holds them at rest (N)."""

    def __init__(self, seed, least=1.2):
        self.random = random.Random(seed)
        self.count = self.random.choice([2, 3])
        self.masses = [self.random.uniform(0.5, 2.0) for _ in range(self.count)]
        self.kinetic = [self.random.uniform(0.05, 0.2) for _ in range(self.count)]
        self.static = [mu * self.random.uniform(least, 2.0) for mu in self.kinetic]
        self.pulled = self.random.randrange(self.count)
        self.mass = sum(self.masses)
        self.brake = G * sum(m * mu for m, mu in zip(self.masses, self.kinetic, strict=True))
        self.holds = G * sum(m * mu for m, mu in zip(self.masses, self.static, strict=True))

    def rubs(self):
        rubs = zip(self.kinetic, self.static, strict=True)
        return tuple(Friction(i, mu, static=static) for i, (mu, static) in enumerate(rubs))

    def rods(self):
        return tuple(Rod(pair) for pair in pairwise(range(self.count)))


def holds_to(found, wanted):
    """Whether all velocities are what they should be, closely, and nothing is said against them."""
    values, errors = found.observed["velocities"], found.errors["velocities"]
    assert found.warnings == ()
    for value, error, true in zip(values, errors, wanted, strict=True):
        assert abs(value - true) <= error + 1e-13
        assert error < 1e-6


@pytest.mark.parametrize("seed", share(range(12), 3))
@pytest.mark.parametrize("late", [-0.05, 0.3])
def test_a_train_that_slid_to_rest_sets_off_as_all_static_friction_is_overcome(seed, late):
    train = Train(seed)
    speed, way = train.random.uniform(0.2, 0.5), train.random.choice([1.0, -1.0])
    begins = 1.2 * speed * train.mass / train.brake
    pull = ForceFunction(train.pulled, lambda t, x, v: (way * train.holds * max(t - begins, 0.0),))
    bodies = tuple(Body(m, (float(i),), (speed,)) for i, m in enumerate(train.masses))
    scene = Scene(bodies, (*train.rods(), *train.rubs(), pull), until=begins + 1.0 + late)
    gained = train.holds * ((1.0 + late) ** 2 - 1.0) / 2.0 - train.brake * late
    holds_to(play(scene, {O.VELOCITIES}), [way * max(gained, 0.0) / train.mass] * train.count)


@pytest.mark.parametrize("seed", share([0, 2, 5, 9, 11], 2))
@pytest.mark.parametrize("late", [-0.05, 0.3])
def test_a_train_that_a_wall_stopped_does_so_too(seed, late):
    """The wall gives the train its momentum back to nothing; all that slid before is at rest at once."""
    train = Train(seed)
    pull = ForceFunction(train.pulled, lambda t, x, v: (train.holds * max(t - 1.0, 0.0),))
    bodies = tuple(Body(m, (float(i),), (-3.0,)) for i, m in enumerate(train.masses))
    wall = HardWall((1.0,), -0.3, restitution=0.0, only=(0,))
    scene = Scene(bodies, (*train.rods(), *train.rubs(), pull, wall), until=2.0 + late)
    gained = train.holds * ((1.0 + late) ** 2 - 1.0) / 2.0 - train.brake * late
    holds_to(play(scene, {O.VELOCITIES}), [max(gained, 0.0) / train.mass] * train.count)


@pytest.mark.parametrize("seed", share([1, 4, 6, 16, 35, 37], 2))
def test_on_an_incline_it_stays_where_it_stopped_until_a_pull_overcomes_what_holds(seed):
    train = Train(seed)
    slope = train.random.uniform(0.05, 0.2)
    along, across = (math.cos(slope), math.sin(slope)), (-math.sin(slope), math.cos(slope))
    kinetic = [math.tan(slope) * train.random.uniform(1.0, 1.5) for _ in range(train.count)]
    presses = [G * m * math.cos(slope) for m in train.masses]
    brake = sum(p * mu for p, mu in zip(presses, kinetic, strict=True))
    holds, drawn = 1.5 * brake, train.mass * G * math.sin(slope)
    speed, late = 1.0, 0.3
    begins = 1.1 * speed * train.mass / (brake + drawn)
    pull = ForceFunction(
        train.pulled, lambda t, x, v: tuple(a * (holds + drawn) * max(t - begins, 0.0) for a in along)
    )
    bodies = tuple(
        Body(m, (i * along[0], i * along[1]), (speed * along[0], speed * along[1]))
        for i, m in enumerate(train.masses)
    )
    floors = (
        HardWall(across, restitution=0.0, mu=mu, static=1.5 * mu, only=(i,)) for i, mu in enumerate(kinetic)
    )
    scene = Scene(bodies, (Weight(G), *train.rods(), pull, *floors), until=begins + 1.0 + late)
    gained = (holds + drawn) * ((1.0 + late) ** 2 - 1.0) / 2.0 - (brake + drawn) * late
    holds_to(play(scene, {O.VELOCITIES}), [gained / train.mass * a for _ in bodies for a in along])


@pytest.mark.parametrize("seed", share(range(8), 3))
def test_two_blocks_on_a_spring_are_one(seed):
    """To and fro, until static friction holds both: as one block of their mass on one surface that holds and brakes as much."""
    train = Train(seed, least=1.0)
    masses, rubs = train.masses[:2], train.rubs()[:2]
    brake, holds = (
        sum(G * m * mu for m, mu in zip(masses, coefficients[:2], strict=True))
        for coefficients in (train.kinetic, train.static)
    )
    stiffness, mass, far = train.random.uniform(5.0, 50.0), sum(masses), 30.0
    stretched = train.random.uniform(2.0, 8.0) * holds / stiffness
    until = train.random.uniform(1.0, 12.0) * math.sqrt(mass / stiffness)
    nail = Body(math.inf, (0.0,), (0.0,))
    both = tuple(Body(m, (far + stretched + i,), (0.0,)) for i, m in enumerate(masses))
    moved = tuple(Friction(i + 1, rub.mu, static=rub.static) for i, rub in enumerate(rubs))
    spring = Spring((0, 1), stiffness, length=far)
    two = play(Scene((nail, *both), (Rod((1, 2)), *moved, spring), until=until), {O.VELOCITIES})
    weight = mass * G
    alone = Body(mass, (far + stretched,), (0.0,))
    rub = Friction(1, brake / weight, static=holds / weight)
    one = play(Scene((nail, alone), (rub, spring), until=until), {O.VELOCITIES})
    assert one.warnings == two.warnings == ()
    allowed = one.errors["velocities"][1] + max(two.errors["velocities"])
    assert allowed < 1e-6
    for value in two.observed["velocities"][1:]:
        assert abs(value - one.observed["velocities"][1]) <= allowed


@pytest.mark.parametrize("seed", share([0, 2], 1))
def test_blocks_on_slack_strings_that_stop_in_turn_are_no_coincidence(seed):
    """Bodies that are tied come to rest one after the other within rounding, in another order at another tolerance: nothing comes of it."""
    draw = random.Random(seed)
    often = draw.uniform(0.5, 3.0)
    pull = ForceFunction(4, lambda t, x, v: (20.0 * math.sin(often * t),))
    gaps = [draw.choice([0.0, 0.05 * draw.random()]) for _ in range(4)]
    bodies = tuple(
        Body(draw.uniform(0.5, 2.0), (float(i),), (draw.choice([0.0, 0.0, 0.3]),)) for i in range(5)
    )
    strings = (String((i, i + 1), 1.0 + gap) for i, gap in enumerate(gaps))
    rubs = []
    for i in range(5):
        mu = draw.uniform(0.05, 0.2)
        rubs.append(Friction(i, mu, static=mu * draw.choice([1.0, 1.5])))
    assert play(Scene(bodies, (*strings, *rubs, pull), until=4.0), {O.VELOCITIES}).warnings == ()
