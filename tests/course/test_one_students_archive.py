"""Whatever one student's archive is, the others' notebooks are collected as without it, and the student is named."""

from __future__ import annotations

import io
import json
import lzma
import shutil
import zipfile
from collections.abc import Mapping
from functools import cache
from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as some

from corollary.course import collect as collecting
from corollary.course.attack.hostile_archives import HOSTILE, far_away, of_method, packed, without_a_name
from corollary.course.collect import Collected, collect
from corollary.nbgrader.zip_collect import BoundedExtractor
from corollary.problem.problem_set import ProblemSet
from corollary.records.files import Course, open_course
from corollary.records.origin import set_of
from corollary.records.submissions import ACCEPTED, NOBODY, UNUSABLE

from .test_collect import NOW

LMS = "Ben Bool_18_assignsubmission_file_"
OTHERS = {"ada": "Ada Lovelace_17_assignsubmission_file_", "cyd": "Cyd Charisse_19_assignsubmission_file_"}
NAMES = "id,first_name,last_name,email\nada,Ada,Lovelace,\nben,Ben,Bool,\ncyd,Cyd,Charisse,\n"


@pytest.fixture(scope="module")
def came(
    _handed_in: Path, tmp_path_factory: pytest.TempPathFactory
) -> tuple[Course, ProblemSet, dict[str, bytes]]:
    """A course with names on its roster, into which nothing is collected yet, and everybody's right notebook."""
    folder = Path(shutil.copytree(_handed_in, tmp_path_factory.mktemp("hostile") / "course"))
    (folder / ".corollary" / "roster.csv").write_text(NAMES)
    sheets = {
        who: (folder / "submitted" / who / "one" / "one.ipynb").read_bytes() for who in ("ada", "ben", "cyd")
    }
    shutil.rmtree(folder / "submitted")
    course = open_course(folder)
    return course, set_of(course, "one")[1], sheets


def collected(came: tuple[Course, ProblemSet, dict[str, bytes]], bens: Mapping[str, bytes]) -> Collected:
    """What Moodle's archive of everybody's comes to, with these files in Ben's folder; nothing is written."""
    course, problem_set, sheets = came
    content = io.BytesIO()
    with zipfile.ZipFile(content, "w") as made:
        for name, text in bens.items():
            made.writestr(f"{LMS}/{name}", text)
        for who, place in OTHERS.items():
            made.writestr(f"{place}/one.ipynb", sheets[who])
    archive = course.folder.parent / "all.zip"
    archive.write_bytes(content.getvalue())
    return collect(course, problem_set, [archive], now=NOW, dry_run=True)


def others_are_taken(found: Collected) -> None:
    taken = {each.student for each in found.of(ACCEPTED)}
    assert taken >= OTHERS.keys()
    assert not {each.student for each in found.arrivals if each.outcome != ACCEPTED} & OTHERS.keys()


@pytest.mark.parametrize("kind", HOSTILE)
def test_an_archive_that_is_wrong_costs_nobody_else_anything(kind: str, came) -> None:
    found = collected(came, {"work.zip": HOSTILE[kind]()})
    others_are_taken(found)
    refused = [each for each in found.arrivals if each.outcome in (UNUSABLE, NOBODY)]
    assert refused
    assert {each.student for each in refused} == {"ben"}
    for each in refused:
        assert each.why
        assert not {"Error", "Traceback", "LZMA:", "struct"} & set(each.why.replace("(", " ").split())


SMALL = {
    "LZMA garbage": lambda: of_method(14, b"\0\0\5\0" + b"\xff" * 60),
    "an offset of 2^63": far_away,
    "a member without a name": without_a_name,
}


def read_by_python(content: bytes) -> None:
    with zipfile.ZipFile(io.BytesIO(content)) as archive:
        for each in archive.infolist():
            assert each.is_dir() or archive.read(each)


@pytest.mark.parametrize("kind", SMALL)
def test_an_archive_of_less_than_two_hundred_bytes(kind: str, came, tmp_path: Path) -> None:
    """Each holds what Python's own reader raises something else than BadZipFile over."""
    content = SMALL[kind]()
    assert len(content) < 200
    with pytest.raises((lzma.LZMAError, OverflowError, IndexError)):
        read_by_python(content)
    found = collected(came, {"work.zip": content})
    others_are_taken(found)
    refused = [each for each in found.arrivals if each.outcome != ACCEPTED]
    assert {each.student for each in refused} == {"ben"}
    archive = came[0].folder.parent / "all.zip"
    extractor = BoundedExtractor()
    extractor.extract(str(archive), str(tmp_path))
    names = [path.parent.name for path in sorted(tmp_path.rglob("*.ipynb"))]
    assert names == sorted(OTHERS.values())


def test_who_used_up_the_bound_is_named(came) -> None:
    found = collected(came, {"work.zip": HOSTILE["twelve padded notebooks"]()})
    others_are_taken(found)
    why = [each.why for each in found.of(UNUSABLE) if "100 MB" in each.why]
    assert len(why) == 7
    assert "the files of ben are larger than 100 MB when unpacked" in why[0]


def test_padded_notebooks_beside_one_another_use_up_no_others_bound(came) -> None:
    padded = b'{"cells": []}' + b" " * 19_000_000
    found = collected(came, dict.fromkeys((f"{number}.ipynb" for number in range(6)), padded))
    others_are_taken(found)
    assert sum("100 MB" in each.why for each in found.arrivals) == 1


def test_ten_thousand_files_of_one_student(came) -> None:
    data = {f"data/{number}.csv": b"" for number in range(10_000)}
    found = collected(came, {**data, "work.zip": packed(("one.ipynb", came[2]["ben"]))})
    others_are_taken(found)
    assert "ben" in {each.student for each in found.of(ACCEPTED)}
    assert "9900 more of the files of ben are no notebooks" in [each.why for each in found.arrivals]
    assert len(found.arrivals) < 110


def test_a_thousand_small_notebooks_of_one_student_are_not_all_read(came) -> None:
    found = collected(came, {f"{number}.ipynb": b"{}" for number in range(1_000)})
    others_are_taken(found)
    assert sum("more than 500 notebooks" in each.why for each in found.arrivals) == 500


def test_a_failure_of_this_program_over_one_file_stops_nobody_else(came, monkeypatch) -> None:
    real = collecting.identified

    def stumbling(member, *about):
        if member.name.startswith(LMS):
            raise ZeroDivisionError("a fault of ours")
        return real(member, *about)

    monkeypatch.setattr(collecting, "identified", stumbling)
    found = collected(came, {"one.ipynb": came[2]["ben"]})
    others_are_taken(found)
    (why,) = (each.why for each in found.of(UNUSABLE))
    assert "ZeroDivisionError: a fault of ours" in why
    assert found.log is not None
    assert "in stumbling" in found.log.read_text()
    assert found.log.stat().st_mode & 0o777 == 0o600
    monkeypatch.setenv("COROLLARY_DEBUG", "1")
    with pytest.raises(ZeroDivisionError):
        collected(came, {"one.ipynb": came[2]["ben"]})


@cache
def valid() -> bytes:
    text = json.dumps({"nbformat": 4, "nbformat_minor": 5, "metadata": {}, "cells": []}).encode()
    inner = packed(("one.ipynb", text), method=zipfile.ZIP_DEFLATED)
    return packed(
        ("work/one.ipynb", text), ("data.csv", b"1,2"), ("more.zip", inner), method=zipfile.ZIP_DEFLATED
    )


places = some.integers(0, len(valid()) - 1)
changes = some.lists(
    some.tuples(places, some.binary(max_size=8), some.integers(0, 8)), min_size=1, max_size=6
)


@settings(max_examples=40, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(changes)
def test_bytes_changed_at_random(came, bytes_changed) -> None:
    content = bytearray(valid())
    for place, text, cut in bytes_changed:
        content[place : place + cut] = text
    others_are_taken(collected(came, {"work.zip": bytes(content)}))
