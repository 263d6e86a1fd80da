"""Evidence on a request for regrading: the one change of the derivation that gives the answer, who else made it, what would move."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

from markupsafe import Markup, escape

from corollary.course.wrong_answers import DrawnKeys, drawn_keys, letters_of, parts_of
from corollary.grading.solutions import Solutions
from corollary.grading.unlisted_rules import UnlistedRule
from corollary.nbgrader.hand_marking import part_named
from corollary.problem.problem_set import ProblemSet
from corollary.records.assignments import read_assigned
from corollary.records.files import Course
from corollary.records.marks import Record, read_marks
from corollary.records.unlisted import rules_giving
from corollary.render.wording import points

MOST = 10


@dataclass(frozen=True, slots=True)
class SameChange:
    """Another student whose answer follows from the same change; points before lateness."""

    student: str
    answer: str
    points: float
    out_of: float


@dataclass(frozen=True, slots=True)
class Evidence:
    """`answer` as it was read and how it was marked; rules that give it, none where there is no such rule; `others` made the same
    change. `points` and `out_of` are the student's, `listed` what the part would earn as a listed misconception."""

    student: str
    answer: str
    verdict: str
    points: float
    out_of: float
    rules: tuple[UnlistedRule, ...] = ()
    others: tuple[SameChange, ...] = ()
    listed: float = 0.0


def explained(
    course: Course,
    problem_set: ProblemSet,
    solutions: Solutions,
    student: str,
    part: str,
    keys: dict[str, DrawnKeys] | None = None,
) -> Evidence:
    """What there is on one student's answer to a part, named as in the notebook. `keys` keeps those of each problem for the next
    look: they are what takes long. Raises NotMarkable, NotACourse, NotDerivable."""
    records = read_marks(course, problem_set, read_assigned(course, problem_set))
    record = records[student]
    part = part_named(problem_set, part, record)
    entry = record.parts[part]
    row = record.row(part)
    found = Evidence(student, entry.answer, row.verdict, entry.points, entry.out_of)
    by_problem = {} if keys is None else keys
    if row.problem not in by_problem:
        by_problem[row.problem] = drawn_keys(
            course, problem_set, solutions, records.keys(), lambda name: None, row.problem
        )
    drawn_here = by_problem[row.problem]
    own = drawn_here.get((student, row.problem))
    if own is None:
        return found
    drawn = [
        letters
        for (name, code), key in drawn_here.items()
        if code == row.problem and key.solution is own.solution
        for letters in (
            letters_of(name, key, parts_of(records[name], code), problem_set, row.part).get(row.part),
        )
        if letters is not None
    ]
    place = next((at for at, one in enumerate(drawn) if one.student == student), None)
    if place is None:
        return found
    rules = rules_giving(own.solution, row.part, drawn, place)
    others = {at: None for _, places in rules for at in places if at != place}
    return replace(
        found,
        rules=tuple(rule for rule, _ in rules),
        others=tuple(_other(records[drawn[at].student], part) for at in others),
        listed=round(entry.points + drawn[place].points, 6),
    )


def evidence_html(found: Evidence, named: Callable[[str], str] | None) -> str:
    """The same for the page; `named` gives name and id, None where the marking is anonymous."""
    answer = Markup("<p>Read as <code>{}</code>: {}, {} of {}.</p>").format(
        found.answer or "nothing", found.verdict, points(found.points), points(found.out_of)
    )
    if not found.rules:
        return answer + Markup(
            "<p>No single change of the derivation gives this answer with the student’s numbers.</p>"
        )
    rules = Markup("").join(
        Markup("<li>{}: <code>{}</code></li>").format(rule.words, rule.formula) for rule in found.rules[:4]
    )
    text = answer + Markup("<p>One change gives it:</p><ul>{}</ul>").format(rules)
    text += Markup(
        "<p>Listed in the solution as a misconception, the answer would earn {} of {}.</p>"
    ).format(points(found.listed), points(found.out_of))
    if not found.others:
        return text + Markup("<p>Nobody else has it.</p>")
    count = len(found.others)
    rows = Markup("").join(
        Markup("<tr><td>{}</td><td>{}</td><td>{} of {}</td></tr>").format(
            escape(named(each.student)) if named else "a student",
            each.answer,
            points(each.points),
            points(each.out_of),
        )
        for each in found.others[:MOST]
    )
    more = Markup("<p>and {} more</p>").format(count - MOST) if count > MOST else ""
    whose = "1 other has" if count == 1 else f"{count} others have"
    return text + Markup(
        "<p>{} it. What you give would move them only if you tick this:</p>"
        "<table><thead><tr><th>student</th><th>answer</th><th>has</th></tr></thead><tbody>{}</tbody></table>{}"
        '<p><label><input type="checkbox" class="others"> Give the same points and comment to {}</label></p>'
    ).format(whose, rows, more, "that student" if count == 1 else f"all {count}")


def _other(record: Record, part: str) -> SameChange:
    entry = record.parts[part]
    return SameChange(record.handed_in.student, entry.answer, entry.points, entry.out_of)
