"""Hostile files in place of banks: each costs itself alone, and what stands beside it is audited."""

from __future__ import annotations

import json
import time
from functools import partial
from pathlib import Path

import pytest
from click.testing import CliRunner
from hypothesis import given
from hypothesis import strategies as st
from tests.audit.hostile_files import GOOD, hostile_files
from tests.audit.test_audit import audit

from corollary.audit.bank_file import READERS
from corollary.audit.limited_reading import LimitedReader
from corollary.cli.commands import app
from corollary.problem.diagnostic import Malformed
from corollary.sandbox.limited import Limited, NotFinished

READABLE = {"good", "closed"}  # `good` also with a long convention; a closed file, to root
SIZE = 20_000  # characters: what grows with the square of it takes minutes


@pytest.fixture
def good(tmp_path):
    path = tmp_path / "good.yaml"
    path.write_text(GOOD, encoding="utf-8")
    return path


def test_the_command_goes_on_behind_two_hundred_hostile_files(tmp_path, good):
    paths = hostile_files(tmp_path, SIZE)
    assert len(paths) > 200
    done = audit(*paths, good, "--json")
    assert "Traceback" not in done.stderr
    found = json.loads(done.stdout)
    assert (found[-1]["id"], found[-1]["finding"]) == ("good", "agrees")
    assert {each["file"].rpartition(":")[0] for each in found} == {
        "question.html" if path.is_dir() and path.name != "folder.yaml" else path.name
        for path in (*paths, good)
    }
    others = [each["id"] for each in found if each["finding"] not in {"cannot say", "wrong"}]
    assert set(others) <= READABLE, others
    assert not [each for each in found if "not read within" in each["why"] or "reader fails" in each["why"]]
    assert done.returncode == 0
    assert max(len(each["why"]) for each in found) < 6000


def test_on_a_terminal_and_on_the_page_nothing_of_it_is_obeyed(tmp_path, good):
    paths = [
        each
        for each in hostile_files(tmp_path, 1000)
        if each.name in {"control.yaml", "half_character.yaml", "half_character.json"}
    ]
    assert len(paths) == 3
    page = tmp_path / "page.html"
    done = audit(*paths, good, "--report", page)
    assert done.returncode == 0, done.stderr
    assert "\x1b" not in done.stdout + done.stderr
    assert "good" in page.read_text(encoding="utf-8")


@pytest.mark.whole
def test_programs_that_do_not_end_cost_themselves_alone(tmp_path, good):
    folders = [
        each
        for each in hostile_files(tmp_path, 1000)
        if each.parent.name
        in {"server_endless", "server_memory", "server_long_text", "server_recursive", "server_minus"}
    ]
    laws = tmp_path / "laws.yaml"
    laws.write_text(
        "".join(
            f"- {{id: {each.parent.name}, given: {{m: kg}}, laws: [F = m], asked: F}}\n" for each in folders
        ),
        encoding="utf-8",
    )
    done = audit(*folders, good, "--laws", laws, "--run", "--seeds", "1", "--json")
    found = json.loads(done.stdout)
    assert [each["finding"] for each in found] == ["cannot say"] * len(folders) + ["agrees"]
    assert done.returncode == 0, done.stderr


@pytest.mark.parametrize(
    ("names", "status"),
    [
        (["good.yaml"], 0),
        (["good.yaml", "bad.xml"], 0),
        (["bad.xml"], 2),
        (["bad.xml", "good.yaml", "nowhere.yaml"], 2),
        (["good.yaml", "bank.doc"], 2),
        (["bad.xml", "wrong.yaml"], 1),
        (["nowhere.yaml", "wrong.yaml"], 1),
    ],
)
def test_the_status_is_that_of_what_was_read(tmp_path, good, names, status):
    """2 is for a file that is not there, or of no kind, and for nothing that could be read."""
    (tmp_path / "bad.xml").write_text("<quiz>", encoding="utf-8")
    (tmp_path / "bank.doc").write_text("hello", encoding="utf-8")
    (tmp_path / "wrong.yaml").write_text(GOOD.replace("6.0", "7.0"), encoding="utf-8")
    done = CliRunner().invoke(app, ["audit", *(str(tmp_path / name) for name in names), "--json"])
    assert done.exit_code == status, done.stderr
    found = json.loads(done.stdout)
    assert [each["file"].partition(":")[0] for each in found] == names
    for each, name in zip(found, names, strict=True):
        assert (each["finding"] == "cannot say") == (name not in {"good.yaml", "wrong.yaml"})
        assert (name in done.stderr) == (each["finding"] == "cannot say")


@pytest.mark.parametrize(
    "function", [partial(time.sleep, 3600), partial(pow, 9, 9**9**2), partial(bytes, 1 << 40)]
)
def test_what_does_not_end_is_stopped_and_what_follows_is_not(function):
    interpreter = Limited()
    with pytest.raises(NotFinished):
        interpreter.call(function, 0.5, 2.0)
    assert interpreter.call(partial(len, "abc"), 5.0) == 3
    interpreter.stop()


def test_a_file_of_laws_that_cannot_be_read_is_refused(tmp_path, good):
    laws = tmp_path / "laws.yaml"
    laws.write_text("[" * SIZE, encoding="utf-8")
    with pytest.raises(Malformed, match=r"laws\.yaml:1: is nested too deeply"), LimitedReader(laws, None):
        pass


PIECES = [
    "ANS(", "num_cmp(", "$a", "$b", " = ", ";", "\n", "random(1,5,1)", "BEGIN_TEXT", "END_TEXT", "BEGIN_PGML", "END_PGML", "[__]{", "}",
    "\\{", "<<'A'", "A", ")", "+", "-", "**", "2", "<quiz>", "</quiz>", "<question type='numerical'>", "</question>",
    "<answer fraction='100'>", "</answer>", "<text>", "</text>", "<pl-number-input answers-name='F'>", "<!--", "-->", "'", '"', "```{r}",
    "```", "m <- ", "sample(1:9, 1)", "extype: num", "exsolution: `r m`", "extype: cloze", "exclozetype: num|schoice", "Answerlist", "* 1",
    "\\Sexpr{", "é", "\0", "def generate(data):", "    data['correct_answers']['F'] = ", "    m = random.randint(1, 3)", "import random",
    "round(", "\\begin{answerlist}", "\\item", "[", "]", "1e999", "NAMED_ANS(", "=>",
]  # fmt: skip


@given(
    pieces=st.lists(st.sampled_from(PIECES), max_size=25),
    server=st.lists(st.sampled_from(PIECES), max_size=12),
)
def test_whatever_stands_in_a_file_is_read_or_said_not_to_be(tmp_path_factory, pieces, server):
    folder: Path = tmp_path_factory.mktemp("piece")
    (folder / "server.py").write_text("".join(server), encoding="utf-8")
    for ending, records_of in READERS.items():
        path = folder / ("question.html" if ending == ".html" else f"bank{ending}")
        path.write_text("".join(pieces), encoding="utf-8")
        try:
            records = records_of(path)
        except Malformed:
            continue
        assert all(each.unread or each.published for each in records)
