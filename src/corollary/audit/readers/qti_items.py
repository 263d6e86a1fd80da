"""QTI 2.1: an item whose key is a number, a number among options, or worked out from template variables."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from xml.etree.ElementTree import Element, tostring

from corollary.audit.readers.straight_line import NotRead, PublishedFormula, StraightLine
from corollary.audit.record import MOST_RECORDS, ExerciseRecord
from corollary.audit.text_file import local, words_of, xml_of
from corollary.problem.diagnostic import Diagnostic, Malformed

OPERATORS = {"sum": "+", "subtract": "-", "product": "*", "divide": "/", "power": "^"}
MATHEMATICAL = {"sin", "cos", "tan", "asin", "acos", "atan", "exp", "ln"}


def qti_records(path: Path) -> tuple[ExerciseRecord, ...]:
    """The items of a file. Raises Malformed."""
    root = xml_of(path)
    items = list(_items(root))
    if not items:
        raise Malformed([Diagnostic(path, 1, f"holds no assessmentItem of QTI; its root is <{local(root)}>")])
    if len(items) > MOST_RECORDS:
        raise Malformed([Diagnostic(path, 1, f"has more than {MOST_RECORDS} items; divide it")])
    return tuple(_record(path, each) for each in items)


def _items(element: Element) -> Iterator[Element]:
    """Those that stand in no other one."""
    if local(element) == "assessmentItem":
        yield element
        return
    for each in element:
        yield from _items(each)


def _record(path: Path, item: Element) -> ExerciseRecord:
    name = item.get("identifier") or path.stem
    body = _child(item, "itemBody")
    statement = words_of(tostring(body, encoding="unicode")) if body is not None else ""
    try:
        declared = [each for each in item if local(each) == "responseDeclaration"]
        if len(declared) != 1:
            raise NotRead(f"it declares {len(declared)} responses, and one is read")
        processing = _child(item, "templateProcessing")
        if processing is not None:
            key = _templates(processing)
            return ExerciseRecord(
                name,
                path,
                1,
                key.drawn,
                published=(key.text,),
                statement=statement,
                worked_out=key.worked_out,
            )
        return ExerciseRecord(name, path, 1, published=(_correct(item, declared[0]),), statement=statement)
    except NotRead as error:
        return ExerciseRecord(name, path, 1, statement=statement, unread=str(error))


def _child(element: Element, name: str) -> Element | None:
    return next((each for each in element if local(each) == name), None)


def _correct(item: Element, declared: Element) -> str:
    """The correct value; of an option its text. Raises NotRead."""
    response = _child(declared, "correctResponse")
    values = [words_of(each.text or "") for each in response] if response is not None else []
    if len(values) != 1:
        raise NotRead(f"it has {len(values)} correct values, and one is read")
    if declared.get("baseType") in {"float", "integer", "string"}:
        text = values[0]
    elif declared.get("baseType") == "identifier":
        chosen = (
            each
            for each in item.iter()
            if local(each) == "simpleChoice" and each.get("identifier") == values[0]
        )
        text = next((words_of(tostring(each, encoding="unicode")) for each in chosen), "")
    else:
        raise NotRead(f"a response of type {declared.get('baseType')} is not read")
    if not re.search(r"\d", text):
        raise NotRead(f"the correct value, {text!r}, is not a number")
    return text


def _templates(processing: Element) -> PublishedFormula:
    program, key = StraightLine(), ""
    for rule in processing:
        inside = rule[0] if len(rule) == 1 else None
        if inside is None or local(rule) not in {"setTemplateValue", "setCorrectResponse"}:
            raise NotRead(f"the rule {local(rule)} of templateProcessing is not read")
        letter = rule.get("identifier") or ""
        if local(rule) == "setCorrectResponse":
            key = _expression(inside)
        elif local(inside) in {"randomFloat", "randomInteger"}:
            program.draw(letter, inside.get("min") or "", inside.get("max") or "")
        else:
            program.assign(letter, _expression(inside))
    if not key:
        raise NotRead("templateProcessing sets no correct response")
    return program.key(key)


def _expression(element: Element) -> str:
    inside = [_expression(each) for each in element]
    match local(element):
        case "baseValue":
            return f"({words_of(element.text or '')})"
        case "variable":
            return element.get("identifier") or ""
        case "mathConstant" if element.get("name") == "pi":
            return "pi"
        case "mathOperator" if element.get("name") in MATHEMATICAL and len(inside) == 1:
            return f"{element.get('name')}({inside[0]})"
        case name if name in OPERATORS and len(inside) >= 2:
            return "(" + OPERATORS[name].join(f"({each})" for each in inside) + ")"
        case name:
            raise NotRead(f"the expression {name} is not read")
