"""The report on a terminal."""

from __future__ import annotations

from rich.console import Console

from corollary.records.collusion import Shared
from corollary.records.marks import HandedIn
from corollary.records.report_model import Report, report, report_record
from corollary.render.report_page import terminal


def said(report: Report, *unmarked: str) -> str:
    console = Console(width=120)
    with console.capture() as captured:
        console.print(terminal(report, unmarked))
    return captured.get()


def test_what_is_handed_in_and_not_marked_is_not_called_missing():
    nobody = Report((), (), (), (), (), missing=("ada", "ben"))
    assert "Nothing was handed in yet." in said(nobody)
    assert "Not handed in by 2: ada, ben" in said(nobody)
    tried = said(nobody, "ada")
    assert "1 handed in what is not on record yet" in tried
    assert "Nothing was handed in" not in tried
    assert "Not handed in by 1: ben" in tried


def test_marks_on_record_are_told_apart_from_those_to_come():
    report = Report((HandedIn("cyd", "Cyd", 3.0, 5.0),), (), (), (), (), missing=("ada",))
    tried = said(report, "ada")
    assert "1 handed in what is not on record yet" in tried
    assert "1 handed in, 0 of them late; mean 3" in tried
    assert "Not handed in by" not in tried


def handed(**marks: tuple[float, float]) -> Report:
    return report([HandedIn(who, who.title(), *each) for who, each in marks.items()], [])


def test_sheets_out_of_different_totals_are_told_in_per_cent():
    same = said(handed(ada=(12.0, 16.0), ben=(16.0, 16.0)))
    assert "mean 14 and median 14 of 16 points" in same
    other = said(handed(ada=(12.0, 16.0), ben=(19.0, 19.0), cyd=(19.0, 19.0)))
    assert "mean 92 % and median 100 % of the own sheet's points" in " ".join(other.split())
    assert "sheets are out of 16 or 19 points" in " ".join(other.split())


def test_one_who_is_late_is_counted():
    many = [HandedIn(f"s{number}", "", 1.0, 1.0) for number in range(241)]
    assert "242 handed in, 1 of them late" in said(
        report([*many, HandedIn("ada", "", 1.0, 1.0, late=3.0)], [])
    )


def test_what_chance_explains_is_a_sentence_and_no_table():
    fits = [Shared(f"s{number}", "ada", ("X12_5_d",), 0.56) for number in range(70)]
    noise = report([HandedIn("ada", "", 1.0, 1.0)], [], shared=fits)
    assert "70 times a wrong answer fits another student's numbers, which chance explains." in said(noise)
    assert "by chance" not in said(noise)
    told = report(
        [HandedIn("ada", "", 1.0, 1.0)], [], shared=[Shared("cyd", "ada", ("X12_5_d",), 0.004), *fits[:1]]
    )
    assert "0.004" in said(told)
    assert "s0" not in said(told)
    assert "Besides, once a wrong answer fits" in said(told)
    assert report_record(told)["coincidences"] == 1
