"""A quiz for Canvas: QTI 1.2 as Canvas writes it, numbers in a unit that four decimals suffice for, parts carried or refused by name."""

from __future__ import annotations

import io
import zipfile
from xml.etree import ElementTree as Xml

import pytest

from corollary.grading.solutions import Solutions
from corollary.messages import language
from corollary.problem.bank import chapter_bank, home
from corollary.problem.problem_set import Scheme
from corollary.problem.variant import at
from corollary.render.exports import target
from corollary.render.lms_item import item
from corollary.render.targets.canvas import CanvasOption, CanvasQuestion, typed_scale
from corollary.units.unit import unit

QTI = "{http://www.imsglobal.org/xsd/ims_qtiasiv1p2}"
SOLUTIONS = Solutions(chapter_bank())


def written(*codes: str, variants: int = 1):
    made = target("canvas").items
    assert made is not None
    items = [
        item(SOLUTIONS, at(home(None, code)[1], 40 * number), number, 1.0, Scheme())
        for code in codes
        for number in range(1, variants + 1)
    ]
    found = made("few", items, False)
    archive = zipfile.ZipFile(io.BytesIO(found.files["few-canvas.zip"]))
    return found, {name: archive.read(name).decode() for name in archive.namelist()}


def kinds(root: Xml.Element) -> list[str]:
    return [
        field.findtext(f"{QTI}fieldentry", "")
        for field in root.iter(f"{QTI}qtimetadatafield")
        if field.findtext(f"{QTI}fieldlabel") == "question_type"
    ]


def test_each_part_is_a_question_and_its_variants_a_pool():
    found, files = written("X12.5", variants=2)
    quiz = Xml.fromstring(files["few/few.xml"])
    assert kinds(quiz) == ["numerical_question"] * 8
    pools = quiz.findall(f".//{QTI}section/{QTI}section")
    assert [len(pool.findall(f"{QTI}item")) for pool in pools] == [2, 2, 2, 2]
    assert [pool.findtext(f".//{QTI}selection_number") for pool in pools] == ["1"] * 4
    assert [pool.findtext(f".//{QTI}points_per_item") for pool in pools] == ["1", "1", "1", "2"]
    assert any("its numbers differ" in each for each in found.lost)
    assert not any("its numbers differ" in each for each in written("X12.5")[0].lost)


def test_what_is_right_is_a_number_with_its_margin_and_nothing_else_earns():
    _, files = written("X12.5")
    first = next(Xml.fromstring(files["few/few.xml"]).iter(f"{QTI}item"))
    (scored,) = [each for each in first.iter(f"{QTI}respcondition") if each.find(f"{QTI}setvar") is not None]
    low, right, high = (
        float(scored.findtext(f".//{QTI}{kind}", "")) for kind in ("vargte", "varequal", "varlte")
    )
    wanted = item(SOLUTIONS, at(home(None, "X12.5")[1], 40), 1, 1.0, Scheme()).parts[0].marks[0]
    assert (right, high - right) == pytest.approx((wanted.values[0], wanted.reach), rel=1e-6)
    assert right - low == pytest.approx(high - right, rel=1e-6)


def test_the_manifest_names_the_figures_that_questions_show():
    _, files = written("X12.5", "X12.7")
    assert all(
        f'<file href="{name}"/>' in files["imsmanifest.xml"] for name in files if name != "imsmanifest.xml"
    )
    quiz = files["few/few.xml"]
    for name in [name for name in files if name.startswith("figures/")]:
        assert f'&lt;img src="{name}"' in quiz
    assert "mspace" not in quiz


def test_parts_are_carried_or_refused_by_name():
    found, files = written("P12.14", "S12.2")
    refused = {each.part: each.lost for each in found.parts if not each.how}
    assert set(refused) == {"g", "h", "j"}
    assert all(refused.values())
    quiz = Xml.fromstring(files["few/few.xml"])
    assert set(kinds(quiz)) == {"numerical_question", "multiple_choice_question", "essay_question"}
    choice = next(each for each in quiz.iter(f"{QTI}item") if kinds(each) == ["multiple_choice_question"])
    shown = {each.get("linkrefid") for each in choice.iter(f"{QTI}displayfeedback")}
    assert shown == {each.get("ident") for each in choice.iter(f"{QTI}itemfeedback")}
    assert len(shown) >= 3


def test_a_text_that_canvas_would_replace_is_not_sent():
    assert CanvasQuestion("q", "Title", 1.0, "x" * 15_900, "").fits
    assert not CanvasQuestion("q", "Title", 1.0, "x" * 16_100, "").fits


def test_markup_survives_as_text():
    options = [CanvasOption("<em>p</em> < 0", True, ""), CanvasOption("q", False, "Look & see.")]
    root = Xml.fromstring(CanvasQuestion('a"b', "<1>", 2.5, "<p>A & B</p>", "", options=options).xml())
    assert [each.text for each in root.iter("mattext")] == [
        "<div><p>A & B</p></div>", "<em>p</em> < 0", "q", "Look & see."
    ]  # fmt: skip
    assert root.attrib == {"ident": 'a"b', "title": "<1>"}


@pytest.mark.parametrize(
    ("text", "value", "reach", "asked", "typed"),
    [
        ("m/s", 3.0, 0.03, "m/s", 3.0),
        ("N", 4e-6, 4e-8, "µN", 4.0),
        ("kg", 0.002, 2e-5, "g", 2.0),
        ("kN", 3e-5, 3e-7, "mN", 30.0),
        ("kg*m/s", 0.0047, 5e-5, "g m/s", 4.7),
        ("J", 5e9, 5e7, "GJ", 5.0),
        ("deg", 0.01, 1e-4, "10⁻³ °", 10.0),
        ("1", 0.00012, 1e-6, "10⁻⁶", 120.0),
    ],
)
def test_numbers_are_typed_in_a_unit_that_four_decimals_suffice_for(text, value, reach, asked, typed):
    scale = typed_scale(unit(text), [value], reach)
    assert (scale.text, scale.typed(value)) == (asked, pytest.approx(typed))
    assert scale.typed(reach) >= 0.005  # rounding moves 0.00005


def test_the_rule_for_decimals_is_in_the_language_of_the_question():
    with language("de"):
        _, files = written("X12.5")
    assert "Dezimalkomma" in files["few/few.xml"]
    assert "decimal point" in written("X12.5")[1]["few/few.xml"]
