"""Conditions of ready scenes against derivatives known in closed form; grazing hits and edges are announced."""

import math

import pytest

from corollary.scenes.catalogue import run
from corollary.scenes.condition import with_conditions


def conditioned(scene, **settings):
    return with_conditions(run(scene, settings), 1e-12)


def test_the_depth_of_a_contact_goes_with_a_power_of_each_setting():
    """X = ((q + 1) m v^2 / 2 k)^(1/(q + 1)) depends most on the speed (twice 2/5), or on the exponent."""
    found = conditioned("cradle", N=2.0, q=1.0)
    assert found.measured["duration"].condition == pytest.approx(0.5, rel=0.5)
    assert found.measured["velocities"].condition == pytest.approx(1.0, rel=1e-5)


@pytest.mark.parametrize("near", [1e-5, 1e-3])
def test_a_grazing_hit_is_announced_with_the_condition_it_has(near):
    """The speed of approach is v sqrt(1 - (b/D)^2): its share changes by 1/(2 near) times that of b."""
    found = conditioned("spheres", eta=0.0, dy=0.04 * (1.0 - near), q=1.0, k=1e12)
    assert found.measured["largest_overlap"].condition == pytest.approx(0.5 / near, rel=0.1)
    assert conditioned("spheres", eta=0.0, dy=0.0).measured["velocities"].condition < 10.0


def test_an_edge_within_the_rounding_of_the_settings_is_named():
    edge = math.sqrt(50.0 * 0.16 / (1.0 - 1.0 / 1.96))
    found = conditioned("atom", v0=edge * (1.0 + 1e-9))
    assert any("v0 lies at an edge" in each and "'bound'" in each for each in found.warnings)


def test_what_is_lost_is_said_in_digits():
    found = conditioned("spheres", eta=0.0, dy=0.04 * (1.0 - 3e-7), q=1.0, k=1e12)
    assert any(each.startswith("largest_overlap changes") for each in found.warnings)


@pytest.mark.parametrize("settings", [{"m1": 1000.0, "v0": 1e-305}, {"m1": 1000.0, "v0": 1e-310}])
def test_a_condition_beyond_all_numbers_is_said(settings):
    """A rocket that burns nothing and hardly moves: the mass that is left changes its speed by more than any number of times."""
    found = conditioned("rocket", **settings)
    assert max(each.condition for each in found.measured.values()) > 1e250
    assert any("no more than 0" in each for each in found.warnings)
