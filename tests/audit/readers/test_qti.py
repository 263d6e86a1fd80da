"""Items of QTI 2.1: what is read of each, and why the others are not."""

from __future__ import annotations

import pytest

from corollary.audit.bank_file import records_of
from corollary.audit.readers.qti_items import qti_records
from corollary.problem.diagnostic import Malformed

SHELL = (
    '<assessmentItem xmlns="http://www.imsglobal.org/xsd/imsqti_v2p1" identifier="fall" title="Fall">{inside}'
    "<itemBody><p>How far?</p>{body}</itemBody></assessmentItem>"
)


def response(kind, *values):
    rows = "".join(f"<value>{each}</value>" for each in values)
    return f'<responseDeclaration identifier="R" baseType="{kind}"><correctResponse>{rows}</correctResponse></responseDeclaration>'


def draw(letter, low, high, kind="randomFloat"):
    return f'<setTemplateValue identifier="{letter}"><{kind} min="{low}" max="{high}"/></setTemplateValue>'


def variable(letter):
    return f'<variable identifier="{letter}"/>'


def number(value):
    return f'<baseValue baseType="float">{value}</baseValue>'


def processing(*rules):
    return f"<templateProcessing>{''.join(rules)}</templateProcessing>"


def correct(expression):
    return f'<setCorrectResponse identifier="R">{expression}</setCorrectResponse>'


CHOICE = '<choiceInteraction><simpleChoice identifier="A">3 m/s</simpleChoice><simpleChoice identifier="B">fast</simpleChoice></choiceInteraction>'
FLOAT = response("float")
SQUARE = f"<power>{variable('v')}{number(2)}</power>"
ENERGY = f"<divide><product>{variable('m')}{SQUARE}</product>{number(2)}</divide>"
IN_RADIANS = f"<divide><product>{variable('a')}<mathConstant name='pi'/></product>{number(180)}</divide>"
RADIANS = f'<setTemplateValue identifier="b">{IN_RADIANS}</setTemplateValue>'
READ = [
    (response("float", "19.6"), "", "19.6"),
    (response("integer", "12"), "", "12"),
    (response("string", "4.9 m/s"), "", "4.9 m/s"),
    (response("identifier", "A"), CHOICE, "3 m/s"),
    (FLOAT + processing(draw("m", 1, 5), correct(f"<product>{variable('m')}{number('9.8')}</product>")), "", "m*(49/5)"),
    (FLOAT + processing(draw("m", 1, 5), draw("v", 2, 9, "randomInteger"), correct(ENERGY)), "", "m*v^2/2"),
    (FLOAT + processing(draw("a", 10, 80), RADIANS, correct(f"<mathOperator name='sin'>{variable('b')}</mathOperator>")), "", "sin(a*pi/180)"),
    (FLOAT + processing(draw("a", 1, 8), draw("b", 1, 8), correct(f"<subtract>{variable('a')}{variable('b')}</subtract>")), "", "a - b"),
    (FLOAT + processing(draw("a", 1, 8), draw("b", 1, 8), correct(f"<sum>{variable('a')}{variable('b')}{number(3)}</sum>")), "", "a + b + 3"),
]  # fmt: skip
NOT_READ = [
    (response("identifier", "B"), CHOICE, "is not a number"),
    (response("identifier", "A", "B"), CHOICE, "2 correct values"),
    (response("float", "1") + response("float", "2"), "", "2 responses"),
    (response("pair", "A B"), "", "type pair"),
    (FLOAT + processing(draw("a", 1, 8), correct(f"<round>{variable('a')}</round>")), "", "round is not read"),
    (FLOAT + processing("<templateCondition><templateIf/></templateCondition>"), "", "is not read"),
    (FLOAT + processing(draw("a", 1, 8)), "", "sets no correct response"),
]  # fmt: skip


def file_of(tmp_path, inside, body):
    path = tmp_path / "item.xml"
    path.write_text(SHELL.format(inside=inside, body=body), encoding="utf-8")
    return path


@pytest.mark.parametrize(("inside", "body", "published"), READ)
def test_what_is_read(tmp_path, same, inside, body, published):
    (record,) = qti_records(file_of(tmp_path, inside, body))
    assert not record.unread
    assert same(*record.published, published)
    assert record.statement.startswith("How far?")


@pytest.mark.parametrize(("inside", "body", "why"), NOT_READ)
def test_what_is_not_read_is_said(tmp_path, inside, body, why):
    (record,) = qti_records(file_of(tmp_path, inside, body))
    assert record.unread
    assert why in record.unread


def test_xml_is_told_apart_by_its_root(tmp_path):
    (record,) = records_of(file_of(tmp_path, response("float", "1"), ""), {})
    assert record.id == "fall"
    path = tmp_path / "other.xml"
    path.write_text("<html/>", encoding="utf-8")
    with pytest.raises(Malformed, match="no assessmentItem"):
        records_of(path, {})
