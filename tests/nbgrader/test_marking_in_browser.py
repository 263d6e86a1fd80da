"""Marking by hand in a real browser: on our own page with the keyboard alone, and in nbgrader's formgrader."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

pytest.importorskip("nbgrader")

from corollary.records.files import Course
from corollary.records.manual_marks import read_manual

from .conftest import STUDENTS, grade, hand_in, run

pytestmark = pytest.mark.browser
BIN = Path(sys.executable).parent
HOSTILE = "It moves. <img src=x onerror=\"document.title='hacked'\"> <script>document.title='hacked'</script>"


@pytest.fixture
def address(marked_course: Course) -> Iterator[str]:
    """The page that `corollary mark` opens, with ada's answer a hostile one."""
    hand_in(marked_course, STUDENTS[0], X12_11_c=HOSTILE)
    assert grade(marked_course).status == 0
    line = [str(BIN / "corollary"), "mark", "words", "--course", str(marked_course.folder), "--no-browser"]
    running = subprocess.Popen(line, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
    assert running.stdout is not None
    try:
        yield running.stdout.readline().strip()
    finally:
        running.terminate()
        running.wait()
        running.stdout.close()


def test_answers_are_marked_with_the_keyboard_alone(address: str, marked_course: Course, chromium) -> None:
    from playwright.sync_api import expect

    page = chromium.new_page(viewport={"width": 1100, "height": 900})
    wrong: list[str] = []
    page.on("pageerror", lambda error: wrong.append(str(error)))
    page.goto(address)
    text = page.inner_text("body")
    assert "0 of 2 answers marked · 0 of 2 students done" in text
    assert "Ada Lovelace (ada)" in text
    assert "The floor can be moved" in text, "the question stands above the answers"
    for key in ("j", "1", "3"):
        page.keyboard.press(key)
    expect(page.locator(".state").first).to_have_text("saved")
    page.keyboard.press("c")
    page.keyboard.type("Say more.")
    page.keyboard.press("Escape")
    page.keyboard.press("j")
    page.keyboard.press("f")
    expect(page.locator(".state")).to_have_text(["saved", "saved"])
    expect(page.locator(".progress")).to_have_text("2 of 2 answers marked · 2 of 2 students done")
    expect(page.locator("article.current .here")).to_have_text("you are here")
    page.keyboard.press("m")
    expect(page.locator("article.current .loaded")).to_contain_text("Seen from the moving floor")
    given = {place.student: mark for place, mark in read_manual(marked_course).by_place.items()}
    assert sorted((mark.score, mark.comment) for mark in given.values()) == [(1.33, "Say more."), (2.0, None)]
    if folder := os.environ.get("COROLLARY_PICTURES"):
        page.screenshot(path=f"{folder}/marking.png", full_page=True)
    assert page.title() != "hacked"
    assert wrong == []
    page.reload()
    assert "No answer waits for marking." in page.inner_text("body")
    page.close()
    feedback = (marked_course.place("feedback", "ben", "words") / "words.html").read_text(encoding="utf-8")
    assert "Marked by your teacher" in feedback


@pytest.fixture
def formgrader(marked_course: Course, tmp_path: Path, jupyter) -> Iterator[str]:
    """The address of a Jupyter with formgrader in the course's folder."""
    extension = "--ServerApp.jpserver_extensions={'nbgrader.server_extensions.formgrader': True}"
    with jupyter("server", marked_course.folder, tmp_path, extension) as address:
        yield address


def _saved(what: str) -> Callable[[Any], bool]:
    """Whether a response is nbgrader's to a `grade` or a `comment` that the page has saved."""
    return lambda response: f"/api/{what}/" in response.url and response.request.method == "PUT"


def test_what_is_given_in_formgrader_is_in_the_report_at_once(
    formgrader: str, marked_course: Course, chromium
) -> None:
    page = chromium.new_page(viewport={"width": 1100, "height": 900})
    for number in (1, 2, 3):  # in an order of nbgrader's own; one of the three wrote nothing
        page.goto(f"{formgrader}/formgrader/gradebook/words/words")
        page.click(f"a:has-text('Submission #{number}')")
        page.wait_for_selector("#X12_11_c")
        text = page.inner_text("#notebook")
        if "The floor" in text.split("Explain")[-1]:
            break
    rubric = "Says that a floor that moves away takes energy from the ball"
    assert rubric in text, "the rubric stands by the answer"
    assert not re.search(r"\b(ada|ben|cyd|Lovelace|Boole)\b", text), "marking is anonymous"
    page.wait_for_load_state("networkidle")
    with page.expect_response(_saved("grade")):
        page.fill("#X12_11_c", "1.5")
        page.keyboard.press("Tab")
    with page.expect_response(_saved("comment")):
        page.fill("#X12_11_c-comment", "Say more.")
        page.keyboard.press("Tab")
    if folder := os.environ.get("COROLLARY_PICTURES"):
        page.screenshot(path=f"{folder}/formgrader.png", full_page=True)
    page.close()
    found = run(marked_course, "corollary", "report", "words", "--course", ".", "--json").document
    assert sum(part["counts"]["by_hand"] for part in found["parts"]) == 1
    pages = [
        (marked_course.place("feedback", one.id, "words") / "words.html").read_text() for one in STUDENTS
    ]
    assert sum("Say more." in text for text in pages) == 1
