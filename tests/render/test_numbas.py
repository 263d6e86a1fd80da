"""An exam for Numbas: its JSON behind a line that names the version, a table of variants in each question, one algorithm for marks."""

from __future__ import annotations

import json
import re

import pytest

from corollary.grading.solutions import Solutions
from corollary.problem.bank import chapter_bank, home
from corollary.problem.problem_set import Scheme
from corollary.problem.variant import at
from corollary.render.exports import target
from corollary.render.lms_item import item
from corollary.render.targets.numbas import entry_of

SOLUTIONS = Solutions(chapter_bank())


def items(*codes: str, variants: int = 1, scheme: Scheme | None = None):
    return [
        item(SOLUTIONS, at(home(None, code)[1], 40 * number), number, 1.0, scheme or Scheme())
        for code in codes
        for number in range(1, variants + 1)
    ]


def written(of, apart: bool = False):
    made = target("numbas").items
    assert made is not None
    found = made("few", of, apart)
    header, _, text = found.files["few-numbas.exam"].decode().partition("\n")
    assert header == "// Numbas version: finer_feedback_settings"
    (group,) = json.loads(text)["question_groups"]
    return found, group["questions"]


def table(question: dict) -> list[dict]:
    """The table of variants, read as JME reads a string: a backslash keeps what follows it."""
    definition = question["variables"]["variants"]["definition"]
    inside = re.fullmatch(r'json_decode\(safe\("(.*)"\)\)', definition, re.DOTALL)
    assert inside is not None
    return json.loads(re.sub(r"\\(.)", r"\1", inside[1], flags=re.DOTALL))


def test_a_question_draws_one_of_its_variants():
    _, questions = written(items("X12.5", "X12.7", variants=3))
    assert [each["name"] for each in questions] == [
        "X12.5 Kicking a ball",
        "X12.7 Ball reflected from a wall",
    ]
    for question in questions:
        rows = table(question)
        variables = {name: each["definition"] for name, each in question["variables"].items()}
        assert variables["variant"] == "random(0..2)"
        assert variables["drawn"] == "variants[variant]"
        assert len(rows) == 3
        assert len({row["statement"] for row in rows}) == 3
        assert all(variables[column] == f'drawn["{column}"]' for column in rows[0])
        assert all("data:image/svg+xml;base64," in row["statement"] for row in rows)


def test_what_a_question_reads_is_in_its_table():
    """Whatever stands in braces is a variable, and so is what the algorithms ask for; nothing in a formula is taken for one."""
    _, questions = written(items("X12.7", "X12.13", "P12.14"))
    for question in questions:
        columns = set(table(question)[0])
        texts = json.dumps({key: question[key] for key in ("statement", "advice", "parts")})
        asked = set(re.findall(r"\{(\w+)(?:\[\d+\])?\}", texts)) | set(
            re.findall(r"\b\w+_(?:credits|ranges|shown|options|marks)\b", texts)
        )
        assert asked == columns
        for row in table(question):
            every = json.dumps(row)
            assert every.count("<math") == every.count("nosubvars=")


def test_credits_are_those_of_the_item():
    (one,) = items("X12.7", scheme=Scheme(mistaken=0.3))
    _, (question,) = written([one])
    (row,) = table(question)
    for asked, entry in zip(one.parts, question["parts"], strict=True):
        listed = row[f"{asked.prompt.part.id}_credits"]
        assert [(tuple(each["values"]), each["reach"], each["share"]) for each in listed] == [
            (mark.values, mark.reach, mark.share) for mark in asked.marks
        ]
        assert [tuple(each["signed"]) for each in listed] == [mark.signed for mark in asked.marks]
        assert [bool(each["feedback"]) for each in listed] == [bool(mark.feedback) for mark in asked.marks]
        assert sum(gap["marks"] for gap in entry["gaps"]) == pytest.approx(asked.prompt.out_of)
        assert len(entry["gaps"]) == len(asked.components)


def test_options_earn_and_say_what_is_theirs():
    (one,) = items("S12.2")
    _, (question,) = written([one])
    (row,) = table(question)
    for asked, entry in zip(one.parts, question["parts"], strict=True):
        if entry["type"] == "1_n_2":
            marks = row[entry["matrix"]]
            assert marks == [each.share * asked.prompt.out_of for each in asked.options]
            assert len(entry["distractors"]) == len(row[entry["choices"]]) == len(asked.options)
            break
    else:
        pytest.fail("S12.2 has a choice")


def test_parts_are_carried_or_refused_by_name():
    found, (question,) = written(items("P12.14"))
    assert {each.part for each in found.parts if not each.how} == {"g", "h", "j"}
    assert all(each.lost for each in found.parts if not each.how)
    assert len(question["parts"]) == len([each for each in found.parts if each.how])
    prose = next(each for each in found.parts if each.part == "k")
    assert "paper" in prose.lost
    assert question["parts"][-1]["type"] == "information"
    refused = next(each for each in items("P12.14")[0].parts if each.prompt.part.id == "g")
    with pytest.raises(TypeError):
        entry_of(refused)


def test_apart_each_part_is_a_question_that_draws_for_itself():
    _, questions = written(items("X12.5", variants=2), apart=True)
    assert [each["name"] for each in questions] == [f"X12.5 Kicking a ball, ({part})" for part in "abcd"]
    assert all(len(each["parts"]) == 1 and len(table(each)) == 2 for each in questions)
