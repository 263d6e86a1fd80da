"""A share of the draws of benchmarks/calibration.py: bounds hold always, estimates as often as is published, none is far off."""

import random
import sys
from pathlib import Path

import mpmath as mp
import pytest

sys.path.insert(0, str(Path(__file__).parents[2] / "benchmarks"))

pytest.importorskip("numba")  # for what is imported below; the marker has the tests run where it is

from calibration import FAMILIES, calibrated, ratios
from ready.contacts import of_springs
from ready.integrals import of_ball, of_spheres
from ready.motion import followed

from corollary.derive.ready_scenes import ready_scenes, run

SCENES = ready_scenes()

# Draws, where the reference takes seconds.
FEW = {"long rows of springs, unequal": 3, "two spheres, damped": 8}

pytestmark = pytest.mark.fast  # references are followed in compiled steps


def test_every_ready_scene_is_calibrated():
    assert {family.scene for family in FAMILIES} == set(SCENES)


@pytest.mark.whole
@pytest.mark.parametrize("family", FAMILIES, ids=lambda family: family.name)
def test_stated_errors_hold(family):
    found = calibrated(family, FEW.get(family.name, 15))
    assert found.values > found.refused
    assert found.worst <= (1.0 + 1e-9 if found.bounds == found.runs else 3.0), found.settings


@pytest.mark.parametrize("reference", [of_ball, of_spheres])
def test_the_rule_of_the_references_has_converged(reference):
    family = next(family for family in FAMILIES if family.reference is reference)
    for draw in range(6):
        given = family.draw(random.Random(draw))
        found = run(family.scene, given)
        with mp.workdps(family.digits):
            once, finer = reference(given, found), reference(given, found, 256)
            for name, values in once.items():
                for x, y in zip(values, finer[name], strict=True):
                    assert abs(x - y) <= 1e-22 * abs(y), name


def test_the_rule_of_the_references_agrees_with_another():
    # A ball without weight: a beta function.
    given = {"m": 0.3, "k": 2e4, "v0": -1.5, "q": 1.5, "g": 0.0, "R": 1.0, "y0": 1.0}
    with mp.workdps(40):
        (lasts,) = of_ball(given, None)["duration"]
        top = (mp.mpf(given["m"]) * mp.mpf("2.25") * mp.mpf("2.5") / (2 * mp.mpf(2e4))) ** (1 / mp.mpf("2.5"))
        exact = 2 * top / mp.mpf("1.5") * mp.beta(mp.mpf("0.4"), mp.mpf("0.5")) / mp.mpf("2.5")
        assert abs(lasts - exact) < 1e-30 * exact


@pytest.mark.whole
def test_steps_of_31_digits_find_a_contact_whose_end_is_known():
    """Two balls and a spring: half a swing; a Hertz contact: a beta function."""
    m, k, v = 0.1, 1e4, 1.0
    half = followed((m, m), (0, 0, 1, 0), (v, 0, 0, 0), [(0, 1, 1.0, k, 1.0, 0.0)], (1e-3, v), accuracy=1e-22)
    with mp.workdps(40):
        lasts = half.last - half.first
        true = mp.pi * mp.sqrt(mp.mpf(m) / 2 / mp.mpf(k))
        assert abs(mp.mpf(lasts.numerator) / lasts.denominator - true) < 1e-21 * true
        hertz = followed((m, m), (0, 0, 1, 0), (v, 0, 0, 0), [(0, 1, 1.0, k, 1.5, 0.0)], (1e-3, v))
        lasts = hertz.last - hertz.first
        deep = (mp.mpf("1.25") * mp.mpf(m) / 2 / mp.mpf(k)) ** mp.mpf("0.4")
        true = 2 * deep * mp.mpf("0.4") * mp.beta(mp.mpf("0.4"), mp.mpf("0.5"))
        assert abs(mp.mpf(lasts.numerator) / lasts.denominator - true) < 1e-17 * true


@pytest.mark.whole
@pytest.mark.parametrize(
    "given",
    [
        # A late touch after a long flight: five balls had been off by twenty times what was stated.
        {
            "masses": (
                0.364991155132011,
                0.12104925612744531,
                0.019890326305564185,
                0.024082745547419515,
                0.012596282267283897,
            ),
            "k": 1e4,
            "v0": 1.0,
            "gaps": (
                0.00010102415600671933,
                0.02943571378151416,
                0.25432843142878553,
                2.3554373557547053e-05,
            ),
            "balls_in": 2.0,
        },
        # Struck some seven hundred times: a velocity had come out with the other sign, at 54 000 times what was stated.
        {
            "masses": (
                0.04305778813399612,
                0.0005432172600007333,
                0.1674513161680895,
                2.0366482784635904,
                0.0021733552712057047,
                0.0015864131899527303,
                0.01759486434291575,
                0.1985477481877877,
                0.43936240723851705,
                2.5644759468053904,
            ),
            "k": 4773.677101742475,
            "v0": 1.2384281618080717,
            "gaps": 0.027570220802578316,
            "balls_in": 1.0,
        },
    ],
    ids=["five", "ten"],
)
def test_rounding_that_a_row_of_springs_amplifies_is_in_the_errors(given):
    family = next(each for each in FAMILIES if each.reference is of_springs)
    given = given | {"N": float(len(given["masses"])), "q": 1.0}
    assert max(ratio for _, ratio in ratios(family, given, run("cradle", given))) <= 1.0
