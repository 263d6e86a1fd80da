"""Both of Canvas's importers read the quiz, and what they read gives the marks that we give, all or nothing.

New Quizzes read by `instructure/qti`: with a checkout of it in COROLLARY_CANVAS_QTI, and Ruby, it is asked. Classic Quizzes read
what `instructure/QTIMigrationTool` makes of the package: with a checkout in COROLLARY_CANVAS_MIGRATION, and a Python that has lxml
in COROLLARY_CANVAS_PYTHON, it is asked, and the answers are taken off its files by the rule of canvas-lms
(`gems/plugins/qti_exporter/lib/qti/numeric_interaction.rb`, `choice_interaction.rb`). Canvas itself is not run.
"""

from __future__ import annotations

import io
import json
import os
import subprocess
import zipfile
from collections import Counter
from dataclasses import replace
from decimal import Decimal
from pathlib import Path
from xml.etree import ElementTree as Xml

import pytest

from corollary.render.exports import target
from corollary.render.lms_item import ChoiceAsked, LmsItem, NumbersAsked
from corollary.render.targets.canvas import scale_of

from .by_component import by_component

QTI = os.environ.get("COROLLARY_CANVAS_QTI", "")
MIGRATION = os.environ.get("COROLLARY_CANVAS_MIGRATION", "")
PYTHON = os.environ.get("COROLLARY_CANVAS_PYTHON", "python3")
DRIVER = Path(__file__).with_name("canvas_qti.rb")
CLIENTS = ("canvas-new", "canvas-classic")
FEW = ("X12.2", "X12.10", "X12.4", "S12.2")
V2 = "{http://www.imsglobal.org/xsd/imsqti_v2p1}"

Answers = list[tuple[Decimal, Decimal]] | set[str]
"""What is right: numbers between two, or the idents of options."""


@pytest.fixture
def folder(chapter_items, tmp_path) -> Path:
    made = target("canvas").items
    assert made is not None
    archive = made("chapter", chapter_items, False).files["chapter-canvas.zip"]
    with zipfile.ZipFile(io.BytesIO(archive)) as opened:
        opened.extractall(tmp_path / "package")
    return tmp_path / "package"


def by_new_quizzes(folder: Path) -> tuple[str, dict[str, Answers]]:
    run = subprocess.run(["ruby", DRIVER, QTI, folder], capture_output=True, text=True, check=False)
    assert run.returncode == 0, run.stderr[-2000:]
    told = json.loads(run.stdout)
    found: dict[str, Answers] = {}
    for ident, item in told["items"].items():
        assert "<img" not in item["body"] or 'src="figures/' in item["body"]
        match item["type"]:
            case "NumericInteraction":
                found[ident] = [_between(each) for each in item["scoring"]]
            case "ChoiceInteraction":
                found[ident] = {each["values"] for each in item["scoring"]}
            case other:
                assert other == "StringInteraction"
    return f"qti {told['version']}", found


def _between(scoring: dict) -> tuple[Decimal, Decimal]:
    if scoring["type"] == "withinARange":
        return Decimal(scoring["start"]), Decimal(scoring["end"])
    assert (scoring["type"], scoring["margin_type"]) == ("marginOfError", "absolute")
    value, margin = Decimal(scoring["value"]), Decimal(scoring["margin"])
    return value - margin, value + margin


def by_classic_quizzes(folder: Path) -> tuple[str, dict[str, Answers]]:
    made = folder.parent / "migrated"
    command = [PYTHON, "migrate.py", "--nogui", "--ucvars", "--overwrite", f"--cpout={made}", folder]
    run = subprocess.run(command, cwd=MIGRATION, capture_output=True, text=True, check=False)
    assert run.returncode == 0, run.stderr[-2000:]
    found: dict[str, Answers] = {}
    for path in (made / "assessmentItems").glob("*.xml"):
        item = Xml.parse(path).getroot()
        fields = {
            each.get("name"): each.get("value")
            for each in item.iter()
            if each.tag.endswith("instructureField")
        }
        rules = [
            each
            for each in item.iter(f"{V2}responseIf")
            if each.find(f"{V2}setOutcomeValue[@identifier='SCORE']")
        ]
        match fields["question_type"]:
            case "numerical_question":
                found[path.stem] = [numeric for rule in rules if (numeric := _numeric(rule))]
            case "multiple_choice_question":
                found[path.stem] = {
                    each.findtext(f"{V2}baseValue", "").removeprefix("RESPONSE_")
                    for rule in rules
                    for each in rule.iter(f"{V2}match")
                }
    version = next(line for line in run.stdout.splitlines() if line.startswith("Version"))
    return f"QTIMigrationTool {version.removeprefix('Version: ')}", found


def _numeric(rule: Xml.Element) -> tuple[Decimal, Decimal] | None:
    """As numeric_interaction.rb does: the margin is how far the upper bound is from what is exact."""

    def bound(kind: str) -> Decimal | None:
        text = rule.findtext(f".//{V2}and/{V2}customOperator[@class='{kind}']/{V2}baseValue")
        return None if text is None else Decimal(text)

    if rule.find(f"{V2}or") is not None:
        exact = Decimal(rule.findtext(f"{V2}or/{V2}stringMatch/{V2}baseValue", ""))
        upper = bound("varlte")
        assert upper is not None
        return exact - (upper - exact), upper
    low, high = bound("vargte"), bound("varlte")
    return None if low is None or high is None else (low, high)


def marked(answers: Answers, typed: str) -> bool:
    """Classic Quizzes round what is typed to four decimals; New Quizzes don't, and then it makes no difference."""
    if isinstance(answers, set):
        return typed in answers
    try:
        number = round(Decimal(typed), 4)
    except ArithmeticError:  # "", or a comma
        return False
    return any(low <= number <= high for low, high in answers)


def share_given(item: LmsItem, asked, row, found: dict[str, Answers]) -> float:
    pool = f"{item.exercise.problem.name}_{row.part.id}"
    if isinstance(asked, ChoiceAsked):
        letters = [each.option.letter for each in asked.options]
        typed = str(101 + letters.index(row.fields[0])) if row.fields[0] else ""
        return float(marked(found[f"{pool}_{item.number}"], typed))
    scale = scale_of(asked)
    names = [f"{pool}_{at}" for at in range(1, len(row.fields) + 1)] if len(row.fields) > 1 else [pool]
    right = [
        marked(found[f"{name}_{item.number}"], text and _as_typed(scale, text))
        for name, text in zip(names, row.fields, strict=True)
    ]
    return sum(right) / len(right)


def _as_typed(scale, text: str) -> str:
    return text if "," in text else f"{Decimal(text).scaleb(-scale.power):f}"


def alike(asked, row, theirs: float) -> str:
    """equal, or by what name the difference goes; "" for one without a name."""
    wanted = row.share
    if abs(theirs - wanted) < 1e-4:
        return "equal"
    if row.sort == "comma":
        return "comma"
    if isinstance(asked, NumbersAsked) and len(asked.components) > 1:
        return "by component" if abs(_all_or_nothing(asked, row) - theirs) < 1e-4 else ""
    return "all or nothing" if theirs == 0 and 0 < wanted < 1 else ""


def _all_or_nothing(asked: NumbersAsked, row) -> float:
    """What right components earn where each is a question."""
    right = tuple(mark for mark in asked.marks if mark.share == 1)
    return by_component(replace(asked, marks=right), [float(text) for text in row.fields if text])


@pytest.mark.client
@pytest.mark.parametrize(
    ("client", "name", "ask"),
    [
        pytest.param(
            CLIENTS[0], "Canvas, New Quizzes' importer", by_new_quizzes,
            marks=pytest.mark.skipif(not QTI, reason="no COROLLARY_CANVAS_QTI"),
        ),
        pytest.param(
            CLIENTS[1], "Canvas, Classic Quizzes' importer", by_classic_quizzes,
            marks=pytest.mark.skipif(not MIGRATION, reason="no COROLLARY_CANVAS_MIGRATION"),
        ),
    ],
)  # fmt: skip
def test_questions_earn_what_we_give(client, name, ask, chapter_items, folder, fingerprint, record, table):
    version, found = ask(folder)
    items, nameless = {}, []
    for item in chapter_items:
        asked = {
            each.prompt.part.id: each for each in item.parts if isinstance(each, NumbersAsked | ChoiceAsked)
        }
        counted, code = Counter(), item.exercise.problem.code
        for row in table(item):
            theirs = share_given(item, asked[row.part.id], row, found)
            how = alike(asked[row.part.id], row, theirs)
            counted[how or "different"] += 1
            if not how:
                nameless.append((code, row.part.id, row.sort, row.fields, row.share, theirs))
        if asked:
            items[code] = {"hash": fingerprint(item), "parts": len(asked), **counted}
    assert not nameless
    record(client, {"client": name, "version": version, "items": items})


@pytest.mark.parametrize("code", FEW)
def test_what_decides_marks_is_what_canvas_was_asked(code, make_item, fingerprint, recorded):
    for client in CLIENTS:
        items = recorded(client)["items"]
        if code in items:
            assert items[code]["hash"] == fingerprint(make_item(code))


@pytest.mark.whole
def test_nothing_has_changed_since_canvas_was_asked(chapter_items, fingerprint, recorded):
    found = {each.exercise.problem.code: fingerprint(each) for each in chapter_items}
    for client in CLIENTS:
        asked = {code: each["hash"] for code, each in recorded(client)["items"].items()}
        assert asked
        assert asked == {code: found[code] for code in asked}


def test_canvas_gave_no_mark_of_its_own(recorded):
    for client in CLIENTS:
        assert not [code for code, each in recorded(client)["items"].items() if each.get("different")]
