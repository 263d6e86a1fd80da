"""Moodle's own importer and question engine give the marks that we give, on everything the answer tables try.

With the folder of an installed Moodle in COROLLARY_MOODLE it is asked, and its answers are written to recorded/moodle.json.
"""

from __future__ import annotations

import json
import os
import subprocess
from collections import Counter
from fractions import Fraction
from itertools import groupby
from pathlib import Path

import pytest

from corollary.grading.from_json import from_json
from corollary.grading.judge import judge
from corollary.grading.points import grade
from corollary.render.exports import target
from corollary.render.lms_item import ChoiceAsked, NumbersAsked
from corollary.render.targets.moodle import typed_units
from corollary.units.unit import show

from .by_component import by_component

MOODLE = os.environ.get("COROLLARY_MOODLE", "")
DRIVER = Path(__file__).with_name("moodle.php")
FEW = ("X12.2", "X12.10", "X12.4", "S12.2")


def ask(folder: Path, name: str, questions: bytes, attempts: list[dict]) -> dict:
    """What Moodle makes of the questions, and gives for the attempts."""
    (folder / f"{name}.xml").write_bytes(questions)
    (folder / f"{name}.json").write_text(json.dumps(attempts), encoding="utf-8")
    command = ["php", "-d", "memory_limit=2G", "-d", "display_errors=0", DRIVER, MOODLE]
    run = subprocess.run(
        [*command, folder / f"{name}.xml", folder / f"{name}.json"],
        capture_output=True,
        text=True,
        check=False,
    )
    assert run.returncode == 0, run.stdout[-2000:] + run.stderr[-2000:]
    return json.loads(run.stdout[run.stdout.index('{"version"') :])


def typed(asked, row, names: list[str]) -> dict[str, object]:
    """The fields of the question filled in: an option by its place."""
    if isinstance(asked, ChoiceAsked):
        letters = [each.option.letter for each in asked.options]
        return {names[0]: letters.index(row.fields[0]) if row.fields[0] else -1}
    return dict(zip(names, row.fields, strict=True))


def alike(asked, row, theirs: float) -> str:
    """equal, or by what name the difference goes; "" for one without a name."""
    if abs(theirs - row.share) < 1e-4:
        return "equal"
    if row.sort == "comma":
        return "comma"
    if isinstance(asked, NumbersAsked) and len(asked.components) > 1:
        expected = by_component(asked, [float(text) for text in row.fields])
        return "by component" if abs(expected - theirs) < 1e-4 else ""
    return ""


@pytest.mark.client
@pytest.mark.skipif(not MOODLE, reason="no COROLLARY_MOODLE")
def test_embedded_answers_earn_what_we_give(chapter_items, fingerprint, record, table, tmp_path):
    attempts, tried = [], []
    for item in chapter_items:
        fields = [each for each in item.parts if isinstance(each, NumbersAsked | ChoiceAsked)]
        if len(fields) < 2 and not (
            fields and isinstance(fields[0], NumbersAsked) and len(fields[0].components) > 1
        ):
            continue
        names, weights, place = {}, {}, 0
        for each in fields:
            count = len(each.components) if isinstance(each, NumbersAsked) else 1
            names[each.prompt.part.id] = [f"sub{place + at + 1}_answer" for at in range(count)]
            weights[each.prompt.part.id] = Fraction(each.prompt.out_of) / sum(
                Fraction(one.prompt.out_of) for one in fields
            )
            place += count
        by_part = {each.prompt.part.id: each for each in fields}
        rows = table(item)
        problem = item.exercise.problem
        responses = [typed(by_part[row.part.id], row, names[row.part.id]) for row in rows]
        attempts.append({"question": f"{problem.code} {problem.title}, 1", "responses": responses})
        tried.append((item, by_part, rows, weights))
    made = target("moodle").items
    assert made is not None
    found = ask(
        tmp_path, "embedded", made("chapter", chapter_items, False).files["chapter-moodle.xml"], attempts
    )
    result = {"client": "Moodle", "version": found["version"], "items": {}}
    nameless = []
    for (item, by_part, rows, weights), marks in zip(tried, found["marks"], strict=True):
        counted = Counter()
        for row, mark in zip(rows, marks, strict=True):
            theirs = 0.0 if mark is None else float(mark) / float(weights[row.part.id])
            how = alike(by_part[row.part.id], row, theirs)
            counted[how or "different"] += 1
            if not how:
                nameless.append(
                    (item.exercise.problem.code, row.part.id, row.sort, row.fields, row.share, theirs)
                )
        result["items"][item.exercise.problem.code] = {
            "hash": fingerprint(item),
            "parts": len(by_part),
            **counted,
        }
    assert not nameless
    record("moodle", result)


@pytest.mark.client
@pytest.mark.skipif(not MOODLE, reason="no COROLLARY_MOODLE")
def test_questions_apart_read_units(chapter_items, fingerprint, record, table, tmp_path):
    attempts, tried = [], []
    for item in chapter_items:
        problem, rows = item.exercise.problem, table(item)
        for asked in item.parts:
            if not isinstance(asked, NumbersAsked | ChoiceAsked):
                continue
            if isinstance(asked, NumbersAsked) and len(asked.components) > 1:
                continue
            part, texts = asked.prompt.part, []
            for row in [each for each in rows if each.part.id == part.id]:
                unit = (
                    f" {show(part.unit)}"
                    if isinstance(asked, NumbersAsked) and row.fields[0] and show(part.unit)
                    else ""
                )
                texts.append(
                    (
                        row.sort,
                        typed(asked, row, ["answer"]) if not unit else {"answer": row.fields[0] + unit},
                        row.share,
                    )
                )
            if isinstance(asked, NumbersAsked) and (units := typed_units(part.unit)):
                value = asked.marks[0].values[0]
                for name, size in units[1:]:
                    text = f"{value * size:.7g} {name}"
                    texts.append(("other unit", {"answer": text}, ours(item, part.id, text)))
                text = f"{value:.7g} kg*m^5"
                texts.append(("wrong unit", {"answer": text}, ours(item, part.id, text)))
                texts.append(("no unit", {"answer": f"{value:.7g}"}, 1.0))
            name = f"{problem.code} {problem.title}, ({part.heading_letter}), 1"
            attempts.append({"question": name, "responses": [each for _, each, _ in texts]})
            tried.append((problem.code, part.id, texts))
    made = target("moodle").items
    assert made is not None
    found = ask(tmp_path, "apart", made("chapter", chapter_items, True).files["chapter-moodle.xml"], attempts)
    counted, nameless = {}, []
    for (code, part, texts), marks in zip(tried, found["marks"], strict=True):
        for (sort, response, share), mark in zip(texts, marks, strict=True):
            theirs = float(mark or 0.0)
            how = "equal" if abs(theirs - share) < 1e-4 else sort if sort in ("comma", "no unit") else ""
            counted.setdefault(code, Counter())[how or "different"] += 1
            if not how:
                nameless.append((code, part, sort, response, share, theirs))
    assert not nameless
    by_code = {item.exercise.problem.code: fingerprint(item) for item in chapter_items}
    items = {
        code: {"hash": by_code[code], "parts": len(list(group)), **counted[code]}
        for code, group in groupby(tried, key=lambda each: each[0])
    }
    record("moodle-apart", {"client": "Moodle, --apart", "version": found["version"], "items": items})


def ours(item, part: str, text: str) -> float:
    found = grade(item.key, judge(item.key, {part: from_json(text)}))[part]
    return found.points / found.out_of


@pytest.mark.parametrize("code", FEW)
def test_what_decides_marks_is_what_moodle_was_asked(code, make_item, fingerprint, recorded):
    item = make_item(code)
    for client in ("moodle", "moodle-apart"):
        items = recorded(client)["items"]
        if code in items:
            assert items[code]["hash"] == fingerprint(item)


@pytest.mark.whole
def test_nothing_has_changed_since_moodle_was_asked(chapter_items, fingerprint, recorded):
    for client in ("moodle", "moodle-apart"):
        items = recorded(client)["items"]
        assert items
        found = {each.exercise.problem.code: fingerprint(each) for each in chapter_items}
        assert {code: each["hash"] for code, each in items.items()} == {code: found[code] for code in items}


def test_moodle_gave_no_mark_of_its_own(recorded):
    for client in ("moodle", "moodle-apart"):
        assert not [code for code, each in recorded(client)["items"].items() if each.get("different")]
