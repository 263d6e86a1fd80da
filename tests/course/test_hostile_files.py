"""Whatever is handed in costs its student a person's look, and nobody else anything."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path

import pytest

from .conftest import COMMAND, SET, grade

pytestmark = pytest.mark.whole

NOBODY = 65534
ORDINARY_USER = Path(__file__).parents[1] / "adversary" / "ordinary_user.py"


def sparse(path: Path) -> None:
    with path.open("wb") as file:
        file.truncate(40 << 30)


HARM: dict[str, Callable[[Path], object]] = {
    "pipe": os.mkfifo,
    "folder": os.mkdir,
    "device": lambda path: path.symlink_to("/dev/zero"),
    "nowhere": lambda path: path.symlink_to("/no/such/file"),
    "sparse": sparse,
}


def only_ben_is_looked_at(course: Path) -> str:
    """Grades, and gives why nothing could be read of Ben's."""
    done = grade(course)
    assert done.status == 0, done.errors
    assert done.document["failed"] == ["ben"]
    assert done.points == {"ada": 5.0, "ben": 0.0, "cyd": 5.0}
    return done.document["students"]["ben"]["trouble"]


@pytest.mark.parametrize("kind", HARM)
def test_a_notebook_that_is_no_file(kind: str, handed_in: Path) -> None:
    notebook = handed_in / "submitted" / "ben" / "one" / "one.ipynb"
    notebook.unlink()
    HARM[kind](notebook)
    assert "could not be opened" in only_ben_is_looked_at(handed_in)


def test_nbgraders_autograde_opens_no_pipe_and_follows_no_link(handed_in: Path) -> None:
    pytest.importorskip("nbgrader")
    for student, kind in (("ada", "pipe"), ("ben", "device")):
        notebook = handed_in / "submitted" / student / "one" / "one.ipynb"
        notebook.unlink()
        HARM[kind](notebook)
    line = [COMMAND.with_name("nbgrader"), "autograde", "one"]
    subprocess.run(line, cwd=handed_in, timeout=120, check=True, capture_output=True)
    done = grade(handed_in)
    assert (done.document["graded"], done.document["failed"]) == (0, ["ada", "ben"])
    assert done.points == {"ada": 0.0, "ben": 0.0, "cyd": 5.0}


def test_a_students_folder_that_is_a_link(handed_in: Path) -> None:
    shutil.rmtree(handed_in / "submitted" / "ben")
    (handed_in / "submitted" / "ben").symlink_to("ada")
    assert "link" in only_ben_is_looked_at(handed_in)


@pytest.mark.parametrize("kind", [*HARM, "key"])
def test_files_beside_the_notebook_that_are_none(kind: str, handed_in: Path) -> None:
    for file in ("timestamp.txt", "submission_secret.txt"):
        beside = handed_in / "submitted" / "ben" / "one" / file
        if kind == "key":
            beside.symlink_to("../../../.corollary/key")
        else:
            HARM[kind](beside)
    done = grade(handed_in)
    assert (done.status, done.points) == (0, {"ada": 5.0, "ben": 5.0, "cyd": 5.0}), done.errors
    key = (handed_in / ".corollary" / "key").read_bytes()
    for step in ("autograded", "feedback"):
        for copied in (handed_in / step).rglob("*"):
            assert not copied.is_symlink()
            assert copied.is_dir() or (copied.stat().st_size < 1 << 20 and key not in copied.read_bytes())


@pytest.mark.parametrize(
    "texts",
    [
        ("0001-01-01 00:00:00 +0500", "0001-01-01 00:00:00 UTC", "9" * 900),
        ("2026-12-04 21:03:11 Zone/../../etc/passwd", "\x00\ud800", "\x1b[2J"),
    ],
)
def test_timestamps_that_mean_nothing(texts: tuple[str, ...], handed_in: Path) -> None:
    for student, text in zip(("ada", "ben", "cyd"), texts, strict=True):
        stamp = handed_in / "submitted" / student / "one" / "timestamp.txt"
        stamp.write_bytes(text.encode("utf-8", "surrogatepass"))
    done = grade(handed_in)
    assert (done.status, done.points) == (0, {"ada": 5.0, "ben": 5.0, "cyd": 5.0}), done.errors


def test_an_attachment_whose_name_no_file_can_hold(handed_in: Path) -> None:
    path = handed_in / "submitted" / "ben" / "one" / "one.ipynb"
    notebook = json.loads(path.read_text(encoding="utf-8"))
    png = "iVBORw0KGgo="
    for cell in notebook["cells"]:
        if cell["cell_type"] == "markdown":
            cell["attachments"] = {"\ud800.png": {"image/png": png}}
    path.write_text(json.dumps(notebook))
    done = grade(handed_in)
    assert (done.status, done.points) == (0, {"ada": 5.0, "ben": 5.0, "cyd": 5.0}), done.errors


def test_names_of_folders_and_files_are_written_out(handed_in: Path) -> None:
    sheet = handed_in / "submitted" / "ada" / "one" / "one.ipynb"
    strangers = {b"e\x1b[2Jvil<script>": "e\\x1b[2Jvil<script>", b"\xff\xc2\x9b1m": "\\udcff\\x9b1m"}
    for name in strangers:
        folder = handed_in / "submitted" / os.fsdecode(name) / "one"
        folder.mkdir(parents=True)
        shutil.copy(sheet, folder)
    unclear = handed_in / "submitted" / "ben" / "one"
    (unclear / "one.ipynb").rename(unclear / "a\x1b]0;x\x07.ipynb")
    shutil.copy(sheet, unclear / "b\u202e.ipynb")
    done = grade(handed_in)
    assert done.status == 0
    for written in (*strangers.values(), "a\\x1b]0;x\\x07.ipynb", "b\\u202e.ipynb"):
        assert written in done.errors
    assert not {"\x1b", "\x07", "\x9b", "\u202e"} & set(done.errors)
    assert set(done.document["strangers"]) == {os.fsdecode(name) for name in strangers}
    assert "vil<script>" not in Path(done.document["report"]).read_text(encoding="utf-8")


@pytest.mark.usefixtures("open_to_everybody")
def test_a_folder_that_an_ordinary_user_cannot_look_into(handed_in: Path) -> None:
    with tempfile.TemporaryDirectory() as name:  # pytest's own folders are for one user
        folder = Path(name)
        folder.chmod(0o777)
        course = Path(shutil.copytree(handed_in, folder / "course"))
        (folder / "one.md").write_text(SET)
        if os.geteuid() == 0:
            for place in (course, *course.rglob("*")):
                os.chown(place, NOBODY, NOBODY)
        closed = course / "submitted" / "ben"
        closed.chmod(0)
        about = {"HOME": name, "TMPDIR": name, "PYTHONDONTWRITEBYTECODE": "1"}
        by = (sys.executable, ORDINARY_USER)
        done = grade(course, by=by, name=folder / "one.md", **about)
        assert done.document["failed"] == ["ben"], done.errors
        assert done.points == {"ada": 5.0, "cyd": 5.0}  # no 0 on record: it is the rights that are wrong
        assert "ben is not graded" in done.errors
        assert "Permission denied" in done.errors
        closed.chmod(0o755)
        assert grade(course, by=by, name=folder / "one.md", **about).points["ben"] == 5.0
