"""The page to practise on as files: it says what grading says, holds nothing of what is left out, and works in a browser from a file."""

from __future__ import annotations

import json
import os
from pathlib import Path

import pytest
from click.testing import CliRunner

from corollary.cli.commands import app
from corollary.practice.offline import Offline
from corollary.practice.practice import practice
from corollary.problem.bank import chapter_bank
from corollary.render.practice_site import (
    NEEDED,
    NoPyodide,
    exercise_file,
    page_file,
    reading,
    scripts,
    with_room,
)

ANSWERS = [
    "8.6 kg m/s",
    "8,6 Ns",
    "86 kg m/s",
    "8.6 s",
    "-8.6 N s",
    "abc",
    "",
    "17.2 N s",
    "8600 kg m/s",
    "9",
]


@pytest.fixture(scope="module")
def kicks():
    return practice(chapter_bank(), ["X12.5"])


@pytest.fixture(scope="module")
def turns(kicks):
    text = exercise_file(kicks, kicks.problems[0], 2).decode()
    return json.loads(text.partition(" = ")[2].rstrip().rstrip(";"))


def test_serialized_says_what_grading_says(kicks, turns):
    posed, offline = kicks.pose("X12.5", 0), Offline(json.loads(turns[0]["key"]))
    for answer in ANSWERS:
        ours = posed.judged("a", {"a": answer}).verdict
        assert offline.verdict("a", {"a": answer}) == ours, answer
        assert offline.preview("a", answer) == posed.preview("a", answer)


def test_a_file_in_place_of_its_folder_is_refused(tmp_path):
    (tmp_path / "notes.txt").write_text("mine", encoding="utf-8")
    done = CliRunner().invoke(app, ["export", "X12.5", "--to", "site", str(tmp_path / "notes.txt")])
    assert done.exit_code == 2
    assert "is a file; name a folder for the site" in done.stderr


def test_what_is_said_of_a_mistake_stands_in_the_file_as_html(turns):
    verdict = Offline(json.loads(turns[0]["key"])).verdict("a", {"a": "86 kg m/s"})
    assert "<math" in turns[0]["said"][verdict.mistake]


def test_each_turn_has_numbers_hints_steps_and_its_motion(turns):
    one, other = turns
    assert one["judged"] == ["a", "b", "c", "d"]
    assert one["html"] != other["html"]
    assert one["hints"]["a"][0].startswith("<p>One step leads from what is given")
    assert one["hints"]["b"]["part"] == "a"
    assert "from your answer in (a)" in one["hints"]["b"]["known"][0]
    assert len(one["steps"]) > 2
    assert 'class="reel"' in one["motion"]


def test_what_is_read_and_judged_there_needs_python_alone():
    carried = reading()["modules"]
    assert "corollary.grading.follow_through" in carried
    assert not {"numpy", "sympy", "scipy"} & {name.partition(".")[0] for name in carried}


def test_the_page_loads_files_beside_it_and_sends_nothing(kicks):
    page = page_file(kicks).decode()
    assert "connect-src" not in page
    assert "default-src &#39;none&#39;" in page or "default-src 'none'" in page


def test_a_folder_without_pyodide_is_refused_by_what_it_lacks(tmp_path):
    with pytest.raises(NoPyodide, match=r"pyodide\.asm\.wasm"):
        scripts(tmp_path)


@pytest.mark.parametrize(("before", "least"), [(b"\xe0\x03", 1024), (b"\xff\x7f", 16383)])
def test_a_program_begins_with_memory_for_a_snapshot(before, least):
    """The least number of pages in its memory section is set; the rest of the program is as it was."""
    header, after = b"\0asm\1\0\0\0", b"\x0a\x01\x00"
    program = header + b"\x01\x01\x00" + b"\x05\x07\x01\x01" + before + b"\x80\x80\x04" + after
    made = with_room(program)
    assert len(made) == len(program)
    assert made[:15] == program[:15]
    assert made[17:] == program[17:]
    assert (made[15] & 0x7F) | (made[16] << 7) == least
    assert with_room(made) == made


def test_what_has_no_memory_of_its_own_is_left_as_it_is():
    assert with_room(b"\0asm\1\0\0\0\x0a\x01\x00") == b"\0asm\1\0\0\0\x0a\x01\x00"


@pytest.fixture
def little(tmp_path) -> Path:
    """A folder that looks like Pyodide."""
    for name in NEEDED:
        (tmp_path / name).write_text('{"info": {}}', encoding="utf-8")
    return tmp_path


def test_problems_of_a_set_that_is_left_out_leave_nothing_behind(little, tmp_path):
    """Neither their titles nor their laws and values are in any file."""
    place = tmp_path / "site"
    asked = ["export", "X12.2", "X12.5", str(place), "--to", "site", "--bank", "chapter", "--json"]
    chosen = ["--variants", "1", "--except", "momentum_1", "--pyodide", str(little)]
    done = CliRunner().invoke(app, [*asked, *chosen])
    assert done.exit_code == 0, done.output
    assert json.loads(done.stdout)["problems"] == ["X12.2"]
    pages = [place / "index.html", *(place / "exercises").iterdir()]
    written = "".join(path.read_text(encoding="utf-8") for path in pages)
    assert "Energetic" in written
    for secret in ("Kicking a ball", "X12.5", "football", "172.0"):
        assert secret not in written


@pytest.mark.parametrize(
    "named", [["X12.2", "PLACE"], ["X12.2", "-o", "PLACE"], ["-o", "PLACE", "energetic_collision"]]
)
def test_the_folder_of_a_site_is_named_last_or_by_its_option(little, tmp_path, named):
    named = [each.replace("PLACE", str(tmp_path / "site")) for each in named]
    usual = ["--to", "site", "--variants", "1", "--pyodide", str(little), "--json"]
    done = CliRunner().invoke(app, ["export", *named, *usual])
    assert done.exit_code == 0, done.output
    assert json.loads(done.stdout)["problems"] == ["X12.2"]
    assert (tmp_path / "site" / "index.html").is_file()


@pytest.mark.parametrize(
    ("named", "sentence"),
    [
        (["--to", "site"], "name the folder for the site: corollary export --to site DIR"),
        (["momentum_1", "--to", "site"], "name the folder for the site last"),
        (["--to", "moodle"], "say which set: corollary export SET --to moodle"),
    ],
)
def test_what_is_missing_is_said(named, sentence):
    done = CliRunner().invoke(app, ["export", *named, "--bank", "chapter"])
    assert done.exit_code == 2
    assert sentence in done.stderr


def test_options_of_a_site_are_for_a_site(tmp_path):
    done = CliRunner().invoke(app, ["export", "momentum_1", "--to", "text", "--except", "momentum_1"])
    assert done.exit_code == 2
    assert "for a site" in done.stderr


@pytest.fixture(scope="module")
def site(tmp_path_factory) -> Path:
    """Three exercises as files, with Python."""
    place = tmp_path_factory.mktemp("site")
    command = [
        "export",
        "X12.2",
        "S12.5wall",
        "S12.5el",
        str(place),
        "--to",
        "site",
        "--bank",
        "chapter",
        "--variants",
        "2",
    ]
    folder = os.environ.get("COROLLARY_PYODIDE")
    done = CliRunner().invoke(app, [*command, *(["--pyodide", folder] if folder else [])])
    assert done.exit_code == 0, done.output
    return place / "index.html"


@pytest.mark.browser
@pytest.mark.client
def test_a_student_practises_without_a_network(chromium, site):
    """From a file: wrong, a hint, right by a formula; what follows; worked solution and motion."""
    from playwright.sync_api import expect

    assert (site.parent / "pyodide" / "snapshot.js").is_file()
    context = chromium.new_context(viewport={"width": 390, "height": 800}, offline=True)
    page, wrong = context.new_page(), list[str]()
    page.on("pageerror", lambda error: wrong.append(str(error)))
    page.on("console", lambda message: wrong.append(f"{message.type}: {message.text}"))
    page.goto(site.as_uri())
    page.locator('nav button[data-code="S12.5wall"]').click()
    part, seen = page.locator("section[data-part=a]"), page.locator("section[data-part=b]")
    field = part.locator("input[type=text]").first
    field.fill("9 km")
    field.press("Enter")
    expect(part.locator(".feedback")).to_contain_text("Not right yet")
    expect(part.locator(".feedback")).to_contain_text("Think of")
    expect(part.locator(".read")).to_contain_text("9 km")
    part.get_by_role("button", name="A hint").click()
    expect(part.locator(".hints li")).to_have_count(1)
    field.fill("2 vB - vA")
    expect(part.locator(".read")).to_contain_text("2*vB - vA")
    field.press("Enter")
    expect(part.locator(".feedback .said.right")).to_be_visible()
    other = seen.locator("input[type=text]").first
    other.fill("vA - vB")
    other.press("Enter")
    expect(seen.locator(".feedback .said.right")).to_be_visible()
    steps = page.get_by_role("button", name="Show the next step")
    for count in range(1, 40):
        if not steps.is_visible():
            break
        steps.click()
        expect(page.locator(".worked > div")).to_have_count(count)
    expect(page.locator(".film")).to_have_count(1)
    loaded = page.evaluate("[...document.scripts].map(each => each.src)")
    assert any(each.endswith("pyodide/snapshot.js") for each in loaded)
    assert not any(each.endswith("pyodide/reading.js") for each in loaded)  # it would begin anew
    assert page.evaluate("document.documentElement.scrollWidth - document.documentElement.clientWidth") <= 0
    page.emulate_media(media="print")
    page.evaluate("dispatchEvent(new Event('beforeprint'))")
    expect(page.locator(".motion li").first).to_be_visible()
    expect(page.locator("#other")).not_to_be_visible()
    assert not wrong
    context.close()


@pytest.mark.browser
@pytest.mark.client
def test_hints_follow_what_is_known(chromium, site):
    from tests.hints_in_browser import ask_for_hints

    context = chromium.new_context(viewport={"width": 390, "height": 800}, offline=True)
    page, wrong = context.new_page(), list[str]()
    page.set_default_timeout(30_000)
    page.on("pageerror", lambda error: wrong.append(str(error)))
    page.on("console", lambda message: wrong.append(f"{message.type}: {message.text}"))
    page.goto(site.as_uri())
    page.locator('nav button[data-code="S12.5el"]').evaluate("each => each.click()")
    ask_for_hints(page)
    assert not wrong
    context.close()


@pytest.mark.browser
@pytest.mark.client
def test_one_exercise_from_the_first_key_to_the_motion_by_keyboard_alone(chromium, site):
    """Tab, Enter and letters: the focus is always seen somewhere, and never lost."""
    context = chromium.new_context(
        viewport={"width": 390, "height": 800}, offline=True, reduced_motion="reduce"
    )
    page = context.new_page()
    page.set_default_timeout(30_000)
    page.goto(site.as_uri())
    visited = list[str]()

    def tab_to(wanted: str) -> None:
        for _count in range(60):
            page.keyboard.press("Tab")
            visited.append(page.evaluate("document.activeElement.tagName"))
            if page.evaluate(f"document.activeElement.matches({json.dumps(wanted)})"):
                return
        raise AssertionError(f"{wanted} is not reached: {visited}")

    tab_to('nav button[data-code="S12.5wall"]')
    page.keyboard.press("Enter")
    page.locator("#title:focus").wait_for()
    for part, answer in (("a", "2 vB - vA"), ("b", "vA - vB")):
        tab_to(f"section[data-part={part}] input[type=text]")
        page.keyboard.type(answer)
        page.keyboard.press("Enter")
        page.locator(f"section[data-part={part}] .said.right").wait_for()
    tab_to("#step")
    for count in range(1, 40):
        page.keyboard.press("Enter")
        page.locator(".worked > div").nth(count - 1).wait_for()
        if not page.locator("#step").is_visible():
            break
    assert page.evaluate("document.activeElement.closest('.worked') !== null")
    page.locator(".film").wait_for()
    before = page.locator(".film .clock").inner_text()
    tab_to(".film .scrub")
    for _count in range(200):
        page.keyboard.press("ArrowRight")
    assert page.locator(".film .clock").inner_text() != before
    tab_to(".film summary")
    page.keyboard.press("Enter")
    assert page.locator(".film li").first.is_visible()
    assert page.locator(".film svg.stage").get_attribute("aria-label")
    assert "BODY" not in visited[:-1]
    context.close()


@pytest.mark.browser
@pytest.mark.client
@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize("width", [390, 1280])
def test_axe_finds_nothing_on_an_exercise_with_all_shown(chromium, site, axe, scheme, width):
    context = chromium.new_context(
        offline=True, bypass_csp=True, color_scheme=scheme, viewport={"width": width, "height": 800}
    )
    page = context.new_page()
    page.set_default_timeout(30_000)
    page.goto(site.as_uri())
    page.locator('nav button[data-code="S12.5wall"]').click()
    for part, answer in (("a", "2 vB - vA"), ("b", "9 km")):
        field = page.locator(f"section[data-part={part}] input[type=text]").first
        field.fill(answer)
        field.press("Enter")
        page.locator(f"section[data-part={part}] .said").wait_for()
    page.locator("section[data-part=b] .hint").click()
    steps = page.locator("#step")
    for count in range(40):
        if not steps.is_visible():
            break
        steps.click()
        page.locator(".worked > div").nth(count).wait_for()
    page.locator(".film").wait_for()
    page.evaluate(axe)
    found = page.evaluate("axe.run(document, {resultTypes: ['violations']})")["violations"]
    assert [(each["id"], each["impact"], each["nodes"][0]["html"]) for each in found] == []
    context.close()
