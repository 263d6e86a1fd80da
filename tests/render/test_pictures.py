"""Pictures in a problem's text, in every format that students see: the very file, with its words; nothing else is fetched."""

from __future__ import annotations

import base64
import io
import re
import zipfile
from pathlib import Path
from xml.etree import ElementTree as Xml

import pytest
from PIL import Image

from corollary.grading.solutions import Solutions
from corollary.notebook.worksheet import exercise
from corollary.problem.bank import Bank, find
from corollary.problem.problem_set import Scheme
from corollary.problem.roster import Student
from corollary.problem.variant import chapter
from corollary.render.exports import target
from corollary.render.lms_item import item
from corollary.render.markdown import html
from corollary.render.pictures import as_svg

ADA = Student("ada", "Ada", "Lovelace")
PROBLEM = """\
---
code: X1
title: Cart
given:
  m: {is: mass, value: 2, from: 1, to: 5, step: 1, unit: kg}
  g: {is: gravity, value: 9.81, unit: m/s^2}
require: [m > 0, g > 0]
---
A cart of {{m}}, {{g}}: ![a red cart](cart.png)

## Weight {#a .value unit="N"}
Its weight? ![a field](field.jpg)

## Graph {#b .choice}
Which?
- (A) ![a rising line](up.svg)
- (B) none
"""
SOLUTION = '''\
"""A cart."""

from corollary.author import choice, derivation, step, unknowns
from corollary.laws import law


def derive(m, g):
    F = unknowns("F")
    return derivation(
        step(F, "Weight.", law("Weight", "F = m*g"), answers="a"),
        choice("b", "It rises.", a=True, b=False),
    )
'''
SVG = '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 9 9"><path d="M0 9L9 0" stroke="#000"/></svg>'


def picture(kind: str, size: tuple[int, int]) -> bytes:
    out = io.BytesIO()
    Image.new("RGB", size, "red").save(out, kind)
    return out.getvalue()


PNG, JPEG = picture("PNG", (120, 60)), picture("JPEG", (64, 48))


@pytest.fixture(scope="module")
def bank(tmp_path_factory) -> Bank:
    folder: Path = tmp_path_factory.mktemp("bank")
    for name in ("problems", "solutions"):
        (folder / name / "carts").mkdir(parents=True)
    problems = folder / "problems" / "carts"
    (problems / "cart.md").write_text(PROBLEM)
    (problems / "cart.png").write_bytes(PNG)
    (problems / "field.jpg").write_bytes(JPEG)
    (problems / "up.svg").write_text(SVG)
    (folder / "solutions" / "carts" / "cart.py").write_text(SOLUTION)
    return Bank(folder)


@pytest.fixture(scope="module")
def asked(bank):
    return exercise(chapter(find(bank, "X1")))


@pytest.fixture(scope="module")
def questions(bank):
    return item(Solutions(bank), chapter(find(bank, "X1")), 1, 1.0, Scheme())


@pytest.mark.parametrize("name", ["html", "md", "ipynb"])
def test_texts_carry_the_very_files(asked, name):
    write = target(name).exercise
    assert write is not None
    text = write(asked, ADA, "")
    assert isinstance(text, str)
    for raw, kind in ((PNG, "png"), (JPEG, "jpeg")):
        assert f"data:image/{kind};base64,{base64.b64encode(raw).decode()}" in text
    assert all(words in text for words in ("a red cart", "a field", "a rising line"))


def test_a_terminal_has_their_words(asked):
    write = target("text").exercise
    assert write is not None
    text = write(asked, ADA, "")
    assert "A cart of 2 kg, 9.81 m/s²: [Picture: a red cart]" in text
    assert "- (A) [Picture: a rising line]" in text


def test_paper_has_each_with_its_words(asked):
    write = target("pdf").exercise
    assert write is not None
    file = write(asked, ADA, "")
    assert isinstance(file, bytes)
    assert file.startswith(b"%PDF")
    assert len(re.findall(rb"/Subtype ?/Image", file)) == 2


def test_moodle_has_them_as_files_of_the_text_that_shows_them(questions):
    made = target("moodle").items
    assert made is not None
    together, apart = made("few", [questions], False), made("few", [questions], True)
    (_, question) = Xml.fromstring(together.files["few-moodle.xml"])
    files = {each.get("name"): base64.b64decode(each.text or "") for each in question.iter("file")}
    shown = re.findall(
        r"@@PLUGINFILE@@/([^\"]+)\" alt=\"([^\"]*)\"", question.findtext("questiontext/text") or ""
    )
    assert [(files[name], words) for name, words in shown] == [(PNG, "a red cart"), (JPEG, "a field")]
    assert [(each.part, bool(each.how)) for each in together.parts] == [("a", True), ("b", False)]
    assert "an option is a picture" in together.parts[1].lost
    assert all(each.how for each in apart.parts)
    choice = [
        each for each in Xml.fromstring(apart.files["few-moodle.xml"]) if each.get("type") == "multichoice"
    ]
    (answer, other) = choice[0].findall("answer")
    assert answer.find("file") is not None
    assert f"@@PLUGINFILE@@/{answer.find('file').get('name')}" in (answer.findtext("text") or "")
    assert other.find("file") is None


def test_qti_has_them_as_files_that_the_manifest_names(questions):
    made = target("qti").items
    assert made is not None
    archive = zipfile.ZipFile(io.BytesIO(made("few", [questions], False).files["few-qti.zip"]))
    item_text = archive.read("cart-1.xml").decode()
    shown = re.findall(r'<img src="([^"]+)" alt="([^"]+)"', item_text)
    assert [words for _, words in shown] == ["a red cart", "a field", "a rising line"]
    assert [archive.read(name) for name, _ in shown[:2]] == [PNG, JPEG]
    manifest = archive.read("imsmanifest.xml").decode()
    assert all(f'href="{name}"' in manifest for name, _ in shown)


def test_canvas_has_them_as_files_that_the_manifest_names(questions):
    made = target("canvas").items
    assert made is not None
    found = made("few", [questions], False)
    assert all(each.how for each in found.parts)
    archive = zipfile.ZipFile(io.BytesIO(found.files["few-canvas.zip"]))
    displayed = re.findall(r'&lt;img src="([^"]+)" alt="([^"]+)"', archive.read("few/few.xml").decode())
    assert {words: archive.read(name) for name, words in displayed[:2]} == {
        "a red cart": PNG,
        "a field": JPEG,
    }
    manifest = archive.read("imsmanifest.xml").decode()
    assert all(f'href="{name}"' in manifest for name, _ in displayed)


@pytest.mark.parametrize(
    "text",
    [
        "![x](https://example.org/a.png)",
        "![x](javascript:alert(1))",
        "![x](data:text/html;base64,AAAA)",
        "![x](file:///etc/passwd)",
        "![x](cart.png)",
    ],
)
def test_nothing_else_becomes_a_picture(text):
    assert "<img" not in html(text)


def test_words_in_brackets_cannot_end_the_tag():
    assert '<img src="data:image/png;base64,AAAA" alt="&quot;&gt;&lt;b&gt;"' in html(
        '!["><b>](data:image/png;base64,AAAA)'
    )


@pytest.mark.parametrize(("raw", "kind", "wide"), [(PNG, "png", 120), (JPEG, "jpeg", 64)])
def test_the_size_is_that_of_the_file(raw, kind, wide):
    svg, width = as_svg(f"data:image/{kind};base64,{base64.b64encode(raw).decode()}")
    assert width == wide
    assert f'width="{wide}"' in svg
