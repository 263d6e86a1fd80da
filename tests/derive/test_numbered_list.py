"""Lists with an entry for each whole number in a range: as long as the numbers make them, judged, carried forward, and proven."""

from __future__ import annotations

import math
from fractions import Fraction
from pathlib import Path

import pytest

from corollary.answers.verdict import Follows, Mistaken, Right, Unread, Wrong
from corollary.derive.cache import solution_of
from corollary.derive.load import NotDerivable
from corollary.derive.solve import solve
from corollary.formula.ball import Undefined
from corollary.grading.assign import admitted
from corollary.grading.from_json import from_json
from corollary.grading.judge import judge
from corollary.grading.key import make_key
from corollary.grading.plain_key import key_of, serialized
from corollary.problem.bank import home
from corollary.problem.variant import chosen
from corollary.verify.verify import verify

PROBLEM = """\
---
code: T9
title: Orders
given:
  d: {is: distance of the slits, value: 2.00, from: 1.60, to: 3.00, step: 0.05, unit: um}
  lam: {is: wavelength, value: 600, from: 450, to: 690, step: 5, unit: nm}
  h: {is: shift, value: 0.10, unit: um}
require:
  - d > 0
  - lam > 0
  - h > 0
---
A grating, with {{d}} from slit to slit, hangs in straight light of {{lam}}. Another has {{h}} more from slit to slit.

## The other grating {#a .value unit="um" points=1}
How far apart are the slits of the other grating?

## Directions {#b .list unit="deg" points=2}
At which angles from the straight beam do its orders appear on one side?

## Both sides {#c .list points=1}
Which orders does the first grating have, those of the other side with a minus?
"""
SOLUTION = """\
Gratings.

## (a) D

It is wider.

- law: Wider, `D = d + h`
- mistake: It is wider, not narrower. `D = d - h`

## (b) theta

Paths from slit to slit differ by whole wavelengths.

- each: `m` from `1` to `floor(D/lam)`
- law: Grating, `D*sin(theta) = m*lam`
- where: `theta > 0 and theta <= pi/2`
- mistake: The straight beam goes to neither side. `m` from `0` to `floor(D/lam)`
- mistake: Only for small angles is the sine the angle. `D*theta = m*lam`
- mistake: Half a wavelength makes it dark, and there is one order more.
  - each: `m` from `1` to `floor(D/lam) - 1`
  - law: Grating, `D*sin(theta) = (m - 1/2)*lam`

## (c) n

All whole numbers whose sine is 1 at most.

- each: `k` from `-floor(d/lam)` to `floor(d/lam)`
- law: Whole numbers, `n = k`
- mistake: There are two sides. `k` from `0` to `floor(d/lam)`
"""


def bank(folder: Path, problem: str = PROBLEM, solution: str = SOLUTION):
    for place, text in (("problems/all/orders.md", problem), ("solutions/all/orders.md", solution)):
        (folder / place).parent.mkdir(parents=True, exist_ok=True)
        (folder / place).write_text(text, encoding="utf-8")
    return home(folder, "T9")


@pytest.fixture(scope="module")
def orders(tmp_path_factory: pytest.TempPathFactory):
    return solve(*bank(tmp_path_factory.mktemp("lists")))


def key_for(solution, **values):
    return make_key(
        solution, chosen(solution.problem, {name: Fraction(value) for name, value in values.items()})
    )


def degrees(key, part):
    return [math.degrees(value) for value in key.truths[part].values]


@pytest.mark.parametrize(
    ("d", "lam", "angles", "largest"),
    [
        # asin(2/7) = 16.60, asin(4/7) = 34.85, asin(6/7) = 59.00; 2.0/0.6 = 3.3
        ("2.00", "600", [16.60, 34.85, 59.00], 3),
        # 1.7/0.69 = 2.46: asin(0.40588) = 23.95, asin(0.81176) = 54.27; 1.6/0.69 = 2.3
        ("1.60", "690", [23.95, 54.27], 2),
        # 2.75/0.49 = 5.6: multiples of 0.178182; 2.65/0.49 = 5.4
        ("2.65", "490", [10.26, 20.88, 32.31, 45.46, 62.99], 5),
        # beyond the grid: 5.1/0.6 = 8.5
        ("5.00", "600", [6.76, 13.61, 20.67, 28.07, 36.03, 44.90, 55.44, 70.25], None),
    ],
)
def test_the_list_has_the_entries_that_exist(orders, d, lam, angles, largest):
    if largest is None:
        with pytest.raises(Undefined, match="17 entries, and 12 are the most"):
            key_for(orders, d=d, lam=lam)
        return
    key = key_for(orders, d=d, lam=lam)
    assert degrees(key, "b") == pytest.approx(angles, abs=0.006)
    assert key.truths["b"].proven
    assert key.truths["c"].values == tuple(map(float, range(-largest, largest + 1)))


def test_a_list_that_is_empty_is_refused(orders):
    with pytest.raises(Undefined, match="the list is empty"):
        key_for(orders, d="0.30", lam="600")


def test_numbers_near_a_step_are_not_dealt(orders):
    """D/lam = 1.8/0.6 = 3: whether there is a third order is for rounding to say."""
    problem = orders.problem
    assert "too near a step" in admitted(orders, chosen(problem, {"d": Fraction("1.70")}))[1]


@pytest.mark.parametrize(
    ("typed", "verdict", "words"),
    [
        (["16.6 deg", "34.85 deg", "59.0 deg"], Right, ""),
        (["59.0 deg", "16.6 deg", "34.8 deg"], Right, ""),
        ("16.6°; 34.8° and 59.0°", Right, ""),
        ([16.6, 34.85, 59.0], Right, ""),
        (["0 deg", "16.6 deg", "34.85 deg", "59.0 deg"], Mistaken, "neither side"),
        (["16.37 deg", "32.74 deg", "49.11 deg"], Mistaken, "small angles"),
        (["8.21 deg", "25.38 deg"], Mistaken, "makes it dark"),
        (["16.6 deg", "34.85 deg"], Wrong, "not all"),
        (["16.6 deg", "34.85 deg", "59.0 deg", "70 deg"], Wrong, "others that are not right"),
        (["11 deg", "12 deg", "13 deg"], Wrong, ""),
        ([], Unread, ""),
        ("some", Unread, ""),
    ],
)
def test_how_a_list_is_judged(orders, typed, verdict, words):
    key = key_for(orders)
    found = judge(key, {"a": from_json("2.1 um"), "b": from_json(typed)})["b"][0][0]
    assert isinstance(found, verdict), found
    assert words in str(found)


@pytest.mark.parametrize(
    ("typed", "verdict"),
    [
        ([-3, -2, -1, 0, 1, 2, 3], Right),
        ("0, 1, -1, 2, -2, 3, -3", Right),
        ([0, 1, 2, 3], Mistaken),
        ([-3, -2, -1, 1, 2, 3], Wrong),
        ([-3, -2, -1, 0, 1, 2, 3.2], Wrong),
    ],
)
def test_a_list_of_whole_numbers(orders, typed, verdict):
    found = judge(key_for(orders), {"c": from_json(typed)})["c"][0][0]
    assert isinstance(found, verdict), found


def test_a_wrong_earlier_answer_is_followed_to_a_list_of_another_length(orders):
    """With 2.6 µm there are four orders: asin(3/13) = 13.34, asin(6/13) = 27.49, asin(9/13) = 43.81, asin(12/13) = 67.38."""
    typed = ["13.34 deg", "27.49 deg", "43.81 deg", "67.38 deg"]
    found = judge(key_for(orders), {"a": from_json("2.6 um"), "b": from_json(typed)})["b"][0][0]
    assert found == Follows(("a",))


def test_a_key_for_a_browser_judges_alike(orders):
    key = key_for(orders)
    plain = key_of(serialized(key))
    answers = {"a": from_json("2.1 um"), "b": from_json(["0 deg", "16.6 deg", "34.85 deg", "59.0 deg"])}
    assert judge(plain, answers)["b"][0] == judge(key, answers)["b"][0]


def test_what_the_cache_holds_is_the_same(tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    found = bank(tmp_path)
    first, again = solution_of(*found), solution_of(*found)
    assert again is not first
    for d in ("2.00", "2.50"):
        assert key_for(again, d=d).truths == key_for(first, d=d).truths
    assert [each.conditions for each in again.regimes] == [each.conditions for each in first.regimes]


def test_it_verifies_and_says_proven_only_of_what_is(tmp_path):
    checked = verify(*bank(tmp_path), 20)
    assert checked.complaints == ()
    outcomes = {(each.kind, each.outcome) for each in checked.obligations}
    assert ("laws hold", "proven") in outcomes
    assert ("value exists", "proven") in outcomes
    assert ("one case", "proven") in outcomes
    assert ("no step", "sampled") in outcomes
    assert "counter-example" not in {outcome for _kind, outcome in outcomes}
    own_range = [each for each in checked.obligations if "neither side" in each.claim]
    assert {each.outcome for each in own_range} == {"sampled"}
    assert checked.mutation is not None
    assert checked.mutation.bends > 10


def test_in_python_it_is_the_same(tmp_path, orders):
    problem = PROBLEM[: PROBLEM.index("## Both sides")]
    found = bank(tmp_path, problem)
    (tmp_path / "solutions/all/orders.md").unlink()
    (tmp_path / "solutions/all/orders.py").write_text(
        '''"""Gratings."""

from sympy import And, floor, pi

from corollary.author import derivation, each, mistake, step, unknowns, variable
from corollary.laws import law, wrong


def derive(d, lam, h):
    D, theta = unknowns("D theta")
    m = variable("m")
    return derivation(
        step(D, "It is wider.", law("Wider", "D = d + h"), answers="a"),
        step(
            theta, "Whole wavelengths.", law("Grating", "D*sin(theta) = m*lam"), answers="b", each=each(m, 1, floor(D/lam)),
            where=And(theta > 0, theta <= pi/2),
            mistakes=[mistake("No.", each=each(m, 0, floor(D/lam))), mistake("Small.", wrong("D*theta = m*lam"))],
        ),
    )
''',
        encoding="utf-8",
    )
    key = make_key(solve(*found), chosen(found[1], dict[str, Fraction]()))
    assert key.truths["b"].values == key_for(orders).truths["b"].values
    zeroth = ["0 deg", "16.6 deg", "34.85 deg", "59.0 deg"]
    assert judge(key, {"a": from_json("2.1 um"), "b": from_json(zeroth)})["b"][0][0].mistake == "No."


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        (
            "`m` from `1` to `floor(D/lam)`\n- law",
            "`m` from `1` to `D/lam`\n- law",
            "both ends are whole numbers",
        ),
        ("each: `m` from `1` to `floor(D/lam)`\n- law", "each: m = 1\n- law", "write the whole numbers"),
        ("- each: `m` from `1` to `floor(D/lam)`\n- law", "- law", "what does m mean"),
        ("each: `m` from", "each: `lam` from", "means something already"),
        ("`k` from `0`", "`m` from `0`", "are called k"),
    ],
)
def test_what_is_wrong_is_said(tmp_path, old, new, words):
    assert old in SOLUTION
    with pytest.raises(NotDerivable, match=words):
        solve(*bank(tmp_path, solution=SOLUTION.replace(old, new, 1)))
