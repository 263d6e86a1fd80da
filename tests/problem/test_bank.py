"""A bank: problems found by code, by name, by path, and what is said when there is none, or two."""

from __future__ import annotations

import os
import sys
from pathlib import Path

import pytest

from corollary.plug_ins import PlugInFault
from corollary.problem.bank import (
    Bank,
    UnknownCode,
    chapter_bank,
    find,
    home,
    load,
    open_bank,
    readable,
)
from corollary.problem.diagnostic import Malformed
from corollary.problem.problem_set import find_set
from corollary.problem.translation import translations

FRONT = "code: {code}\ntitle: A cart\ngiven:\n  m: {{is: mass, value: 1, unit: kg}}"


@pytest.fixture
def bank(write, tmp_path) -> Bank:
    write(FRONT.format(code="X1.2"), "## M {#a .value}\n", name="cart")
    write(FRONT.format(code="X1.10"), "## M {#a .value}\n", name="sledge")
    return open_bank(tmp_path)


@pytest.mark.parametrize("code", ["X1.2", "x1.2", "cart"])
def test_found_by_code_and_by_name(bank, code):
    assert find(bank, code).name == "cart"


def test_found_by_path(bank, tmp_path, monkeypatch):
    path = tmp_path / "problems" / "carts" / "cart.md"
    assert find(bank, str(path)).code == "X1.2"
    monkeypatch.chdir(path.parent)
    place, problem = home(None, "cart.md")
    assert problem.code == "X1.2"
    assert place.solution(problem) == tmp_path / "solutions" / "carts" / "cart.md"


def test_a_code_that_begins_like_another(bank):
    with pytest.raises(UnknownCode, match=r"no problem is called X1\.1 \(did you mean"):
        find(bank, "X1.1")


def test_a_code_written_in_quotes(bank, write):
    write(FRONT.format(code='"X1.3"'), "## M {#a .value}\n", name="quoted")
    assert find(bank, "X1.3").name == "quoted"


def test_in_the_order_of_the_chapter(bank):
    assert [problem.code for problem in load(bank)] == ["X1.2", "X1.10"]


def test_two_of_one_code(bank, write):
    write(FRONT.format(code="x1.10"), "## M {#a .value}\n", name="wagon")
    with pytest.raises(Malformed, match=r"wagon\.md:2: sledge\.md has the code x1\.10 already"):
        load(bank)


def test_two_of_one_name(bank, tmp_path):
    other = tmp_path / "problems" / "ships" / "cart.md"
    other.parent.mkdir()
    other.write_text("---\n" + FRONT.format(code="X9.9") + "\n---\n## M {#a .value}\n", encoding="utf-8")
    with pytest.raises(Malformed, match=r"cart\.md:1: there is another cart\.md in carts/"):
        load(bank)


def test_complaints_of_every_file(bank, write):
    write("title: A", "## M {#a .value}\n", name="first")
    write("title: B", "## M {#a .value}\n", name="second")
    with pytest.raises(Malformed) as raised:
        load(bank)
    assert {complaint.path.name for complaint in raised.value.complaints} == {"first.md", "second.md"}


@pytest.mark.parametrize("code", ["nothing.md", "X9", "", "../../etc/passwd", "sets"])
def test_what_is_not_there(bank, code):
    with pytest.raises(UnknownCode):
        find(bank, code)


def test_a_path_outside_the_bank(bank, tmp_path):
    alone = tmp_path / "alone.md"
    alone.write_text("---\n" + FRONT.format(code="X9.9") + "\n---\n## M {#a .value}\n", encoding="utf-8")
    with pytest.raises(UnknownCode, match="is not in"):
        find(bank, str(alone))
    with pytest.raises(UnknownCode, match="is in no bank"):
        home(None, str(alone))


def test_a_folder_that_is_no_bank(tmp_path):
    with pytest.raises(UnknownCode, match="no folder problems/"):
        open_bank(tmp_path / "nowhere")


def test_every_code_of_the_chapter_leads_back_to_its_problem():
    bank = chapter_bank()
    problems = load(bank)
    assert len(problems) >= 5
    for problem in problems:
        assert find(bank, problem.code) == find(bank, problem.name) == problem


@pytest.fixture
def other(tmp_path) -> Path:
    """Another bank, in a package that could be installed: X9.1, and a set."""
    folder = tmp_path / "site" / "heat_problems"
    (folder / "problems" / "heat").mkdir(parents=True)
    (folder / "problems" / "sets").mkdir()
    text = "---\n" + FRONT.format(code="X9.1") + "\n---\n## M {#a .value}\n"
    (folder / "problems" / "heat" / "kettle.md").write_text(text, encoding="utf-8")
    text = "---\ntitle: Warm\nproblems:\n  - X9.1\n  - X1.2\n---\n"
    (folder / "problems" / "sets" / "warm.md").write_text(text, encoding="utf-8")
    (folder / "__init__.py").write_text("", encoding="utf-8")
    return folder


def test_several_banks_are_one(bank, other):
    both = open_bank(Path(os.pathsep.join((str(bank.folder), str(other)))))
    assert [problem.code for problem in load(both)] == ["X1.2", "X1.10", "X9.1"]
    assert both.solution(find(both, "kettle")) == other / "solutions" / "heat" / "kettle.md"
    assert both.solution(find(both, "cart")) == bank.folder / "solutions" / "carts" / "cart.md"
    assert find(both, str(other / "problems" / "heat" / "kettle.md")).code == "X9.1"
    assert [problem.code for problem in find_set(both, "warm").problems] == ["X9.1", "X1.2"]
    assert open_bank(Path(both.place)) == both
    assert open_bank(Path(os.pathsep.join([str(other)] * 2))) == open_bank(other)


def test_a_code_that_two_banks_have(bank, other):
    path = other / "problems" / "heat" / "kettle.md"
    path.write_text(path.read_text().replace("X9.1", "X1.2"), encoding="utf-8")
    with pytest.raises(Malformed, match=r"kettle\.md:2: cart\.md has the code X1\.2 already"):
        load(open_bank(Path(os.pathsep.join((str(bank.folder), str(other))))))


def test_the_bank_of_an_installed_package(other, installed, monkeypatch, tmp_path):
    installed("warmth", {"corollary.banks": ["heat = heat_problems", "empty = json"]})
    monkeypatch.syspath_prepend(other.parent)
    monkeypatch.chdir(tmp_path)
    assert open_bank(Path("heat")).folder == other
    assert (
        "heat_problems" in sys.modules
    )  # its package may bring units, and registers them when it is imported
    assert open_bank(Path(f"chapter{os.pathsep}heat")).more == (other,)
    with pytest.raises(
        PlugInFault, match="the bank empty of warmth cannot be used: json: it has no folder problems/"
    ):
        open_bank(Path("empty"))
    with pytest.raises(UnknownCode, match="the banks installed are chapter, empty, heat"):
        open_bank(Path("optics"))
    installed("chapters", {"corollary.banks": ["chapter = heat_problems"]})
    with pytest.raises(
        PlugInFault, match="corollary-physics and chapters are both installed and both bring chapter"
    ):
        open_bank(Path("optics"))


def test_the_bank_that_the_environment_names(bank, other, monkeypatch):
    monkeypatch.setenv("COROLLARY_BANK", os.pathsep.join((str(bank.folder), str(other))))
    assert open_bank(None).more == (other,)
    assert home(None, "kettle")[1].code == "X9.1"
    assert open_bank(bank.folder) == bank
    monkeypatch.setenv("COROLLARY_BANK", "")
    assert open_bank(None) == chapter_bank()


def test_what_is_no_file_is_that_problems_complaint(bank, tmp_path):
    """A folder named like a translation is none; a pipe named like a problem is not waited for."""
    beside = next(iter(bank)).path
    beside.with_name(f"{beside.stem}.de.md").mkdir()
    os.mkfifo(beside.with_name("pipe.md"))
    problems, complaints = readable(bank)
    assert beside in [each.path for each in problems]
    assert translations(beside) == {}
    assert list(map(str, complaints)) == ["pipe.md:1: is a folder, a pipe or a device; a problem is a file"]
