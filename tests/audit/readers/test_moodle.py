"""Twenty questions of Moodle as it exports them: what is read of each, and why the others are not."""

from __future__ import annotations

import pytest

from corollary.audit.bank_file import laws_by_id, records_of
from corollary.audit.examine import examine
from corollary.audit.readers.moodle_xml import moodle_records
from corollary.problem.diagnostic import Malformed

SHELL = """<?xml version="1.0" encoding="UTF-8"?>
<quiz>
<question type="category"><category><text>$course$/physics</text></category></question>
<question type="{kind}"><name><text>fall</text></name>
<questiontext format="html"><text><![CDATA[<p>How <b>fast</b> &amp; far?</p>]]></text></questiontext>
{inside}
</question></quiz>
"""


def answer(text, fraction=100):
    return f'<answer fraction="{fraction}" format="moodle_auto_format"><text>{text}</text><tolerance>0.1</tolerance></answer>'


def units(*pairs):
    rows = "".join(f"<unit><multiplier>{m}</multiplier><unit_name>{u}</unit_name></unit>" for m, u in pairs)
    return f"<units>{rows}</units>"


def dataset(letter, low, high, items=()):
    rows = "".join(
        f"<dataset_item><number>{n}</number><value>{v}</value></dataset_item>" for n, v in enumerate(items, 1)
    )
    return (
        f"<dataset_definition><name><text>{letter}</text></name><minimum><text>{low}</text></minimum>"
        f"<maximum><text>{high}</text></maximum><dataset_items>{rows}</dataset_items></dataset_definition>"
    )


def datasets(*each):
    return f"<dataset_definitions>{''.join(each)}</dataset_definitions>"


MV = datasets(dataset("m", 1, 10), dataset("v", 2, 30))
READ = [
    ("numerical", answer("19.6"), "19.6"),
    ("numerical", answer("19.6") + units((1, "m/s"), (0.001, "km/s")), "19.6 m/s"),
    ("numerical", answer("19.6") + answer("20", 50) + answer("*", 0), "19.6"),
    ("numerical", answer("-3.2e4"), "-3.2e4"),
    ("numerical", answer("0"), "0"),
    ("calculated", answer("{m}*{v}") + MV, "m*v"),
    ("calculated", answer("{m}*pow({v},2)/2") + MV, "m*v^2/2"),
    ("calculatedsimple", answer("0.5*{m}*{v}*{v}") + MV, "1/2*m*v*v"),
    ("calculated", answer("sqrt(2*9.81*{h})") + datasets(dataset("h", 1, 5)), "sqrt(2*981/100*h)"),
    ("calculated", answer("sin(deg2rad({a}))") + datasets(dataset("a", 10, 80)), "sin(a*pi/180)"),
    ("calculated", answer("2*pi()*sqrt({l}/9.8)") + datasets(dataset("l", 1, 3)), "2*pi*sqrt(l/(49/5))"),
    ("calculated", answer("{x}/{y}") + datasets(dataset("x", 1, 2, [1, 1.5, 2]), dataset("y", 3, 4)), "x/y"),
    ("calculated", answer("round({m}*9.81, 1)") + MV, "m*981/100"),
    ("shortanswer", answer("42 N"), "42 N"),
    ("multichoice", answer("9.8 m/s&lt;sup&gt;2&lt;/sup&gt;") + answer("0", 0), "9.8 m/s^2"),
    ("multichoice", "<single>true</single>" + answer("4.9 m/s") + answer("9.8 m/s", 0), "4.9 m/s"),
    ("multichoice", answer("&lt;p&gt;12&amp;nbsp;N&lt;/p&gt;") + answer("24 N", 0), "12 N"),
    ("multichoice", "<single>1</single>" + answer("v = 3.0 m/s") + answer("6.0 m/s", -33.3), "v = 3.0 m/s"),
]
NOT_READ = [
    ("essay", "", "type essay"),
    ("cloze", "", "type cloze"),
    ("numerical", answer("*"), "every answer"),
    ("numerical", answer("1") + answer("2"), "2 different answers"),
    ("multichoice", "<single>false</single>" + answer("1 N") + answer("2 N"), "several options"),
    ("multichoice", answer("the heavier one"), "is not a number"),
    ("calculated", answer("{m}*{v}") + datasets(dataset("m", 1, 2)), "v is not known"),
    ("calculated", answer("{m}*round({v},1)") + MV, ""),
    ("calculated", answer("{m}*") + MV, ""),
    ("calculated", answer("{m}^2") + MV, "pow is"),
    ("calculated", answer("{m}") + datasets(dataset("m", 5, 5)), "not a range"),
]


def file_of(tmp_path, kind, inside):
    path = tmp_path / "bank.xml"
    path.write_text(SHELL.format(kind=kind, inside=inside), encoding="utf-8")
    return path


@pytest.mark.parametrize(("kind", "inside", "published"), READ)
def test_what_is_read(tmp_path, same, kind, inside, published):
    (record,) = moodle_records(file_of(tmp_path, kind, inside))
    assert not record.unread
    assert same(*record.published, published)
    assert record.statement == "How fast & far?"


@pytest.mark.parametrize(("kind", "inside", "why"), NOT_READ)
def test_what_is_not_read_is_said(tmp_path, kind, inside, why):
    (record,) = moodle_records(file_of(tmp_path, kind, inside))
    assert record.unread
    assert why in record.unread


@pytest.mark.parametrize(
    "text",
    [
        '<!DOCTYPE quiz [<!ENTITY a "b">]><quiz/>',
        "<quiz><question></quiz>",
        '<?xml version="1.0" encoding="nobody\'s"?><quiz/>',
        "<quiz>" + "<a>" * 200 + "</a>" * 200 + "</quiz>",
        "no markup",
    ],
)
def test_what_is_no_safe_xml_is_refused(tmp_path, text):
    path = tmp_path / "bank.xml"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(Malformed):
        moodle_records(path)


@pytest.mark.parametrize("encoding", ["utf-88", "UTF-7", "cp037", "UTF-16"])
def test_the_text_is_utf_8_whatever_it_says(tmp_path, encoding):
    """What another encoding would make of the bytes is never seen."""
    path = tmp_path / "bank.xml"
    question = '<question type="description"><a><![CDATA[<!DOCTYPE html>]]></a></question>'
    path.write_text(f'<?xml version="1.0" encoding="{encoding}"?><quiz>{question}</quiz>', encoding="utf-8")
    assert moodle_records(path) == ()


def test_a_number_and_a_formula_are_audited(tmp_path):
    path = file_of(tmp_path, "calculated", answer("{m}*{v}*{v}") + MV)
    laws = tmp_path / "laws.yaml"
    laws.write_text("- {id: fall, given: {m: kg, v: m/s}, laws: [K = m*v^2/2], asked: K}\n", encoding="utf-8")
    (record,) = records_of(path, laws_by_id(laws))
    (outcome,) = examine(record)
    assert outcome.finding == "wrong"
    assert set(outcome.counterexample) == {"m", "v", "published", "derived"}
