"""A disk that is full costs no marks: the run says so, and the next one, with room again, marks what is left."""

from __future__ import annotations

import json
import subprocess
from pathlib import Path

import pytest

from .conftest import COMMAND, STUDENTS, grade

pytestmark = pytest.mark.whole

# In a mount namespace of its own, where nobody else meets the disk.
ASIDE = ("unshare", "--map-root-user", "--mount", "sh", "-euc")
EVERYBODY = dict.fromkeys(STUDENTS, 5.0)


@pytest.mark.parametrize("options", ["size=64k", "size=64k,nr_inodes=1"], ids=["no block", "no file"])
def test_a_full_folder_for_temporary_files(options: str, handed_in: Path, tmp_path: Path) -> None:
    full = tmp_path / "full"
    full.mkdir()
    script = f'mount -t tmpfs -o {options} tmpfs "{full}"; cat /dev/zero > "{full}/fill" || true; exec "$@"'
    done = grade(handed_in, by=(*ASIDE, script, "sh"), TMPDIR=str(full))
    assert (done.status, done.points) == (0, EVERYBODY), done.errors


@pytest.mark.parametrize("room", [0, 40, 80, 120], ids="{} kB".format)
def test_a_full_disk_under_the_course(room: int, handed_in: Path, tmp_path: Path) -> None:
    """Filled up to so many kilobytes: the first run meets its end somewhere on its way."""
    script = f"""
        disk="{tmp_path}/disk"; mkdir "$disk"
        mount -t tmpfs -o size=16m tmpfs "$disk"
        cp -r "{handed_in}" "$disk/course"
        head -c $(( ($(df -k --output=avail "$disk" | tail -1) - {room}) * 1024 )) /dev/zero > "$disk/fill"
        "{COMMAND}" grade one --course "$disk/course" --jobs 1 > /dev/null 2> "{tmp_path}/said" && exit 1
        rm "$disk/fill"
        "{COMMAND}" grade one --course "$disk/course" --jobs 1 --json > "{tmp_path}/answer"
        ls -A "$disk/course" "$disk/course/.corollary" > "{tmp_path}/files"
    """
    done = subprocess.run([*ASIDE, script], capture_output=True, text=True, timeout=120, check=False)
    said = (tmp_path / "said").read_text()
    assert done.returncode == 0, (done.stderr, said)
    assert "corollary: No space left on device" in said
    assert "free disk space and run this again" in said
    assert "Traceback" not in said
    students = json.loads((tmp_path / "answer").read_text())["students"]
    assert {student: each["points"] for student, each in students.items()} == EVERYBODY
    assert "draft" not in (tmp_path / "files").read_text()
