"""TAO's QTI SDK finds the items valid by QTI's schemas, and gives the marks that we give on everything the answer tables try.

With a checkout of oat-sa/qti-sdk in COROLLARY_QTI_SDK it is asked, and its answers are written to recorded/qti.json.
"""

from __future__ import annotations

import io
import json
import os
import subprocess
import zipfile
from pathlib import Path

import pytest

from .qti_attempts import attempts, compared, package, unpack
from .xml_structure import structure

SDK = os.environ.get("COROLLARY_QTI_SDK", "")
DRIVER = Path(__file__).with_name("qti_sdk.php")
FEW = ("X12.2", "X12.10", "X12.4", "S12.2")


def version() -> str:
    run = subprocess.run(
        ["git", "-C", SDK, "describe", "--always"], capture_output=True, text=True, check=False
    )
    return run.stdout.strip() or os.environ.get("COROLLARY_QTI_SDK_VERSION", "unknown")


def structure_of(archive: bytes) -> set[str]:
    """Of all items together."""
    with zipfile.ZipFile(io.BytesIO(archive)) as opened:
        items = [name for name in opened.namelist() if name.endswith("-1.xml")]
        return set().union(*(structure(opened.read(name)) for name in items))


@pytest.mark.client
@pytest.mark.skipif(not SDK, reason="no COROLLARY_QTI_SDK")
def test_items_earn_what_we_give(chapter_items, fingerprint, record, table, tmp_path):
    archive = package(chapter_items)
    unpack(archive, tmp_path)
    tried = attempts(chapter_items, table, archive)
    asked = [
        {
            "item": each.file,
            "responses": [
                {
                    name: ["identifier" if each.is_choice(row) else "float", text]
                    for name, text in filled.items()
                }
                for row, filled in zip(each.rows, each.responses(), strict=True)
            ],
        }
        for each in tried
    ]
    (tmp_path / "attempts.json").write_text(json.dumps(asked), encoding="utf-8")
    command = ["php", "-d", "memory_limit=2G", DRIVER, SDK, tmp_path, tmp_path / "attempts.json"]
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    assert run.returncode == 0, run.stdout[-2000:] + run.stderr[-2000:]
    items, nameless = compared(tried, json.loads(run.stdout)["marks"], fingerprint)
    assert not nameless
    record("qti-structure", {"valid": sorted(structure_of(archive))})
    record("qti", {"client": "QTI 2.1, TAO's qti-sdk", "version": version(), "items": items})


@pytest.mark.parametrize("code", FEW)
def test_what_decides_marks_is_what_tao_was_asked(code, make_item, fingerprint, recorded):
    items = recorded("qti")["items"]
    if code in items:
        assert items[code]["hash"] == fingerprint(make_item(code))


def test_items_are_built_as_those_that_the_schema_found_valid(make_item, recorded):
    items = [make_item(code) for code in FEW]
    assert structure_of(package(items)) <= set(recorded("qti-structure")["valid"])
    assert structure_of(package(items, apart=True)) <= set(recorded("qti-structure")["valid"])


WITH_INDEX = {"mrow > mroot", "mroot > mrow", "mroot > mn"}
"""Roots with an index, such as a cube root: MathML's schema has them, and the SDK has not been asked about them yet."""


@pytest.mark.whole
def test_every_item_is_built_as_those_that_the_schema_found_valid(chapter_items, recorded):
    found = structure_of(package(chapter_items, apart=True)) - WITH_INDEX
    assert found <= set(recorded("qti-structure")["valid"])


@pytest.mark.whole
def test_nothing_has_changed_since_tao_was_asked(chapter_items, fingerprint, recorded):
    items = recorded("qti")["items"]
    assert items
    found = {each.exercise.problem.code: fingerprint(each) for each in chapter_items}
    assert {code: each["hash"] for code, each in items.items()} == {code: found[code] for code in items}


def test_tao_gave_no_mark_of_its_own(recorded):
    assert not [code for code, each in recorded("qti")["items"].items() if each.get("different")]
