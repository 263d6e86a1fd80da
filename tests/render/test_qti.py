"""Items in QTI 2.1: an archive that its manifest describes, ranges in place of tolerances, and one item drawn of each problem."""

from __future__ import annotations

import io
import re
import zipfile
from xml.etree import ElementTree as Xml

import pytest

from corollary.grading.solutions import Solutions
from corollary.problem.bank import chapter_bank, home
from corollary.problem.problem_set import Scheme
from corollary.problem.variant import at
from corollary.render.exports import target
from corollary.render.lms_item import item
from corollary.render.qti_item import float_text

QTI = "{http://www.imsglobal.org/xsd/imsqti_v2p1}"
SOLUTIONS = Solutions(chapter_bank())


def written(*codes: str, variants: int = 1, apart: bool = False):
    made = target("qti").items
    assert made is not None
    items = [
        item(SOLUTIONS, at(home(None, code)[1], 40 * number), number, 1.0, Scheme())
        for code in codes
        for number in range(1, variants + 1)
    ]
    found = made("few", items, apart)
    archive = zipfile.ZipFile(io.BytesIO(found.files["few-qti.zip"]))
    return found, {name: archive.read(name).decode() for name in archive.namelist()}


def test_the_manifest_names_every_file_and_the_test_draws_one_variant():
    _, files = written("X12.5", "X12.7", variants=2)
    named = re.findall(r'<file href="([^"]+)"', files["imsmanifest.xml"])
    assert sorted([*named, "imsmanifest.xml"]) == sorted(files)
    test = Xml.fromstring(files["test.xml"])
    sections = test.findall(f".//{QTI}assessmentSection")
    assert [len(each.findall(f"{QTI}assessmentItemRef")) for each in sections] == [2, 2]
    assert all(each.find(f"{QTI}selection").get("select") == "1" for each in sections)
    assert files["kicking_a_ball-1.xml"] != files["kicking_a_ball-2.xml"]


def test_marks_are_ranges_and_every_outcome_is_declared():
    _, files = written("X12.7")
    text = next(
        text for name, text in files.items() if name.startswith("ball_reflected") and name.endswith(".xml")
    )
    root = Xml.fromstring(text)
    assert not root.findall(f".//{QTI}equal")
    declared = {each.get("identifier") for each in root.iter() if each.tag.endswith("Declaration")}
    used = {each.get("identifier") for each in root.iter(f"{QTI}variable")}
    used |= {each.get("identifier") for each in root.iter(f"{QTI}setOutcomeValue")}
    assert used <= declared
    shown = {each.get("identifier") for each in root.iter(f"{QTI}modalFeedback")}
    said = {each.text for each in root.iter(f"{QTI}baseValue") if each.get("baseType") == "identifier"}
    assert shown == said
    assert len(list(root.iter(f"{QTI}textEntryInteraction"))) == 7
    assert "<sum><product>" in text  # components are judged together
    within = [each.findall(f"{QTI}not/{QTI}isNull/{QTI}variable") for each in root.iter(f"{QTI}and")]
    assert all(within)  # a blank field is nothing, also to a player that takes it for 0
    assert f'src="{next(name for name in files if name.endswith(".svg"))}"' in text


def test_parts_are_carried_or_refused_by_name():
    found, files = written("P12.14", apart=True)
    assert {each.part for each in found.parts if not each.how} == {"g", "h", "j"}
    items = [name for name in files if name.endswith("-1.xml")]
    assert len(items) == len([each for each in found.parts if each.how])
    assert "extendedTextInteraction" in files[next(name for name in items if name.endswith("-k-1.xml"))]


@pytest.mark.parametrize(
    ("value", "text"), [(4e-6, "4.0e-06"), (-0.0, "0.0"), (12.0, "12.0"), (1.5e20, "1.5e+20"), (-8.6, "-8.6")]
)
def test_floats_have_a_point(value, text):
    assert float_text(value) == text
