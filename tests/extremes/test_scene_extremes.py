"""Scenes at the ends of the range: a right number, a named outcome, or a sentence; never a hang, a nan or a traceback."""

import json
import math
from itertools import pairwise

import pytest

from corollary.derive.ready_scenes import ready_scenes, run
from corollary.scenes.forces.contact import Contact
from corollary.scenes.integrate.regularised import collide
from corollary.scenes.row import RowOfBodies
from corollary.scenes.run import BadSetting, GuardFailed

pytestmark = pytest.mark.whole

SCENES = ready_scenes()


def run_or_refusal(scene, settings, tolerance):
    try:
        return run(scene, settings, tolerance)
    except (BadSetting, GuardFailed) as refused:
        return str(refused)


def numbers(value):
    return [x for part in value for x in numbers(part)] if isinstance(value, tuple) else [value]


@pytest.mark.parametrize("k", [1e-12, 1e3, 1e12, 1e18])
def test_hardness_sets_the_time_and_nothing_else(k):
    found, soft = run("cradle", {"q": 1.5, "k": k}), run("cradle", {"q": 1.5})
    assert found.observed["velocities"] == soft.observed["velocities"]


@pytest.mark.parametrize("size", [1e-150, 1e-30, 1e30, 1e150])
@pytest.mark.parametrize("name", ["m", "k", "v0"])
def test_sizes_far_from_any_classroom_are_right_or_refused_in_a_sentence(name, size):
    plain = run("cradle", {"q": 1.5}).observed["velocities"]
    found = run_or_refusal("cradle", {"q": 1.5, name: size}, 1e-12)
    if isinstance(found, str):
        assert "range of a computer" in found
        return
    scale = size if name == "v0" else 1.0
    assert [v / scale for v in found.observed["velocities"]] == pytest.approx(plain, rel=1e-12)


# A contact that never ends lasts for ever, and its weight pushes for ever.
MAY_BE_INFINITE = ("duration", "impulse", "rests_after", "energy_ratio")


@pytest.mark.parametrize("scene", SCENES)
def test_every_setting_pushed_to_its_ends(scene):
    """Each number setting in turn, very small and very large: whatever comes out is finite, or its infinity has a name."""
    for setting in SCENES[scene].settings:
        if setting.whole or not isinstance(setting.value, float):
            continue
        for value in (1e-9, 1e9):
            found = run_or_refusal(scene, {setting.name: value}, 1e-8)
            if isinstance(found, str):
                assert found.endswith("."), (setting.name, value)
                continue
            for name, seen in found.observed.items():
                for x in numbers(seen):
                    assert not math.isnan(x), (setting.name, value, name)
                    assert math.isfinite(x) or name in MAY_BE_INFINITE, (setting.name, value, name)


@pytest.mark.parametrize("mass", [1e-6, 1e-4, 1e-2, 1e-3, 1e2, 1e6, 1e9])
def test_a_middle_ball_of_any_mass(mass):
    found = collide(
        RowOfBodies((1.0, mass, 1.0), (1.0, 0.0, 0.0), (0.0, 0.0), (Contact(1.0, 1.5),) * 2), 1e-11
    )
    a, b, c = found.velocities
    assert a + mass * b + c == pytest.approx(1.0, abs=1e-11 * max(1.0, mass * abs(b)))
    assert a * a + mass * b * b + c * c == pytest.approx(1.0, abs=1e-8)
    if mass >= 1e6:
        assert a == pytest.approx(-1.0, abs=3.0 / mass + 1e-8)


@pytest.mark.parametrize(
    "masses",
    [
        (1.0, 1e-7, 1.0),
        (1.0, 1e-9, 1.0),
        (1.0, 1e-9, 1e-9, 1.0),
        (math.inf, 1e-8, 1.0),
        (1.0, 1e-8) * 20 + (1.0,),
    ],
)
@pytest.mark.parametrize("gap", [0.0, 0.01])
def test_balls_lighter_than_dust_between_others_are_refused_within_a_few_steps(masses, gap):
    between = len(masses) - 1
    velocities = (0.0,) * between + (-1.0,)
    with pytest.raises(GuardFailed, match=r"does not end within 4000 steps\. Make the masses less unequal"):
        collide(RowOfBodies(masses, velocities, (gap,) * between, (Contact(1.0, 1.5),) * between), 1e-12)


def test_a_ball_lighter_than_dust_that_is_not_caught_between_others_is_followed():
    row = RowOfBodies((1.0, 1e-9, 1.0), (1.0, 0.0, 5.0), (0.0, 0.0), (Contact(1.0, 1.5),) * 2)
    assert collide(row, 1e-12).velocities == pytest.approx((1.0, 2.0, 5.0), abs=1e-8)


@pytest.mark.parametrize("near", [1e-3, 1e-6, 1e-8, 1e-10])
def test_grazing(near):
    """A hit that barely is one: the deflection is right to the last digits, since (D - b)(D + b) loses none."""
    b = 0.04 * (1.0 - near)
    found = run("spheres", {"eta": 0.0, "dy": b})
    assert found.outcome == "released"
    assert found.observed["energy_ratio"] == pytest.approx(1.0, abs=1e-14)
    # Hard spheres would turn the relative velocity by 2 acos(b/D); soft ones turn it by less, and not the other way.
    assert 1e-15 > found.observed["velocities"][1] > -2.0 * math.sqrt(2.0 * near)


@pytest.mark.parametrize("q", [1.0, 1.001, 1.5, math.e, 9.999, 10.0])
@pytest.mark.parametrize("count", [2, 3, 20])
def test_cradles_of_any_length_and_exponent_keep_momentum_and_energy(count, q):
    found = run("cradle", {"N": count, "q": q, "v0": 1.0}, tolerance=1e-9)
    v = found.observed["velocities"]
    assert math.fsum(v) == pytest.approx(1.0, abs=1e-12)
    assert math.fsum(x * x for x in v) == pytest.approx(1.0, abs=1e-6)
    # No ball is left behind one it should have pushed on; speeds below the tolerance are not told apart.
    assert all(a <= b + 1e-9 for a, b in pairwise(v))


def test_a_run_can_be_written_down():
    found = run("cradle", {"q": 1.5})
    assert json.loads(json.dumps({"observed": found.observed, "why": found.why, "seconds": found.seconds}))[
        "observed"
    ]
