"""The report as a page: plots in words too, tables beside them, nothing from elsewhere."""

from __future__ import annotations

import re
import runpy
from dataclasses import replace
from pathlib import Path

import pytest

from corollary.records.collusion import Shared
from corollary.records.marks import HandedIn
from corollary.records.report_model import report
from corollary.records.statistics import Estimate, FeatureEffect, set_statistics
from corollary.render.report_page import intervals, report_page

SAMPLE = runpy.run_path(str(Path(__file__).parents[1] / "sample.py"))
summary = SAMPLE["summary"]
Page = SAMPLE["Page"]


@pytest.fixture
def of(tmp_path):
    return SAMPLE["problem_set"](tmp_path)


def test_the_page_holds_the_report_and_needs_nothing_beside_it(of):
    found = summary(
        [SAMPLE["marked"](of), SAMPLE["late"](SAMPLE["marked"](of, "eve"))], roster=["ada", "cy", "eve"]
    )
    text = report_page(found, of)
    page = Page(text)
    ways = [f"a href=../feedback/{one}/momentum/momentum.html" for one in ("ada", "eve")]
    assert {way for way in page.out if "formgrader" not in way} == {*ways, "form", "script"}
    assert "2 handed in, 1 missing" in page.words
    assert "3.38 mean of 12 points" in page.words
    assert "1 came late" in page.words
    assert "You forgot the" in page.words
    assert "ada, eve" in page.words
    assert "late, 50 % kept" in page.words
    assert "a person reads this" in page.words
    assert "1 student cy" in page.words
    assert text == report_page(found, of)


def test_different_totals_are_in_per_cent_and_coincidences_counted(of):
    handed = [HandedIn("ada", "Ada", 12.0, 16.0), HandedIn("ben", "Ben", 19.0, 19.0)]
    fits = [Shared("ada", "ben", ("X12_5_a",), 0.56)] * 2
    words = Page(
        report_page(report(handed, [], shared=fits, nobodys=[("who.ipynb", "says nothing")]), of)
    ).words
    assert "88 % mean of the own sheet’s points" in words
    assert "Totals are in per cent, for sheets are out of 16 or 19 points." in words
    assert "Per cent Students" in words
    assert "0 came late" in words
    assert "2 times a wrong answer fits another student's numbers" in words
    assert "This table proves nothing by itself" not in words
    assert "Collected, owner unknown: who.ipynb : says nothing" in words


def test_statistics_stand_in_the_page_where_they_are_asked_for(of):
    found = summary([SAMPLE["marked"](of), SAMPLE["marked"](of, "eve")])
    effect = FeatureEffect("X12.5", "a", "figures", 40, Estimate(0.5, 0.125, 0.875), 0.011, 0.25, 0.625, 0.75)
    whole = replace(set_statistics(found, {}), effects=(effect,))
    words = Page(report_page(found, of, statistics=whole)).words
    of_one = next(each for each in whole.parts if each.difficulty.value == 1)
    assert of_one.answers == 2
    assert "100 % (34 % to 100 %)" in words  # Wilson's interval of 2 of 2
    assert "0.50 (0.12 to 0.88) 0.011 0.250 62 %" in words
    assert "1 effect looked for, 0 found at 5 % of all together" in words
    assert "Statistics" not in Page(report_page(found, of)).words


def test_what_waits_for_a_person_comes_first(of):
    text = report_page(summary([SAMPLE["marked"](of)]), of)
    assert re.findall("<h2[^>]*>(.*?)</h2>", text) == [
        "Waits for marking",
        "Totals",
        "Part by part",
        "Misconceptions and slips met",
        "Students",
    ]


def test_every_part_of_every_student_can_be_read_without_a_script(of):
    words = Page(report_page(summary([SAMPLE["marked"](of)]), of)).words
    assert "X12.5 a right 1/1 X12.5 b follows 1/1 X12.5 c mistaken 0.5/2 You forgot the" in words
    assert "P12.14 b wrong 0/1" in words
    assert "Feedback page of Ada Lovelace <x> · Ada Lovelace <x> in formgrader" in words


def test_links_lead_into_formgrader_wherever_it_is(of):
    found = summary([SAMPLE["marked"](of, "a&b ø")])
    out = Page(
        report_page(found, of, formgrader="https://hub.example.org/user/me/formgrader/", course="a/b")
    ).out
    assert "a href=https://hub.example.org/user/me/formgrader/gradebook/momentum/momentum" in out
    assert "a href=https://hub.example.org/user/me/formgrader/manage_students/a%26b%20%C3%B8/momentum" in out
    assert "a href=a/b/feedback/a%26b%20%C3%B8/momentum/momentum.html" in out


def test_bars_stand_in_the_tables_that_hold_their_numbers(of):
    text = report_page(summary([SAMPLE["marked"](of)]), of)
    assert len(re.findall(r'<svg[^>]* aria-hidden="true">', text)) == len(re.findall('class="bar">', text))
    bar = re.search(r'<tr><th scope="row">X12.5&nbsp;c .*?</tr>', text)
    assert bar is not None
    assert '<rect class="mistaken" x="0.0" width="100.0" height="1"/>' in bar[0]


@pytest.mark.parametrize(
    ("out_of", "edges"),
    [
        (53, [0, 5, 10, 15, 20, 25, 30, 35, 40, 45, 50, 53]),
        (12, list(range(13))),
        (10, list(range(11))),
        (5, [0, 0.5, 1, 1.5, 2, 2.5, 3, 3.5, 4, 4.5, 5]),
        (7.5, [0, 1, 2, 3, 4, 5, 6, 7, 7.5]),
        (1000, list(range(0, 1001, 100))),
        (0, [0, 0.5, 1]),
    ],
)
def test_totals_are_counted_between_round_numbers(out_of, edges):
    found = intervals([], out_of)
    assert [one.low for one in found] == edges[:-1]
    assert [one.high for one in found] == edges[1:]


def test_every_total_counts_once_and_the_best_in_the_last_interval():
    totals = [-1.0, 0.0, 4.99, 5.0, 50.0, 53.0, 54.0]
    found = intervals(totals, 53)
    assert [one.count for one in found] == [3, 1, 0, 0, 0, 0, 0, 0, 0, 0, 3]
    assert found[0].share == 1
    assert found[1].share == pytest.approx(1 / 3)


def test_a_report_on_nothing_is_a_page(of):
    assert "Nothing was handed in yet." in Page(report_page(summary([]), of)).words


def test_one_of_something_is_said_as_one(of):
    words = Page(report_page(summary([SAMPLE["marked"](of)]), of)).words
    assert "1 answer waits for marking" in words
    assert "1 notebook ran behind" in words
    assert not re.search(r"\b1 (students|answers|notebooks|submissions|parts|points)\b", words)


def test_a_thousand_students_fit_in_a_page_that_is_soon_loaded(of):
    found = summary([SAMPLE["marked"](of, f"s{number:04}") for number in range(1000)])
    assert len(report_page(found, of)) < 5_000_000 * 7 / 28  # seven parts each; a long set has 28
