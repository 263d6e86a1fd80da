"""The exercises of `examples/audit`: what the audit finds of each published answer is what `findings.json` records."""

from __future__ import annotations

import json
from collections import Counter
from pathlib import Path
from typing import Any

import pytest
import yaml
from click.testing import CliRunner

from corollary.cli.commands import app

FOLDER = Path(__file__).parents[2] / "examples" / "audit"
FILES = sorted(path.name for path in FOLDER.glob("*.yaml"))
RECORDED = json.loads((FOLDER / "findings.json").read_text(encoding="utf-8"))
KINDS = {"agrees", "last figure", "wrong", "not unique", "impossible", "ambiguous", "cannot say"}


def found_in(path: Path) -> dict[str, dict[str, str]]:
    """Exercise: what is asked: the finding. The command ends with 1 where a key is faulty, and with 0 where none is."""
    done = CliRunner().invoke(app, ["audit", str(path), "--json"], catch_exceptions=False)
    found: dict[str, dict[str, str]] = {}
    for each in json.loads(done.stdout):
        found.setdefault(each["id"], {})[each["asked"]] = each["finding"]
    faulty = {"wrong", "not unique", "impossible"} & {
        kind for each in found.values() for kind in each.values()
    }
    assert done.exit_code == bool(faulty), done.stderr
    return found


def records(name: str) -> dict[str, Any]:
    return yaml.safe_load((FOLDER / name).read_text(encoding="utf-8"))


@pytest.mark.whole
@pytest.mark.parametrize("name", FILES)
def test_findings_are_those_recorded(name):
    assert found_in(FOLDER / name) == RECORDED[name]


# One of each kind; every one is explained in docs/results/audit_findings.md.
SAMPLE = {
    "college_physics.yaml": ["2.53", "3.29", "6.16", "6.48", "10.20"],
    "question_library.yaml": ["273", "290", "291a"],
    "webwork_brock.yaml": ["NU_U17-2-07-014", "NU_U17_10_02_003"],
}


@pytest.mark.whole
@pytest.mark.parametrize("name", SAMPLE)
def test_a_sample_is_found_as_recorded(name, tmp_path):
    whole = records(name)
    whole["records"] = [each for each in whole["records"] if each["id"] in SAMPLE[name]]
    (tmp_path / name).write_text(yaml.safe_dump(whole, allow_unicode=True), encoding="utf-8")
    assert found_in(tmp_path / name) == {each: RECORDED[name][each] for each in SAMPLE[name]}


def test_the_sources_are_five_and_more_and_each_record_says_where_it_is_from():
    assert set(RECORDED) == set(FILES)
    assert len(FILES) >= 5
    for name in FILES:
        whole = records(name)
        assert whole["source"]
        assert whole["licence"].startswith("CC BY")
        for each in whole["records"]:
            assert each.get("address", whole["address"]).startswith("https://")


def test_there_are_a_hundred_and_fifty_records_and_more():
    assert sum(len(each) for each in RECORDED.values()) >= 150
    counted = Counter(
        kind for each in RECORDED.values() for answers in each.values() for kind in answers.values()
    )
    assert set(counted) <= KINDS
    assert counted["agrees"] > sum(counted.values()) // 2
