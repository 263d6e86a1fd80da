"""A roster: students from a CSV file, and what is said of one that will not do."""

from __future__ import annotations

import pytest

from corollary.problem.diagnostic import Malformed
from corollary.problem.roster import Student, read_roster


def roster(tmp_path, content: str | bytes):
    path = tmp_path / "roster.csv"
    path.write_bytes(content if isinstance(content, bytes) else content.encode())
    return read_roster(path)


def test_as_nbgrader_has_it(tmp_path):
    found = roster(tmp_path, "id,first_name,last_name,email\nada,Ada,Lovelace,ada@example.org\nbob,,,\n")
    assert found == (Student("ada", "Ada", "Lovelace", "ada@example.org"), Student("bob"))
    assert [student.name for student in found] == ["Ada Lovelace", "bob"]


def test_as_a_spreadsheet_writes_it(tmp_path):
    content = '\ufeffemail, id ,group\r\n"a@b.org",  s1 ,3\r\n\r\n"c@d.org",s2,"two\r\nlines"\r\n'
    assert [(student.id, student.email) for student in roster(tmp_path, content)] == [
        ("s1", "a@b.org"),
        ("s2", "c@d.org"),
    ]


def test_names_of_any_script(tmp_path):
    assert roster(tmp_path, "id,first_name\ns1,Łukasz 明\n")[0].name == "Łukasz 明"


@pytest.mark.parametrize(
    ("content", "line", "words"),
    [
        ("", 1, "lists no students"),
        ("id\n", 1, "lists no students"),
        ("name\nada\n", 1, "no column `id`; its columns are name"),
        ("id;name\nada;x\n", 1, "no column `id`"),
        ("id,name\n,Ada\n", 2, "id ''"),
        ("id\n\n\nada\n../bob\n", 5, "id '../bob'"),
        ("id\n.hidden\n", 2, "id '.hidden'"),
        ("id\na/b\n", 2, "id 'a/b'"),
        ("id\nada\nbob\nada\n", 4, "id ada stands on line 2 already"),
        (b"id\n\xff\xfe\n", 1, "cannot be read"),
        (b"id\na\x00b\n", 2, "will not do"),
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
        roster(tmp_path, "id\nada\nada\n b b\n")
    assert [complaint.line for complaint in raised.value.complaints] == [3, 4]


def test_a_roster_that_is_not_there(tmp_path):
    with pytest.raises(Malformed, match=r"roster\.csv:1: cannot be read: No such file"):
        read_roster(tmp_path / "roster.csv")
