"""A problem set: its problems, whole or in part, pools, points, dates, and what each verdict earns."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Collection, Iterable, Iterator
from dataclasses import dataclass, replace
from datetime import UTC, datetime, tzinfo
from fractions import Fraction
from pathlib import Path

from corollary.messages import did_you_mean
from corollary.plug_ins import PlugInFault
from corollary.problem.bank import CHAPTER, Bank, UnknownCode, bank_around, find, open_bank
from corollary.problem.dates import HOW_TO_WRITE, REVEAL, Reveal, moment
from corollary.problem.diagnostic import Diagnostic, Malformed
from corollary.problem.front_matter import Node, Reader, TableNode, TextNode, split
from corollary.problem.late_penalty import IN_TIME, Delay, LateSteps, read_late_steps, rule_in_words
from corollary.problem.packages import fault, module_named
from corollary.problem.packed_pictures import packed
from corollary.problem.part import Part
from corollary.problem.problem import Problem
from corollary.problem.sampling import digest
from corollary.problem.translation import set_words

MOST_POINTS = 1000


@dataclass(frozen=True, slots=True)
class Pool:
    """Any `count` of the problems with these codes, other ones for each student; `equally`: each to equally many students.
    `line` is where the set says so."""

    count: int
    codes: tuple[str, ...]
    line: int = 0
    equally: bool = False


@dataclass(frozen=True, slots=True)
class Listed:
    """The problems of a set with their weights, in its order, those of pools too."""

    problems: tuple[Problem, ...]
    weights: tuple[float, ...]
    pools: tuple[Pool, ...]


def read_problems(bank: Bank, front: Reader) -> Listed:
    """What stands under `problems:`; what is wrong with it is complained of."""
    usual = front.text("bank", "")
    chosen: list[tuple[Problem, float]] = []
    pools: list[Pool] = []
    for node in front.list_of("problems"):
        if isinstance(node, TableNode) and "any" in node.entries:
            row = Reader(front.path, node, "a pool of the set", front.complaints)
            count, (deal, deal_line) = row.fraction("any"), row.line_of("deal", "at random")
            if deal not in {"at random", "equally"}:
                row.complain(
                    deal_line, f"deal: {deal}: say equally (each problem to equally many) or at random"
                )
            named = list(row.list_of("of"))
            members = [each for one in named for each in _listed(bank, usual, front, one, chosen)]
            row.finish()
            if count is not None and not (count.denominator == 1 and 1 <= count < len(named)):
                row.complain(
                    node.line,
                    f"any: {count} of {len(named)} problems; a pool deals some of its problems, at least one and not all",
                )
            pools.append(
                Pool(int(count or 1), tuple(each.code for each in members), node.line, deal == "equally")
            )
        else:
            list(_listed(bank, usual, front, node, chosen))
    problems, weights = zip(*chosen, strict=True) if chosen else ((), ())
    return Listed(problems, weights, tuple(pools))


def _listed(
    bank: Bank, usual: str, front: Reader, node: Node, chosen: list[tuple[Problem, float]]
) -> Iterator[Problem]:
    """One row, put behind those chosen already; nothing where it cannot be."""
    weight: Fraction | None = Fraction(1)
    row = None
    if isinstance(node, TableNode):
        row = Reader(front.path, node, "a problem of the set", front.complaints)
        code, weight, place = row.text("code"), row.fraction("weight", "1"), row.text("bank", usual)
    elif isinstance(node, TextNode):
        code, place = node.text, usual
    else:
        front.complain(
            node.line,
            "a problem of the set is a code, or {code: X12.5, weight: 2}, or {any: 2, of: [X12.4, X12.5]}",
        )
        return
    try:
        problem = _found(bank, place, code, front.path)
    except (UnknownCode, Malformed, PlugInFault) as error:
        front.complain(node.line, str(error))
        return
    if any(problem.code == other.code for other, _ in chosen):
        front.complain(node.line, f"{code} is in the set twice")
    if weight is not None and not 0 <= weight <= MOST_POINTS:
        front.complain(node.line, f"{code} has weight: {weight}; give a number from 0 to 1000")
    if row is not None:
        problem = _adapted(problem, row)
        row.finish()
    chosen.append((problem, float(1 if weight is None else weight)))
    yield problem


def _found(bank: Bank, place: str, code: str, path: Path) -> Problem:
    """The problem of this code, or of `BANK/CODE`. Raises UnknownCode, Malformed, PlugInFault."""
    named, slash, short = code.rpartition("/")
    if slash and not code.endswith(".md"):
        place, code = named, short
    return find(_bank_named(bank, place, path) if place else bank, code)


def _bank_named(bank: Bank, name: str, path: Path) -> Bank:
    """One of the banks at hand by its folder's name, a folder beside the set, the chapter's, or that of an installed package."""
    here = [each for each in bank.each if each.folder.name == name and name != CHAPTER]
    beside = path.parent / name
    return here[0] if here else open_bank(beside if (beside / "problems").is_dir() else Path(name))


def _adapted(problem: Problem, row: Reader) -> Problem:
    """With the parts that the set asks for, and the points it gives for them; itself where it says nothing of either."""
    ids = {part.id: part for part in problem.parts}
    wanted = [node for node in row.list_of("parts") if isinstance(node, TextNode)]
    points: dict[str, float] = {}
    table = row.table_of("points")
    given = Reader(row.path, table, f"the points of {problem.code}", row.complaints)
    for part in table.entries:
        number = given.fraction(part)
        if number is not None and not 0 <= number <= MOST_POINTS:
            given.complain(
                table.entries[part].line,
                f"{problem.code} {part} has {number} points; give a number from 0 to 1000",
            )
        points[part] = float(number or 0)
    for name, line in (
        *((node.text, node.line) for node in wanted),
        *((name, node.line) for name, node in table.entries.items()),
    ):
        if name not in ids:
            row.complain(line, f"{problem.code} has no part {name}; it has {', '.join(ids)}")
    left = {node.text for node in wanted} or set(ids)
    if unasked := [name for name in points if name in ids and name not in left]:
        row.complain(
            table.line,
            f"{problem.code}: part {unasked[0]} has points and is not among `parts`; leave one out",
        )
    if not wanted and not points:
        return problem
    parts: list[Part] = [
        replace(part, points=points.get(part.id, part.points)) for part in problem.parts if part.id in left
    ]
    return replace(problem, parts=tuple(parts), written=problem)


NAME = re.compile(r"[A-Za-z0-9][A-Za-z0-9_-]{0,79}$")


@dataclass(frozen=True, slots=True)
class Usual:
    """What holds in a course for every set that does not say otherwise; `zone` None: the machine's own."""

    zone: tzinfo | None = None
    reveal: Reveal = "no"
    late_steps: LateSteps | None = None
    packages: tuple[str, ...] | None = None  # that students may import; None: nothing is said of them


USUAL = Usual()
NO_PACKAGES = ("", "none", "no")  # besides those that are always there


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
    """`weights` multiply the points of each problem's parts; `due` and `opens` are moments with a zone, or None. `problems` has
    those of all `pools`, of which a student gets some; `shuffled`: each in an order of their own. `tries` is how many hand-ins
    count, None for any number. `file` is the file it was read from. `late_steps`: None where late work keeps one share. `packages`
    are those declared as what students may import, None where nothing is."""

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
    pools: tuple[Pool, ...] = ()
    shuffled: bool = False
    tries: int | None = None
    file: Path | None = None
    late_steps: LateSteps | None = None
    packages: tuple[str, ...] | None = None

    def delay(self, due: datetime, when: datetime) -> Delay:
        """How late a hand-in at a moment is for who has this deadline, and what is left of its marks."""
        if self.late_steps is not None:
            return self.late_steps.delay(due, when)
        seconds = (when.astimezone(UTC) - due.astimezone(UTC)).total_seconds()
        return Delay(seconds, 0, self.scheme.late, "late") if seconds > 0 else IN_TIME

    @property
    def late_rule(self) -> str:
        """What students read of steps below the deadline; empty where there are none."""
        return "" if self.late_steps is None or self.due is None else rule_in_words(self.late_steps, self.due)

    def weight(self, problem: Problem) -> float:
        """1 for a problem that is no longer in the set."""
        code = problem.as_written.code
        return next((w for p, w in zip(self.problems, self.weights, strict=True) if p.code == code), 1.0)

    @property
    def out_of(self) -> float:
        """What a sheet is out of; at most, where the problems of a pool differ."""
        points = {problem.code: self.points(problem) for problem in self.problems}
        best = sum(
            sum(sorted((points.pop(code) for code in pool.codes), reverse=True)[: pool.count])
            for pool in self.pools
        )
        return best + sum(points.values())

    def points(self, problem: Problem) -> float:
        """What a problem is out of."""
        return sum(part.points for part in problem.parts) * self.weight(problem)

    def deal(
        self, key: bytes, students: Iterable[str], before: Iterable[Collection[str]] = ()
    ) -> dict[str, tuple[Problem, ...]]:
        """What students get when the set is generated: of each pool as many as it deals, by the course's key.

        `before` are the codes that others have already, which count where a pool is dealt equally.
        """
        held = Counter(code for codes in before for code in codes)

        def problems_of(student: str) -> tuple[Problem, ...]:
            def rank(word: str, code: str) -> int:
                return digest(key, word, self.name, student, code)

            left_out: set[str] = set()
            for pool in self.pools:
                in_order = sorted(pool.codes, key=lambda code: rank("pool", code))
                if pool.equally:
                    in_order.sort(key=held.__getitem__)
                held.update(in_order[: pool.count])
                left_out.update(in_order[pool.count :])
            chosen = [problem for problem in self.problems if problem.code not in left_out]
            return tuple(
                sorted(chosen, key=lambda each: rank("order", each.code)) if self.shuffled else chosen
            )

        students = tuple(students)
        turns = sorted(students, key=lambda student: digest(key, "turn", self.name, student))
        dealt = {student: problems_of(student) for student in turns}
        return {student: dealt[student] for student in students}

    def is_dealt(self, codes: Collection[str]) -> bool:
        """Whether these problems, and no other, may be a student's: all that are in no pool, and of each pool what it deals."""
        pooled = {code for pool in self.pools for code in pool.codes}
        return {code for code in codes if code not in pooled} == {
            problem.code for problem in self.problems if problem.code not in pooled
        } and all(len(set(pool.codes) & set(codes)) == pool.count for pool in self.pools)


def find_set(bank: Bank, name: str, usual: Usual = USUAL) -> ProblemSet:
    """The set called so in the bank's problems/sets, or in the file of that path; `usual`: what its course says of dates.

    Raises UnknownCode or Malformed.
    """
    path = Path(name) if name.endswith(".md") and Path(name).is_file() else file_of_set(bank, name)
    if path is None:
        have = set_names(bank)
        if _is_a_problem(bank, name):
            raise UnknownCode(
                f"{name} is a problem, not a problem set; corollary show {name} --format FORMAT writes a single problem"
            )
        raise UnknownCode(
            f"there is no problem set {name}{did_you_mean(name, have)}; the bank {bank.place} has: {', '.join(have) or 'none'}"
        )
    return read_set(bank, path, usual)


def file_of_set(bank: Bank, name: str) -> Path | None:
    """Return the file in which a bank has the set of this name."""
    places = (each.sets / f"{name}.md" for each in bank.each)
    return next((place for place in places if place.is_file()), None)


def _is_a_problem(bank: Bank, name: str) -> bool:
    try:
        return any(name in (each.code, each.name) for each in bank)
    except Malformed:  # of other problems; here it is a set that was asked for
        return False


def bank_of_set(folder: Path | None, name: str) -> Bank:
    """The bank in which a set is found: the one in the folder, else the one that the set's file lies in, else what `open_bank`
    opens. Raises UnknownCode."""
    return (None if folder else bank_around(name)) or open_bank(folder)


def set_names(bank: Bank) -> list[str]:
    """What the bank's sets are called."""
    return sorted(file.stem for each in bank.each for file in each.sets.glob("*.md") if "." not in file.stem)


def read_set(bank: Bank, path: Path, usual: Usual = USUAL) -> ProblemSet:
    """The problem set a file holds. Raises Malformed with every complaint found."""
    table, body, first_line = split(path)
    complaints: list[Diagnostic] = []
    body = packed(path, body, first_line, complaints)
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
    order, order_line = front.line_of("order", "fixed")
    if order not in {"fixed", "shuffled"}:
        front.complain(order_line, f"order: {order}: say fixed (as listed) or shuffled (for each student)")
    tries = _tries(front)
    credit = front.table_of("credit")
    scheme = _scheme(path, credit, complaints)
    late_steps = _late_steps(front, credit, due, scheme.late, usual)
    packages = _packages(front, usual)
    listed = read_problems(bank, front)
    front.finish()
    if not front.list_of("problems"):
        complaints.append(
            Diagnostic(path, table.line, "holds no problems; list them under problems:, one `- X12.5` a line")
        )
    if complaints:
        raise Malformed(complaints)
    own_title, own_introduction = set_words(path)
    return ProblemSet(
        path.stem,
        own_title or title,
        own_introduction or body.strip(),
        listed.problems,
        listed.weights,
        due,
        scheme,
        REVEAL[reveal],
        opens,
        rubric == "yes",
        listed.pools,
        order == "shuffled",
        tries,
        path,
        late_steps,
        packages,
    )


def _late_steps(
    front: Reader, credit: TableNode, due: datetime | None, share: float, usual: Usual
) -> LateSteps | None:
    """The set's own steps, else the course's where the set gives no share of its own."""
    table = front.table_of("late")
    if "late" in front.table.entries:
        return read_late_steps(front, table, due, share)
    return None if "late" in credit.entries else usual.late_steps


def _packages(front: Reader, usual: Usual) -> tuple[str, ...] | None:
    """The modules under `packages:`, which is a list, or words between commas; the course's where the set says nothing."""
    if "packages" not in front.table.entries:
        return usual.packages
    found: list[str] = []
    for node in front.list_of("packages"):
        for word in node.text.split(",") if isinstance(node, TextNode) else ("",):
            if (word := word.strip()) in NO_PACKAGES:
                continue
            if complaint := fault(word):
                front.complain(node.line, complaint)
            else:
                found.append(module_named(word))
    return tuple(dict.fromkeys(found))


def _tries(front: Reader) -> int | None:
    text, line = front.line_of("tries", "")
    if text and not re.fullmatch(r"[1-9]\d{0,3}", text):
        front.complain(line, f"tries: {text}: say how many hand-ins count, such as 3, or leave it out")
        return None
    return int(text) if text else None


def _date(front: Reader, name: str, usual: Usual) -> datetime | None:
    text, line = front.line_of(name, "")
    found = moment(text, usual.zone, end_of_day=name == "due")
    if text and found is None:
        front.complain(line, f"{name}: {text} is not a date or time; {HOW_TO_WRITE}")
    return found


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
