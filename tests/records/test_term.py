"""A term by `corollary term`: totals reckoned by hand, who is missing, and misconceptions from set to set."""

from __future__ import annotations

import csv
import itertools
import json
import shutil
import stat
from pathlib import Path

import pytest

from corollary.cli.main import main
from corollary.practice.practice import practice
from corollary.problem.bank import Bank, chapter_bank, find
from corollary.problem.problem_set import find_set
from corollary.problem.roster import read_roster
from corollary.problem.variant import chapter
from corollary.records.assignments import numbers_of, open_record, save_record
from corollary.records.deadlines import Extension, write_extension
from corollary.records.files import create_course
from corollary.records.marks import HandedIn, NewMarks, PartRecord, Record, Row, write_marks
from corollary.records.origin import write_origin
from corollary.records.term_totals import best_mean

ROSTER = """\
id,first_name,last_name,email,section,group
ada,Ada,Lund,ada@example.org,A,1
ben,Ben,Okafor,ben@example.org,B,"1, 2"
cyd,Cyd,Li,cyd@example.org,A,2
dee,Dee,Weiss,dee@example.org,B,
"""
TENNIS, METEOR, DROP = "hitting_a_tennis_ball", "meteor_impact", "absorbing_a_drop"
SETS = {
    "week1": (TENNIS, "2020-01-10"),
    "week2": ("kicking_a_ball", "2020-01-20"),
    "week3": (METEOR, "2020-01-30"),
    "week4": ("golf_ball", "2999-01-01"),
}
ARRIVING = "arriving momentum left out"
LEFT_OUT = {
    TENNIS: "You left out the momentum with which the ball arrives; the racket must first stop it.",
    METEOR: "You left out the momentum of the planet, which moves as well before the impact.",
}
OTHER = "an old sentence that no solution has any more"
# Of the first part: its verdict, points out of 4, and the mistake.
MARKS = {
    ("ada", "week1"): ("mistaken", 2.0, LEFT_OUT[TENNIS]),
    ("ada", "week2"): ("right", 4.0, ""),
    ("ada", "week3"): ("mistaken", 1.0, LEFT_OUT[METEOR]),
    ("ben", "week1"): ("mistaken", 2.0, LEFT_OUT[TENNIS]),
    ("ben", "week2"): ("mistaken", 0.0, OTHER),
    ("ben", "week3"): ("right", 4.0, ""),
    ("cyd", "week1"): ("unmarked", 0.0, ""),
    ("cyd", "week2"): ("right", 4.0, ""),
}


@pytest.fixture
def bank(tmp_path: Path) -> Bank:
    """The problems of the sets, and one more that can show the same misconception."""
    for step in ("problems", "solutions"):
        for place in (chapter_bank().folder / step).glob("*/*.md"):
            if place.stem in {*(problem for problem, _ in SETS.values()), DROP}:
                (tmp_path / "bank" / step / place.parent.name).mkdir(parents=True, exist_ok=True)
                shutil.copy(place, tmp_path / "bank" / step / place.parent.name)
    return Bank(tmp_path / "bank")


@pytest.fixture
def course(bank: Bank, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Four sets of one problem each; dee handed in nothing and is excused from the second."""
    (tmp_path / "roster.csv").write_text(ROSTER)
    made = create_course(tmp_path / "course", read_roster(tmp_path / "roster.csv").students)
    for name, (problem, due) in SETS.items():
        file = tmp_path / f"{name}.md"
        file.write_text(f"---\ntitle: Title of {name}\ndue: {due}\nproblems: [{problem}]\n---\nGo.\n")
        problem_set = find_set(bank, str(file))
        record, asked = open_record(made, problem_set), find(bank, problem)
        for student in ("ada", "ben", "cyd", "dee"):
            record.students[student] = {asked.code: numbers_of(chapter(asked), record.place(asked, 1.0))}
        save_record(made, problem_set, record)
        write_origin(made, name, bank, file)
        part = asked.parts[0].id
        for (student, where), (verdict, points, error) in MARKS.items():
            if where == name:
                row = Row(student, asked.code, part, verdict, points, 4.0, error)
                whole = HandedIn(student, student, points, 4.0)
                parts = {asked.answer_name(asked.parts[0]): PartRecord(verdict, points, 4.0)}
                kept = Record(points, 4.0, parts, "", whole, (row,))
                write_marks(made, problem_set, [NewMarks(student, kept, b"{}", "<p>")])
    write_extension(made, "week2", "dee", Extension(excused=True))
    (made.folder / "corollary.toml").write_text('timezone = "UTC"\n')
    monkeypatch.chdir(made.folder)
    return made.folder


def run(monkeypatch: pytest.MonkeyPatch, *words: str) -> int:
    monkeypatch.setattr("sys.argv", ["corollary", "term", *words])
    with pytest.raises(SystemExit) as end:
        main()
    return int(end.value.code or 0)


def rows_of(name: str) -> list[dict[str, str]]:
    return list(csv.DictReader(Path(name).read_text().splitlines()))


def test_totals_count_what_is_missing_and_wait_for_what_a_person_must_mark(course, monkeypatch, capsys):
    assert run(monkeypatch, "--json") == 0
    people = json.loads(capsys.readouterr().out)["students"]
    assert people["ada"]["total"] == pytest.approx((0.5 + 1 + 0.25) / 3)
    assert people["ben"]["total"] == pytest.approx((0.5 + 0 + 1) / 3)
    assert people["cyd"]["total"] is None
    assert (people["cyd"]["low"], people["cyd"]["high"]) == pytest.approx((1 / 3, 2 / 3))
    assert people["cyd"]["missing"] == ["week3"]
    assert (people["dee"]["total"], people["dee"]["missing"]) == (0, ["week1", "week3"])
    assert people["dee"]["sets"]["week2"]["state"] == "excused"
    assert {each["sets"]["week4"]["state"] for each in people.values()} == {"open"}


def test_weights_and_the_worst_left_out(course, monkeypatch, capsys):
    Path("corollary.toml").write_text('timezone = "UTC"\n[term]\nweights = { week1 = 3 }\ndrop = 1\n')
    assert run(monkeypatch, "--json") == 0
    people = json.loads(capsys.readouterr().out)["students"]
    assert people["ada"]["total"] == pytest.approx((3 * 0.5 + 1) / 4)
    assert people["ben"]["total"] == pytest.approx((3 * 0.5 + 1) / 4)
    assert people["ben"]["sets"]["week2"]["dropped"]
    assert (people["cyd"]["low"], people["cyd"]["high"]) == pytest.approx((0.5, 1))


def test_a_setting_that_names_no_set_is_refused(course, monkeypatch, capsys):
    Path("corollary.toml").write_text('timezone = "UTC"\n[term]\nweights = { wek1 = 3 }\n')
    assert run(monkeypatch) == 2
    assert "did you mean week1" in capsys.readouterr().err
    Path("corollary.toml").write_text('timezone = "UTC"\n[term]\ndrop = 1\nbest = 2\n')
    assert run(monkeypatch) == 2
    assert "corollary.toml:2" in capsys.readouterr().err


def test_the_best_choice_of_sets_is_the_best_of_all_choices():
    shares, weights = (0.5, 0.49, 1.0, 0.2, 0.9), (1.0, 10.0, 1.0, 3.0, 0.5)
    for count in range(1, 6):
        choices = itertools.combinations(range(5), count)
        best = max(
            sum(weights[at] * shares[at] for at in each) / sum(weights[at] for at in each) for each in choices
        )
        assert best_mean(shares, weights, count)[0] == pytest.approx(best)


def test_a_misconception_is_the_same_in_problems_that_name_it(course, monkeypatch, capsys):
    assert run(monkeypatch, "--json") == 0
    found = json.loads(capsys.readouterr().out)
    arriving = next(each for each in found["misconceptions"] if each["name"] == ARRIVING)
    assert (arriving["repeated"], arriving["lost"]) == (["ada"], ["ben"])
    assert arriving["counts"] == {"week1": 2, "week3": 1}
    old = next(each for each in found["misconceptions"] if each["name"] == OTHER)
    assert old["problem"] == "X12.5"
    (of_ada,) = found["students"]["ada"]["misconceptions"]
    assert of_ada["met"].keys() == {"week1", "week3"}


def test_tables_and_page_are_for_the_instructor_and_of_one_section(course, monkeypatch, capsys):
    places = {"--csv": "totals.csv", "--missing": "missing.csv", "--misconceptions": "m.csv", "-o": "t.html"}
    assert run(monkeypatch, "--section", "b", *itertools.chain(*places.items())) == 0
    assert {stat.S_IMODE(Path(each).stat().st_mode) for each in places.values()} == {0o600}
    totals = rows_of("totals.csv")
    assert [each["id"] for each in totals] == ["ben", "dee"]
    (mail,) = rows_of("missing.csv")
    assert (mail["name"], mail["email"]) == ("Dee Weiss", "dee@example.org")
    assert mail["missing_titles"] == "Title of week1, Title of week3"
    assert "2 sets not handed in" in mail["behind"]
    rows = {each["misconception"]: each for each in rows_of("m.csv")}
    assert (rows[ARRIVING]["status"], rows[ARRIVING]["week3"]) == ("lost", "right")
    assert "Ben Okafor" in Path("t.html").read_text()
    assert "Ada" not in Path("t.html").read_text()
    assert run(monkeypatch, "--group", "2", "--json") == 0
    assert json.loads(capsys.readouterr().out)["students"].keys() == {"ben", "cyd"}
    assert run(monkeypatch, "--section", "C") == 2
    assert "sections A, B" in capsys.readouterr().err


@pytest.mark.whole
def test_a_practice_sheet_has_fresh_numbers_for_a_repeated_misconception_and_no_answer(
    course, bank, monkeypatch, capsys
):
    assert run(monkeypatch, "--practice-sheets", "sheets") == 0
    rows = {each["id"]: each for each in rows_of("sheets/practice.csv")}
    assert "ben" not in rows  # the misconception was lost
    ada = rows["ada"]
    drop = find(bank, DROP)
    assert (ada["misconception"], ada["exercise"]) == (ARRIVING, drop.code)  # the one that she never had
    assert stat.S_IMODE(Path("sheets").stat().st_mode) == 0o700
    page = Path("sheets/ada/practice.html").read_text()
    assert LEFT_OUT[METEOR] in page
    assert f"corollary practise {drop.code}/{ada['number']}" in page
    cells = json.loads(Path("sheets/ada/practice.ipynb").read_text())["cells"]
    part = drop.part(ada["part"])
    assert any(drop.answer_name(part) in "".join(cell["source"]) for cell in cells)
    key = practice(bank).pose(drop.code, int(ada["number"])).key
    answers = [f"{abs(value):.3g}" for value in key.truths[part.id].values]
    assert key.variant.index != chapter(drop).index
    assert not [each for each in answers if len(each) > 3 and each in page]
