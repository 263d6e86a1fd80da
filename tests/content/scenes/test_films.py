"""Films of the ready-made scenes, held against textbooks: what is conserved, what bodies do in the end, and where they are between."""

from __future__ import annotations

import math

import pytest

from corollary.derive.ready_scenes import film_of, ready_scenes
from corollary.scenes.forces.fields import Weight
from corollary.scenes.scene import Body, Scene

SCENES = ready_scenes()

HEAD_ON = {"mA": 2.0, "mB": 3.0, "dx": 0.08, "dy": 0.0, "vA": (4.0, 0.0), "vB": (-1.5, 0.0)}


def test_spheres_meet_where_straight_lines_do_and_part_as_elastic_ones():
    film = film_of("spheres", {**HEAD_ON, "k": 1e9, "eta": 0.0})
    assert film is not None
    (ax, _), (bx, _) = film.velocities[-1]
    assert (ax, bx) == pytest.approx((-2.6, 2.9), abs=1e-6)
    early, deepest = (
        film.times[5],
        (5 * 1.2 * 5.5**2 / (4 * 1e9)) ** 0.4,
    )  # Hertz: Landau and Lifshitz, Elasticity, (9.15)
    assert film.places[5][0][0] == pytest.approx(4.0 * early)
    for frame in range(len(film.times)):
        assert film.momentum(frame) == pytest.approx((3.5, 0.0), abs=1e-6)
        gap = math.dist(*film.places[frame]) - 2 * film.radii[0]
        assert gap > -1.001 * deepest
    assert film.kinetic(-1) == pytest.approx(19.375, rel=1e-6)


def test_spheres_that_never_meet_have_no_film():
    assert film_of("spheres", {**HEAD_ON, "vA": (-4.0, 0.0), "vB": (1.0, 0.0)}) is None


def test_a_bullet_is_caught_and_friction_is_seen_only_where_it_is_asked_for():
    shot = {"m": 0.1, "M": 1.9, "v": 20.0}
    free, rough = film_of("bullet_block", shot), film_of("bullet_block", {**shot, "mu": 0.5, "g": 9.8})
    assert free is not None
    assert rough is not None
    assert free.momentum(-1)[0] == pytest.approx(2.0)
    assert rough.momentum(-1)[0] == pytest.approx(0.0, abs=1e-9)
    start, end = rough.places[0][1][0], rough.places[-1][1][0]
    assert end - start == pytest.approx(1.0 / (2 * 0.5 * 9.8), rel=1e-3)


def test_the_energy_of_a_swing_is_kept_and_a_bullet_in_a_pendulum_loses_what_the_catch_takes():
    swing = film_of("pendulum_block", {"m": 1.0, "M": 2.0, "L": 1.0, "g": 9.8})
    shot = film_of("ballistic_pendulum", {"mA": 0.01, "mB": 0.99, "v": 100.0, "L": 1.0, "g": 9.8, "dt": 1e-3})
    assert swing is not None
    assert shot is not None
    total = [swing.kinetic(k) + swing.stored[k] for k in range(len(swing.times))]
    assert total == pytest.approx([total[0]] * len(total), abs=1e-4)
    first, last = (shot.kinetic(k) + shot.stored[k] for k in (0, -1))
    assert (first, last) == (pytest.approx(50.0), pytest.approx(0.5, rel=1e-2))


def test_a_floor_gives_back_what_it_does_and_a_wall_turns_one_component():
    bounced = film_of("ball_on_floor", {"m": 0.1, "k": 1e6, "R": 0.02, "y0": 0.021, "v0": -2.8, "g": 9.8})
    wall = film_of("wall", {"m": 0.2, "v0": 8.0, "theta": math.pi / 6, "dt": 0.01})
    assert bounced is not None
    assert wall is not None
    first, last = (bounced.kinetic(k) + bounced.stored[k] for k in (0, -1))
    assert last == pytest.approx(first, rel=1e-4)
    assert bounced.velocities[-1][0][1] > 0.0 > bounced.velocities[0][0][1]
    assert wall.velocities[-1][0] == pytest.approx((8.0 * math.cos(math.pi / 6), 4.0), rel=1e-6)


def test_a_composed_scene_is_filmed_until_its_end():
    fall = Scene((Body(1.0, (0.0, 0.0), (1.0, 0.0)),), (Weight(9.8),), until=2.0)
    film = film_of(fall, {})
    assert film is not None
    assert film.places[-1][0] == pytest.approx((2.0, -19.6))
    assert film_of(Scene(fall.bodies, (Weight(9.8),)), {}) is None


def test_what_is_known_at_one_moment_only_has_no_film():
    assert film_of("rocket", {}) is None


def test_one_a_million_times_as_heavy_counts_in_no_total():
    film = film_of("spheres", {**HEAD_ON, "mB": 3e9, "k": 1e9, "eta": 0.0})
    assert film is not None
    assert film.loose == (0,)
    assert film.velocities[-1][0][0] == pytest.approx(-7.0, abs=1e-3)
