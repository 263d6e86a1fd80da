"""The front door: light until it is used, exact about numbers, and plain about what it refuses."""

from __future__ import annotations

import math
import shutil
import subprocess
import sys
from fractions import Fraction
from pathlib import Path

import pytest

import corollary

LOADED = "import sys; import corollary; print(*(name for name in sys.modules if name.startswith('corollary.') or name in {'numpy', 'sympy'}))"


@pytest.fixture(scope="module")
def problem() -> corollary.Problem:
    return corollary.load_bank()["X12.5"]


def test_the_import_alone_loads_the_version_alone() -> None:
    done = subprocess.run([sys.executable, "-c", LOADED], capture_output=True, text=True, check=True)
    assert done.stdout.split() == ["corollary.version"]


def test_every_name_is_there_and_no_other() -> None:
    for name in corollary.__all__:
        assert getattr(corollary, name) is not None
    assert set(corollary.__all__) <= set(dir(corollary))
    with pytest.raises(AttributeError, match="no attribute 'solved'"):
        corollary.solved  # noqa: B018


def test_types_are_shipped() -> None:
    assert (Path(corollary.__file__).parent / "py.typed").is_file()


@pytest.mark.parametrize("mass", [0.1, "0.1", Fraction(1, 10), "100 g", "1/10"])
def test_a_number_is_what_is_written(problem: corollary.Problem, mass: float | str | Fraction) -> None:
    """A tenth is a tenth, not the double beside it: three tenths of the speed of 3 m/s."""
    assert corollary.key(problem, m=mass, v=3).variant.values["m"] == Fraction(1, 10)
    assert corollary.key(problem, m=mass, v=3)["a"].value == 0.3


@pytest.mark.parametrize(
    ("given", "why"),
    [
        ({"M": 1.0}, "M is not among the givens of X12.5"),
        ({"m": True}, "m: true is not a number"),
        ({"m": "heavy"}, "m=heavy: "),
        ({"m": "3 s"}, "m=3 s: "),
        ({"m": float("nan")}, "m=nan: "),
        ({"m": -1}, "X12.5 needs m > 0"),
    ],
)
def test_what_is_no_value_of_a_given_is_refused(problem: corollary.Problem, given: dict, why: str) -> None:
    with pytest.raises(corollary.OutOfRange) as refused:
        corollary.key(problem, **given)
    assert str(refused.value).startswith(why)


def test_an_answer_to_no_part_is_refused(problem: corollary.Problem) -> None:
    with pytest.raises(corollary.UnknownPart, match=r"X12\.5 has no part z; its parts are a, b, c, d"):
        corollary.judge(problem, {"z": 1})


def test_a_part_that_students_see_with_another_letter_is_named_with_both() -> None:
    with pytest.raises(
        corollary.UnknownPart, match=r"no part d; its parts are a, b, c, e \[d on the sheet\]"
    ):
        corollary.judge(corollary.load_bank()["S12.5two"], {"d": ["v_B1 - v_A1 = r*(vA - vB)"]})


def test_a_bank_of_ones_own_is_solved_from_its_own_solutions(tmp_path: Path) -> None:
    """Also where a topic is called `problems`."""
    chapter = corollary.load_bank()
    for kind in ("problems", "solutions"):
        folder = tmp_path / kind / "problems"
        folder.mkdir(parents=True)
        shutil.copy(chapter.folder / kind / "impulse" / "kicking_a_ball.md", folder)
    solution = tmp_path / "solutions" / "problems" / "kicking_a_ball.md"
    bank = corollary.load_bank(tmp_path)
    assert [problem.code for problem in bank] == ["X12.5"]
    assert len(bank) == 1
    assert corollary.key(bank["kicking_a_ball"])["c"].value == 86.0
    solution.unlink()
    with pytest.raises(corollary.NotDerivable, match=r"kicking_a_ball\.md needs a solution there"):
        corollary.solve(bank["X12.5"])


def test_a_folder_that_is_no_bank(tmp_path: Path) -> None:
    with pytest.raises(corollary.UnknownCode, match="is not a bank"):
        corollary.load_bank(tmp_path)


def test_a_scene_of_unknown_name_or_setting() -> None:
    with pytest.raises(corollary.BadSetting, match="no scene 'ferris_wheel'"):
        corollary.play("ferris_wheel")
    with pytest.raises(corollary.BadSetting):
        corollary.play("cradle", colour=3.0)


def test_a_scene_says_how_strongly_its_values_hang_on_the_settings() -> None:
    # The overlap of a head-on hit is A^(1/(q + 1)) with A = (q + 1) (m/2) v^2/(2 k): most it hangs on q. That of one that grazes by a
    # part p of the reach hangs on the offset as 1/(2 p).
    log_of_a = math.log(2.5 * 0.05 / 2e4)
    head_on = corollary.play("cradle", N=2, q=1.5)
    assert head_on.measured["largest_overlap"].condition == pytest.approx(
        1.5 * (1.0 - log_of_a) / 2.5**2, rel=1e-5
    )
    grazing = corollary.play("spheres", eta=0.0, dy=0.04 * (1.0 - 3e-7), q=1.0, k=1e12)
    assert grazing.measured["largest_overlap"].condition == pytest.approx(0.5 / 3e-7, rel=0.3)
    assert any("a grazing hit" in warning for warning in grazing.warnings)
    assert corollary.play("cradle", conditions=False, N=2).measured["duration"].condition is None
