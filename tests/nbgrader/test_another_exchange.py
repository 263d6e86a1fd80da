"""An exchange that is not nbgrader's own, such as ngshare: what hands in and feedback go through it as ever, own sheets do not."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from tests import forked

pytest.importorskip("nbgrader")

from corollary.course.generate import generate
from corollary.grading.solutions import Solutions
from corollary.problem.bank import chapter_bank
from corollary.problem.problem_set import find_set
from corollary.problem.roster import Student

pytestmark = pytest.mark.whole
SET = "---\ntitle: One exercise\nproblems:\n  - X12.5\n---\nOne exercise.\n"
BIN = Path(sys.executable).parent
# A service that has one folder for what is released and one for each student's work, and is named by the traits of
# ExchangeFactory, as ngshare_exchange.configureExchange does. As ngshare's, it knows by the page's timestamp.txt what was handed in.
SERVICE = """
import shutil
from pathlib import Path

from nbgrader.exchange import abc

SERVICE = Path({service!r})


class Collect(abc.ExchangeCollect):
    def init_src(self):
        self.src_path = str(SERVICE / "submissions" / self.coursedir.assignment_id)

    def init_dest(self):
        self.dest_path = str(Path(self.coursedir.root, "submitted"))

    def copy_files(self):
        for place in sorted(Path(self.src_path).iterdir()):
            shutil.copytree(place, Path(self.dest_path, place.name, self.coursedir.assignment_id))


class ReleaseFeedback(abc.ExchangeReleaseFeedback):
    def init_src(self):
        self.src_path = str(Path(self.coursedir.root, "feedback"))

    def init_dest(self):
        self.dest_path = str(SERVICE / "feedback")

    def copy_files(self):
        for page in Path(self.src_path).glob("*/*/*.html"):
            assert page.with_name("timestamp.txt").read_text() == "2026-08-05 10:00:00.000000 UTC"
            place = Path(self.dest_path, page.parts[-3])
            place.mkdir(parents=True, exist_ok=True)
            shutil.copy(page, place)


class Release(abc.ExchangeReleaseAssignment):
    def init_src(self):
        self.src_path = str(Path(self.coursedir.root, "release", self.coursedir.assignment_id))

    def init_dest(self):
        self.dest_path = str(SERVICE / "released")

    def copy_files(self):
        shutil.copytree(self.src_path, self.dest_path)


c.ExchangeFactory.release_assignment = Release
c.ExchangeFactory.collect = Collect
c.ExchangeFactory.release_feedback = ReleaseFeedback
"""


@pytest.fixture
def course(tmp_path: Path) -> Path:
    (tmp_path / "one.md").write_text(SET)
    bank = chapter_bank()
    problem_set = find_set(bank, str(tmp_path / "one.md"))
    roster = [Student("ada"), Student("ben")]
    made = generate(tmp_path / "course", problem_set, roster, Solutions(bank)).course
    config = made.folder / "nbgrader_config.py"
    config.write_text(config.read_text() + SERVICE.format(service=str(tmp_path / "service")))
    for student in ("ada", "ben"):
        place = tmp_path / "service" / "submissions" / "one" / student
        place.mkdir(parents=True)
        shutil.copy(made.notebook("release", student, "one"), place)
        (place / "timestamp.txt").write_text("2026-08-05 10:00:00.000000 UTC")
    return made.folder


def run(course: Path, program: str, *words: str) -> subprocess.CompletedProcess[str]:
    environment = {**os.environ, "PATH": f"{BIN}{os.pathsep}{os.environ['PATH']}"}
    return forked.run([BIN / program, *words], cwd=course, env=environment, timeout=300)


def test_hand_ins_and_feedback_go_through_it_and_own_sheets_do_not(course: Path) -> None:
    service = course.parent / "service"
    refused = run(course, "corollary", "release", "one", "--to", "exchange")
    assert refused.returncode == 1
    assert "Release, which nbgrader_config.py names, gives everybody the same notebook" in refused.stderr
    assert not (service / "released").exists()
    collected = run(course, "nbgrader", "collect", "one")
    assert collected.returncode == 0, collected.stderr
    graded = run(course, "corollary", "grade", "one")
    assert graded.returncode == 0, graded.stderr
    released = run(course, "nbgrader", "release_feedback", "one")
    assert released.returncode == 0, released.stderr
    for student, other in (("ada", "ben"), ("ben", "ada")):
        (page,) = (service / "feedback" / student).iterdir()
        assert page.read_bytes() == (course / "feedback" / student / "one" / "one.html").read_bytes()
        assert f"({other})" not in page.read_text("utf-8")
