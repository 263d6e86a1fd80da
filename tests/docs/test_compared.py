"""The page of comparisons is that of the data and of the package as they are now, and claims nothing without a source."""

from __future__ import annotations

import csv
import json
import re
import subprocess
import sys
from pathlib import Path

import pytest

TOP = Path(__file__).parents[2]
DATA = TOP / "benchmarks" / "compared"
PAGE = (TOP / "docs" / "compared.md").read_text(encoding="utf-8")
OTHERS = {"edX", "PrairieLearn", "Numbas", "WeBWorK", "Moodle", "STACK"}


def rows(name: str) -> list[dict[str, str]]:
    with (DATA / name).open(encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def cells(text: str) -> list[str]:
    """The outcomes beside a typed answer on the page, Corollary's first."""
    line = next(each for each in PAGE.splitlines() if each.startswith(f"| `{text}`"))
    return [cell.strip() for cell in line.split("|")[2:-1]]


def test_the_page_is_up_to_date():
    done = subprocess.run([sys.executable, TOP / ".ci" / "compared_page.py", "--check"], check=False)
    assert done.returncode == 0, "python .ci/compared_page.py writes it anew"


def test_each_system_has_a_version_a_source_and_the_way_it_was_established():
    systems = {each["system"]: each for each in rows("systems.csv")}
    assert systems.keys() == OTHERS
    for each in systems.values():
        assert re.search(r"\d", each["version"]), each["system"]
        assert all(address.startswith("https://") for address in each["source"].split())
        assert each["established"]


@pytest.mark.parametrize("name", ["typed.csv", "formulas.csv"])
def test_corollary_takes_no_wrong_answer_for_right_and_marks_no_right_one_wrong(name: str):
    found = rows(name)
    assert {each["should"] for each in found} == {"right", "wrong"}
    for each in found:
        outcome = cells(each["text"])[0]
        assert outcome in ({"right", "asked", "refused"} if each["should"] == "right" else {"wrong"}), each[
            "text"
        ]


def test_each_feature_leads_to_a_page():
    for each in rows("features.csv"):
        assert (TOP / "docs" / each["page"]).is_file(), each["feature"]
        assert each["Corollary"] in ("yes", "no", "in part")


def test_where_others_have_what_corollary_has_not_it_stands_on_the_page():
    assert any(each["Corollary"] == "no" for each in rows("features.csv"))
    assert "| [no](" in PAGE


def test_speed_is_of_one_run_with_all_three():
    found = json.loads((DATA / "speed.json").read_text(encoding="utf-8"))
    assert {"nbgrader", "otter-grader", "corollary"} <= found["versions"].keys()
    times = found["ms per notebook, after the start"]
    assert {"nbgrader autograde", "otter run"} <= times.keys()
    assert f"| {times['nbgrader autograde']:.0f} | 1 × as fast |" in PAGE
