"""Conditions of ready scenes against derivatives known in closed form; grazing hits and edges are announced."""

import math
from dataclasses import replace

import pytest

from corollary.derive.ready_scenes import run, with_conditions


def conditioned(scene, **settings):
    return with_conditions(run(scene, settings), 1e-12)


def test_a_contact_lasts_by_a_power_of_each_setting_and_hangs_most_on_the_exponent():
    """T = 2 X sqrt(pi) G(1 + p) / (v G(1/2 + p)) with X = (m v^2 / 2 p k)^p, p = 1/(q + 1) and the reduced mass m."""

    def lasts(q):
        p = 1.0 / (q + 1.0)
        deep = (0.05 / (2.0 * p * 1e4)) ** p
        return 2.0 * deep * math.sqrt(math.pi) * math.gamma(1.0 + p) / math.gamma(0.5 + p)

    found = conditioned("cradle", N=2.0, q=1.0)
    assert found.observed["duration"] == pytest.approx(lasts(1.0), rel=1e-12)
    by_exponent = (lasts(1.0 + 1e-6) - lasts(1.0 - 1e-6)) / 2e-6 / lasts(1.0)
    assert found.measured["duration"].condition == pytest.approx(by_exponent, rel=1e-5)
    assert found.measured["velocities"].condition == pytest.approx(1.0, rel=1e-5)


@pytest.mark.parametrize("near", [1e-5, 1e-3])
def test_a_grazing_hit_is_announced_with_the_condition_it_has(near):
    """The speed of approach is v sqrt(1 - (b/D)^2): its share changes by 1/(2 near) times that of b."""
    found = conditioned("spheres", eta=0.0, dy=0.04 * (1.0 - near), q=1.0, k=1e12)
    assert found.measured["largest_overlap"].condition == pytest.approx(0.5 / near, rel=0.1)
    assert conditioned("spheres", eta=0.0, dy=0.0).measured["velocities"].condition < 10.0


@pytest.mark.parametrize("q", [1.0, 1.5])
def test_the_numbers_of_a_row_are_moved_each_by_its_own_part(q):
    """All masses times one factor leave the velocities as they are; that of a light ball between two heavy ones alone does not."""
    masses = (0.3, 1e-4, 0.2)
    found = conditioned("cradle", q=q, masses=masses)
    other = run("cradle", {"q": q, "masses": (masses[0], masses[1] * (1.0 - 1e-6), masses[2])})
    pairs = zip(found.observed["velocities"], other.observed["velocities"], strict=True)
    alone = max(abs(a - b) for a, b in pairs) / 1e-6 / found.measured["velocities"].size
    assert alone > 20.0
    assert alone < found.measured["velocities"].condition < 3.0 * alone


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


def test_settings_at_the_end_of_what_they_may_be_hide_no_condition():
    """By default the spheres touch as they begin, and the exponent is the least: moved all at once, that is refused."""
    found = conditioned("touching_spheres")
    assert (
        1.0 < found.measured["momentum_change"].condition < 2.0
    )  # m g t, of which several are moved at once
    assert found.measured["velocities"].condition > 0.1


def test_each_edge_is_told_by_the_name_of_its_setting():
    edge = math.sqrt(50.0 * 0.16 / (1.0 - 1.0 / 1.96))
    run_there = run("atom", {"v0": edge * (1.0 + 1e-9)})
    dear = with_conditions(replace(run_there, evaluations=10**6), 1e-12)
    assert any("v0 lies at an edge" in each for each in dear.warnings)
    assert not any("One of" in each for each in dear.warnings)
