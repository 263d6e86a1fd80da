"""A problem set: which problems, their points, the dates, and what each verdict earns."""

from __future__ import annotations

import re
from dataclasses import dataclass
from datetime import datetime
from fractions import Fraction
from pathlib import Path

from corollary.messages import did_you_mean
from corollary.problem.bank import Bank, UnknownCode, find
from corollary.problem.dates import HOW_TO_WRITE, REVEAL, Reveal, Usual, moment
from corollary.problem.diagnostic import Diagnostic, Malformed
from corollary.problem.front_matter import Reader, TableNode, TextNode, split
from corollary.problem.problem import Problem

NAME = re.compile(r"[A-Za-z0-9][A-Za-z0-9_-]{0,79}$")
USUAL = Usual()


@dataclass(frozen=True, slots=True)
class Scheme:
    """What share of a part's points each verdict earns, and what is kept of the marks of late work.

    `choice` is what a wrong option of a choice earns, where the solution says what those who take it overlook.
    """

    follows: float = 1.0
    slip: float = 0.5
    mistaken: float = 0.25
    late: float = 1.0
    choice: float = 0.0


@dataclass(frozen=True, slots=True)
class ProblemSet:
    """`weights` multiply the points of each problem's parts; `due` and `opens` are moments with a zone, or None."""

    name: str
    title: str
    introduction: str
    problems: tuple[Problem, ...]
    weights: tuple[float, ...]
    due: datetime | None
    scheme: Scheme
    reveal: Reveal
    opens: datetime | None = None
    rubric: bool = False

    def weight(self, problem: Problem) -> float:
        """1 for a problem that is no longer in the set."""
        code = problem.as_written.code
        return next((w for p, w in zip(self.problems, self.weights, strict=True) if p.code == code), 1.0)

    @property
    def out_of(self) -> float:
        return sum(
            part.points * weight
            for problem, weight in zip(self.problems, self.weights, strict=True)
            for part in problem.parts
        )


def find_set(bank: Bank, name: str, usual: Usual = USUAL) -> ProblemSet:
    """The set called so in the bank's problems/sets, or in the file of that path; `usual`: what its course says of dates.

    Raises UnknownCode or Malformed.
    """
    places = [Path(name)] if name.endswith(".md") else [each.sets / f"{name}.md" for each in bank.each]
    path = next((place for place in places if place.is_file()), None)
    if path is None:
        have = set_names(bank)
        raise UnknownCode(
            f"there is no problem set {name}{did_you_mean(name, have)}; the bank has: {', '.join(have) or 'none'}"
        )
    return read_set(bank, path, usual)


def set_names(bank: Bank) -> list[str]:
    """What the bank's sets are called."""
    return sorted(file.stem for each in bank.each for file in each.sets.glob("*.md"))


def read_set(bank: Bank, path: Path, usual: Usual = USUAL) -> ProblemSet:
    """The problem set a file holds. Raises Malformed with every complaint found."""
    table, body, _ = split(path)
    complaints: list[Diagnostic] = []
    front = Reader(path, table, "the problem set", complaints)
    if not NAME.match(path.stem):
        front.complain(
            1, f"the file's name becomes a folder's; {path.stem!r} will not do, use letters, digits, _ and -"
        )
    title = front.text("title")
    opens, due = _date(front, "opens", usual), _date(front, "due", usual)
    if opens and due and opens >= due:
        front.complain(front.line_of("opens", "")[1], "opens when it is due already, or later")
    reveal, reveal_line = front.line_of("reveal", usual.reveal)
    if reveal not in REVEAL:
        front.complain(
            reveal_line,
            f"reveal: {reveal}: say yes or after due (feedback shows the worked solution once the set is due), "
            "after extensions, by hand, or no",
        )
    rubric, rubric_line = front.line_of("rubric", "no")
    if rubric not in {"yes", "no"}:
        front.complain(
            rubric_line, f"rubric: {rubric}: say yes (feedback shows it once the set is due) or no"
        )
    scheme = _scheme(path, front.table_of("credit"), complaints)
    chosen = _problems(bank, front)
    front.finish()
    if not front.list_of("problems"):
        complaints.append(
            Diagnostic(path, table.line, "holds no problems; list them under problems:, one `- X12.5` a line")
        )
    if complaints:
        raise Malformed(complaints)
    problems, weights = zip(*chosen, strict=True)
    return ProblemSet(
        path.stem, title, body.strip(), problems, weights, due, scheme, REVEAL[reveal], opens, rubric == "yes"
    )


def _date(front: Reader, name: str, usual: Usual) -> datetime | None:
    text, line = front.line_of(name, "")
    found = moment(text, usual.zone, end_of_day=name == "due")
    if text and found is None:
        front.complain(line, f"{name}: {text} is no moment; {HOW_TO_WRITE}")
    return found


def _problems(bank: Bank, front: Reader) -> list[tuple[Problem, float]]:
    chosen: list[tuple[Problem, float]] = []
    for node in front.list_of("problems"):
        weight: Fraction | None = Fraction(1)
        if isinstance(node, TableNode):
            row = Reader(front.path, node, "a problem of the set", front.complaints)
            code, weight = row.text("code"), row.fraction("weight", "1")
            row.finish()
        elif isinstance(node, TextNode):
            code = node.text
        else:
            front.complain(node.line, "a problem of the set is a code, or {code: X12.5, weight: 2}")
            continue
        try:
            problem = find(bank, code)
        except (UnknownCode, Malformed) as error:
            front.complain(node.line, str(error))
            continue
        if any(problem.code == other.code for other, _ in chosen):
            front.complain(node.line, f"{code} is in the set twice")
        if weight is not None and not 0 <= weight <= 1000:
            front.complain(node.line, f"{code} has weight: {weight}; give a number from 0 to 1000")
        chosen.append((problem, float(1 if weight is None else weight)))
    return chosen


def _scheme(path: Path, table: TableNode, complaints: list[Diagnostic]) -> Scheme:
    row = Reader(path, table, "credit", complaints)
    shares: dict[str, float] = {}
    for name, default in (
        ("follows", "1"),
        ("slip", "0.5"),
        ("mistaken", "0.25"),
        ("late", "1"),
        ("choice", "0"),
    ):
        share = row.fraction(name, default)
        if share is not None and not 0 <= share <= 1:
            row.complain(row.line_of(name, default)[1], f"{name} earns {share}; a share lies between 0 and 1")
        shares[name] = float(share or 0)
    row.finish()
    return Scheme(**shares)
