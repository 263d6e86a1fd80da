"""The page to practise on as files: it says what grading says, holds nothing of what is left out, and works in a browser from a file."""

from __future__ import annotations

import json
import os
from pathlib import Path

import pytest
from click.testing import CliRunner

from corollary.answers import prepared as in_browser
from corollary.answers.verdict import word
from corollary.cli.commands import app
from corollary.practice.practice import practice
from corollary.problem.bank import chapter_bank
from corollary.render.practice_site import exercise_file, page_file
from corollary.render.pyodide import NEEDED, NoPyodide, scripts

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


def test_plain_data_says_what_grading_says(kicks, turns):
    posed = kicks.pose("X12.5", 0)
    for answer in ANSWERS:
        ours = posed.judged("a", {"a": answer}).verdict
        assert word(in_browser.judge(turns[0]["parts"]["a"]["asked"], answer)) == word(ours), answer


def test_what_is_said_of_a_mistake_stands_in_the_file_as_html(turns):
    part = turns[0]["parts"]["a"]
    verdict = in_browser.judge(part["asked"], "86 kg m/s")
    assert "<math" in part["said"][verdict.mistake]


def test_each_turn_has_numbers_hints_steps_and_its_motion(turns):
    one, other = turns
    assert one["judged"] == ["a", "b", "c", "d"]
    assert one["html"] != other["html"]
    assert all(part["hints"][0] for part in one["parts"].values())
    assert len(one["steps"]) > 2
    assert 'class="reel"' in one["motion"]


def test_what_is_read_and_judged_there_needs_python_alone():
    from corollary.notebook.packing import modules

    carried = modules(("value", "vector", "choice"), ("corollary.answers.prepared",))
    assert "corollary.answers.judge_numbers" in carried


def test_the_page_loads_files_beside_it_and_sends_nothing(kicks):
    page = page_file(kicks).decode()
    assert "connect-src" not in page
    assert "default-src &#39;none&#39;" in page or "default-src 'none'" in page


def test_a_folder_without_pyodide_is_refused_by_what_it_lacks(tmp_path):
    with pytest.raises(NoPyodide, match=r"pyodide\.asm\.wasm"):
        scripts(tmp_path)


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


def test_options_of_a_site_are_for_a_site(tmp_path):
    done = CliRunner().invoke(app, ["export", "momentum_1", "--to", "text", "--except", "momentum_1"])
    assert done.exit_code == 2
    assert "for a site" in done.stderr


@pytest.mark.browser
@pytest.mark.client
def test_a_student_practises_without_a_network(chromium, tmp_path, axe):
    """From a file: wrong, a hint, right; worked solution and motion; and axe has nothing to say."""
    from playwright.sync_api import expect

    expect.set_options(timeout=120_000)
    place = tmp_path / "site"
    command = [
        "export",
        "X12.2",
        "S12.5wall",
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
    context = chromium.new_context(viewport={"width": 390, "height": 800}, offline=True)
    page, wrong = context.new_page(), list[str]()
    page.on("pageerror", lambda error: wrong.append(str(error)))
    page.goto((place / "index.html").as_uri())
    page.locator('nav button[data-code="S12.5wall"]').click()
    part = page.locator("section[data-part=a]")
    field = part.locator("input[type=text]").first
    field.fill("9 km")
    field.press("Enter")
    expect(part.locator(".feedback")).to_contain_text("Not right yet")
    expect(part.locator(".read")).to_contain_text("9 km")
    part.get_by_role("button", name="A hint").click()
    expect(part.locator(".hints li")).to_have_count(1)
    field.fill("-9 m/s")
    field.press("Enter")
    expect(part.locator(".feedback .said.right")).to_be_visible()
    steps = page.get_by_role("button", name="Show the next step")
    for count in range(1, 40):
        if not steps.is_visible():
            break
        steps.click()
        expect(page.locator(".worked > div")).to_have_count(count)
    expect(page.locator(".film")).to_have_count(1)
    assert page.evaluate("document.documentElement.scrollWidth - document.documentElement.clientWidth") <= 0
    assert not wrong
    context.close()
    context = chromium.new_context(offline=True, bypass_csp=True)
    page = context.new_page()
    page.goto((place / "index.html").as_uri())
    page.locator('nav button[data-code="S12.5wall"]').click()
    expect(page.locator("#title")).to_contain_text("S12.5wall")
    page.evaluate(axe)
    found = page.evaluate("axe.run(document, {resultTypes: ['violations']})")["violations"]
    assert [(each["id"], each["impact"], each["nodes"][0]["html"]) for each in found] == []
    context.close()
