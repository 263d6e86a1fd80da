"""The site: built without a warning, every link leads somewhere, every problem has its page, and nothing is asked of another machine."""

from __future__ import annotations

import html
import os
import re
import shutil
import subprocess
import sys
from collections.abc import Iterable
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

import pytest

from corollary.problem.bank import chapter_bank

TOP = Path(__file__).parents[2]
FETCHES = {
    ("link", "href"),
    ("script", "src"),
    ("img", "src"),
    ("iframe", "src"),
    ("source", "src"),
    ("object", "data"),
}

KINDS = ("tutorial", "howto", "reference", "explanation", "results")

pytestmark = pytest.mark.whole


class Addresses(HTMLParser):
    """What a page leads to, what it fetches, the places in it that can be led to, and the kinds of its elements: each with its class
    and the names of its attributes."""

    def __init__(self, text: str):
        super().__init__()
        self.leads: list[str] = []
        self.fetched: list[str] = []
        self.places: set[str] = set()
        self.kinds: set[tuple[str, str, frozenset[str]]] = set()
        self.feed(text)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.kinds.add((tag, dict(attrs).get("class") or "", frozenset(name for name, _value in attrs)))
        for name, value in attrs:
            if name == "id" and value:
                self.places.add(value)
            if (tag, name) in FETCHES and value and ("rel", "canonical") not in attrs:
                self.fetched.append(value)
            if (tag, name) == ("a", "href") and value:
                self.leads.append(value)


@pytest.fixture(scope="module")
def site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Built with the banks of examples/banks installed beside, as `make site` does."""
    folder, banks = tmp_path_factory.mktemp("site"), tmp_path_factory.mktemp("banks")
    found = [str(path) for path in sorted((TOP / "examples" / "banks").glob("*/"))]
    pip = [sys.executable, "-m", "pip", "install", "--quiet", "--no-deps", "--no-build-isolation", "--target"]
    copies = [shutil.copytree(each, banks / "sources" / Path(each).name) for each in found]
    subprocess.run([*pip, banks, *copies], check=True)
    subprocess.run(
        [Path(sys.executable).with_name("mkdocs"), "build", "--quiet", "--site-dir", folder],
        cwd=TOP,
        env=os.environ | {"PYTHONPATH": str(banks), "NO_MKDOCS_2_WARNING": "1"},
        check=True,
    )
    return folder


@pytest.fixture(scope="module")
def pages(site: Path) -> dict[Path, Addresses]:
    return {path: Addresses(path.read_text(encoding="utf-8")) for path in site.rglob("*.html")}


def with_every_kind(of: Iterable[Path], pages: dict[Path, Addresses], times: int = 3) -> list[Path]:
    """Pages on which an element of every kind stands, three times where so many of these have it."""
    left, found = sorted(of), list[Path]()
    for _ in range(times):
        kinds = set[tuple[str, str, frozenset[str]]]().union(*(pages[each].kinds for each in left))
        while kinds:
            best = max(left, key=lambda each: len(pages[each].kinds & kinds))
            found.append(best)
            left.remove(best)
            kinds -= pages[best].kinds
    return found


def test_every_problem_has_its_page(site: Path):
    gallery = (site / "gallery.html").read_text(encoding="utf-8")
    for problem in chapter_bank():
        assert f"gallery/{problem.code}.html" in gallery
        page = (site / "gallery" / f"{problem.code}.html").read_text(encoding="utf-8")
        assert problem.title in html.unescape(page)
        assert "Worked solution" in page
        source = html.unescape((site / "gallery" / f"{problem.code}_source.html").read_text(encoding="utf-8"))
        assert f"code: {problem.code}" in re.sub(r"<[^>]+>", "", source)
    banks = TOP / "examples" / "banks"
    others = [
        path
        for path in banks.glob("*/src/*/problems/**/*.md")
        if "." not in path.stem and path.parent.name != "sets"
    ]
    assert len(others) > 60
    assert len(list((site / "gallery").glob("*.html"))) == 2 * (40 + len(others))  # each with its source


def test_every_link_leads_somewhere(site: Path, pages: dict[Path, Addresses]):
    lost: list[str] = []
    for path, page in pages.items():
        if path.name == "404.html":
            continue
        for address in page.leads + page.fetched:
            parts = urlsplit(address)
            if parts.scheme or parts.netloc:
                continue
            target = (path.parent / unquote(parts.path)).resolve() if parts.path else path
            if target.is_dir():
                target /= "index.html"
            there = target.is_file() and (
                not parts.fragment or target.suffix != ".html" or parts.fragment in pages[target].places
            )
            if not there and parts.fragment != "__top":
                lost.append(f"{path.relative_to(site)}: {address}")
    assert lost == []


def test_nothing_is_asked_of_another_machine(site: Path, pages: dict[Path, Addresses]):
    for path, page in pages.items():
        for address in page.fetched:
            assert urlsplit(address).scheme in ("", "data"), (path.name, address)
    for style in site.rglob("*.css"):
        addresses = re.findall(r"url\(['\"]?([^)'\"]+)", style.read_text(encoding="utf-8"))
        assert all(urlsplit(each).scheme in ("", "data") for each in addresses), style.name


def test_the_reference_has_the_laws(site: Path):
    text = (site / "reference" / "python.html").read_text(encoding="utf-8")
    for name in ("load_bank", "change_of_momentum", "restitution"):
        assert name in text, name


@pytest.mark.browser
def test_the_search_works_in_a_folder(site: Path, chromium):
    page = chromium.new_page()
    page.goto((site / "index.html").as_uri())
    page.fill("input.md-search__input", "restitution")
    found = page.locator(".md-search-result__item a").first
    found.wait_for(timeout=60_000)
    assert "estitution" in page.locator(".md-search-result__list").inner_text()
    page.close()


@pytest.mark.browser
def test_no_page_scrolls_sideways_on_a_phone(site: Path, pages: dict[Path, Addresses], chromium):
    """Of the pages with the text of a problem's files, which are all laid out alike, each tenth."""
    page, found = chromium.new_page(viewport={"width": 390, "height": 900}), dict[str, int]()
    texts = sorted(path for path in pages if path.name.endswith("_source.html"))
    assert len(texts) > 100
    for path in [*(pages.keys() - texts), *texts[::10]]:
        page.goto(path.as_uri())
        beyond = page.evaluate("document.documentElement.scrollWidth - document.documentElement.clientWidth")
        found |= {str(path.relative_to(site)): beyond} if beyond > 0 else {}
    page.close()
    assert not found


@pytest.mark.browser
@pytest.mark.client
@pytest.mark.parametrize(("scheme", "width"), [("light", 1280), ("dark", 390)])
def test_axe_finds_nothing_serious(site: Path, pages: dict[Path, Addresses], chromium, axe, scheme, width):
    context = chromium.new_context(
        bypass_csp=True, color_scheme=scheme, viewport={"width": width, "height": 900}
    )
    page, found = context.new_page(), list[tuple[str, str, str]]()
    own = [*site.glob("*.html"), *(path for kind in KINDS for path in (site / kind).glob("*.html"))]
    assert len(own) > 50
    samples = [site / "gallery" / "X12.5.html", site / "trade" / "tables.html"]
    for path in [*with_every_kind(own, pages), *samples]:
        page.goto(path.as_uri())
        page.evaluate(axe)
        done = page.evaluate("axe.run({resultTypes: ['violations']})")  # of all else one node each
        found += [
            (path.name, each["id"], each["nodes"][0]["html"][:100])
            for each in done["violations"]
            if each["impact"] in {"serious", "critical"}
        ]
    context.close()
    assert not found


def test_a_list_goes_on_behind_its_code(site: Path):
    text = (site / "student.html").read_text(encoding="utf-8")
    first = text.partition("<ol>")[2].partition("</ol>")[0]
    assert first.count("<li>") == 4
