"""Ready scenes so far out that doubles do not hold what happens: a value, its absence with a reason, or a refusal; never inf or nan."""

import math
import random

import pytest

from corollary.derive.ready_scenes import ready_scenes, run
from corollary.scenes.run import BadSetting, GuardFailed, components

SCENES = ready_scenes()

# Scenes that are followed in steps take too long for many draws.
IN_STEPS = {"ballistic_pendulum", "cradle", "touching_spheres", "super_ball"}


def drawn(scene, rng):
    """Every number setting at a random power of ten, from the least double to the largest."""
    found = {}
    for setting in SCENES[scene].settings:
        if setting.whole or not isinstance(setting.value, float) or rng.random() < 0.4:
            continue
        value = 10.0 ** rng.uniform(-323.0, 308.0) if rng.random() < 0.5 else 10.0 ** rng.uniform(-12.0, 12.0)
        found[setting.name] = (
            min(max(value, setting.least), setting.most) if math.isfinite(setting.most) else value
        )
    return found


@pytest.mark.parametrize("scene", [name for name in SCENES if name not in IN_STEPS])
def test_no_draw_gives_what_is_no_number(scene):
    rng, answered = random.Random(scene), 0
    for _ in range(30):
        settings = drawn(scene, rng)
        try:
            found = run(scene, settings, 1e-9)
        except (BadSetting, GuardFailed) as refused:
            assert str(refused).endswith("."), settings  # noqa: PT017
            continue
        answered += 1
        for name, each in found.measured.items():
            assert all(map(math.isfinite, (*components(each.value), *components(each.error)))), (
                settings,
                name,
            )
            assert math.isfinite(each.relative_error), (settings, name)
    assert answered


@pytest.mark.parametrize("q", [1.0, 1.5])
def test_what_masses_beyond_all_comparison_leave_open_is_said(q):
    """The first comes back as from a wall; the others move by less than any error of it, and that their touches are not decided is a note."""
    found = run("cradle", {"N": 5.0, "q": q, "masses": (1e-28, 1e28, 1.0, 1e28, 1e-28)})
    off = zip(
        found.observed["velocities"], (-1.0, 2e-56, 4e-56, 0.0, 0.0), found.errors["velocities"], strict=True
    )
    assert all(abs(value - true) <= error < 1e-8 for value, true, error in off)
    assert any("no relative velocity that is known" in warning for warning in found.warnings)


def test_a_contact_as_short_as_the_least_double():
    """The peak force m v pi / dt is beyond the doubles: it is left out, and the rest is there."""
    found = run("wall", {"dt": 5e-324})
    assert {"peak_force", "mean_force"} & found.observed.keys() == set()
    assert found.observed["momentum_change"] == pytest.approx((0.0, 1.6), rel=1e-15)
    assert any(warning.startswith("peak_force is 5.08692e+323") for warning in found.warnings)
