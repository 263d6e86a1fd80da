"""What a student reads of one exercise in each format before it is answered, as text."""

from __future__ import annotations

import re
from html import unescape
from io import BytesIO
from xml.etree import ElementTree
from zipfile import ZipFile

from corollary.grading.key import Key
from corollary.grading.solutions import Solutions
from corollary.notebook.notebook import file_text, notebook
from corollary.notebook.worksheet import Exercise, worksheet
from corollary.practice.practice import Posed
from corollary.problem.problem_set import ProblemSet, Scheme
from corollary.problem.roster import Student
from corollary.render.lms_item import item
from corollary.render.page import drawing
from corollary.render.practice_page import exercise_piece
from corollary.render.targets import html, md, moodle, qti, text

FIELD = re.compile(r"\{\d+:[A-Z_]+:(?:\\.|[^\\}])*\}")
"""A field in the text of a Moodle question: its answers stand in it, and are not shown."""
NOBODY = Student("", "")
BODY = re.compile(r"<itemBody>.*?</itemBody>", re.DOTALL)


def question_texts(solutions: Solutions, key: Key) -> dict[str, str]:
    """By format; what an LMS keeps to itself, such as the answers of a question, is left out."""
    asked = Posed(key).exercise
    one = item(solutions, key.variant, 1, 1.0, Scheme())
    found = {
        "the notebook": _notebook(asked),
        "the HTML page": html.write_exercise(asked, NOBODY, ""),
        "the Markdown": md.write_exercise(asked, NOBODY, ""),
        "the text": text.write_exercise(asked, NOBODY, ""),
        "the practise page": exercise_piece(Posed(key)),
    }
    if asked.figure:
        found["the figure"] = f"{asked.figure_alt} {drawing(asked)}"
    for apart in (False, True):
        way = ", each part alone" if apart else ""
        (questions,) = moodle.write_items("texts", [one], apart).files.values()
        if shown := _moodle(questions):
            found[f"the Moodle question{way}"] = shown
    if shown := _qti(qti.write_items("texts", [one], apart=False).files["texts-qti.zip"]):
        found["the QTI item"] = shown
    return found


def _notebook(asked: Exercise) -> str:
    problem = asked.problem
    alone = ProblemSet(problem.name, problem.title, "", (problem,), (1.0,), None, Scheme(), "no")
    nb = notebook(worksheet(alone, NOBODY, [asked.variant]))
    return "\n".join(cell.source for cell in nb.cells) + file_text(nb).replace("\\n", "\n")


def _qti(archive: bytes) -> str:
    with ZipFile(BytesIO(archive)) as files:
        items = [files.read(name).decode() for name in files.namelist() if name.endswith("-1.xml")]
    return " ".join(body for each in items for body in BODY.findall(each))


def _moodle(questions: bytes) -> str:
    found = ElementTree.fromstring(questions).findall("question")
    texts = [each.findtext("questiontext/text") or "" for each in found]
    options = [
        answer.findtext("text") or ""
        for each in found
        if each.get("type") == "multichoice"
        for answer in each.findall("answer")
    ]
    return unescape(FIELD.sub(" ", " ".join([*texts, *options])))
