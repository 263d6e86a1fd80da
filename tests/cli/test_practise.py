"""`corollary practise`: what the page is answered, and the way a student clicks, in a browser."""

from __future__ import annotations

import json
import re
import subprocess
import sys
from collections.abc import Iterator
from html import unescape
from pathlib import Path

import pytest
from click.testing import CliRunner

from corollary.cli.commands import app
from corollary.cli.open_sets import course_in, not_to_be_practised, with_sets
from corollary.cli.practise import answered
from corollary.practice.practice import practice
from corollary.problem.bank import chapter_bank
from corollary.problem.problem_set import find_set
from corollary.render.practice_site import NEEDED

SET = """\
---
title: Exam
due: 2199-01-01
problems:
  - Q1
---
Open.
"""


@pytest.fixture(scope="module")
def kicks():
    return practice(chapter_bank(), ["X12.5", "X12.2"])


def ask(found, **posted):
    return json.loads(answered(found, {"code": "X12.5", "turn": 0, **posted}))


def words(html: str) -> str:
    return " ".join(unescape(re.sub(r"<[^>]*>", " ", html)).split())


def test_an_exercise_has_a_field_for_each_part(kicks):
    got = ask(kicks, ask="exercise")
    assert got["judged"] == ["a", "b", "c", "d"]
    assert got["html"].count("<form>") == 4
    assert "A football of mass" in words(got["html"])
    assert "8.6" not in words(got["html"])


def test_what_is_typed_is_read_judged_and_answered_with_the_message_for_a_mistake(kicks):
    assert ask(kicks, ask="read", part="a", answer="8,6 Ns") == {
        "ok": True,
        "text": "read as 8.6 N s (2 figures)",
    }
    right = ask(kicks, ask="judge", part="a", answers={"a": "8.6 kg m/s"})
    assert right["right"]
    assert "Right" in words(right["html"])
    energy = ask(kicks, ask="judge", part="a", answers={"a": "86 kg m/s"})
    assert not energy["right"]
    assert "kinetic energy" in words(energy["html"])
    carried = ask(kicks, ask="judge", part="c", answers={"b": "9.2 N s", "c": "92 N"})
    assert carried["right"]
    assert "follows correctly" in words(carried["html"])


def test_hints_end_and_steps_follow_each_other(kicks):
    told = ask(kicks, ask="hints", part="a", right=[])["hints"]
    assert len(told) == 3
    assert all(told)
    assert "86.00" in words(ask(kicks, ask="step", place=2)["html"])


def test_what_moves_is_played_where_the_solution_shows_it(kicks):
    got = ask(kicks, ask="motion")
    assert "A (0.43 kg): at the beginning at rest, at the end 20 m/s to the right." in words(got["html"])
    assert ask(kicks, ask="motion", code="X12.2") == {"html": ""}


@pytest.mark.parametrize(
    "posted",
    [
        {"ask": "exercise", "code": "X99"},
        {"ask": "exercise", "turn": -1},
        {"ask": "exercise", "turn": 10**9},
        {"ask": "nothing"},
        {"ask": "read", "part": "z", "answer": "1"},
        {"ask": "judge", "part": "a"},
        {"ask": "step", "place": 99},
    ],
)
def test_what_cannot_be_answered_is_a_sentence(kicks, posted):
    with pytest.raises(ValueError, match=r"\w+ \w+"):
        ask(kicks, **posted)


@pytest.mark.parametrize(
    "answer", ["<script>alert(1)</script>", "9" * 10_000, "\ud800", ["1", "2"], "", "nan"]
)
def test_odd_answers_are_read_and_shown_harmlessly(kicks, answer):
    read = ask(kicks, ask="read", part="a", answer=answer)
    assert isinstance(read["text"], str)
    got = ask(kicks, ask="judge", part="a", answers={"a": answer})
    assert not got["right"]
    assert "<script>" not in got["html"]


def test_a_set_stands_for_its_problems():
    bank = chapter_bank()
    codes = [problem.code for problem in find_set(bank, "momentum_1").problems]
    assert with_sets(bank, ["X12.3", "momentum_1", "collisions"]) == ["X12.3", *codes, "collisions"]


def test_a_set_that_is_not_due_is_left_out(tmp_path):
    """What is asked in an open set cannot be practised on, nor what `--except` names; status 2 where nothing is left."""
    bank = tmp_path / "mine"
    assert CliRunner().invoke(app, ["new", "Q1", "ride", "--bank", str(bank)]).exit_code == 0
    (bank / "problems" / "sets").mkdir(exist_ok=True)
    (bank / "problems" / "sets" / "exam.md").write_text(SET, encoding="utf-8")
    done = CliRunner().invoke(app, ["practise", "--bank", str(bank), "--no-browser"])
    assert done.exit_code == 2
    assert "left out, since not due yet: the problems of exam (due " in done.stderr
    assert "no problem is left to practise on; name other problems" in done.stderr


@pytest.mark.parametrize("wanted", ["momentum_1", "X12.5"])
def test_the_sample_set_can_be_practised_on_whatever_its_date(wanted):
    """It comes with the installation, and is nobody's homework until a course has generated it."""
    bank = chapter_bank()
    assert not not_to_be_practised(bank, ())
    assert "X12.5" in [each.code for each in practice(bank, with_sets(bank, [wanted])).problems]


def test_the_sample_set_is_left_out_where_a_course_has_generated_it(tmp_path: Path, monkeypatch):
    monkeypatch.delenv("COROLLARY_COURSE", raising=False)
    (tmp_path / "roster.csv").write_text("id\nada\n", encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    made = run("generate", "momentum_1", "--roster", "roster.csv", "--course", "mech", "--yes")
    assert made.exit_code == 0, made.output
    course = course_in(tmp_path / "mech")
    assert course is not None
    assert run("extend", "ada", "momentum_1", "2199-01-01", "--course", "mech").exit_code == 0
    assert "X12.5" in not_to_be_practised(chapter_bank(), (), course)


@pytest.fixture
def class_at_work(tmp_path: Path, monkeypatch) -> Path:
    """A course with a set of its own, due long ago, which one student may still hand in; its folder is the working one."""
    monkeypatch.delenv("COROLLARY_COURSE", raising=False)
    (tmp_path / "week1.md").write_text(SET.replace("2199", "2001").replace("Q1", "X12.6"), encoding="utf-8")
    (tmp_path / "roster.csv").write_text("id\nada\nben\n", encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    assert run("generate", "week1.md", "--roster", "roster.csv", "--course", "mech", "--yes").exit_code == 0
    monkeypatch.chdir(tmp_path / "mech")
    return tmp_path / "mech"


@pytest.fixture
def little(tmp_path: Path) -> Path:
    """A folder that looks like Pyodide."""
    (tmp_path / "pyodide").mkdir()
    for name in NEEDED:
        (tmp_path / "pyodide" / name).write_text('{"info": {}}', encoding="utf-8")
    return tmp_path / "pyodide"


def run(*words: str):
    return CliRunner().invoke(app, list(words))


def test_a_set_of_the_course_is_left_out_until_its_last_deadline(class_at_work: Path, little: Path):
    """The course's own set, from a file outside the bank: by its date and by extensions, on the page and in a site."""
    site = ["export", "X12.6", "X12.2", "site", "--to", "site", "--pyodide", str(little), "--json"]
    assert json.loads(run(*site).stdout)["problems"] == ["X12.2", "X12.6"]
    assert run("extend", "ben", "week1", "2199-01-01").exit_code == 0
    for asked in (["practise", "X12.6", "--no-browser"], ["practise", "week1", "--no-browser"]):
        done = run(*asked)
        assert (done.exit_code, done.stdout) == (2, "")
        assert "left out, since not due yet: the problems of " in done.stderr
        assert "week1 (due Tuesday 1 January 2199" in done.stderr
    for more in ([], ["--variants", "2"]):
        assert json.loads(run(*site, *more).stdout)["problems"] == ["X12.2"]
    assert run("extend", "ben", "week1", "--remove").exit_code == 0
    assert run("practise", "X12.6", "--no-browser", "--except", "week1").exit_code == 2


def test_a_set_that_cannot_be_found_any_more_is_left_out_by_its_record(class_at_work: Path):
    (class_at_work.parent / "week1.md").unlink()
    done = run("practise", "X12.6", "--no-browser")
    assert done.exit_code == 2
    assert "week1 (its file is lost, so its date is unknown)" in done.stderr


def test_what_is_for_everybody_is_exported_from_a_courses_folder(class_at_work: Path, little: Path):
    """A course, around the working folder or named, chooses no numbers."""
    done = run("export", "momentum_1", "X12.2", "there", "--to", "site", "--pyodide", str(little))
    assert (done.exit_code, done.stderr.count("say how many variants")) == (0, 0)
    assert run("export", "X12.5", "--to", "moodle").exit_code == 0
    named = run("export", "X12.5", "--to", "moodle", "--course", str(class_at_work))
    assert (named.exit_code, "say how many variants" in named.stderr) == (0, False)


@pytest.fixture
def address() -> Iterator[str]:
    command = [str(Path(sys.executable).with_name("corollary")), "practise", "S12.5el", "X12.2", "X12.3"]
    running = subprocess.Popen(
        [*command, "--bank", "chapter", "--no-browser", "--port", "0"],
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        text=True,
    )
    assert running.stdout is not None
    try:
        yield running.stdout.readline().strip()
    finally:
        running.terminate()
        running.wait()
        running.stdout.close()


@pytest.mark.browser
def test_hints_follow_what_is_known(address, chromium):
    from tests.hints_in_browser import ask_for_hints

    context = chromium.new_context(viewport={"width": 390, "height": 800})
    page, wrong = context.new_page(), list[str]()
    page.on("pageerror", lambda error: wrong.append(str(error)))
    page.goto(address)
    page.locator('nav button[data-code="S12.5el"]').evaluate("each => each.click()")
    ask_for_hints(page)
    assert not wrong
    context.close()


@pytest.mark.browser
@pytest.mark.client
def test_a_student_practises(address, chromium, axe):
    """Choose, type, see how it is read, be wrong, take a hint, be right; and what was done is still there after a reload."""
    from playwright.sync_api import expect

    context = chromium.new_context(viewport={"width": 390, "height": 800}, bypass_csp=True)
    page, wrong = context.new_page(), list[str]()
    page.on("pageerror", lambda error: wrong.append(str(error)))
    page.goto(address)
    page.get_by_role("button", name="Next exercise").click()
    expect(page.locator("nav button[aria-current=true]")).to_have_count(1)
    code = "S12.5el"
    page.locator(f'nav button[data-code="{code}"]').click()
    expect(page.locator("#title")).to_contain_text(code)
    first = page.locator("section[data-part]").first
    field = first.locator("input[type=text]").first
    field.fill("abc")
    expect(first.locator(".read")).to_contain_text("cannot be read")
    field.fill("8.6 s")
    field.press("Enter")
    expect(first.locator(".feedback")).to_contain_text("Not right yet")
    first.get_by_role("button", name="A hint").click()
    expect(first.locator(".hints li")).to_have_count(1)
    page.get_by_role("button", name="Show the next step").click()
    expect(page.locator(".worked > div")).to_have_count(1)
    steps = page.get_by_role("button", name="Show the next step")
    for shown in range(2, 40):
        if not steps.is_visible():
            break
        steps.click()
        expect(page.locator(".worked > div")).to_have_count(shown)
    film = page.locator(".film")
    expect(film.locator(".clock")).to_have_text("0 s")
    before = film.locator(".body").first.get_attribute("transform")
    page.emulate_media(reduced_motion="reduce")
    film.get_by_role("button", name="Play").press("Enter")
    expect(film.locator(".clock")).not_to_have_text("0 s")
    film.get_by_role("button", name="Pause").click()
    assert film.locator(".body").first.get_attribute("transform") != before
    film.locator(".scrub").press("End")
    expect(film.locator("[data-value=x]")).to_have_text("8")
    assert page.evaluate("document.documentElement.scrollWidth - document.documentElement.clientWidth") <= 0
    for scheme in ("light", "dark"):
        page.emulate_media(color_scheme=scheme)
        page.evaluate(axe)
        found = page.evaluate("axe.run(document, {resultTypes: ['violations']})")["violations"]
        assert [(each["id"], each["impact"], each["nodes"][0]["html"]) for each in found] == []
    page.reload()
    expect(page.locator(f'nav button[data-code="{code}"]')).to_have_attribute("data-state", "open")
    assert not wrong
    context.close()
