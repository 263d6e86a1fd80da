"""Numbas's compiler takes the exam, and its runtime, in a browser, gives the marks that we give on everything the answer tables try.

With the folder of Numbas (numbas/Numbas) in COROLLARY_NUMBAS it is asked, and its answers are written to recorded/numbas.json.
"""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from collections import Counter
from pathlib import Path

import pytest

from corollary.grading.solutions import Solutions
from corollary.problem.bank import chapter_bank
from corollary.problem.problem_set import Scheme
from corollary.problem.variant import at
from corollary.render.exports import target
from corollary.render.lms_item import ChoiceAsked, NotAsked, NumbersAsked, item

NUMBAS = os.environ.get("COROLLARY_NUMBAS", "")
DRIVER = Path(__file__).with_name("numbas.js").read_text(encoding="utf-8")
FEW = ("X12.2", "X12.10", "X12.4", "S12.2")
MATHJAX = "mathjax@4.1.3"
THERE = "() => !!document.querySelector('numbas-exam')?.exam?.signals"


@pytest.fixture(scope="session")
def mathjax(tmp_path_factory) -> Path:
    """The folder of npm's packages with MathJax, without which Numbas does not begin."""
    npm = shutil.which("npm")
    assert npm is not None, "npm is missing: it fetches MathJax for Numbas"
    folder = tmp_path_factory.mktemp("mathjax")
    command = [npm, "install", "--no-audit", "--no-fund", "--ignore-scripts", "--prefix", folder, MATHJAX]
    subprocess.run(command, check=True, timeout=300)
    return folder / "node_modules"


@pytest.fixture
def exam(chromium, mathjax, tmp_path):
    """A page on which Numbas runs the exam of these items, and Numbas's version."""
    pages, errors = [], []

    def started(items):
        made = target("numbas").items
        assert made is not None
        (tmp_path / "chapter.exam").write_bytes(made("chapter", items, False).files["chapter-numbas.exam"])
        folder = tmp_path / "exam"
        program = [sys.executable, Path(NUMBAS) / "bin" / "numbas.py", "-p", NUMBAS, "-c", "-o", folder]
        options = ["--mathjax-4-url", "http://127.0.0.1/mathjax", tmp_path / "chapter.exam"]
        run = subprocess.run([*program, *options], cwd=NUMBAS, capture_output=True, text=True, check=False)
        assert run.returncode == 0, run.stdout[-2000:] + run.stderr[-2000:]
        page = chromium.new_page()
        page.set_default_timeout(120_000)
        pages.append(page)
        page.on("pageerror", lambda error: errors.append(str(error)))
        page.route("**/*", lambda route: serve(route, folder, mathjax))
        page.goto("http://127.0.0.1/")
        page.wait_for_function(THERE)
        about = json.loads((folder / "numbas-manifest.json").read_text(encoding="utf-8"))
        return page, about["Numbas_version"]

    yield started
    for page in pages:
        page.close()
    assert not errors


def serve(route, folder: Path, modules: Path) -> None:
    name = route.request.url.partition("127.0.0.1/")[2].partition("?")[0] or "index.html"
    places = [modules / name, modules / "@mathjax" / name.removeprefix("mathjax/"), folder / name]
    found = next((place for place in places if place.is_file()), None)
    if found is None:
        route.abort()
    else:
        route.fulfill(path=found)


def typed(asked, row) -> list[str] | int | None:
    """The fields of a part, or the place of an option."""
    if isinstance(asked, NumbersAsked):
        return list(row.fields)
    letters = [each.option.letter for each in asked.options]
    return letters.index(row.fields[0]) if row.fields[0] else None


@pytest.mark.client
@pytest.mark.browser
@pytest.mark.skipif(not NUMBAS, reason="no COROLLARY_NUMBAS")
def test_numbas_gives_what_we_give(chapter_items, exam, fingerprint, record, table):
    attempts, tried = [], []
    for one in chapter_items:
        problem, rows = one.exercise.problem, table(one)
        carried = [each for each in one.parts if not isinstance(each, NotAsked)]
        for place, asked in enumerate(carried):
            if isinstance(asked, NumbersAsked | ChoiceAsked):
                of_part = [row for row in rows if row.part.id == asked.prompt.part.id]
                answers = [typed(asked, row) for row in of_part]
                attempts.append(
                    {"question": f"{problem.code} {problem.title}", "part": place, "answers": answers}
                )
                tried.append((one, asked, of_part))
    page, version = exam(chapter_items)
    items, nameless = {}, []
    for (one, asked, rows), given in zip(tried, page.evaluate(DRIVER, attempts), strict=True):
        code = one.exercise.problem.code
        here = items.setdefault(code, {"hash": fingerprint(one), "parts": 0})
        here["parts"] += 1
        counted = Counter()
        for row, each in zip(rows, given, strict=True):
            theirs = each["score"] / asked.prompt.out_of
            if abs(theirs - row.share) < 1e-4 and abs(each["marks"] - asked.prompt.out_of) < 1e-9:
                counted["equal"] += 1
            else:
                counted["different"] += 1
                nameless.append((code, row.part.id, row.sort, row.fields, row.share, each))
        for name, count in counted.items():
            here[name] = here.get(name, 0) + count
    assert not nameless
    assert len(items) > 30
    record("numbas", {"client": "Numbas's runtime", "version": f"{version}, in Chromium", "items": items})


@pytest.mark.parametrize("code", FEW)
def test_what_decides_marks_is_what_numbas_was_asked(code, make_item, fingerprint, recorded):
    items = recorded("numbas")["items"]
    if code in items:
        assert items[code]["hash"] == fingerprint(make_item(code))


@pytest.mark.whole
def test_nothing_has_changed_since_numbas_was_asked(chapter_items, fingerprint, recorded):
    items = recorded("numbas")["items"]
    assert items
    found = {each.exercise.problem.code: fingerprint(each) for each in chapter_items}
    assert {code: each["hash"] for code, each in items.items()} == {code: found[code] for code in items}


def test_numbas_gave_no_mark_of_its_own(recorded):
    assert not [code for code, each in recorded("numbas")["items"].items() if each.get("different")]


@pytest.mark.client
@pytest.mark.browser
@pytest.mark.skipif(not NUMBAS, reason="no COROLLARY_NUMBAS")
def test_a_student_types_is_told_and_tries_other_numbers(exam, make_item):
    """One variant says what the next one does not: the page draws among them, and marks by the one that it shows."""
    problem = make_item("X12.5").exercise.problem
    solutions = Solutions(chapter_bank())
    items = [item(solutions, at(problem, 40 * n), n, 1.0, Scheme()) for n in range(1, 6)]
    page, _version = exam(items)
    page.wait_for_selector("text=Save answer")
    shown = set()
    for _attempt in range(20):
        (one,) = [each for each in items if says(page, each)]
        shown.add(one.number)
        mistaken = one.parts[0].marks[1]
        field = page.locator("input:visible").first
        field.click()
        field.fill(f"{mistaken.values[0]:.7g}".replace(".", ","))
        page.get_by_role("button", name="Save answer").first.click()
        page.wait_for_selector("text=That is the kinetic energy")
        page.wait_for_selector(f"text=Score: {mistaken.share:g}/1")
        if len(shown) > 1:
            return
        page.get_by_role("button", name="Try another question like this one").click()
        page.get_by_role("button", name="OK").click()
        page.wait_for_selector("text=That is the kinetic energy", state="detached")
    pytest.fail("every draw was the same variant")


def says(page, one) -> bool:
    return page.get_by_text(" ".join(one.exercise.statement.split())).count() > 0
