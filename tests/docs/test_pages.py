"""The pages of the documentation name files, make targets and floors that are there."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

TOP = Path(__file__).parents[2]
PACKAGE = TOP / "src" / "corollary"
PAGES = [TOP / "README.md", *sorted((TOP / "docs").rglob("*.md"))]
NEW = ("TOPIC/NAME", "test_MODULE")  # what a page tells its reader to write


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_links_lead_somewhere(page: Path) -> None:
    text = re.sub(r"`[^`\n]+`", "", page.read_text(encoding="utf-8"))  # a link in code is an example
    for target, _, anchor in re.findall(r"\]\(([^)#]*)(#([^)]*))?\)", text):
        if "://" in target:
            continue
        other = page.parent / target if target else page
        assert other.exists(), target
        if anchor:
            headings = re.findall(r"^#+ (.*)$", other.read_text(encoding="utf-8"), re.MULTILINE)
            assert anchor in {re.sub(r"[^\w -]", "", each.lower()).replace(" ", "-") for each in headings}


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_files_that_are_named_are_there(page: Path) -> None:
    for name in re.findall(r"`([\w./-]+/[\w./-]*|[\w/-]+\.py)`", page.read_text(encoding="utf-8")):
        if page.name in {"architecture.md", "contributing.md"} and not any(each in name for each in NEW):
            places = [TOP / name, PACKAGE / name, *PACKAGE.glob(f"*/{name}"), *PACKAGE.glob(f"*/*/{name}")]
            assert any(place.exists() for place in places) or name in {
                "locale/",
                "demo/",
                "site/",
                "submitted/",
                "judging.py",
            }, name


def test_make_targets_that_are_named_are_there() -> None:
    makefile = (TOP / "Makefile").read_text(encoding="utf-8")
    for page in PAGES:
        for target in re.findall(r"`make ([\w-]+)`", page.read_text(encoding="utf-8")):
            assert re.search(rf"^{target}:", makefile, re.MULTILINE), f"{page.name}: make {target}"


def test_every_room_stands_in_the_table_of_floors() -> None:
    table = (TOP / "docs" / "architecture.md").read_text(encoding="utf-8").partition("## The walk")[0]
    rooms = {
        path.stem for path in PACKAGE.iterdir() if path.suffix == ".py" or (path / "__init__.py").exists()
    }
    for room in rooms - {"__init__"}:
        assert f"`{room}`" in table, room


def test_the_tests_that_are_named_are_there():
    rows = re.findall(
        r"`(tests/[\w/]+\.py)::(\w+)`", (TOP / "docs" / "contributing.md").read_text(encoding="utf-8")
    )
    assert len(rows) >= 17
    for path, name in rows:
        assert f"\ndef {name}(" in (TOP / path).read_text(encoding="utf-8"), name
