"""`corollary share`: rights of a course for a group, of what is written later, and what `doctor` says of them."""

from __future__ import annotations

import json
import os
import shlex
import stat
from collections.abc import Iterator
from pathlib import Path

import pytest
from click.testing import CliRunner

from corollary.atomic import open_to_append, write_whole
from corollary.cli.commands import app
from corollary.problem.roster import Student
from corollary.records.files import create_course

GROUP = "daemon"  # every Debian has it; no group is made for a test
pytestmark = pytest.mark.skipif(
    not hasattr(os, "geteuid") or os.geteuid() != 0, reason="only root is free to choose the group of a file"
)


@pytest.fixture
def course(tmp_path: Path) -> Iterator[Path]:
    before = os.umask(0o077)  # of somebody careful
    yield create_course(tmp_path / "mech", [Student("ada")]).folder
    os.umask(before)


def run(*words: object) -> tuple[int, str, str]:
    done = CliRunner().invoke(app, [str(word) for word in words], catch_exceptions=False)
    return done.exit_code, done.stdout, done.stderr


def rights(course: Path) -> dict[str, str]:
    found = json.loads(run("doctor", "--course", course, "--json")[1])["findings"]
    return next(each for each in found if each["name"] == "rights")


def test_a_new_course_is_its_owners_alone_and_a_shared_one_the_groups(course: Path) -> None:
    assert stat.S_IMODE(course.stat().st_mode) == 0o700
    (course / "reports").mkdir(mode=0o755)
    status, out, _ = run("share", "--group", GROUP, "--course", course)
    assert "is shared with daemon" in out
    assert status == 1, "pytest's own folders let nobody pass, which is said"
    write_whole(course / ".corollary" / "later" / "one.json", "{}", mode=0o600)
    os.close(open_to_append(course / "reports" / "log.txt"))
    for path in (course, *course.rglob("*")):
        wanted = 0o2770 if path.is_dir() else 0o660
        assert (path.group(), stat.S_IMODE(path.stat().st_mode)) == (GROUP, wanted), path
    assert (rights(course)["state"], "group daemon" in rights(course)["sentence"]) == ("good", True)


def test_what_the_group_cannot_use_is_named_and_the_advice_mends_it(course: Path) -> None:
    run("share", "--group", GROUP, "--course", course)
    (course / "gradebook.db").touch(mode=0o600)
    found = rights(course)
    assert found["state"] == "weak"
    assert "gradebook.db" in found["sentence"]
    run(*shlex.split(found["remedy"])[1:])
    assert rights(course)["state"] == "good"


@pytest.mark.parametrize(
    ("group", "sentence"),
    [
        ("users", "is not one of a team"),
        ("daemon", "has students of this course: daemon"),
        ("daemn", "did you mean daemon"),
    ],
)
def test_a_group_that_is_not_the_teams_is_refused(tmp_path: Path, group: str, sentence: str) -> None:
    course = create_course(tmp_path / "mech", [Student("daemon")]).folder
    status, _, err = run("share", "--group", group, "--course", course)
    assert (status, sentence in err) == (2, True), err
    assert stat.S_IMODE(course.stat().st_mode) == 0o700
