"""Second ways with settings drawn at random: they meet the first within what both state, and are not the first again."""

import math
from random import Random

import pytest

from corollary.derive.ready_scenes import ready_scenes, run
from corollary.scenes.run import components

pytestmark = pytest.mark.whole

SCENES = ready_scenes()


def any_of(draw: Random, low: float, high: float) -> float:
    return 10.0 ** draw.uniform(low, high)


def absorbed_drop(draw):
    names = {"m": any_of(draw, -1, 1), "dm": any_of(draw, -2, 1), "v": draw.uniform(-9, 9)}
    return names | {"u": draw.uniform(-9, 9), "F": draw.choice([0.0, 4.0]), "dt": any_of(draw, -6, -1)}


def atom(draw):
    """Either way round, on a line or in a plane; some of them leave."""
    start = {"v0": draw.choice([-1.0, 1.0]) * any_of(draw, -1, 0.8), "r0": draw.uniform(0.65, 1.35)}
    return start | {"m": any_of(draw, -1, 1), "dimension": draw.choice([1.0, 2.0])}


def ball_on_floor(draw):
    names = {"m": any_of(draw, -2, 1), "k": any_of(draw, 4, 8), "q": draw.choice([1.0, 1.5, 2.0])}
    damped = draw.choice([{}, {"eta": any_of(draw, -2, 2), "g": 0.0, "q": 1.0}])
    start = {"y0": 0.02 + draw.choice([0.0, any_of(draw, -6, 0)]), "v0": -any_of(draw, -1, 1)}
    return names | start | {"g": draw.choice([0.0, 9.8])} | damped


def ballistic_pendulum(draw):
    masses = {"mA": any_of(draw, -3, -1), "mB": any_of(draw, -0.5, 1)}
    return masses | {"v": any_of(draw, 0.5, 1.2), "L": any_of(draw, 0, 1), "dt": any_of(draw, -6, -3)}


def bouncing_ball(draw):
    names = {"h0": any_of(draw, -3, 2), "r": draw.choice([0.0, 1.0, draw.random()])}
    return names | {"n": float(draw.randint(1, 6)), "g": any_of(draw, -1, 2)}


def cradle(draw):
    """Of two balls; more are followed in steps in any case."""
    names = {"N": 2.0, "q": draw.choice([1.0, 1.5, 3.0]), "v0": any_of(draw, -2, 1)}
    masses = {"masses": tuple(any_of(draw, -1, 0.5) for _ in range(2))} if draw.random() < 0.5 else {}
    gaps = {"gaps": (any_of(draw, -5, -2),)} if draw.random() < 0.5 else {}
    return names | masses | gaps


def ions(draw):
    names = {"C": any_of(draw, -5, -1), "mA": any_of(draw, -2, 6), "mB": any_of(draw, -2, 0)}
    names |= draw.choice([{}, {"mA": names["mB"], "mB": names["mA"]}])
    return names | {"v": any_of(draw, -1, 1), "s": draw.choice([0.0, draw.uniform(0.0, 0.079)])}


def kick(draw):
    names = {"m": any_of(draw, -2, 2), "v0": draw.choice([-1.0, 1.0]) * any_of(draw, -3, 6)}
    return names | {"F": any_of(draw, -6, 3), "dt": any_of(draw, -9, 0), "pulse": float(draw.randint(1, 8))}


def pendulum_block(draw):
    names = {"m": any_of(draw, -2, 2), "L": any_of(draw, -1, 1), "k": any_of(draw, 6, 11)}
    return names | {"M": draw.choice([any_of(draw, -2, 2), names["m"]]), "g": any_of(draw, 0, 1.3)}


def rocket(draw):
    names = {"m0": any_of(draw, 0, 6), "N": float(round(any_of(draw, 0, 4)))}
    return names | {"m1": any_of(draw, -18, 0), "v_rel": any_of(draw, 0, 4)}


def snowball(draw):
    names = {"M": any_of(draw, 0, 2), "Ms": any_of(draw, 0, 2), "m": any_of(draw, -1, 1)}
    return names | {"v": any_of(draw, -1, 2), "theta": draw.uniform(0.0, 1.5)}


def spheres(draw):
    names = {"mA": any_of(draw, -2, 0), "mB": any_of(draw, -2, 0), "k": any_of(draw, 4, 7), "eta": 0.0}
    return names | {"q": draw.choice([1.0, 1.5, 2.0]), "dy": draw.uniform(-0.045, 0.045)}


def super_ball(draw):
    names = {"mA": any_of(draw, -1, 1), "mB": any_of(draw, -2, 0), "h0": any_of(draw, -1, 1)}
    return names | {"q": draw.choice([1.0, 1.5]), "gap": any_of(draw, -5, -2)}


def two_blocks(draw):
    names = {"mA": any_of(draw, -2, 2), "mB": any_of(draw, -2, 2), "vA": draw.uniform(-1, 9)}
    return names | {"vB": draw.uniform(-5, 4), "r": draw.choice([0.0, 1.0, draw.random()])}


def wall(draw):
    names = {"m": any_of(draw, -2, 1), "v0": any_of(draw, -1, 2), "dt": any_of(draw, -5, -1)}
    return names | {"theta": draw.uniform(0.01, 0.5 * math.pi)}


DRAWN = [
    absorbed_drop,
    atom,
    ball_on_floor,
    ballistic_pendulum,
    bouncing_ball,
    cradle,
    ions,
    kick,
    pendulum_block,
    rocket,
    snowball,
    spheres,
    super_ball,
    two_blocks,
    wall,
]


@pytest.mark.parametrize("drawn", DRAWN, ids=lambda drawn: drawn.__name__)
def test_wherever_both_ways_agree_within_what_they_state(drawn):
    draw = Random(drawn.__name__)
    for _ in range(8):
        settings, tolerance = drawn(draw), any_of(draw, -11, -6)
        first, second = (run(drawn.__name__, settings, tolerance, second_way=way) for way in (False, True))
        assert second.error_is == "estimate"
        for name, each in second.measured.items():
            known = first.measured[name]
            rows = (known.value, each.value, known.error, each.error)
            for a, b, e, f in zip(*map(components, rows), strict=True):
                assert abs(a - b) <= e + f, (name, settings, tolerance)
                assert f >= 0.0


def test_only_what_is_followed_in_steps_in_any_case_has_no_second_way():
    assert {name for name, scene in SCENES.items() if scene.second_way is None} == {"touching_spheres"}


@pytest.mark.parametrize(
    ("scene", "settings"),
    [
        ("ball_on_floor", {"q": 1.0, "g": 0.0}),
        ("ball_on_floor", {"q": 1.0, "g": 0.0, "eta": 5.0}),
        ("ball_on_floor", {"eta": 1e8}),
        ("bouncing_ball", {}),
        ("cradle", {"N": 2}),
        ("cradle", {"N": 2, "q": 1.5}),
        ("pendulum_block", {}),
        ("spheres", {"eta": 0.0}),
        ("two_blocks", {"r": 1.0}),
        ("wall", {}),
    ],
)
def test_what_has_a_formula_is_not_confirmed_by_it(scene, settings):
    first, second = (run(scene, settings, second_way=way) for way in (False, True))
    assert first.model != "integration"
    assert second.model == "integration"


@pytest.mark.parametrize("tolerance", [1e-6, 1e-8, 1e-10])
@pytest.mark.parametrize("block", [0.5, 1.0, 1.0 + 1e-6, 2.0, 50.0])
def test_a_pendulum_that_hits_a_block_is_as_far_off_as_it_says(block, tolerance):
    """Nothing is neglected in steps: runs differ by their own errors only."""
    fine, rough = (run("pendulum_block", {"M": block}, each, second_way=True) for each in (1e-13, tolerance))
    for name, each in rough.measured.items():
        known = fine.measured[name]
        rows = (known.value, each.value, known.error, each.error)
        assert all(abs(a - b) <= e + f for a, b, e, f in zip(*map(components, rows), strict=True)), name
