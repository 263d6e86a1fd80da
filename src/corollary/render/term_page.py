"""The term for the instructor: tables on a terminal, and a page that needs nothing beside it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from statistics import fmean

from rich.console import Group, RenderableType
from rich.table import Table
from rich.text import Text

from corollary.messages import few, visible
from corollary.records.misconception_history import Followed, MisconceptionTerm
from corollary.records.term import CourseTerm, StudentTerm
from corollary.records.term_totals import (
    EXCUSED,
    MARKED,
    MISSING,
    NO_SHEET,
    OPEN,
    UNGRADED,
    WAITS,
    SetResult,
    TermTotal,
)
from corollary.render.page import page

MOST = 10  # rows of a list on a terminal
FEW = 5  # misconceptions on a terminal where nobody repeated any
MOST_STUDENTS = 40  # a class whose totals a terminal shows
LONGEST = 90  # of a misconception's sentence on a terminal
TROUBLE = "*"
STAR = "* Something went wrong with this hand-in as a whole; corollary report SET says what."


@dataclass(frozen=True, slots=True)
class SetLine:
    """One set in the class: how many of each state, and the mean share of what was handed in, a range where marks are not final."""

    name: str
    title: str
    due: str
    weight: str
    counts: dict[str, int]
    mean: str


@dataclass(frozen=True, slots=True)
class StudentTermLine:
    """One student in the table: a text for each set, the total as a text and as a number to sort by, and the misconceptions."""

    term: StudentTerm
    cells: tuple[str, ...]
    total: str
    order: float
    followed: tuple[Followed, ...]


def result_text(result: SetResult, *, dropped: bool = False) -> str:
    """`82 %`; `62–71 %` where answers wait; in brackets where it does not count; a word where there is no mark."""
    match result.state:
        case "marked" | "waits":
            text = _range(result.low, result.high, 0) + (TROUBLE if result.trouble else "")
        case "open":
            text = "·"
        case _:
            text = result.state
    return f"({text})" if dropped else text


def total_text(total: TermTotal) -> str:
    """The total with one decimal; a range where it is not final, a dash where nothing counts yet."""
    if total.low is None or total.high is None:
        return "–"
    return _range(total.low, total.high, 1)


def _range(low: float, high: float, decimals: int) -> str:
    ends = [f"{100 * each:.{decimals}f}" for each in (low, high)]
    return f"{ends[0]} %" if high - low < 1e-12 else f"{ends[0]}–{ends[1]} %"


def set_lines(term: CourseTerm) -> list[SetLine]:
    """The sets in their order."""
    found: list[SetLine] = []
    for place, each in enumerate(term.sets):
        results = [line.results[place] for line in term.students]
        states = (MARKED, WAITS, UNGRADED, MISSING, OPEN, EXCUSED, NO_SHEET)
        counts = {state: sum(one.state == state for one in results) for state in states}
        handed_in = [one for one in results if one.state in (MARKED, WAITS, UNGRADED)]
        due = f"{each.due:%Y-%m-%d}" if each.due is not None else "–"
        found.append(SetLine(each.name, each.title, due, f"{each.weight:g}", counts, _mean(handed_in, 0)))
    return found


def _mean(each: Sequence[SetResult | TermTotal], decimals: int) -> str:
    """A range where one of them is not final, a dash where there is none."""
    ends = [(one.low, one.high) for one in each if one.low is not None and one.high is not None]
    if not ends:
        return "–"
    return _range(fmean(low for low, _ in ends), fmean(high for _, high in ends), decimals)


def rules_text(term: CourseTerm) -> str:
    """How a total is made, in a sentence."""
    rules, weights = term.rules, {each.weight for each in term.sets}
    how = "each set counts the same" if len(weights) < 2 else "sets count by their weights"
    if rules.by_points:
        how = "each set counts by its points"
    if rules.best is not None:
        how += f"; the best {rules.best} count"
    elif rules.drop:
        how += f"; {'the worst one is' if rules.drop == 1 else f'the worst {rules.drop} are'} left out"
    return f"A total is the mean share of the points so far: {how}."


def behind_text(term: CourseTerm) -> str:
    """The definition by which a student falls behind."""
    sets = "set" if term.rules.missing == 1 else "sets"
    return (
        f"A student falls behind with {term.rules.missing} {sets} or more not handed in, or with a total below "
        f"{term.rules.below:g} %. An answer that waits for marking counts in the student's favour."
    )


def headline(term: CourseTerm) -> str:
    """The class in a sentence."""
    totals = [line.total for line in term.students]
    waiting = sum(line.total.low is not None and not line.total.is_final for line in term.students)
    mean = f"mean total {_mean(totals, 1)}"
    more = f"; {waiting} {'total is a range' if waiting == 1 else 'totals are ranges'}, for answers wait or are not graded"
    students = "1 student" if len(term.students) == 1 else f"{len(term.students)} students"
    sets = "1 set" if len(term.sets) == 1 else f"{len(term.sets)} sets"
    return f"{students}, {sets}; {mean}{more if waiting else ''}"


def terminal(term: CourseTerm, lines: Sequence[MisconceptionTerm]) -> RenderableType:
    """Tables for rich."""
    return Group(*_pieces(term, lines))


def _pieces(term: CourseTerm, lines: Sequence[MisconceptionTerm]) -> Iterator[RenderableType]:
    yield Text(headline(term))
    yield Text(rules_text(term), style="dim")
    yield _table(
        "Sets",
        ("set", "due", "weight", "handed in", "missing", "excused", "waits", "not graded", "mean"),
        (
            (
                each.name,
                each.due,
                each.weight,
                str(each.counts[MARKED] + each.counts[WAITS] + each.counts[UNGRADED]),
                str(each.counts[MISSING]),
                str(each.counts[EXCUSED]),
                str(each.counts[WAITS]),
                str(each.counts[UNGRADED]),
                each.mean,
            )
            for each in set_lines(term)
        ),
    )
    if len(term.students) <= MOST_STUDENTS:
        yield _totals(term)
        if has_trouble(term):
            yield Text(STAR, style="dim")
    else:
        yield Text("The totals of all students are in --csv FILE, and on the page of -o FILE.", style="dim")
    if behind := [line for line in term.students if line.behind]:
        yield _table(
            f"Falls behind: {len(behind)}",
            ("student", "name", "total", "why"),
            (
                (each.student.id, each.student.name, total_text(each.total), _why(each))
                for each in behind[:MOST]
            ),
        )
        yield from _more(len(behind))
        yield Text(behind_text(term), style="dim")
    again = [each for each in lines if each.repeated]
    names = {line.student.id: line.student.name_with_id for line in term.students}
    some = again or [each for each in lines if not each.misconception.is_slip][:FEW]
    if some:
        yield _table(
            "Misconceptions through the term",
            ("misconception", *term.names, "repeated", "lost", "who repeated"),
            (
                (
                    _named(each),
                    *(str(each.counts.get(name, "·")) for name in term.names),
                    str(len(each.repeated)),
                    str(len(each.lost)),
                    few([names.get(one, one) for one in each.repeated], 4) if each.repeated else "",
                )
                for each in some[:MOST]
            ),
        )
        yield from _more(len(some))
        if rest := len(lines) - len(some):
            yield Text(f"{rest} more were repeated by nobody; the page of -o FILE has them all", style="dim")
    for note in term.notes:
        yield Text(visible(note))


def has_trouble(term: CourseTerm) -> bool:
    return any(
        each.trouble for line in term.students for each in line.results if each.state in {MARKED, WAITS}
    )


def _named(each: MisconceptionTerm) -> str:
    what = each.misconception
    text = what.name if what.is_named else f"{what.problem}: {what.name}"
    return text if len(text) <= LONGEST else f"{text[:LONGEST]} …"


def _why(line: StudentTerm) -> str:
    missing = f" ({', '.join(line.missing)})" if line.missing else ""
    return "; ".join(line.behind) + missing


def _totals(term: CourseTerm) -> Table:
    rows = (
        (
            line.student.id,
            line.student.name,
            *(
                result_text(each, dropped=place in line.total.dropped)
                for place, each in enumerate(line.results)
            ),
            total_text(line.total),
        )
        for line in term.students
    )
    return _table("Totals (in brackets: left out)", ("student", "name", *term.names, "total"), rows)


def _table(title: str, columns: tuple[str, ...], rows: Iterator[tuple[str, ...]]) -> Table:
    table = Table(*columns, title=title, title_justify="left", title_style="bold")
    for row in rows:
        table.add_row(*(Text(visible(each)) for each in row))
    return table


def _more(count: int) -> Iterator[Text]:
    if count > MOST:
        yield Text(f"and {count - MOST} more; the page of -o FILE has them all", style="dim")


def term_page(term: CourseTerm, followed: Sequence[Followed], lines: Sequence[MisconceptionTerm]) -> str:
    """The term as one page of HTML."""
    own: dict[str, list[Followed]] = {}
    for each in followed:
        own.setdefault(each.student, []).append(each)
    people = [
        StudentTermLine(
            line,
            tuple(
                result_text(each, dropped=place in line.total.dropped)
                for place, each in enumerate(line.results)
            ),
            total_text(line.total),
            -1.0 if line.total.low is None else line.total.low,
            tuple(own.get(line.student.id, ())),
        )
        for line in term.students
    ]
    names = {line.student.id: line.student.name for line in term.students}
    sections = any(line.student.section or line.student.group for line in term.students)
    return page(
        "term.html",
        title="The term",
        script="report.js",
        style="report.css",
        term=term,
        headline=headline(term),
        rules=rules_text(term),
        behind_rule=behind_text(term),
        sets=set_lines(term),
        people=people,
        behind=[each for each in people if each.term.behind],
        sections=sections,
        star=STAR if has_trouble(term) else "",
        lines=lines,
        named=[each for each in lines if each.misconception.is_named],
        of_one_problem=[each for each in lines if not each.misconception.is_named],
        names=names,
        by_status={
            (each.misconception, status): [
                one for one in followed if one.misconception == each.misconception and one.status == status
            ]
            for each in lines
            for status in ("repeated", "once", "lost")
        },
    )
