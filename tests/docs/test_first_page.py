"""The README as a first page: one sentence, one picture, two commands, a table of what is new with links, and its readers."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path
from xml.etree import ElementTree

import corollary

TOP = Path(__file__).parents[2]
README = (TOP / "README.md").read_text(encoding="utf-8")
SVG = "{http://www.w3.org/2000/svg}"


def section(title: str) -> str:
    return README.partition(f"\n## {title}\n")[2].partition("\n## ")[0]


def paragraphs() -> list[str]:
    """The paragraphs of prose: no headings, code, tables or pictures."""
    text = re.sub(r"```.*?```", "", README, flags=re.DOTALL)
    return [each for each in re.split(r"\n\s*\n", text) if each.strip() and each.lstrip()[0] not in "#|!"]


def test_it_begins_with_one_sentence_and_one_picture():
    title, sentence, picture = README.split("\n\n")[:3]
    assert title == "# Corollary"
    assert re.fullmatch(r"\*\*[^.]+\.\*\*", sentence)
    assert picture.startswith("![")
    assert README.count("![") == 1


def test_no_paragraph_is_longer_than_three_lines():
    assert len(paragraphs()) > 5
    long = [each for each in paragraphs() if len(each.strip().splitlines()) > 3 or len(each) > 3 * 140]
    assert not long


def test_each_line_of_its_tables_has_a_link():
    for title, least in (("What it does that others don't", 5), ("Who it is for", 5)):
        rows = [row for row in section(title).splitlines() if row.startswith("|")][2:]
        assert len(rows) >= least
        assert not [row for row in rows if not re.search(r"\]\([^)]+\)", row)], title


def test_it_ends_within_a_page():
    assert len(README.splitlines()) < 110


def test_the_picture_is_what_the_command_draws():
    done = subprocess.run([sys.executable, TOP / ".ci" / "first_page.py", "--check"], check=False)
    assert done.returncode == 0, "python .ci/first_page.py writes it anew"


def test_the_picture_is_light_fits_a_phone_and_says_what_the_package_says():
    path = TOP / "docs" / "first_page.svg"
    assert path.stat().st_size < 10_000
    root = ElementTree.fromstring(path.read_text(encoding="utf-8"))
    assert root.attrib["width"] == "390"
    sizes = [float(each.attrib["font-size"]) for each in root.iter() if "font-size" in each.attrib]
    assert min(sizes) >= 12
    said = " ".join("".join(each.itertext()) for each in root.iter(f"{SVG}text"))
    problem = corollary.load_bank()["X12.5"]
    given = {"m": "0.37 kg", "v": "24.5 m/s", "w": "13 m/s", "dt": "0.07 s"}
    feedback = next(
        part.feedback for part in corollary.judge(problem, {"d": "130 N"}, given).parts if part.part.id == "d"
    )
    assert feedback in said
    assert '"130 N"' in said
    assert "198.2\N{NO-BREAK SPACE}N" in said  # 0.37 kg (24.5 + 13.0) m/s / 0.07 s
