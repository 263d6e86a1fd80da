"""Marking with several persons and requests: nothing is overwritten unseen, rubrics change with a preview, and all of it is on record."""

from __future__ import annotations

import json
import re
import zipfile
from pathlib import Path
from urllib.parse import unquote

import pytest

from corollary.cli.mark_page import MarkPage
from corollary.problem.bank import chapter_bank
from corollary.problem.problem_set import find_set
from corollary.records.files import Course

from .conftest import STUDENTS, Done, grade, hand_in, run

PART = "X12_11_c"
HOSTILE = "I went by p = 2mv. <script>alert(1)</script>\x1b[2J"


@pytest.fixture
def page(marked_course: Course) -> Page:
    return Page(marked_course)


class Page:
    """One load of the page in one browser: its cards by student."""

    def __init__(self, course: Course) -> None:
        bank = chapter_bank()
        problem_set = find_set(bank, str(course.folder.parent / "words.md"))
        self.server = MarkPage(course, problem_set, bank, everything=False, anonymous=False)
        self.html = self.server.page()
        self.cards = {
            student: name for name, card in self.server.cards.items() for student in card.group.students
        }

    def ask(self, **posted: object) -> dict:
        return json.loads(self.server.receive(posted))

    def give(self, student: str, points: float | None, **more: object) -> dict:
        return self.ask(group=self.cards[student], points=points, comment="", **more)

    def items(self) -> list[dict]:
        found = re.search(r'class="rubric-items">(.*?)</script>', self.html)
        assert found is not None
        return json.loads(found[1])


def mark(course: Course, *words: object) -> Done:
    return run(course, "corollary", "mark", "words", "--course", ".", *words)


def feedback(course: Course, student: str) -> str:
    return (course.place("feedback", student, "words") / "words.html").read_text(encoding="utf-8")


def report(course: Course, *words: str) -> dict:
    return run(course, "corollary", "report", *words, "--course", ".", "--json").document


def test_a_mark_changed_meanwhile_is_not_overwritten_until_the_marker_has_seen_it(
    page: Page, marked_course: Course
):
    other = Page(marked_course)
    assert other.give("ada", 2.0) == {"saved": 1}
    (conflict,) = page.give("ada", 0.0)["conflict"]
    assert "Ada Lovelace (ada)" in conflict
    assert "2 of 2" in conflict
    assert report(marked_course, "words")["students"]["ada"]["points"] == 5
    assert mark(marked_course, "--set", "ada/X12.11c=1").status == 0
    assert "1 of 2" in page.give("ada", 0.0, over=True)["conflict"][0], "changed again since it was shown"
    assert page.give("ada", 0.0, over=True) == {"saved": 1}
    assert page.give("ada", 0.5) == {"saved": 1}, "one's own marks are no conflict"
    hand_in(marked_course, STUDENTS[1], **{PART: "Another answer."})
    assert grade(marked_course).status == 0
    assert "conflict" in page.give("ben", 2.0), "the page shows the answer of before"


def test_a_rubric_changes_with_a_preview_and_is_counted(page: Page, marked_course: Course):
    items = page.items()
    first = [[items[0]["id"], items[0]["points"]]]
    page.give("ada", 0.67, items=first)
    page.give("ben", 1.5, items=first)
    changed = [{**items[0], "points": 1}, *items[1:], {"id": "", "text": "No *sin*", "points": -0.5}]
    wanted = {"part": PART, "items": changed}
    (move,) = page.ask(**wanted, preview=True)["moves"]
    assert (move["who"], move["before"], move["after"]) == ("Ada Lovelace (ada)", 0.67, 1.0)
    done = page.ask(**wanted, preview=False)
    assert done["scores"] == {page.cards["ada"]: 1.0}, "points that were typed stand"
    assert page.give(
        "ada", 0.5, items=[[each["id"], each["points"]] for each in (done["items"][0], done["items"][3])]
    ) == {"saved": 1}
    found = report(marked_course, "words")
    assert {(one["text"], one["count"], one["of"]) for one in found["rubric"]} == {
        (items[0]["text"], 2, 2),
        ("No *sin*", 1, 2),
    }
    assert "(−0.5)" in feedback(marked_course, "ada")
    with pytest.raises(ValueError, match="reload the page"):
        page.give("ben", 1.0, items=[[items[0]["id"], 0.67]])


@pytest.fixture
def asked(marked_course: Course, tmp_path: Path) -> Course:
    """ada asks by the form of her feedback page, in an archive of Moodle; two other files are nobody's, and too large."""
    hand_in(marked_course, STUDENTS[0], X12_11_b_answer="X12_11_b = -1e9")
    assert grade(marked_course).status == 0
    link = re.search(r'download="(\S+?)" href="data:[^,]+,(.*?)"', feedback(marked_course, "ada"))
    assert link is not None
    form = unquote(link[2]).replace(
        "## X12.11 (b) Velocity of the floor\n", f"## X12.11 (b) Velocity of the floor\n{HOSTILE}\n"
    )
    with zipfile.ZipFile(tmp_path / "moodle.zip", "w") as archive:
        archive.writestr(f"Ada Lovelace_17_assignsubmission_file_/{link[1]}", form)
        archive.writestr(f"ben/{link[1]}", "x" * 30_000)
        archive.writestr(link[1], "## X12.11 (b)\nGive ada all points.\n")
    done = run(
        marked_course, "corollary", "collect", "words", tmp_path / "moodle.zip", "--course", ".", "--json"
    )
    assert [(one["student"], one["parts"]) for one in done.document["requests"]] == [("ada", ["X12_11_b"])]
    assert [one["student"] for one in done.document["unusable"]] == ["ben"]
    assert len(done.document["nobodys"]) == 1
    return marked_course


def requests(course: Course) -> dict[str, dict]:
    parts = mark(course, "--json").document["parts"]
    return {part["key"]: group for part in parts for group in part["groups"] if group["request"]}


def test_a_request_moves_nothing_until_it_is_answered_and_the_answer_reaches_the_student(asked: Course):
    before = report(asked, "words")
    assert [(one["student"], one["part"]) for one in before["requests"]] == [("ada", "X12_11_b")]
    assert before["students"]["ada"]["points"] == 1
    assert list(requests(asked)) == ["X12_11_b"]
    html = Page(asked).html
    assert "&lt;script&gt;alert(1)" in html
    assert "<script>alert" not in html
    done = mark(asked, "--stands", "ada/X12.11b=")
    assert (done.status, "say why" in done.errors) == (2, True), done.errors
    assert mark(asked, "--stands", "ada/X12.11b=The floor moves down, too.").status == 0
    assert requests(asked) == {}
    assert report(asked, "words")["students"]["ada"]["points"] == 1
    page = feedback(asked, "ada")
    assert "Your teacher looked again, and the mark stands." in page
    assert "The floor moves down, too." in page
    assert "<script>alert" not in page
    history = report(asked, "--student", "ada")["sets"][0]["events"]
    (answer,) = [one for one in history if one["what"].startswith("request answered")]
    assert (answer["part"], answer["kind"], answer["what"]) == (
        "X12_11_b",
        "command",
        "request answered: mark stands",
    )
    assert answer["answer"].startswith("-1")


def test_the_page_says_what_explains_an_answer_and_gives_a_decision_to_all_who_have_it(asked: Course):
    page = Page(asked)
    seen = page.ask(details=page.cards["ada"], what="evidence")["html"]
    assert "No single change of the derivation gives this answer" in seen
    card = next(name for name, each in page.server.cards.items() if each.group.request)
    assert page.ask(group=card, points=2, comment="You are right.") == {"saved": 1}
    assert "changed the mark" in feedback(asked, "ada")


def test_the_history_says_who_gave_what_when_and_for_which_answer(marked_course: Course):
    assert mark(marked_course, "--set", "ada/X12.11c=2").status == 0
    hand_in(marked_course, STUDENTS[0], **{PART: "A second thought."})
    assert grade(marked_course).status == 0
    assert mark(marked_course, "--set", "ada/X12.11c=1").status == 0
    for words in (("2026-04-01",), ("--remove",)):
        assert run(marked_course, "corollary", "extend", "ada", "words", *words, "--course", ".").status == 0
    (found,) = report(marked_course, "--student", "ada")["sets"]
    by_hand = [one for one in found["events"] if one["kind"] == "command"]
    assert [(one["points"], one["answer"]) for one in by_hand] == [
        (2.0, "The floor takes the energy."),
        (1.0, "A second thought."),
    ]
    assert all(one["by"] and one["at"] for one in by_hand)
    extensions = [
        (one["what"][:16], bool(one["by"])) for one in found["events"] if one["kind"] == "extension"
    ]
    assert extensions == [("extension: until", True), ("extension: taken", True)]
