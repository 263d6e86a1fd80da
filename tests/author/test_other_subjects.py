"""A problem about heat, turning and angles: units beside the SI in givens, parts and answers, verified and marked."""

from __future__ import annotations

import math

import pytest

from corollary.api import judge, key, solve
from corollary.problem.bank import Bank, find
from corollary.verify.verify import verify

PROBLEM = """\
---
code: H1.1
title: Tea with milk
given:
  m1: {is: mass of the tea, value: 200, from: 150, to: 300, step: 10, unit: g}
  m2: {is: mass of the milk, value: 40, from: 20, to: 60, step: 5, unit: g}
  T1: {is: temperature of the tea, value: 80, from: 60, to: 90, step: 1, unit: °C}
  T2: {is: temperature of the milk, value: 6, from: 4, to: 12, step: 1, unit: °C}
  alpha: {is: tilt of the cup, value: 30, from: 10, to: 60, step: 1, unit: deg}
  L: {is: radius of the stirrer, value: 30, from: 10, to: 60, step: 1, unit: cm}
  w: {is: speed of the stirrer, value: 300, from: 100, to: 600, step: 100, unit: rpm}
require:
  - m1 > 0
  - m2 > 0
---
Tea of {{m1}} at {{T1}} and milk of {{m2}} at {{T2}}, a tilt of {{alpha}}, a stirrer of {{L}} at {{w}}.

## Temperature {#a .value unit="°C" points=1}
Which one?

## Cooled by {#b .value unit="Δ°C" points=1}
By how much?

## Angle {#c .value unit="deg" points=1}
Twice the tilt.

## Rim {#d .value unit="km/s" points=1}
Its speed.
"""
SOLUTION = '''\
"""Tea with milk."""

from corollary.author import derivation, mistake, step, unknowns
from corollary.laws import law


def derive(m1, m2, T1, T2, alpha, L, w):
    T, d, b, v = unknowns("T d b v")
    heat = {"m1": m1, "m2": m2, "T1": T1, "T2": T2, "T": T}
    return derivation(
        step(T, "Heat is kept.", law("Heat", "m1*(T1 - T) = m2*(T - T2)", **heat), answers="a", mistakes=[
            mistake("The mean.", law("Heat", "2*T = T1 + T2", T=T, T1=T1, T2=T2)),
            mistake("Changed places.", law("Heat", "m2*(T1 - T) = m1*(T - T2)", **heat)),
        ]),
        step(d, "A difference.", law("Difference", "d = T1 - T", d=d, T1=T1, T=T), answers="b"),
        step(b, "Twice.", law("Twice", "b = 2*a", b=b, a=alpha), answers="c"),
        step(v, "The rim.", law("Rim", "v = w*L", v=v, w=w, L=L), answers="d"),
    )
'''
TEA = (200 * 80 + 40 * 6) / 240  # °C, by the mean that the masses weigh


@pytest.fixture(scope="module")
def solution(tmp_path_factory):
    place = tmp_path_factory.mktemp("heat")
    for name, text in (("problems/heat/tea.md", PROBLEM), ("solutions/heat/tea.py", SOLUTION)):
        (place / name).parent.mkdir(parents=True)
        (place / name).write_text(text, encoding="utf-8")
    return solve(find(Bank(place), "H1.1"))


def test_the_key_is_in_si(solution):
    truths = key(solution).truths
    assert truths["a"].value == pytest.approx(TEA + 273.15)
    assert truths["b"].value == pytest.approx(80 - TEA)
    assert truths["c"].value == pytest.approx(math.radians(60))
    assert truths["d"].value == pytest.approx(300 * 2 * math.pi / 60 * 0.3)


@pytest.mark.parametrize(
    ("part", "right"),
    [
        ("a", (67.7, "67.7", "67.7 °C", "340.8 K", "153.8 °F")),
        ("b", (12.3, "12.3 °C", "12.3 K", "22.2 °F")),
        ("c", (60, "60", "60°", "1.047 rad")),
        ("d", (0.009425, "0.009425", "9.425 m/s", "33.93 km/h")),
    ],
)
def test_a_bare_number_is_in_the_unit_of_the_part_and_each_unit_is_converted(solution, part, right):
    for answer in right:
        assert judge(solution, {part: answer})[part].points == 1, answer


@pytest.mark.parametrize(
    ("part", "wrong"),
    [
        ("a", (68.4, 340.8, "67.7 K")),
        ("b", (285.5, "12.3 m")),
        ("c", (30, "60 rad")),
        ("d", (9.425, "9.425 km/s")),
    ],
)
def test_how_near_is_told_in_the_unit_of_the_part(solution, part, wrong):
    """68.4 °C is one per cent from 67.7 °C, though two in a thousand of 341 K."""
    for answer in wrong:
        assert judge(solution, {part: answer})[part].points < 1, answer


def test_kelvin_of_a_bare_celsius_is_a_known_slip(solution):
    heat = (200 * 80 + 40 * (6 - 273.15)) / 240
    assert "T2 was put in without converting its unit to SI" in judge(solution, {"a": heat})["a"].feedback


def test_all_of_it_verifies(solution):
    tally = verify(Bank(solution.problem.path.parents[2]), solution.problem, count=12)
    assert tally.complaints == ()
