"""What can be exported to: exercises and sheets in our formats, marks as a table, and a target of another package's."""

from __future__ import annotations

import base64
import csv
import io
import re
import runpy
from pathlib import Path

import pytest

from corollary.notebook.worksheet import Worksheet, exercise, worksheet
from corollary.plug_ins import PlugInFault
from corollary.problem.csv_table import table_text
from corollary.problem.roster import Student
from corollary.problem.variant import at, chapter
from corollary.records.marks_table import Column, Mark, MarksTable, every_column
from corollary.render.exports import (
    FOR_EXERCISES,
    OURS,
    Target,
    UnknownTarget,
    names,
    names_for_exercises,
    target,
)

SAMPLE = runpy.run_path(str(Path(__file__).parents[1] / "sample.py"))


ADA = Student("ada", "Ada", "Lovelace")


def written(name: str, asked, solution: str = "") -> str:
    write = target(name).exercise
    assert write is not None
    made = write(asked, ADA, solution)
    assert isinstance(made, str)
    return made


@pytest.fixture
def sheet(tmp_path) -> Worksheet:
    of = SAMPLE["problem_set"](tmp_path)
    return worksheet(of, ADA, [at(of.problems[0], 7), at(of.problems[1], 3)])


@pytest.fixture
def kick(tmp_path):
    return exercise(chapter(SAMPLE["problem_set"](tmp_path).problems[0]))


def test_text_reads_well_on_a_terminal(kick):
    text = written("text", kick, "Because $p = mv$.")
    assert text.startswith(
        "X12.5  Kicking a ball\n\nA ball of mass 0.43 kg lies still until you kick it; it leaves at v = 20.0"
    )
    assert "[Figure: A ball of mass 0.43 kg [at rest].]" in text
    assert "(a) Momentum  [1 point, in kg m/s]\nBy how much does it change, Δp?" in text
    assert "- (A) the momentum, ∑p" in text.replace("∑ p", "∑p")
    assert text.endswith("Worked solution\n\nBecause p = m v.\n")
    assert "$" not in text
    assert "Worked solution" not in written("text", kick)


def test_markdown_keeps_formulas_and_brings_the_figure(kick):
    text = written("md", kick)
    assert "$\\Delta p$" in text
    assert r"![A ball of mass 0.43" in text
    assert r"\[at rest\].][figure]" in text
    drawn = base64.b64decode(re.search(r"\[figure\]: data:image/svg\+xml;base64,(\S+)", text)[1]).decode()  # type: ignore[index]
    assert drawn.startswith('<svg xmlns="http://www.w3.org/2000/svg"')
    assert "m = 0.43" in drawn
    assert "script" not in drawn


@pytest.mark.parametrize("name", ["text", "md", "html", "ipynb"])
def test_a_sheet_has_its_owner_and_all_its_exercises(sheet: Worksheet, name: str):
    write = target(name).worksheet
    assert write is not None
    text = write(sheet, {"X12.5": "Because it moves."})
    for words in ("Ada Lovelace", "Kicking a ball", "A ball on the floor", "Which impulse acts?", "0.30"):
        assert words in text
    assert "run()" not in text
    assert ("Because it moves." in text) is (name != "ipynb"), (
        "what is handed out to be answered shows no solution"
    )


def test_the_figures_of_a_sheet_do_not_share_their_names(tmp_path):
    of = SAMPLE["problem_set"](tmp_path)
    write = target("md").worksheet
    assert write is not None
    kick = of.problems[0]
    twice = Worksheet(of, ADA, (exercise(at(kick, 1)), exercise(at(kick, 1))))
    assert write(twice, {}).count("[figure X12.5]: data:") == 2
    assert "\n[figure]: " not in write(twice, {})


def marks(name: str, table: MarksTable) -> list[str]:
    write = target(name).marks
    assert write is not None
    made = write(table)
    return (made if isinstance(made, str) else made.text).splitlines()


def notes(name: str, table: MarksTable) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Who is left out of the file, and what is said of it."""
    write = target(name).marks
    assert write is not None
    made = write(table)
    assert not isinstance(made, str)
    return made.absent, made.notes


def test_marks_are_blank_where_there_are_none(tmp_path):
    of = SAMPLE["problem_set"](tmp_path)
    report = SAMPLE["summary"]([SAMPLE["marked"](of), SAMPLE["late"](SAMPLE["marked"](of, "eve"))])
    roster = (ADA, Student("bo", "Bo, jr."), Student("eve"))
    assert marks("csv", MarksTable(roster, tuple(every_column(of, report, roster)))) == [
        "id,first_name,last_name,email,X12.5 a,X12.5 b,X12.5 c,X12.5 c_2,X12.5 e,P12.14 a,P12.14 b,total,out_of",
        "ada,Ada,Lovelace,,1,1,0.5,0,,2,0,4.5,12",
        'bo,"Bo, jr.",,,,,,,,,,,12',
        "eve,,,,1,1,0.5,0,,2,0,2.25,12",
    ]


HARMLESS = ["-", "-1", "+1,5", "a=b", "7", "Ada"]
FORMULAS = ["=1+1", "@SUM(A1)", "+A1", "-A1", "\t=1", " =1", '=HYPERLINK("x")', "-1+1"]


def test_no_name_is_a_formula_for_a_spreadsheet():
    cells = list(csv.reader(io.StringIO(table_text([HARMLESS, FORMULAS]))))
    assert cells == [HARMLESS, [f"'{cell}" for cell in FORMULAS]]


def _of(*students: Student) -> MarksTable:
    return MarksTable(students, (Column("Week 1", (), 5, {"ada": Mark(4.5, 5)}),))


def test_moodle_gets_no_column_of_ids_that_somebody_is_without():
    """For one row whose id is blank Moodle takes nothing of the file."""
    full = Student("ada", "Ada", "Lovelace", "ada@uio.no", (("Username", "ada"), ("ID number", "007")))
    part = Student("bo", "Bo", "Ek", "", (("Username", "bo"),))
    assert marks("moodle-grades", _of(full)) == [
        "First name,Last name,Username,ID number,Email address,Week 1",
        "Ada,Lovelace,ada,007,ada@uio.no,4.5",
    ]
    assert marks("moodle-grades", _of(full, part)) == [
        "First name,Last name,Username,Week 1",
        "Ada,Lovelace,ada,4.5",
        "Bo,Ek,bo,",
    ]
    by_mail = Student("ada@uio.no", "Ada", "L", "ada@uio.no", (("Email address", "ada@uio.no"),))
    assert marks("moodle-grades", _of(by_mail))[0] == "First name,Last name,Email address,Week 1"
    assert marks("moodle-grades", _of(Student("bo", ids=(("column 1", "bo"),)))) == [
        "First name,Last name,id,Week 1",
        ",,bo,",
    ]


NUMBERED = Student(
    "007", "Ada", "Lovelace", "ada@uio.no", (("ID number", "007"), ("Email address", "ada@uio.no"))
)
NEWCOMER = Student("ek-1f2e3d4c", "Bo", "Ek", "", (("id", "Ek, Bø"),))


def test_a_newcomer_without_a_number_turns_nobodys_id_into_a_folder_name():
    by_mail = Student("ek-1f2e3d4c", "Bo", "Ek", "bo@uio.no", (("id", "Ek, Bø"),))
    table = _of(NUMBERED, by_mail)
    assert marks("moodle-grades", table) == [
        "First name,Last name,Email address,Week 1",
        "Ada,Lovelace,ada@uio.no,",
        "Bo,Ek,bo@uio.no,",
    ]
    assert notes("moodle-grades", table) == (
        (),
        (
            'each row has Email address; choose it under "Map from" in Moodle',
            "ID number is left out, since these students have none or share one: ek-1f2e3d4c",
        ),
    )


def test_where_no_id_is_everybodys_most_are_in_the_file_and_the_others_are_named():
    """A row without an id would make Moodle refuse the file, or give its marks to the student above."""
    table = _of(NUMBERED, NEWCOMER, Student("008", "Cy", "C", "", (("Matrikelnummer", "008"),)))
    assert marks("moodle-grades", table) == [
        "First name,Last name,ID number,Week 1",
        "Ada,Lovelace,007,",
        "Cy,C,008,",
    ]
    absent, (of_all, of_absent) = notes("moodle-grades", table)
    assert absent == ("ek-1f2e3d4c",)
    assert of_all.startswith("each row has ID number; choose it")
    assert of_absent == "no id column covers every student; without ID number on the roster: ek-1f2e3d4c"


def test_an_id_as_the_roster_had_it_and_never_the_folders_name():
    assert marks("moodle-grades", _of(NEWCOMER)) == ["First name,Last name,id,Week 1", 'Bo,Ek,"Ek, Bø",']
    canvas = Student("s-1", "Ada", "L", ids=(("ID", "2001"), ("SIS User ID", "S/1")))
    assert marks("moodle-grades", _of(canvas)) == ["First name,Last name,SIS User ID,Week 1", "Ada,L,S/1,"]


@pytest.mark.parametrize("value", ["0", "007"])
def test_an_id_that_moodle_takes_for_none_or_for_anothers_is_none(value):
    twin = Student("bo", "Bo", "Ek", "bo@uio.no", (("ID number", value),))
    assert marks("moodle-grades", _of(NUMBERED, twin))[0] == "First name,Last name,Email address,Week 1"


def test_canvas_gets_its_own_numbers_where_the_roster_has_them():
    ids = (("ID", "2001"), ("SIS User ID", "S-1"), ("SIS Login ID", "ada"))
    assert marks("canvas-grades", _of(Student("ada", "Ada", "Lovelace", ids=ids), Student("bo"))) == [
        "Student,ID,SIS User ID,SIS Login ID,Section,Week 1",
        "    Points Possible,,,,,5",
        '"Lovelace, Ada",2001,S-1,ada,,4.5',
        "bo,,,,,",
    ]


def test_canvas_is_told_no_id_that_it_never_gave():
    """It finds by the name whoever has none; of namesakes it takes the first."""
    ada = Student("lovelace-7", "Ada", "Lovelace", "ada@uio.no", (("Username", "adal"), ("ID", "9")))
    table = _of(ada, Student("k1", "Kim", "Lee"), Student("k2", "Kim", "Lee"))
    assert marks("canvas-grades", table)[2:] == ['"Lovelace, Ada",,,,,']
    absent, said = notes("canvas-grades", table)
    assert absent == ("k1", "k2")
    assert said[0].startswith(
        "no id of Canvas's is on the roster, so students are matched by name alone: Ada Lovelace; safer: --template"
    )
    assert "cannot tell students of the same name apart" in said[1]
    login = (("SIS Login ID", "kim2"),)
    known = _of(
        Student("k1", "Kim", "Lee", ids=(("ID", "31"), ("SIS Login ID", "kim1"))),
        Student("k2", "Kim", "Lee", ids=login),
    )
    assert marks("canvas-grades", known)[2:] == ['"Lee, Kim",31,,kim1,,', '"Lee, Kim",,,kim2,,']
    assert notes("canvas-grades", known) == ((), ())


def test_a_title_by_which_canvas_overlooks_a_column_is_said():
    title = "Week 1, Final Score"
    table = MarksTable((ADA,), (Column(title, (), 5, {}),))
    assert any(title in each for each in notes("canvas-grades", table)[1])


def test_what_is_unknown_is_answered_with_what_there_is():
    assert names_for_exercises() == ("text", "md", "html", "ipynb", "pdf")
    with pytest.raises(
        UnknownTarget, match="docx is not known; choose one of text, md, html, ipynb, pdf, csv"
    ):
        target("docx")


THEIRS = """
from corollary.render.exports import Target

def write(problem_set, sheets):
    return {"all.txt": " ".join(sheet.student.id for sheet in sheets).encode()}

ROLL = Target(ending="txt", problem_set=write)
NOTHING = "no target"
"""


def test_another_package_brings_a_target_by_an_entry_point(installed, sheet):
    points = ["roll = rollcall:ROLL", "broken = rollcall:NOTHING", "gone = rollcall:MISSING"]
    installed("rollcall", {"corollary.exports": points}, {"rollcall.py": THEIRS})
    assert names() == (
        "text",
        "md",
        "html",
        "ipynb",
        "pdf",
        "csv",
        "moodle-grades",
        "canvas-grades",
        "feedback-zip",
        "moodle",
        "moodle-stack",
        "qti",
        "canvas",
        "numbas",
        "site",
        "broken",
        "gone",
        "roll",
    )
    roll = target("roll")
    assert isinstance(roll, Target)
    assert roll.problem_set is not None
    assert roll.problem_set(sheet.problem_set, [sheet]) == {"all.txt": b"ada"}
    with pytest.raises(
        PlugInFault, match=r"the export broken of rollcall .* it is not a corollary.render.exports.Target"
    ):
        target("broken")
    with pytest.raises(PlugInFault, match="the export gone of rollcall cannot be used: rollcall:MISSING"):
        target("gone")
    assert names_for_exercises() == ("text", "md", "html", "ipynb", "pdf")


def test_what_an_exercise_can_be_shown_as_is_what_the_targets_say() -> None:
    assert tuple(name for name in OURS if target(name).exercise is not None) == FOR_EXERCISES


@pytest.mark.parametrize(
    ("word", "meant"), [("cvs", "csv or canvas"), ("moodel-grades", "moodle-grades"), ("htlm", "html")]
)
def test_a_target_that_is_nearly_right_is_guessed(word: str, meant: str) -> None:
    with pytest.raises(UnknownTarget, match=rf"{word} is not known \(did you mean {meant}\?\)"):
        target(word)
