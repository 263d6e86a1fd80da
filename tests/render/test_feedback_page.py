"""A student's feedback: everything that was said, nothing that was not meant for them, and nothing from elsewhere."""

from __future__ import annotations

import base64
import re
import runpy
from dataclasses import replace
from pathlib import Path

import pytest

from corollary.answers.verdict import Right
from corollary.records.manual_marks import ManualMark
from corollary.records.marks import record_of, with_manual
from corollary.render import feedback_page as page_of
from corollary.render.feedback_page import packed, page_facts, unpacked
from corollary.render.wording import LOOKS

SAMPLE = runpy.run_path(str(Path(__file__).parents[1] / "sample.py"))
Page = SAMPLE["Page"]


def feedback_page(work, of, *, manual=None, **more):
    """The page with the program's own marks, or with what a person gave; made of facts that were written to a file."""
    facts = unpacked(packed(page_facts(work, of, **more)))
    return page_of.feedback_page(facts, with_manual(record_of(work, ""), manual or {}))


@pytest.fixture
def of(tmp_path):
    return SAMPLE["problem_set"](tmp_path)


@pytest.fixture
def work(of):
    return SAMPLE["marked"](of)


def test_the_page_needs_nothing_beside_it_and_runs_nothing(of, work):
    solution = "[x](http://example.org) <script>run()</script> $x$"
    found = Page(feedback_page(SAMPLE["late"](work), of, solutions={"X12.5": solution}))
    assert [each for each in found.out if not each.startswith("a href=data:text/markdown")] == []
    assert len(found.ids) == len(set(found.ids))
    assert set(found.links) <= set(found.ids)


def test_points_verdicts_answers_and_feedback_are_all_there(of, work):
    words = Page(feedback_page(work, of)).words
    assert "Feedback for Ada Lovelace <x>" in words
    assert "4.5 of 12 points" in words
    assert "Momentum & impulse" in words
    for name, look in LOOKS.items():
        assert look.phrase in words or name == "unread"
    assert "No answer" in words
    for part in (part for grade in work.grades for part in grade.parts):
        assert not part.answer or " ".join(part.answer.split()) in words
    assert "Too fast <script>alert(2)</script>" in words
    assert "names the floor" not in words  # the rubric is the marker's
    assert "1 part still waits for your teacher" in words


def test_where_to_complain_is_said_below_the_total_and_not_at_the_foot_of_twenty_pages(of, work):
    page = feedback_page(work, of)
    assert page.index("Total") < page.index("not fair") < page.index("<section>")


def test_the_numbers_are_the_students_own(of, work):
    words = Page(feedback_page(work, of)).words
    own = work.grades[0].variant
    assert f"A ball of mass {float(own.values['m']):.2f} kg lies still" in words
    assert f"m = {float(own.values['m']):.2f}" in words


def test_only_answers_that_were_read_are_called_read(of, work):
    words = Page(feedback_page(work, of)).words
    assert "Your answer, as read: 8.6 kg m/s" in words
    assert "Your answer: <b>The</b> Earth recoils" in words


@pytest.mark.parametrize(
    ("read", "shown"),
    [("-0.257 m/s", "−0.257 m/s"), ("(3 m/s, -4 m/s)", "(3 m/s, −4 m/s)"), ("1e-3 m, x to the left", "1e-3 m, x to the left")],
)  # fmt: skip
def test_a_number_below_zero_has_a_minus(of, work, read, shown):
    grade = work.grades[0]
    part = next(each for each in grade.parts if each.part.id == "a")
    below = replace(
        grade, parts=tuple(replace(each, answer=read) if each is part else each for each in grade.parts)
    )
    assert (
        f"Your answer, as read: {shown}"
        in Page(feedback_page(replace(work, grades=(below, *work.grades[1:])), of)).words
    )


def test_late_work_says_what_was_kept(of, work):
    words = Page(feedback_page(SAMPLE["late"](work), of)).words
    assert "Handed in 2 h 5 min after the due time, so 50 % of the points are kept: 4.5 became 2.25." in words
    assert "2.25 of 12 points" in words
    assert "after the due time" not in Page(feedback_page(work, of)).words


def test_trouble_and_stopped_cells_are_told(of, work):
    words = Page(feedback_page(replace(work, trouble="The notebook ends in the middle."), of)).words
    assert "The notebook ends in the middle." in words
    assert "Cell of P12.14 (b): It uses x, which no cell above it has given a value." in words
    assert "X12_5_a_answer" not in words


def test_figures_stand_at_the_part_that_drew_them(of, work):
    text = feedback_page(work, of)
    found = Page(text)
    own = 'src="data:image/png;base64,' + base64.b64encode(SAMPLE["PNG"]).decode()
    assert text.count(own) == 2
    assert found.pictures[0] == "Your figure: 1 curve, titled “Force”, x axis “t (s)”, y axis “F (N)”"
    part = text[text.index('id="X12_5_c_2"') : text.index('id="X12_5_e"')]
    assert "no picture could be made of it" in part
    assert own in text[text.index('id="P12_14_a"') : text.index('id="P12_14_b"')]
    assert own in text[text.index("Other figures of yours") :]


def test_a_picture_that_is_none_is_not_embedded(of, work):
    forged = replace(work, figures=(replace(work.figures[1], png=b"<svg onload=alert(1)>"),))
    assert "<img" not in feedback_page(forged, of)


def test_solutions_are_shown_only_when_given(of, work):
    assert "Worked solution" not in feedback_page(work, of)
    words = Page(feedback_page(work, of, solutions={"P12.14": "Follow the *energy*."})).words
    assert words.count("Worked solution") == 1
    assert words.index("P12.14 A ball") < words.index("Worked solution")


def test_an_empty_submission_is_still_a_page(of, work):
    empty = replace(work, grades=(), runs=(), figures=(), trouble="There was no file.", isolation="")
    assert "0 of 0 points" in Page(feedback_page(empty, of)).words


@pytest.mark.parametrize(("seconds", "said"), [(1, "1 min"), (3599, "1 h"), (2 * 86400 + 3700, "2 days 1 h")])
def test_how_late_it_came_is_said_in_minutes_at_the_finest(of, work, seconds, said):
    page = Page(feedback_page(replace(work, late=seconds), of))
    assert f"Handed in {said} after the due time" in page.words


def test_half_a_surrogate_pair_does_not_keep_a_page_from_being_written(of, work):
    torn = replace(work, trouble="\ud83d", grades=())
    feedback_page(torn, of).encode()


def test_letters_that_no_page_may_hold_are_replaced(of, work):
    text = feedback_page(replace(work, trouble="a\0b\x1b[2Jc\x85d"), of)
    assert "a\ufffdb\ufffd[2Jc\ufffdd" in text
    assert not set(text) & set(map(chr, (*range(9), 11, *range(14, 32), *range(127, 160))))


def test_a_comment_is_read_as_markdown_with_formulas_and_its_lines_stay(of, work):
    part = next(iter(record_of(work, "").parts))
    comment = "Name the **frame**: $p = m v$.\nThen <b>add</b> $\\frac{$."
    page = feedback_page(work, of, manual={part: ManualMark(comment=comment)})
    said = page.partition('<div class="comment">')[2].partition("</div>")[0]
    assert "<strong>frame</strong>" in said
    assert 'alttext="p = m v"' in said
    assert "\nThen &lt;b&gt;add&lt;/b&gt; <code" in said
    assert "white-space: pre-line" in page.partition(".said .comment")[2][:40]


def test_what_is_right_is_folded_and_nothing_else(of, work):
    """A remark, or a part that is not wholly right, stands open."""
    whole = f"{LOOKS['right'].phrase}."

    def bare(part):
        return replace(part, feedback=whole) if isinstance(part.verdict, Right) else part

    grades = tuple(replace(grade, parts=tuple(map(bare, grade.parts))) for grade in work.grades)
    for marked, count in ((work, 0), (replace(work, grades=grades), 1)):
        text = feedback_page(marked, of)
        folded = re.findall(r'<article class="part (\w+)" id="\w+">\s*<details><summary>', text)
        assert folded == ["right"] * count
        assert text.count("<details>") == text.count("</details>") == count


def test_a_student_reads_nothing_of_isolation(of, work):
    page = feedback_page(replace(work, isolation="namespaces + Landlock"), of)
    assert "Landlock" not in page
    assert "solation" not in Page(page).words
