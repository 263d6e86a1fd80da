"""Answers judged from plain data, by Python's standard library alone: what marking says of them is said, or that it cannot be told."""

from __future__ import annotations

import json
import re
import subprocess
import sys
from pathlib import Path

import pytest

from corollary.answers.verdict import word
from corollary.grading.from_json import from_json
from corollary.grading.judge import judge
from corollary.grading.key import Key
from corollary.grading.plain_key import judged, key_of, serialized
from corollary.grading.solutions import Solutions
from corollary.grading.verdict_text import sentence
from corollary.practice.offline import Offline
from corollary.problem.bank import Bank, chapter_bank, open_bank
from corollary.problem.variant import chapter
from corollary.render.practice_site import reading
from corollary.verify.expected_answers import samples

MANUAL = Path(__file__).parents[2] / "docs" / "howto"
BLOCK = r"((?:(?!^```).)*)"
EXAMPLE = re.compile(
    rf"^```markdown\n(?=---\ncode: ){BLOCK}^```\n\n```markdown\n(?!---){BLOCK}^```", re.MULTILINE | re.DOTALL
)
ALONE = """
import json, sys
given, asked = json.load(sys.stdin)
space = {}
exec(given["start"], space)
answered = space["begin"](json.dumps(given))
print(json.dumps([json.loads(answered("judge", key, part, json.dumps(answers))) for key, part, answers in asked]))
"""


@pytest.fixture(scope="module")
def solutions():
    return Solutions(chapter_bank())


def key(solutions: Solutions, code: str) -> Key:
    return solutions.key(chapter(chapter_bank()[code]))


def alone(asked: list[tuple[Key, str, dict]]) -> list[dict]:
    """What the page's own program says, from the texts and data that the page carries and the standard library."""
    data = [(json.dumps(serialized(key)), part, answers) for key, part, answers in asked]
    done = subprocess.run(
        [sys.executable, "-S", "-I", "-c", ALONE],
        input=json.dumps([reading(), data]),
        capture_output=True,
        text=True,
        timeout=120,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)


@pytest.fixture
def manual(tmp_path) -> Bank:
    """The whole examples of the manual for authors, but for those of programs, which no page judges."""
    pages = [path.read_text(encoding="utf-8") for path in sorted(MANUAL.glob("*.md"))]
    examples = [each for page in pages for each in EXAMPLE.findall(page)]
    for number, (problem, solution) in enumerate(each for each in examples if "example: `" not in each[1]):
        for folder, ending, text in (("problems", "md", problem), ("solutions", "md", solution)):
            place = tmp_path / folder / "examples" / f"example_{number}.{ending}"
            place.parent.mkdir(parents=True, exist_ok=True)
            place.write_text(text, encoding="utf-8")
    return open_bank(tmp_path)


@pytest.mark.whole
def test_every_type_is_judged_as_it_is_marked_without_flint_and_without_our_package(manual):
    """Samples of each answer type, from the bank and from the manual."""
    asked = list[tuple[Key, str, dict]]()
    for bank, codes in ((chapter_bank(), ["X12.1", "X12.5", "S12.1", "X12.3"]), (manual, None)):
        work = Solutions(bank)
        for problem in (each for each in bank if codes is None or each.code in codes):
            one = work.key(chapter(problem))
            for part in filter(judged, problem.parts):
                asked += [(one, part.id, {part.id: each.answer}) for each in samples(one, part)]
    types = {one.variant.problem.part(part).answer_type for one, part, _answers in asked}
    assert types >= {"value", "vector", "expression", "choice", "interval", "list", "table", "word", "forces"}
    for (one, part, answers), got in zip(asked, alone(asked), strict=True):
        verdict = judge(one, {name: from_json(each) for name, each in answers.items()})[part][0][0]
        assert (got["word"], got["text"]) == (word(verdict), sentence(verdict)), (part, answers)


def test_a_formula_a_slip_and_what_follows_are_told_by_the_standard_library_alone(solutions):
    kick, meteor = key(solutions, "X12.5"), key(solutions, "S12.1")
    asked = [
        (kick, "a", {"a": "m v"}),
        (kick, "a", {"a": "m v/2"}),
        (kick, "a", {"a": "8600 kg m/s"}),
        (kick, "c", {"b": "9.2 N s", "c": "92 N"}),
        (kick, "c", {"c": "92 N"}),
        (meteor, "b", {"a": ["1 km/s", "2 km/s"], "b": "abc"}),
    ]
    words = [each["word"] for each in alone(asked)]
    expected = [
        judge(one, {n: from_json(a) for n, a in answers.items()})[part][0][0] for one, part, answers in asked
    ]
    assert words == [word(each) for each in expected]
    assert words[:4] == ["right", "slip", "slip", "follows"]


def test_a_key_comes_back_from_serialized_with_all_that_marking_asks_of_it(solutions):
    one = key(solutions, "X12.5")
    data = json.dumps(serialized(one))
    back = key_of(json.loads(data))
    assert back.truths == one.truths
    assert back.variant.exact == one.variant.exact
    assert back.choices == one.choices
    for find in one.solution.unknowns:
        assert find.statement.because not in data


def test_what_would_follow_through_a_simulation_is_left_open(solutions):
    """A ball on the floor: with a wrong value of what goes into the simulation, nothing is said of what comes out of it."""
    one = key(solutions, "E12.3.1s")
    offline = Offline(json.loads(json.dumps(serialized(one))))
    before, right = (one.truths[part].values[0] for part in ("a", "c"))
    typed = {"right": f"{right:.6g}", "wrong": f"{1.4 * right:.6g}"}
    assert word(offline.verdict("c", {"c": typed["right"]})) == "right"
    assert word(offline.verdict("c", {"a": f"{2.5 * before:.6g}", "c": typed["right"]})) == "right"
    assert word(offline.verdict("c", {"a": f"{before:.6g}", "c": typed["wrong"]})) == "wrong"
    assert word(offline.verdict("c", {"c": typed["wrong"]})) == "wrong"
    left = offline.verdict("c", {"a": f"{2.5 * before:.6g}", "c": typed["wrong"]})
    assert word(left) == "unmarked"
    assert "worked solution" in sentence(left)
