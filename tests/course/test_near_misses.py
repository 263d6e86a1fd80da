"""Near misses of reading in a graded class: reported by kind and text, accepted for all students of a group, and by nobody else."""

from __future__ import annotations

import json
import re
import subprocess
import threading
import urllib.request
from pathlib import Path
from typing import Any

import pytest
from tests import forked

from corollary.grading.solutions import Solutions
from corollary.notebook.notebook import filled_in
from corollary.notebook.worksheet import worksheet
from corollary.problem.roster import Student
from corollary.records.assignments import read_assigned
from corollary.records.files import open_course
from corollary.records.origin import set_of

from .conftest import COMMAND, STUDENTS, Graded, grade


def command(course: Path, *words: str) -> subprocess.CompletedProcess[str]:
    line = [str(COMMAND), words[0], "one", "--course", str(course), *words[1:]]
    return forked.run(line, capture_output=True, encoding="utf-8", timeout=120, check=False)


def near_misses(course: Path) -> list[dict[str, Any]]:
    return json.loads(command(course, "report", "--json").stdout)["near_misses"]


def write(course: Path, student: str, **answers: str) -> dict[str, float]:
    """A student's notebook with these answers and no others, each with `{}` for the right number; those numbers."""
    opened = open_course(course)
    place, problem_set = set_of(opened, "one", None)
    solutions = Solutions(place)
    row = read_assigned(opened, problem_set)[student]
    sheet = worksheet(problem_set, Student(student), row.variants)
    (key,) = (solutions.key(each.variant) for each in sheet.exercises)
    right = {part: truth.values[0] for part, truth in key.truths.items()}
    cells = {
        f"X12_5_{part}_answer": f"X12_5_{part} = "
        + text.replace("{}", f"{right[part]:.4g}").replace("{e}", f"{right[part] / 100:.4g}")
        for part, text in answers.items()
    }
    opened.notebook("submitted", student, "one").write_text(filled_in(sheet, cells), encoding="utf-8")
    return right


@pytest.fixture
def course(handed_in: Path) -> tuple[Path, Graded]:
    """Ada and Ben lose a power of ten, each with numbers of their own; Cyd writes a sentence, forgets quotes and is wrong."""
    write(handed_in, "ada", d='"{e}*102 N"', a='"{} kg m/s"')
    write(handed_in, "ben", d='"{e}*102 N"', c="1")
    write(handed_in, "cyd", d='"-7.65e9 N"', c='"I think it is {}, for p = mv"', a="{} kg m/s")
    done = grade(handed_in)
    assert done.status == 0, done.errors
    return handed_in, done


def test_they_are_grouped_by_kind_and_text_and_nothing_is_given(course: tuple[Path, Graded]):
    folder, done = course
    found = near_misses(folder)
    groups = {(each["part"], each["kind"]): each for each in found}
    assert len(groups) == len(found) == 3
    power = groups["d", "power of ten lost"]
    assert (power["text"], power["students"]) == ("…*… N", ["ada", "ben"])
    assert all(re.fullmatch(r"[\d.]+\*102 N", each["typed"]) for each in power["answers"])
    assert all(each["read"].endswith(" N") and each["points"] == 2 for each in power["answers"])
    assert groups["c", "one number in words that were not read"]["students"] == ["cyd"]
    assert groups["a", "text without quotes"]["students"] == ["cyd"]
    assert done.points == {"ada": 1.0, "ben": 0.0, "cyd": 0.0}
    assert "near" not in done.document["students"]["ada"]["parts"]["X12_5_d"]
    table = command(folder, "report").stdout
    assert "Near misses of reading" in table
    assert power["id"] in table
    page = (folder / "reports" / "one.html").read_text(encoding="utf-8")
    assert f"corollary mark one --accept {power['id']}" in page


def test_a_group_is_accepted_for_all_its_students_and_stays_so(course: tuple[Path, Graded]):
    folder, _ = course
    power = near_misses(folder)[0]
    done = command(folder, "mark", "--accept", power["id"])
    assert (done.returncode, done.stdout) == (0, "2 marks given in one\n"), done.stderr
    assert [each["kind"] for each in near_misses(folder)] == [
        "text without quotes",
        "one number in words that were not read",
    ]
    for words in ((), ("--regrade", "--yes")):
        again = grade(folder, *words)
        assert again.points == {"ada": 3.0, "ben": 2.0, "cyd": 0.0}, again.errors
    for student in ("ada", "ben"):
        page = (folder / "feedback" / student / "one" / "one.html").read_text(encoding="utf-8")
        taken = next(each["read"] for each in power["answers"] if each["student"] == student)
        assert f"Your answer was taken as <code>{taken}</code>" in page
    gone = command(folder, "mark", "--accept", power["id"])
    assert gone.returncode == 2
    assert f"--accept {power['id']}: one has no near misses of this name; its groups are " in gone.stderr


@pytest.mark.whole
def test_what_was_accepted_stands_for_that_answer_only(course: tuple[Path, Graded]):
    folder, _ = course
    group = near_misses(folder)[0]["id"]
    assert command(folder, "mark", "--accept", group).returncode == 0
    write(folder, "ada", d='"0.5*102 N"')
    grade(folder)
    waiting = json.loads(command(folder, "report", "--json").stdout)["waiting"]
    assert [(each["student"], each["part"]) for each in waiting if "has changed" in each["why"]] == [
        ("ada", "d")
    ]


@pytest.mark.whole
def test_a_mark_by_hand_takes_it_off_the_list(course: tuple[Path, Graded]):
    folder, _ = course
    assert command(folder, "mark", "--set", "cyd/X12.5c=0").returncode == 0
    assert "c" not in {each["part"] for each in near_misses(folder)}


@pytest.mark.whole
def test_the_page_for_marking_shows_each_group_with_one_button(course: tuple[Path, Graded]):
    folder, _ = course
    line = [str(COMMAND), "mark", "one", "--course", str(folder), "--no-browser"]
    with subprocess.Popen(line, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True) as server:
        try:
            assert server.stdout is not None
            address = next(found[0] for each in server.stdout if (found := re.search(r"http://\S+/", each)))
            rest = threading.Thread(target=server.stdout.read)
            rest.start()
            with urllib.request.urlopen(address, timeout=60) as answer:
                page = answer.read().decode()
            article = next(
                each for each in page.split("<article")[1:] if 'class="accept"' in each and "*102 N" in each
            )
            assert "Accept for all 2" in article
            group = re.search(r'data-group="(\w+)"', article)
            assert group is not None
            body = json.dumps({"group": group[1], "points": 2, "comment": ""}).encode()
            asked = urllib.request.Request(
                f"{address}give",
                body,
                {"Content-Type": "application/json", "Origin": address[: address.index("/", 8)]},
            )
            with urllib.request.urlopen(asked, timeout=60) as answer:
                assert json.loads(answer.read()) == {"saved": 2}
        finally:
            server.terminate()
            server.wait(60)
    assert grade(folder).points == {"ada": 3.0, "ben": 2.0, "cyd": 0.0}
    assert set(STUDENTS) == {"ada", "ben", "cyd"}
