"""One case of `corollary read`: what is read, its value in SI, and what is decided."""

from __future__ import annotations

import pytest

from corollary.answers.read_case import BadCase, read_case


def read(text: str, **others: object) -> dict[str, object]:
    return read_case({"text": text, **others})


@pytest.mark.parametrize(
    ("text", "unit", "read_as", "value", "its_unit", "dimension", "verdict"),
    [
        ("8,6 Ns", "kg m/s", "8.6 N s", 8.6, "N*s", {"kg": 1, "m": 1, "s": -1}, "compatible"),
        ("5 cm", "m", "5 cm", 0.05, "cm", {"m": 1}, "compatible"),
        ("5", "cm", "5", 5.0, "1", {}, "wrong dimension"),
        ("5 cm", "s", "5 cm", 0.05, "cm", {"m": 1}, "wrong dimension"),
        ("5 cm", None, "5 cm", 0.05, "cm", {"m": 1}, None),
        ("5", None, "5", 5.0, "1", {}, None),
        (
            "0.82 km/s to the left",
            "m/s",
            "0.82 km/s to the left",
            -820.0,
            "km/s",
            {"m": 1, "s": -1},
            "compatible",
        ),
        ("85.3 lost", "J", "85.3 lost", -85.3, "1", {}, "wrong dimension"),
        ("loss: 2 N m", "N m", "2 N m loss", -2.0, "N*m", {"kg": 1, "m": 2, "s": -2}, "compatible"),
        (
            "-3 m/s, x to the left",
            "m/s",
            "-3 m/s, x to the left",
            3.0,
            "m/s",
            {"m": 1, "s": -1},
            "compatible",
        ),
    ],
)
def test_a_quantity(text, unit, read_as, value, its_unit, dimension, verdict):
    found = read(text, unit=unit)
    assert (found["status"], found["field"], found["text"]) == ("ok", "quantity", text)
    assert (found["read"], found["value"], found["unit"]) == (read_as, value, its_unit)
    assert (found["dimension"], found["verdict"]) == (dimension, verdict)
    assert bool(found["why"]) == (verdict == "wrong dimension")


def test_words_that_leave_the_sign_open_are_asked_about():
    found = read("-3 m/s to the right", unit="m/s")
    assert found["status"] == "asked"
    assert "which sign" in str(found["why"])


@pytest.mark.parametrize(
    ("text", "figures"), [("200 N", 2), ("0.20 kN", 2), ("1000 W", 2), ("200.0 N", 4), ("204 N", 3)]
)
def test_figures_are_counted_by_the_one_rule_for_zeros(text, figures):
    assert read(text)["figures"] == figures


def test_a_unit():
    found = read("N s", field="unit", unit="kg m/s")
    assert (found["status"], found["read"], found["value"], found["verdict"]) == (
        "ok",
        "N s",
        1.0,
        "compatible",
    )
    other = read("km/h", field="unit", unit="s")
    assert other["read"] == "km/h"
    assert other["value"] == pytest.approx(1 / 3.6)
    assert other["dimension"] == {"m": 1, "s": -1}
    assert other["verdict"] == "wrong dimension"
    assert other["why"]
    assert read("km/h", field="unit")["verdict"] is None


def test_an_expression():
    names = {"names": ["m", "v"], "equals": "m*v"}
    assert read("v m", **names)["verdict"] == "equal"
    different = read("m/v", **names)
    assert different["verdict"] == "different"
    at = different["counterexample"]
    assert at["m"] / at["v"] != pytest.approx(at["m"] * at["v"])
    alone = read("m v", names=["m", "v"])
    assert (alone["field"], alone["read"], alone["verdict"]) == ("expression", "m*v", None)


@pytest.mark.parametrize("field", ["quantity", "unit", "expression"])
def test_what_cannot_be_read_says_where_and_why(field):
    found = read("8.6 furlong *", field=field, names=["m"])
    assert found["status"] == "refused"
    assert found["why"]
    assert found["read"] is found["value"] is found["verdict"] is None


@pytest.mark.parametrize(
    "case", [None, 3, [], {}, {"text": 3}, {"text": "5", "field": "poem"}, {"text": "5", "unit": 3}, {"text": "m", "names": ["m"], "equals": "m*"}]
)  # fmt: skip
def test_what_is_no_case(case):
    with pytest.raises(BadCase):
        read_case(case)


@pytest.mark.parametrize(
    "case",
    [
        {"text": "8.6\ud800", "unit": "kg m/s"},
        {"text": "\udc00", "unit": "N"},
        {"text": "2*m*v\ud834", "field": "expression", "names": ["m", "v"], "equals": "2*m*v"},
        {"text": "N\udfff", "field": "unit", "unit": "N"},
    ],
)
def test_half_a_surrogate_is_refused_with_a_sentence_that_can_be_written(case):
    found = read_case(case)
    assert found["status"] == "refused"
    assert len(str(found["why"]).encode()) > 20


@pytest.mark.parametrize(
    "case",
    [
        {"text": "8.6", "unit": "kg\ud800"},
        {"text": "m", "field": "expression", "names": ["m\ud800"]},
        {"text": "2*m", "field": "expression", "names": ["m"], "equals": "2*m\ud800"},
        {"text": "1", "field": "q\ud800"},
    ],
)
def test_half_a_surrogate_in_the_request_is_no_case(case):
    with pytest.raises(BadCase) as refused:
        read_case(case)
    str(refused.value).encode()


@pytest.mark.parametrize(
    "text", ["twice v", "2 x v", "2v m/s", "2 ganger v", "the ball starts with 2v", "**u = 2v**"]
)
def test_a_formula_is_read_as_the_marker_reads_it(text):
    found = read_case({"text": text, "unit": "m/s", "names": ["v"], "equals": "2*v"})
    assert (found["read"], found["verdict"]) == ("2*v", "equal")
