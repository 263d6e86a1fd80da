"""Verifying on a Dask cluster: the same findings in the same order, and a sentence where it cannot be."""

from __future__ import annotations

import json
from dataclasses import replace

import pytest
from click.testing import CliRunner
from tests.verify.conftest import GOOD, OPENING, PROBLEM

from corollary import parallel
from corollary.cli.commands import app
from corollary.parallel import NoCluster
from corollary.problem.bank import Bank, chapter_bank, find
from corollary.verify.checked import Checked
from corollary.verify.side_by_side import on_cluster, verify_each, verify_there

distributed = pytest.importorskip("distributed", reason="needs Dask: pip install '.[dask]'")
BANK = chapter_bank()
CODES = ("X12.2", "E12.3.1")
DIES = "import os, signal\nos.kill(os.getpid(), signal.SIGKILL)\n"


@pytest.fixture(scope="module")
def address():
    import dask

    with (
        dask.config.set({"distributed.scheduler.allowed-failures": 0}),
        distributed.LocalCluster(n_workers=1, threads_per_worker=1, dashboard_address=None) as machines,
    ):
        yield machines.scheduler_address


def cart(folder, solution: str = GOOD) -> Bank:
    for room in ("problems", "solutions"):
        (folder / room / "carts").mkdir(parents=True)
    (folder / "problems/carts/cart.md").write_text(PROBLEM, encoding="utf-8")
    indented = "".join(f"    {line}" for line in solution.splitlines(keepends=True))
    (folder / "solutions/carts/cart.py").write_text(OPENING + indented, encoding="utf-8")
    return Bank(folder)


@pytest.mark.whole
def test_a_cluster_finds_what_this_machine_does(address: str) -> None:
    todo = [(BANK, find(BANK, code)) for code in CODES]
    with verify_each(todo, 4, 1) as here, on_cluster(address)(todo, 4) as there:
        assert list(map(found, there)) == list(map(found, here))


def found(checked: Checked) -> tuple[Checked, set[tuple[str, str]]]:
    """Everything but which prover was in time."""
    return replace(checked, obligations=()), {(each.claim, each.outcome) for each in checked.obligations}


@pytest.mark.whole
def test_the_command_verifies_there_what_changed(address: str, tmp_path) -> None:
    cart(tmp_path, GOOD.replace("1.5 kg m/s", "1.6 kg m/s"))
    words = ["verify", "X1.1", "--bank", str(tmp_path), "--json", "--variants", "4"]
    there, here = (CliRunner().invoke(app, [*words, *more]) for more in (["--executor", address], []))
    assert there.exit_code == here.exit_code == 1
    assert json.loads(there.stdout)["problems"] == json.loads(here.stdout)["problems"]


@pytest.mark.whole
def test_a_solution_that_ends_its_worker_is_named(address: str, tmp_path) -> None:
    bank = cart(tmp_path, DIES + GOOD)
    with (
        pytest.raises(NoCluster, match=r"the workers that verified X1\.1 died"),
        on_cluster(address)([(bank, find(bank, "X1.1"))], 4) as found,
    ):
        list(found)


def test_a_worker_with_another_program_verifies_nothing() -> None:
    with pytest.raises(NoCluster, match=r"another version of X12\.2 or of corollary"):
        verify_there(BANK, find(BANK, "X12.2"), 4, "another state", "en")


def test_nobody_answers(monkeypatch, tmp_path) -> None:
    monkeypatch.setattr(parallel, "SECONDS_TO_CONNECT", 1)
    cart(tmp_path)
    done = CliRunner().invoke(
        app, ["verify", "X1.1", "--bank", str(tmp_path), "--anew", "--executor", "tcp://127.0.0.1:9"]
    )
    assert done.exit_code == 2
    assert "no Dask scheduler answers at tcp://127.0.0.1:9" in done.stderr


def test_nothing_to_do_needs_no_cluster() -> None:
    with on_cluster("tcp://127.0.0.1:9")([], 4) as found:
        assert not list(found)
