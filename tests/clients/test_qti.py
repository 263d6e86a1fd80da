"""TAO's QTI SDK finds the items valid by QTI's schemas, and gives the marks that we give on everything the answer tables try.

With a checkout of oat-sa/qti-sdk in COROLLARY_QTI_SDK it is asked, and its answers are written to recorded/qti.json.
"""

from __future__ import annotations

import io
import json
import os
import subprocess
import zipfile
from collections import Counter
from pathlib import Path

import pytest

from corollary.render.exports import target
from corollary.render.item import ChoiceAsked, NumbersAsked

SDK = os.environ.get("COROLLARY_QTI_SDK", "")
DRIVER = Path(__file__).with_name("qti_sdk.php")
FEW = ("X12.5", "X12.7", "X12.4", "S12.2")


def version() -> str:
    run = subprocess.run(
        ["git", "-C", SDK, "describe", "--always"], capture_output=True, text=True, check=False
    )
    return run.stdout.strip() or os.environ.get("COROLLARY_QTI_SDK_VERSION", "unknown")


@pytest.mark.client
@pytest.mark.skipif(not SDK, reason="no COROLLARY_QTI_SDK")
def test_items_earn_what_we_give(chapter_items, fingerprint, record, table, tmp_path):
    made = target("qti").items
    assert made is not None
    with zipfile.ZipFile(
        io.BytesIO(made("chapter", chapter_items, False).files["chapter-qti.zip"])
    ) as archive:
        archive.extractall(tmp_path)
    attempts, tried = [], []
    for item in chapter_items:
        parts = {
            each.prompt.part.id: each for each in item.parts if isinstance(each, NumbersAsked | ChoiceAsked)
        }
        rows = table(item)
        responses = [
            {
                f"RESPONSE_{row.part.id}_{at}": [
                    "identifier" if isinstance(parts[row.part.id], ChoiceAsked) else "float",
                    text,
                ]
                for at, text in enumerate(row.fields, 1)
            }
            for row in rows
        ]
        file = f"{item.exercise.problem.name}-1.xml"
        if (tmp_path / file).exists():
            attempts.append({"item": file, "responses": responses})
            tried.append((item, parts, rows))
    (tmp_path / "attempts.json").write_text(json.dumps(attempts), encoding="utf-8")
    command = ["php", "-d", "memory_limit=2G", DRIVER, SDK, tmp_path, tmp_path / "attempts.json"]
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    assert run.returncode == 0, run.stdout[-2000:] + run.stderr[-2000:]
    result = {"client": "QTI 2.1, TAO's qti-sdk", "version": version(), "items": {}}
    nameless = []
    for (item, parts, rows), marks in zip(tried, json.loads(run.stdout)["marks"], strict=True):
        counted = Counter()
        for row, mark in zip(rows, marks, strict=True):
            theirs = float(mark[f"SCORE_{row.part.id}"] or 0.0) / parts[row.part.id].prompt.out_of
            how = "equal" if abs(theirs - row.share) < 1e-4 else "comma" if row.sort == "comma" else ""
            counted[how or "different"] += 1
            if not how:
                nameless.append(
                    (item.exercise.problem.code, row.part.id, row.sort, row.fields, row.share, theirs)
                )
        if parts:
            result["items"][item.exercise.problem.code] = {
                "hash": fingerprint(item),
                "parts": len(parts),
                **counted,
            }
    assert not nameless
    record("qti", result)


@pytest.mark.parametrize("code", FEW)
def test_what_decides_marks_is_what_tao_was_asked(code, make_item, fingerprint, recorded):
    items = recorded("qti")["items"]
    if code in items:
        assert items[code]["hash"] == fingerprint(make_item(code))


@pytest.mark.whole
def test_nothing_has_changed_since_tao_was_asked(chapter_items, fingerprint, recorded):
    items = recorded("qti")["items"]
    assert items
    found = {each.exercise.problem.code: fingerprint(each) for each in chapter_items}
    assert {code: each["hash"] for code, each in items.items()} == {code: found[code] for code in items}


def test_tao_gave_no_mark_of_its_own(recorded):
    assert not [code for code, each in recorded("qti")["items"].items() if each.get("different")]
