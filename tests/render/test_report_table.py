"""The report on a terminal."""

from __future__ import annotations

from rich.console import Console

from corollary.records.record import HandedIn
from corollary.records.report_model import Report
from corollary.render.report_table import terminal


def said(report: Report, *unmarked: str) -> str:
    console = Console(width=120)
    with console.capture() as captured:
        console.print(terminal(report, unmarked))
    return captured.get()


def test_what_is_handed_in_and_not_marked_is_not_called_missing():
    nobody = Report((), (), (), (), (), missing=("ada", "ben"))
    assert "Nothing was handed in yet." in said(nobody)
    assert "Nothing from 2: ada, ben" in said(nobody)
    tried = said(nobody, "ada")
    assert "1 handed in what is not on record yet" in tried
    assert "Nothing was handed in" not in tried
    assert "Nothing from 1: ben" in tried


def test_marks_on_record_are_told_apart_from_those_to_come():
    report = Report((HandedIn("cyd", "Cyd", 3.0, 5.0),), (), (), (), (), missing=("ada",))
    tried = said(report, "ada")
    assert "1 handed in what is not on record yet" in tried
    assert "1 handed in, 0% of them late; mean 3" in tried
    assert "Nothing from" not in tried
