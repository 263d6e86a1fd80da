"""The local page of `corollary mark`: what it shows, what it takes, and what it refuses because somebody changed it meanwhile."""

from __future__ import annotations

import json
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any

from corollary.course.regrade_evidence import Evidence, evidence_html, explained
from corollary.course.wrong_answers import DrawnKeys
from corollary.derive.worked_solution import model_answer
from corollary.formula.ball import Undefined
from corollary.formula.latex import letter, letters_printed
from corollary.grading.solutions import Solutions
from corollary.guard import Failure, guarded
from corollary.nbgrader.hand_marking import (
    ChangedMeanwhile,
    NotMarkable,
    StandingMark,
    as_it_stands,
    change_rubric,
    give_marks,
    marking_state,
    marks_of,
    seen_in,
)
from corollary.nbgrader.written_marks import stored_facts
from corollary.problem.bank import Bank
from corollary.problem.problem_set import ProblemSet
from corollary.problem.roster import name_with_id
from corollary.problem.variant import Variant, written
from corollary.records.assignments import read_assigned
from corollary.records.files import Course, students
from corollary.records.manual_marks import PAGE, ManualMark, RubricItem, login_name
from corollary.records.near_miss_groups import AnswerGroup, PartToMark
from corollary.records.rubrics import item_id, read_rubrics
from corollary.render.marking_page import (
    MarkingProgress,
    PartQuestion,
    details_html,
    marking_page,
    question_of,
    rubric_record,
)
from corollary.render.wording import points

LONGEST_LOOK = 30.0  # seconds of the processor for a model answer, or for what explains a wrong one
RELOAD = "this page belongs to an earlier run; reload it"


@dataclass(slots=True)
class AnswerCard:
    """One card of one page: what it saw of each student, and what it was moved stands instead."""

    part: PartToMark
    group: AnswerGroup
    seen: dict[str, str]
    standing: dict[str, str] = field(default_factory=dict[str, str])


@dataclass
class MarkPage:
    """The pages of one run of `corollary mark`; every load has cards of its own, by which a save says what it saw."""

    course: Course
    problem_set: ProblemSet
    bank: Bank
    everything: bool
    anonymous: bool
    only: Collection[str] | None = None
    cards: dict[str, AnswerCard] = field(default_factory=dict[str, AnswerCard])
    parts: dict[str, PartToMark] = field(default_factory=dict[str, PartToMark])
    keys: dict[str, DrawnKeys] = field(default_factory=dict[str, DrawnKeys])

    @cached_property
    def names(self) -> Mapping[str, str]:
        return {each.id: each.name for each in students(self.course)}

    @cached_property
    def variants(self) -> Mapping[tuple[str, str], Variant]:
        """The numbers by student and problem; none where the record cannot be read."""
        sheets = guarded(lambda: read_assigned(self.course, self.problem_set))
        if isinstance(sheets, Failure):
            return {}
        return {
            (student, each.problem.code): each for student, sheet in sheets.items() for each in sheet.variants
        }

    @cached_property
    def solutions(self) -> Solutions:
        return Solutions(self.bank)

    def page(self) -> str:
        """A page with cards of its own. Raises NotACourse, NothingGraded."""
        state = marking_state(self.course, self.problem_set, everything=self.everything, only=self.only)
        ids: dict[tuple[str, int], str] = {}
        places: dict[str, int] = {}
        questions: dict[str, PartQuestion] = {}
        before = set[str]()
        for part in state.parts:
            self.parts[part.key] = part
            for place, group in enumerate(part.groups):
                name = ids[part.key, place] = f"a{len(self.cards)}"
                self.cards[name] = AnswerCard(part, group, dict(zip(group.students, group.seen, strict=True)))
                for student in group.students:
                    places.setdefault(student, len(places))
            facts = stored_facts(self.course, self.problem_set.name, part.groups[0].students[0])
            if facts is not None and (asked := question_of(facts, part.key, before)) is not None:
                questions[part.key] = asked
        done_before = [student for student in state.done if student not in places]
        return marking_page(
            self.problem_set,
            state.parts,
            ids,
            names=None if self.anonymous else self.names,
            questions=questions,
            numbers=self._numbers(state.parts),
            progress=MarkingProgress(places, len(done_before), len({*state.students, *places})),
        )

    def receive(self, posted: dict[str, Any]) -> str:
        """What the page sends: a mark, a changed rubric, or the wish to see more of an answer."""
        if "part" in posted:
            return json.dumps(self._rubric(posted))
        if "details" in posted:
            return json.dumps({"html": self._details(posted)})
        return json.dumps(self._mark(posted))

    def _mark(self, posted: Mapping[str, Any]) -> dict[str, Any]:
        try:
            card = self.cards[str(posted["group"])]
            score, comment = posted["points"], str(posted.get("comment") or "").strip()
            score = None if score is None else float(score)
            ticked = posted.get("items")
            items = (
                None
                if ticked is None
                else self._ticked(card.part, [(str(one), float(each)) for one, each in ticked])
            )
        except (KeyError, TypeError):
            raise NotMarkable(RELOAD) from None
        if posted.get("over"):
            card.seen |= card.standing
        mark = ManualMark(score, None, comment or None, by=login_name(), rubric=items, source=PAGE)
        if posted.get("stands"):
            student = card.group.students[0]
            mark = as_it_stands(self.course, self.problem_set, student, card.part.key, mark)
        marks = {(each, card.part.key): one for each, one in marks_of(card.group, mark)}
        seen = {(student, card.part.key): token for student, token in card.seen.items()}
        if posted.get("others") and card.group.request is not None:
            others = self._evidence(card).others
            marks |= {(each.student, card.part.key): mark for each in others}
        try:
            after = give_marks(self.course, self.problem_set, marks, seen=seen)
        except ChangedMeanwhile as changed:
            card.standing = {each.student: each.seen for each in changed.standing}
            return {"conflict": [self._words(each) for each in changed.standing]}
        card.seen = {student: token for (student, _), token in after.items() if student in card.seen}
        return {"saved": len(marks)}

    def _words(self, each: StandingMark) -> str:
        who = "The mark" if self.anonymous else f"The mark of {self.named(each.student)}"
        mark = each.mark
        by = f" by {mark.by}" if mark is not None and mark.by else ""
        at = f" on {mark.at[:16].replace('T', ' at ')} UTC" if mark is not None and mark.at else ""
        through = f" ({mark.source})" if mark is not None and mark.source else ""
        words = f" Comment: {mark.comment}" if mark is not None and mark.comment else ""
        return (
            f"{who} was changed meanwhile{by}{at}{through}: it is {points(each.points)} of {points(each.out_of)} now, "
            f"or the answer is another.{words}"
        )

    def named(self, student: str) -> str:
        """Name and id."""
        return name_with_id(self.names.get(student, student), student)

    def _ticked(self, part: PartToMark, ticked: Sequence[tuple[str, float]]) -> tuple[RubricItem, ...]:
        items = read_rubrics(self.course, self.problem_set.name).get(part.key) or self.parts[part.key].items
        known = {each.id: each for each in items}
        if any(
            one not in known or abs(known[one].share * part.out_of - worth) > 0.006 for one, worth in ticked
        ):
            raise NotMarkable("the rubric was changed meanwhile; reload the page")
        return tuple(known[one] for one, _ in ticked)

    def _rubric(self, posted: Mapping[str, Any]) -> dict[str, Any]:
        try:
            part = self.parts[str(posted["part"])]
            items = [
                RubricItem(
                    str(each["id"]) or item_id(str(each["text"])), str(each["text"]), _share(each, part)
                )
                for each in posted["items"]
            ]
            preview = bool(posted["preview"])
        except (KeyError, TypeError):
            raise NotMarkable(RELOAD) from None
        except ValueError:
            raise NotMarkable("an item's points must be a number") from None
        cards = [(name, card) for name, card in self.cards.items() if card.part.key == part.key]
        whose = sorted({student for _, card in cards for student in card.seen})
        before = {} if preview else seen_in(self.course, self.problem_set, part.key, whose)
        moves = change_rubric(self.course, self.problem_set, part.key, items, preview=preview)
        moved = [
            {
                "who": "a student" if self.anonymous else self.named(each.student),
                "before": each.before,
                "after": each.after,
            }
            for each in moves
        ]
        if preview:
            return {"moves": moved}
        after = seen_in(self.course, self.problem_set, part.key, whose)
        now = {each.student: each.after for each in moves}
        scores = dict[str, float | None]()
        for name, card in cards:
            # What somebody else changed meanwhile is not seen by having changed the rubric.
            card.seen = {
                one: after[one] if before.get(one) == token else token for one, token in card.seen.items()
            }
            if card.group.students[0] in now:
                scores[name] = now[card.group.students[0]]
        self.parts[part.key] = replace(part, items=tuple(items))
        return {"moves": moved, "items": rubric_record(items, part.out_of), "scores": scores}

    def _details(self, posted: Mapping[str, Any]) -> str:
        try:
            card = self.cards[str(posted["details"])]
        except KeyError:
            raise NotMarkable(RELOAD) from None
        student = card.group.students[0]
        if posted.get("what") == "evidence":
            found = guarded(lambda: self._evidence(card), LONGEST_LOOK)
            if isinstance(found, Failure):
                raise NotMarkable(f"this could not be worked out ({found.what})")
            return evidence_html(found, None if self.anonymous else self.named)
        facts = stored_facts(self.course, self.problem_set.name, student)
        asked = None if facts is None else question_of(facts, card.part.key, set())
        variant = self.variants.get((student, card.part.problem))
        model = "" if variant is None else guarded(lambda: self._model(variant, card.part.part), LONGEST_LOOK)
        text = model if isinstance(model, str) else ""
        texts = details_html(asked, _numbers_of(variant) if variant is not None else "", text)
        question = (
            f'{texts["question"]}<p class="quiet">{texts["numbers"]}</p>'
            if posted.get("what") == "both"
            else ""
        )
        return question + (texts["model"] or "<p>There is no model answer for these numbers.</p>")

    def _evidence(self, card: AnswerCard) -> Evidence:
        student, part = card.group.students[0], card.part.key
        return explained(self.course, self.problem_set, self.solutions, student, part, self.keys)

    def _model(self, variant: Variant, part: str) -> str:
        """The answer to a part in words, else the worked solution of the problem."""
        try:
            key = self.solutions.key(variant)
        except Undefined:
            return ""
        asked = next((each for each in variant.problem.parts if each.id == part), None)
        in_words = model_answer(key.solution, asked, key.choices, variant) if asked is not None else ""
        return in_words or self.solutions.worked_solution_of(key)

    def _numbers(self, parts: Sequence[PartToMark]) -> dict[tuple[str, str], str]:
        wanted = {(group.students[0], part.problem) for part in parts for group in part.groups}
        return {one: _numbers_of(self.variants[one]) for one in wanted if one in self.variants}


def _share(posted: Mapping[str, Any], part: PartToMark) -> float:
    """The share of the part's points that an item is worth; as it was where its points are as they were shown."""
    worth = float(str(posted["points"]))
    before = next((each.share for each in part.items if each.id == posted["id"]), None)
    if before is not None and abs(round(before * part.out_of, 2) - worth) < 0.005:
        return before
    return worth / part.out_of if part.out_of else 0.0


def _numbers_of(variant: Variant) -> str:
    """The givens in one line of Markdown."""
    with letters_printed(variant.problem.printed_letters):
        return ", ".join(f"${letter(symbol)}$ = {written(variant, symbol)}" for symbol in variant.values)
