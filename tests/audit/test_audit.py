"""The command on files: what is said, in which form, and with which status."""

from __future__ import annotations

import json
import subprocess
from pathlib import Path

import pytest
from tests import forked

RECORDS = """
- id: right
  given: {m: 2 kg, a: 3 m/s^2}
  laws: [F = m*a]
  asked: F
  published: 6.0 N
- id: problem
  problem: X12.5
  given: {m: 0.43 kg, v: 72 km/h, w: 20 m/s, dt: 100 ms}
  asked: a
  published: 8.6 kg m/s
"""
COSINE = """
- id: cosine
  given: {v: 20 m/s, theta: 30 deg, g: 9.8 m/s^2}
  laws: [Height: h = (v*sin(theta))^2/(2*g)]
  asked: h
  published: 15.3 m
"""
LISTED = """
- id: half
  given: {r: 2 m, v: 3 m/s}
  laws: [a = v^2/r]
  asked: a
  published: 9.0 m/s^2
  mistakes:
    - You took half of the radius: a = v^2/(r/2)
"""


def audit(*arguments: object, cwd: Path | None = None) -> subprocess.CompletedProcess[str]:
    return forked.run(
        [forked.COMMAND, "audit", *arguments], cwd=cwd, capture_output=True, text=True, timeout=300
    )


@pytest.fixture
def written(tmp_path):
    def write(text, name="records.yaml"):
        path = tmp_path / name
        path.write_text(text, encoding="utf-8")
        return path

    return write


def test_json_and_status(written):
    done = audit(written(RECORDS), "--json")
    assert done.returncode == 0, done.stderr
    right, problem = json.loads(done.stdout)
    assert (right["id"], right["finding"], right["derived"]) == ("right", "agrees", "6.000 N")
    assert (problem["finding"], problem["formula"]) == ("agrees", "m*v")


def test_a_mistake_is_named_and_the_status_says_wrong(written, tmp_path):
    page = tmp_path / "page.html"
    done = audit(
        written(RECORDS),
        written(COSINE, "cosine.yaml"),
        written(LISTED, "l.json"),
        "--json",
        "--report",
        page,
    )
    assert done.returncode == 1
    *_, cosine, half = json.loads(done.stdout)
    assert cosine["finding"] == "wrong"
    assert cosine["violates"] == "Height"
    assert "sine and cosine are interchanged" in cosine["mistake"]
    assert half["mistake"] == "You took half of the radius"
    text = page.read_text(encoding="utf-8")
    assert "<math" in text
    assert "sine and cosine are interchanged" in text
    assert "15.3 m" in text


@pytest.mark.whole
@pytest.mark.parametrize("beside", ["", "below/../", "./"])
def test_a_path_from_where_one_stands(written, tmp_path, beside):
    written(RECORDS)
    written(LISTED, "l.json")
    (tmp_path / "below").mkdir()
    done = audit(f"{beside}records.yaml", f"{beside}l.json", "--json", "--report", "page.html", cwd=tmp_path)
    assert done.returncode == 1, done.stderr
    assert [each["id"] for each in json.loads(done.stdout)][:1] == ["right"]
    assert "You took half of the radius" in (tmp_path / "page.html").read_text(encoding="utf-8")


def test_a_bad_request(written):
    done = audit(written("- id: a\n  laws: [F = m a]\n  asked: F\n  published: 1 N\n"))
    assert done.returncode == 2
    assert "records.yaml:2" in done.stderr


@pytest.mark.whole
def test_other_bad_requests(written, tmp_path):
    assert audit(tmp_path / "nowhere.yaml").returncode == 2
    assert audit(written("hello", "bank.doc")).returncode == 2


PUBLISHED = (
    ("a", "8.6 kg m/s", "agrees"),
    ("a", "8.7 kg m/s", "last figure"),
    ("a", "17.2 kg m/s", "wrong"),
    ("a", "m*v", "agrees"),
    ("a", "the momentum", "cannot say"),
    ("a", "m*v^2/w", "wrong"),
    ("q", "1 N", "cannot say"),
)


@pytest.mark.whole
def test_a_problem_of_a_bank(written):
    records = "".join(
        f"- {{id: '{place}', problem: X12.5, given: {{v: 20 m/s}}, asked: {asked}, published: '{published}'}}\n"
        for place, (asked, published, _) in enumerate(PUBLISHED)
    )
    done = audit(written(records), "--json")
    assert [each["finding"] for each in json.loads(done.stdout)] == [finding for _, _, finding in PUBLISHED]


def test_a_page_of_a_key_in_which_nothing_agrees(written, tmp_path):
    page = tmp_path / "page.html"
    done = audit(written(LISTED), "--report", page)
    assert done.returncode == 1, done.stderr
    text = page.read_text(encoding="utf-8")
    assert "<h2>Wrong</h2>" in text
    assert "<h2>Agrees</h2>" not in text
