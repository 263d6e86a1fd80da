"""STACK's own question type and potential response trees, with Maxima, give the marks that we give on formulas.

With a checkout of maths/moodle-qtype_stack in COROLLARY_STACK, PHP with mbstring and Symfony's Yaml, and Maxima, it is asked, and
its answers are written to recorded/stack.json.
"""

from __future__ import annotations

import hashlib
import json
import os
import subprocess
from collections import Counter
from pathlib import Path

import pytest

from corollary.formula.plain_text import text
from corollary.grading.from_json import from_json
from corollary.grading.judge import judge
from corollary.grading.points import grade
from corollary.render.exports import target
from corollary.render.lms_item import LmsItem, NotAsked

STACK = os.environ.get("COROLLARY_STACK", "")
DRIVER = Path(__file__).with_name("stack.php")
ASKED = {"X12.1": ("v + v", "v*2", "4*v/2", "2*v*M/M", "sqrt(4*v^2)", "3*v", "2*M*v", "2*v^2", "2*v +", "")}
"""Problems with a formula, and what else is typed than what is known to be right or wrong."""


def formulas(item: LmsItem) -> list[NotAsked]:
    return [each for each in item.parts if isinstance(each, NotAsked) and each.formulas]


def decides(item: LmsItem) -> str:
    """A hash of all that decides marks."""
    found = [
        (each.prompt.part.id, each.prompt.out_of, each.positive,
         [(credit.share, [text(tree) for tree in credit.trees]) for credit in each.formulas])
        for each in formulas(item)
    ]  # fmt: skip
    return hashlib.sha256(json.dumps(found).encode()).hexdigest()[:16]


def ours(item: LmsItem, part: str, typed: str) -> float:
    found = grade(item.key, judge(item.key, {part: from_json(typed or None)}))[part]
    return found.points / found.out_of


@pytest.mark.client
@pytest.mark.skipif(not STACK, reason="no COROLLARY_STACK")
def test_formulas_earn_what_we_give(make_item, record, tmp_path):
    made = target("moodle-stack").items
    assert made is not None
    items = [make_item(code) for code in ASKED]
    attempts, tried = [], []
    for item in items:
        problem = item.exercise.problem
        for asked in formulas(item):
            rows = [text(credit.trees[0]) for credit in asked.formulas] + list(ASKED[problem.code])
            name = f"{problem.code} {problem.title}, ({asked.prompt.part.heading_letter}), 1"
            attempts.append({"question": name, "responses": [{"ans1": row} for row in rows]})
            tried.append((item, asked.prompt.part.id, rows))
    (tmp_path / "questions.xml").write_bytes(made("few", items, False).files["few-moodle-stack.xml"])
    (tmp_path / "attempts.json").write_text(json.dumps(attempts), encoding="utf-8")
    (tmp_path / "maxima").mkdir()
    command = [
        "php",
        DRIVER,
        STACK,
        tmp_path / "maxima",
        tmp_path / "questions.xml",
        tmp_path / "attempts.json",
    ]
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    assert run.returncode == 0, run.stdout[-2000:] + run.stderr[-2000:]
    told, found, different = json.loads(run.stdout), {}, []
    for (item, part, rows), marks in zip(tried, told["marks"], strict=True):
        counted = Counter()
        for row, mark in zip(rows, marks, strict=True):
            share = ours(item, part, row)
            same = abs(share - (mark["score"] or 0.0)) < 1e-4
            counted["equal" if same else "different"] += 1
            different += [] if same else [(part, row, share, mark)]
        found[item.exercise.problem.code] = {"hash": decides(item), "parts": 1, **counted}
    assert not different
    record(
        "stack", {"client": "STACK's potential response trees", "version": told["version"], "items": found}
    )


def test_what_decides_marks_is_what_stack_was_asked(make_item, recorded):
    items = recorded("stack")["items"]
    assert set(items) == set(ASKED)
    for code, each in items.items():
        assert each["hash"] == decides(make_item(code))
        assert not each.get("different")
