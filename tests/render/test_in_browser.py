"""Pages in a real browser, on a phone and on a desk, light and dark: nothing sticks out, and everything is reached by keyboard."""

from __future__ import annotations

import re
import runpy
from dataclasses import replace
from pathlib import Path

import pytest
from click.testing import CliRunner

from corollary.cli.author_words import author_words
from corollary.cli.commands import app
from corollary.cli.variant_sheets import rendered_variants
from corollary.grading.solutions import Solutions
from corollary.notebook.worksheet import worksheet
from corollary.problem.bank import chapter_bank
from corollary.problem.problem_set import find_set
from corollary.problem.roster import Student
from corollary.problem.variant import chapter
from corollary.records.marks import record_of
from corollary.records.statistics import set_statistics
from corollary.render.exports import target
from corollary.render.feedback_page import feedback_page, page_facts
from corollary.render.preview_page import preview_page
from corollary.render.report_page import report_page

pytestmark = pytest.mark.browser
SAMPLE = runpy.run_path(str(Path(__file__).parents[1] / "sample.py"))
AUDITED = Path(__file__).parents[2] / "examples" / "audit" / "physics.yaml"
NAMES = ("feedback", "report", "sheet", "preview", "audit")
PHONE, DESK = 320, 1200
STICKING_OUT = "document.documentElement.scrollWidth - document.documentElement.clientWidth"
OUT_OF_REACH = """
[...document.querySelectorAll("body *")].filter(each =>
  each.scrollWidth > each.clientWidth + 1 && ["auto", "scroll"].includes(getComputedStyle(each).overflowX) && each.tabIndex < 0
).map(each => each.outerHTML.slice(0, 200))
"""
ON_THE_EDGE = """
[...document.querySelectorAll("body *")].filter(each => {
  const {left, right, width} = each.getBoundingClientRect(), edge = document.documentElement.clientWidth;
  return width && parseFloat(getComputedStyle(each).borderLeftWidth) && (left < 1 || right > edge - 1);
}).map(each => each.outerHTML.slice(0, 200))
"""
BROKEN = """
all => all.map(each => {
  const inside = document.createRange();
  inside.selectNodeContents(each);
  const tops = [...inside.getClientRects()].map(box => box.top);
  return Math.max(...tops) - Math.min(...tops);
})
"""
INTERVAL = re.compile(r"\d % \(\d+ % to \d+ %\)")
TALLER = "[...document.querySelectorAll('.formula')].filter(each => each.querySelector('span') && each.clientHeight > 40).length"


@pytest.fixture(scope="module")
def pages(tmp_path_factory) -> dict[str, Path]:
    """The pages that people read, as files."""
    folder = tmp_path_factory.mktemp("pages")
    sample = SAMPLE["problem_set"](folder / "bank")
    marked, late = SAMPLE["marked"](sample), SAMPLE["late"](SAMPLE["marked"](sample, "eve"))
    momentum = find_set(chapter_bank(), "momentum_1")
    variants = [chapter(problem) for problem in momentum.problems]
    worked = Solutions(chapter_bank()).worked_solution
    solutions = {variant.problem.code: worked(variant) for variant in variants}
    write = target("html").worksheet
    assert write is not None
    summary = SAMPLE["summary"]([marked, late], roster=["ada", "cy", "eve"])
    texts = {
        "feedback": feedback_page(
            page_facts(late, sample, solutions={"X12.5": solutions["X12.5"]}), record_of(late, "")
        ),
        "report": report_page(summary, sample, statistics=set_statistics(summary, {})),
        "sheet": write(worksheet(momentum, Student("ada", "Ada"), variants), solutions),
    }
    texts["preview"] = preview_page(
        author_words(), rendered_variants(chapter_bank(), variants[0].problem.path)
    )
    for name, text in texts.items():
        (folder / f"{name}.html").write_text(text, encoding="utf-8")
    done = CliRunner().invoke(app, ["audit", str(AUDITED), "--report", str(folder / "audit.html")])
    assert done.exit_code == 0, done.output
    return {name: folder / f"{name}.html" for name in NAMES}


def opened(chromium, path: Path, width: int, scheme: str):
    context = chromium.new_context(
        viewport={"width": width, "height": 800}, color_scheme=scheme, offline=True, bypass_csp=True
    )
    page = context.new_page()
    page.goto(path.as_uri())
    return page


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("width", [PHONE, 360, DESK])
def test_nothing_sticks_out_and_what_scrolls_is_reached_by_keyboard(pages, chromium, name, width):
    page = opened(chromium, pages[name], width, "light")
    assert page.evaluate(STICKING_OUT) <= 0
    assert page.evaluate(OUT_OF_REACH) == []
    page.context.close()


@pytest.mark.parametrize("name", NAMES)
def test_printed_borders_lie_inside_of_the_page(pages, chromium, name):
    """Paper cuts off what lies on the edge of its margin."""
    page = opened(chromium, pages[name], DESK, "light")
    page.emulate_media(media="print")
    assert page.evaluate(ON_THE_EDGE) == []
    page.context.close()


def test_long_formulas_wrap_on_a_phone_and_not_on_a_desk(pages, chromium):
    phone, desk = (opened(chromium, pages["sheet"], width, "light") for width in (PHONE, DESK))
    assert phone.evaluate(TALLER) > desk.evaluate(TALLER)
    assert phone.evaluate(TALLER) >= 20
    for page in (phone, desk):
        page.context.close()


@pytest.mark.client
@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("width", [360, DESK])
@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_axe_finds_nothing(pages, chromium, axe, name, width, scheme):
    page = opened(chromium, pages[name], width, scheme)
    page.evaluate(axe)
    found = page.evaluate("axe.run(document, {resultTypes: ['violations']})")["violations"]
    assert [(each["id"], each["impact"], each["nodes"][0]["html"]) for each in found] == []
    page.context.close()


@pytest.mark.parametrize("name", ["feedback", "report", "sheet", "audit"])
def test_pages_keep_their_own_policy(pages, chromium, name):
    """The policy lets the page's own style and script through: a browser says so when it does not."""
    context = chromium.new_context(offline=True)
    page, complaints = context.new_page(), []
    page.on("console", lambda message: complaints.append(message.text))
    page.on("pageerror", lambda error: complaints.append(str(error)))
    page.goto(pages[name].as_uri())
    assert page.evaluate("getComputedStyle(document.body).maxWidth") not in {"none", ""}
    page.evaluate(
        "document.body.insertAdjacentHTML('beforeend', '<img src=x onerror=\"document.title = 1\">')"
    )
    page.wait_for_function("performance.now() > 0")
    assert page.title() != "1"
    assert all("onerror" in one or "img-src" in one or "inline event handler" in one for one in complaints), (
        complaints
    )
    context.close()


def test_no_interval_and_no_number_of_the_report_is_broken_over_lines(pages, chromium):
    """Bars, too, stand beside the first line of their row."""
    page = opened(chromium, pages["report"], PHONE, "light")
    spread = page.locator("tbody td.number").evaluate_all(BROKEN)
    assert page.get_by_text(INTERVAL).count() > 3
    assert max(spread) < 10  # pixels: a button's box is higher than its number
    low = "all => all.map(each => each.getBoundingClientRect().top - each.closest('tr').getBoundingClientRect().top)"
    assert max(page.locator(".bar svg").evaluate_all(low)) < 24
    page.context.close()


def test_dark_pages_are_dark_and_their_drawings_light(pages, chromium):
    page = opened(chromium, pages["sheet"], DESK, "dark")
    assert page.evaluate("getComputedStyle(document.body).backgroundColor") == "rgb(22, 24, 27)"
    assert "invert" in page.evaluate("getComputedStyle(document.querySelector('.drawing svg')).filter")
    page.emulate_media(media="print")
    assert page.evaluate("getComputedStyle(document.body).backgroundColor") == "rgb(255, 255, 255)"
    page.context.close()


@pytest.mark.parametrize("width", [PHONE, DESK])
def test_what_is_said_of_a_student_has_the_width_of_the_table(pages, chromium, width):
    page = opened(chromium, pages["report"], width, "light")
    page.locator(".students summary").first.click()
    lists = page.locator(".students details[open] ul")
    assert lists.first.evaluate("each => each.clientWidth / each.closest('.narrow').clientWidth") > 0.9
    assert page.evaluate(STICKING_OUT) <= 0
    page.context.close()


@pytest.fixture
def thousand(tmp_path, chromium):
    """The report of a thousand students, opened under its own policy."""
    sample = SAMPLE["problem_set"](tmp_path / "bank")
    works = []
    for number in range(1000):
        work = SAMPLE["marked"](sample, f"s{number:04}")
        work = replace(work, student=Student(f"s{number:04}", f"Student{number}", "Doe"))
        works.append(SAMPLE["late"](work) if number % 100 == 7 else work)
    path = tmp_path / "report.html"
    path.write_text(report_page(SAMPLE["summary"](works), sample), encoding="utf-8")
    context = chromium.new_context(viewport={"width": DESK, "height": 800}, offline=True)
    page = context.new_page()
    page.goto(path.as_uri())
    yield page
    context.close()


def visible(page) -> list[str]:
    return page.evaluate(
        "[...document.querySelectorAll('.students tbody tr')].filter(row => !row.hidden).map(row => row.querySelector('summary').innerText)"
    )


def test_students_are_searched_by_name_by_what_was_said_and_by_both(thousand):
    box = thousand.get_by_role("searchbox")
    box.fill("student77 doe")
    assert [one.split()[0] for one in visible(thousand)] == ["Student77"]
    box.fill("late")
    assert len(visible(thousand)) == 10
    assert "10 of 1000" in thousand.locator("output").inner_text()
    box.fill("late, s0107, X12.5 c mistaken")
    assert len(visible(thousand)) == 1
    box.fill("")
    assert len(visible(thousand)) == 1000


def test_students_are_sorted_by_keyboard(thousand):
    points = thousand.locator(".students thead button").nth(1)
    points.focus()
    thousand.keyboard.press("Enter")
    assert thousand.locator(".students thead th").nth(1).get_attribute("aria-sort") == "descending"
    thousand.keyboard.press("Enter")
    assert thousand.locator(".students thead th").nth(1).get_attribute("aria-sort") == "ascending"
    assert {one.split()[0] for one in visible(thousand)[:10]} == {f"Student{n}" for n in range(7, 1000, 100)}
    name = thousand.locator(".students thead button").first
    name.press("Enter")
    assert [one.split()[0] for one in visible(thousand)[:3]] == ["Student0", "Student1", "Student2"]


def test_a_number_leads_to_the_students_it_counts(thousand):
    thousand.get_by_role("button", name="X12.5 c mistaken").press("Enter")
    assert thousand.get_by_role("searchbox").input_value() == "X12.5 c mistaken"
    assert len(visible(thousand)) == 1000
    thousand.locator(".students summary").first.press("Enter")
    assert "P12.14 b wrong 0/1" in " ".join(thousand.locator(".students details").first.inner_text().split())
