"""A roster: students from a CSV file as it comes, and what is said of one that will not do."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from corollary.problem.diagnostic import Malformed
from corollary.problem.roster import ID, Roster, Student, folder_name, ids_heading, read_roster

# As these programs write them: headings, order and quoting of Moodle's participants and grades, and of Canvas's gradebook.
MOODLE = '\ufeff"First name","Last name","Email address",Groups\r\nAda,Lovelace,ada@example.org,"A, B"\r\nBen,Bó,ben@example.org,\r\n'
MOODLE_GRADES = (
    '"First name","Last name","ID number",Institution,Department,"Email address","Assignment: Week 1 (Real)","Last downloaded from this course"\n'
    "Ada,Lovelace,100201,,,ada@example.org,-,1790000000\nBen,Bool,100202,,,ben@example.org,7.50,1790000000\n"
)
CANVAS = (
    "Student,ID,SIS User ID,SIS Login ID,Section,Week 1 (4711),Current Score\r\n"
    ",,,,,Manual Posting,\r\n"
    "    Points Possible,,,,,10.00,(read only)\r\n"
    '"Lovelace, Ada",2001,S-17,ada,Mechanics 1,,\r\n'
    '"Bool, Ben",2002,S-18,ben,Mechanics 1,7.5,75\r\n'
    '"Student, Test",2099,,,Mechanics 1,,\r\n'
)


def roster(tmp_path, content: str | bytes, id_column: str = "", known: tuple[str, ...] = ()) -> Roster:
    path = tmp_path / "roster.csv"
    path.write_bytes(content if isinstance(content, bytes) else content.encode())
    return read_roster(path, id_column, known)


def ids(tmp_path, content: str | bytes, id_column: str = "", known: tuple[str, ...] = ()) -> list[str]:
    return [each.id for each in roster(tmp_path, content, id_column, known).students]


def test_as_nbgrader_has_it(tmp_path):
    found = roster(tmp_path, "id,first_name,last_name,email\nada,Ada,Lovelace,ada@example.org\nbob,,,\n")
    assert found.students == (Student("ada", "Ada", "Lovelace", "ada@example.org"), Student("bob"))
    assert [student.name for student in found.students] == ["Ada Lovelace", "bob"]
    assert found.notes == ()


def test_as_a_spreadsheet_writes_it(tmp_path):
    content = '\ufeffemail, id ,group\r\n"a@b.org",  s1 ,3\r\n\r\n"c@d.org",s2,"two\r\nlines"\r\n'
    assert [(student.id, student.email) for student in roster(tmp_path, content).students] == [
        ("s1", "a@b.org"),
        ("s2", "c@d.org"),
    ]


def test_names_of_any_script(tmp_path):
    assert roster(tmp_path, "id,first_name\ns1,Łukasz 明\n").students[0].name == "Łukasz 明"


@pytest.mark.parametrize("delimiter", [",", ";", "\t", "|"])
@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "cp1252", "utf-16", "utf-16-le", "utf-16-be"])
def test_any_usual_delimiter_and_encoding(tmp_path, delimiter, encoding):
    lines = [("ID number", "Surname", "First name"), ("17", "Müller, Dr.", "Jürgen"), ("18", "Øst", "Åse")]
    quoted = "\r\n".join(delimiter.join(f'"{cell}"' for cell in line) for line in lines)
    found = roster(tmp_path, quoted.encode(encoding))
    assert found.students == (Student("17", "Jürgen", "Müller, Dr."), Student("18", "Åse", "Øst"))
    assert any("Windows-1252" in note for note in found.notes) == (encoding == "cp1252")


def test_the_line_by_which_excel_tells_the_delimiter(tmp_path):
    assert ids(tmp_path, "sep=;\r\nid;name\r\nada;x\r\n") == ["ada"]


@pytest.mark.parametrize("heading", ["ID", "ID number", "Username", "Student ID", "Matrikelnummer", "Login"])
def test_ids_under_the_names_they_go_by(tmp_path, heading):
    assert ids(tmp_path, f"{heading};Email address\n12;a@b.org\n13;c@d.org\n") == ["12", "13"]


def test_moodles_participants(tmp_path):
    found = roster(tmp_path, MOODLE)
    assert found.students[1] == Student("ben@example.org", "Ben", "Bó", "ben@example.org")
    assert found.notes == ("ids are those of Email address",)


def test_moodles_grades(tmp_path):
    found = roster(tmp_path, MOODLE_GRADES)
    assert [each.id for each in found.students] == ["100201", "100202"]
    assert found.notes == ("ids are those of ID number; --id-column takes others (Email address)",)


def test_a_column_that_is_blank_for_somebody_is_not_taken_for_ids(tmp_path):
    assert ids(tmp_path, MOODLE_GRADES.replace("100202", "")) == ["ada@example.org", "ben@example.org"]


def test_canvas_gradebook_without_its_rows_that_are_no_people(tmp_path):
    found = roster(tmp_path, CANVAS)
    assert found.students == (Student("ada", "Ada", "Lovelace"), Student("ben", "Ben", "Bool"))
    assert dict(found.students[0].ids) == {"SIS Login ID": "ada", "SIS User ID": "S-17", "ID": "2001"}
    assert ids(tmp_path, CANVAS, "SIS User ID") == ["S-17", "S-18"]
    assert ids(tmp_path, CANVAS, "2") == ["2001", "2002"]


def test_canvas_gradebook_with_last_and_first_names_apart(tmp_path):
    """As an account can have it; its invented student is then called so by two cells."""
    apart = CANVAS.replace("Student,ID", "LastName,FirstName,ID").replace(",,,,,", ",,,,,,", 2)
    apart = re.sub(r'"(\w+), (\w+)"', r"\1,\2", apart)
    assert roster(tmp_path, apart).students == roster(tmp_path, CANVAS).students


def test_the_column_by_which_the_course_knows_its_students_is_taken_again(tmp_path):
    assert ids(tmp_path, MOODLE_GRADES, known=("ada@example.org",)) == ["ada@example.org", "ben@example.org"]


@pytest.mark.parametrize(
    ("content", "students"),
    [
        ("ada\nben\n", (Student("ada"), Student("ben"))),
        ("ada,Ada,Lovelace,a@b.org\nben,Ben,Bool,b@b.org\n", (Student("ada", "Ada", "Lovelace", "a@b.org"), Student("ben", "Ben", "Bool", "b@b.org"))),
        ('"Lovelace, Ada";17\n"Bool, Ben";18\n', (Student("17", "Ada", "Lovelace"), Student("18", "Ben", "Bool"))),
    ],
)  # fmt: skip
def test_without_headings_what_is_taken_for_what_is_said(tmp_path, content, students):
    found = roster(tmp_path, content)
    assert found.students == students
    assert "has no line with names of columns; taken to hold ids in column" in found.notes[0]


def test_ids_that_cannot_name_a_folder_get_names_that_can(tmp_path):
    given = ["Łukasz", "明", "21/104", "a b", "Ñ", "N", "ada"]
    found = roster(tmp_path, "id\n" + "\n".join(given))
    names = [each.id for each in found.students]
    assert all(ID.match(name) for name in names)
    assert len({name.lower() for name in names}) == len(given)
    assert names[-1] == "ada"
    assert [dict(each.ids)["id"] for each in found.students] == given
    assert "Łukasz is Lukasz-" in found.notes[-1]
    assert (
        folder_name("明") == "student-73b972d7"
    )  # of `printf 明 | sha256sum`: the same everywhere, for ever
    assert folder_name("Jürgen") == folder_name("Ju\u0308rgen")


def test_names_that_windows_keeps_to_itself_are_nobodys_folder(tmp_path):
    given = ["con", "NUL", "aux.2", "Com1", "ada.", "console", "com10", "b.con"]
    found = [each.id for each in roster(tmp_path, "id\n" + "\n".join(given)).students]
    assert found[-3:] == given[-3:]
    for mapped, each in zip(found[:5], given[:5], strict=True):
        assert mapped != each
        assert mapped.partition("-")[0].lower() not in mapped.lower().split(".")
        assert not mapped.endswith(".")
    again = read_roster(tmp_path / "roster.csv", known=["con"])
    assert again.students[0].id == "con"


@pytest.mark.parametrize(
    ("content", "line", "words"),
    [
        ("", 1, "lists no students"),
        ("id\n", 1, "lists no students"),
        ("name\nada\n", 1, "no column `id`; its columns are name; say which holds the ids with --id-column"),
        ("Nummer,Wer\n12,Ada\n13,Ben\n", 1, "no column `id`; its columns are Nummer, Wer"),
        ("id,name\n,Ada\n", 2, "id ''"),
        ("id\n\n\nada\n../bob\n", 5, "id '../bob' cannot name a folder"),
        ("id\n.hidden\n", 2, "id '.hidden'"),
        ("id\nada\nbob\nada\n", 4, "id ada stands on line 2 already"),
        ("id\nada\nAda\n", 3, "id Ada and ada on line 2 are one folder on many disks"),
        ("id\n1.23457E+11\n", 2, "was rounded by a spreadsheet"),
        ("id\na\u200bb\n", 2, "an invisible character"),
        ("id,last_name\nada,Lovelace, Ada\n", 2, "has 3 cells, and there are 2 columns"),
        (b"id\na\x00b\n", 2, "zero byte"),
        ('id\n"ada\nben\n', 2, "a quotation mark is out of place"),
        (b"PK\x03\x04rest", 1, "is an Excel or LibreOffice workbook; save it as CSV"),
        (b"id\n\x81\x8d\n", 1, "an unknown encoding"),
        ("<html><body>Please log in</body></html>", 1, "is a web page; give the CSV file itself"),
        ('[{"id": "ada"}]', 1, "is JSON"),
        ("Course: Mechanics\nExported today\n\nID,Name\n1,Ada\n", 4, "delete the lines above"),
    ],
)
def test_a_roster_that_will_not_do(tmp_path, content, line, words):
    with pytest.raises(Malformed) as raised:
        roster(tmp_path, content)
    (complaint,) = raised.value.complaints
    assert words in complaint.sentence
    assert complaint.line == line


def test_every_bad_row_is_named(tmp_path):
    with pytest.raises(Malformed) as raised:
        roster(tmp_path, "id,x\nada\nada\n,b\n")
    assert [complaint.line for complaint in raised.value.complaints] == [3, 4]


def test_a_column_that_is_not_there(tmp_path):
    with pytest.raises(Malformed, match=r"roster\.csv:1: has no column Kennung; its columns are id, name"):
        roster(tmp_path, "id,name\nada,x\n", "Kennung")


def test_a_roster_that_is_not_there(tmp_path):
    with pytest.raises(Malformed, match=r"roster\.csv:1: cannot be read: No such file"):
        read_roster(tmp_path / "roster.csv")


def test_a_folder_in_the_place_of_a_roster(tmp_path: Path) -> None:
    with pytest.raises(Malformed, match="is a folder; name the CSV file itself"):
        read_roster(tmp_path)


def test_newcomers_have_ids_of_the_column_that_the_course_goes_by(tmp_path):
    """A student who left and comes back alone is nobody that the course knows, and must be the same student."""
    before = roster(tmp_path, "ID number,Email address\n7,ada@uio.no\n,ben@uio.no\n").students
    assert [each.id for each in before] == ["ada@uio.no", "ben@uio.no"]
    path = tmp_path / "newcomers.csv"
    path.write_text("ID number;email address\n9;cyd@uio.no\n")
    known = {each.id for each in before}
    assert [each.id for each in read_roster(path, "", known, ids_heading(before)).students] == ["cyd@uio.no"]
    path.write_text("ID number;Email address\n9;\n")  # where it says nothing of somebody, another is taken
    assert [each.id for each in read_roster(path, "", known, ids_heading(before)).students] == ["9"]
    assert ids_heading([]) == ids_heading([Student("ada")]) == ""
