"""What the marking scheme tells a person is what the judge does: the ends of ranges, what mistakes earn, what is carried."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

import pytest

from corollary.answers.evaluation import as_exact, number
from corollary.answers.verdict import Follows, Mistaken, Right
from corollary.grading.from_json import from_json
from corollary.grading.judge import judge
from corollary.grading.key import Key
from corollary.grading.marking_scheme import PartScheme, marking_scheme
from corollary.grading.solutions import Solutions
from corollary.problem.bank import home
from corollary.problem.problem_set import Scheme
from corollary.problem.variant import at, chapter

SCHEME = Scheme(follows=0.75, slip=0.5, mistaken=0.25, choice=0.125)
CODES = ("X12.5", "X12.10", "X12.8", "S12.4", "T12.3")


def of(code: str, index: int | None = None) -> tuple[Key, dict[str, PartScheme]]:
    bank, problem = home(None, code)
    key = Solutions(bank).key(chapter(problem) if index is None else at(problem, index))
    return key, {each.part.id: each for each in marking_scheme(key, SCHEME, weight=2.0)}


def verdict(key: Key, answers: dict[str, object], part: str):
    return judge(key, {name: from_json(value) for name, value in answers.items()})[part][0][0]


@pytest.mark.parametrize("index", [None, 5, 77])
@pytest.mark.parametrize("code", CODES)
def test_the_ends_of_a_range_are_right_and_what_lies_beyond_is_not(code: str, index: int | None):
    key, parts = of(code, index)
    tried = 0
    for name, each in parts.items():
        if each.truth is None or each.part.components or each.accepted is None or not each.truth.values[0]:
            continue
        found, step = each.accepted, Fraction(10) ** each.accepted.place
        assert found.high - found.low <= 2 * Fraction(
            each.truth.tolerance * each.truth.scale / each.part.unit.si
        )
        for end in (found.low, found.high):
            assert isinstance(verdict(key, {name: float(end)}, name), Right), (name, float(end))
        for beyond in (found.low - 2 * step, found.high + 2 * step):
            assert not isinstance(verdict(key, {name: float(beyond)}, name), Right), (name, float(beyond))
        tried += 1
    assert tried


@pytest.mark.parametrize("code", CODES)
def test_a_mistake_earns_what_the_scheme_says(code: str):
    key, parts = of(code)
    listed = [
        (name, each, mistake) for name, each in parts.items() for mistake in each.mistakes if each.truth
    ]
    assert listed
    for name, each, mistake in listed:
        unit = each.part.unit
        own = [unit.from_si(value) for value in mistake.values]
        found = verdict(key, {name: own if each.part.components else own[0]}, name)
        assert isinstance(found, Mistaken), (name, mistake, found)
        assert mistake.points == (0.0 if found.nothing else 0.25 * each.part.points * 2)


def test_a_wrong_option_has_its_letter_and_what_it_overlooks():
    bank, problem = home(None, "S12.2")
    key = Solutions(bank).key(chapter(problem))
    choices = [each for each in marking_scheme(key, SCHEME) if each.letter]
    assert choices
    for each in choices:
        assert isinstance(verdict(key, {each.part.id: each.letter}, each.part.id), Right)
        for mistake in each.mistakes:
            assert mistake.letter != each.letter
            found = verdict(key, {each.part.id: mistake.letter}, each.part.id)
            assert isinstance(found, Mistaken)
            assert found.mistake == mistake.sentence
            assert mistake.points == 0.125 * each.out_of


@pytest.mark.parametrize(
    ("code", "part", "earlier"), [("X12.5", "c", "b"), ("X12.5", "d", "a"), ("X12.8", "b", "a")]
)
def test_the_formula_for_what_is_carried_gives_what_follows(code: str, part: str, earlier: str):
    key, parts = of(code)
    carried = next(each for each in parts[part].carried if each.earlier == (earlier,))
    assert parts[part].follows == 0.75 * parts[part].out_of
    truth = key.truths[earlier]
    wrong = tuple(1.37 * value for value in truth.values)
    letters = key.variant.exact | {
        name: as_exact(value) for name, value in zip(key.find(truth).names, wrong, strict=True)
    }
    own = [number(tree, letters) / parts[part].part.unit.si for tree in carried.trees]
    shown = [value / parts[earlier].part.unit.si for value in wrong]
    answers: dict[str, object] = {
        earlier: shown if len(shown) > 1 else shown[0],
        part: own if len(own) > 1 else own[0],
    }
    found = verdict(key, answers, part)
    assert isinstance(found, Follows)
    assert earlier in found.earlier


def test_what_a_person_compares_with_stands_there():
    _key, parts = of("P12.14")
    for name, words in (("k", "-"), ("h", "def ")):
        assert words in parts[name].answer
        assert parts[name].truth is None
        assert parts[name].accepted is None


@pytest.mark.parametrize("code", CODES)
def test_how_far_an_answer_may_be_off_is_rounded_to_the_inside_at_the_same_place(code: str):
    _key, parts = of(code)
    for each in parts.values():
        if each.truth is not None and (found := each.accepted) is not None:
            allowed = Fraction(each.truth.tolerance * each.truth.scale / each.part.unit.si)
            step = Fraction(10) ** found.place
            assert allowed - step * (1 + Fraction(1, 10**6)) < found.reach <= allowed
            assert found.reach % step == 0


def test_nothing_is_carried_from_an_answer_that_a_set_leaves_out():
    key, parts = of("X12.8")
    assert {each.earlier for each in parts["c2"].carried} >= {("a",)}
    whole = key.variant.problem
    some = replace(whole, parts=tuple(part for part in whole.parts if part.id in ("b", "c2")), written=whole)
    b, c2 = marking_scheme(replace(key, variant=replace(key.variant, problem=some)), SCHEME)
    assert not b.carried
    assert all(each.earlier == ("b",) for each in c2.carried)
