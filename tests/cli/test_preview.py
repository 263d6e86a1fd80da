"""`corollary preview`: what is on the page, what an author's error looks like, and that the page follows what is saved."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from collections.abc import Iterator
from html import unescape
from pathlib import Path

import pytest
from click.testing import CliRunner

from corollary.cli.commands import app
from corollary.cli.local_page import edition
from corollary.cli.preview import previewed
from corollary.problem.bank import Bank, chapter_bank, home_of_file


@pytest.fixture
def bank(tmp_path) -> Bank:
    done = CliRunner().invoke(app, ["new", "Q1", "ride", "--bank", str(tmp_path / "mine")])
    assert done.exit_code == 0, done.output
    return Bank(tmp_path / "mine")


@pytest.fixture
def problem(bank) -> Path:
    return bank.problems / "exercises" / "ride.md"


def change(path: Path, old: str, new: str) -> None:
    text = path.read_text(encoding="utf-8")
    assert old in text
    path.write_text(text.replace(old, new, 1), encoding="utf-8")


def words(page: str) -> str:
    body = page.partition("<body>")[2].partition("<script>")[0]
    return " ".join(unescape(re.sub(r"<[^>]*>", " ", body)).split())


def test_twenty_variants_with_key_mistakes_and_tolerance(bank, problem):
    page = previewed(bank, problem)
    assert len(re.findall(r'<section class="sheet"', page)) >= 21
    reasons = (
        "the condition <code>abs(v - w) &gt; v/5</code> does not hold</td>",
        "cannot be told from the truth</td>",
    )
    assert page.count('<tr class="redrawn">') == sum(page.count(reason) for reason in reasons)
    shown = words(page)
    assert "20 variants as students get them" in shown
    # 12 km at 15 km/h and back at 20 km/h: 48 min there, 24 km in 84 min; the mean of the speeds is 17.5 km/h = 4.8611 m/s
    own = shown.partition("Its own numbers")[2]
    assert "2880.0 s" in own
    assert "4.7619 m/s" in own
    assert re.search(r"mean of the two speeds, but you ride longer at the slower one\. 4\.8611 m/s", own)
    assert "right within 0.5 %" in own
    assert "The way is longer, and so is the time. A" in own
    assert "Worked solution" in own
    assert "ridden there at 15\N{NO-BREAK SPACE}km/h" in page  # the figure's words
    assert 'class="note trouble" aria-label' not in page


def test_a_draw_that_a_mistake_meets_says_so(bank, problem):
    change(problem, "  - abs(v - w) > v/5\n", "  - d > 0\n")
    shown = words(previewed(bank, problem))
    assert re.search(r"redrawn \(↻\)", shown)
    assert "cannot be told from the truth" in shown


@pytest.mark.parametrize(
    ("file", "old", "new", "complaint"),
    [
        ("md", "code: Q1", "cod: Q1", r"ride\.md:2 the front matter has no `code`"),
        ("md", "at {{v}}, turn", "at {{V}}, turn", r"ride\.md:22 \{\{V\}\} is not among the givens"),
        ("solution", "- law: Speed", "- low: Speed", r"ride\.md:7 an item that begins with 'low' has no place here"),
        ("solution", "v = d/t", "v = d/s", r"ride\.md:7 Speed: what does s mean"),
        ("solution", "`v = d/t`", "v = d/t", r"ride\.md:7 write one law between backticks"),
        ("solution", "## (a) t", "## (a) d", r"ride\.md:3 d is a given"),
        ("solution", "## (a) t", "## (a)", r"ride\.md:7 an item that begins with 'law' has no place here"),
        ("md", "floor at", "flour at", r"ride\.md:\d+ .*flour"),
    ],
)  # fmt: skip
def test_an_authors_error_is_on_the_page(bank, problem, file, old, new, complaint):
    change(problem if file == "md" else bank.solution_beside(problem), old, new)
    page = previewed(bank, problem)
    note = re.search(r'<section class="note trouble" aria-label.*?</section>', page, re.DOTALL)
    assert note is not None
    assert re.search(complaint, words(f"<body>{note[0]}"))
    assert "Traceback" not in page
    if file == "solution":
        assert "You ride a bike along a way of 12" in words(page)  # what is asked is still there


def test_a_change_of_one_sign_in_the_same_second_is_seen(bank, problem):
    solution = bank.solution_beside(problem)
    assert "4.7619" in words(previewed(bank, problem))
    first = edition(bank, problem)
    before = solution.stat()
    change(solution, "u = 2*d/(t + d/w)", "u = 2*d/(t - d/w)")
    os.utime(solution, ns=(before.st_atime_ns, before.st_mtime_ns + 1000))
    assert edition(bank, problem) != first
    assert "4.7619" not in words(previewed(bank, problem))  # 24 km in 12 min


def test_every_edition_counts_programs_beside_the_solution(tmp_path):
    bank, path = home_of_file(None, "P12.14")
    assert bank.folder == chapter_bank().folder
    assert "floor.py" in edition(bank, path) or ".py" in edition(bank, path).partition(".py")[2]


@pytest.fixture
def address(bank) -> Iterator[str]:
    command = [str(Path(sys.executable).with_name("corollary")), "preview", "Q1", "--bank", str(bank.folder)]
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


@pytest.mark.browser
def test_the_page_follows_what_is_saved(address, bank, problem, chromium):
    from playwright.sync_api import expect

    page = chromium.new_page(viewport={"width": 1100, "height": 900})
    wrong: list[str] = []
    page.on("pageerror", lambda error: wrong.append(str(error)))
    page.goto(address)
    page.set_default_timeout(60_000)
    expect(page.locator(".sheet:visible")).to_have_count(1)
    expect(page.locator(".sheet:visible h2")).to_have_text("Its own numbers")
    page.locator("tbody a").nth(2).click()
    name = page.locator(".sheet:visible h2").inner_text()
    assert re.fullmatch(r"Variant \d+", name)
    change(problem, "You ride a bike", "You push a cart")
    expect(page.locator(".sheet:visible")).to_contain_text("You push a cart")
    expect(page.locator(".sheet:visible h2")).to_have_text(name)
    change(problem, "code: Q1", "cod: Q1")
    expect(page.locator("section.trouble")).to_contain_text("ride.md:2")
    change(problem, "cod: Q1", "code: Q1")
    expect(page.locator("section.trouble")).to_have_count(0)
    assert wrong == []
    page.close()
