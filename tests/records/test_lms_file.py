"""Files as Moodle and Canvas export them, filled in: the right cells, nobody else's, and nothing but them."""

from __future__ import annotations

from pathlib import Path

import pytest

from corollary.problem.diagnostic import Malformed
from corollary.problem.roster import Student
from corollary.records.lms_file import FilledIn, fill_in
from corollary.records.marks_table import Column, Mark, MarksTable, Notation

ADA = Student("ada", "Ada", "Lovelace", "ada@uio.no", (("ID number", "007"),))
BEN = Student("ben", "Ben", "Bitdiddle", "ben@uio.no", (("ID number", "0100"),))
CYD = Student("cyd", "Cyd", "Müller", "cyd@uio.no")
DAG = Student("dag", "Dag", "Østby", "dag@uio.no")
WEEK = Column(
    "Week 1: impulse", ("week_1",), 5, {"ada": Mark(4.5, 5), "ben": Mark(0, 5)}, excused=frozenset({"dag"})
)


def filled(path: Path, content: str, *headings: str, encoding: str = "utf-8", **notation: object) -> FilledIn:
    path.write_bytes(content.encode(encoding))
    table = MarksTable((ADA, BEN, CYD, DAG), (WEEK,), Notation(**notation))  # type: ignore[arg-type]
    return fill_in(path, table, headings)


MOODLE = (
    '"First name","Last name","ID number",Institution,Department,"Email address","Assignment: Week 1: impulse (Real)",'
    '"Assignment: Week 1: impulse (Percentage)","Course total (Real)","Last downloaded from this course"\n'
    'Ada,Lovelace,007,,,ada@uio.no,-,-,-,1796000000\n'
    'Ben,Bitdiddle,0100,,,ben@uio.no,3.00,"60.00 %",3.00,1796000000\n'
    'Cyd,Müller,,,,cyd@uio.no,-,-,-,1796000000\n'
    'Dag,Østby,,,,dag@uio.no,2.50,-,-,1796000000\n'
    'Guest,Lecturer,,,,guest@uio.no,-,-,-,1796000000\n'
)  # fmt: skip


def test_moodles_gradebook(tmp_path: Path) -> None:
    """A mark, a zero, nothing (as it stood), an excuse (blank), and somebody who is no student here."""
    made = filled(tmp_path / "moodle.csv", MOODLE)
    expected = (
        MOODLE.replace("ada@uio.no,-", "ada@uio.no,4.5")
        .replace("ben@uio.no,3.00", "ben@uio.no,0")
        .replace("dag@uio.no,2.50", "dag@uio.no,")
    )
    assert made.content.decode() == expected
    assert (made.strangers, made.absent, made.notes) == (("Guest Lecturer",), (), ())


WORKSHEET = (
    '\ufeffIdentifier,"Full name","Email address",Status,Grade,"Maximum Grade","Grade can be changed",'
    '"Last modified (submission)","Last modified (grade)","Feedback comments"\r\n'
    '"Participant 4711","Ada Lovelace",ada@uio.no,"Submitted for grading",,100.00,Yes,"Friday, 4 December 2026, 11:00 PM",-,\r\n'
    '"Participant 4712","Ben Bitdiddle",ben@uio.no,"No submission",,100.00,Yes,-,-,"<p>Well, ""done""</p>"\r\n'
)  # fmt: skip


def test_moodles_grading_worksheet_and_what_its_marks_are_out_of(tmp_path: Path) -> None:
    made = filled(tmp_path / "worksheet.csv", WORKSHEET)
    assert made.content.decode() == WORKSHEET.replace('grading",,', 'grading",4.5,').replace(
        'submission",,', 'submission",0,'
    )
    assert made.absent == ("cyd", "dag")
    assert made.notes == ("Grade is out of 100 in the file and out of 5 here; --out-of 100 scales the marks",)
    scaled = filled(tmp_path / "worksheet.csv", WORKSHEET, out_of=100, decimals=0)
    assert ('grading",90,' in scaled.content.decode(), scaled.notes) == (True, ())


def test_an_excused_students_mark_that_moodles_worksheet_would_keep_is_said(tmp_path: Path) -> None:
    """Moodle 4.1 and 4.5 leave a mark alone whose cell is blank in the worksheet, and nowhere else."""
    excused = '"Participant 4714","Dag Østby",dag@uio.no,"No submission",{},100.00,Yes,-,"Friday, 4 December 2026",\r\n'
    made = filled(tmp_path / "worksheet.csv", WORKSHEET + excused.format("30.00"), out_of=100)
    assert made.content.decode().endswith(excused.format(""))
    (note,) = made.notes
    assert note.startswith("excused, with a mark in the worksheet: the cell is blank now")
    assert note.endswith("take it away there: Participant 4714 Dag Østby")
    assert filled(tmp_path / "worksheet.csv", WORKSHEET + excused.format(""), out_of=100).notes == ()


CANVAS = (
    "Student,ID,SIS User ID,SIS Login ID,Section,Week 1: impulse (4411),Essay (4412),Current Score,Final Score\n"
    ",,,,,Manual Posting,,,\n"
    "    Points Possible,,,,,5.0,10.0,(read only),(read only)\n"
    '"Lovelace, Ada",2001,,ada,Physics,,8.0,80,80\n'
    '"Bitdiddle, Ben",2002,,ben,Physics,1.00,N/A,,\n'
    '"Müller, Cyd",2003,,cyd,Physics,2.00,,,\n'
    '"Østby, Dag",2004,,dag,Physics,EX,,,\n'
    '"Student, Test",2099,,4f3c,Physics,,,,\n'
)  # fmt: skip


def test_canvas_keeps_its_second_row_its_excuse_and_a_mark_that_is_not_ours(tmp_path: Path) -> None:
    made = filled(tmp_path / "canvas.csv", CANVAS)
    assert made.content.decode() == CANVAS.replace("ada,Physics,", "ada,Physics,4.5").replace(
        "ben,Physics,1.00", "ben,Physics,0"
    )
    assert (made.strangers, made.absent) == ((), ())
    assert made.notes == (
        "Week 1: impulse (4411): the file has a mark and the course has none, so it is unchanged: Cyd Müller",
    )


def test_semicolons_cp1252_and_decimal_commas_stay(tmp_path: Path) -> None:
    german = (
        "Vollständiger Name;E-Mail-Adresse;Bewertung;Beste Bewertung\r\nAda Lovelace;ada@uio.no;;5,00\r\n"
    )
    made = filled(tmp_path / "bewertung.csv", german, encoding="cp1252")
    assert made.content.decode("cp1252") == german.replace("no;;", "no;4,5;")


def test_an_id_with_a_comma_is_no_decimal_comma(tmp_path: Path) -> None:
    """Moodle 4.1 and 4.5 refuse a file with `4,5` where their language writes points."""
    assert ",4.5," in filled(tmp_path / "points.csv", MOODLE.replace(",0100,", ',"12,5",')).content.decode()
    with_commas = MOODLE.replace("3.00", '"3,00"').replace("2.50", '"2,50"')
    assert ',"4,5",' in filled(tmp_path / "commas.csv", with_commas).content.decode()
    blank = MOODLE.replace("ben@uio.no,3.00", "ben@uio.no,-").replace("2.50", "-").replace("3.00", '"3,00"')
    assert ',"4,5",' in filled(tmp_path / "another.csv", blank).content.decode()


def test_a_name_is_enough_where_one_has_it_and_is_said(tmp_path: Path) -> None:
    """No id of the file is on the roster; two of the name would be nobody."""
    text = "Name,Login,Points\nLovelace  ada,al17,\nBITDIDDLE, bb3,\nBen Bitdiddle,bb3,\n"
    made = filled(tmp_path / "named.csv", text, "points")
    assert made.content.decode() == text.replace("al17,", "al17,4.5").replace(
        "Ben Bitdiddle,bb3,", "Ben Bitdiddle,bb3,0"
    )
    assert made.notes == (
        "matched by name alone, since no id is known: Lovelace  ada al17, Ben Bitdiddle bb3",
    )
    assert made.strangers == ("BITDIDDLE bb3",)


def test_ids_that_contradict_each_other_get_nothing(tmp_path: Path) -> None:
    text = "ID number,Email address,Points\n007,ben@uio.no,\n0100,ben@uio.no,\n"
    made = filled(tmp_path / "mixed.csv", text, "3")
    assert made.content.decode() == text.replace("0100,ben@uio.no,", "0100,ben@uio.no,0")
    assert made.notes == ("the ids name different students, so nothing is written for: 007 ben@uio.no",)


REFUSED = [
    ("", (), "is empty"),
    (
        "id,Points\nada,\n",
        (),
        "has no column for Week 1: impulse; its columns are id, Points; say which with --column",
    ),
    ("id,week_1,Week 1: impulse (Real)\nada,,\n", (), "has several columns for Week 1: impulse"),
    ("id,Points\nada,\n", ("Marks",), "has no column Marks; its columns are id, Points"),
    ("id,Points\nada,\n", ("3",), "has no column 3"),
    ("id,Points\nada,\n", ("Points", "Points"), "is to get Week 1: impulse: name a column for each"),
    ("id,week_1\nzoe,\n", (), "names no student of the course"),
    ("id,x,week_1\nada\n", (), "the row of Ada Lovelace has too few cells"),
]


@pytest.mark.parametrize(("text", "headings", "sentence"), REFUSED)
def test_what_cannot_be_filled_in_is_refused(
    text: str, headings: tuple[str, ...], sentence: str, tmp_path: Path
) -> None:
    with pytest.raises(Malformed) as refusal:
        filled(tmp_path / "marks.csv", text, *headings)
    assert f"marks.csv:1: {sentence}" in str(refusal.value)
