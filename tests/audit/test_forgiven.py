"""Keys rounded more coarsely than their own question forgives, in each format that states a tolerance."""

from __future__ import annotations

import pytest

from corollary.audit.bank_file import laws_by_id, records_of
from corollary.audit.examine import examine
from corollary.audit.record import ForgivenError
from corollary.audit.record_file import records_in
from corollary.problem.diagnostic import Malformed

LAWS = """\
- id: fall
  given: {h: 20 m, g: 9.8 m/s^2}
  laws: ['v^2 = 2*g*h']
  where: v > 0
  asked: v in m/s
"""
MOODLE = """<?xml version="1.0"?><quiz><question type="numerical"><name><text>fall</text></name>
<questiontext><text>How fast?</text></questiontext><answer fraction="100"><text>KEY</text>TOL</answer>
<units><unit><multiplier>1</multiplier><unit_name>m/s</unit_name></unit></units></question></quiz>"""
REXAMS = "Question\n========\nHow fast?\n\nMeta-information\n================\nexname: fall\nextype: num\nexsolution: KEY\nTOL\n"
CLOZE = (
    "Question\n========\nHow fast?\n\nMeta-information\n================\nexname: fall\nextype: cloze\n"
    "exclozetype: num\nexsolution: KEY\nTOL\n"
)
FORMS = {
    "moodle": ("fall.xml", MOODLE, "<tolerance>{}</tolerance>"),
    "R/exams": ("fall.Rmd", REXAMS, "extol: {}"),
    "cloze": ("fall.Rmd", CLOZE, "extol: {}"),
    "YAML": ("fall.yaml", LAWS + "  published: KEY\n  TOL\n", "forgives: {}"),
}


def finding(folder, form, key, tolerance):
    """19.7990 m/s by the laws."""
    name, text, stated = FORMS[form]
    path, laws = folder / name, folder / "laws.yaml"
    path.write_text(text.replace("KEY", key).replace("TOL", stated.format(tolerance) if tolerance else ""))
    laws.write_text(LAWS)
    (record,) = records_of(path, {} if form == "YAML" else laws_by_id(laws))
    (outcome,) = examine(record)
    assert ("more coarsely than its question forgives" in outcome.why) == (outcome.finding == "wrong")
    return outcome.finding


@pytest.mark.parametrize("form", FORMS)
@pytest.mark.parametrize(
    ("key", "tolerance", "found"),
    [
        ("19.8", "0.01", "agrees"),
        ("19.8", "0.0005", "wrong"),
        ("20", "0.3", "agrees"),
        ("20", "0.1", "wrong"),
        ("20", "", "agrees"),
    ],
)
def test_a_key_is_as_fine_as_its_question_asks(tmp_path, form, key, tolerance, found):
    assert finding(tmp_path, form, key, tolerance) == found


@pytest.mark.parametrize(("tolerance", "found"), [("2 %", "agrees"), ("1%", "wrong")])
def test_a_share_of_the_answer(tmp_path, tolerance, found):
    assert finding(tmp_path, "YAML", "20", tolerance) == found


def test_a_tolerance_that_is_worked_out_is_not_known(tmp_path):
    assert finding(tmp_path, "R/exams", "20", "`r tol`") == "agrees"


def test_one_for_each_answer(tmp_path):
    path = tmp_path / "r.yaml"
    text = LAWS.replace("asked: v in m/s", "asked: [v in m/s, v in km/h]") + "  published: [19.8, 71.3]\n"
    path.write_text(text + "  forgives: [1 %, 0.5]\n")
    assert records_in(path)[0].forgives == (ForgivenError(0.01, 0.0), ForgivenError(0.0, 0.5))
    path.write_text(text + "  forgives: 1 %\n")
    with pytest.raises(Malformed, match="asks for 2 and forgives 1"):
        records_in(path)


@pytest.mark.parametrize("text", ["much", "-1 %", "nan", "inf", "%", ""])
def test_what_is_no_tolerance(tmp_path, text):
    path = tmp_path / "r.yaml"
    path.write_text(LAWS + f"  published: 19.8\n  forgives: '{text}'\n")
    with pytest.raises(Malformed, match=r"r\.yaml:7: .* is not a tolerance; write a share of the answer"):
        records_in(path)


@pytest.mark.parametrize(
    ("key", "answer", "found"),
    [
        ("19.80", 'NumberWithUnits("KEY m/s")->cmp', "agrees"),  # 0.005 % off; a thousandth is forgiven
        ("20", 'NumberWithUnits("KEY m/s")->cmp', "wrong"),  # 1 % off
        ("20", 'NumberWithUnits("KEY m/s")->cmp(tolerance => 0.02)', "agrees"),
        ("20", 'NumberWithUnits("KEY m/s")->cmp(tolerance => 0.1, tolType => "absolute")', "wrong"),
        ("20", 'NumberWithUnits("KEY m/s")->with(tolType => "absolute", tolerance => 0.3)->cmp', "agrees"),
        ("20", 'NumberWithUnits("KEY m/s")->cmp(tolerance => $rough)', "agrees"),  # it is not known
        ("20", "num_cmp(KEY, relTol => 2)", "agrees"),  # percent
        ("20", "num_cmp(KEY, tol => 0.1)", "wrong"),
        ("20", "num_cmp(KEY)", "wrong"),
    ],
)
@pytest.mark.parametrize(
    "context", ["", "Context()->flags->set(tolerance => 0.05, tolType => 'relative');\n"]
)
def test_webworks_tolerances(tmp_path, key, answer, found, context):
    if context and "num_cmp" not in answer and "(tol" not in answer:
        found = "agrees"
    path, laws = tmp_path / "fall.pg", tmp_path / "laws.yaml"
    path.write_text(
        f"DOCUMENT();\n{context}BEGIN_TEXT\nHow fast?\nEND_TEXT\nANS({answer});\nENDDOCUMENT();\n".replace(
            "KEY", key
        )
    )
    laws.write_text(LAWS)
    (record,) = records_of(path, laws_by_id(laws))
    (outcome,) = examine(record)
    assert outcome.finding == found, (outcome.why, record)
