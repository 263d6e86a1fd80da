"""The page of `corollary preview` as an author uses it: type, look, mend, save, and what is refused."""

from __future__ import annotations

import http.client
import json
import re
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from urllib.parse import urlsplit

import pytest
from click.testing import CliRunner

from corollary.cli.commands import app
from corollary.problem.bank import Bank

pytestmark = pytest.mark.browser
SIZES = [(1280, 800), (1024, 768), (390, 844), (320, 640)]
STICKING_OUT = "document.documentElement.scrollWidth - document.documentElement.clientWidth"
CUT_OFF = """
[...document.querySelectorAll("header button, header select, header .state, [role=tab], #checked")].filter(each => {
  const {left, right, width, bottom} = each.getBoundingClientRect();
  return width && (left < 0 || right > innerWidth || bottom > innerHeight || each.scrollWidth > each.clientWidth + 1 && each.clientWidth);
}).map(each => each.outerHTML.slice(0, 200))
"""
OUT_OF_LINE = """
side => {
  const area = document.querySelector(`textarea[data-side=${side}]`), mirror = area.previousElementSibling;
  return [area.scrollHeight - area.clientHeight > 2, mirror.children.length - area.value.split("\\n").length];
}
"""


@pytest.fixture
def bank(tmp_path) -> Bank:
    done = CliRunner().invoke(app, ["new", "Q1", "ride", "--bank", str(tmp_path / "mine")])
    assert done.exit_code == 0, done.output
    return Bank(tmp_path / "mine")


@pytest.fixture
def problem(bank) -> Path:
    return bank.problems / "exercises" / "ride.md"


@contextmanager
def served(code: str, folder: Path) -> Iterator[str]:
    command = [str(Path(sys.executable).with_name("corollary")), "preview", code, "--bank", str(folder)]
    running = subprocess.Popen(
        [*command, "--no-browser"], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True
    )
    assert running.stdout is not None
    try:
        yield running.stdout.readline().strip()
    finally:
        running.terminate()
        running.wait()
        running.stdout.close()


@pytest.fixture
def address(bank) -> Iterator[str]:
    with served("Q1", bank.folder) as found:
        yield found


@pytest.fixture
def page(chromium, address):
    """The page with everything verified; nothing on it may go wrong."""
    context = chromium.new_context(viewport={"width": 1280, "height": 800})
    opened, wrong = context.new_page(), list[str]()
    opened.set_default_timeout(120_000)
    opened.on("pageerror", lambda error: wrong.append(str(error)))
    opened.on("console", lambda message: wrong.append(message.text))
    opened.goto(address)
    verified(opened)
    yield opened
    assert [
        each for each in wrong if "400 (Bad Request)" not in each
    ] == []  # what is refused is said on the page
    context.close()


def verified(page) -> None:
    from playwright.sync_api import expect

    expect(page.locator("#checked")).to_have_text(re.compile("verified: all hold"))


def area(page, side: str):
    page.locator(f"#tab-{side}").click()
    return page.locator(f"textarea[data-side={side}]")


def retype(page, side: str, old: str, new: str) -> str:
    text = area(page, side).input_value()
    assert old in text
    area(page, side).fill(text.replace(old, new, 1))
    return text.replace(old, new, 1)


def test_an_error_is_named_beside_its_line_mended_verified_and_saved(page, bank, problem):
    from playwright.sync_api import expect

    solution = bank.solution_beside(problem)
    before = solution.read_bytes()
    retype(page, "solution", "- law: Speed,", "- low: Speed,")
    complaint = page.locator("#complaints li").first
    expect(complaint).to_contain_text("an item that begins with 'low' has no place here")
    expect(complaint.locator("b")).to_have_text("Solution 7")
    line = page.locator("#solution-panel .mirror > div").nth(6)
    expect(line).to_have_class("wrong")
    expect(line.locator(".beside")).to_contain_text("an item that begins with 'low'")
    expect(page.locator("#tab-solution .count")).to_have_text("1")
    page.locator("#tab-problem").click()
    complaint.locator("button").click()  # jumps to the line of the other text
    assert page.evaluate(
        "[document.activeElement.dataset.side, document.activeElement.value.slice(0, document.activeElement.selectionStart).split('\\n').length]"
    ) == ["solution", 7]
    expect(page.locator("#save")).to_be_enabled()
    assert solution.read_bytes() == before
    retype(page, "solution", "- low: Speed,", "- law: Speed,")
    expect(page.locator("#complaints li b")).to_have_count(0)
    text = retype(page, "solution", "The time is the way", "The duration is the way")
    verified(page)
    expect(page.locator(".sheet.chosen")).to_contain_text("The duration is the way")
    assert solution.read_bytes() == before
    page.keyboard.press("Control+s")
    expect(page.locator("#state")).to_have_text("saved")
    assert solution.read_text(encoding="utf-8") == text
    expect(page.locator("#save")).to_be_disabled()


def test_both_texts_are_saved_by_the_button_and_the_variants_follow(page, bank, problem):
    from playwright.sync_api import expect

    page.locator(".draws tbody a").nth(2).click()
    name = page.locator(".sheet.chosen h2").inner_text()
    assert re.fullmatch(r"Variant \d+", name)
    asked = retype(page, "problem", "You ride a bike", "You push a cart")
    derived = retype(page, "solution", "nearer to the slower one", "closer to the slower one")
    expect(page.locator(".sheet.chosen")).to_contain_text("You push a cart")
    expect(page.locator(".sheet.chosen h2")).to_have_text(name)
    page.locator("#save").click()
    expect(page.locator("#state")).to_have_text("saved")
    assert problem.read_text(encoding="utf-8") == asked
    assert bank.solution_beside(problem).read_text(encoding="utf-8") == derived


def test_a_file_saved_elsewhere_is_followed_and_over_unsaved_text_a_conflict_is_shown(page, problem):
    from playwright.sync_api import expect

    def elsewhere(old: str, new: str) -> str:
        text = problem.read_text(encoding="utf-8")
        problem.write_text(text.replace(old, new), encoding="utf-8")
        return text.replace(old, new)

    elsewhere("You ride a bike", "You push a cart")
    expect(area(page, "problem")).to_have_value(re.compile("You push a cart"))
    expect(page.locator(".sheet.chosen")).to_contain_text("You push a cart")
    mine = retype(page, "problem", "You push a cart", "You pull a sledge")
    theirs = elsewhere("You push a cart", "You drive a car")
    notice = page.locator("#conflict-problem")
    expect(notice).to_contain_text("was changed on the disk since you opened it. Nothing is overwritten")
    page.keyboard.press("Control+s")
    expect(page.locator("#state")).to_contain_text("not saved")
    assert problem.read_text(encoding="utf-8") == theirs
    expect(area(page, "problem")).to_have_value(mine)
    notice.get_by_text("Show the text on the disk").click()
    expect(notice.locator("pre")).to_contain_text("You drive a car")
    notice.get_by_text("Take the text on the disk").click()
    expect(area(page, "problem")).to_have_value(theirs)
    page.keyboard.press("Control+z")  # nothing is lost by it
    expect(area(page, "problem")).to_have_value(mine)
    page.keyboard.press("Control+s")
    expect(page.locator("#state")).to_have_text("saved")
    assert problem.read_text(encoding="utf-8") == mine


def test_mine_is_written_over_the_other_text_only_when_chosen(page, problem):
    from playwright.sync_api import expect

    mine = retype(page, "problem", "You ride a bike", "You pull a sledge")
    problem.write_text(problem.read_text(encoding="utf-8") + "\nMore.\n", encoding="utf-8")
    page.locator("#conflict-problem").get_by_text("Keep mine").click()
    expect(page.locator("#state")).to_contain_text("not saved")
    page.locator("#save").click()
    expect(page.locator("#state")).to_have_text("saved")
    assert problem.read_text(encoding="utf-8") == mine


def test_unsaved_text_is_asked_for_before_the_page_goes(page):
    asked = list[str]()
    page.on("dialog", lambda dialog: (asked.append(dialog.type), dialog.dismiss()))
    page.reload()
    assert asked == []
    verified(page)
    mine = retype(page, "problem", "You ride a bike", "You pull a sledge")
    page.close(run_before_unload=True)
    page.wait_for_event("dialog") if not asked else None
    assert asked == ["beforeunload"]
    assert area(page, "problem").input_value() == mine


def test_words_are_found_and_inserted_with_an_example(page):
    from playwright.sync_api import expect

    area(page, "solution").evaluate("each => each.setSelectionRange(0, 0)")
    page.locator("#tab-words").click()
    page.locator("#find").fill("what an answer comes to")
    expect(page.locator(".words li:visible")).to_have_count(1)
    page.locator(".words li:visible .insert").click()
    lines = page.locator("textarea[data-side=solution]").input_value().split("\n")
    assert lines[1] == "- limit: The way back takes no time. `u -> 2*v` as `w -> oo`"
    expect(page.locator("#complaints li").first).to_contain_text("Solution")
    page.keyboard.press("Control+z")
    verified(page)


def test_a_new_problem_is_written_on_the_page(page, bank):
    from playwright.sync_api import expect

    page.locator("#new").click()
    page.locator("dialog input[name=code]").fill("Q1")
    page.locator("dialog input[name=name]").fill("walk")
    page.locator("dialog button[type=submit]").click()
    expect(page.locator("dialog .trouble")).to_contain_text("has the code Q1 already")
    page.locator("dialog input[name=code]").fill("Q2")
    page.locator("dialog button[type=submit]").click()
    expect(page.locator("#problem option:checked")).to_have_text("Q2 exercises/walk")
    expect(area(page, "problem")).to_have_value(re.compile("code: Q2"))
    assert (bank.folder / "solutions" / "exercises" / "walk.md").is_file()


def test_a_bank_of_an_installed_package_is_shown_read_only(chromium, tmp_path):
    from playwright.sync_api import expect

    folder = tmp_path / "site-packages" / "theirs"
    assert CliRunner().invoke(app, ["new", "Q1", "ride", "--bank", str(folder)]).exit_code == 0
    with served("Q1", folder) as address:
        page = chromium.new_page()
        page.goto(address)
        expect(page.locator("#locked")).to_contain_text("belongs to an installed package and is read only")
        expect(page.locator("#save")).to_be_hidden()
        expect(page.locator("textarea[data-side=problem]")).not_to_be_editable()
        expect(page.locator("#state")).to_have_text("read only")
        page.close()


@pytest.mark.parametrize(("width", "height"), SIZES)
@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_nothing_is_cut_off_and_line_numbers_stand_at_their_lines(chromium, address, width, height, scheme):
    from playwright.sync_api import expect

    context = chromium.new_context(viewport={"width": width, "height": height}, color_scheme=scheme)
    page = context.new_page()
    page.set_default_timeout(120_000)
    page.goto(address)
    verified(page)
    for side in ("problem", "solution"):
        area(page, side)
        assert page.evaluate(OUT_OF_LINE, side) == [False, 0]
    retype(page, "solution", "- law: Speed,", "- low: Speed,")
    expect(page.locator("#complaints li b").first).to_be_visible()
    for panel in ("solution", "words", "variants"):
        if page.locator(f"#tab-{panel}").is_visible():
            page.locator(f"#tab-{panel}").click()
        assert page.evaluate(STICKING_OUT) <= 0
        assert page.evaluate(CUT_OFF) == []
    expect(page.locator("#variants")).to_be_visible()
    context.close()


@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.client
def test_axe_finds_nothing_on_the_page_to_write_on(chromium, axe, address, scheme):
    context = chromium.new_context(
        viewport={"width": 1280, "height": 800}, color_scheme=scheme, bypass_csp=True
    )
    page = context.new_page()
    page.set_default_timeout(120_000)
    page.goto(address)
    verified(page)
    retype(page, "solution", "- law: Speed,", "- low: Speed,")
    page.locator("#complaints li b").first.wait_for()
    page.evaluate(axe)
    found = page.evaluate("axe.run(document, {resultTypes: ['violations']})")["violations"]
    assert [(each["id"], each["impact"], each["nodes"][0]["html"]) for each in found] == []
    context.close()


def test_without_the_secret_or_from_elsewhere_nothing_is_answered(address, problem):
    place = urlsplit(address)
    before = problem.read_bytes()
    save = {
        "ask": "save",
        "problem": "exercises/ride",
        "files": {"problem": {"text": "x", "fingerprint": ""}},
    }

    def ask(method: str, path: str, body: object = None, **headers: str) -> int:
        connection = http.client.HTTPConnection("127.0.0.1", place.port or 0, timeout=60)
        named = {name.replace("_", "-"): value for name, value in headers.items()}
        connection.request(method, path, json.dumps(body) if body else None, named)
        answer = connection.getresponse()
        answer.read()
        connection.close()
        return answer.status

    json_ = {"Content_Type": "application/json"}
    give = f"{place.path}give"
    assert ask("GET", place.path) == 200
    assert ask("GET", f"{place.path}?problem=exercises/ride") == 200
    for path in ("/", "/give", "/guessed/", f"{place.path}../", f"{place.path}problems/exercises/ride.md"):
        assert ask("GET", path) == 404
    assert ask("POST", "/guessed/give", save, **json_) == 404
    assert ask("GET", place.path, Host="evil.example") == 404
    assert ask("POST", give, save, **json_, Host=f"evil.example:{place.port}") == 404
    assert ask("POST", give, save, **json_, Origin="http://evil.example") == 403
    assert ask("POST", give, save, **json_, Origin="null") == 403
    assert ask("POST", give, save, Content_Type="text/plain") == 403
    assert ask("POST", give, {"ask": "open", "problem": "../../../etc/passwd"}, **json_) == 400
    assert ask("POST", give, {**save, "problem": "../outside"}, **json_) == 400
    assert ask("POST", give, {"ask": "anything", "problem": ""}, **json_) == 400
    assert ask("POST", give, {"ask": "open", "problem": ""}, **json_) == 200
    assert problem.read_bytes() == before
