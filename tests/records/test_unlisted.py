"""Wrong answers that nobody listed: rules one change from the derivation that students share."""

from __future__ import annotations

import csv
import io
import json
from pathlib import Path

import msgspec
import pytest
from click.testing import CliRunner
from rich.console import Console

from corollary.cli.commands import app
from corollary.derive.solution import Solution
from corollary.grading.solutions import Solutions
from corollary.records.assignments import read_assigned
from corollary.records.files import open_course
from corollary.records.marks import HandedIn, PartRecord, Record, Row
from corollary.records.statistics import SetStatistics
from corollary.records.unlisted import DrawnLetters, shared_rules
from corollary.render.statistics_table import statistics_table


def drawn(count: int, planted: int) -> list[DrawnLetters]:
    """The second kick of X12.5, F_r = m (v + w)/dt; the first students take the velocities' difference."""
    found: list[DrawnLetters] = []
    for place in range(count):
        m, v, w, dt = 0.4 + 0.013 * place, 20 + 1.7 * place, 9 + (5 * place) % 7, 0.008 + 0.0003 * place
        letters = {"m": m, "v": v, "w": w, "dt": dt, "dp_r": m * (v + w)}
        wrong = m * (v - w) / dt if place < planted else 3.7 * m * v**0.5 / dt**1.5
        typed = (float(f"{wrong:.3g}"),) if place < planted + 4 else None
        found.append(DrawnLetters(f"s{place}", letters, typed, 0.01, 0.5))
    return found


@pytest.fixture
def solution(kicks) -> Solution:
    return Solutions(kicks.bank).of(kicks.problem_set.problems[0])


def test_a_shared_rule_is_named_with_those_who_used_it(solution: Solution) -> None:
    (offer,) = shared_rules(solution, "X12.5", "d", drawn(30, 4))
    assert offer.students == ("s0", "s1", "s2", "s3")
    assert (offer.wrong, offer.points) == (8, 2.0)
    assert offer.rules[0].formula == "dp_r = m*(v - w)"
    assert "sign of w turned" in offer.rules[0].words
    assert offer.adjusted < 0.01
    assert offer.expected < 1
    console = Console(width=120, record=True, file=io.StringIO())
    console.print(statistics_table(SetStatistics((), (), (), (offer,))))
    shown = console.export_text()
    assert "4 of 8 wrong answers that nobody listed" in shown
    assert "students: s0, s1, s2, s3" in shown
    assert "`dp_r = m*(v - w)`" in shown


def test_what_two_students_share_is_not_offered_nor_what_all_numbers_would_give(solution: Solution) -> None:
    assert shared_rules(solution, "X12.5", "d", drawn(30, 2)) == []
    same = drawn(30, 4)[0]
    alike = [DrawnLetters(f"s{place}", same.letters, same.typed, 0.01) for place in range(8)]
    assert shared_rules(solution, "X12.5", "d", alike) == [], "with the same numbers nothing can be told"


def test_the_drafted_line_makes_a_misconception_of_it(kicks, solution: Solution) -> None:
    (offer,) = shared_rules(solution, "X12.5", "d", drawn(30, 4))
    file = kicks.bank.folder / "solutions" / "impulse" / "kicking_a_ball.md"
    head, step, rest = file.read_text().partition("## dp_r\n")
    assert step
    file.write_text(head + step + rest.replace("- mistake:", f"{offer.rules[0].draft}\n- mistake:", 1))
    listed = Solutions(kicks.bank).of(kicks.problem_set.problems[0])
    texts = [wrong.text for find in listed.unknowns if find.names == ("dp_r",) for wrong in find.mistakes]
    assert offer.rules[0].message in texts


@pytest.mark.whole
def test_the_report_of_a_course_offers_it(kicks, tmp_path: Path) -> None:
    names = [f"s{place}" for place in range(8)]
    kicks.generate(*names)
    course, problem_set = open_course(kicks.folder), kicks.problem_set
    for place, (student, sheet) in enumerate(read_assigned(course, problem_set).items()):
        given = sheet.variants[0].si
        wrong = given["m"] * (given["v"] - given["w"]) / given["dt"]
        _record(course, problem_set, student, f"{wrong:.4g} N" if place < 4 else None)
    (course.record("graded", "any").parent / "kicks").mkdir(parents=True, exist_ok=True)
    table = tmp_path / "statistics.csv"
    done = CliRunner().invoke(
        app,
        ["report", "kicks", "--course", str(kicks.folder), "--statistics", "--json", "--csv", str(table)],
        catch_exceptions=False,
    )
    assert done.exit_code == 0, done.output
    (offer,) = json.loads(done.stdout)["statistics"]["unlisted"]
    assert (offer["part"], offer["count"], offer["wrong"]) == ("d", 4, 4)
    assert "dp_r = m*(v - w)" in {rule["formula"] for rule in offer["rules"]}
    rows = [row for row in csv.DictReader(io.StringIO(table.read_text())) if row["statistic"] == "unlisted"]
    assert [(row["part"], row["answers"], len(row["students"].split())) for row in rows] == [("d", "4", 4)]


def _record(course, problem_set, student: str, wrong: str | None) -> None:
    problem = problem_set.problems[0]
    rows, parts = [], {}
    for part in problem.parts:
        is_wrong = part.id == "d" and wrong is not None
        verdict, points = ("wrong", 0.0) if is_wrong else ("right", part.points)
        rows.append(Row(student, problem.code, part.id, verdict, points, part.points))
        parts[problem.answer_name(part)] = PartRecord(verdict, points, part.points, wrong if is_wrong else "")
    whole = Record(1.0, 4.0, parts, "", HandedIn(student, student, 1.0, 4.0), tuple(rows))
    place = course.record("graded", f"{problem_set.name}/{student}.json")
    place.parent.mkdir(parents=True, exist_ok=True)
    place.write_bytes(msgspec.json.encode(whole))
