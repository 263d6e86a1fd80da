"""Moodle XML: numerical questions, calculated ones with their datasets, multiple choice among numbers."""

from __future__ import annotations

import re
from dataclasses import replace
from pathlib import Path
from xml.etree.ElementTree import Element

from corollary.audit.forgiven import forgiven_absolutely
from corollary.audit.readers.straight_line import NotRead, StraightLine, unrounded
from corollary.audit.record import MOST_RECORDS, ExerciseRecord, ForgivenError
from corollary.audit.text_file import words_of, xml_of
from corollary.problem.diagnostic import Diagnostic, Malformed

WILDCARD = re.compile(r"\{([A-Za-z]\w*)\}")
NOT_QUESTIONS = {"category", "description"}


def moodle_records(path: Path) -> tuple[ExerciseRecord, ...]:
    """The questions of a file. Raises Malformed."""
    root = xml_of(path)
    if root.tag != "quiz":
        raise Malformed(
            [Diagnostic(path, 1, f"is not an export of a Moodle question bank: its root is <{root.tag}>")]
        )
    questions = [each for each in root.findall("question") if each.get("type") not in NOT_QUESTIONS]
    if len(questions) > MOST_RECORDS:
        raise Malformed([Diagnostic(path, 1, f"has more than {MOST_RECORDS} questions; divide it")])
    return tuple(_record(path, each, place) for place, each in enumerate(questions, 1))


def _record(path: Path, question: Element, place: int) -> ExerciseRecord:
    name = words_of(question.findtext("idnumber") or question.findtext("name/text") or f"question {place}")
    statement = words_of(question.findtext("questiontext/text") or "")
    bare = ExerciseRecord(name, path, 1, statement=statement)
    try:
        match question.get("type"):
            case "numerical":
                published = f"{_right(question)} {_unit(question)}".strip()
                return replace(bare, published=(published,), forgives=(_forgiven(question),))
            case "shortanswer":
                return replace(bare, published=(_with_digits(_right(question)),))
            case "calculated" | "calculatedsimple":
                return _calculated(bare, question)
            case "multichoice":
                return replace(bare, published=(_choice(question),))
            case kind:
                raise NotRead(f"questions of type {kind} are not read")
    except NotRead as error:
        return replace(bare, unread=str(error))


def _right(question: Element) -> str:
    """The text of the one answer with full marks. Raises NotRead."""
    full = [each for each in question.findall("answer") if _number_of(each.get("fraction")) == 100]
    texts = {words_of(each.findtext("text") or "") for each in full}
    if len(texts) != 1:
        raise NotRead(f"{len(texts)} different answers earn full marks")
    (text,) = texts
    if text == "*":
        raise NotRead("every answer earns full marks")
    return text


def _forgiven(question: Element) -> ForgivenError | None:
    """What the one answer with full marks forgives; where it stands twice, what either does."""
    full = [each for each in question.findall("answer") if _number_of(each.get("fraction")) == 100]
    stated = [forgiven_absolutely(each.findtext("tolerance") or "") for each in full]
    return None if None in stated else max(filter(None, stated), key=lambda each: each.absolute, default=None)


def _number_of(text: str | None) -> float:
    """Raises NotRead."""
    try:
        return float(text or 0)
    except ValueError:
        raise NotRead(f"{text!r} stands where a number belongs") from None


def _unit(question: Element) -> str:
    """The unit in which a bare number is meant: the one with the multiplier 1. Raises NotRead where there are only others."""
    units = question.findall("units/unit")
    for unit in units:
        if _number_of(unit.findtext("multiplier")) == 1:
            return (unit.findtext("unit_name") or "").strip()
    if units:
        raise NotRead("none of its units has the multiplier 1")
    return ""


def _calculated(bare: ExerciseRecord, question: Element) -> ExerciseRecord:
    program = StraightLine()
    for dataset in question.findall("dataset_definitions/dataset_definition"):
        letter = (dataset.findtext("name/text") or "").strip()
        low, high = (dataset.findtext(f"{name}/text") or "" for name in ("minimum", "maximum"))
        items = [
            (each.findtext("value") or "").strip() for each in dataset.findall("dataset_items/dataset_item")
        ]
        if items and len(set(items)) > 1:
            program.draw_among(letter, items)
        else:
            program.draw(letter, low, high)
    key = _right(question)
    if "^" in key:
        raise NotRead("^ is not a power in a formula of Moodle's, pow is")
    key = unrounded(key, {"round"})
    found = program.key(WILDCARD.sub(r"\1", key))
    return replace(bare, given=found.drawn, published=(found.text,), key_unit=_unit(question))


def _choice(question: Element) -> str:
    if (question.findtext("single") or "true").strip() not in {"true", "1"}:
        raise NotRead("several options may be chosen")
    return _with_digits(_right(question))


def _with_digits(text: str) -> str:
    if not re.search(r"\d", text):
        raise NotRead(f"the right answer, {text!r}, is not a number")
    return text
