"""One student's part of a file is told from a namesake's: by ids, addresses and numbers of the LMS before names."""

from __future__ import annotations

import io
import json
import zipfile

import pytest

from corollary.problem.roster import Student
from corollary.records.person import Person
from corollary.records.separation import mentions, separate

ADA = Student("ada", "Ada", "Lovelace", "ada@uni.example")
OTHER = Student("ada1", "Ada", "Lovelace", "ada.two@uni.example")
MAX = Student("max", "Max", "Born", "max@uni.example")


def person(*others: Student) -> Person:
    """Ada among these others, with the number 1001 in Moodle; 1002 is that of a stranger of her name."""
    everybody = frozenset({"ada", "max", "ada1"})  # who left the roster is in the records
    return Person(
        ADA, (ADA, MAX, *others), {"moodle 1001": "ada"}, ("week1",), everybody, frozenset({"moodle 1002"})
    )


@pytest.mark.parametrize(
    ("table", "left"),
    [
        ("id,first_name,last_name,email\nada,Ada,Lovelace,\nada1,Ada,Lovelace,ada.two@uni.example\n", "ada1"),
        ("Student,ID\nAda Lovelace,ada\nAda Lovelace,ada1\n", "ada1"),
        ("Name;E-mail\nAda Lovelace;ada@uni.example\nAda Lovelace;ada.two@uni.example\n", "ada.two"),
        ("Identifier,Full name,Email address\nParticipant 1001,Ada Lovelace,\nParticipant 1002,Ada Lovelace,\n", "1002"),
    ],
)  # fmt: skip
@pytest.mark.parametrize("on_the_roster", [True, False])
def test_a_row_of_a_namesake_stays(table: str, left: str, on_the_roster: bool) -> None:
    done = separate(("table.csv",), table.encode(), person(OTHER) if on_the_roster else person())
    assert done.entries == 1
    assert done.rest is not None
    lines = done.rest.decode().splitlines()
    assert len(lines) == 2
    assert left in lines[1]


@pytest.mark.parametrize(
    ("table", "left"),
    [
        ("student,partner\nada,max\nmax,ada\n", "max,ada"),
        ("by,about\nmax@uni.example,ada\nada@uni.example,max\n", "max@uni.example,ada"),
        ("Student,Partner\nAda Lovelace,Max Born\nMax Born,Ada Lovelace\n", "Max Born,Ada Lovelace"),
        ("Surname,First name,Username\nLovelace,Ada,ada\nLovelace,Ada,alovelace9\n", "Lovelace,Ada,alovelace9"),
    ],
)  # fmt: skip
def test_a_row_is_of_whom_it_identifies_first(table: str, left: str) -> None:
    done = separate(("pairs.csv",), table.encode(), person())
    assert done.entries == 1
    assert (done.rest or b"").decode().splitlines()[1:] == [left]


def test_a_row_of_a_group_with_somebody_unknown_before_is_hers() -> None:
    table = b"tutor,student\ntutor@uni.example,ada\n"
    assert separate(("tutors.csv",), table, person()).entries == 1


def test_a_row_with_nothing_but_the_name_is_hers_only_where_it_is_one_persons() -> None:
    table = b"Student,Points\nAda Lovelace,5\n"
    assert separate(("points.csv",), table, person()).entries == 1
    assert separate(("points.csv",), table, person(OTHER)).entries == 0


def test_a_record_of_a_namesake_stays() -> None:
    records = json.dumps(
        [{"id": "ada1", "name": "Ada Lovelace"}, {"id": "ada", "name": "Ada Lovelace"}]
    ).encode()
    done = separate(("records.json",), records, person(OTHER))
    assert json.loads(done.rest or b"") == [{"id": "ada1", "name": "Ada Lovelace"}]


def test_a_hand_in_under_the_number_of_a_stranger_is_not_hers_and_is_named() -> None:
    target = io.BytesIO()
    with zipfile.ZipFile(target, "w") as archive:
        for number in (1001, 1002):
            archive.writestr(f"Ada Lovelace_{number}_assignsubmission_file_/week1.ipynb", b"{}")
    done = separate(("all.zip",), target.getvalue(), person())
    assert [name for name, _ in done.theirs] == ["Ada Lovelace_1001_assignsubmission_file_/week1.ipynb"]
    with zipfile.ZipFile(io.BytesIO(done.rest or b"")) as archive:
        (left,) = archive.namelist()
    assert mentions(left.encode(), person()) == 1


def test_what_a_person_wrote_of_another_is_left_as_it_is_everywhere() -> None:
    mark = json.dumps({"student": "max", "comment": "the same words as Ada Lovelace (ada)"}).encode()
    assert separate(("marks.jsonl",), mark, person()).rest == mark
    assert mentions(mark, person()) == 2
