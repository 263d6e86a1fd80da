"""What held is not verified again until something has changed; what did not hold always is."""

from __future__ import annotations

import pytest
from tests.verify.conftest import GOOD, OPENING, PROBLEM

from corollary.problem.bank import Bank, find
from corollary.verify import side_by_side
from corollary.verify.checked import Checked


@pytest.fixture
def bank(tmp_path) -> Bank:
    for room in ("problems", "solutions"):
        (tmp_path / room / "carts").mkdir(parents=True)
    (tmp_path / "problems/carts/cart.md").write_text(PROBLEM, encoding="utf-8")
    write(tmp_path, GOOD)
    return Bank(tmp_path)


def write(folder, body: str) -> None:
    indented = "".join(f"    {line}" for line in body.splitlines(keepends=True))
    (folder / "solutions/carts/cart.py").write_text(OPENING + indented, encoding="utf-8")


@pytest.fixture
def times(monkeypatch) -> list[str]:
    """The codes of the problems that were really verified."""
    seen, real = list[str](), side_by_side.verify

    def counted(bank, problem, count, runner):
        seen.append(problem.code)
        return real(bank, problem, count, runner)

    monkeypatch.setattr(side_by_side, "verify", counted)
    return seen


def found(bank: Bank, count: int = 5, *, anew: bool = False) -> Checked:
    with side_by_side.verify_changed([(bank, find(bank, "X1.1"))], count, anew=anew) as checked:
        (only,) = checked
    return only


def test_the_same_is_not_verified_again(bank, times):
    assert found(bank) == found(bank)
    assert len(times) == 1


def test_what_was_verified_anew_is_not_verified_again_after_that(bank, times):
    assert found(bank, anew=True) == found(bank, anew=True)
    assert len(times) == 2
    assert found(bank) == found(bank, anew=True)
    assert len(times) == 3


def test_a_change_is_seen(bank, times, tmp_path):
    assert found(bank).ok
    write(tmp_path, GOOD.replace("1.5 kg m/s", "1.6 kg m/s"))
    assert not found(bank).ok
    (tmp_path / "problems/carts/cart.md").write_text(
        PROBLEM.replace("to: 5, step: 1, unit: m/s", "to: 6, step: 1, unit: m/s")
    )
    write(tmp_path, GOOD)
    assert found(bank).variants == 8 * 6 * 4
    assert found(bank, 6).ok
    assert len(times) == 4


def test_a_change_of_a_file_beside_the_solution_is_seen(bank, times, tmp_path):
    """A judge that is named, and what it imports in turn, from its own folder and from beside the solution."""
    write(tmp_path, 'JUDGE = module("cart/judge_cart.py")\n' + GOOD)
    files = {"cart/judge_cart.py": "import wheels\nimport carts\n", "cart/wheels.py": "", "carts.py": ""}
    for name, text in files.items():
        path = tmp_path / "solutions" / "carts" / name
        path.parent.mkdir(exist_ok=True)
        path.write_text(text, encoding="utf-8")
    assert found(bank).ok
    for count, (name, text) in enumerate(files.items(), start=2):
        assert found(bank).ok
        (tmp_path / "solutions" / "carts" / name).write_text(text + "# changed\n", encoding="utf-8")
        assert found(bank).ok
        assert len(times) == count


def test_what_does_not_hold_is_verified_again(bank, times, tmp_path):
    write(tmp_path, GOOD.replace("1.5 kg m/s", "1.6 kg m/s"))
    assert found(bank).complaints == found(bank).complaints
    assert len(times) == 2
