"""Ways from earlier answers to later ones that the author did not take."""

from __future__ import annotations

import pytest

from corollary.answers.evaluation import as_exact, number
from corollary.derive.cache import solution_of
from corollary.derive.solution import Solution
from corollary.problem.bank import home
from corollary.problem.variant import chapter


def derivation(code: str) -> Solution:
    return solution_of(*home(None, code))


def values(code: str, part: str, **own: float) -> list[float]:
    """What the ways from just these answers, by their letters, give for the chapter's numbers, rounded."""
    solution = derivation(code)
    letters = {find.part: set(find.names) for find in solution.unknowns}
    known = chapter(solution.problem).exact | {name: as_exact(value) for name, value in own.items()}
    return [
        round(number(path.trees[0], known), 6)
        for path in solution.paths.get(part, ())
        if set().union(*(letters[each] for each in path.earlier)) == set(own)
    ]


@pytest.mark.parametrize(
    ("code", "part", "own", "value"),
    [
        ("X12.8", "c2", {"V": -0.5}, 80 * 0.5 / 22),  # momentum that went to the ball has come from you
        ("E12.5.1", "c", {"v_0": 101.0}, 1.0),  # asked later, found before
        ("E12.7.1", "d", {"P": 900.0}, 450.0),  # half of the power, whatever the rate
        ("E12.7.1", "c", {"F": 900.0}, 850.0),  # R u less than for sand at rest
        ("X12.13", "c", {"W": 30.0}, (30 - 2 * 9.8 * 1.5 / 2) / 2),
        ("P12.15", "e", {"V": -3.0}, (3 * 11) ** 0.5),
        ("P12.15", "k3", {"v_e": 4.0}, 4 / (1 - (0.6 / 1.4) ** 2) ** 0.5),
        ("S12.5el", "b", {"v_A1": 1.0}, 5.0),  # by the relative velocity,
        ("S12.5el", "b", {"v_A1": 1.0}, 10**0.5),  # and by the energy
        ("X12.3", "e", {"K_1": 4e5}, -4e5),
        ("X12.1", "c", {"u_b": 60.0}, 0.915 * 60),
        ("X12.6", "b", {"F": -3.6e5}, -1.2e4),  # at the same speed, whichever the student takes it to be
    ],
)
def test_a_way_that_the_laws_allow(code, part, own, value):
    assert values(code, part, **own) == pytest.approx([value], rel=1e-5) or any(
        each == pytest.approx(value, rel=1e-5) for each in values(code, part, **own)
    )


def test_no_way_leads_back():
    """What is asked first cannot have been worked out from what is asked later."""
    for code in ("X12.8", "E12.5.1", "P12.15"):
        solution = derivation(code)
        order = [part.id for part in solution.problem.parts]
        for part, paths in solution.paths.items():
            assert all(order.index(each) < order.index(part) for path in paths for each in path.earlier)


def test_a_copy_is_no_way():
    """The impulse is the change of momentum by another name, and your velocity stays what it was."""
    assert "b" not in derivation("X12.5").paths
    assert "c" not in derivation("X12.8").paths


def test_a_given_is_not_bent_to_fit_an_answer():
    """Nobody finds the mass of the snowball from a wrong velocity to put it in elsewhere."""
    assert values("X12.8", "c2", V=-0.5) == pytest.approx([80 * 0.5 / 22], rel=1e-5)


def test_an_angle_knows_its_quadrant():
    solution = derivation("E12.3.2")
    known = chapter(solution.problem).exact | {"J_l_x": as_exact(-1.0), "J_l_y": as_exact(1.0)}
    found = [number(path.trees[0], known) for path in solution.paths["c3"] if path.earlier == ("c1",)]
    assert any(each == pytest.approx(2.35619449) for each in found)
