"""How much is compared for the figures of one part, counted in places of curves: hostile notebooks end soon, at a person."""

from __future__ import annotations

import numpy as np
import pytest

from corollary.answers.verdict import Right, Unmarked, Verdict
from corollary.grading.key import Key
from corollary.grading.program_run import ProgramRun
from corollary.grading.programs import work
from corollary.grading.programs.curves import DrawnCurve, Graph
from corollary.grading.programs.judge_programs import judge_plot
from corollary.grading.solutions import Solutions
from corollary.problem.bank import chapter_bank, find
from corollary.problem.variant import chapter
from corollary.sandbox.job import Axes, DrawnLine, Figure

POINTS = 5_000  # the most that a frame may bring


@pytest.fixture(scope="module")
def key() -> Key:
    solutions = Solutions(chapter_bank())
    return solutions.key(chapter(find(chapter_bank(), "P12.14")))


@pytest.fixture
def spent(monkeypatch: pytest.MonkeyPatch) -> list[int]:
    """Every count made, in the limit that judging sets."""
    counted: list[int] = []
    add = work.Work.add

    def noted(self: work.Work, places: int) -> None:
        counted.append(self.compared + places)
        add(self, places)

    monkeypatch.setattr(work.Work, "add", noted)
    return counted


def velocities(key: Key, rough: float = 0.0) -> list[DrawnLine]:
    """The two velocities of the contact, with as many points as there may be."""
    given = key.variant.si
    lasts = np.pi * np.sqrt(given["m"] / 2 / given["k"])
    t = np.linspace(0, 1.3 * lasts, POINTS)
    a = np.where(t < lasts, given["v0"] / 2 * (1 + np.cos(np.pi * t / lasts)), 0.0)
    a = a + rough * given["v0"] * (-1.0) ** np.arange(POINTS)
    b = given["v0"] - a
    return [DrawnLine(tuple(t.tolist()), tuple(y.tolist()), "", "line") for y in (a, b)]


def figure(cell: str, *of_axes: list[DrawnLine]) -> Figure:
    ends = (0.0, 1.0)
    axes = (Axes("", "t [s]", "v [m/s]", ends, ends, "linear", "linear", (), tuple(each)) for each in of_axes)
    return Figure(cell, tuple(axes), None)


def judged(key: Key, *figures: Figure) -> Verdict:
    run = ProgramRun({}, figures[:1], True, figures[1:21], figures[21:])
    return judge_plot(key.solution, key.variant, key.variant.problem.part("h"), run, b"", "")


def test_a_usual_figure_is_a_hundredth_of_the_limit(key: Key, spent: list[int]):
    assert isinstance(judged(key, figure("own", velocities(key))), Right)
    assert 0 < spent[-1] < work.MOST_COMPARED / 100


def test_forty_cells_full_of_half_of_it_go_to_a_person(key: Key, spent: list[int]):
    one = velocities(key, rough=0.02)[:1] * 10
    found = judged(key, *(figure(f"cell{number}", one, one, one) for number in range(41)))
    assert isinstance(found, Unmarked)
    assert "your teacher" in str(found)
    assert work.MOST_COMPARED < spent[-1] < work.MOST_COMPARED + 3 * POINTS


def test_the_right_figure_in_another_cell_ends_the_search(key: Key, spent: list[int]):
    right = figure("right", velocities(key))
    wrong = [figure(f"cell{number}", velocities(key)[:1]) for number in range(19)]
    first = judged(key, *wrong[:1], right, *wrong[1:])
    fewest = spent[-1]
    last = judged(key, *wrong, right)
    assert isinstance(first, Unmarked)
    assert isinstance(last, Unmarked)
    assert fewest < spent[-1] / 3


def test_curves_of_many_points_are_compared_at_some_places_but_along_their_whole_length():
    graph = Graph("a line", lambda x: x, (0.0, 1.0), (1.0, 1.0))
    x = np.linspace(0, 1, POINTS)
    for joined in (True, False):
        assert graph.fits(DrawnCurve(x, x, joined))
        assert len(DrawnCurve(x, x, joined).points((1.0, 1.0))[0]) < POINTS / 8
        for place in (0, 1, 2_345, POINTS - 1):
            y = x.copy()
            y[place] += 0.3  # one point aside
            assert not graph.fits(DrawnCurve(x, y, joined)), place


@pytest.mark.parametrize("every", [2, 3, 100])
def test_a_line_with_many_holes_is_all_its_pieces(every: int):
    x = np.linspace(0, 1, POINTS)
    drawn = DrawnCurve(x, np.where(np.arange(POINTS) % every, x, np.nan), joined=True)
    found, _y = drawn.points((1.0, 1.0))
    assert len(found) < POINTS / 4
    assert np.diff(found).max() < 0.02
    half = DrawnCurve(x, np.where((x > 0.3) & (x < 0.7), np.nan, x), joined=True)
    found, _y = half.points((1.0, 1.0))
    assert not ((found > 0.3) & (found < 0.7)).any()  # no line is drawn over a gap
